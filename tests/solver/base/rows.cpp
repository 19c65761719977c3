#include "solver/base/rows.hpp"

#include <boost/test/unit_test.hpp>
#include <cfenv>
#include <limits>
#include <utility>
#include <vector>

BOOST_AUTO_TEST_SUITE(rows_tests)

using namespace talus;

BOOST_AUTO_TEST_CASE(each_number_is_advanced_and_what_lies_behind_the_last_is_left_alone) {
  for (std::size_t count = 0; count <= 20; ++count) {
    std::vector<double> x(21), rate(21), out(21, -1.0);
    for (std::size_t i = 0; i < x.size(); ++i)
      x[i] = 0.1 * static_cast<double>(i), rate[i] = 1.0 / (1.0 + static_cast<double>(i));
    add_scaled(out.data(), x.data(), 0.3, rate.data(), count);
    for (std::size_t i = 0; i < out.size(); ++i)
      BOOST_TEST(out[i] == (i < count ? x[i] + 0.3 * rate[i] : -1.0));
    std::vector<double> same = x;
    add_scaled(same.data(), same.data(), 0.3, rate.data(), count);
    for (std::size_t i = 0; i < same.size(); ++i)
      BOOST_TEST(same[i] == (i < count ? out[i] : x[i]));
  }
}

BOOST_AUTO_TEST_CASE(a_number_that_is_not_finite_is_found_wherever_it_is) {
  constexpr double nan = std::numeric_limits<double>::quiet_NaN(), inf = std::numeric_limits<double>::infinity();
  for (std::size_t count = 0; count <= 20; ++count) {
    std::vector<double> x(21, 1e308), y(21, -1e-310);
    BOOST_TEST(all_finite(x.data(), y.data(), count));
    for (std::size_t i = 0; i < x.size(); ++i) {
      for (const double bad : {nan, -nan, inf, -inf}) {
        for (std::vector<double>* const row : {&x, &y}) {
          const double kept = std::exchange((*row)[i], bad);
          BOOST_TEST(all_finite(x.data(), y.data(), count) == (i >= count));
          (*row)[i] = kept;
        }
      }
    }
  }
}

BOOST_AUTO_TEST_CASE(finite_numbers_are_finite_however_sums_are_rounded) {
  const std::vector<double> x(21, 1.5), y(21, -1e-310);
  for (const int rounding : {FE_DOWNWARD, FE_UPWARD, FE_TOWARDZERO}) {
    for (std::size_t count = 0; count <= x.size(); ++count) {
      std::fesetround(rounding);
      const bool finite = all_finite(x.data(), y.data(), count);
      std::fesetround(FE_TONEAREST);
      BOOST_TEST(finite);
    }
  }
}

BOOST_AUTO_TEST_SUITE_END()
