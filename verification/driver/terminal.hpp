#pragma once

#include <string>
#include <vector>

#include "verification/check/record.hpp"
#include "verification/driver/results.hpp"

namespace talus::verification {

/// A failed check in one line: case, name, measured, reference, bound, error/bound, justification.
[[nodiscard]] std::string sentence(const std::string& id, const Check& check);

/// A control that did not turn red, in one line.
[[nodiscard]] std::string sentence(const std::string& id, const Control& control);

/// Terminal output of the driver: one line for each case on standard output, progress on standard error. Colours are
/// used only on a terminal and without NO_COLOR; progress is shown only if standard error is a terminal.
class Terminal {
 public:
  /// `total`: number of cases to run; `rounding`: the mode of floating-point numbers in which they run, named beside
  /// failures unless it is "nearest".
  explicit Terminal(std::size_t total, std::string rounding = "nearest");

  /// Prints the line of a finished case, followed by its failures.
  void report(const Record& record, const std::vector<std::string>& running, bool reused = false);

  /// Prints the last lines: totals, verdict, of each case with failed checks the one with the largest finite
  /// error/bound, the largest first, and the location of the results.
  void summarise(const Results& results, const std::string& results_file) const;

 private:
  /// "; rounding upward", or nothing.
  [[nodiscard]] std::string rounding_text() const;
  [[nodiscard]] std::string painted(const std::string& text, const char* colour) const;
  void show_progress(const std::vector<std::string>& running) const;
  void clear_progress() const;

  std::size_t total_;
  std::string rounding_;
  std::size_t ended_ = 0;
  bool colour_;
  bool progress_;
};

}  // namespace talus::verification
