#pragma once

#include <string>

#include "solver/app/sweep/sweep_folder.hpp"

namespace talus::app {

/// Number of runs by their ends.
struct SweepCounts {
  std::size_t runs{}, missing{}, finished{}, unusable{}, diverged{}, refused{}, limited{};

  [[nodiscard]] std::size_t done() const { return runs - missing; }
  [[nodiscard]] std::size_t failed() const { return unusable + diverged + refused + limited; }
};
[[nodiscard]] SweepCounts counts_of(const SweepFolder& sweep, const KnownResults& known);

/// The runs that have a result as a CSV file, in the order of the manifest: number from 1, id, each field that is
/// varied with its unit, how the run ended and why, its last time, force evaluations, the verdict of a fence, and each
/// output with its unit. A field whose values are no quantities in one unit is a column of texts. Cells without a
/// value are empty.
[[nodiscard]] std::string sweep_csv(const SweepFolder& sweep, const KnownResults& known, const SweepBase& base);

/// The same as JSON, in SI units; parameters as they are written.
[[nodiscard]] std::string sweep_json(const SweepFolder& sweep, const KnownResults& known, const SweepBase& base);

}  // namespace talus::app
