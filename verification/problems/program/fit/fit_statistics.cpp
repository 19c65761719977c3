#include "verification/problems/program/fit/fit_statistics.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
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

std::vector<double> ratios_of_samples(const std::array<double, 4>& products, const std::array<double, 4>& squares) {
  std::vector<double> possible;
  for (int code = 0; code < 256; ++code) {
    double product = 0.0, square = 0.0;
    for (int draw = 0, rest = code; draw < 4; ++draw, rest /= 4) {
      const auto row = static_cast<std::size_t>(rest % 4);
      product += products[row], square += squares[row];
    }
    possible.push_back(product / square);
  }
  return possible;
}

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
      const Fit found = fit({{50.0, 200.0, 120.0, Spacing::logarithmic}, {0.0, 0.9, 0.5}}, model,
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

namespace {

/// Samples of a line through the origin, y = p x, with a second quantity, 2 p x: p is one of the values that the
/// sums over rows with these counts give. The distance from the nearest one, over the range of p.
double sample_distance() {
  constexpr std::array x{1.0, 2.0, 4.0, 3.0}, y{0.0, 2.0, 40.0, 300.0}, z{1.0, 5.0, 70.0, 610.0};
  constexpr double lower = -50.0, upper = 150.0;
  std::array<double, 4> products{}, squares{};
  for (std::size_t row = 0; row < 4; ++row)
    products[row] = x[row] * (y[row] + 2.0 * z[row]), squares[row] = 5.0 * x[row] * x[row];
  const std::vector<double> possible = ratios_of_samples(products, squares);
  const FitModel model = [&](const std::vector<double>& p, const std::vector<std::size_t>& of) {
    std::vector<double> found;
    for (const std::size_t row : of)
      found.insert(found.end(), {p[0] * x[row] - y[row], 2.0 * p[0] * x[row] - z[row]});
    return found;
  };
  const Fit found = fit({{lower, upper, 20.0}}, model, {.rows = 4, .samples = 400, .seed = 5}, false);
  double worst = 0.0;
  for (const std::vector<double>& sample : found.samples) {
    double nearest = upper - lower;
    for (const double value : possible)
      keep_smallest(nearest, std::abs(sample[0] - value));
    keep_largest(worst, nearest / (upper - lower));
  }
  return found.samples.size() == 400 ? worst : 1.0;
}

/// Largest error of a straight line y = a x + b whose a, or b, is at the lower or upper bound: the other one is then
/// that of a fit of one parameter; and of its standard errors, which are those of both. The first is at least 1 if the
/// fit does not say which one is at its bound, or that it has converged.
std::array<double, 2> bound_errors() {
  constexpr std::array x{0.5, 1.0, 2.0, 3.5, 4.0, 6.0}, y{1.1, 1.9, 4.2, 7.4, 7.7, 12.3};  // nearly 2 x
  const FitModel model = [&](const std::vector<double>& p, const std::vector<std::size_t>& of) {
    std::vector<double> found;
    for (const std::size_t row : of)
      found.push_back(p[0] * x[row] + p[1] - y[row]);
    return found;
  };
  double sum_x = 0.0, sum_y = 0.0, sum_xx = 0.0, sum_xy = 0.0;
  for (std::size_t i = 0; i < x.size(); ++i)
    sum_x += x[i], sum_y += y[i], sum_xx += x[i] * x[i], sum_xy += x[i] * y[i];
  constexpr auto rows = static_cast<double>(x.size());
  double worst = 0.0, errors = 0.0;
  const auto compare = [&](const FitParameter& slope, const FitParameter& shift, double a, double b,
                           std::size_t bound) {
    const Fit found = fit({slope, shift}, model, {.rows = x.size(), .samples = 0}, false);
    keep_worst(worst, found.values[0] - a);
    keep_worst(worst, found.values[1] - b);
    if (!found.converged || !found.at_bound[bound] || found.at_bound[1 - bound]) worst = std::max(1.0, std::abs(worst));
    // The inverse of the normal equations, whose scatter is that about the bounded line.
    double squares = 0.0;
    for (std::size_t i = 0; i < x.size(); ++i)
      squares += std::pow(a * x[i] + b - y[i], 2);
    const double variance = squares / (rows - 2.0) / (rows * sum_xx - sum_x * sum_x);
    keep_worst(errors, found.errors[0] - std::sqrt(rows * variance));
    keep_worst(errors, found.errors[1] - std::sqrt(sum_xx * variance));
  };
  const FitParameter any_slope{-10.0, 10.0, 1.0}, any_shift{-10.0, 10.0, 1.0};
  for (const double a : {2.5, 1.5}) {
    const FitParameter slope = a > 2.0 ? FitParameter{a, 10.0, 5.0} : FitParameter{-10.0, a, 0.0};
    compare(slope, any_shift, a, (sum_y - a * sum_x) / rows, 0);
  }
  for (const double b : {1.0, -1.0}) {
    const FitParameter shift = b > 0.0 ? FitParameter{b, 10.0, 5.0} : FitParameter{-10.0, b, -5.0};
    compare(any_slope, shift, (sum_xy - b * sum_x) / sum_xx, b, 1);
  }
  return {worst, errors};
}

/// Error of the deeper of two minima, from a start beside the other one; and of a narrow minimum, from a start within
/// it, for a parameter and for the logarithm of one.
double minimum_error() {
  double worst = 0.0;
  const FitModel two = [](const std::vector<double>& p, const std::vector<std::size_t>& of) {
    std::vector<double> found;
    for (const std::size_t row : of)
      found.push_back(row == 0 ? p[0] * p[0] - 1.0 : 0.3 * (p[0] - 1.0));
    return found;
  };
  keep_worst(worst, fit({{-3.0, 3.0, -1.2}}, two, {.rows = 2, .samples = 0}, false).values[0] - 1.0);
  for (const Spacing spacing : {Spacing::even, Spacing::logarithmic}) {
    constexpr double lowest = 2.0, centre = 7.3, width = 0.03;
    const FitModel narrow = [](const std::vector<double>& p, const std::vector<std::size_t>& of) {
      const double away = (p[0] - centre) / width;
      std::vector<double> found;
      for (const std::size_t row : of)
        found.push_back((row == 0 ? 1.0 : 0.5) * std::tanh(away));  // constant but for 0.6 around it
      return found;
    };
    const Fit found = fit({{lowest, 20.0, centre + 0.5 * width, spacing}}, narrow,
                          {.rows = 2, .samples = 0, .maximum_searches = 60}, false);
    keep_worst(worst, found.values[0] - centre);
  }
  return worst;
}

/// Largest error of the frequency of exact values of a sin(w t) at 40 times of one unit, for ranges with some thirty
/// minima, that from the middle of the range are many minima away.
double frequency_error() {
  constexpr std::size_t rows = 40;
  const auto value = [](double a, double w, std::size_t row) {
    return a * std::sin(w * (static_cast<double>(row) + 1.0) / rows);
  };
  double worst = 0.0;
  for (const double frequency : {4.7, 21.3, 37.3, 71.9, 96.1}) {
    const FitModel model = [&](const std::vector<double>& p, const std::vector<std::size_t>& of) {
      std::vector<double> found;
      for (const std::size_t row : of)
        found.push_back(value(p[0], p[1], row) - value(2.0, frequency, row));
      return found;
    };
    const Fit found =
        fit({{0.1, 10.0, 1.0, Spacing::logarithmic}, {1.0, 100.0, 50.5}}, model, {.rows = rows, .samples = 0}, false);
    keep_largest(worst, found.values[1] / frequency - 1.0);
  }
  return worst;
}

/// Standard error of a parameter p whose logarithm is a slope, y = x ln p, over its closed form: p times that of the
/// slope, s/sqrt(sum x^2). Largest deviation from 1, with the scatter s given and from the deviations, and with starts
/// far below and above the fit.
double logarithm_error() {
  constexpr std::array x{1.0, 2.0, 3.0, 4.0, 5.0}, y{0.8, 1.3, 2.2, 2.7, 3.6};
  double products = 0.0, squares = 0.0, sum = 0.0;
  for (std::size_t i = 0; i < x.size(); ++i)
    products += x[i] * y[i], squares += x[i] * x[i];
  const double slope = products / squares;
  for (std::size_t i = 0; i < x.size(); ++i)
    sum += (slope * x[i] - y[i]) * (slope * x[i] - y[i]);
  const FitModel model = [&](const std::vector<double>& p, const std::vector<std::size_t>& of) {
    std::vector<double> found;
    for (const std::size_t row : of)
      found.push_back(x[row] * std::log(p[0]) - y[row]);
    return found;
  };
  double worst = 0.0;
  for (const double start : {0.02, 90.0}) {
    for (const bool is_known : {true, false}) {
      const Fit found =
          fit({{0.01, 100.0, start, Spacing::logarithmic}}, model, {.rows = x.size(), .samples = 0}, is_known);
      const double scatter = is_known ? 1.0 : std::sqrt(sum / (static_cast<double>(x.size()) - 1.0));
      keep_worst(worst, found.errors[0] / (std::exp(slope) * scatter / std::sqrt(squares)) - 1.0);
    }
  }
  return worst;
}

/// Whether a fit says that two measured values of p determine it, if its standard error is this fraction of its range.
bool is_undetermined(double fraction) {
  constexpr double range = 10.0;
  const double uncertainty = std::numbers::sqrt2 * fraction * range;
  const FitModel model = [&](const std::vector<double>& p, const std::vector<std::size_t>& of) {
    return std::vector<double>(of.size(), p[0] / uncertainty);
  };
  return fit({{-0.5 * range, 0.5 * range, 1.0}}, model, {.rows = 2, .samples = 0}, true).undetermined[0];
}

}  // namespace

void check_search(Findings& findings) {
  findings.expect_true("undetermined: a standard error of 60 % of the range is, one of 40 % is not",
                       is_undetermined(0.6) && !is_undetermined(0.4), "the guide names half of the range");
  findings.expect("bootstrap: samples of a line through the origin, largest distance from a possible value",
                  sample_distance(), 0.0,
                  Tolerance::round_off(1e-12,
                                       "over the range of the parameter; each sample is one of 256 sums, and "
                                       "Gauss and Newton solve a linear problem in one step"));
  const auto [values, errors] = bound_errors();
  findings.expect("search: parameters of which one is at its bound, largest error", values, 0.0,
                  Tolerance::round_off(1e-12, "of slopes and shifts of some units; a linear problem"));
  findings.expect(
      "search: standard errors of parameters of which one is at its bound, largest error", errors, 0.0,
      Tolerance::round_off(2e-11,
                           "slopes are differences over at least 1e-4 of a range of 20, of deviations of up "
                           "to 60, rounded by 7e-15: 4e-12 of them, and of standard errors of up to 0.5"));
  findings.expect("search: the deeper of two minima, and a narrow one around the start, largest error", minimum_error(),
                  0.0,
                  Tolerance::round_off(1e-12,
                                       "all deviations are zero there, so that each step of Gauss and Newton "
                                       "squares the error of values of some units"));
  findings.expect("search: the frequency of an oscillation, whose sum has some thirty minima, largest error",
                  frequency_error(), 0.0,
                  Tolerance::round_off(1e-12,
                                       "all deviations are zero there, as above; another minimum is at least 5 % "
                                       "away"));
  findings.expect(
      "search: standard error of a parameter whose logarithm is a slope, over its closed form, deviation "
      "from 1",
      logarithm_error(), 0.0,
      Tolerance::model(5e-8,
                       "the scatter is that of a point within 1e-6 of the range, 9.2 in ln p, from the minimum: it is "
                       "larger by half of 55 (9.2e-6)^2 over the sum of squares, 0.048"));
}

}  // namespace talus::verification::problems::fitted_parameters
