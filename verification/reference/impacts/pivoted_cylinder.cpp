#include "verification/reference/impacts/pivoted_cylinder.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <limits>
#include <numbers>
#include <stdexcept>

#include "verification/reference/impacts/restitution.hpp"
#include "verification/reference/mathematics/trajectory.hpp"

namespace talus::verification::reference {
namespace {

double arm(const PivotedCylinder& p) { return p.length / 2.0; }

// w1^2 = factor (1 - cos theta) = 2 factor sin^2(theta/2).
double turning_angle(double angular, double factor) {
  return 2.0 * std::asin(std::abs(angular) / std::sqrt(2.0 * factor));  // asin gives NaN beyond 1: it turns over
}

double weight_factor(const PivotedCylinder& p) { return p.mass * p.gravity * p.length / inertia_about_pin(p); }

double reduced_mass(const PivotedCylinder& p) {
  return effective_mass(1.0 / p.rock_mass, 1.0 / effective_column_mass(p));
}

// Indices in Coordinates. `depth` is also integrated (it is a function of the others) to avoid the loss of digits in
// p - p_G.
enum Coordinate : std::size_t { theta, omega, px, py, vx, vy, depth };

/// Origin at the initial position of G, pin at (0, h); u = (cos, sin) is the column's cross axis, a = (-sin, cos) its
/// long axis. G = (h sin, h - h cos), n = -u. The projection of the rock's centre onto the face lies at height
/// b = a . (p - p_G) above G along the axis. Its material velocity along u is theta' (h - b): the lever arm about the
/// pin times the rate. Hence
///   depth' = v . u - theta' (h - b),   I_p theta'' = F (h - b) - m g h sin theta,   M p'' = -F u - M g y.
struct Laws {
  long double m, h, inertia, rock, g, kn, c;

  Laws(const PivotedCylinder& p, const PivotedContact& contact)
      : m(p.mass),
        h(static_cast<long double>(p.length) / 2.0L),
        inertia(static_cast<long double>(p.inertia) + m * h * h),
        rock(p.rock_mass),
        g(p.gravity),
        kn(contact.stiffness),
        c(contact.damping) {}

  [[nodiscard]] long double lever(const Coordinates& y) const {
    const long double sine = std::sin(y[theta]);
    const long double cosine = std::cos(y[theta]);
    // a . (p - p_G) with a . p_G = -h sin^2 + h cos - h cos^2 = h (cos - 1)
    return h - (-sine * y[px] + cosine * y[py] - h * (cosine - 1.0L));
  }
  [[nodiscard]] long double closing(const Coordinates& y) const {
    return y[vx] * std::cos(y[theta]) + y[vy] * std::sin(y[theta]) - y[omega] * lever(y);
  }
  [[nodiscard]] long double force(const Coordinates& y) const { return kn * y[depth] + c * closing(y); }
  [[nodiscard]] long double spin_up(const Coordinates& y, long double f) const {
    return (f * lever(y) - m * g * h * std::sin(y[theta])) / inertia;
  }
  void rates(const Coordinates& y, Coordinates& dydt, bool touching) const {
    const long double f = touching ? force(y) : 0.0L;
    dydt[theta] = y[omega];
    dydt[omega] = spin_up(y, f);
    dydt[px] = y[vx];
    dydt[py] = y[vy];
    dydt[vx] = -f * std::cos(y[theta]) / rock;
    dydt[vy] = -f * std::sin(y[theta]) / rock - g;
    dydt[depth] = closing(y);
  }
  // dF/dt = k depth' + c depth'', with u' = theta' a, a' = -theta' u:
  //   lever = h cos theta - a . p,  lever' = -v . a + theta' (u . p - h sin theta),
  //   depth'' = p'' . u + theta' v . a - theta'' lever - theta' lever'.
  [[nodiscard]] long double force_rate(const Coordinates& y) const {
    const long double sine = std::sin(y[theta]);
    const long double cosine = std::cos(y[theta]);
    const long double f = force(y);
    const long double along = -sine * y[vx] + cosine * y[vy];
    const long double lever_rate = -along + y[omega] * (cosine * y[px] + sine * y[py] - h * sine);
    const long double normal_acceleration = -f / rock - g * sine;
    const long double closing_rate =
        normal_acceleration + y[omega] * along - spin_up(y, f) * lever(y) - y[omega] * lever_rate;
    return kn * closing(y) + c * closing_rate;
  }
};

PivotedState state_of(const Laws& laws, const Trajectory& path, bool touching) {
  const Coordinates& y = path.coordinates();
  const auto at = [&y](Coordinate coordinate) { return static_cast<double>(y[coordinate]); };
  return {static_cast<double>(path.time()),
          at(theta),
          at(omega),
          at(px),
          at(py),
          at(vx),
          at(vy),
          touching ? static_cast<double>(laws.force(y)) : 0.0};
}

// Largest value before `end`: at the start, where `rate` first falls to zero, or at the end.
double peak(Trajectory path, const Guard& rate, const std::function<long double(const Coordinates&)>& quantity,
            long double end) {
  const long double first = quantity(path.coordinates());
  static_cast<void>(path.advance_until(std::array{rate}, end));
  return static_cast<double>(std::max(first, quantity(path.coordinates())));
}

void swing_out(const PivotedCylinder& p, const Trajectory& release, PivotedSoftImpact& result) {
  // Energy from the end of contact: w^2 = factor (cos theta - cos theta_max), sin^2(theta_max/2) as below.
  const double half = std::sin(result.at_end.angle / 2.0);
  const double sine = std::sqrt(result.at_end.rate * result.at_end.rate / (2.0 * weight_factor(p)) + half * half);
  result.largest_angle = 2.0 * std::asin(sine);
  result.turning_time = std::numeric_limits<double>::quiet_NaN();
  const std::array<Guard, 2> guards{[](const Coordinates& y) { return y[omega]; },
                                    [](const Coordinates& y) { return -y[depth]; }};
  Trajectory path = release;
  // Limit of two small-amplitude periods: a column that turns over has no turning point, and the search ends there.
  const long double limit =
      release.time() + 4.0L * std::numbers::pi_v<long double> / std::sqrt(weight_factor(p) / 2.0L);
  const auto first = path.advance_until(guards, limit);
  result.struck_again = first == std::size_t{1};
  if (first == std::size_t{0}) result.turning_time = static_cast<double>(path.time());
}

void demand(const PivotedCylinder& p, const PivotedContact& contact) {
  if (!(p.mass > 0.0 && p.length > 0.0 && p.inertia > 0.0 && p.rock_mass > 0.0 && p.rock_radius > 0.0 &&
        p.half_width > 0.0 && p.approach_speed > 0.0 && p.gravity > 0.0)) {
    throw std::invalid_argument("soft_impact: masses, lengths, inertia, speed and gravity must be > 0");
  }
  if (!(contact.stiffness > 0.0 && contact.damping >= 0.0)) {
    throw std::invalid_argument("soft_impact: the contact needs k_n > 0 and c >= 0");
  }
}

}  // namespace

double inertia_about_pin(const PivotedCylinder& p) { return p.inertia + p.mass * arm(p) * arm(p); }

double effective_column_mass(const PivotedCylinder& p) { return inertia_about_pin(p) / (arm(p) * arm(p)); }

double cylinder_inertia(double mass, double length, double radius) {
  return mass * (length * length / 12.0 + radius * radius / 4.0);
}

double printed_eq_28(const PivotedCylinder& p) {
  const double square = p.length * p.length / 4.0;
  return p.rock_mass * (1.0 + p.restitution) * square / (p.inertia + (p.rock_mass + p.mass) * square);
}

double corrected_eq_28(const PivotedCylinder& p) { return printed_eq_28(p) * p.approach_speed; }

PivotedImpact rigid_impact(const PivotedCylinder& p) {
  const double v1 = corrected_eq_28(p);
  return {v1, v1 - p.restitution * p.approach_speed, 2.0 * v1 / p.length};
}

double printed_eq_30(const PivotedCylinder& p, double angular, double angle) {
  return angular * angular + 2.0 * weight_factor(p) * (std::cos(angle) - 1.0);
}

double corrected_eq_30(const PivotedCylinder& p, double angular, double angle) {
  return angular * angular + weight_factor(p) * (std::cos(angle) - 1.0);
}

double printed_largest_angle(const PivotedCylinder& p, double angular) {
  return turning_angle(angular, 2.0 * weight_factor(p));
}

double corrected_largest_angle(const PivotedCylinder& p, double angular) {
  return turning_angle(angular, weight_factor(p));
}

PendulumMotion swing(const PivotedCylinder& p, double angular) {
  return PendulumMotion::from_bottom(std::sqrt(weight_factor(p) / 2.0), angular);
}

double particle_damping(const PivotedCylinder& p, double contact_stiffness) {
  return eq_21_damping(p.restitution, contact_stiffness, effective_mass(1.0 / p.rock_mass, 1.0 / p.mass));
}

double pivoted_damping(const PivotedCylinder& p, double contact_stiffness) {
  return eq_21_damping(p.restitution, contact_stiffness, reduced_mass(p));
}

double restitution_of(const PivotedCylinder& p, const PivotedContact& contact) {
  return restitution(contact.damping / (2.0 * std::sqrt(contact.stiffness * reduced_mass(p))), contact.end);
}

PivotedSoftImpact soft_impact(const PivotedCylinder& p, const PivotedContact& contact,
                              std::span<const double> sample_times) {
  demand(p, contact);
  const Laws laws(p, contact);
  const auto touching = [&laws](const Coordinates& y, Coordinates& dydt) { laws.rates(y, dydt, true); };
  const auto free = [&laws](const Coordinates& y, Coordinates& dydt) { laws.rates(y, dydt, false); };
  const long double reduced = reduced_mass(p);
  const long double step = 0.05L / std::max(std::sqrt(laws.kn / reduced), laws.c / reduced);
  const long double gap = static_cast<long double>(p.half_width) + p.rock_radius;
  const Trajectory onset(touching, {0.0L, 0.0L, -gap, 0.0L, p.approach_speed, 0.0L, 0.0L}, 0.0L, step);

  const Guard force = [&laws](const Coordinates& y) { return laws.force(y); };
  const Guard depth_of = [](const Coordinates& y) { return y[depth]; };
  const long double patience = 20.0L * std::numbers::pi_v<long double> * std::sqrt(reduced / laws.kn);
  Trajectory path = onset;
  if (!path.advance_until(std::array{contact.end == EndRule::clamped ? force : depth_of}, patience)) {
    throw std::runtime_error("soft_impact: no end of contact");
  }
  const long double end = path.time();
  PivotedSoftImpact result;
  result.at_end = state_of(laws, path, false);
  result.column_speed = arm(p) * result.at_end.rate;
  result.depth_at_end = contact.end == EndRule::clamped ? static_cast<double>(path.coordinates()[depth]) : 0.0;
  result.largest_depth = peak(
      onset, [&laws](const Coordinates& y) { return laws.closing(y); }, depth_of, end);
  result.peak_force = peak(
      onset, [&laws](const Coordinates& y) { return laws.force_rate(y); }, force, end);
  const auto gain = [&laws](const Coordinates& y) { return laws.spin_up(y, laws.force(y)); };
  result.peak_rate = peak(
      onset, gain, [](const Coordinates& y) { return y[omega]; }, end);

  const long double calm = 0.02L / std::sqrt(static_cast<long double>(weight_factor(p)));
  const Trajectory release(free, path.coordinates(), end, calm);
  swing_out(p, release, result);
  Trajectory early = onset;
  Trajectory late = release;
  for (const double t : sample_times) {
    const bool before = static_cast<long double>(t) < end;
    Trajectory& now = before ? early : late;
    now.advance_to(t);
    result.samples.push_back(state_of(laws, now, before));
  }
  return result;
}

}  // namespace talus::verification::reference
