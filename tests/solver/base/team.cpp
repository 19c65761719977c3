#define BOOST_TEST_MODULE team
#include "solver/base/team.hpp"

#include <boost/test/unit_test.hpp>
#include <numeric>
#include <stdexcept>
#include <string>
#include <vector>

using talus::Team;

BOOST_AUTO_TEST_CASE(each_part_is_done_once_and_before_the_next_work_begins) {
  for (const std::size_t size : {1U, 2U, 3U, 7U}) {
    Team team{size};
    std::vector<long> done(size);
    bool together = true;
    for (long call = 1; call <= 2000; ++call) {
      team.each([&](std::size_t k) { ++done[k]; });
      together = together && std::accumulate(done.begin(), done.end(), 0L) == call * static_cast<long>(size);
    }
    BOOST_TEST(together);
    BOOST_TEST(done == std::vector<long>(size, 2000), boost::test_tools::per_element());
  }
}

BOOST_AUTO_TEST_CASE(what_a_part_throws_reaches_the_caller_and_the_team_goes_on) {
  Team team{3};
  for (const std::size_t thrower : {0U, 2U}) {
    std::string caught;
    try {
      team.each([&](std::size_t k) {
        if (k >= thrower) throw std::runtime_error{"part " + std::to_string(k)};
      });
    } catch (const std::runtime_error& error) {
      caught = error.what();
    }
    BOOST_TEST(caught == "part " + std::to_string(thrower));
    int done = 0;
    team.each([&](std::size_t k) {
      if (k == 1) ++done;
    });
    BOOST_TEST(done == 1);
  }
}
