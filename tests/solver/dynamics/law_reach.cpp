/// Gaps between bodies whose law acts at a distance, by a law that is in no list.
#include <boost/test/unit_test.hpp>
#include <string>
#include <vector>

#include "solver/dynamics/contact_arrays.hpp"
#include "solver/dynamics/gap_update.hpp"
#include "solver/model/model_builder.hpp"
#include "solver/model/reach.hpp"
#include "tests/solver/laws/cohesive.hpp"

BOOST_AUTO_TEST_SUITE(law_reach_tests)

using namespace talus;

namespace {

/// Rate of the gap of a ball at height `above` that falls onto a plane with speed 2, evaluated with the law in mode 0;
/// 0 where only the gap itself is evaluated.
template <class L>
double rate_of_gap(const L& law, double above) {
  ModelBuilder builder;
  const BodyId ball =
      builder.add(Body{.name = "ball", .mass = 2.0, .inertia = 1.0, .shape = Circle{0.5}, .p_WB = {0.0, 0.5 + above}});
  const BodyId plane = builder.add(Body{.name = "plane", .mobility = Mobility::fixed, .shape = HalfPlane{}});
  const Contact contact{.name = "c", .a = ball, .b = plane};
  ContactArrays<L> arrays;
  std::vector<InstancePair> pairs(1);
  ContactCompiler<L>{builder.model(), arrays, pairs}.add(0, contact, law, {}, {});
  State state;
  state.mode.assign(1, 0);
  Workspace work;
  work.poses = Poses{2};
  work.poses.set(0, {{0.0, 0.5 + above}, {}, {0.0, -2.0}, 0.0});
  work.near.assign(1, Workspace::wanted);
  work.gaps.resize(1), work.rates.assign(1, 0.0);
  GapUpdate{std::get<typename ContactArrays<L>::template Array<Ball, HalfPlane>>(arrays.arrays), &state, work}.run();
  BOOST_TEST(work.gaps[0].depth == -above, boost::test_tools::tolerance(1e-15));
  return work.rates[0];
}

}  // namespace

BOOST_AUTO_TEST_CASE(gaps_are_evaluated_from_the_reach_of_the_law_on) {
  const Cohesive cohesive{.stiffness = 10.0, .range = 0.2, .damping = 0.0};
  BOOST_TEST(rate_of_gap(cohesive, 0.21) == 0.0);
  BOOST_TEST(rate_of_gap(cohesive, 0.19) == 2.0);
  BOOST_TEST(rate_of_gap(LinearSpringDashpot{10.0}, 0.01) == 0.0);
  BOOST_TEST(rate_of_gap(LinearSpringDashpot{10.0}, -0.01) == 2.0);
}

BOOST_AUTO_TEST_CASE(a_law_that_acts_at_a_distance_needs_one) {
  const Shape circle = Circle{1.0}, box = Rectangle{1.0, 2.0}, outline = Superquadric{1.0, 2.0, 3.0},
              plane = HalfPlane{};
  for (const Shape& other : {circle, box, outline, plane})
    BOOST_TEST(reach_error(ContactMethod::resultant, NodeDepth::nearest, circle, other).empty());
  for (const Shape& other : {circle, outline, plane})
    BOOST_TEST(reach_error(ContactMethod::resultant, NodeDepth::nearest, other, box).empty());
  BOOST_TEST(reach_error(ContactMethod::resultant, NodeDepth::nearest, box, box) ==
             "it acts at a distance, and the gap of a rectangle and a rectangle is no distance between outlines that "
             "are apart; give a superquadric, or contact by nodes");
  BOOST_TEST(reach_error(ContactMethod::nodes, NodeDepth::nearest, box, outline).empty());
  BOOST_TEST(reach_error(ContactMethod::nodes, NodeDepth::centroid_ray, box, outline) ==
             "it acts at a distance, and the depth of nodes by 'centroid_ray' is no distance between outlines that are "
             "apart; node_depth must be 'nearest'");
}

BOOST_AUTO_TEST_SUITE_END()
