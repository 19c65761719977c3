#include "solver/granular/list_skin.hpp"

#include <boost/test/unit_test.hpp>

BOOST_AUTO_TEST_SUITE(list_skin_tests)

using talus::list_skin;

BOOST_AUTO_TEST_CASE(entries_are_those_of_the_nearest_scene) {
  BOOST_TEST(list_skin(1000, 0.3) == 1.0);
  BOOST_TEST(list_skin(1200, 0.38) == 1.0);
  BOOST_TEST(list_skin(1000, 0.75) == 0.7);
  BOOST_TEST(list_skin(100, 0.9) == 0.3);
  // The midpoint between two decades is at 316.
  BOOST_TEST(list_skin(310, 0.84) == 0.4);
  BOOST_TEST(list_skin(330, 0.84) == 0.7);
}

BOOST_AUTO_TEST_CASE(what_lies_outside_takes_the_border) {
  BOOST_TEST(list_skin(1, 0.01) == list_skin(100, 0.3));
  BOOST_TEST(list_skin(0, 0.99) == list_skin(100, 0.9));
  BOOST_TEST(list_skin(10'000'000, 0.01) == list_skin(100'000, 0.3));
}

BOOST_AUTO_TEST_SUITE_END()
