#include "verification/reference/motion/held_body.hpp"

#include <boost/test/unit_test.hpp>
#include <cmath>

BOOST_AUTO_TEST_SUITE(held_body_tests)

namespace ref = talus::verification::reference;
using ref::Real, ref::SmoothState, ref::SmoothSystem, ref::Triple;

namespace {

/// Negative gradient of an energy with respect to each coordinate.
template <class Energy>
Triple downhill(const Energy& energy, const Triple& q) {
  Triple out{};
  for (std::size_t i = 0; i < 3; ++i) {
    Triple up = q, down = q;
    up[i] += 1e-6L, down[i] -= 1e-6L;
    out[i] = (energy(down) - energy(up)) / 2e-6L;
  }
  return out;
}

const ref::PrescribedMotion wave{{ref::Wave{0.1, 0.2, {{0.3, 2.0, 0.4}}}, ref::Wave{-0.2, 0.0, {{0.2, 3.0, 0.1}}},
                                  ref::Wave{0.0, 0.5, {{0.1, 1.0, 1.0}, {0.05, 4.0, 0.0}}}},
                                 {}};

}  // namespace

BOOST_AUTO_TEST_CASE(cables_pull_down_their_energy) {
  const std::vector<ref::Tie> ties{{0.5, 0.2, 3.0, 1.0, 1.5, 40.0, 0.0}, {-0.4, 0.1, -2.0, 2.0, 1.0, 70.0, 0.0}};
  const SmoothSystem system = ref::body_on_cables(2.0, 0.5, ties);
  const auto energy = [&](const Triple& q) {
    Real sum = 0.0L;
    for (const ref::Tie& tie : ties) {
      const Real x = q[0] + std::cos(q[2]) * tie.body_x - std::sin(q[2]) * tie.body_y;
      const Real y = q[1] + std::sin(q[2]) * tie.body_x + std::cos(q[2]) * tie.body_y;
      const Real drawn = std::hypot(tie.anchor_x - x, tie.anchor_y - y) - tie.rest_length;
      sum += 0.5L * tie.stiffness * drawn * drawn;
    }
    return sum;
  };
  const Triple q{0.1L, -0.3L, 0.7L};
  const Triple force = downhill(energy, q), found = system.acceleration({q, {}, {}}, 0.0L);
  for (std::size_t i = 0; i < 3; ++i)
    BOOST_TEST(std::abs(found[i] * (i == 2 ? 0.5L : 2.0L) - force[i]) < 1e-8L);
}

BOOST_AUTO_TEST_CASE(dashpots_of_cables_lose_their_power) {
  const ref::Tie tie{0.5, 0.2, 3.0, 1.0, 0.0, 0.0, 0.8};
  const SmoothSystem system = ref::body_on_cables(2.0, 0.5, {tie});
  BOOST_TEST(system.damped);
  const SmoothState x = wave.at(0.3L);
  const auto length = [&](Real t) {
    const Triple q = wave.at(t).q;
    return std::hypot(3.0L - q[0] - std::cos(q[2]) * 0.5L + std::sin(q[2]) * 0.2L,
                      1.0L - q[1] - std::sin(q[2]) * 0.5L - std::cos(q[2]) * 0.2L);
  };
  const Real rate = (length(0.3L + 1e-6L) - length(0.3L - 1e-6L)) / 2e-6L;
  const Triple a = system.acceleration(x, 0.0L);
  const Real power = 2.0L * (a[0] * x.v[0] + a[1] * x.v[1]) + 0.5L * a[2] * x.v[2];
  BOOST_TEST(std::abs(power + 0.8L * rate * rate) < 1e-9L);
}

BOOST_AUTO_TEST_CASE(pressed_disc_keeps_its_energy) {
  const ref::PressedDisc disc{1.0, 1.0, 0.5, 100.0, 60.0, 25.0, {{-3.0, 0.0, 3.0}, {3.0, 0.0, 3.0}}};
  const SmoothSystem system = ref::pressed_disc(disc);
  const SmoothState start{{0.02L, 2.3L, 0.0L}, {0.3L, 0.1L, 0.5L}, {0.01L, -0.02L}};
  const auto energy = [&](const SmoothState& x) {
    Real sum = 0.5L * (x.v[0] * x.v[0] + x.v[1] * x.v[1] + 0.5L * x.v[2] * x.v[2]) + 25.0L * x.q[1];
    for (std::size_t i = 0; i < 2; ++i) {
      const Real overlap = 4.0L - std::hypot(x.q[0] - disc.posts[i].x, x.q[1]);
      sum += 50.0L * overlap * overlap + 30.0L * x.z[i] * x.z[i];
    }
    return sum;
  };
  // Runge-Kutta of order 4: error (w h)^4 w t/120 = 1e-12, relative to an energy of 60.
  const SmoothState end = ref::moved(system, start, 0.5L, 4000);
  BOOST_TEST(std::abs(energy(end) - energy(start)) < 1e-10L);
}

BOOST_AUTO_TEST_CASE(disc_rolls_on_a_post_as_on_a_plane) {
  // A disc that rolls around a post of radius R, both rigid: r (w - W) = R W with W the rate about the post.
  const ref::PressedDisc disc{0.5, 1.0, 0.1, 1.0, 1.0, 0.0, {{0.0, 0.0, 2.0}}};
  const Real about = 0.3L, spin = about * 2.5L / 0.5L;
  const auto slip = ref::pressed_disc(disc).slip({0.0L, 2.5L, 0.0L}, {-about * 2.5L, 0.0L, spin});
  BOOST_TEST(std::abs(slip[0]) < 1e-17L);
}

BOOST_AUTO_TEST_CASE(waves_and_forcing) {
  const ref::Wave& one = wave.coordinates[2];
  for (const int n : {0, 1, 2, 3}) {
    const Real slope = (one.derivative(n, 0.7L + 1e-5L) - one.derivative(n, 0.7L - 1e-5L)) / 2e-5L;
    BOOST_TEST(std::abs(slope - one.derivative(n + 1, 0.7L)) < 1e-8L);
  }
  const SmoothSystem springs = ref::body_on_cables(2.0, 0.5, {{0.5, 0.2, 3.0, 1.0, 1.5, 40.0, 0.3}});
  const SmoothState end = ref::moved(ref::forced(springs, wave), wave.at(0.0L), 1.0L, 4000);
  const SmoothState wanted = wave.at(1.0L);
  for (std::size_t i = 0; i < 3; ++i)
    BOOST_TEST(std::abs(end.q[i] - wanted.q[i]) + std::abs(end.v[i] - wanted.v[i]) < 1e-11L);
}

BOOST_AUTO_TEST_SUITE_END()
