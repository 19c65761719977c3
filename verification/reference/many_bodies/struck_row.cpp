#include "verification/reference/many_bodies/struck_row.hpp"

#include <boost/math/constants/constants.hpp>
#include <optional>
#include <stdexcept>

#include "verification/reference/mathematics/high_precision.hpp"

namespace talus::verification::reference {
namespace {

using Vector = std::array<Real50, 3>;

struct Shape {
  std::array<int, 3> along;
  int square;  ///< square of the frequency, in k/m; 0: free
};

std::array<Shape, 3> shapes(std::array<bool, 2> closed) {
  if (closed[0] && closed[1]) return {{{{1, 1, 1}, 0}, {{1, 0, -1}, 1}, {{1, -2, 1}, 3}}};
  if (closed[0]) return {{{{1, 1, 0}, 0}, {{0, 0, 1}, 0}, {{1, -1, 0}, 2}}};
  if (closed[1]) return {{{{0, 1, 1}, 0}, {{1, 0, 0}, 0}, {{0, 1, -1}, 2}}};
  return {{{{1, 0, 0}, 0}, {{0, 1, 0}, 0}, {{0, 0, 1}, 0}}};
}

/// Positions u and velocities at the start of a segment, and the contacts closed in it.
struct Piece {
  Real50 start;
  Vector u, v;
  std::array<bool, 2> closed;
};

struct Moment {
  Vector u, v;
  Real50 overlap(std::size_t contact) const { return u[contact] - u[contact + 1]; }
  Real50 rate(std::size_t contact) const { return v[contact] - v[contact + 1]; }
};

Moment after(const Piece& piece, const Real50& w, const Real50& t) {
  Moment moment{{Real50(0), Real50(0), Real50(0)}, {Real50(0), Real50(0), Real50(0)}};
  for (const Shape& shape : shapes(piece.closed)) {
    Real50 a(0), b(0);
    int norm = 0;
    for (std::size_t i = 0; i < 3; ++i) {
      a += shape.along[i] * piece.u[i];
      b += shape.along[i] * piece.v[i];
      norm += shape.along[i] * shape.along[i];
    }
    a /= norm;
    b /= norm;
    Real50 value = a + b * t, rate = b;
    if (shape.square != 0) {
      const Real50 frequency = w * sqrt(Real50(shape.square));
      const Real50 c = cos(frequency * t), s = sin(frequency * t);
      value = a * c + b / frequency * s;
      rate = b * c - a * frequency * s;
    }
    for (std::size_t i = 0; i < 3; ++i) {
      moment.u[i] += shape.along[i] * value;
      moment.v[i] += shape.along[i] * rate;
    }
  }
  return moment;
}

struct Event {
  Real50 time;
  std::size_t contact;
};

/// First change of a contact, measured from the start of the segment; none when the discs separate for ever.
std::optional<Event> next_change(const Piece& piece, const Real50& w) {
  if (!piece.closed[0] && !piece.closed[1]) {
    std::optional<Event> first;
    for (std::size_t c = 0; c < 2; ++c) {
      const Real50 rate = piece.v[c] - piece.v[c + 1], gap = piece.u[c + 1] - piece.u[c];
      if (rate > 0 && gap > 0 && (!first || gap / rate < first->time)) first = Event{gap / rate, c};
    }
    return first;
  }
  const auto changed = [&](const Moment& moment, std::size_t c) { return (moment.overlap(c) > 0) != piece.closed[c]; };
  const Real50 grid = boost::math::constants::two_pi<Real50>() / (50 * sqrt(Real50(3)) * w);
  for (int i = 1; i < 10000; ++i) {
    const Moment there = after(piece, w, grid * i);
    std::optional<Event> first;
    for (std::size_t c = 0; c < 2; ++c) {
      if (!changed(there, c)) continue;
      Real50 low = grid * (i - 1), high = grid * i;
      for (int j = 0; j < 24; ++j) {
        const Real50 middle = (low + high) / 2;
        (changed(after(piece, w, middle), c) ? high : low) = middle;
      }
      // At 1e-9 of a grid step from the root, Newton's method doubles the digits in each iteration.
      for (int j = 0; j < 4; ++j) {
        const Moment near = after(piece, w, high);
        high -= near.overlap(c) / near.rate(c);
      }
      if (!first || high < first->time) first = Event{high, c};
    }
    if (first) return first;
  }
  throw std::logic_error("struck_row: a contact that never opens");
}

/// Calls visit(piece, w, duration) for each segment; the last has no duration.
template <class Visit>
void for_each_piece(const StruckRow& row, Visit&& visit) {
  if (!(row.mass > 0.0 && row.stiffness > 0.0 && row.speed > 0.0 && row.gap >= 0.0))
    throw std::invalid_argument("struck_row: needs m, k, v > 0 and gap >= 0");
  const Real50 w = sqrt(Real50(row.stiffness) / Real50(row.mass));
  // For discs in contact the second contact closes together with the first, because the second disc moves at once.
  Piece piece{Real50(0),
              {Real50(0), Real50(0), Real50(row.gap)},
              {Real50(row.speed), Real50(0), Real50(0)},
              {true, row.gap == 0.0}};
  for (;;) {
    const std::optional<Event> event = next_change(piece, w);
    visit(piece, w, event ? std::optional<Real50>(event->time) : std::nullopt);
    if (!event) return;
    const Moment moment = after(piece, w, event->time);
    Piece next{piece.start + event->time, moment.u, moment.v, piece.closed};
    // Set the vanishing overlap to exactly zero: round-off of the wrong sign would be another change.
    const Real50 middle = (next.u[event->contact] + next.u[event->contact + 1]) / 2;
    next.u[event->contact] = next.u[event->contact + 1] = middle;
    next.closed[event->contact] = !next.closed[event->contact];
    piece = next;
  }
}

}  // namespace

RowRebound rebound(const StruckRow& row) {
  RowRebound found;
  for_each_piece(row, [&](const Piece& piece, const Real50&, const std::optional<Real50>& duration) {
    found.changes.push_back({nearest(piece.start), piece.closed});
    if (duration) return;
    found.end_time = nearest(piece.start);
    for (std::size_t i = 0; i < 3; ++i)
      found.velocity[i] = nearest(piece.v[i]);
  });
  return found;
}

RowState row_at(const StruckRow& row, double t) {
  RowState found;
  for_each_piece(row, [&](const Piece& piece, const Real50& w, const std::optional<Real50>& duration) {
    const Real50 local = Real50(t) - piece.start;
    if (local < 0 || (duration && local > *duration)) return;
    const Moment moment = after(piece, w, local);
    for (std::size_t i = 0; i < 3; ++i) {
      found.position[i] = nearest(i == 2 ? Real50(moment.u[i] - row.gap) : moment.u[i]);
      found.velocity[i] = nearest(moment.v[i]);
    }
  });
  return found;
}

}  // namespace talus::verification::reference
