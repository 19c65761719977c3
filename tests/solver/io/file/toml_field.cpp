#include "solver/io/file/toml_field.hpp"

#include <boost/test/unit_test.hpp>
#include <string>

#include "solver/base/error.hpp"

BOOST_AUTO_TEST_SUITE(toml_field_tests)

using namespace talus;

namespace {

TomlValue document() {
  return parse_toml(
      "gravity = [\"0 m/s^2\", \"-9.81 m/s^2\"]\n[run]\nstep = \"1 s\"\n"
      "[[body]]\nname = \"a\"\nshape = { kind = \"circle\", radius = \"1 m\" }\n[[body]]\nname = \"b\"\nmass = \"2 "
      "kg\"\n"
      "[fence]\n[[fence.rock]]\na = \"1 m\"\n[[fence.rock]]\na = \"2 m\"\n",
      "test.toml");
}

const TomlValue& at(const TomlValue& value, const std::string& key) {
  for (const TomlEntry& entry : std::get<TomlTable>(value.data))
    if (entry.key == key) return entry.value;
  BOOST_FAIL("no key " + key);
  return value;
}
const TomlValue& at(const TomlValue& value, std::size_t i) { return std::get<TomlArray>(value.data).at(i); }
std::string text(const TomlValue& value) { return std::get<std::string>(value.data); }

TomlValue changed(const std::string& path, const std::string& value = "new") {
  TomlValue made = document();
  set_field(made, path, {value});
  return made;
}

void refused(const std::string& path, const std::string& message) {
  TomlValue made = document();
  BOOST_CHECK_EXCEPTION(set_field(made, path, {"new"}), InputError, [&](const InputError& error) {
    BOOST_TEST(std::string{error.what()}.find(message) != std::string::npos, error.what());
    return true;
  });
}

}  // namespace

BOOST_AUTO_TEST_CASE(fields_of_all_kinds_are_set) {
  BOOST_TEST(text(at(at(changed("run.step"), "run"), "step")) == "new");
  BOOST_TEST(text(at(at(changed("run.end"), "run"), "end")) == "new");
  BOOST_TEST(text(at(at(changed("gravity[1]"), "gravity"), 1)) == "new");
  BOOST_TEST(text(at(at(at(changed("body.b.mass"), "body"), 1), "mass")) == "new");
  BOOST_TEST(text(at(at(at(at(changed("body.a.shape.radius"), "body"), 0), "shape"), "radius")) == "new");
  BOOST_TEST(text(at(at(at(at(changed("fence.rock[1].a"), "fence"), "rock"), 1), "a")) == "new");
  BOOST_TEST(text(at(at(at(at(changed("fence.rock[1].a"), "fence"), "rock"), 0), "a")) == "1 m");
}

BOOST_AUTO_TEST_CASE(tables_that_may_be_left_out_are_added) {
  BOOST_TEST(text(at(at(at(changed("fence.options.symmetry"), "fence"), "options"), "symmetry")) == "new");
  BOOST_TEST(text(at(at(at(changed("run.watch.accuracy"), "run"), "watch"), "accuracy")) == "new");
  TomlValue twice = changed("run.watch.accuracy", "first");
  set_field(twice, "run.watch.quality", {"second"});
  BOOST_TEST(text(at(at(at(twice, "run"), "watch"), "accuracy")) == "first");
  BOOST_TEST(text(at(at(at(twice, "run"), "watch"), "quality")) == "second");
  refused("fence.options[0].x", "field 'options' is not known");
}

BOOST_AUTO_TEST_CASE(a_changed_value_keeps_its_line) {
  BOOST_TEST(at(at(changed("body.b.mass"), "body"), 1).line == 7);
  BOOST_TEST(at(at(at(changed("body.b.mass"), "body"), 1), "mass").line == 9);
}

BOOST_AUTO_TEST_CASE(wrong_paths_are_refused) {
  for (const char* path : {"", ".", "run.", ".run", "a..b", "a[", "a[x]", "a[1", "[1]", "a[1]b"})
    refused(path, "it must be a path such as");
  refused("walk.step", "field 'walk' is not known");
  refused("body.c.mass", "name 'c' is not known");
  refused("body.a", "it must end with a field of 'a'");
  refused("body.a[0]", "it must end with a field of 'a'");
  refused("gravity", "found an array; it must be a value");
  refused("run", "found a table; it must be a value");
  refused("run.step.more", "nothing can be below 'step'");
  refused("run.step[0]", "'step' is not an array");
  refused("gravity[2]", "'gravity' has no element [2]; give one of its 2 elements");
  refused("gravity[0].x", "nothing can be below 'gravity'");
  refused("fence.rock[0]", "found a table; it must be a value");
  refused("fence.rock.a", "'fence.rock.a': 'rock' is a list without names; give an index, rock[0]");
  refused("gravity.x", "'gravity' is a list without names; give an index, gravity[0]");
}

BOOST_AUTO_TEST_SUITE_END()
