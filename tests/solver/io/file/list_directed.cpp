#include "solver/io/file/list_directed.hpp"

#include <boost/test/unit_test.hpp>
#include <string>
#include <vector>

#include "solver/base/error.hpp"

BOOST_AUTO_TEST_SUITE(list_directed_tests)

// Expected values follow from the rules of list-directed input in the Fortran 77 standard (ANSI X3.9-1978, 13.6).

using namespace talus;

namespace {

using Values = std::vector<std::string>;

/// One record of `count` values.
Values record(ListDirected& input, int count) {
  input.start_record();
  Values values;
  for (int i = 0; i < count; ++i)
    values.emplace_back(input.value());
  return values;
}

Values record(std::string_view text, int count) {
  ListDirected input{text};
  return record(input, count);
}

std::string message(std::string_view text, int count) {
  try {
    static_cast<void>(record(text, count));
  } catch (const InputError& error) {
    return error.what();
  }
  return "no error";
}

}  // namespace

BOOST_AUTO_TEST_CASE(separators) {
  const Values expected{"1", "-2.5", "3e4"};
  for (const char* text : {"1 -2.5 3e4", "1,-2.5,3e4", "  1 , -2.5\t,\t3e4 comment", "1\n-2.5\n\n 3e4",
                           "1,\n-2.5\n,3e4", "\n\n1 -2.5\r\n3e4\r\n", "1 -2.5 3e4/", "1 -2.5 3e4,,"}) {
    BOOST_TEST(record(text, 3) == expected, boost::test_tools::per_element());
  }
}

BOOST_AUTO_TEST_CASE(records_start_on_new_lines_and_drop_the_rest) {
  ListDirected input{"a title, as written\r\n1 2 dropped\n3\n4 dropped 5\n\n6"};
  BOOST_TEST(input.whole_line() == "a title, as written");
  BOOST_TEST((record(input, 1) == Values{"1"}));
  BOOST_TEST(input.line() == 2);
  BOOST_TEST((record(input, 2) == Values{"3", "4"}));
  BOOST_TEST(input.line() == 4);
  BOOST_TEST(record(input, 0).empty());
  BOOST_TEST(input.line() == 5);
  BOOST_TEST((record(input, 1) == Values{"6"}));
}

BOOST_AUTO_TEST_CASE(repeats) {
  BOOST_TEST((record("3*0.5 1*2,2*7", 6) == Values{"0.5", "0.5", "0.5", "2", "7", "7"}));
  ListDirected input{"5*1\n2"};
  BOOST_TEST((record(input, 2) == Values{"1", "1"}));
  BOOST_TEST((record(input, 1) == Values{"2"}));
}

BOOST_AUTO_TEST_CASE(missing_values) {
  BOOST_TEST(message("1 2", 3) == "the file ends here; a value is missing");
  BOOST_TEST(message("", 1) == "the file ends here; a value is missing");
  const std::string null = "found a comma where a value is due (a null value); write the value";
  for (const char* text : {"1,,2", ",1 2", "1, ,2", "1,\n,2"})
    BOOST_TEST(message(text, 2) == null);
  BOOST_TEST(message("1 / 2", 2) == "found \"/\", which ends the record; a value is missing");
  for (const char* repeat : {"2*", "0*1", "99999999999999999999*1"}) {
    BOOST_TEST(message(repeat, 1) == "found \"" + std::string{repeat} + "\"; a repeat is written r*value with r > 0");
  }
  ListDirected empty{""};
  BOOST_CHECK_THROW(static_cast<void>(empty.whole_line()), InputError);
}

BOOST_AUTO_TEST_SUITE_END()
