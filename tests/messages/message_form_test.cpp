#include <boost/test/unit_test.hpp>

#include <sstream>

#include "tests/messages/message_form.hpp"

BOOST_AUTO_TEST_SUITE(message_form_tests)

using namespace talus::messages;

BOOST_AUTO_TEST_CASE(a_form_has_no_place_and_no_values) {
  BOOST_TEST(form_of("s.toml:7: body 'rock': mass: found \"-3 kg\"; it must be > 0") ==
             "found \"...\"; it must be > N");
  BOOST_TEST(form_of("/tmp/a/s.toml:7: contact 'c': stiffness: found 1e-5; it must be at least 2.5: why: so") ==
             "found N; it must be at least N: why: so");
  BOOST_TEST(form_of("--law: law 'hertzz' is not known; nearest: hertz; known: hertz, latching_spring") ==
             "law '...' is not known; nearest: ...; known: ...");
  BOOST_TEST(form_of("s.toml:8: not TOML: Error while parsing: x") == "not TOML: ...");
  BOOST_TEST(form_of("out; a/plot.json: No such file or directory") == "No such file or directory");
  BOOST_TEST(form_of("K1 is not K2") == "K1 is not K2");
  BOOST_TEST(form_of("s.vtp:2: not XML: Start-end tags mismatch") == "not XML: ...");
  BOOST_TEST(form_of("plot.json: it is not a file written by `talus run --out`: [json.exception.101] x") ==
             "it is not a file written by `talus run --out`: ...");
}

BOOST_AUTO_TEST_CASE(digits_of_words_formulas_and_years_are_no_numbers) {
  BOOST_TEST(form_of("found the character 0x0a; a title is UTF-8 or Latin-1") ==
             "found the character N; a title is UTF-8 or Latin-1");
  BOOST_TEST(form_of("found 4a265652f405e506, but scene.toml has 0509baf4a6043364; it must be as it was") ==
             "found N, but scene.toml has N; it must be as it was");
  BOOST_TEST(form_of("it must be .DAT (a deck of 1993) or .toml") == "it must be .DAT (a deck of 1993) or .toml");
  BOOST_TEST(form_of("overlaps are proportional to 1/sqrt(k), K1/K2 = 0.45") ==
             "overlaps are proportional to 1/sqrt(k), K1/K2 = N");
  BOOST_TEST(form_of("found 2, 2; each must be in (0, 1]. At most 1,001 rows of -1.5e-07 m.") ==
             "found N, N; each must be in (N, N]. At most N rows of N m.");
}

BOOST_AUTO_TEST_CASE(what_changes_from_run_to_run_is_left_out) {
  BOOST_TEST(lasting("/tmp/talus_faults_1234/out/state.json: found 3 m/s") == "state.json: found 3 m/s");
  BOOST_TEST(lasting("talus_faults_1234: process 77") == "talus_faults: process 1234");
  BOOST_TEST(lasting("talus_test_3xsl7G: is a folder") == "talus_test: is a folder");
  BOOST_TEST(lasting("run 2c6cd4bfa8263b65 of 9007199254740994") == "run 0123456789abcdef of 9007199254740994");
}

BOOST_AUTO_TEST_CASE(the_shortest_message_is_the_example) {
  const auto forms = forms_of({"input\tone\tlong.toml:7: mass: found 30; it must be > 0\x1f"
                               "a.toml: b: it is missing",
                               "input\ttwo\ts.toml:7: mass: found 3; it must be > 0", "file\ttwo\tx: Is a directory",
                               "input\tfuzz\tnothing of a user"},
                              {"fuzz"});
  BOOST_REQUIRE(forms.size() == 3U);
  BOOST_TEST(forms[0].kind == "file");
  BOOST_TEST(forms[0].text == "Is a directory");
  BOOST_TEST(forms[1].text == "found N; it must be > N");
  BOOST_TEST(forms[1].example == "s.toml:7: mass: found 3; it must be > 0");
  BOOST_TEST(forms[2].example == "a.toml: b: it is missing");
  BOOST_CHECK_THROW(static_cast<void>(forms_of({"no tabs"}, {})), std::runtime_error);
}

BOOST_AUTO_TEST_CASE(texts_of_other_programs_and_hints_at_the_help_are_no_messages) {
  const auto forms = forms_of({"file\tone\tgnuplot failed on figure x (exit status 3):\x1ftalus: no terminal",
                               "input\tone\tSCENE is required\x1fhelp: talus run --help"},
                              {});
  BOOST_REQUIRE(forms.size() == 2U);
  BOOST_TEST(forms[0].text == "gnuplot failed on figure x (exit status N):");
  BOOST_TEST(forms[1].text == "SCENE is required");
}

BOOST_AUTO_TEST_CASE(each_message_names_a_cure_or_has_one_in_the_list) {
  const auto forms =
      forms_of({"input\tone\ta.toml:1: mass: found 3; it must be < 0", "input\tone\tneither can move"}, {});
  const auto cures = [](const char* text) {
    std::istringstream in{text};
    return read_cures(in);
  };
  BOOST_TEST(names_cure("found N; it must be < N"));
  BOOST_TEST(!names_cure("a name that can move"));
  BOOST_TEST(cure_errors(forms, cures("# why\nneither can move\n    free one\n    of the two\n")).empty());
  BOOST_TEST(cure_of(forms.back(), cures("neither can move\n    free one\n    of the two\n")) == "free one of the two");
  BOOST_TEST(cure_errors(forms, {}) ==
                 std::vector<std::string>{"the message names no cure, and cures.txt has none: neither can move"},
             boost::test_tools::per_element());
  BOOST_TEST(cure_errors(forms, cures("neither can move\n    free one\ngone\n    x\n")) ==
                 std::vector<std::string>{"no message has the form: gone"},
             boost::test_tools::per_element());
  BOOST_TEST(cure_errors(forms, cures("neither can move\n")).size() == 2U);
  BOOST_CHECK_THROW(cures("    free one\n"), std::runtime_error);
}

BOOST_AUTO_TEST_SUITE_END()
