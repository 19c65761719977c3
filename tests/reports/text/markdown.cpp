#include "reports/text/markdown.hpp"

#include <boost/test/unit_test.hpp>
#include <limits>

#include "reports/text/document.hpp"

BOOST_AUTO_TEST_SUITE(markdown_tests)

namespace md = talus::reports::markdown;

BOOST_AUTO_TEST_CASE(marks_are_escaped) {
  BOOST_TEST(md::text("two_cable * [x] <b> h^2 ~ #1") == R"(two\_cable \* \[x\] \<b\> h\^2 \~ \#1)");
  BOOST_TEST(md::text("costs $5") == R"(costs \$5)");
  BOOST_TEST(md::text("- a\nb...") == R"(\- a b\.\..)");
}

BOOST_AUTO_TEST_CASE(maths_and_code_are_kept) {
  BOOST_TEST(md::text("error $C_1 h^2$ by `a_b`_c") == R"(error $C_1 h^2$ by `a_b`\_c)");
  BOOST_TEST(md::cell("$|x|$ | y") == R"($\vert x\vert $ \| y)");
  BOOST_TEST(md::text("$5 and $6") == R"(\$5 and \$6)");
}

BOOST_AUTO_TEST_CASE(headings_move_together_outside_code) {
  BOOST_TEST(md::with_headings_below("# A\n```\n# no\n```\n## B\n", 2) == "## A\n```\n# no\n```\n### B\n");
  BOOST_TEST(md::with_headings_below("#no heading\n", 2) == "#no heading\n");
}

BOOST_AUTO_TEST_CASE(heading_ids_follow_github) {
  BOOST_TEST(md::heading_id("two_cable: Two-cable impact, Eq. 21") == "two_cable-two-cable-impact-eq-21");
}

BOOST_AUTO_TEST_CASE(digits_show_the_difference) {
  BOOST_TEST(md::number(2.0000013, md::digits_to_tell(2.0000013, 2.0)) == "2.0000013");
  BOOST_TEST(md::number(2.0, md::digits_to_tell(2.0, 2.0)) == "2");
  BOOST_TEST(md::number(std::numeric_limits<double>::quiet_NaN(), 3) == "nan");
  BOOST_TEST(md::digits_to_tell(std::numeric_limits<double>::infinity(), 1.0) == 5);
}

BOOST_AUTO_TEST_CASE(a_table_has_a_cell_for_each_column) {
  BOOST_TEST(md::table({{"a"}, {"b", true}}, {{"x", ""}}, "") == "| a | b |\n|:----|----:|\n| x | – |\n");
}

BOOST_AUTO_TEST_CASE(letters_without_a_sign_become_their_number) {
  const std::string header = "\\DeclareUnicodeCharacter{03BC}{x}";
  BOOST_TEST(talus::reports::printable("é μ 漢 \xFF", header) == "é μ U+6F22 ?");
}

BOOST_AUTO_TEST_SUITE_END()
