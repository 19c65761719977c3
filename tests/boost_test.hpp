#pragma once

// The headers that take most of a test's compilation, compiled once for all tests.
#include <boost/test/unit_test.hpp>
