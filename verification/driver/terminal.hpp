#pragma once

#include <string>
#include <vector>

#include "verification/check/record.hpp"
#include "verification/driver/results.hpp"

namespace talus::verification {

/// A failed check in one line: case, name, measured, reference, error/bound, why.
[[nodiscard]] std::string sentence(const std::string& id, const Check& check);

/// A control that did not turn red, in one line.
[[nodiscard]] std::string sentence(const std::string& id, const Control& control);

/// What the driver writes for people: one line for each case on standard output, progress on standard error. Colour
/// only on a terminal and without NO_COLOR; progress only if standard error is a terminal.
class Terminal {
 public:
  /// `total` cases are to run.
  explicit Terminal(std::size_t total);

  /// A case ended: its line, and under it what failed.
  void report(const Record& record, const std::vector<std::string>& running, bool reused = false);

  /// The last lines: sums, verdict, and where the results are.
  void summarise(const Results& results, const std::string& results_file) const;

 private:
  [[nodiscard]] std::string painted(const std::string& text, const char* colour) const;
  void show_progress(const std::vector<std::string>& running) const;
  void clear_progress() const;

  std::size_t total_;
  std::size_t ended_ = 0;
  bool colour_;
  bool progress_;
};

}  // namespace talus::verification
