#include "verification/reference/outlines/solid_moments.hpp"

#include <boost/test/unit_test.hpp>
#include <numbers>

BOOST_AUTO_TEST_SUITE(solid_moments_tests)

namespace ref = talus::verification::reference;

BOOST_AUTO_TEST_CASE(sphere_cube_and_rod) {
  const double pi = std::numbers::pi;
  const ref::SolidMoments sphere = ref::integrated_moments(ref::Solid::ellipsoid, 1.5, 1.5);
  BOOST_TEST(sphere.volume == 4.0 / 3.0 * pi * 3.375, boost::test_tools::tolerance(1e-15));
  BOOST_TEST(sphere.polar == 0.4 * sphere.volume * 2.25, boost::test_tools::tolerance(1e-15));
  const ref::SolidMoments cube = ref::integrated_moments(ref::Solid::block, 2.0, 2.0);
  BOOST_TEST(cube.volume == 64.0);
  BOOST_TEST(cube.polar == 64.0 * 16.0 / 6.0, boost::test_tools::tolerance(1e-15));
  // A thin rod: m l^2/12.
  const ref::SolidMoments rod = ref::integrated_moments(ref::Solid::cylinder, 1e-6, 3.0);
  BOOST_TEST(rod.polar / rod.volume == 3.0, boost::test_tools::tolerance(1e-12));
}

BOOST_AUTO_TEST_CASE(centroid_of_a_triangle) {
  const ref::Point c = ref::polygon_centroid({{0.0, 0.0}, {3.0, 0.0}, {0.0, 6.0}});
  BOOST_TEST(c.x == 1.0);
  BOOST_TEST(c.y == 2.0);
}

BOOST_AUTO_TEST_SUITE_END()
