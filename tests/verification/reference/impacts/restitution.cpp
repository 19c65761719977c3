#include "verification/reference/impacts/restitution.hpp"

#include <boost/test/unit_test.hpp>
#include <cmath>
#include <limits>
#include <stdexcept>

#include "verification/reference/mathematics/high_precision.hpp"

BOOST_AUTO_TEST_SUITE(restitution_tests)

namespace ref = talus::verification::reference;
using ref::EndRule;
using ref::Real50;

namespace {

constexpr double eps = std::numeric_limits<double>::epsilon();

struct Phase {
  Real50 d, v;
};

// Solves d'' + 2 xi d' + d = 0 (w = 1) by the Taylor series of its recurrence, 50 terms, in steps of 1/8: no closed
// form.
Phase series_step(const Phase& start, const Real50& xi, const Real50& h) {
  Real50 c0 = start.d;
  Real50 c1 = start.v;
  Real50 d = c0;
  Real50 v(0);
  Real50 power(1);
  for (int n = 1; n < 50; ++n) {
    v += n * c1 * power;
    power *= h;
    d += c1 * power;
    const Real50 c2 = -(2 * xi * n * c1 + c0) / (Real50(n) * (n + 1));
    c0 = c1;
    c1 = c2;
  }
  return {d, v};
}

struct End {
  Real50 t, d, v;
};

// Finds the end by stepping, and by bisection of the last step.
End march(const Real50& xi, EndRule rule) {
  const auto inside = [&](const Phase& y) { return rule == EndRule::clamped ? y.d + 2 * xi * y.v > 0 : y.d > 0; };
  Phase y{Real50(0), Real50(1)};
  Real50 t(0);
  const Real50 h = Real50(1) / 8;
  for (Phase next = series_step(y, xi, h); inside(next); next = series_step(y, xi, h)) {
    y = next;
    t += h;
  }
  Real50 low(0);
  Real50 high = h;
  for (int i = 0; i < 160; ++i) {
    const Real50 middle = (low + high) / 2;
    (inside(series_step(y, xi, middle)) ? low : high) = middle;
  }
  const Phase last = series_step(y, xi, low);
  return {t + low, last.d, last.v};
}

double relative(double value, const Real50& truth) { return std::abs(ref::nearest((value - truth) / truth)); }

}  // namespace

BOOST_AUTO_TEST_CASE(closed_forms_match_an_independent_50_digit_series) {
  for (const double xi : {0.01, 0.2, 0.45, 0.5, 0.6, 0.9, 0.999, 1.0, 1.0 + 1e-9, 1.001, 1.7, 5.0}) {
    for (const EndRule rule : {EndRule::attractive, EndRule::clamped}) {
      if (rule == EndRule::attractive && xi > 0.95) continue;  // e below 1e-8: the end cannot be resolved
      const ref::ImpactEvents events = ref::impact_events({1.0, 2.0 * xi, 1.0, 1.0}, rule);
      const End end = march(Real50(xi), rule);
      // Exponents up to 2 xi A = 4.6 and pi xi/s = 7 multiply the eps of their arguments.
      BOOST_TEST(relative(events.restitution, -end.v) < 40 * eps);
      BOOST_TEST(relative(events.contact_time, end.t) < 4 * eps);
      if (rule == EndRule::clamped) BOOST_TEST(relative(events.depth_at_end, end.d) < 20 * eps);
    }
  }
}

BOOST_AUTO_TEST_CASE(the_depth_satisfies_its_equation_and_its_extrema) {
  for (const double xi : {0.0, 0.1, 0.3, 0.49, 0.7, 1.0, 2.0}) {
    const ref::Impact impact{9.0, 2.0 * xi * 6.0, 4.0, 0.7};  // w = 1.5
    const ref::ImpactEvents events = ref::impact_events(impact, EndRule::clamped);
    const ref::DepthState top = ref::depth_at(impact, events.largest_depth_time);
    BOOST_TEST(std::abs(top.rate) < 4 * eps * impact.approach_speed);
    BOOST_TEST(std::abs(top.depth / events.largest_depth - 1.0) < 8 * eps);
    const auto force = [&](double t) {
      const ref::DepthState s = ref::depth_at(impact, t);
      return impact.stiffness * s.depth + impact.damping * s.rate;
    };
    double largest = 0.0;
    const int samples = 4000;
    for (int i = 0; i <= samples; ++i)
      largest = std::max(largest, force(events.contact_time * i / samples));
    // The sampled maximum is below the true one by at most F'' dt^2/8 ~ (pi/4000)^2/8.
    BOOST_TEST(largest <= events.largest_force * (1.0 + 8 * eps));
    BOOST_TEST(largest >= events.largest_force * (1.0 - 1e-6));
    const double h = 1e-4;
    const double t = 0.4;
    const double second = (ref::depth_at(impact, t + h).rate - ref::depth_at(impact, t - h).rate) / (2.0 * h);
    BOOST_TEST(std::abs(4.0 * second + force(t)) < 1e-6);  // central difference: h^2/6 d'''' ~ 1e-8
    BOOST_TEST(ref::depth_at(impact, 0.0).depth == 0.0);
    BOOST_TEST(ref::depth_at(impact, 0.0).rate == 0.7);
  }
}

BOOST_AUTO_TEST_CASE(known_values) {
  // Restitution with Eq. 21's damping and the clamped rule: the printed 0.902 0.718 0.550 0.397 0.253.
  const double targets[] = {0.9, 0.7, 0.5, 0.3, 0.1};
  const double clamped[] = {0.902, 0.718, 0.550, 0.397, 0.253};
  for (int i = 0; i < 5; ++i) {
    const double xi = ref::damping_ratio(targets[i], EndRule::attractive);
    BOOST_TEST(std::abs(ref::restitution(xi, EndRule::clamped) - clamped[i]) < 0.5e-3);
  }
  BOOST_TEST(ref::restitution(1.0, EndRule::clamped) == std::exp(-2.0));
  BOOST_TEST(ref::restitution(1.5, EndRule::attractive) == 0.0);
  // e -> 1/(4 xi^2) for large xi: 2 xi A = 2 ln(2 xi) (1 + O(1/xi^2)) + ...
  BOOST_TEST(std::abs(ref::restitution(1e4, EndRule::clamped) * 4e8 - 1.0) < 1e-6);
  const ref::ImpactEvents elastic = ref::impact_events({4.0, 0.0, 1.0, 3.0}, EndRule::attractive);
  BOOST_TEST(elastic.restitution == 1.0);
  BOOST_TEST(elastic.largest_depth == 1.5);
  BOOST_TEST(std::abs(elastic.largest_force - 6.0) < 1e-14);
}

BOOST_AUTO_TEST_CASE(identity_of_clamped_restitution_and_depth) {
  for (double xi = 0.0; xi < 3.0; xi += 0.037) {
    const ref::ImpactEvents events = ref::impact_events({1.0, 2.0 * xi, 1.0, 1.0}, EndRule::clamped);
    BOOST_TEST(std::abs(events.restitution / (events.largest_depth * events.largest_depth) - 1.0) < 20 * eps);
  }
}

BOOST_AUTO_TEST_CASE(smooth_across_critical_damping) {
  for (const double step : {1e-15, 1e-12, 1e-9, 1e-6}) {
    // A(1 + x) = 1 - x/3 + 2 x^2/15 + ...
    for (const double x : {step, -step}) {
      const double xi = 1.0 + x;
      BOOST_TEST(std::abs(ref::contact_angle(xi) - (1.0 - (xi - 1.0) / 3.0 + 2.0 / 15.0 * x * x)) < 2 * eps);
    }
  }
}

BOOST_AUTO_TEST_CASE(inverse_returns_the_ratio) {
  for (const double e : {1.0, 0.999999, 0.9, 0.5, 0.2, 0.1353352832366127, 0.1, 0.01, 1e-6}) {
    for (const EndRule rule : {EndRule::attractive, EndRule::clamped}) {
      const double xi = ref::damping_ratio(e, rule);
      // de/e = -(d ln e/d xi) d xi; d ln e/d xi is pi/(1 - xi^2)^1.5, up to 100 at e = 1e-6.
      BOOST_TEST(std::abs(ref::restitution(xi, rule) / e - 1.0) < 300 * eps);
    }
  }
  BOOST_TEST(ref::damping_ratio(1.0, EndRule::clamped) == 0.0);
  BOOST_CHECK_THROW((void)ref::damping_ratio(0.0, EndRule::clamped), std::invalid_argument);
  BOOST_CHECK_THROW((void)ref::damping_ratio(1.01, EndRule::attractive), std::invalid_argument);
  BOOST_CHECK_THROW((void)ref::damping_ratio(std::nan(""), EndRule::attractive), std::invalid_argument);
}

BOOST_AUTO_TEST_CASE(eq_21_as_printed) {
  const double logarithm = std::log(2.0);
  const double m1 = 2.0;
  const double m2 = 1.0;
  const double k = 50.0;
  const double printed = 2.0 * logarithm * std::sqrt(k * m1 * m2 / (m1 + m2)) /
                         std::sqrt(std::pow(3.14159265358979323846, 2) + logarithm * logarithm);
  BOOST_TEST(std::abs(ref::eq_21_damping(0.5, k, ref::effective_mass(1.0 / m1, 1.0 / m2)) / printed - 1.0) < 4 * eps);
}

BOOST_AUTO_TEST_CASE(effective_masses) {
  // A rod m l^2/12 hit at its end: 1/m + (l/2)^2 12/(m l^2) = 4/m.
  BOOST_TEST(ref::free_mobility(3.0, 3.0 * 4.0 / 12.0, 1.0) == 4.0 / 3.0);
  // Free, and pivoted with an impact at the centre of percussion of the rod's end: pivot at one end, impact at the
  // other, m_eff = m/3.
  BOOST_TEST(ref::effective_mass(ref::pivoted_mobility(3.0 * 4.0 / 3.0, 2.0), 0.0) == 1.0);
  BOOST_TEST(ref::effective_mass(0.5, 0.5) == 1.0);
  BOOST_CHECK_THROW((void)ref::effective_mass(0.0, 0.0), std::invalid_argument);
  BOOST_CHECK_THROW((void)ref::free_mobility(0.0, 1.0, 0.0), std::invalid_argument);
}

BOOST_AUTO_TEST_SUITE_END()
