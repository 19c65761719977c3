#pragma once

// What most of a test's compilation goes to, compiled once for all tests. BOOST_TEST_MODULE, which each test defines for
// itself, is read by boost/test/unit_test_suite.hpp, which makes main() of it and stays with the tests.
#include <boost/test/framework.hpp>
#include <boost/test/test_tools.hpp>
#include <boost/test/tree/auto_registration.hpp>
#include <boost/test/tree/global_fixture.hpp>
#include <boost/test/tree/test_case_template.hpp>
