#pragma once

#include <array>
#include <cstddef>
#include <nlohmann/json_fwd.hpp>
#include <numeric>
#include <string>
#include <string_view>

#include "solver/app/sweep/sweep_folder.hpp"

namespace talus::app {

/// Number of runs by their ends.
struct SweepCounts {
  std::size_t runs{};
  std::array<std::size_t, Names<SweepEnd>::list.size()> ends{};  ///< by SweepEnd

  [[nodiscard]] std::size_t done() const { return std::accumulate(ends.begin(), ends.end(), std::size_t{0}); }
  [[nodiscard]] std::size_t missing() const { return runs - done(); }
  [[nodiscard]] std::size_t finished() const { return ends[static_cast<std::size_t>(SweepEnd::finished)]; }
  [[nodiscard]] std::size_t failed() const { return done() - finished(); }

  /// "64 of 64 runs done: 60 finished, 4 diverged"; `what` follows "runs".
  [[nodiscard]] std::string text(std::string_view what) const;
  /// Members `runs`, `missing`, and one for each end.
  [[nodiscard]] nlohmann::ordered_json json() const;
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
