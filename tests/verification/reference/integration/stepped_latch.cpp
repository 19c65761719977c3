#include "verification/reference/integration/stepped_latch.hpp"

#include <algorithm>
#include <array>
#include <boost/test/unit_test.hpp>
#include <cmath>

BOOST_AUTO_TEST_SUITE(stepped_latch_tests)

namespace ref = talus::verification::reference;

namespace {

constexpr std::array maps{ref::StepMap::euler, ref::StepMap::taylor, ref::StepMap::leapfrog};

/// Restitution of an impact of a unit mass at unit speed, computed step by step: K1 = 1, force min(K1 d, K2 (d - d0))
/// limited to be >= 0.
double stepped(const ref::SteppedLatch& latch, double phase) {
  const double h = latch.step;
  double x = -phase * h, v = 1.0, largest = 0.0;
  bool closing = true;
  for (int i = 0; i < 1000000; ++i) {
    largest = std::max(largest, x);
    if (v <= 0.0) closing = false;
    const double back = (x - largest * (1.0 - latch.ratio)) / latch.ratio;
    const double a = x <= 0.0 ? 0.0 : closing ? -x : -std::max(0.0, back);
    if (!closing && a == 0.0) return -v;
    if (latch.map == ref::StepMap::leapfrog) {
      v += h * a;
      x += h * v;
    } else {
      x += h * v + (latch.map == ref::StepMap::taylor ? 0.5 * h * h * a : 0.0);
      v += h * a;
    }
  }
  return NAN;
}

}  // namespace

BOOST_AUTO_TEST_CASE(each_impact_to_fourth_order) {
  for (const ref::StepMap map : maps) {
    for (const double ratio : {1.0, 0.81, 0.49, 0.25}) {
      std::array<double, 2> worst{};
      for (std::size_t k = 0; k < 2; ++k) {
        // Not a divisor of the contact time, so that all fractions of a step occur.
        const double step = k == 0 ? 0.0413 : 0.01037;
        for (int i = 0; i < 200; ++i) {
          const double phase = (i + 0.5) / 200.0;
          const double error = std::log(stepped({ratio, step, map}, phase)) -
                               std::log(ref::stepped_restitution({ratio, step, map}, phase));
          worst[k] = std::max(worst[k], std::abs(error));
        }
      }
      BOOST_TEST(worst[0] < 0.2 * std::pow(0.0413 / std::sqrt(ratio), 4));
      BOOST_TEST(worst[1] < 0.2 * std::pow(0.01037 / std::sqrt(ratio), 4));
    }
  }
}

BOOST_AUTO_TEST_CASE(means_of_impacts) {
  for (const ref::StepMap map : maps) {
    for (const double ratio : {0.81, 0.49, 0.25}) {
      const ref::SteppedLatch latch{ratio, 0.0413, map};
      double sum = 0.0;
      for (int i = 0; i < 2000; ++i)
        sum += std::log(stepped(latch, (i + 0.5) / 2000.0)) / 2000.0;
      BOOST_TEST(std::abs(sum - std::log(ref::mean_restitution(latch))) <
                 0.02 * std::pow(0.0413 / std::sqrt(ratio), 4));
    }
  }
}

BOOST_AUTO_TEST_CASE(leading_terms) {
  // e of 0.45 by euler at w1 h = 0.02177 and by taylor at 0.0434: 0.700.
  BOOST_TEST(std::abs(ref::leading_restitution({0.45, 0.02177, ref::StepMap::euler}) - 0.7) < 5e-5);
  BOOST_TEST(std::abs(ref::leading_restitution({0.45, 0.0434, ref::StepMap::taylor}) - 0.7) < 5e-4);
  BOOST_TEST(ref::leading_restitution({0.49, 0.3, ref::StepMap::leapfrog}) == 0.7);
  for (const ref::StepMap map : maps) {
    const double coarse = ref::mean_restitution({0.49, 0.02, map}) / ref::leading_restitution({0.49, 0.02, map}) - 1.0;
    const double predicted = map == ref::StepMap::taylor ? 4e-4 * (1.0 / 0.49 - 1.0) / 16.0 : 0.0;
    BOOST_TEST(std::abs(coarse - predicted) < 5e-6);
  }
  BOOST_TEST(std::isnan(ref::mean_restitution({0.49, 1.5, ref::StepMap::euler})));
}

BOOST_AUTO_TEST_SUITE_END()
