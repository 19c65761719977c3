#include "verification/reference/cables/two_cable_contact.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <numbers>
#include <stdexcept>

#include "verification/reference/mathematics/trajectory.hpp"

namespace talus::verification::reference {
namespace {

// Indices in Coordinates.
enum Coordinate : std::size_t { x, v, depth, striker_v };

struct Laws {
  long double k, l, m, striker, kn, c;

  Laws(const TwoCable& p, const SoftContact& contact)
      : k(p.stiffness), l(p.length), m(p.mass), striker(p.striker_mass), kn(contact.stiffness), c(contact.damping) {}

  // Pull of both cables towards -x.
  [[nodiscard]] long double pull(const Coordinates& y) const {
    const long double now = std::sqrt(l * l + y[x] * y[x]);
    const long double stretch = y[x] * y[x] / (now + l);
    return 2.0L * k * stretch * y[x] / now;
  }
  [[nodiscard]] long double closing(const Coordinates& y) const { return y[striker_v] - y[v]; }
  [[nodiscard]] long double force(const Coordinates& y) const { return kn * y[depth] + c * closing(y); }
  [[nodiscard]] long double force_rate(const Coordinates& y) const {
    const long double f = force(y);
    return kn * closing(y) - c * (f / striker + (f - pull(y)) / m);
  }
  void rates(const Coordinates& y, Coordinates& dydt, bool touching) const {
    const long double f = touching ? force(y) : 0.0L;
    dydt[x] = y[v];
    dydt[v] = (f - pull(y)) / m;
    dydt[depth] = closing(y);
    dydt[striker_v] = -f / striker;
  }
};

TwoCableState state_of(const Laws& laws, const Trajectory& path, bool touching) {
  const Coordinates& y = path.coordinates();
  TwoCableState s;
  s.t = static_cast<double>(path.time());
  s.particle_position = static_cast<double>(y[x]);
  s.particle_velocity = static_cast<double>(y[v]);
  s.striker_velocity = static_cast<double>(y[striker_v]);
  s.contact_force = touching ? static_cast<double>(laws.force(y)) : 0.0;
  return s;
}

// Largest value before `end`: at the start, where `rate` first falls to zero, or at the end.
long double peak(Trajectory path, const Guard& rate, const std::function<long double(const Coordinates&)>& quantity,
                 long double end) {
  const long double first = quantity(path.coordinates());
  static_cast<void>(path.advance_until(std::array{rate}, end));
  return std::max(first, quantity(path.coordinates()));
}

void demand(const TwoCable& p, const SoftContact& contact) {
  if (!(p.stiffness >= 0.0 && p.length > 0.0 && p.mass > 0.0 && p.striker_mass > 0.0 && p.approach_speed > 0.0)) {
    throw std::invalid_argument("soft_impact: the problem needs k >= 0, l, m, M and v0 > 0");
  }
  if (!(contact.stiffness > 0.0 && contact.damping >= 0.0)) {
    throw std::invalid_argument("soft_impact: the contact needs k_n > 0 and c >= 0");
  }
}

// A twentieth of the shortest time scale: 1/w, and the decay time of an overdamped contact.
long double longest_contact_step(const Laws& laws) {
  const long double reduced = laws.m * laws.striker / (laws.m + laws.striker);
  return 0.05L / std::max(std::sqrt(laws.kn / reduced), laws.c / reduced);
}

}  // namespace

TwoCableContact soft_impact(const TwoCable& problem, const SoftContact& contact, std::span<const double> sample_times) {
  demand(problem, contact);
  const Laws laws(problem, contact);
  const auto touching = [&laws](const Coordinates& y, Coordinates& dydt) { laws.rates(y, dydt, true); };
  const auto free = [&laws](const Coordinates& y, Coordinates& dydt) { laws.rates(y, dydt, false); };
  const Coordinates start{0.0L, 0.0L, 0.0L, problem.approach_speed};
  const Trajectory onset(touching, start, 0.0L, longest_contact_step(laws));

  const long double reduced = laws.m * laws.striker / (laws.m + laws.striker);
  const long double patience = 20.0L * std::numbers::pi_v<long double> * std::sqrt(reduced / laws.kn);
  const Guard inside = contact.end == EndRule::clamped ? Guard([&laws](const Coordinates& y) { return laws.force(y); })
                                                       : Guard([](const Coordinates& y) { return y[depth]; });
  Trajectory path = onset;
  if (!path.advance_until(std::array{inside}, patience)) throw std::runtime_error("soft_impact: no end of contact");

  TwoCableContact result;
  const long double end = path.time();
  result.at_end = state_of(laws, path, false);
  result.depth_at_end = contact.end == EndRule::clamped ? static_cast<double>(path.coordinates()[depth]) : 0.0;
  const auto closing = [&laws](const Coordinates& y) { return laws.closing(y); };
  const auto depth_of = [](const Coordinates& y) { return y[depth]; };
  result.largest_depth = static_cast<double>(peak(onset, closing, depth_of, end));
  const auto force_rate = [&laws](const Coordinates& y) { return laws.force_rate(y); };
  result.peak_force = static_cast<double>(peak(
      onset, force_rate, [&laws](const Coordinates& y) { return laws.force(y); }, end));
  const auto gain = [&laws](const Coordinates& y) { return laws.force(y) - laws.pull(y); };
  result.peak_speed = static_cast<double>(peak(
      onset, gain, [](const Coordinates& y) { return y[v]; }, end));

  // Motion on the cables: its longest step is a fiftieth of sqrt(m/2k), the shortest time scale of the cables.
  const long double cable_time = laws.k > 0.0L ? std::sqrt(laws.m / (2.0L * laws.k)) : 1.0L;
  const Trajectory release(free, path.coordinates(), end, 0.02L * cable_time);
  Trajectory swing = release;
  const Guard forward = [](const Coordinates& y) { return y[v]; };
  const long double far = end + 1e4L * (cable_time + laws.l / problem.approach_speed);
  if (laws.k > 0.0L && path.coordinates()[v] > 0.0L && swing.advance_until(std::array{forward}, far)) {
    const long double reach = swing.coordinates()[x];
    result.turning_time = static_cast<double>(swing.time());
    result.turning_distance = static_cast<double>(reach);
    result.turning_angle = static_cast<double>(std::atan(reach / laws.l));
    Trajectory again = release;
    const Guard apart = [](const Coordinates& y) { return -y[depth]; };
    result.struck_again = again.advance_until(std::array{apart}, swing.time()).has_value();
  }

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
