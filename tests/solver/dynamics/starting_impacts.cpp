/// Effective masses of impacts that begin together.
#include "solver/dynamics/starting_impacts.hpp"

#include <boost/test/unit_test.hpp>
#include <cmath>

BOOST_AUTO_TEST_SUITE(starting_impacts_tests)

using namespace talus;

// A body has three degrees of freedom, so that four impulses that stop it are not unique. The mobility along the last
// line, through the centre of mass, is a millionth of that along the first: the rounding of the elimination exceeds
// 1e-12 of it.
BOOST_AUTO_TEST_CASE(singular_impacts_have_single_masses_whatever_their_mobilities) {
  Model model;
  model.bodies = {Body{.name = "body", .mass = 1.0, .inertia = 1e-6},
                  Body{.name = "ground", .mobility = Mobility::fixed}};
  const ContactGroup group{.a = BodyId{0}, .b = BodyId{1}};
  Workspace work;
  work.poses = Poses{model.bodies.size()};
  StartingImpacts impacts;
  struct Line {
    double angle, arm;
  };
  for (const auto& [angle, arm] : {Line{0.5, 1.0}, {1.0, -1.0}, {2.0, 0.5}, {1.6, 0.0}}) {
    const Vec2 n{std::cos(angle), std::sin(angle)};
    impacts.each.at(impacts.count++) = {.group = &group, .instance = work.gaps.size(), .closing = 1.0};
    work.gaps.push_back({.depth = 0.0, .n_AB = n, .p_WC = {arm * n.y, -arm * n.x}});
  }
  const PointMobility mobility{model};
  find_masses(mobility, work, impacts);
  for (std::size_t i = 0; i < impacts.count; ++i)
    BOOST_TEST(impacts.each.at(i).mass == single_mass(mobility, work, impacts.each.at(i)));
}

BOOST_AUTO_TEST_SUITE_END()
