#include "solver/calibrate/latching_calibration.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <boost/math/special_functions/lambert_w.hpp>
#include <boost/math/tools/toms748_solve.hpp>
#include <cmath>
#include <cstdint>
#include <numbers>
#include <string_view>
#include <utility>
#include <variant>

#include "solver/base/error.hpp"
#include "solver/granular/disc_system.hpp"

namespace talus {
namespace {

std::string_view method_name(const SteppedContact& contact) { return traits(contact.method).name; }

/// Growth exponent of loading, c pi w1 h.
double gain_in_loading(const SteppedContact& contact) {
  return traits(contact.method).amplitude_growth_rate * std::numbers::pi * contact.loading_angle();
}

InputError out_of_range(const SteppedContact& contact, double restitution, double minimum) {
  if (minimum > 1.0) {
    return InputError{
        fmt::format("restitution: found {}; with {} at this step, w1 h = {:.4g}, an impact always gains speed, {:.4g} "
                    "times as much "
                    "at least; a shorter step is needed",
                    restitution, method_name(contact), contact.loading_angle(), minimum)};
  }
  return InputError{
      fmt::format("restitution: found {}; possible with {} at this step, w1 h = {:.4g}: {:.4g} to 1; a shorter step "
                  "extends this interval",
                  restitution, method_name(contact), contact.loading_angle(), minimum)};
}

/// Restitution of one impact of two discs. Lengths are scaled such that the largest overlap is 1/16 of a radius.
double impact_restitution(const SteppedContact& contact, double ratio, double phase) {
  const double radius = 1.0, speed = contact.loading_angle() / contact.step / 16.0;
  DiscShapes shapes;
  Discs discs;
  for (const double side : {-1.0, 1.0}) {
    shapes.add(radius, 0.5 / contact.effective_mass);
    discs.add(side * (radius + 0.5 * phase * contact.step * speed), 0.0, -0.5 * side * speed, 0.0);
  }
  DiscSystem system{shapes, {}, LatchingSpring{contact.stiffness, contact.stiffness / ratio, 0.0}, radius};
  return std::visit(
      [&](auto method) {
        system.begin(discs);
        method.start(system, discs, contact.step);
        const auto closing = [&] { return discs.vx[0] - discs.vx[1]; };
        // When the force has ended, the discs separate at their remaining speed.
        const double part = 1.0 / (contact.loading_angle() * std::sqrt(ratio));
        const auto maximum = static_cast<long>(4.0 * contact.steps_in_contact(ratio) + 4.0 * part) + 10;
        for (long n = 0; n < maximum; ++n) {
          method.step(system, discs, contact.step);
          if (closing() < 0.0 && discs.x[1] - discs.x[0] > 2.0 * radius) return -closing() / speed;
        }
        throw InputError{
            fmt::format("restitution: with {} at this step, w1 h = {:.4g}, discs of K1/K2 = {:.4g} do not "
                        "part; a shorter step is needed",
                        method_name(contact), contact.loading_angle(), ratio)};
      },
      contact.method);
}

}  // namespace

double SteppedContact::loading_angle() const { return step * std::sqrt(stiffness / effective_mass); }

double SteppedContact::steps_in_contact(double ratio) const {
  return 0.5 * std::numbers::pi * (1.0 + std::sqrt(ratio)) / loading_angle();
}

double stepped_restitution(const SteppedContact& contact, double ratio) {
  return stepped_restitution(contact.method, std::sqrt(ratio), contact.loading_angle());
}

double minimum_restitution(const SteppedContact& contact) {
  const double gained = gain_in_loading(contact);
  return gained > 0.0 ? gained * std::exp(1.0 + gained) : 0.5 * contact.loading_angle();
}

double ratio_by_formula(const SteppedContact& contact, double restitution) {
  const double minimum = minimum_restitution(contact), gained = gain_in_loading(contact);
  if (!(restitution >= minimum && restitution <= 1.0)) throw out_of_range(contact, restitution, minimum);
  if (gained == 0.0) return restitution * restitution;
  // With r the square root of the ratio and z = c pi w1 h/r: e = r exp(c pi w1 h + z), so
  // -z exp(-z) = -c pi w1 h exp(c pi w1 h)/e, whose solution with z < 1 is on the principal branch.
  const double argument = -gained * std::exp(gained) / restitution;
  const double root = -gained / boost::math::lambert_w0(std::max(argument, -1.0 / std::numbers::e));
  return std::min(1.0, root * root);
}

SimulatedRestitution simulated_restitution(const SteppedContact& contact, double ratio, int phases) {
  double sum = 0.0, squares = 0.0;
  for (int i = 0; i < phases; ++i) {
    const double e = impact_restitution(contact, ratio, (i + 0.5) / phases);
    sum += e, squares += e * e;
  }
  const double mean = sum / phases;
  return {mean, std::sqrt(std::max(0.0, squares / phases - mean * mean))};
}

double ratio_by_simulation(const SteppedContact& contact, double restitution) {
  // The search is for the square root of the ratio, in which the restitution is nearly linear.
  const auto above = [&](double root) { return simulated_restitution(contact, root * root).mean - restitution; };
  double low = std::sqrt(ratio_by_formula(contact, restitution)), high = low;
  double at_low = above(low), at_high = at_low;
  while (at_high < 0.0 && high < 1.0)
    low = high, at_low = at_high, high = std::min(1.0, 1.02 * high), at_high = above(high);
  if (at_high <= 0.0) return high * high;
  while (at_low > 0.0) {
    const double lower = 0.98 * low, at_lower = above(lower);
    if (!(at_lower < at_low)) throw out_of_range(contact, restitution, restitution + at_low);
    high = low, at_high = at_low, low = lower, at_low = at_lower;
  }
  std::uintmax_t evaluations = 60;
  const auto close_enough = [](double a, double b) { return std::abs(b - a) < 1e-10; };
  const auto root = boost::math::tools::toms748_solve(above, low, high, at_low, at_high, close_enough, evaluations);
  const double middle = 0.5 * (root.first + root.second);
  return middle * middle;
}

}  // namespace talus
