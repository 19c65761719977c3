#pragma once

// The headers that take most of a test's compilation, compiled once for all tests. BOOST_TEST_MODULE, which each test
// defines, is read by boost/test/unit_test_suite.hpp, which defines main() and is therefore included by the tests.
#include <boost/test/framework.hpp>
#include <boost/test/test_tools.hpp>
#include <boost/test/tree/auto_registration.hpp>
#include <boost/test/tree/global_fixture.hpp>
#include <boost/test/tree/test_case_template.hpp>
