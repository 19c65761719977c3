#include <fmt/format.h>

#include <algorithm>
#include <boost/test/unit_test.hpp>

#include "tests/solver/io/file_tables.hpp"

BOOST_AUTO_TEST_SUITE(many_errors_tests)

// Independent mistakes in different tables of one file are reported together, and nothing else.

namespace {

/// A mistake: `from` of a complete file becomes `to`, and a line of the message contains `expected`.
struct Mistake {
  std::string_view from, to, expected;
};

/// Makes all mistakes in a complete file and compares the messages.
void check_all(std::string_view file, const std::vector<Mistake>& mistakes) {
  auto tables = tables_of(file);
  for (const Mistake& mistake : mistakes) {
    const auto line_of = [&](auto& table) { return std::ranges::find(table.lines, mistake.from); };
    const auto table = std::ranges::find_if(tables, [&](FileTable& t) { return line_of(t) != t.lines.end(); });
    BOOST_REQUIRE_MESSAGE((table != tables.end()), mistake.from);
    if (mistake.to.empty()) {
      table->lines.erase(line_of(*table));
    } else {
      *line_of(*table) = mistake.to;
    }
  }
  const std::string errors = errors_of(tables);
  const auto lines = static_cast<std::size_t>(1 + std::ranges::count(errors, '\n'));
  BOOST_TEST(lines == mistakes.size(), errors);
  for (const Mistake& mistake : mistakes)
    BOOST_TEST((errors.find(mistake.expected) != std::string::npos),
               fmt::format("\"{}\" in {}", mistake.expected, errors));
}

}  // namespace

BOOST_AUTO_TEST_CASE(scene) {
  check_all(
      complete_files[0],
      {{"gravity = [\"0 m/s^2\", \"-9.81 m/s^2\"]", "gravity = \"9.81 m/s^2\"", ": gravity: found \"9.81 m/s^2\""},
       {"mass = \"3 kg\"", "mass = \"3 m\"", ": body 'rock': mass: found \"3 m\""},
       {"radius = \"0.5 m\"", "", ": body 'rock': shape: radius: it is missing"},
       {"kind = \"rectangle\"", "kind = \"rectangel\"", ": body 'door': shape: kind: found \"rectangel\""},
       {"pin = [\"0 m\", \"1 m\"]", "pin = [\"0 m\"]", ": body 'door': pin: found 1 components"},
       {"points = [[\"0 m\", \"0 m\"], [\"5 m\", \"1 m\"]]", "points = \"0 m\"", ": body 'hills': shape: points: "},
       {"between = [\"rock\", \"ground\"]", "between = [\"rok\", \"ground\"]", "body 'rok' is not known"},
       {"restitution = 0.5", "restitution = 1.5", ": contact 'bounce': restitution: found 1.5"},
       {"nodes = [12, 4]", "nodes = [1, 2, 3]", ": contact 'knock': nodes: found 3 numbers"},
       {"law = \"latching_spring\"", "law = \"latching\"", ": contact 'dent': law: found \"latching\""},
       {"node_depth = \"smoother\"", "node_depth = \"smother\"", ": contact 'dent': node_depth: found \"smother\""},
       {"rest_length = \"2 m\"", "rest_length = \"-2 m\"", ": cable 'rope': rest_length: found \"-2 m\""},
       {"table = [[\"0.1 m\", \"12 N\"], [\"0.2 m\", \"13 N\"]]", "table = 3", ": cable 'wire': table: found 3"},
       {"strength = \"50 N\"", "", ": hanger 'hook': strength: it is missing"},
       {"integrator = \"rk4\"", "integrator = \"rk5\"", ": run: integrator: found \"rk5\""},
       {"end = \"1 s\"", "end = \"0 s\"", ": run: end: found \"0 s\""},
       {"tunnelling = \"warning\"", "tunnelling = \"warn\"", ": run: watch: tunnelling: found \"warn\""},
       {"between = [\"rock\", \"door\"]", "between = \"rock\"", ": contact 'knock': between: found \"rock\""}});
}

// The missing step of a named method is reported without building the model.
BOOST_AUTO_TEST_CASE(scene_without_a_step) {
  check_all(complete_files[0], {{"mass = \"3 kg\"", "mass = \"3 m\"", ": body 'rock': mass: found \"3 m\""},
                                {"step = \"1 ms\"", "", ": run: step: it is missing; rk4 has a fixed step"}});
}

// The error gives the line of the table.
BOOST_AUTO_TEST_CASE(scene_that_the_model_refuses) {
  check_all(complete_files[0], {{"point = [\"0 m\", \"0.4 m\"]", "point = [\"0 m\", \"0.3 m\"]",
                                 ": hanger 'hook': 0 cables end at its point"}});
}

BOOST_AUTO_TEST_CASE(fence) {
  check_all(complete_files[2],
            {{"span = \"16 m\"", "", ": fence: span: it is missing"},
             {"duration = \"0.1 s\"", "duration = 0.1", ": fence: duration: found 0.1"},
             {"history_elements = [2, 3]", "history_elements = \"2\"", ": fence: history_elements: found \"2\""},
             {"history_codes = [3, 4]", "history_codes = [3, 4.5]", ": fence: history_codes: found 4.5"},
             {"ground_profile = [[\"-9 m\", \"-2 m\"], [\"9 m\", \"-1.9 m\"]]", "ground_profile = 1",
              ": fence: ground_profile: found 1"},
             {"power = 1.0", "power = 2.0", ": fence: rock 1: power: found 2"},
             {"shape = \"ellipse\"", "shape = \"elipse\"", ": fence: rock 2: shape: found \"elipse\""},
             {"solid = \"cylinder\"", "solid = \"cylindre\"", ": fence: column: solid: found \"cylindre\""},
             {"held = [\"x\", \"y\", \"rotation\"]", "held = [\"z\"]", ": fence: ground: held: found \"z\""},
             {"number = 3", "number = 0", ": fence: changed_column 1: number: found 0"},
             {"cable = \"top1\"", "cable = 1", ": fence: stretched_cable 1: cable: found 1"},
             {"contact = \"resultant\"", "contact = \"resultants\"", ": fence: options: contact: found \"resultants\""},
             {"integrator = \"stormer_cowell\"", "integrator = \"stormer\"",
              ": fence: options: integrator: found \"stormer\""},
             {"strength_top = \"600 kN\"", "strength_top = \"600 kg\"", ": fence: options: strength_top: found"},
             {"accuracy = \"off\"", "accuracy = \"of\"", ": fence: options: watch: accuracy: found \"of\""}});
}

BOOST_AUTO_TEST_CASE(fence_with_wrong_rules) {
  check_all(complete_files[3], {{"rules = \"1993\"", "rules = \"1994\"", ": fence: rules: found \"1994\""},
                                {"steps = 100", "", ": fence: duration: it is missing"},
                                {"table = [[0.01, 1.2]]", "table = 1.2", ": fence: options: table: found 1.2"}});
}

// Rules between several numbers.
BOOST_AUTO_TEST_CASE(fence_whose_numbers_do_not_go_together) {
  check_all(complete_files[2],
            {{"y_bottom = \"-1 m\"", "y_bottom = \"2 m\"", ": fence: y_top: found 1.5 m; it must be above"},
             {"gravity_sign = -1", "gravity_sign = 0", ": fence: gravity_sign: found 0; it must be 1 or -1"},
             {"along = \"0 m\"", "along = \"30 m\"", ": fence: rock 1: along: found 30 m"},
             {"solid = \"cylinder\"", "solid = \"block\"", ": fence: column: solid: found 1 (block)"},
             {"history_elements = [2, 3]", "history_elements = [2, 99]", ": fence: history_elements: found 99"},
             {"number = 3", "number = 99", ": fence: changed_column 1: number: found 99"},
             {"exit_x = \"-3 m\"", "exit_x = \"1 m\"", ": fence: rock 1: position: found x = 0.9 m"}});
}

BOOST_AUTO_TEST_CASE(cell) {
  check_all(complete_files[4],
            {{"title = \"All of a cell\"", "title = 3", ": title: "},
             {"stiffness = \"1.7e4 N/m\"", "", ": cell: stiffness: it is missing"},
             {"diameter = \"1 mm\"", "diameter = 1", ": cell: diameter: found 1; the unit is missing"},
             {"rows = 8", "rows = 0", ": cell: rows: found 0"},
             {"block_mass = \"9e-3 kg\"", "", ": cell: block_mass: it is missing; give overburden or block_mass"},
             {"friction = 0.5", "friction = -0.5", ": cell: friction: found -0.5"},
             {"seed = 3", "seed = -3", ": cell: seed: found -3"},
             {"integrator = \"central_difference\"", "integrator = \"rk4\"", ": run: integrator: found \"rk4\""},
             {"step = \"0.2 us\"", "stepp = \"0.2 us\"", ": run: stepp: this key is not known; nearest: step"},
             {"jump = \"on\"", "jump = \"yes\"", ": run: jump: found \"yes\""},
             {"images = \"nearest\"", "images = \"far\"", ": run: images: found \"far\""}});
  check_all(complete_files[6],
            {{"law = \"linear_spring_dashpot\"", "law = \"linear\"", ": cell: law: found \"linear\""},
             {"mass = \"7.2e-7 kg\"", "", ": cell: mass: it is missing"},
             {"wall_discs = 11", "", ": cell: wall_discs: it is missing"},
             {"end = \"100 ms\"", "", ": run: end: it is missing"}});
}

BOOST_AUTO_TEST_CASE(cell_whose_numbers_do_not_go_together) {
  check_all(complete_files[5], {{"restitution = 0.7", "restitution = 0.7\nseed = 1\nunloading_stiffness = \"3e4 N/m\"",
                                 ": cell: restitution: found beside unloading_stiffness"}});
  check_all(complete_files[4], {{"columns = 10", "columns = 12", ": cell: columns: found 12"},
                                {"unloading_stiffness = \"3e4 N/m\"", "unloading_stiffness = \"1e4 N/m\"",
                                 ": cell: unloading_stiffness: found \"1e4 N/m\", in SI: 10000; it must be at least"}});
}

BOOST_AUTO_TEST_CASE(cell_without_its_tables) {
  auto tables = tables_of(complete_files[4]);
  tables.resize(1);
  BOOST_TEST(errors_of(tables) == "f.toml:1: cell: it is missing\nf.toml:1: run: it is missing");
}

BOOST_AUTO_TEST_CASE(at_most_twenty) {
  for (const std::string_view file : complete_files) {
    auto tables = tables_of(file);
    for (int i = 0; i < 30; ++i)
      tables[1].lines.push_back(fmt::format("no_such_{} = 1", i));
    const std::string errors = errors_of(tables);
    BOOST_TEST(std::ranges::count(errors, '\n') == 20);
    BOOST_TEST(errors.ends_with("f.toml: there may be more errors; these are the first found"));
  }
}

BOOST_AUTO_TEST_SUITE_END()
