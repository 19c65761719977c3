#include "verification/reference/cables/hanger_break.hpp"

#include <boost/test/unit_test.hpp>
#include <cmath>
#include <stdexcept>

BOOST_AUTO_TEST_SUITE(hanger_break_tests)

namespace ref = talus::verification::reference;

namespace {

const ref::HungPair pair{2.0, 1.0, 3.0, 5.0, 1.5};

double energy(const ref::PairState& s) {
  return 0.5 * pair.mass_b * s.speed_b * s.speed_b + 0.5 * pair.mass_c * s.speed_c * s.speed_c +
         0.5 * pair.stiffness_1 * s.b * s.b + 0.5 * pair.stiffness_2 * (s.c - s.b) * (s.c - s.b);
}

}  // namespace

BOOST_AUTO_TEST_CASE(held_pair_obeys_its_equations) {
  const ref::PairState start = ref::held_pair(pair, 0.0);
  BOOST_TEST(start.b == 0.0);
  BOOST_TEST(start.c == 0.0);
  BOOST_TEST(std::abs(start.speed_b) < 1e-15);
  BOOST_TEST(start.speed_c == 1.5, boost::test_tools::tolerance(1e-14));
  const double h = 1e-4;
  for (double t = 0.1; t < 3.0; t += 0.173) {
    const ref::PairState a = ref::held_pair(pair, t - h), s = ref::held_pair(pair, t), z = ref::held_pair(pair, t + h);
    const double t2 = pair.stiffness_2 * (s.c - s.b), t1 = pair.stiffness_1 * s.b;
    BOOST_TEST(std::abs((z.b - 2.0 * s.b + a.b) / (h * h) - (t2 - t1) / pair.mass_b) < 1e-6);
    BOOST_TEST(std::abs((z.c - 2.0 * s.c + a.c) / (h * h) + t2 / pair.mass_c) < 1e-6);
    BOOST_TEST(std::abs((z.b - a.b) / (2.0 * h) - s.speed_b) < 1e-7);
    BOOST_TEST(energy(s) == energy(start), boost::test_tools::tolerance(1e-13));
  }
}

BOOST_AUTO_TEST_CASE(load_rises_to_its_first_peak) {
  const ref::LoadPeak peak = ref::first_load_peak(pair);
  double maximum = 0.0;
  for (double t = 0.0; t <= 1.2 * peak.time; t += 1e-5)
    maximum = std::max(maximum, ref::hanger_load(pair, ref::held_pair(pair, t)));
  BOOST_TEST(maximum == peak.load, boost::test_tools::tolerance(1e-9));
}

BOOST_AUTO_TEST_CASE(what_is_lost_is_what_the_cables_held_less_what_the_one_holds) {
  const double strength = 0.7 * ref::first_load_peak(pair).load;
  const ref::HangerBreak broken = ref::break_hanger(pair, strength);
  const ref::PairState& at = broken.at_break;
  BOOST_TEST(ref::hanger_load(pair, at) == strength, boost::test_tools::tolerance(1e-13));
  const double before = 0.5 * pair.stiffness_1 * at.b * at.b + 0.5 * pair.stiffness_2 * (at.c - at.b) * (at.c - at.b);
  const double after = 0.5 * broken.merged_stiffness * at.c * at.c;
  BOOST_TEST(broken.lost == before - after, boost::test_tools::tolerance(1e-12));
  // Two springs in series: 1/k = 1/3 + 1/5.
  BOOST_TEST(broken.merged_stiffness == 15.0 / 8.0, boost::test_tools::tolerance(1e-15));
}

BOOST_AUTO_TEST_CASE(parted_pair_swings_and_flies) {
  const ref::HangerBreak broken = ref::break_hanger(pair, 0.5 * ref::first_load_peak(pair).load);
  const ref::PairState end = ref::parted_pair(pair, broken, broken.slack_time);
  BOOST_TEST(std::abs(end.c) < 1e-14);
  BOOST_TEST(end.speed_c == -broken.exit_speed_c, boost::test_tools::tolerance(1e-14));
  BOOST_TEST(end.speed_b == broken.at_break.speed_b);
  const double h = 1e-4, t = 0.5 * (broken.time + broken.slack_time);
  const ref::PairState a = ref::parted_pair(pair, broken, t - h), s = ref::parted_pair(pair, broken, t),
                       z = ref::parted_pair(pair, broken, t + h);
  BOOST_TEST(std::abs((z.c - 2.0 * s.c + a.c) / (h * h) + broken.merged_stiffness * s.c / pair.mass_c) < 1e-6);
  BOOST_TEST(std::abs((z.b - a.b) / (2.0 * h) - s.speed_b) < 1e-9);
}

BOOST_AUTO_TEST_CASE(a_strong_hanger_is_refused) {
  BOOST_CHECK_THROW((void)ref::break_hanger(pair, 1.01 * ref::first_load_peak(pair).load), std::invalid_argument);
  BOOST_CHECK_THROW((void)ref::break_hanger(pair, 0.0), std::invalid_argument);
}

BOOST_AUTO_TEST_SUITE_END()
