#include "verification/reference/many_bodies/struck_row.hpp"

#include <array>
#include <boost/test/unit_test.hpp>
#include <cmath>
#include <limits>
#include <stdexcept>

#include "verification/reference/mathematics/trajectory.hpp"

BOOST_AUTO_TEST_SUITE(struck_row_tests)

namespace ref = talus::verification::reference;

namespace {

constexpr double eps = std::numeric_limits<double>::epsilon();

/// The same row by tight integration: y = x1, x2, x3, v1, v2, v3; a contact opens or closes where its overlap changes
/// sign.
class IntegratedRow {
 public:
  explicit IntegratedRow(const ref::StruckRow& row) : row_{row} {}

  std::array<double, 6> at(long double t) {
    ref::Coordinates y{0.0L, 0.0L, 0.0L, row_.speed, 0.0L, 0.0L};
    std::array<bool, 2> closed{true, row_.gap == 0.0};
    long double now = 0.0L;
    for (;;) {
      ref::Trajectory piece([&](const ref::Coordinates& x, ref::Coordinates& rates) { rate(closed, x, rates); }, y, now,
                            0.01L);
      const ref::Guard first = [&](const ref::Coordinates& x) { return closed[0] ? overlap(0, x) : -overlap(0, x); };
      const ref::Guard second = [&](const ref::Coordinates& x) { return closed[1] ? overlap(1, x) : -overlap(1, x); };
      const auto event = piece.advance_until(std::array{first, second}, t);
      y = piece.coordinates();
      now = piece.time();
      if (!event) break;
      closed[*event] = !closed[*event];
    }
    std::array<double, 6> found{};
    for (std::size_t i = 0; i < 6; ++i)
      found[i] = static_cast<double>(y[i]);
    return found;
  }

 private:
  long double overlap(std::size_t c, const ref::Coordinates& y) const {
    return y[c] - y[c + 1] - (c == 1 ? row_.gap : 0.0L);
  }
  void rate(const std::array<bool, 2>& closed, const ref::Coordinates& y, ref::Coordinates& rates) const {
    const long double one = closed[0] ? row_.stiffness * overlap(0, y) / row_.mass : 0.0L;
    const long double two = closed[1] ? row_.stiffness * overlap(1, y) / row_.mass : 0.0L;
    for (std::size_t i = 0; i < 3; ++i)
      rates[i] = y[i + 3];
    rates[3] = -one;
    rates[4] = one - two;
    rates[5] = two;
  }
  ref::StruckRow row_;
};

}  // namespace

BOOST_AUTO_TEST_CASE(motion_matches_a_tight_integration) {
  for (const double gap : {0.0, 0.05, 0.3, 0.9}) {
    const ref::StruckRow row{1.3, 7.0, 0.6, gap};
    for (const double t : {0.2, 0.9, 1.4, 2.1, 3.5}) {
      const ref::RowState found = ref::row_at(row, t);
      const auto truth = IntegratedRow{row}.at(t);
      for (std::size_t i = 0; i < 3; ++i) {
        BOOST_TEST(std::abs(found.position[i] - truth[i]) < 1e-14);
        BOOST_TEST(std::abs(found.velocity[i] - truth[i + 3]) < 1e-14);
      }
    }
  }
}

BOOST_AUTO_TEST_CASE(keeps_momentum_and_energy) {
  for (const double gap : {0.0, 0.1, 0.2, 0.5}) {
    const ref::RowRebound found = ref::rebound({2.0, 3.0, 1.5, gap});
    const auto& v = found.velocity;
    BOOST_TEST(std::abs(v[0] + v[1] + v[2] - 1.5) < 4 * eps);
    BOOST_TEST(std::abs(v[0] * v[0] + v[1] * v[1] + v[2] * v[2] - 2.25) < 8 * eps);
    BOOST_TEST(v[0] <= v[1]);
    BOOST_TEST(v[1] <= v[2]);
    BOOST_TEST(found.changes.front().time == 0.0);
    BOOST_TEST(found.changes.back().time == found.end_time);
    BOOST_TEST(!found.changes.back().closed[0]);
    BOOST_TEST(!found.changes.back().closed[1]);
  }
}

BOOST_AUTO_TEST_CASE(far_apart_the_speed_is_handed_on) {
  // The first contact, which lasts half a period, ends before the second disc has crossed a gap of pi v/w.
  const ref::RowRebound found = ref::rebound({1.0, 1.0, 1.0, 4.0});
  BOOST_TEST(std::abs(found.velocity[0]) < 4 * eps);
  BOOST_TEST(std::abs(found.velocity[1]) < 4 * eps);
  BOOST_TEST(std::abs(found.velocity[2] - 1.0) < 4 * eps);
  BOOST_TEST(found.changes.size() == 4u);
}

BOOST_AUTO_TEST_CASE(bad_parameters) {
  BOOST_CHECK_THROW((void)ref::rebound({1.0, 1.0, 0.0, 0.0}), std::invalid_argument);
  BOOST_CHECK_THROW((void)ref::rebound({1.0, 1.0, 1.0, -1.0}), std::invalid_argument);
}

BOOST_AUTO_TEST_SUITE_END()
