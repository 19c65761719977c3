#include "tests/interface/interface_text.hpp"

#include <boost/test/unit_test.hpp>

#include "tests/interface/known_gaps.hpp"

BOOST_AUTO_TEST_SUITE(interface_text_tests)

using namespace talus::interface_audit;
using Items = std::set<std::string>;

namespace {

const std::string scene = R"(title = "a # title"  # comment
gravity = ["0 m/s^2", "-9.81 m/s^2"]
[run]
steps = 10
step = 0.5
watch = { overlap = "off", limit = "2 %" }
[[body]]
name = "rock"
mass = "2 kg"
held = true
[[body]]
mass = "3 kg"
)";

std::string with(const std::string& item) { return changed("scene.toml", scene, item).value_or("nothing"); }
bool contains(const std::string& text, const char* part) { return text.find(part) != std::string::npos; }

}  // namespace

BOOST_AUTO_TEST_CASE(items_of_a_scene_are_its_values) {
  BOOST_TEST(
      (items_of("scene.toml", scene) == Items{"field body.held", "field body.mass", "field body.name",
                                              "field gravity.0", "field gravity.1", "field run.step", "field run.steps",
                                              "field run.watch.limit", "field run.watch.overlap", "field title"}));
  BOOST_TEST(items_of("scene.toml", "not = [toml").empty());
  BOOST_TEST(items_of("scene.txt", scene).empty());
}

BOOST_AUTO_TEST_CASE(numbers_change_with_their_units_everywhere_in_the_item) {
  BOOST_TEST(contains(with("field gravity.1"), R"(["0 m/s^2", "-9.908100000000001 m/s^2"])"));
  BOOST_TEST(contains(with("field gravity.0"), R"(["0.01 m/s^2", "-9.81 m/s^2"])"));
  BOOST_TEST(contains(with("field body.mass"), "mass = \"2.02 kg\""));
  BOOST_TEST(contains(with("field body.mass"), "mass = \"3.0300000000000002 kg\""));
  BOOST_TEST(contains(with("field run.steps"), "steps = 11\n"));
  BOOST_TEST(contains(with("field run.step"), "step = 0.505\n"));
  BOOST_TEST(contains(with("field body.held"), "held = false"));
  BOOST_TEST(with("field body.inertia") == "nothing");
}

BOOST_AUTO_TEST_CASE(texts_are_removed_with_their_keys) {
  BOOST_TEST(with("field title").starts_with("  # comment\n"));
  BOOST_TEST(contains(with("field run.watch.overlap"), "watch = {  limit = \"2 %\" }"));
  BOOST_TEST(contains(with("field run.watch.limit"), "limit = \"2.02 %\""));
  const std::string last = changed("a.toml", "a = { b = 1, c = \"off\" }\n", "field a.c").value_or("");
  BOOST_TEST(items_of("a.toml", last) == Items{"field a.b"});
  const std::string list = "held = [\"x\", \"y\"]\n";
  BOOST_TEST((items_of("a.toml", list) == Items{"field held.0", "field held.1"}));
  BOOST_TEST(contains(changed("a.toml", list, "field held.0").value_or(""), "held = [ \"y\"]"));
  BOOST_TEST(contains(changed("a.toml", list, "field held.1").value_or(""), "held = [\"x\"]"));
}

BOOST_AUTO_TEST_CASE(columns_change_in_each_row) {
  const std::string csv = "time [s],\"a, b\",name\n0,1,x\n1,2.5,y\n";
  BOOST_TEST((items_of("out/two.history.csv", csv) ==
              Items{"column *.history.csv: a, b", "column *.history.csv: name", "column *.history.csv: time [s]"}));
  BOOST_TEST(changed("history.csv", csv, "column history.csv: a, b").value_or("") ==
             "time [s],\"a, b\",name\n0,1.01,x\n1,2.525,y\n");
  const std::string notes = "# element 2, code 51\n# another\n";
  BOOST_TEST(items_of("out/impacts.csv", csv).contains("column impacts.csv: a, b"));
  BOOST_TEST((items_of("history.csv", notes + csv) == items_of("history.csv", csv)));
  BOOST_TEST(changed("history.csv", notes + csv, "column history.csv: a, b").value_or("") ==
             notes + "time [s],\"a, b\",name\n0,1.01,x\n1,2.525,y\n");
  BOOST_TEST(changed("history.csv", csv, "column history.csv: name").value_or("") ==
             "time [s],\"a, b\",name\n0,1,xx\n1,2.5,yx\n");
  const std::string texts = "end,reason\n1,\n,\"a, b\"\n";
  BOOST_TEST(changed("results.csv", texts, "column *.csv: reason").value_or("") == "end,reason\n1,\n,\"a, bx\"\n");
  BOOST_TEST(!changed("results.csv", "end,reason\n1,\n", "column *.csv: reason"));
  BOOST_TEST(!changed("history.csv", csv, "column history.csv: c"));
}

BOOST_AUTO_TEST_CASE(columns_of_bodies_are_one_item_and_the_last_one_changes) {
  const std::string csv = "time [s],a.x [m],b.c.x [m],energy.kinetic [N m],b.y [m]\n1,1,1,1,1\n";
  BOOST_TEST((items_of("history.csv", csv) == Items{"column history.csv: *.x [m]", "column history.csv: *.y [m]",
                                                    "column history.csv: energy.kinetic [N m]",
                                                    "column history.csv: time [s]"}));
  BOOST_TEST(contains(changed("history.csv", csv, "column history.csv: *.x [m]").value_or(""), "\n1,1,1.01,1,1\n"));
  BOOST_TEST((items_of("profile.csv", "a.x [m]\n1\n") == Items{"column profile.csv: a.x [m]"}));
}

BOOST_AUTO_TEST_CASE(members_change_in_each_element) {
  const std::string json = R"({"a": {"n": 1, "x": 2.0}, "l": [{"t": "s", "f": true}, {"t": "u", "f": null}]})";
  BOOST_TEST((items_of("summary.json", json) == Items{"member summary.json: a.n", "member summary.json: a.x",
                                                      "member summary.json: l[].f", "member summary.json: l[].t"}));
  const auto compact = [&](const char* item) {
    std::string text = changed("summary.json", json, item).value_or("");
    std::erase_if(text, [](char c) { return c == ' ' || c == '\n'; });
    return text;
  };
  BOOST_TEST(compact("member summary.json: a.n") ==
             R"({"a":{"n":2,"x":2.0},"l":[{"t":"s","f":true},{"t":"u","f":null}]})");
  BOOST_TEST(compact("member summary.json: a.x") ==
             R"({"a":{"n":1,"x":2.02},"l":[{"t":"s","f":true},{"t":"u","f":null}]})");
  BOOST_TEST(compact("member summary.json: l[].t") ==
             R"({"a":{"n":1,"x":2.0},"l":[{"t":"sx","f":true},{"t":"ux","f":null}]})");
  BOOST_TEST(compact("member summary.json: l[].f") ==
             R"({"a":{"n":1,"x":2.0},"l":[{"t":"s","f":false},{"t":"u","f":null}]})");
  BOOST_TEST(rewritten("summary.json", json).has_value());
}

BOOST_AUTO_TEST_CASE(arrays_of_states_change) {
  const std::string vtp =
      "<DataArray type=\"Float64\" format=\"ascii\">\n1 2\n</DataArray><DataArray Name=\"spin\">3</DataArray>";
  BOOST_TEST((items_of("out/two_7.vtp", vtp) == Items{"array *.vtp: points", "array *.vtp: spin"}));
  BOOST_TEST(
      contains(changed("two_7.vtp", vtp, "array *.vtp: spin").value_or(""), "Name=\"spin\">3.0300000000000002 <"));
  BOOST_TEST(contains(changed("two_7.vtp", vtp, "array *.vtp: points").value_or(""), "ascii\">1.01 2.02 <"));
}

BOOST_AUTO_TEST_CASE(gaps_are_known_with_a_reason_or_unexpected) {
  using talus::records::InterfaceStatus;
  const KnownGaps known = read_known_gaps(
      "# comment\n\nsurvived: option study --threads -- the same bits\n"
      "unused: field run.jump -- no effect here\n");
  BOOST_TEST(known.size() == 2U);
  BOOST_TEST(known.at("survived: option study --threads") == "the same bits");
  const auto item = [](const char* kind, const char* name, InterfaceStatus status) {
    return talus::records::InterfaceItem{
        .kind = kind, .name = name, .cases = {}, .status = status, .killed_by = "", .check = ""};
  };
  const std::vector<talus::records::InterfaceItem> items{
      item("option", "study --threads", InterfaceStatus::survived), item("field", "run.jump", InterfaceStatus::killed),
      item("member", "a.json: b", InterfaceStatus::survived), item("field", "title", InterfaceStatus::refused)};
  BOOST_TEST((unexpected_gaps(items, known) ==
              std::vector<std::string>{"not known: survived: member a.json: b", "no longer: unused: field run.jump"}));
  for (const char* wrong : {"survived: option a", "survived: option a -- ", "killed: option a -- reason",
                            "unused: field b -- one\nunused: field b -- two"})
    BOOST_CHECK_THROW(static_cast<void>(read_known_gaps(wrong)), std::runtime_error);
}

BOOST_AUTO_TEST_SUITE_END()
