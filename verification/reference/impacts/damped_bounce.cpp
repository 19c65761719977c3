#include "verification/reference/impacts/damped_bounce.hpp"

#include <boost/math/constants/constants.hpp>
#include <boost/math/tools/toms748_solve.hpp>
#include <cstdint>
#include <limits>
#include <optional>
#include <stdexcept>

#include "verification/reference/mathematics/high_precision.hpp"

namespace talus::verification::reference {
namespace {

/// exp(-xi u) (p C + q S) of the header: x - g/w0^2, x', the force and their derivatives are all of this form.
struct Decay {
  Real50 w0, xi, s;
  Real50 p, q;

  [[nodiscard]] Real50 operator()(const Real50& t) const {
    const Real50 u = w0 * t;
    const Real50 sine = s == 0 ? u : xi < 1 ? Real50(sin(s * u) / s) : Real50(sinh(s * u) / s);
    const Real50 cosine = s == 0 ? Real50(1) : xi < 1 ? Real50(cos(s * u)) : Real50(cosh(s * u));
    return exp(-xi * u) * (p * cosine + q * sine);
  }
  // d/dt; C' = w0 (xi^2 - 1) S and S' = w0 C on both sides of xi = 1.
  [[nodiscard]] Decay rate() const { return {w0, xi, s, w0 * (q - xi * p), w0 * ((xi - 1) * (xi + 1) * p - xi * q)}; }

  // First zero at t > 0: p C + q S = 0, tan(s u)/s = -p/q.
  [[nodiscard]] std::optional<Real50> first_zero() const {
    if (s == 0) return q != 0 && -p / q > 0 ? std::optional<Real50>(-p / q / w0) : std::nullopt;
    if (xi < 1) {
      Real50 angle = atan2(Real50(-p * s), q);
      const Real50 pi = boost::math::constants::pi<Real50>();
      while (angle <= 0)
        angle += pi;
      return angle / (s * w0);
    }
    const Real50 ratio = q == 0 ? Real50(-1) : Real50(-p * s / q);
    if (ratio <= 0 || ratio >= 1) return std::nullopt;
    return atanh(ratio) / (s * w0);
  }
};

/// One segment of motion from `start`, in local time.
struct Piece {
  bool touching{};
  Real50 start, x, v;         // time, overlap and overlap rate at the start
  std::optional<Real50> end;  // duration; none if unbounded
};

struct BounceMotion {
  Real50 w0, xi, g, s, rest;
  EndRule rule;

  explicit BounceMotion(const DampedBounce& drop)
      : w0(drop.frequency), xi(drop.damping_ratio), g(drop.gravity), rest(g / (w0 * w0)), rule(drop.end) {
    s = sqrt(abs((1 - xi) * (1 + xi)));
  }

  [[nodiscard]] Decay depth(const Piece& piece) const {  // minus `rest`
    const Real50 y = piece.x - rest;
    return {w0, xi, s, y, piece.v / w0 + xi * y};
  }
  [[nodiscard]] Real50 x_at(const Piece& piece, const Real50& t) const {
    return piece.touching ? Real50(depth(piece)(t) + rest) : Real50(piece.x + t * (piece.v + g * t / 2));
  }
  [[nodiscard]] Real50 v_at(const Piece& piece, const Real50& t) const {
    return piece.touching ? depth(piece).rate()(t) : Real50(piece.v + g * t);
  }

  // First fall to zero of f(t) = decay(t) + offset, offset >= 0. Until its first minimum f falls from the preceding
  // maximum, later minima are higher (decay), and without a minimum f tends to offset from above.
  [[nodiscard]] static std::optional<Real50> first_fall(const Decay& decay, const Real50& offset) {
    const Decay rate = decay.rate();
    const auto f = [&](const Real50& t) { return Real50(decay(t) + offset); };
    Real50 top(0);
    std::optional<Real50> extremum = rate.first_zero();
    if (!extremum) return std::nullopt;
    if (rate.rate()(*extremum) < 0) {          // a maximum: the minimum follows half a period later
      if (decay.xi >= 1) return std::nullopt;  // one extremum only: f tends to offset from above, never reaching 0
      top = *extremum;
      extremum = top + boost::math::constants::pi<Real50>() / (decay.s * decay.w0);
    }
    if (f(*extremum) > 0) return std::nullopt;
    return root(f, top, *extremum);
  }

  template <class F>
  [[nodiscard]] static Real50 root(const F& f, const Real50& low, const Real50& high) {
    const Real50 at_high = f(high);
    if (at_high == 0) return high;
    std::uintmax_t evaluations = 300;
    const auto close = [](const Real50& a, const Real50& b) { return abs(b - a) <= 1e-47 * abs(b); };
    const auto bracket = boost::math::tools::toms748_solve(f, low, high, f(low), at_high, close, evaluations);
    return (bracket.first + bracket.second) / 2;
  }

  [[nodiscard]] std::optional<Real50> contact_duration(const Piece& piece) const {
    const Decay y = depth(piece);
    if (rule == EndRule::attractive) return first_fall(y, rest);
    // force/mass = g - x'': decay -x'' with the offset g
    Decay force = y.rate().rate();
    force.p = -force.p;
    force.q = -force.q;
    return first_fall(force, g);
  }

  // A flight that starts outside the wall, or inside with enough speed to leave it.
  [[nodiscard]] bool ends_at_wall(const Piece& flight) const {
    return flight.x <= 0 || g == 0 || flight.v * flight.v > 2 * g * flight.x;
  }

  // End of a flight: outside, x rises to 0; inside (clamped only), the law's force w0^2 x + 2 xi w0 x' rises to 0.
  [[nodiscard]] std::optional<Real50> flight_duration(const Piece& piece) const {
    if (g == 0) return piece.v > 0 ? std::optional<Real50>(-piece.x / piece.v) : std::nullopt;
    // x = 0 is reached from outside at t = (-v + sqrt(v^2 - 2 g x))/g.
    if (ends_at_wall(piece)) return (-piece.v + sqrt(piece.v * piece.v - 2 * g * piece.x)) / g;
    // Later root of w0^2 (x + v t + g t^2/2) + 2 xi w0 (v + g t) = 0, where the force rises.
    const Real50 lag = 2 * xi / w0;
    const Real50 b = piece.v + lag * g;
    const Real50 c = piece.x + lag * piece.v;
    const Real50 square = b * b - 2 * g * c;
    return square > 0 ? Real50((-b + sqrt(square)) / g) : Real50(0);
  }

  [[nodiscard]] Real50 largest_depth(const Piece& piece) const {
    const std::optional<Real50> turn = depth(piece).rate().first_zero();
    return turn ? x_at(piece, *turn) : piece.x;
  }
};

Piece first_piece(const DampedBounce& drop, const BounceMotion& motion) {
  if (!(drop.frequency > 0.0 && drop.damping_ratio >= 0.0 && drop.gravity >= 0.0 && drop.gap >= 0.0)) {
    throw std::invalid_argument("DampedBounce: needs w0 > 0, xi >= 0, g >= 0 and gap >= 0");
  }
  if (!(drop.speed > 0.0) && (drop.gap == 0.0 || drop.gravity == 0.0)) {
    throw std::invalid_argument("DampedBounce: the disc does not fall on the wall");
  }
  Piece piece{drop.gap == 0.0, Real50(0), Real50(-drop.gap), Real50(drop.speed), std::nullopt};
  piece.end = piece.touching ? motion.contact_duration(piece) : motion.flight_duration(piece);
  return piece;
}

Piece next_piece(const BounceMotion& motion, const Piece& piece) {
  Piece next{!piece.touching, piece.start + *piece.end, motion.x_at(piece, *piece.end), motion.v_at(piece, *piece.end),
             std::nullopt};
  // Set x to exactly zero where it is known: round-off of the wrong sign would mean a contact that is already open.
  if (piece.touching ? motion.rule == EndRule::attractive : motion.ends_at_wall(piece)) next.x = 0;
  next.end = next.touching ? motion.contact_duration(next) : motion.flight_duration(next);
  return next;
}

Bounce bounce_of(const BounceMotion& motion, const Piece& contact) {
  Bounce bounce;
  bounce.start_time = nearest(contact.start);
  bounce.start_speed = nearest(contact.v);
  bounce.largest_depth = nearest(motion.largest_depth(contact));
  if (!contact.end) {
    bounce.end_time = std::numeric_limits<double>::infinity();
    bounce.end_depth = nearest(motion.rest);
    return bounce;
  }
  const Real50 x = motion.x_at(contact, *contact.end);
  const Real50 v = motion.v_at(contact, *contact.end);
  bounce.end_time = nearest(contact.start + *contact.end);
  bounce.end_velocity = nearest(v);
  bounce.end_depth = motion.rule == EndRule::attractive ? 0.0 : nearest(x);
  bounce.apex_gap =
      motion.g > 0 ? nearest(Real50(v * v / (2 * motion.g) - x)) : std::numeric_limits<double>::infinity();
  return bounce;
}

}  // namespace

std::vector<Bounce> bounces(const DampedBounce& drop, int count) {
  const BounceMotion motion(drop);
  std::vector<Bounce> list;
  for (Piece piece = first_piece(drop, motion); static_cast<int>(list.size()) < count;
       piece = next_piece(motion, piece)) {
    if (piece.touching) list.push_back(bounce_of(motion, piece));
    if (!piece.end) break;
  }
  return list;
}

std::vector<BounceState> bounce_states(const DampedBounce& drop, std::span<const double> times) {
  const BounceMotion motion(drop);
  Piece piece = first_piece(drop, motion);
  std::vector<BounceState> states;
  for (const double t : times) {
    while (piece.end && piece.start + *piece.end <= t)
      piece = next_piece(motion, piece);
    const Real50 local = Real50(t) - piece.start;
    states.push_back({nearest(-motion.x_at(piece, local)), nearest(motion.v_at(piece, local)), piece.touching});
  }
  return states;
}

}  // namespace talus::verification::reference
