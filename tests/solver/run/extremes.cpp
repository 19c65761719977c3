#include "solver/run/extremes.hpp"

#include <boost/test/unit_test.hpp>
#include <cmath>
#include <limits>

BOOST_AUTO_TEST_SUITE(extremes_tests)

using namespace talus;

namespace {

/// Value i at a step: every third number repeats its values, and some are NaN.
double value(int step, std::size_t i) {
  if (step > 0 && (step + static_cast<int>(i)) % 11 == 0) return std::numeric_limits<double>::quiet_NaN();
  return std::sin(1.3 * (i % 3 == 0 ? step % 5 : step) + static_cast<double>(i));
}

}  // namespace

// Any number of quantities and of times, also if the extremes are read or saved between two blocks of rows.
BOOST_AUTO_TEST_CASE(extremes_are_those_of_each_quantity_alone_at_any_time) {
  for (std::size_t count = 1; count <= 13; ++count) {
    Extremes found;
    std::vector<Extreme> alone(count);
    for (int step = 0; step < 60; ++step) {
      const double time = 0.5 + 0.1 * step;
      std::vector<double> values;
      for (std::size_t i = 0; i < count; ++i) {
        const double x = values.emplace_back(value(step, i));
        Extreme& extreme = alone[i];
        if (step == 0) extreme = {x, time, x, time};
        if (x < extreme.minimum) extreme.minimum = x, extreme.minimum_time = time;
        if (x > extreme.maximum) extreme.maximum = x, extreme.maximum_time = time;
      }
      found.add(time, values);
      if (step % 13 == 5) {
        Archive saved;
        found.serialize(saved, count);
        Archive restored{saved.items()};
        found = Extremes();
        found.serialize(restored, count);
      }
      BOOST_TEST(found.size() == count);
      for (std::size_t i = 0; i < count; ++i) {
        BOOST_TEST(found[i].minimum == alone[i].minimum);
        BOOST_TEST(found[i].minimum_time == alone[i].minimum_time);
        BOOST_TEST(found[i].maximum == alone[i].maximum);
        BOOST_TEST(found[i].maximum_time == alone[i].maximum_time);
      }
    }
  }
}

BOOST_AUTO_TEST_SUITE_END()
