#include "tests/mutants/schemata.hpp"

#include <boost/test/unit_test.hpp>
#include <stdexcept>

BOOST_AUTO_TEST_SUITE(schemata_tests)

namespace {

using talus::mutants::Edit;
using talus::mutants::Form;
using talus::mutants::switch_at;
using talus::mutants::Switched;
using talus::mutants::with_switches;

/// The edit that replaces the first `old` of a text.
Switched edit(const std::string& text, const std::string& old, const std::string& replacement, int number,
              Form form = Form::expression) {
  const std::size_t at = text.find(old);
  return {Edit{"file.hpp", at, at + old.size(), form, replacement}, number};
}

}  // namespace

BOOST_AUTO_TEST_CASE(a_text_without_edits_stays) { BOOST_TEST(with_switches("x = a;\n", {}) == "x = a;\n"); }

BOOST_AUTO_TEST_CASE(an_expression_becomes_a_choice) {
  const std::string text = "x = a + b;";
  const std::vector<Switched> edits{edit(text, "a + b", "a - b", 7)};
  BOOST_TEST(with_switches(text, edits) == "x = (talus::mutants::on(7) ? (a - b) : (a + b));");
}

BOOST_AUTO_TEST_CASE(a_statement_becomes_a_branch) {
  const std::string text = "if (c) y = 1; else y = 2;";
  const std::vector<Switched> edits{edit(text, "y = 1;", "", 3, Form::statement)};
  BOOST_TEST(with_switches(text, edits) == "if (c) { if (talus::mutants::on(3)) {  } else { y = 1; } } else y = 2;");
}

BOOST_AUTO_TEST_CASE(one_place_may_have_several) {
  const std::string text = "x = a * b;";
  const std::vector<Switched> edits{edit(text, "a * b", "b", 2), edit(text, "a * b", "a", 1)};
  BOOST_TEST(with_switches(text, edits) ==
             "x = (talus::mutants::on(1) ? (a) : talus::mutants::on(2) ? (b) : (a * b));");
}

BOOST_AUTO_TEST_CASE(inner_edits_are_in_what_stays_only) {
  const std::string text = "x = (a + b) * c;";
  const std::vector<Switched> edits{edit(text, "a + b", "a", 2), edit(text, "(a + b) * c", "(a + b)", 1)};
  BOOST_TEST(with_switches(text, edits) ==
             "x = (talus::mutants::on(1) ? ((a + b)) : (((talus::mutants::on(2) ? (a) : (a + b))) * c));");
}

BOOST_AUTO_TEST_CASE(what_comes_first_does_not_depend_on_the_list) {
  const std::string text = "f(a, b) + g(c);";
  const std::vector<Switched> forward{edit(text, "a", "x", 1), edit(text, "b", "y", 2), edit(text, "g(c)", "c", 3)};
  const std::vector<Switched> backward(forward.rbegin(), forward.rend());
  BOOST_TEST(with_switches(text, forward) == with_switches(text, backward));
}

BOOST_AUTO_TEST_CASE(edits_that_cross_are_refused) {
  const std::string text = "a + b + c";
  const std::vector<Switched> edits{edit(text, "a + b", "a", 1), edit(text, "b + c", "b", 2)};
  BOOST_CHECK_THROW(static_cast<void>(with_switches(text, edits)), std::invalid_argument);
}

BOOST_AUTO_TEST_CASE(an_error_is_traced_to_the_switch_before_it) {
  const std::string text = "x = a + b;\ny = c + d + e;\n";
  const std::vector<Switched> edits{edit(text, "a + b", "a", 1), edit(text, "c + d + e", "c", 20),
                                    edit(text, "c + d", "d", 3)};
  const std::string with = with_switches(text, edits);
  const std::size_t second = with.find('\n') + 1;
  BOOST_TEST(switch_at(with, 1, with.find(" ? ") + 2) == 1);
  BOOST_TEST(switch_at(with, 2, with.find("20) ?") - second + 5) == 20);
  BOOST_TEST(switch_at(with, 2, with.find("3) ?") - second + 4) == 3);
  BOOST_TEST(switch_at(with, 2, 1) == 0);
}

BOOST_AUTO_TEST_SUITE_END()
