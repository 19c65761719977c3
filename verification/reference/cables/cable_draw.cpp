#include "verification/reference/cables/cable_draw.hpp"

#include <cmath>
#include <numbers>
#include <stdexcept>

#include "verification/reference/mathematics/high_precision.hpp"

namespace talus::verification::reference {
namespace {

void demand(bool holds, const char* what) {
  if (!holds) throw std::invalid_argument(std::string("cable_draw: ") + what);
}

void demand_sound(const YieldingCable& cable) {
  demand(cable.stiffness > 0.0 && !cable.points.empty() && cable.last_slope >= 0.0, "k must be > 0, a slope >= 0");
  demand(cable.points.front().stretch == 0.0 && cable.points.front().force > 0.0,
         "the yield force must begin at p = 0 and be > 0");
  for (std::size_t i = 1; i < cable.points.size(); ++i) {
    demand(cable.points[i].stretch > cable.points[i - 1].stretch && cable.points[i].force >= cable.points[i - 1].force,
           "stretches must grow, forces not fall");
  }
}

/// Segment of Y that contains p, excluding its end.
struct Piece {
  Real50 stretch, force, slope;
  bool last{};
  Real50 end;
};

Piece piece(const YieldingCable& cable, std::size_t i) {
  const auto& from = cable.points[i];
  if (i + 1 == cable.points.size()) return {from.stretch, from.force, cable.last_slope, true, 0};
  const auto& to = cable.points[i + 1];
  const Real50 slope = (Real50(to.force) - from.force) / (Real50(to.stretch) - from.stretch);
  return {from.stretch, from.force, slope, false, to.stretch};
}

std::size_t piece_of(const YieldingCable& cable, double stretch) {
  std::size_t i = 0;
  while (i + 1 < cable.points.size() && cable.points[i + 1].stretch <= stretch)
    ++i;
  return i;
}

}  // namespace

double yield_force(const YieldingCable& cable, double stretch) {
  demand_sound(cable);
  demand(stretch >= 0.0, "the plastic stretch must be >= 0");
  const Piece on = piece(cable, piece_of(cable, stretch));
  return nearest(on.force + on.slope * (stretch - on.stretch));
}

double yield_elongation(const YieldingCable& cable, double stretch) {
  return stretch + yield_force(cable, stretch) / cable.stiffness;
}

CableDraw draw(const YieldingCable& cable, double mass, double speed, double stretch) {
  demand_sound(cable);
  demand(mass > 0.0 && speed > 0.0 && stretch >= 0.0, "mass and speed must be > 0, the plastic stretch >= 0");
  const Real50 k = cable.stiffness, energy = Real50(mass) * speed * speed / 2;
  std::size_t i = piece_of(cable, stretch);
  Piece on = piece(cable, i);
  Real50 p = stretch, force = on.force + on.slope * (p - on.stretch), left = energy;
  // At its turn the cable stores Y(p)^2/(2 k) of `left`; the excess draws it further.
  if (left <= force * force / (2 * k)) return {nearest(sqrt(2 * k * energy)), stretch, 0.0, speed};
  for (;;) {
    const Real50 slope = on.slope;
    // left = force x + slope x^2/2 + (force + slope x)^2/(2 k), x = p1 - p:  a x^2 + 2 b x - c = 0.
    const Real50 a = slope / 2 + slope * slope / (2 * k), b = (force + force * slope / k) / 2;
    const Real50 c = left - force * force / (2 * k);
    const Real50 x = c / (b + sqrt(b * b + a * c));
    if (on.last || p + x <= on.end) {
      p += x;
      force += slope * x;
      left -= x * (force - slope * x / 2);
      break;
    }
    const Real50 whole = on.end - p;
    left -= whole * (force + slope * whole / 2);
    force += slope * whole;
    p = on.end;
    on = piece(cable, ++i);
  }
  return {nearest(force), nearest(p), nearest(energy - left), nearest(force / sqrt(k * mass))};
}

CableDraw perfectly_plastic_draw(double stiffness, double yield, double mass, double speed) {
  const double returned = yield / std::sqrt(stiffness * mass);
  if (speed <= returned) return {speed * std::sqrt(stiffness * mass), 0.0, 0.0, speed};
  const double lost = 0.5 * mass * speed * speed - 0.5 * yield * yield / stiffness;
  return {yield, lost / yield, lost, returned};
}

double broken_energy(double stiffness, double tension) { return 0.5 * tension * tension / stiffness; }

double speed_kept(double stiffness, double tension, double mass, double speed) {
  return std::sqrt(speed * speed - 2.0 * broken_energy(stiffness, tension) / mass);
}

double plastic_work(const YieldingCable& cable, double stretch) {
  demand_sound(cable);
  demand(stretch >= 0.0, "the plastic stretch must be >= 0");
  Real50 work = 0;
  for (std::size_t i = 0; i < cable.points.size(); ++i) {
    const Piece on = piece(cable, i);
    const Real50 reached = on.last || stretch < on.end ? Real50(stretch) : on.end, x = reached - on.stretch;
    if (x > 0) work += x * (on.force + on.slope * x / 2);
  }
  return nearest(work);
}

double speed_kept(const YieldingCable& cable, double mass, double speed, double stretch) {
  const double taken = plastic_work(cable, stretch) + broken_energy(cable.stiffness, yield_force(cable, stretch));
  demand(mass > 0.0 && 0.5 * mass * speed * speed > taken, "the mass must draw the cable out so far");
  return std::sqrt(speed * speed - 2.0 * taken / mass);
}

double bungee_depth(const Bungee& b) {
  const double hang = b.mass * b.gravity / b.stiffness;
  return hang * (1.0 + std::sqrt(1.0 + 2.0 * b.height / hang));
}

double bungee_period(const Bungee& b) {
  const double hang = b.mass * b.gravity / b.stiffness, w = std::sqrt(b.stiffness / b.mass);
  const double swing = std::numbers::pi / 2.0 + std::asin(1.0 / std::sqrt(1.0 + 2.0 * b.height / hang));
  return 2.0 * (std::sqrt(2.0 * b.height / b.gravity) + swing / w);
}

}  // namespace talus::verification::reference
