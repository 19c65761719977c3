#include "verification/reference/outlines/overlap.hpp"

#include <boost/test/unit_test.hpp>
#include <cmath>
#include <numbers>

BOOST_AUTO_TEST_SUITE(overlap_tests)

namespace ref = talus::verification::reference;
using ref::Outline;
using ref::OutlineKind;

namespace {

Outline box(double a, double b, double x, double y, double angle) {
  return {OutlineKind::rectangle, {a, b, 2.0}, x, y, angle};
}
Outline disc(double r, double x, double y) { return {OutlineKind::circle, {r, r, 2.0}, x, y, 0.4}; }

}  // namespace

BOOST_AUTO_TEST_CASE(discs_overlap_when_their_centres_are_near) {
  BOOST_TEST(ref::overlap_by_points(disc(1.0, 0.0, 0.0), disc(0.5, 1.49, 0.0)));
  BOOST_TEST(!ref::overlap_by_points(disc(1.0, 0.0, 0.0), disc(0.5, 1.0607, 1.0607)));  // 1.50006 apart
  BOOST_TEST(ref::overlap_by_points(disc(1.0, 0.0, 0.0), disc(0.1, 0.1, 0.0)));         // one within the other
}

BOOST_AUTO_TEST_CASE(crossed_boxes_overlap_without_a_corner_inside) {
  BOOST_TEST(ref::overlap_by_points(box(2.0, 0.1, 0.0, 0.0, 0.0), box(2.0, 0.1, 0.0, 0.0, 1.3)));
  BOOST_TEST(!ref::overlap_by_points(box(2.0, 0.1, 0.0, 0.0, 0.0), box(2.0, 0.1, 0.0, 0.21, 0.0)));
}

BOOST_AUTO_TEST_CASE(boundaries_lie_on_the_outlines) {
  const Outline turned = box(2.0, 0.5, 1.0, -1.0, 0.7);
  for (const ref::Point p : ref::boundary(turned, 80)) {
    const double c = std::cos(0.7), s = std::sin(0.7), dx = p.x - 1.0, dy = p.y + 1.0;
    const double u = std::abs(c * dx + s * dy) / 2.0, v = std::abs(c * dy - s * dx) / 0.5;
    BOOST_TEST(std::max(u, v) == 1.0, boost::test_tools::tolerance(1e-14));
  }
  const Outline egg{OutlineKind::superellipse, {2.0, 0.5, 5.0}, 0.0, 0.0, 0.0};
  for (const ref::Point p : ref::boundary(egg, 80)) {
    BOOST_TEST(ref::contains(egg, {0.999 * p.x, 0.999 * p.y}));
    BOOST_TEST(!ref::contains(egg, {1.001 * p.x, 1.001 * p.y}));
  }
}

BOOST_AUTO_TEST_CASE(half_planes) {
  const Outline ground{OutlineKind::half_plane, {}, 0.0, 0.0, std::numbers::pi / 4.0};
  BOOST_TEST(ref::contains(ground, {1.0, 0.9}));
  BOOST_TEST(!ref::contains(ground, {1.0, 1.1}));
  BOOST_TEST(ref::overlap_by_points(disc(1.0, -0.7, 0.7), ground));  // centre 0.99 above it
  BOOST_TEST(!ref::overlap_by_points(ground, disc(1.0, -0.72, 0.72)));
}

// Closed forms: circles, boxes with parallel sides, a corner over a side.
BOOST_AUTO_TEST_CASE(minimum_displacements_of_outlines_with_a_closed_form) {
  const double of_discs = ref::minimum_displacement(disc(1.0, 0.0, 0.0), disc(0.5, 0.9, 0.9), 1600);
  BOOST_TEST(of_discs == 1.5 - 0.9 * std::numbers::sqrt2, boost::test_tools::tolerance(2e-5));
  const double of_boxes = ref::minimum_displacement(
      box(1.0, 0.5, 0.0, 0.0, 0.3), box(0.4, 0.3, -0.2 * std::sin(0.3), 0.2 * std::cos(0.3), 0.3), 1600);
  BOOST_TEST(of_boxes == 0.6, boost::test_tools::tolerance(1e-6));
  const double corner =
      ref::minimum_displacement(box(2.0, 1.0, 0.0, 0.0, 0.0), box(1.0, 1.0, 0.0, 2.3, std::numbers::pi / 4.0), 1600);
  BOOST_TEST(corner == 1.0 + std::numbers::sqrt2 - 2.3, boost::test_tools::tolerance(1e-6));
  const double apart = ref::minimum_displacement(disc(1.0, 0.0, 0.0), disc(0.5, 0.0, 2.0), 1600);
  BOOST_TEST(apart == -0.5, boost::test_tools::tolerance(1e-5));
}

BOOST_AUTO_TEST_SUITE_END()
