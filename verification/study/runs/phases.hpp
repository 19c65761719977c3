#pragma once

#include <cstddef>
#include <vector>

#include "verification/check/convergence.hpp"

/// Runs whose events lie anywhere within a step, each with a different step: the error of one phase is random, the root
/// mean square is not.
namespace talus::verification::problems {

/// One run of such a set.
struct Phase {
  std::size_t index{};
  double step{};   ///< [T]
  double onset{};  ///< fraction of a step before the event, in (0, 1)

  /// Time before the event [T].
  [[nodiscard]] double lead() const { return onset * step; }
};

/// `count` runs with steps of contact_time/(steps_per_contact + offset) and evenly spaced onsets. `commensurate`: a
/// fault, all offsets are zero.
[[nodiscard]] inline std::vector<Phase> offset_phases(double contact_time, double steps_per_contact,
                                                      std::size_t count = fewest_phases, bool commensurate = false) {
  const std::vector<double> onsets = even_phases(count);
  std::vector<Phase> all;
  for (std::size_t i = 0; i < count; ++i) {
    const double step =
        commensurate ? contact_time / steps_per_contact : offset_step(contact_time, steps_per_contact, i);
    all.push_back({i, step, onsets[i]});
  }
  return all;
}

/// Errors returned by `error` for each of these 64 runs.
template <class Error>
[[nodiscard]] PhaseError phase_error(double contact_time, double steps_per_contact, Error&& error) {
  PhaseError all;
  for (const Phase& phase : offset_phases(contact_time, steps_per_contact))
    all.add(error(phase));
  return all;
}

}  // namespace talus::verification::problems
