#include "verification/reference/friction/dragged_slider.hpp"

#include <boost/test/unit_test.hpp>
#include <cmath>
#include <stdexcept>

BOOST_AUTO_TEST_SUITE(dragged_slider_tests)

namespace ref = talus::verification::reference;

namespace {

/// A disc of mass 2 on a level table, m/n = 2/3, L = 0.003.
ref::DraggedSlider disc() {
  return {.mass = 2.0,
          .mobility = 3.0,
          .normal_force = 20.0,
          .friction = 0.3,
          .tangential_stiffness = 2000.0,
          .drive = 0.0,
          .slip_rate = 3.0,
          .stretch = 0.0};
}

/// The conserved quantity of the contact point's motion: m v^2/(2 n) + k_s s^2/2 + mu N (path of the slider) - m a
/// (slip)/n.
double energy(const ref::DraggedSlider& p, const ref::SliderState& x, double slip) {
  return p.mass * x.slip_rate * x.slip_rate / (2.0 * p.mobility) +
         0.5 * p.tangential_stiffness * x.stretch * x.stretch + p.friction * p.normal_force * x.slipped -
         p.mass * p.drive * slip / p.mobility;
}

}  // namespace

BOOST_AUTO_TEST_CASE(obeys_its_equations_between_and_across_phases) {
  // Checked by central differences: dv/dt = a - n k_s s/m in both modes, ds/dt = v or 0, and the slider's path grows by
  // the rest.
  for (const double drive : {0.0, 1.0, 4.0, 20.0}) {
    ref::DraggedSlider p = disc();
    p.drive = drive;
    p.slip_rate = drive > 0.0 ? -0.5 : 3.0;
    const ref::DraggedSliderMotion motion{p, 1.5};
    constexpr double h = 1e-5;
    for (double t = 2 * h; t < 1.5 - h; t += 0.00317) {
      const ref::SliderState a = motion.at(t - h), x = motion.at(t), b = motion.at(t + h);
      bool at_event = false;
      for (const auto& phase : motion.phases())
        at_event = at_event || std::abs(t - phase.begin) <= h;
      if (at_event) continue;
      const double force = p.tangential_stiffness * x.stretch;
      BOOST_TEST(std::abs((b.slip_rate - a.slip_rate) / (2 * h) - (p.drive - p.mobility * force / p.mass)) < 1e-4);
      const double sliding = std::abs(x.slip_rate - (b.stretch - a.stretch) / (2 * h));
      BOOST_TEST(std::abs((b.slipped - a.slipped) / (2 * h) - sliding) < 1e-4);
      BOOST_TEST(std::abs((b.speed_gain - a.speed_gain) / (2 * h) - (p.drive - force / p.mass)) < 1e-4);
      BOOST_TEST(std::abs(force) <= p.friction * p.normal_force * (1 + 1e-12));
    }
  }
}

BOOST_AUTO_TEST_CASE(conserves_energy_and_starts_as_given) {
  ref::DraggedSlider p = disc();
  const ref::DraggedSliderMotion motion{p, 1.0};
  BOOST_TEST(motion.at(0.0).slip_rate == 3.0);
  BOOST_TEST(motion.at(0.0).stretch == 0.0);
  const double start = energy(p, motion.at(0.0), 0.0);
  for (const double t : {0.0005, 0.002, 0.1, 0.32, 0.34, 0.9})
    BOOST_TEST(energy(p, motion.at(t), 0.0) == start, boost::test_tools::tolerance(1e-13));
}

BOOST_AUTO_TEST_CASE(a_rigid_disc_rolls_at_two_thirds) {
  // k_s to infinity: slip ends after v/(n mu N/m) = 3/9 s, when the speed of the centre has changed by a third of the
  // initial slip rate.
  ref::DraggedSlider p = disc();
  p.tangential_stiffness = 2e12;
  const ref::DraggedSliderMotion motion{p, 1.0};
  BOOST_TEST_REQUIRE(motion.phases().size() == 3u);
  BOOST_TEST(motion.phases()[2].begin == 1.0 / 3.0, boost::test_tools::tolerance(1e-6));
  BOOST_TEST(motion.at(0.5).speed_gain == -1.0, boost::test_tools::tolerance(1e-6));
}

BOOST_AUTO_TEST_CASE(swings_after_the_slip) {
  const ref::DraggedSlider p = disc();
  const ref::DraggedSliderMotion motion{p, 2.0};
  double maximum = 0.0;
  for (double t = motion.phases()[2].begin; t < 2.0; t += 1e-4)
    maximum = std::max(maximum, std::abs(motion.at(t).slip_rate));
  BOOST_TEST(maximum == ref::swing_after_slip(p), boost::test_tools::tolerance(1e-4));
  BOOST_TEST(maximum == 0.3 * 10.0 * std::sqrt(3.0 * 2.0 / 2000.0), boost::test_tools::tolerance(1e-4));
}

BOOST_AUTO_TEST_CASE(a_block_on_a_slope) {
  // tan = 0.15, mu = 0.3: from an unstretched spring it oscillates up to twice the static stretch, which is the limit;
  // beyond (0.16) it slips by d = v^2/(2 a), v^2 = w^2 L (2 rest - L), and then sticks.
  const double g = 10.0;
  for (const double tangent : {0.149, 0.16, 0.25, 0.31}) {
    const double cosine = 1.0 / std::sqrt(1.0 + tangent * tangent), sine = tangent * cosine;
    ref::DraggedSlider p{.mass = 1.0,
                         .mobility = 1.0,
                         .normal_force = g * cosine,
                         .friction = 0.3,
                         .tangential_stiffness = 400.0,
                         .drive = g * sine,
                         .slip_rate = 0.0,
                         .stretch = 0.0};
    const ref::DraggedSliderMotion motion{p, 20.0};
    const double slipped = motion.at(20.0).slipped;
    const double rest = g * sine / 400.0, limit = 0.3 * g * cosine / 400.0;
    if (tangent < 0.15) {
      BOOST_TEST(slipped == 0.0);
    } else if (tangent < 0.3) {
      const double v2 = 400.0 * limit * (2.0 * rest - limit);
      BOOST_TEST(slipped == v2 / (2.0 * g * (0.3 * cosine - sine)), boost::test_tools::tolerance(1e-12));
      BOOST_TEST(motion.phases().size() == 3u);
    } else {
      BOOST_TEST(motion.at(20.0).slip_rate > 0.15);
    }
    // With a preloaded spring it does not move at all below the threshold.
    p.stretch = std::min(rest, limit);
    const ref::DraggedSliderMotion held{p, 20.0};
    BOOST_TEST((held.at(20.0).slipped > 0.0) == (tangent > 0.3));
  }
}

BOOST_AUTO_TEST_CASE(wrong_problems_are_refused) {
  ref::DraggedSlider p = disc();
  p.stretch = 0.0031;
  BOOST_CHECK_THROW((ref::DraggedSliderMotion{p, 1.0}), std::invalid_argument);
  p = disc();
  p.mobility = 0.5;
  BOOST_CHECK_THROW((ref::DraggedSliderMotion{p, 1.0}), std::invalid_argument);
}

BOOST_AUTO_TEST_SUITE_END()
