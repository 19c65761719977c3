#pragma once

#include <cstdint>
#include <string>
#include <utility>
#include <vector>

#include "verification/driver/baseline.hpp"

namespace talus::verification {

/// A difference from the baseline as text: one line of the table on the terminal and in the job summary.
struct ChangeLine {
  std::string why;     ///< The most severe reason, or the kind of change.
  std::string item;    ///< "case/check", with the old name if it was renamed.
  std::string before;  ///< Value in the baseline.
  std::string after;   ///< Value now.
  std::string bound;   ///< Error bound of the check, before and after if it changed; empty if not applicable.
  std::string moved;   ///< change/bound; empty if not applicable.
  std::string margin;  ///< error/bound before and after; empty if not applicable.
};

/// One line for each worse item, and for each of its reasons that needs a separate line; the most severe reason first,
/// then the largest change. Checks and controls of a case that is gone or did not finish are included in the line of
/// the case.
[[nodiscard]] std::vector<ChangeLine> lines_of_worse(const Comparison& comparison);

/// One line for each check that changed but is not worse (measured value, bound, reference or verdict), the largest
/// change first.
[[nodiscard]] std::vector<ChangeLine> lines_of_admitted(const Comparison& comparison);

/// "case/check" of the new items, and of those that are gone or were removed on purpose.
[[nodiscard]] std::vector<std::string> new_items(const Comparison& comparison);
[[nodiscard]] std::vector<std::string> lost_items(const Comparison& comparison);

/// A difference between the builds or machines: name, before, after. Revision and date are excluded.
struct Difference {
  std::string what, before, after;
};
[[nodiscard]] std::vector<Difference> build_differences(const Comparison& comparison);

/// The cases in both results, sorted by the change of their time, the largest first.
[[nodiscard]] std::vector<const CaseChange*> by_seconds(const Comparison& comparison);

/// The first 12 digits of the commit, "(modified)" if the sources differed from it.
[[nodiscard]] std::string revision_text(const Provenance& from);

/// Both numbers with as few digits (at least 6) as show that they differ.
[[nodiscard]] std::pair<std::string, std::string> number_pair(double before, double after);

/// A number with thousands separators.
[[nodiscard]] std::string grouped(std::uint64_t number);

/// "1 check", "2 checks".
[[nodiscard]] std::string counted(std::size_t count, const std::string& noun);

}  // namespace talus::verification
