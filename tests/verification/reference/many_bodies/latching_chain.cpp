#include "verification/reference/many_bodies/latching_chain.hpp"

#include <array>
#include <boost/test/unit_test.hpp>
#include <cmath>
#include <numeric>
#include <stdexcept>

#include "verification/reference/impacts/latching_impact.hpp"
#include "verification/reference/many_bodies/struck_row.hpp"

BOOST_AUTO_TEST_SUITE(latching_chain_tests)

namespace ref = talus::verification::reference;

namespace {

double momentum(const std::vector<double>& v) { return std::accumulate(v.begin(), v.end(), 0.0); }
double energy(const std::vector<double>& v) { return 0.5 * std::inner_product(v.begin(), v.end(), v.begin(), 0.0); }

/// A pair whose first disc is struck again, by a third disc, before the second has separated from it.
const ref::LatchingChain restruck{1.0, 1.0 / 0.49, 1.0, {3.0, 1.0, 0.0}, {3.5, 0.0}};

}  // namespace

BOOST_AUTO_TEST_CASE(two_discs_rebound_as_the_closed_form_says) {
  for (const double ratio : {1.0, 0.49, 0.25}) {
    const ref::ChainRebound found = ref::chain_rebound(ref::struck_chain(2, ratio, 3.0, 7.0, 0.6));
    const ref::LatchingEvents exact = ref::latching_events({7.0, 7.0 / ratio, 0.0, 1.5, 0.6});
    BOOST_TEST(std::abs(found.velocity[0] - 0.3 * (1.0 - exact.restitution)) < 1e-15);
    BOOST_TEST(std::abs(found.velocity[1] - 0.3 * (1.0 + exact.restitution)) < 1e-15);
    BOOST_TEST(std::abs(found.end_time - exact.contact_time) < 1e-14);
    BOOST_TEST(std::abs(found.largest[0] - exact.largest_depth) < 1e-15);
    BOOST_TEST(found.reloads == 0);
  }
}

BOOST_AUTO_TEST_CASE(without_a_latch_it_is_the_row_in_50_digits) {
  const ref::RowRebound exact = ref::rebound({2.0, 3.0, 1.5, 0.0});
  const ref::ChainRebound found = ref::chain_rebound(ref::struck_chain(3, 1.0, 2.0, 3.0, 1.5));
  for (std::size_t i = 0; i < 3; ++i)
    BOOST_TEST(std::abs(found.velocity[i] - exact.velocity[i]) < 1e-15);
  BOOST_TEST(std::abs(found.end_time - exact.end_time) < 1e-14);
}

BOOST_AUTO_TEST_CASE(momentum_is_kept_and_energy_where_the_latches_keep_it) {
  for (std::size_t count = 2; count <= 7; ++count) {
    for (const double ratio : {0.9, 0.49, 0.25}) {
      const ref::ChainRebound found = ref::chain_rebound(ref::struck_chain(count, ratio, 1.0, 1.0, 1.0));
      BOOST_TEST(std::abs(momentum(found.velocity) - 1.0) < 2e-15);
      BOOST_TEST(std::abs(energy(found.velocity) + found.kept - 0.5) < 2e-15);
      for (std::size_t i = 1; i < count; ++i)
        BOOST_TEST(found.velocity[i - 1] <= found.velocity[i]);
    }
  }
  const ref::ChainRebound again = ref::chain_rebound(restruck);
  BOOST_TEST(again.reloads_from_slack == 1);
  BOOST_TEST(std::abs(momentum(again.velocity) - 4.0) < 4e-15);
  BOOST_TEST(std::abs(energy(again.velocity) + again.kept - 5.0) < 8e-15);
}

BOOST_AUTO_TEST_CASE(chains_of_three_and_four_end_as_another_program_found) {
  // Computed by another program with a leapfrog and decreasing steps, to five digits.
  const std::array<double, 3> three{0.06106, 0.20237, 0.73657};
  const std::array<double, 4> four{0.06047, 0.08188, 0.21149, 0.64616};
  const ref::ChainRebound a = ref::chain_rebound(ref::struck_chain(3, 0.49, 1.0, 1.0, 1.0));
  const ref::ChainRebound b = ref::chain_rebound(ref::struck_chain(4, 0.49, 1.0, 1.0, 1.0));
  for (std::size_t i = 0; i < 3; ++i)
    BOOST_TEST(std::abs(a.velocity[i] - three[i]) < 1e-5);
  for (std::size_t i = 0; i < 4; ++i)
    BOOST_TEST(std::abs(b.velocity[i] - four[i]) < 1e-5);
}

BOOST_AUTO_TEST_CASE(velocities_in_between) {
  const ref::LatchingChain pair = ref::struck_chain(2, 0.49, 2.0, 1.0, 1.0);
  const std::array<double, 4> times{0.0, 0.9, 1.9, 8.0};
  const auto found = ref::chain_velocities(pair, times);
  for (std::size_t i = 0; i < times.size(); ++i) {
    const ref::DepthState exact = ref::latching_depth_at({1.0, 1.0 / 0.49, 0.0, 1.0, 1.0}, times[i]);
    BOOST_TEST(std::abs(found[i][0] - found[i][1] - exact.rate) < 1e-14);
  }
}

BOOST_AUTO_TEST_CASE(bad_parameters) {
  BOOST_CHECK_THROW((void)ref::chain_rebound({2.0, 1.0, 1.0, {1.0, 0.0}, {0.0}}), std::invalid_argument);
  BOOST_CHECK_THROW((void)ref::chain_rebound({1.0, 2.0, 1.0, {1.0, 0.0}, {0.0, 0.0}}), std::invalid_argument);
  BOOST_CHECK_THROW((void)ref::chain_rebound({1.0, 2.0, 1.0, {1.0, 0.0}, {-1.0}}), std::invalid_argument);
}

BOOST_AUTO_TEST_SUITE_END()
