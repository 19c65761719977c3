#pragma once

#include <string>
#include <utility>
#include <vector>

#include "verification/check/case.hpp"

/// Command lines whose options are checked one by one.
namespace talus::verification::problems {

/// An option of the program with its values, e.g. {"--window", {"0", "0", "1", "1"}}.
using Option = std::pair<std::string, std::vector<std::string>>;
using Options = std::vector<Option>;

/// The command with the options. The fault without_NAME leaves option --NAME out (dashes in NAME as underscores).
[[nodiscard]] std::vector<std::string> with_options(std::vector<std::string> command, const Options& options,
                                                    const Setup& setup);

/// Counts texts, numbers and files that differ from those expected, and keeps their names.
class Differences {
 public:
  template <class T>
  void compare(const std::string& name, const T& found, const T& expected) {
    ++compared_;
    if (!(found == expected)) differing_.push_back(name);
  }

  /// Checks that there are none; a red check names them.
  void expect_none(Findings& findings, const std::string& check, const std::string& why) const;

 private:
  int compared_{};
  std::vector<std::string> differing_;
};

}  // namespace talus::verification::problems
