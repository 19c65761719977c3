#include "verification/record/utf8.hpp"

#include <boost/test/unit_test.hpp>
#include <string>

BOOST_AUTO_TEST_SUITE(utf8_tests)

using namespace talus::records;

BOOST_AUTO_TEST_CASE(control_characters_are_escaped) {
  BOOST_TEST(shown_text("a\x1b[31mred\x7f\b\r\n\tend") == "a\\x1b[31mred\\x7f\\x08\\r\\n\tend");
  BOOST_TEST(shown_text(std::string_view{"\0", 1}) == "\\x00");
  // U+009B as UTF-8, and alone, as in Latin-1.
  BOOST_TEST(shown_text("\xc2\x9b"
                        "31m") == "\\x9b31m");
  BOOST_TEST(shown_text("\x9b"
                        "31m") == "\\x9b31m");
  BOOST_TEST(shown_lines("one\x1b\ntwo\r\n") == "one\\x1b\ntwo\\r\n");
}

BOOST_AUTO_TEST_CASE(other_text_is_unchanged) {
  for (const char* const text :
       {"", "Zaun, 5 \xc2\xb0", "\xc3\xb6 \xe2\x82\xac \xf0\x9f\xaa\xa8", "C:\\x1b \"quoted\""})
    BOOST_TEST(shown_text(text) == text);
  BOOST_TEST(shown_text("B\xf6schung") == "B\xc3\xb6schung");
}

BOOST_AUTO_TEST_SUITE_END()
