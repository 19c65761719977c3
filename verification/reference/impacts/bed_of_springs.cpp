#include "verification/reference/impacts/bed_of_springs.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <stdexcept>

#include "verification/reference/mathematics/trajectory.hpp"

namespace talus::verification::reference {
namespace {

/// Half the angle of the outline below the wall. Computed from the sine of its half: no cancellation near first touch.
long double half_angle(long double radius, long double depth) {
  return 2.0L * std::asin(std::sqrt(0.5L * std::max(depth, 0.0L) / radius));
}

/// A of the header [L^2].
long double depth_sum(long double radius, long double depth) {
  const long double a = half_angle(radius, depth);
  return 2.0L * radius * (radius * std::sin(a) - (radius - std::max(depth, 0.0L)) * a);
}

/// Equations of overlap and overlap rate while closing (force as in the header) and while parting.
class Bed {
 public:
  Bed(const BedOfSprings& bed, double mass) : R_{bed.radius}, k_{bed.stiffness}, t_{bed.relaxation}, m_{mass} {}

  long double closing_force(const Coordinates& y) const {
    return k_ * (depth_sum(R_, y[0]) + t_ * y[1] * 2.0L * R_ * half_angle(R_, y[0]));
  }
  long double parting_force(const Coordinates& y) const { return k_ * depth_sum(R_, y[0] + t_ * y[1]); }

  /// Rate of the closing force over k: B d' + t (B d'' + B' d'^2), B' = 2/sin a.
  long double closing_force_rate(const Coordinates& y) const {
    const long double a = half_angle(R_, y[0]), rate = y[1];
    return 2.0L * R_ * a * (rate - t_ * closing_force(y) / m_) + t_ * rate * rate * 2.0L / std::sin(a);
  }

  Trajectory closing(long double depth, long double rate, long double longest) const {
    return {[this](const Coordinates& y, Coordinates& out) {
              out = {y[1], -closing_force(y) / m_};
            },
            {depth, rate},
            0.0L,
            longest};
  }
  Trajectory parting(const Coordinates& turned, long double longest) const {
    return {[this](const Coordinates& y, Coordinates& out) {
              out = {y[1], -parting_force(y) / m_};
            },
            {turned[0], 0.0L},
            0.0L,
            longest};
  }

 private:
  long double R_, k_, t_, m_;
};

}  // namespace

double bed_force(const BedOfSprings& bed, double depth) {
  return static_cast<double>(bed.stiffness * depth_sum(bed.radius, depth));
}

double bed_energy(const BedOfSprings& bed, double depth) {
  const long double R = bed.radius, u = R - depth, a = half_angle(R, depth), sine = std::sin(a);
  return static_cast<double>(0.5L * bed.stiffness * R *
                             (R * R * a + R * u * sine - 4.0L * R * u * sine + 2.0L * u * u * a));
}

BedImpact bed_impact(const BedOfSprings& bed, double effective_mass, double speed) {
  if (!(bed.radius > 0.0 && bed.stiffness > 0.0 && bed.relaxation >= 0.0 && effective_mass > 0.0 && speed > 0.0))
    throw std::invalid_argument("bed_impact: needs R, k, m, v > 0 and t >= 0");
  const Bed moving{bed, effective_mass};
  // A time in which the overlap does not exceed the scale on which springs of one radius would stop the bodies.
  const long double longest = 0.01L * std::sqrt(effective_mass / (bed.stiffness * bed.radius));
  // The force begins as the square root of the overlap: the integration starts shortly after touch, when v has
  // decreased by (k t/m) int B dd = (k t/m) (4/3) sqrt(2 R) d^(3/2).
  const long double first = 1e-12L * bed.radius;
  const long double lost = bed.stiffness * bed.relaxation / effective_mass * (4.0L / 3.0L) *
                           std::sqrt(2.0L * bed.radius) * first * std::sqrt(first);
  Trajectory path = moving.closing(first, speed - lost, longest);
  const Guard peak = [&](const Coordinates& y) { return moving.closing_force_rate(y); };
  const Guard turn = [](const Coordinates& y) { return y[1]; };
  const long double limit = 1e6L * longest;
  BedImpact found;
  auto ended = path.advance_until(std::array{turn, peak}, limit);
  found.largest_force = static_cast<double>(moving.closing_force(path.coordinates()));
  if (ended == 1) ended = path.advance_until(std::array{turn}, limit);
  Trajectory back = moving.parting(path.coordinates(), longest);
  const Guard pushes = [&](const Coordinates& y) { return y[0] + static_cast<long double>(bed.relaxation) * y[1]; };
  if (!ended || !back.advance_until(std::array{pushes}, limit))
    throw std::invalid_argument("bed_impact: the bodies do not part");
  found.restitution = static_cast<double>(-back.coordinates()[1]) / speed;
  return found;
}

}  // namespace talus::verification::reference
