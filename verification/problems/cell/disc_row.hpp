#pragma once

#include <cstdint>
#include <variant>
#include <vector>

#include "solver/granular/disc_method.hpp"
#include "solver/granular/disc_system.hpp"
#include "verification/study/usage.hpp"

/// Equal discs on a line, left to right along x, in the engine of discs.
namespace talus::verification::problems {

struct DiscRow {
  double radius{1.0};            ///< [L]
  double mass{1.0};              ///< [M]
  std::vector<double> velocity;  ///< of each disc [L/T]
  std::vector<double> gap;       ///< between neighbours [L] >= 0
};

/// Of the list of neighbours: a step moves a disc by some .05, so that lists are made again every few steps [L].
inline constexpr double row_skin = 0.25;

struct FilledRow {
  DiscShapes shapes;
  Discs discs;
};
/// The last disc lies at x = 0, so that discs that touch do so exactly where the radius is a power of two.
[[nodiscard]] FilledRow fill(const DiscRow& row);

/// No disc is faster than the next.
[[nodiscard]] bool ordered(const Discs& discs);

/// No force is left, and none will come.
template <class L>
bool over(const DiscSystem<L>& system, const Discs& discs) {
  if (!ordered(discs)) return false;
  bool forced = false;
  system.for_each_contact(discs, [&](const auto& contact) { forced = forced || contact.force != 0.0; });
  return !forced;
}

/// Steps a row until all is over; calls seen(system) after each step. False if that takes more steps than `most`.
template <class L, class Seen>
bool run_row(DiscSystem<L>& system, FilledRow& row, DiscMethod method, double step, long most, Seen&& seen) {
  record_use(method);
  record_use(system.law());
  std::uint32_t visited = 0;
  const bool ended = std::visit(
      [&](auto& steps) {
        system.begin(row.discs);
        steps.start(system, row.discs, step);
        for (long n = 0; n < most; ++n) {
          steps.step(system, row.discs, step);
          for (const Mode mode : system.modes())
            visited |= 1U << mode;
          seen(system);
          if (over(system, row.discs)) return true;
        }
        return false;
      },
      method);
  record_regimes<L>(L::name, visited);
  return ended;
}

}  // namespace talus::verification::problems
