#pragma once

#include <string>
#include <vector>

#include "verification/problems/fence/sample2_run.hpp"

/// Comparison of the printed listing sample2.OUT (Mustoe & Huttelmaier 1993, Appendix II.5.2) with a run.
namespace talus::verification::problems {

/// A derived number of the listing.
struct DerivedNumber {
  std::string name;  ///< with its element, if it belongs to one
  std::string unit;
  std::string printed;  ///< in 1993
  std::string ours;     ///< in the solver's listing; for heights, the initial position in the listing's format
};
[[nodiscard]] std::vector<DerivedNumber> derived_numbers(const Sample2Run& run);

/// Number of lines of the printed listing before the first state, and number of those that the solver's listing has
/// word for word in the same order.
struct HeadLines {
  std::size_t printed{};
  std::size_t same{};
};
[[nodiscard]] HeadLines head_lines(const Sample2Run& run);

/// One printed number of a state and that of the run.
struct Deviation {
  std::size_t print{};  ///< 0 or 1
  int element{};
  std::string quantity;  ///< x, y, theta, vx, vy, omega
  std::string printed;   ///< the text
  double ours{};
  double units{};  ///< ours - printed, in units of the last printed digit
};

/// All numbers of both states that can be compared. Excluded are printed zeros, velocities below 1e-11 ft/s or rad/s,
/// which were round-off in 1993, and the coordinates that belong to them.
[[nodiscard]] std::vector<Deviation> deviations(const Sample2Run& run);

/// Number of rows of both states: one for each element.
[[nodiscard]] std::size_t rows_of_states();

/// Largest magnitude of the deviations of elements first .. last in one print, in units of the last printed digit; NaN
/// if nothing was compared.
[[nodiscard]] double largest_deviation(const std::vector<Deviation>& all, std::size_t print, int first, int last);

/// Mean magnitude of the deviations of elements first .. last in one print, in units of the last printed digit.
[[nodiscard]] double mean_deviation(const std::vector<Deviation>& all, std::size_t print, int first, int last);

}  // namespace talus::verification::problems
