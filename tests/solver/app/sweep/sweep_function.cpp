#include "solver/app/sweep/sweep_function.hpp"

#include <array>
#include <boost/test/unit_test.hpp>

#include "tests/solver/server/ball_sweep.hpp"

BOOST_AUTO_TEST_SUITE(sweep_function_tests)

using namespace talus::app;

// An enumeration would take long at each start, and would refuse this design, of which no run satisfies the constraint.
BOOST_AUTO_TEST_CASE(a_function_does_not_enumerate_the_design) {
  const Folder folder;
  const SweepFunction function{
      write_ball_sweep(folder, "[[constraint]]\nfield = \"body.ball.velocity[0]\"\nat_least = \"6 m/s\"\n")};
  const auto end = [&](double speed) { return function(std::array{speed, 100.0}, [] { return false; }).end; };
  BOOST_TEST((end(7.0) == SweepEnd::finished));
  BOOST_TEST((end(5.0) == SweepEnd::refused));
}

BOOST_AUTO_TEST_SUITE_END()
