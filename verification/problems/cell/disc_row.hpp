#pragma once

#include <cstdint>
#include <variant>
#include <vector>

#include "solver/granular/disc_method.hpp"
#include "solver/granular/disc_system.hpp"
#include "verification/study/runs/usage.hpp"

/// Rows of equal discs along x, from left to right, run by DiscSystem.
namespace talus::verification::problems {

struct DiscRow {
  double radius{1.0};            ///< [L]
  double mass{1.0};              ///< [M]
  std::vector<double> velocity;  ///< of each disc [L/T]
  std::vector<double> gap;       ///< between neighbours [L] >= 0
};

/// Skin of the neighbour list [L]: a step moves a disc by about 0.05, so that lists are rebuilt every few steps.
inline constexpr double row_skin = 0.25;

struct FilledRow {
  DiscShapes shapes;
  Discs discs;
};
/// Discs of a row. The last one is at x = 0, so that touching discs touch exactly if the radius is a power of two.
[[nodiscard]] FilledRow fill(const DiscRow& row);

/// Whether no disc is faster than the next.
[[nodiscard]] bool ordered(const Discs& discs);

/// Whether no contact force acts and no further contact will occur.
template <class L>
bool over(const DiscSystem<L>& system, const Discs& discs) {
  if (!ordered(discs)) return false;
  bool forced = false;
  system.for_each_contact(discs, [&](const auto& contact) { forced = forced || contact.force != 0.0; });
  return !forced;
}

/// Steps a row until over(); calls seen(system) after each step. Returns false if that takes more than `maximum` steps.
template <class L, class Seen>
bool run_row(DiscSystem<L>& system, FilledRow& row, DiscMethod method, double step, long maximum, Seen&& seen) {
  record_use(method);
  record_use(system.law());
  std::uint32_t visited = 0;
  const bool ended = std::visit(
      [&](auto& steps) {
        system.begin(row.discs);
        steps.start(system, row.discs, step);
        for (long n = 0; n < maximum; ++n) {
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
