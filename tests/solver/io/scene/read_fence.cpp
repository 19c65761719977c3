#include "solver/io/scene/read_fence.hpp"

#include <boost/test/unit_test.hpp>

#include "solver/base/error.hpp"
#include "solver/io/fence1993/read_deck.hpp"
#include "solver/io/fence1993/write_deck.hpp"
#include "solver/io/fence_file.hpp"
#include "solver/io/scene/write_fence.hpp"
#include "solver/scenes/fence_scene.hpp"

BOOST_AUTO_TEST_SUITE(read_fence_tests)

using namespace talus;
using scenes::Fence;

namespace {

std::filesystem::path folder() { return std::filesystem::path{TALUS_CASES} / "fence"; }

Fence read(const std::string& text) {
  const TomlValue document = parse_toml(text, "s.toml");
  SceneSource source{"s.toml", si};
  SceneTable table{source, document, ""};
  return read_fence(table, source);
}

/// The sample's scene file with `part` replaced.
std::string changed(std::string_view part, std::string_view replacement) {
  std::string text = read_text(folder() / "sample2.toml");
  const std::size_t at = text.find(part);
  BOOST_REQUIRE(at != std::string::npos);
  return text.replace(at, part.size(), replacement);
}

std::string message(std::string_view part, std::string_view replacement) {
  try {
    static_cast<void>(read(changed(part, replacement)));
  } catch (const InputError& error) {
    return error.what();
  }
  return "no error";
}

}  // namespace

BOOST_AUTO_TEST_CASE(scene_files_beside_decks_say_the_same) {
  int decks = 0;
  for (const auto& entry : std::filesystem::directory_iterator{folder()}) {
    if (entry.path().extension() != ".DAT") continue;
    std::filesystem::path scene = entry.path();
    scene.replace_extension(".toml");
    BOOST_TEST((read_fence(entry.path()) == read_fence(scene)));
    BOOST_TEST(write_fence(read_fence(entry.path())) == read_text(scene));
    ++decks;
  }
  BOOST_TEST(decks >= 7);
}

BOOST_AUTO_TEST_CASE(other_ways_to_write_it) {
  const Fence sound = read_deck(folder() / "sample2.DAT");
  BOOST_TEST((read(changed("\"2.5 ft\"", "\"30 in\"")) == sound));
  BOOST_TEST((read(changed("friction = 0.0\n", "")) == sound));
  BOOST_TEST((read(changed("bar_length = \"0 ft\"\n", "")) == sound));
  BOOST_TEST(read(changed("title", "# title")).title.empty());
  const Fence modern = read(read_text(folder() / "sample2.toml") +
                            "[fence.options]\nsymmetry = \"full\"\nend_rule = \"clamped\"\nintegrator = \"rk4\"\n");
  BOOST_TEST((modern.options.symmetry == scenes::FenceSymmetry::full));
  BOOST_TEST((modern.options.end_rule == EndRule::clamped));
  BOOST_TEST(modern.options.integrator == "rk4");
  BOOST_TEST((read(write_fence(modern)) == modern));
}

// Power 0 of a column gives a rectangle with contacts by resultants, and the outline of 1993 with contacts by nodes.
BOOST_AUTO_TEST_CASE(outlines_are_what_the_file_says) {
  using scenes::ElementOutline;
  const auto column = [](const std::string& lines, const std::string& options) {
    std::string text = changed("rules = \"1993\"\n", "");
    const std::size_t power = text.find("power = ", text.find("[fence.column]"));
    text.replace(power, text.find('\n', power) - power + 1, lines);
    return read(text + options);
  };
  const auto shape = [](const Fence& fence) {
    return scenes::fence_scene(fence).scene.model.bodies.back().shape.index();
  };
  const std::size_t rectangle = Shape{Rectangle{}}.index(), superquadric = Shape{Superquadric{}}.index();
  BOOST_TEST((column("power = 0.0\n", "").column.outline == ElementOutline::rectangle));
  BOOST_TEST((column("", "").column.outline == ElementOutline::rectangle));
  BOOST_TEST(shape(column("", "")) == rectangle);
  BOOST_TEST((column("power = 0.5\n", "").column.outline == ElementOutline::by_power));
  BOOST_TEST(shape(column("power = 0.5\n", "")) == superquadric);
  BOOST_TEST((column("shape = \"ellipse\"\n", "").column.outline == ElementOutline::ellipse));
  const std::string nodes = "[fence.options]\ncontact = \"nodes\"\n";
  BOOST_TEST((column("power = 0.0\n", nodes).column.outline == ElementOutline::by_power));
  BOOST_TEST(shape(column("power = 0.0\n", nodes)) == superquadric);
  const Fence made = column("", "");
  BOOST_TEST((read(write_fence(made)) == made));
}

// A round rock remains round: power 1 is n = 2.
BOOST_AUTO_TEST_CASE(a_round_rock_is_no_square) {
  std::string text = changed("rules = \"1993\"\n", "");
  const std::size_t rock = text.find("[[fence.rock]]"), power = text.find("power = ", rock);
  text.replace(power, text.find('\n', power) - power, "power = 1.0");
  for (const char* of : {"a = ", "b = "}) {
    const std::size_t axis = text.find(of, rock);
    text.replace(axis, text.find('\n', axis) - axis, std::string{of} + "\"1.5 ft\"");
  }
  const auto made = scenes::fence_scene(read(text));
  BOOST_TEST(made.scene.model.bodies[1].shape.index() == Shape{Circle{}}.index());
}

/// sample2 with every field that decks lack.
Fence beyond_the_deck() {
  Fence fence = read_deck(folder() / "sample2.DAT");
  fence.options.symmetry = scenes::FenceSymmetry::full;
  fence.options.hanger_strength = 20000.0;
  fence.options.strength_bottom = 12345.5;
  fence.options.hardening = 0.02;
  fence.options.rupture = 0.4;
  fence.options.shear_ratio = 0.3;
  fence.options.contact = scenes::FenceContact::smoother;
  fence.options.column_ground = scenes::ColumnGround::contact;
  fence.options.watch = {CheckAction::warning, CheckAction::off, CheckAction::error};
  fence.rocks[0].along = -3.75;
  fence.rocks[0].solid = scenes::ElementSolid::block;
  fence.ground_profile = {{-40.0, -6.0}, {0.0, -4.5}, {40.0, 3.25}};
  fence.changed_columns = {{2, 1.25, 3.5, 0.7, 6.17, -3.5}};
  fence.stretched_cables = {{"top1", 0.0125}, {"back_bottom-2", 0.5}};
  return fence;
}

BOOST_AUTO_TEST_CASE(what_no_deck_has_is_kept_by_scene_files_and_refused_by_decks) {
  const Fence fence = beyond_the_deck();
  BOOST_TEST((read(write_fence(fence)) == fence));
  BOOST_TEST((scenes::fence_scene(fence).scene.plan.watch == fence.options.watch));
  const Fence sound = read_deck(folder() / "sample2.DAT");
  const auto refused = [](const Fence& other) { BOOST_CHECK_THROW(static_cast<void>(write_deck(other)), InputError); };
  Fence one = sound;
  one.options.hanger_strength = 1.0;
  refused(one);
  one = sound, one.options.table = {{0.01, 1.2}};
  refused(one);
  one = sound, one.options.watch.accuracy = CheckAction::off, refused(one);
  one = sound, one.rocks[0].along = 1.0, refused(one);
  one = sound, one.ground_profile = fence.ground_profile, refused(one);
  one = sound, one.changed_columns = fence.changed_columns, refused(one);
  one = sound, one.stretched_cables = fence.stretched_cables, refused(one);
}

BOOST_AUTO_TEST_CASE(cables_yield_by_a_table) {
  Fence fence = read_deck(folder() / "sample2.DAT");
  const std::string options = read_text(folder() / "sample2.toml") + "[fence.options]\n";
  fence.options.table = {{0.01, 1.25}, {0.1, 1.5}};
  BOOST_TEST((read(options + "table = [[0.01, 1.25], [0.1, 1.5]]\n") == fence));
  BOOST_TEST((read(write_fence(fence)) == fence));
  const auto says = [&](std::string_view lines, std::string_view expected) {
    std::string found = "no error";
    try {
      static_cast<void>(read(options + std::string{lines}));
    } catch (const InputError& error) {
      found = error.what();
    }
    BOOST_TEST(found.find(expected) != std::string::npos, found);
  };
  says("hardening = 0.02\ntable = [[0.01, 1.25]]\n", "found hardening = 0.02 and table");
  says("table = [[0.01, 1.25], [0.005, 1.5]]\n", "table: found (0.005, 1.5) after (0.01, 1.25)");
  says("table = [[0.01, 0.5]]\n", "table: found (0.01, 0.5) after (0, 1)");
  says("table = [[\"1 ft\", \"2 lbf\"]]\n", "table: found \"1 ft\"; it must be a pure number");
  says("table = [0.1]\n", "each point must be a pair, e.g. [1.0, 1.0]");
  try {
    static_cast<void>(write_deck(fence));
    BOOST_TEST(false, "a deck took a table");
  } catch (const InputError& error) {
    BOOST_TEST(std::string_view{error.what()}.find("found table; it must be") != std::string_view::npos, error.what());
  }
}

BOOST_AUTO_TEST_CASE(wrong_parts_beyond_the_deck) {
  const auto message_of = [](std::string_view part, std::string_view replacement) -> std::string {
    std::string text = write_fence(beyond_the_deck());
    const std::size_t at = text.find(part);
    BOOST_REQUIRE(at != std::string::npos);
    try {
      static_cast<void>(scenes::fence_scene(read(text.replace(at, part.size(), replacement))));
    } catch (const InputError& error) {
      return error.what();
    }
    return "no error";
  };
  const auto says = [&](std::string_view part, std::string_view replacement, std::string_view expected) {
    const std::string found = message_of(part, replacement);
    BOOST_TEST(found.find(expected) != std::string::npos, found);
  };
  says("symmetry = \"full\"", "symmetry = \"half\"", "along: found -3.75 ft; it must be 0 in the half model");
  says("along = \"-3.75 ft\"", "along = \"-37 ft\"", "within 16.25 ft of mid-span");
  says("number = 2", "number = 8", "number: found 8; it must be in 1 .. 7");
  says("hanger_strength = \"20000 lbf\"", "hanger_strength = \"20000 lb\"", "it must be a force");
  says("hardening = 0.02", "hardening = 1.0", "hardening");
  says("\"top1\"", "\"tap1\"", "nearest: top1");
  says("[\"40 ft\"", "[\"-50 ft\"", "x must grow");
  says("stretch = \"0.0125 ft\"", "stretch = \"-1 ft\"", "must be >= 0");
}

BOOST_AUTO_TEST_CASE(wrong_fences) {
  const std::string keys = "this key is not known; nearest: ";
  BOOST_TEST(message("\"20000000 psi\"", "\"20000000 lbf\"") ==
             "s.toml:19: fence: young: found \"20000000 lbf\"; that is a force; it must be a pressure, e.g. \"20000000 "
             "lbf/ft^2\"");
  BOOST_TEST(message("\"20000000 psi\"", "20000000").substr(0, 57) ==
             "s.toml:19: fence: young: found 20000000; the unit is miss");
  BOOST_TEST(message("restitution = 0.4", "restitution = 1.4") ==
             "s.toml:22: fence: restitution: found 1.4; it must be in (0, 1]");
  BOOST_TEST(message("restitution = 0.4\n", "").substr(0, 44) == "s.toml:4: fence: restitution: it is missing");
  BOOST_TEST(message("columns = 13", "columns = 23") ==
             "s.toml:11: fence: columns: found 23: 2.5 ft apart they take 55 ft; it must be less than the span, 55 ft");
  BOOST_TEST(message("connections = 2", "connections = 3") ==
             "s.toml:10: fence: connections: found 3; it must be 1 or 2");
  BOOST_TEST(message("steps = 3000", "stps = 3000").substr(0, 67) ==
             "s.toml:6: fence: stps: this key is not known; nearest: steps; known");
  BOOST_TEST(
      message("solid = \"ellipsoid\"", "solid = \"cylinder\"") ==
      "s.toml:53: fence: rock 1: solid: found 2 (cylinder); it must be 0 (ellipsoid) or 1 (block) for the ground "
      "and rocks");
  BOOST_TEST(message("[[fence.rock]]", "[[fence.rok]]").find("fence: rok: " + keys + "rock") != std::string::npos);
  BOOST_TEST(message("held = [\"x\", ", "held = [\"z\", ") ==
             "s.toml:50: fence: ground: held: found \"z\"; known: x, y, rotation");
  BOOST_TEST(message("6, 7, 8, 35, 36]", "6, 7, 8, 35, 62]") ==
             "s.toml:33: fence: history_codes: found 62; it must be in 1 .. 61");
  BOOST_TEST(message("[2, 3, 4, 5, 6]", "7") ==
             "s.toml:32: fence: history_elements: found 7; it must be an array of whole numbers, e.g. [1, 2]");
  BOOST_TEST(message("[fence]", "[run]\nend = \"1 s\"\n[fence]").substr(0, 60) ==
             "s.toml:4: run: this key is not known; nearest: units; known:");
  BOOST_TEST(message("DOUBLE", "two\\nlines") ==
             "s.toml:1: title: found the control character 0x0a; a title is one line of UTF-8 or Latin-1 text");
}

// What is found only when the fence is built is reported at its field, too.
BOOST_AUTO_TEST_CASE(fences_that_cannot_be_built) {
  const auto built = [](std::string_view part, std::string_view replacement) {
    std::string text = read_text(folder() / "sample2.toml");
    const std::size_t at = text.find(part);
    BOOST_REQUIRE(at != std::string::npos);
    try {
      static_cast<void>(read_scene_file(text.replace(at, part.size(), replacement), "s.toml"));
    } catch (const InputError& error) {
      return std::string{error.what()};
    }
    return std::string{"no error"};
  };
  BOOST_TEST(
      built("penetration = 0.05", "penetration = 1e-200") ==
      "s.toml:14: fence: penetration: found 1e-200; the contact stiffness of a mass of 37.225 that stops from 65 "
      "within 1.201e-200 is inf; it must be > 0 and finite");
  BOOST_TEST(
      built("-65 ft/s", "0 ft/s") ==
      "s.toml:64: fence: rock 1: velocity: no rock moves; one must, since the contact stiffnesses follow from its "
      "speed");
  BOOST_TEST(built("held = [\"x\", ", "held = [") ==
             "s.toml:50: fence: ground: held: found a ground that can move; it must be held in x, y and rotation");
}

BOOST_AUTO_TEST_CASE(files_by_extension) {
  BOOST_TEST((fence_format("A.DAT") == FenceFormat::deck));
  BOOST_TEST((fence_format("a.dat") == FenceFormat::deck));
  BOOST_TEST((fence_format("a.Toml") == FenceFormat::toml));
  BOOST_CHECK_THROW(static_cast<void>(fence_format("a.txt")), InputError);
  BOOST_CHECK_THROW(static_cast<void>(read_fence(folder().parent_path() / "two_cable.toml")), InputError);
}

BOOST_AUTO_TEST_SUITE_END()
