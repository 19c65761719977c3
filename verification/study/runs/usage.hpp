#pragma once

#include <fmt/format.h>

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "solver/granular/disc_method.hpp"
#include "solver/laws/law_list.hpp"
#include "solver/model/layout.hpp"
#include "verification/check/usage.hpp"

/// Features used by runs, recorded by the ids of the solver's lists as evidence for the claims of a case. run_scene()
/// and Probe record them; cases that run something else call these functions.
namespace talus::verification::problems {

/// Laws, end rules, contact methods, shapes and pairs of shapes of a model.
void record_use(const Model& model);
void record_use(const Integrator& integrator);
void record_use(const DiscMethod& method);
using verification::record_use;

/// Records a law as "law.NAME", and its end rule if it has a dashpot.
template <Law L>
void record_use(const L& law) {
  record_use("law." + std::string{L::name});
  bool is_damped = false;
  if constexpr (HasDamping<L>) is_damped = law.damping != 0.0;
  if constexpr (HasDampingRatio<L>) is_damped = is_damped || law.damping_ratio != 0.0;
  if constexpr (HasEndRule<L>) {
    if (is_damped) record_use("end_rule." + std::string{name_of(law.end_rule)});
  }
}

/// Records the modes of a law from `first` on whose bits are set in `visited`, as regimes of the law of that name. An
/// open contact, mode 0, is not a regime; a slack cable is one.
template <class L>
void record_regimes(std::string_view law, std::uint32_t visited, std::size_t first = 1) {
  for (std::size_t mode = first; mode < L::modes.size(); ++mode) {
    if ((visited >> mode & 1U) != 0) record_use(fmt::format("regime.{}.{}", law, L::modes[mode]));
  }
}

/// Records the shape of a body as "shape.NAME".
void record_shape(const Shape& shape);

/// Records two shapes in contact, in any order, and the shapes themselves.
void record_pair(const Shape& a, const Shape& b);

/// Records the mechanisms by which energy was dissipated.
void record_mechanisms(const State& state);

/// The regimes that the laws of a model enter during a run.
class RegimeRecorder {
 public:
  explicit RegimeRecorder(const Model& model) : model_{&model}, layout_{model}, visited_(layout_.mode_count) {}

  /// Registers another state of the run.
  void see(const State& state) {
    if (state.mode == last_) return;
    last_ = state.mode;
    for (std::size_t slot = 0; slot < last_.size(); ++slot)
      visited_[slot] |= 1U << last_[slot];
  }
  /// Records all regimes that occurred.
  void record() const;

 private:
  const Model* model_;
  Layout layout_;
  std::vector<Mode> last_;
  std::vector<std::uint32_t> visited_;  ///< for each slot, one bit per mode
};

}  // namespace talus::verification::problems
