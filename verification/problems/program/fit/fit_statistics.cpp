#include "verification/problems/program/fit/fit_statistics.hpp"

#include <fmt/format.h>

#include <cmath>
#include <cstdint>
#include <numbers>
#include <random>
#include <vector>

#include "solver/fit/least_squares.hpp"
#include "verification/study/findings/expectations.hpp"

namespace talus::verification::problems::fitted_parameters {
namespace {

/// Standard normal numbers by Box and Muller.
double normal(std::mt19937_64& generator) {
  const auto uniform = [&] { return std::ldexp(static_cast<double>(generator() >> 11U) + 0.5, -53); };
  const double radius = std::sqrt(-2.0 * std::log(uniform()));
  return radius * std::cos(2.0 * std::numbers::pi * uniform());
}

/// Overlap of an impact over its time, in units of the speed: frequency w and damping ratio xi.
double overlap(double w, double xi, double time) {
  const double s = std::sqrt(1.0 - xi * xi);
  return std::exp(-xi * w * time) * std::sin(s * w * time) / (s * w);
}

}  // namespace

void check_coverage(Findings& findings, const Setup& setup) {
  const std::size_t seeds = setup.coarse ? 200 : 1000;
  constexpr std::size_t rows = 20;
  constexpr double w = 100.0, xi = 0.2, noise = 2e-4;
  std::vector<std::vector<std::string>> lines;
  double worst = 0.0, worst_error = 0.0;
  for (const bool is_known : {true, false}) {
    std::array<double, 2> inside{}, by_error{};
    for (std::size_t seed = 0; seed < seeds; ++seed) {
      std::mt19937_64 generator{seed};
      std::vector<double> times, measured;
      for (std::size_t row = 0; row < rows; ++row) {
        times.push_back((static_cast<double>(row) + 1.0) / (rows + 1.0) * std::numbers::pi / w);
        measured.push_back(overlap(w, xi, times.back()) + noise * normal(generator));
      }
      const FitModel model = [&](const std::vector<double>& p, const std::vector<std::size_t>& of) {
        std::vector<double> found;
        for (const std::size_t row : of)
          found.push_back((overlap(p[0], p[1], times[row]) - measured[row]) / (is_known ? noise : 1.0));
        return found;
      };
      const Fit found = fit({{50.0, 200.0, 120.0, true}, {0.0, 0.9, 0.5, false}}, model,
                            {.rows = rows, .samples = 200, .seed = static_cast<std::int64_t>(seed)}, is_known);
      const double shrink = setup.has("half_interval") ? 0.5 : 1.0;
      constexpr std::array truth{w, xi};
      for (std::size_t i = 0; i < truth.size(); ++i) {
        const double low = found.values[i] + shrink * (found.intervals[i][0] - found.values[i]),
                     high = found.values[i] + shrink * (found.intervals[i][1] - found.values[i]);
        inside[i] += low <= truth[i] && truth[i] <= high ? 1.0 : 0.0;
        by_error[i] += std::abs(found.values[i] - truth[i]) <= 1.96 * found.errors[i] ? 1.0 : 0.0;
      }
    }
    for (std::size_t i = 0; i < 2; ++i) {
      const double share = inside[i] / static_cast<double>(seeds);
      keep_worst(worst, share - 0.95);
      keep_worst(worst_error, by_error[i] / static_cast<double>(seeds) - 0.95);
      lines.push_back({i == 0 ? "frequency" : "damping ratio", is_known ? "given" : "from the scatter",
                       fmt::format("{:.1f}", 100.0 * share),
                       fmt::format("{:.1f}", 100.0 * by_error[i] / static_cast<double>(seeds))});
    }
  }
  findings.expect("bootstrap: fraction of intervals with the true value, largest deviation from 95 %", worst, 0.0,
                  Tolerance::model(setup.coarse ? 0.055 : 0.035,
                                   "percentiles of samples of 20 rows contain it 1 to 2 % less often (Hesterberg "
                                   "2015), and as much is two standard deviations of these seeds"));
  findings.expect(
      "bootstrap: fraction of 1.96 standard errors with the true value, largest deviation from 95 %", worst_error, 0.0,
      Tolerance::model(setup.coarse ? 0.045 : 0.025,
                       "1.96 in place of Student's 2.10 with 18 degrees of freedom costs 1.5 %, and as much "
                       "is 1.5 standard deviations of these seeds"));
  findings.table({.name = "coverage",
                  .caption = "How often intervals of 95 % contain the true value, of 20 measured values, in per cent.",
                  .columns = {"parameter", "uncertainty", "bootstrap", "1.96 standard errors"},
                  .rows = lines});
}

}  // namespace talus::verification::problems::fitted_parameters
