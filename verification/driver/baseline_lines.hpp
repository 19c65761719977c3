#pragma once

#include <cstdint>
#include <string>
#include <utility>
#include <vector>

#include "verification/driver/baseline.hpp"

namespace talus::verification {

/// A difference from the baseline in words: one line of the table on the terminal and of the job summary.
struct ChangeLine {
  std::string why;     ///< The gravest reason, or what kind of change it is.
  std::string item;    ///< "case/check", with the old name if it was renamed.
  std::string before;  ///< Value in the baseline.
  std::string after;   ///< Value now.
  std::string bound;   ///< Error bound of the check, before and after if it changed; empty if there is none.
  std::string moved;   ///< change/bound; empty if there is none.
  std::string margin;  ///< error/bound before and after; empty if there is none.
};

/// One line for each item that is worse and each of its reasons that needs another line, the gravest reason first, then
/// the largest change. Checks and controls of a case that is gone or did not come to its end are in the line of the
/// case.
[[nodiscard]] std::vector<ChangeLine> lines_of_worse(const Comparison& comparison);

/// One line for each check that changed and is not worse, the largest change first: measured value, bound, reference or
/// verdict.
[[nodiscard]] std::vector<ChangeLine> lines_of_admitted(const Comparison& comparison);

/// "case/check" of what is new, and of what is gone or was removed on purpose.
[[nodiscard]] std::vector<std::string> new_items(const Comparison& comparison);
[[nodiscard]] std::vector<std::string> lost_items(const Comparison& comparison);

/// What differs between the builds and machines: name, before, after. Revision and date are not among it.
struct Difference {
  std::string what, before, after;
};
[[nodiscard]] std::vector<Difference> build_differences(const Comparison& comparison);

/// The cases in both results by how much longer or shorter they took, the largest difference first.
[[nodiscard]] std::vector<const CaseChange*> by_seconds(const Comparison& comparison);

/// The first 12 digits of the commit, "(modified)" if the sources differed from it.
[[nodiscard]] std::string revision_text(const Provenance& from);

/// Both numbers with as few digits, from 6 on, as show that they differ.
[[nodiscard]] std::pair<std::string, std::string> number_pair(double before, double after);

/// A number with its thousands separated.
[[nodiscard]] std::string grouped(std::uint64_t number);

/// "1 check", "2 checks".
[[nodiscard]] std::string counted(std::size_t count, const std::string& noun);

}  // namespace talus::verification
