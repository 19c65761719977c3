#include "solver/app/sweep/run_limits.hpp"

#include <boost/test/unit_test.hpp>
#include <chrono>

BOOST_AUTO_TEST_SUITE(run_limits_tests)

using namespace talus;
using namespace talus::app;

// By a clock of the test: the time since the limits were made, read at each third call.
BOOST_AUTO_TEST_CASE(a_limit_of_time_counts_seconds_of_the_clock) {
  RunLimits::Clock::time_point now{std::chrono::hours{5}};
  RunLimits limits{{.time = 2.0, .evaluations = 0}, [] { return false; }, 3, [&now] { return now; }};
  const auto reached = [&] {
    bool last = false;
    for (int call = 0; call < 3; ++call)
      last = limits.reached(1);
    return last;
  };
  BOOST_TEST(!reached());
  now += std::chrono::milliseconds{1999};
  BOOST_TEST(!reached());
  now += std::chrono::milliseconds{2};
  BOOST_TEST(!limits.reached(1));
  BOOST_TEST(!limits.reached(1));
  BOOST_TEST(limits.reached(1));
  BOOST_TEST(limits.reason() == "limit of 2 s");
  BOOST_TEST(!limits.is_interrupted());
}

BOOST_AUTO_TEST_SUITE_END()
