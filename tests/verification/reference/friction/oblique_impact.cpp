#include "verification/reference/friction/oblique_impact.hpp"

#include <algorithm>
#include <boost/test/unit_test.hpp>
#include <cmath>
#include <stdexcept>

BOOST_AUTO_TEST_SUITE(oblique_impact_tests)

namespace ref = talus::verification::reference;
using ref::EndRule;

namespace {

/// A disc with k = m = v_n = 1, k_s/k = kappa.
ref::ObliqueImpact disc(double kappa, double mu, double slip, double damping = 0.0) {
  return {.normal = {1.0, damping, 1.0, 1.0},
          .tangential_stiffness = kappa,
          .friction = mu,
          .mobility = 3.0,
          .slip_rate = slip};
}

/// The same by small steps of another method: the spring is stretched and limited by friction (return mapping).
double stepped(const ref::ObliqueImpact& p, int steps) {
  const double h = 4.0 / steps;
  double d = 0.0, vn = p.normal.approach_speed, s = 0.0, v = p.slip_rate;
  for (int i = 0; i < steps; ++i) {
    d += 0.5 * h * vn;
    s += 0.5 * h * v;
    const double force = std::max(0.0, p.normal.stiffness * d + p.normal.damping * vn);
    if (i > 0 && force == 0.0) return v;
    const double limit = p.friction * force / p.tangential_stiffness;
    s = std::clamp(s, -limit, limit);
    vn -= h * force / p.normal.effective_mass;
    v -= h * p.mobility * p.tangential_stiffness * s / p.normal.effective_mass;
    d += 0.5 * h * vn;
    s += 0.5 * h * v;
  }
  return v;
}

}  // namespace

BOOST_AUTO_TEST_CASE(agrees_with_small_steps) {
  for (const double kappa : {0.1, 0.25, 2.0 / 7.0, 1.0 / 3.0, 0.8, 1.5}) {
    for (const double slip : {-0.7, 0.05, 0.3, 0.8, 1.5, 3.0}) {
      for (const double damping : {0.0, 0.3}) {
        const ref::ObliqueImpact p = disc(kappa, 0.3, slip, damping);
        BOOST_TEST(std::abs(ref::rebound(p, EndRule::clamped).slip_rate - stepped(p, 400000)) < 2e-5);
      }
    }
  }
}

BOOST_AUTO_TEST_CASE(energy_is_kept) {
  // Without damping and with the spring slack at the end, m (v^2 - v'^2)/(2 n) is the friction work.
  for (const double kappa : {0.1, 0.25, 1.0 / 3.0, 0.8, 1.5}) {
    for (const double slip : {0.05, 0.3, 0.8, 1.5, 3.0}) {
      const ref::ObliqueRebound found = ref::rebound(disc(kappa, 0.3, slip), EndRule::clamped);
      const double lost = (slip * slip - found.slip_rate * found.slip_rate) / 6.0;
      BOOST_TEST(std::abs(found.dissipated - lost) < 1e-11);
      BOOST_TEST(found.separation == 1.0, boost::test_tools::tolerance(1e-14));
    }
  }
}

BOOST_AUTO_TEST_CASE(sliding_all_through) {
  // dv = mu (1 + e) v_n, the spin changes by as much over r/2, so that the slip changes by three times dv.
  const ref::ObliqueRebound found = ref::rebound(disc(0.5, 0.3, 4.0), EndRule::clamped);
  BOOST_TEST(found.phases.size() == 1u);
  BOOST_TEST(found.speed_lost == ref::speed_lost_by_gross_sliding(0.3, 1.0, 1.0), boost::test_tools::tolerance(1e-12));
  BOOST_TEST(found.slip_rate == 4.0 - 1.8, boost::test_tools::tolerance(1e-12));
}

BOOST_AUTO_TEST_CASE(full_stick_turns_the_slip_round) {
  for (const double fraction : {0.01, 0.5, 0.99}) {
    ref::ObliqueImpact p = disc(1.0 / 3.0, 0.3, 0.0);
    p.slip_rate = fraction * ref::full_stick_ratio(p);
    const ref::ObliqueRebound found = ref::rebound(p, EndRule::clamped);
    BOOST_TEST(found.slip_rate == -p.slip_rate, boost::test_tools::tolerance(1e-12));
    BOOST_TEST(found.dissipated == 0.0);
  }
}

BOOST_AUTO_TEST_CASE(restitution_of_slip_at_a_quarter) {
  // -v'/v for kappa = 0.25, found earlier by other means to three digits: sticking would give -cos(pi sqrt(3 kappa)) =
  // 0.913, which slip at the end of the contact reduces.
  const struct {
    double ratio, restitution;
  } known[] = {{0.1, 0.911}, {1.0, 0.886}, {2.0, 0.838}, {3.0, 0.740}, {4.0, 0.500}};
  for (const auto& [ratio, restitution] : known) {
    const double slip = 0.3 * ratio;
    BOOST_TEST(std::abs(-ref::rebound(disc(0.25, 0.3, slip), EndRule::clamped).slip_rate / slip - restitution) < 6e-4);
  }
}

BOOST_AUTO_TEST_CASE(ends_and_errors) {
  const ref::ObliqueImpact p = disc(0.5, 0.3, 1.0, 0.4);
  BOOST_TEST(ref::rebound(p, EndRule::attractive).slip_rate == ref::rebound(p, EndRule::clamped).slip_rate);
  BOOST_TEST(ref::rebound(p, EndRule::attractive).separation < ref::rebound(p, EndRule::clamped).separation);
  BOOST_CHECK_THROW((void)ref::rebound(disc(0.0, 0.3, 1.0), EndRule::clamped), std::invalid_argument);
  BOOST_CHECK_THROW((void)ref::rebound(disc(0.5, 0.3, 1.0, 2.5), EndRule::clamped), std::invalid_argument);
}

BOOST_AUTO_TEST_SUITE_END()
