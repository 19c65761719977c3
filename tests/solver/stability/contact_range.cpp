/// Bounds of the effective mass of contacts (solver/stability/contact_range.hpp), compared with the effective masses of
/// touching bodies in many orientations.
#include <algorithm>
#include <boost/test/unit_test.hpp>
#include <cmath>
#include <limits>
#include <random>

#include "solver/dynamics/springs.hpp"
#include "solver/model/model_builder.hpp"
#include "solver/stability/contact_range.hpp"

BOOST_AUTO_TEST_SUITE(contact_range_tests)

using namespace talus;

namespace {

/// Two bodies with one contact.
Model pair_of(Body a, Body b) {
  a.name = "a", b.name = "b";
  ModelBuilder builder;
  const BodyId one = builder.add(a), other = builder.add(b);
  builder.add(Contact{.name = "c", .a = one, .b = other, .law = LinearSpringDashpot{100.0, 0.6, EndRule::clamped}});
  return builder.build();
}

/// Smallest and largest effective mass of the deepest instance over random orientations in which the outlines touch;
/// `b` is moved towards `a`, whose centre of mass stays where it is.
std::pair<double, double> measured(Model model, bool turns_b, int count = 1500) {
  std::mt19937_64 random{7};
  const auto angle = [&] { return 2.0 * std::acos(-1.0) * (static_cast<double>(random() >> 11) * 0x1p-53); };
  double smallest = std::numeric_limits<double>::infinity(), largest = 0.0;
  for (int i = 0; i < count; ++i) {
    const double direction = angle();
    model.bodies[0].angle = angle();
    if (turns_b) model.bodies[1].angle = angle();
    const Vec2 centre = model.bodies[0].p_WB;
    const auto deepest = [&](double distance) {
      model.bodies[1].p_WB = centre + distance * Vec2{std::cos(direction), std::sin(direction)};
      const Dynamics dynamics{model};
      std::vector<Spring> found = springs(dynamics, rest_state(model));
      return *std::ranges::max_element(found, {}, &Spring::deformation);
    };
    double near = 0.01, far = 1.5;
    for (int half = 0; half < 32; ++half) {
      const double middle = 0.5 * (near + far);
      (deepest(middle).deformation > 0.0 ? near : far) = middle;
    }
    const Spring touching = deepest(near);
    smallest = std::min(smallest, touching.effective_mass), largest = std::max(largest, touching.effective_mass);
  }
  return {smallest, largest};
}

}  // namespace

BOOST_AUTO_TEST_CASE(largest_levers_of_outlines) {
  BOOST_TEST(largest_lever(Circle{0.3}, {}) == 0.0);
  BOOST_TEST(largest_lever(Circle{0.3}, {0.0, 0.4}) == 0.4);
  BOOST_TEST(largest_lever(Rectangle{0.5, 0.2}, {}) == 0.5);
  // About the middle of a short side: the far corners.
  BOOST_TEST(largest_lever(Rectangle{0.5, 0.2}, {-0.5, 0.0}) == 1.0);
  // From (0, 4) the corner (1, 1) of a square is at (1, -3): the normal (3, 1)/sqrt(10) across this line is between
  // those of the sides at the corner.
  BOOST_TEST(largest_lever(Rectangle{1.0, 1.0}, {0.0, 4.0}) == 5.0);
  BOOST_TEST(largest_lever(Rectangle{1.0, 1.0}, {0.0, 1.2}) == 2.2);
  // An ellipse: |a - b|, where tan t = sqrt(a/b).
  BOOST_TEST(largest_lever(Superquadric{0.5, 0.2, 2.0}, {}) == 0.3, boost::test_tools::tolerance(1e-5));
  BOOST_TEST(largest_lever(HalfPlane{}, {1.0, 1.0}) == 0.0);
}

BOOST_AUTO_TEST_CASE(free_bodies_reach_both_bounds) {
  const Body rod{.mass = 2.0, .inertia = 0.17, .shape = Rectangle{0.5, 0.05}};
  const Body egg{.mass = 1.0, .inertia = 0.05, .shape = Superquadric{0.4, 0.2, 2.5}};
  const Body ball{.mass = 3.0, .inertia = 0.1, .shape = Circle{0.2}};
  for (const auto& [a, b] : {std::pair{rod, ball}, std::pair{egg, ball}, std::pair{rod, egg}}) {
    const Model model = pair_of(a, b);
    const ContactRange range = contact_ranges(Dynamics{model}).at(0);
    const auto [smallest, largest] = measured(model, true);
    BOOST_TEST(smallest >= range.smallest_mass * (1.0 - 1e-4));
    BOOST_TEST(smallest <= range.smallest_mass * 1.03);
    BOOST_TEST(largest <= range.largest_mass * (1.0 + 1e-9));
    BOOST_TEST(largest >= range.largest_mass * 0.98);
  }
  const ContactRange discs = contact_ranges(Dynamics{pair_of(ball, ball)}).at(0);
  BOOST_TEST(discs.smallest_mass == 1.5);
  BOOST_TEST(discs.largest_mass == 1.5);
}

// A beam about its pin that a ball hits: 1/m = 1/m_ball + l^2/I_pin with l up to the far end of the beam.
BOOST_AUTO_TEST_CASE(a_pinned_body_has_the_lever_about_its_pin) {
  const Body beam{
      .mobility = Mobility::pinned, .mass = 3.0, .inertia = 1.0, .shape = Rectangle{1.0, 0.1}, .p_BPin = {-1.0, 0.0}};
  const Body ball{.mobility = Mobility::particle, .mass = 2.0, .shape = Circle{0.1}};
  const ContactRange range = contact_ranges(Dynamics{pair_of(beam, ball)}).at(0);
  BOOST_TEST(range.smallest_mass == 1.0 / (0.5 + 4.0 / 4.0), boost::test_tools::tolerance(1e-15));
  BOOST_TEST(range.largest_mass == 2.0);
  BOOST_TEST(range.highest_frequency == std::sqrt(100.0 / range.smallest_mass), boost::test_tools::tolerance(1e-15));
  BOOST_TEST(range.damping_ratio == 0.6 / (2.0 * std::sqrt(100.0 * range.smallest_mass)),
             boost::test_tools::tolerance(1e-14));
  BOOST_TEST(range.shortest_time ==
             contact_time(LinearSpringDashpot{100.0, 0.6, EndRule::clamped}, range.smallest_mass));
  const Body slider{.mobility = Mobility::sliding_x, .mass = 2.0, .shape = Circle{0.1}};
  const Body post{.mobility = Mobility::fixed, .shape = Circle{0.1}, .p_WB = {1.0, 0.0}};
  const ContactRange sliding = contact_ranges(Dynamics{pair_of(slider, post)}).at(0);
  BOOST_TEST(sliding.smallest_mass == 2.0);
  BOOST_TEST(std::isinf(sliding.largest_mass));
}

// Its guide only takes motions away from a body: it yields at most as much as a free one, and nearly that much where
// the motion that is taken away is not needed.
BOOST_AUTO_TEST_CASE(a_guided_body_has_the_bound_of_a_free_one) {
  const Body ball{.mass = 3.0, .inertia = 0.1, .shape = Circle{0.2}};
  Body rod{.mass = 2.0, .inertia = 0.17, .shape = Rectangle{0.5, 0.05}, .p_BPin = {0.3, 0.2}};
  const double free = contact_ranges(Dynamics{pair_of(rod, ball)}).at(0).smallest_mass;
  for (const Mobility guide : {Mobility::guided_x, Mobility::guided_y}) {
    rod.mobility = guide;
    const Model model = pair_of(rod, ball);
    const ContactRange range = contact_ranges(Dynamics{model}).at(0);
    BOOST_TEST(range.smallest_mass == free);
    const double smallest = measured(model, true, 500).first;
    BOOST_TEST(smallest >= range.smallest_mass * (1.0 - 1e-4));
    BOOST_TEST(smallest <= range.smallest_mass * 1.1);
  }
}

BOOST_AUTO_TEST_SUITE_END()
