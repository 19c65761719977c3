/// Discs that attract each other before they touch, by a law that is in no list: in both systems, with identical bits.
#include <boost/test/unit_test.hpp>
#include <cmath>
#include <random>

#include "solver/granular/disc_system.hpp"
#include "solver/granular/fast_disc_system.hpp"
#include "solver/granular/law_sweep.hpp"
#include "tests/solver/laws/cohesive.hpp"

template struct talus::LawSweeps<talus::LawList<talus::Cohesive>>;

BOOST_AUTO_TEST_SUITE(cohesive_discs_tests)

using namespace talus;

namespace {

constexpr double step = 1e-3;

struct Pair {
  DiscShapes shapes;
  Discs discs;
};
/// Two discs of radius 1 and mass 1 at rest, with this gap between their surfaces.
Pair pair_apart(double gap) {
  Pair pair;
  for (const double side : {-1.0, 1.0})
    pair.shapes.add(1.0, 1.0), pair.discs.add(side * (1.0 + 0.5 * gap), 0.0, 0.0, 0.0);
  return pair;
}

template <class System>
double stored(const System& system, const Discs& discs) {
  double sum = 0.0;
  system.for_each_contact(discs, [&](const DiscContact& contact) { sum += contact.stored; });
  return sum;
}

/// Result of a run of two discs: the largest overlap and the largest energy error.
struct Course {
  double largest_overlap{-1.0}, energy_error{};
  Discs end;
};
template <class System>
Course course(System&& system, Discs discs, long steps) {
  Course found;
  system.begin(discs);
  system.update_modes(discs);
  const auto kinetic = [&] { return 0.5 * (discs.vx[0] * discs.vx[0] + discs.vx[1] * discs.vx[1]); };
  const double start = kinetic() + stored(system, discs);
  for (long n = 0; n < steps; ++n) {
    // A half kick before and after each drift, so that kinetic and stored energy belong to the same time.
    system.kick(discs, 0.5 * step), system.drift(discs, step), system.kick(discs, 0.5 * step);
    found.largest_overlap = std::max(found.largest_overlap, 2.0 - (discs.x[1] - discs.x[0]));
    found.energy_error = std::max(found.energy_error, std::abs(kinetic() + stored(system, discs) - start));
  }
  found.end = discs;
  return found;
}

/// Colliding discs, many of them within the range of the law at any time.
Pair cloud(std::uint32_t seed) {
  std::mt19937 random{seed};
  const auto within = [&](double size) { return size * (static_cast<double>(random()) / 2147483648.0 - 1.0); };
  Pair cloud;
  for (int i = 0; i < 100; ++i) {
    const double radius = 1.0 - 0.1 * (static_cast<double>(random()) / 4294967296.0);
    cloud.shapes.add(radius, 1.0 / (radius * radius));
    cloud.discs.add(2.15 * (i % 10 - 4.5), 2.15 * (i / 10 - 4.5), within(1.5), within(1.5));
  }
  return cloud;
}

}  // namespace

BOOST_AUTO_TEST_CASE(discs_within_the_range_attract_each_other_and_touch) {
  const Cohesive law{.stiffness = 100.0, .range = 0.2, .damping = 0.0};
  const Pair pair = pair_apart(0.1);
  // From the energy k s^2 (1/2 + s/(3 d)) - const: from rest at s = -d/2 to the root of 2 u^3 + 3 u^2 = 1/2, u = s/d.
  const double turn = 0.2 * 0.36602540378443865;
  for (const double skin : {0.01, 0.5}) {
    const Course plain = course(DiscSystem{pair.shapes, {}, law, skin}, pair.discs, 3000);
    const Course fast = course(FastDiscSystem{pair.shapes, {}, law, skin}, pair.discs, 3000);
    BOOST_TEST((plain.end == fast.end));
    BOOST_TEST(plain.largest_overlap == turn, boost::test_tools::tolerance(1e-3));
    // The energy error of velocity Verlet is (w h)^2/8 of the pair's energy, w^2 = 2 k/m (1 + 2 u) at the turning
    // point.
    const double held = 100.0 * 0.2 * 0.2 / 6.0, wh = step * std::sqrt(200.0 * (1.0 + 2.0 * turn / 0.2));
    BOOST_TEST(plain.energy_error < 0.125 * wh * wh * held);
    BOOST_TEST(fast.energy_error == plain.energy_error);
  }
}

BOOST_AUTO_TEST_CASE(discs_out_of_the_range_do_not) {
  const Cohesive law{.stiffness = 100.0, .range = 0.2, .damping = 0.0};
  const Pair pair = pair_apart(0.21);
  BOOST_TEST((course(DiscSystem{pair.shapes, {}, law, 0.05}, pair.discs, 100).end.vx == pair.discs.vx));
  BOOST_TEST((course(FastDiscSystem{pair.shapes, {}, law, 0.05}, pair.discs, 100).end.vx == pair.discs.vx));
}

BOOST_AUTO_TEST_CASE(both_systems_give_the_same_bits) {
  for (const double damping : {0.0, 3.0}) {
    const Cohesive law{.stiffness = 4e3, .range = 0.15, .damping = damping};
    const auto compare = [&](const auto& friction) {
      for (std::uint32_t seed = 0; seed < 4; ++seed) {
        const Pair start = cloud(seed);
        Discs plain_discs = start.discs, fast_discs = start.discs, several_discs = start.discs;
        DiscSystem plain{start.shapes, {}, law, 0.3, friction};
        FastDiscSystem fast{start.shapes, {}, law, 0.3, friction}, several{start.shapes, {}, law, 0.3, friction, 3};
        fast.keep_work(), several.keep_work();
        plain.begin(plain_discs), fast.begin(fast_discs), several.begin(several_discs);
        bool same = true;
        long apart = 0, pressed = 0;
        for (int n = 0; n < 40; ++n) {
          for (int k = 0; k < 10; ++k)
            plain.kick(plain_discs, step), plain.drift(plain_discs, step), plain_discs.t += step;
          fast.advance(fast_discs, step, 10), several.advance(several_discs, step, 10);
          same = same && plain_discs == fast_discs && fast_discs == several_discs;
          fast.for_each_contact(fast_discs, [&](const DiscContact& contact) {
            (contact.depth < 0.0 ? apart : pressed) += 1;
            same = same && (contact.depth > 0.0 || contact.force < 0.0 || damping > 0.0);
          });
        }
        BOOST_TEST(same);
        BOOST_TEST(apart > 200);
        BOOST_TEST(pressed > 200);
        BOOST_TEST(fast.prunings() > fast.builds());
        BOOST_TEST((fast_discs.dissipated() > 0.0) == (damping > 0.0 || FastDiscSystem{fast}.turns));
      }
    };
    compare(Frictionless{}), compare(CoulombFriction{0.5, 2e3});
  }
}

BOOST_AUTO_TEST_SUITE_END()
