// The function main() of each test program.
#define BOOST_TEST_MODULE talus
#include <boost/test/unit_test.hpp>
