#include "verification/check/convergence.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <set>
#include <stdexcept>
#include <utility>

namespace talus::verification {

namespace {

constexpr double nan = std::numeric_limits<double>::quiet_NaN();
constexpr double golden = 0.61803398874989484820;        // (sqrt(5) - 1) / 2
constexpr double golden_square = 0.3819660112501051518;  // 1 - golden

double fraction(double x) { return x - std::floor(x); }

double golden_phase(std::size_t i) { return fraction(golden * (static_cast<double>(i) + 0.5)); }

bool all_positive(const std::vector<double>& values) {
  return std::all_of(values.begin(), values.end(), [](double x) { return std::isfinite(x) && x > 0.0; });
}

double mean_log(const std::vector<double>& values) {
  double sum = 0.0;
  for (const double value : values)
    sum += std::log(value);
  return sum / static_cast<double>(values.size());
}

}  // namespace

double PowerLaw::at(double step) const { return constant * std::pow(step, order); }

Convergence::Convergence(std::vector<double> steps, std::vector<double> errors)
    : steps_(std::move(steps)), errors_(std::move(errors)) {
  if (steps_.size() != errors_.size()) throw std::invalid_argument("as many errors as steps are needed");
}

void Convergence::add(double step, double error) {
  steps_.push_back(step);
  errors_.push_back(error);
}

Convergence Convergence::last(std::size_t count) const {
  if (count > size()) throw std::invalid_argument("more last points are required than were added");
  const auto skip = static_cast<std::ptrdiff_t>(size() - count);
  return {{steps_.begin() + skip, steps_.end()}, {errors_.begin() + skip, errors_.end()}};
}

Convergence Convergence::between(double smallest, double largest) const {
  Convergence chosen;
  for (std::size_t i = 0; i < size(); ++i) {
    if (steps_[i] >= smallest && steps_[i] <= largest) chosen.add(steps_[i], errors_[i]);
  }
  return chosen;
}

PowerLaw Convergence::fit() const {
  const bool enough = std::set<double>(steps_.begin(), steps_.end()).size() >= 2;
  if (!all_positive(steps_) || !all_positive(errors_) || !enough) return {nan, nan, nan};
  const double x_mean = mean_log(steps_);
  const double y_mean = mean_log(errors_);
  double sxx = 0.0;
  double sxy = 0.0;
  for (std::size_t i = 0; i < size(); ++i) {
    const double s = std::log(steps_[i]) - x_mean;
    sxx += s * s;
    sxy += s * (std::log(errors_[i]) - y_mean);
  }
  const double order = sxy / sxx;
  double squares = 0.0;
  for (std::size_t i = 0; i < size(); ++i) {
    const double off = std::log(errors_[i]) - y_mean - order * (std::log(steps_[i]) - x_mean);
    squares += off * off;
  }
  return {order, std::exp(y_mean - order * x_mean), std::sqrt(squares / static_cast<double>(size()))};
}

void PhaseError::add(double error) {
  ++count_;
  sum_of_squares_ += error * error;
  // std::max would drop a NaN.
  largest_ = std::isnan(error) || std::isnan(largest_) ? nan : std::max(largest_, std::abs(error));
}

double PhaseError::rms() const { return count_ == 0 ? nan : std::sqrt(sum_of_squares_ / static_cast<double>(count_)); }

double PhaseError::max() const { return count_ == 0 ? nan : largest_; }

std::vector<double> even_phases(std::size_t count) {
  std::vector<double> phases;
  for (std::size_t i = 0; i < count; ++i) {
    phases.push_back((static_cast<double>(i) + 0.5) / static_cast<double>(count));
  }
  return phases;
}

std::vector<double> golden_phases(std::size_t count) {
  std::vector<double> phases;
  for (std::size_t i = 0; i < count; ++i)
    phases.push_back(golden_phase(i));
  return phases;
}

double incommensurate_step(double contact_time, double steps_per_contact) {
  return contact_time / (steps_per_contact + golden_square);
}

double offset_step(double contact_time, double steps_per_contact, std::size_t phase) {
  return contact_time / (steps_per_contact + golden_phase(phase));
}

std::vector<double> doublings(double first, std::size_t count) {
  std::vector<double> values;
  for (std::size_t i = 0; i < count; ++i)
    values.push_back(std::ldexp(first, static_cast<int>(i)));
  return values;
}

}  // namespace talus::verification
