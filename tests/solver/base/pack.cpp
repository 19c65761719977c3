#include "solver/base/pack.hpp"

#include <array>
#include <boost/test/unit_test.hpp>
#include <cmath>
#include <limits>

BOOST_AUTO_TEST_SUITE(pack_tests)

using namespace talus;

BOOST_AUTO_TEST_CASE(a_row_that_ends_within_a_pack_is_left_alone_behind_its_end) {
  for (std::size_t left = 1; left <= pack_size + 1; ++left) {
    std::array<double, 10> row{1, 2, 3, 4, 5, 6, 7, 8, 9, 10}, out{};
    Pack pack;
    load(pack, row.data(), left);
    store(pack, out.data(), left);
    for (std::size_t i = 0; i < out.size(); ++i)
      BOOST_TEST(out[i] == (i < std::min(left, pack_size) ? row[i] : 0.0));
    for (std::size_t lane = left; lane < pack_size; ++lane)
      BOOST_TEST(static_cast<double>(pack[lane]) == 0.0);
  }
}

BOOST_AUTO_TEST_CASE(the_largest_size_of_all_lanes) {
  constexpr double nan = std::numeric_limits<double>::quiet_NaN(), inf = std::numeric_limits<double>::infinity();
  const auto of = [](double special, std::size_t lane) {
    Pack pack{0.5, -1.5, -0.0, 1.25};
    pack[lane] = special;
    Sizes maximum{};
    raise(maximum, Pack{} + 0.25);
    raise(maximum, pack);
    raise(maximum, Pack{} - 0.125);
    return largest(maximum);
  };
  for (std::size_t lane = 0; lane < pack_size; ++lane) {
    BOOST_TEST(of(-7.0, lane) == 7.0);
    BOOST_TEST(of(-inf, lane) == inf);
    BOOST_TEST(std::isnan(of(nan, lane)));
    BOOST_TEST(std::isnan(of(-nan, lane)));
    BOOST_TEST(of(0.0, lane) == (lane == 1 ? 1.25 : 1.5));
  }
}

BOOST_AUTO_TEST_CASE(whether_a_lane_is_true_or_a_bit_is_set) {
  BOOST_TEST(!any_bit(Sizes{}));
  for (std::size_t lane = 0; lane < pack_size; ++lane) {
    Sizes is{};
    is[lane] = -1;
    BOOST_TEST(bits_of(is) == std::size_t{1} << lane);
    BOOST_TEST(bits_of(~is) == 15U - (std::size_t{1} << lane));
    for (const int bit : {0, 31, 63}) {
      is[lane] = static_cast<std::int64_t>(std::uint64_t{1} << bit);
      BOOST_TEST(any_bit(is));
    }
  }
}

BOOST_AUTO_TEST_SUITE_END()
