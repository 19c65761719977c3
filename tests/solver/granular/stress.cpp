#include "solver/granular/stress.hpp"

#include <boost/test/unit_test.hpp>
#include <cmath>
#include <numbers>

#include "solver/granular/disc_system.hpp"
#include "solver/laws/linear_spring_dashpot.hpp"

BOOST_AUTO_TEST_SUITE(stress_tests)

using namespace talus;

namespace {

constexpr double stiffness = 100.0;

}  // namespace

BOOST_AUTO_TEST_CASE(temperature_is_that_of_the_motion_relative_to_the_flow) {
  DiscShapes shapes;
  Discs discs;
  // Half of the discs are slightly faster than the flow, half slower; one is held.
  for (int i = 0; i < 6; ++i) {
    shapes.add(0.5, 1.0 / (1.0 + i / 2));
    const double y = 1.5 * (i / 2), side = i % 2 == 0 ? 1.0 : -1.0;
    discs.add(0.0, y, 3.0 + 2.0 * y + 0.1 * side, 0.2 * side);
  }
  shapes.add(0.5, 0.0, shapes.add(DiscWall{}));
  discs.add(0.0, -4.0, 1000.0, 1000.0);
  const MeanFlow flow = mean_flow(shapes, discs, 2.0);
  BOOST_TEST(flow.speed == 3.0, boost::test_tools::tolerance(1e-14));
  BOOST_TEST(flow.at(0.5) == 4.0, boost::test_tools::tolerance(1e-14));
  // Masses 1, 1, 2, 2, 3, 3.
  BOOST_TEST(temperature(shapes, discs, flow) == 2.0 * 0.5 * 0.05, boost::test_tools::tolerance(1e-12));
  const Virial kinetic = kinetic_virial(shapes, discs, flow);
  BOOST_TEST(kinetic.xx == 12.0 * 0.01, boost::test_tools::tolerance(1e-12));
  BOOST_TEST(kinetic.xy == 12.0 * 0.02, boost::test_tools::tolerance(1e-12));
  BOOST_TEST(kinetic.yx == kinetic.xy, boost::test_tools::tolerance(1e-12));
  BOOST_TEST(kinetic.yy == 12.0 * 0.04, boost::test_tools::tolerance(1e-12));
  BOOST_TEST(kinetic.pressure() == 6.0 * temperature(shapes, discs, flow), boost::test_tools::tolerance(1e-12));
  BOOST_TEST(temperature(DiscShapes{}, Discs{}, {}) == 0.0);
}

BOOST_AUTO_TEST_CASE(contacts_carry_their_force_across_the_distance_of_the_centres) {
  // A row along x with overlaps d that fills a periodic box: the pressure is k d over the height.
  const double overlap = 0.01, height = 5.0;
  DiscShapes shapes;
  Discs discs;
  for (int i = 0; i < 6; ++i) {
    shapes.add(0.5, 1.0);
    discs.add((1.0 - overlap) * i, 0.0, 0.0, 0.0);
  }
  const PeriodicBox box{.width = 6.0 * (1.0 - overlap), .height = height};
  DiscSystem system{shapes, box, LinearSpringDashpot{stiffness, 0.0, EndRule::clamped}, 0.1};
  system.begin(discs);
  system.update_modes(discs);
  const ContactSums sums = contact_sums(system, discs);
  BOOST_TEST(sums.contacts == 6U);
  BOOST_TEST(sums.virial.xx / (box.width * height) == stiffness * overlap / height,
             boost::test_tools::tolerance(1e-12));
  BOOST_TEST(std::abs(sums.virial.yy) + std::abs(sums.virial.xy) + std::abs(sums.virial.yx) < 1e-14);
  BOOST_TEST(sums.stored == 6.0 * 0.5 * stiffness * overlap * overlap, boost::test_tools::tolerance(1e-12));
  BOOST_TEST(sums.largest_depth == overlap, boost::test_tools::tolerance(1e-12));
  // One contact along a diagonal.
  DiscShapes two;
  Discs leaning;
  two.add(0.5, 1.0), two.add(0.5, 1.0);
  const double along = (1.0 - overlap) * std::numbers::sqrt2 / 2.0;
  leaning.add(0.0, 0.0, 0.0, 0.0), leaning.add(along, along, 0.0, 0.0);
  DiscSystem pair{two, {}, LinearSpringDashpot{stiffness, 0.0, EndRule::clamped}, 0.1};
  pair.begin(leaning);
  pair.update_modes(leaning);
  const Virial virial = contact_sums(pair, leaning).virial;
  const double each = 0.5 * stiffness * overlap * (1.0 - overlap);
  for (const double found : {virial.xx, virial.xy, virial.yx, virial.yy})
    BOOST_TEST(found == each, boost::test_tools::tolerance(1e-10));
}

BOOST_AUTO_TEST_SUITE_END()
