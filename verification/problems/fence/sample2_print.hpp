#pragma once

#include <string>
#include <vector>

#include "verification/problems/fence/sample2_run.hpp"

/// The printed listing sample2.OUT (Mustoe & Huttelmaier 1993, Appendix II.5.2) beside a run.
namespace talus::verification::problems {

/// A derived number of the listing.
struct DerivedNumber {
  std::string name;  ///< with its element, if it is one's
  std::string unit;
  std::string printed;  ///< in 1993
  std::string ours;     ///< in the solver's listing; of heights, the initial place in the listing's format
};
[[nodiscard]] std::vector<DerivedNumber> derived_numbers(const Sample2Run& run);

/// Lines of the printed listing before the first state, and how many of them the solver's listing has word for word, in
/// the same order.
struct HeadLines {
  std::size_t printed{};
  std::size_t same{};
};
[[nodiscard]] HeadLines head_lines(const Sample2Run& run);

/// One printed number of a state beside the run's.
struct Deviation {
  std::size_t print{};  ///< 0 or 1
  int element{};
  std::string quantity;  ///< x, y, theta, vx, vy, omega
  std::string printed;   ///< the text
  double ours{};
  double units{};  ///< ours - printed, in units of the last printed digit
};

/// All numbers of both states that can be compared: not zero in print, and no velocity below 1e-11 ft/s or rad/s, which
/// was round-off in 1993, nor the coordinate that goes with it.
[[nodiscard]] std::vector<Deviation> deviations(const Sample2Run& run);

/// Largest size of the deviations, in units of the last printed digit, of elements first .. last in one print; NaN if
/// nothing was compared.
[[nodiscard]] double largest_deviation(const std::vector<Deviation>& all, std::size_t print, int first, int last);

/// Mean size of the deviations of elements first .. last in one print, in units of the last printed digit.
[[nodiscard]] double mean_deviation(const std::vector<Deviation>& all, std::size_t print, int first, int last);

}  // namespace talus::verification::problems
