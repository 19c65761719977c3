#include "verification/reference/mathematics/trajectory.hpp"

#include <algorithm>
#include <boost/math/tools/toms748_solve.hpp>
#include <boost/numeric/odeint/stepper/controlled_runge_kutta.hpp>
#include <boost/numeric/odeint/stepper/generation.hpp>
#include <boost/numeric/odeint/stepper/runge_kutta_fehlberg78.hpp>
#include <cstdint>
#include <limits>
#include <stdexcept>
#include <utility>

namespace talus::verification::reference {
namespace {

using Stepper = boost::numeric::odeint::runge_kutta_fehlberg78<Coordinates, long double>;

// A hundred units in the last place of a long double: with a tighter tolerance the error estimate is round-off itself.
constexpr long double relative_tolerance = 1e-17L;
// Only for components that are exactly zero: small compared with any length or speed in the references.
constexpr long double absolute_tolerance = 1e-23L;

}  // namespace

Trajectory::Trajectory(Rates rates, Coordinates start, long double start_time, long double longest_step)
    : rates_(std::move(rates)),
      y_(std::move(start)),
      time_(start_time),
      longest_step_(longest_step),
      proposed_step_(longest_step) {
  if (!(longest_step > 0.0L)) throw std::invalid_argument("Trajectory: the longest step must be > 0");
}

Trajectory::Step Trajectory::next_step(long double maximum) {
  auto stepper = boost::numeric::odeint::make_controlled(absolute_tolerance, relative_tolerance, Stepper());
  const auto system = [this](const Coordinates& y, Coordinates& dydt, long double) { rates_(y, dydt); };
  const long double whole = std::min(maximum, longest_step_);
  long double length = std::min(whole, proposed_step_);
  for (int attempt = 0; attempt < 100; ++attempt) {
    const long double tried = length;
    long double reached = 0.0L;
    Coordinates end = y_;
    if (stepper.try_step(system, end, reached, length) == boost::numeric::odeint::success) {
      proposed_step_ = tried < whole ? length : std::max(length, proposed_step_);
      return {tried, std::move(end)};
    }
    proposed_step_ = length;
  }
  throw std::runtime_error("Trajectory: no step length meets the tolerance");
}

Coordinates Trajectory::moved_by(long double length) const {
  if (length == 0.0L) return y_;
  const auto system = [this](const Coordinates& y, Coordinates& dydt, long double) { rates_(y, dydt); };
  Coordinates end = y_;
  Stepper().do_step(system, end, 0.0L, length);
  return end;
}

long double Trajectory::fall_within(const Guard& guard, const Step& step) const {
  const auto value = [&](long double length) { return guard(moved_by(length)); };
  const auto close_enough =
      boost::math::tools::eps_tolerance<long double>(std::numeric_limits<long double>::digits - 1);
  std::uintmax_t evaluations = 200;
  const long double left = guard(y_);
  const long double right = guard(step.end);
  if (left <= 0.0L) return 0.0L;
  if (right == 0.0L) return step.length;
  const auto bracket =
      boost::math::tools::toms748_solve(value, 0.0L, step.length, left, right, close_enough, evaluations);
  return bracket.first + (bracket.second - bracket.first) / 2.0L;
}

void Trajectory::pass(long double length) {
  const long double wanted = length - excess_;
  const long double sum = time_ + wanted;
  excess_ = (sum - time_) - wanted;
  time_ = sum;
}

void Trajectory::land(long double t) {
  time_ = t;
  excess_ = 0.0L;
}

void Trajectory::advance_to(long double t) {
  while (time_ < t) {
    const long double left = (t - time_) + excess_;
    Step step = next_step(left);
    y_ = std::move(step.end);
    pass(step.length);
    if (step.length == left) land(t);
  }
}

std::optional<std::size_t> Trajectory::advance_until(std::span<const Guard> guards, long double limit) {
  std::vector<bool> armed(guards.size(), false);
  while (time_ < limit) {
    const long double left = (limit - time_) + excess_;
    Step step = next_step(left);
    std::optional<std::size_t> first;
    long double earliest = step.length;
    for (std::size_t i = 0; i < guards.size(); ++i) {
      armed[i] = armed[i] || guards[i](y_) > 0.0L;
      if (!armed[i] || guards[i](step.end) > 0.0L) continue;
      const long double length = fall_within(guards[i], step);
      if (first && length >= earliest) continue;
      first = i;
      earliest = length;
    }
    if (first) {
      y_ = moved_by(earliest);
      pass(earliest);
      return first;
    }
    y_ = std::move(step.end);
    pass(step.length);
    if (step.length == left) land(limit);
  }
  return std::nullopt;
}

}  // namespace talus::verification::reference
