#define BOOST_TEST_MODULE message_form
#include <boost/test/unit_test.hpp>

#include "tests/messages/message_form.hpp"

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
}

BOOST_AUTO_TEST_CASE(what_changes_from_run_to_run_is_left_out) {
  BOOST_TEST(lasting("/tmp/talus_faults_1234/out/state.json: found 3 m/s") == "state.json: found 3 m/s");
  BOOST_TEST(lasting("talus_faults_1234: process 77") == "talus_faults: process 1234");
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
