#include "verification/record/json_node.hpp"

#include <cmath>
#include <functional>
#include <limits>
#include <stdexcept>

#include "tests/verification/record/error_message.hpp"
#include "verification/record/json_fault.hpp"
#include "verification/record/json_number.hpp"

BOOST_AUTO_TEST_SUITE(json_node_tests)

using namespace talus::records;

namespace {

/// Error message of `read` for the member "x" of an object with this value.
std::string refused(const std::string& value, const std::function<void(const Node&)>& read) {
  const Json json = Json::parse("{\"x\": " + value + "}");
  return error_message([&] { read(Node{json, "a.json: all"}.at("x")); });
}

}  // namespace

BOOST_AUTO_TEST_CASE(numbers_that_are_not_finite_have_names) {
  using Limits = std::numeric_limits<double>;
  for (const double value : {Limits::infinity(), -Limits::infinity(), 0.1, -0.0, 5e-324}) {
    const Json written = Json::parse(json_number(value).dump());
    BOOST_TEST(*number_of(written) == value);
    BOOST_TEST(written.is_string() == std::isinf(value));
  }
  BOOST_TEST(json_number(Limits::quiet_NaN()) == "nan");
  BOOST_TEST(json_number(-Limits::quiet_NaN()) == "nan");
  BOOST_TEST(std::isnan(*number_of(json_number(Limits::quiet_NaN()))));
  for (const Json& other : {Json("NaN"), Json("infinity"), Json("1"), Json(nullptr), Json(true), Json::array({1})})
    BOOST_TEST(!number_of(other).has_value(), other);
}

BOOST_AUTO_TEST_CASE(values_are_read) {
  const Json json = Json::parse(
      R"({"t": "text", "n": 0.5, "i": -3, "c": 7, "f": true, "z": null, "l": ["a", "b"], "o": {"q": "1", "b": "2"}})");
  const Node node{json, "a.json: all"};
  BOOST_TEST(node.at("t").text() == "text");
  BOOST_TEST(node.at("t").nonempty_text() == "text");
  BOOST_TEST(node.at("t").one_of({"word", "text"}) == "text");
  BOOST_TEST(node.at("t").file_name() == "text");
  BOOST_TEST(node.at("t").file_name(4) == "text");
  const Json longest{{"x", std::string(200, 'a')}};
  BOOST_TEST((Node{longest, "a.json: all"}.at("x").file_name()) == std::string(200, 'a'));
  BOOST_TEST(node.at("n").finite() == 0.5);
  BOOST_TEST(node.at("i").integer() == -3);
  BOOST_TEST(node.at("i").number() == -3.0);
  BOOST_TEST(node.at("c").count() == 7u);
  BOOST_TEST(node.at("f").flag());
  BOOST_TEST(node.at("l").texts() == std::vector<std::string>({"a", "b"}));
  BOOST_TEST(!node.has("z"));
  BOOST_TEST(node.is_null("z"));
  BOOST_TEST(!node.has("none"));
  BOOST_TEST(!node.is_null("none"));
  const auto members = node.at("o").members();  // in the order of the file
  BOOST_TEST(members[0].first == "q");
  BOOST_TEST(members[1].second.text() == "2");
}

BOOST_AUTO_TEST_CASE(errors_name_file_path_what_was_found_and_what_is_allowed) {
  const auto text = [](const Node& node) { (void)node.text(); };
  const auto nonempty_text = [](const Node& node) { (void)node.nonempty_text(); };
  const auto one_of = [](const Node& node) { (void)node.one_of({"pass", "fail"}); };
  const auto name = [](const Node& node) { (void)node.file_name(); };
  const auto number = [](const Node& node) { (void)node.number(); };
  const auto finite = [](const Node& node) { (void)node.finite(); };
  const auto integer = [](const Node& node) { (void)node.integer(); };
  const auto count = [](const Node& node) { (void)node.count(); };
  const auto flag = [](const Node& node) { (void)node.flag(); };
  const auto list = [](const Node& node) { (void)node.list(); };
  const auto members = [](const Node& node) { (void)node.members(); };
  BOOST_TEST(refused("3", text) == "a.json: all.x: must be a text, found 3");
  BOOST_TEST(refused("\" \"", nonempty_text) == "a.json: all.x: must be a text that is not empty, found \" \"");
  BOOST_TEST(refused("\"red\"", one_of) == "a.json: all.x: must be one of pass, fail, found \"red\"");
  BOOST_TEST(refused("[]", one_of) == "a.json: all.x: must be one of pass, fail, found []");
  BOOST_TEST(refused("\"../a\"", name) == "a.json: all.x: must be a plain file name, found \"../a\"");
  BOOST_TEST(refused("\".a\"", name) == "a.json: all.x: must be a plain file name, found \".a\"");
  BOOST_TEST(refused("\"a\\u0000b\"", name) == "a.json: all.x: must be a plain file name, found \"a\\u0000b\"");
  BOOST_TEST(refused("\"a\x7f\"", name) == "a.json: all.x: must be a plain file name, found \"a\x7f\"");
  BOOST_TEST(refused("\"text\"", [](const Node& node) { (void)node.file_name(3); }) ==
             "a.json: all.x: must be a file name of at most 3 bytes, found \"text\"");
  BOOST_TEST(refused('"' + std::string(201, 'a') + '"', name) ==
             "a.json: all.x: must be a file name of at most 200 bytes, found \"" + std::string(56, 'a') + "...");
  BOOST_TEST(refused("\"1\"", number) == "a.json: all.x: must be a number, found \"1\"");
  BOOST_TEST(refused("\"nan\"", finite) == "a.json: all.x: must be a finite number, found \"nan\"");
  BOOST_TEST(refused("1.5", integer) == "a.json: all.x: must be a whole number, found 1.5");
  BOOST_TEST(holds(refused("3000000000", integer), "must be a whole number from -2147483648 to 2147483647"));
  BOOST_TEST(refused("-1", count) == "a.json: all.x: must be a whole number >= 0, found -1");
  BOOST_TEST(refused("0", flag) == "a.json: all.x: must be true or false, found 0");
  BOOST_TEST(refused("{}", list) == "a.json: all.x: must be a list, found {}");
  BOOST_TEST(refused("[]", members) == "a.json: all.x: must be an object, found []");
  BOOST_TEST(refused("null", text) == "a.json: all.x: is null");
  BOOST_TEST(refused("[1, [2]]", [&](const Node& node) { text(node.list()[1].list()[0]); }) ==
             "a.json: all.x[1][0]: must be a text, found 2");
  BOOST_TEST(refused("{}", [&](const Node& node) { text(node.at("y")); }) == "a.json: all.x.y: is missing");
  BOOST_TEST(refused("3", [](const Node& node) { (void)node.has("y"); }) ==
             "a.json: all.x: must be an object, found 3");
  BOOST_TEST(refused("3", [](const Node& node) { node.fail("is odd"); }) == "a.json: all.x: is odd");
  BOOST_TEST(refused("3", [](const Node& node) { node.fail_at("y[1]", "is odd"); }) == "a.json: all.x.y[1]: is odd");
  const std::string long_text = "\"" + std::string(200, 'a') + "\"";
  BOOST_TEST(refused(long_text, flag) ==
             "a.json: all.x: must be true or false, found \"" + std::string(56, 'a') + "...");
}

BOOST_AUTO_TEST_CASE(files_that_are_no_json_are_refused) {
  const Folder folder;
  const auto read = [&](const std::string& text) {
    return error_message([&] { (void)read_json(folder.file("a.json", text)); });
  };
  BOOST_TEST(read("{\"a\": 1}") == "");
  BOOST_TEST(holds(read(""), "a.json: is empty"));
  BOOST_TEST(holds(read("{\"a\": 1"), "a.json: is truncated or not JSON: "));
  BOOST_TEST(holds(read("{\"a\": 1e999}"), "a.json: is truncated or not JSON: "));
  BOOST_TEST(holds(error_message([&] { (void)read_json(folder.path / "none"); }), "No such file or directory"));
}

BOOST_AUTO_TEST_CASE(errors_of_the_library_are_without_their_numbers) {
  try {
    static_cast<void>(Json::parse("{}").at("id"));
    BOOST_FAIL("a member that is missing was found");
  } catch (const Json::exception& error) {
    BOOST_TEST(json_fault(error) == "key 'id' not found");
  }
  BOOST_TEST(json_fault(std::runtime_error{"[x] y"}) == "[x] y");
}

BOOST_AUTO_TEST_SUITE_END()
