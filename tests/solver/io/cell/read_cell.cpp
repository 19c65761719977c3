#include "solver/io/cell/read_cell.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <boost/test/unit_test.hpp>
#include <string>
#include <vector>

#include "solver/base/error.hpp"
#include "solver/granular/disc_method.hpp"
#include "tests/temporary_folder.hpp"

BOOST_AUTO_TEST_SUITE(read_cell_tests)

using namespace talus;

namespace {

const std::string control = "0 1\n1.7e4 3.4e4 1e-3 7.2e-7 9.81 9e-3\n8 10 11 5.0\n2e-7 5e-3 0.1\n";

std::string message(const std::string& text, const std::string& name = "CNTRL.DAT", const CellChoices& choices = {}) {
  try {
    static_cast<void>(read_cell(text, name, choices));
  } catch (const InputError& error) {
    return error.what();
  }
  return "";
}

/// The valid file with one part replaced.
std::string with(std::string text, std::string_view what, std::string_view by) {
  const std::size_t offset = text.find(what);
  BOOST_REQUIRE(offset != std::string::npos);
  return text.replace(offset, what.size(), by);
}

const std::string toml = R"(title = "Cell"
units = "SI"
[cell]
stiffness = "1.7e4 N/m"
restitution = 0.5
diameter = "1 mm"
mass = "7.2e-7 kg"
gravity = "9.81 m/s^2"
overburden = "8 kPa"
rows = 8
columns = 10
wall_discs = 11
block_speed = "5 m/s"
seed = 3
[run]
integrator = "euler_cromer"
step = "0.2 us"
every = "5 ms"
end = "100 ms"
jump = "on"
)";

}  // namespace

BOOST_AUTO_TEST_CASE(the_fifteen_numbers_are_read_in_their_order) {
  const CellScene scene = read_cell(control, "CNTRL.DAT", {});
  BOOST_TEST(!scene.restart);
  BOOST_TEST(scene.pictures);
  BOOST_TEST(!scene.units.has_value());
  const ShearCell& cell = scene.cell;
  BOOST_TEST((cell.law == DiscLaw{LatchingSpring{1.7e4, 3.4e4, 0.0}}));
  BOOST_TEST(cell.diameter == 1e-3);
  BOOST_TEST(cell.mass == 7.2e-7);
  BOOST_TEST(cell.gravity == 9.81);
  BOOST_TEST(cell.block_mass == 9e-3);
  BOOST_TEST(cell.rows == 8);
  BOOST_TEST(cell.columns == 10);
  BOOST_TEST(cell.wall_discs == 11);
  BOOST_TEST(cell.block_speed == 5.0);
  BOOST_TEST(scene.plan.step == 2e-7);
  BOOST_TEST(scene.plan.every == 5e-3);
  BOOST_TEST(scene.plan.end == 0.1);
  BOOST_TEST(scene.plan.integrator == "central_difference");
}

BOOST_AUTO_TEST_CASE(records_are_list_directed) {
  // A record may continue over lines; extra items are dropped; D exponents, repeats and commas are accepted.
  const CellScene scene = read_cell(
      "2*0 rest\n1.7D4, 3.4D+4\n 1e-3 7.2e-7,9.81\n9e-3 more\r\n8 10 11. 5\n2e-7 5e-3 0.1\n", "CNTRL.DAT", {});
  BOOST_TEST(!scene.pictures);
  BOOST_TEST(std::get<LatchingSpring>(scene.cell.law).unloading_stiffness == 3.4e4);
  BOOST_TEST(scene.cell.block_mass == 9e-3);
  BOOST_TEST(scene.cell.wall_discs == 11);
}

BOOST_AUTO_TEST_CASE(errors_name_file_line_and_field) {
  BOOST_TEST(message(with(control, "3.4e4", "1.6e4")) ==
             "CNTRL.DAT:2: K1 K2 D M G MTOP: K2: found 16000; it must be at least the stiffness, 17000: a "
             "contact with K2 < K1 would create energy");
  BOOST_TEST(
      message(with(control, "8 10 11", "8 12 11")) ==
      "CNTRL.DAT:3: NHT NWID TWID VXT: NWID: found 12; it must be at most the discs of a wall, 11: more do not fit "
      "beside each other");
  BOOST_TEST(message(with(control, "8 10 11", "8 2 2")) ==
             "CNTRL.DAT:3: NHT NWID TWID VXT: TWID: found 2; it must be a whole number between 3 and 100000");
  BOOST_TEST(message(with(control, "2e-7 5e-3", "2e-7 1e-7")) ==
             "CNTRL.DAT:4: STEP LOOP TIME: STEP: found 2e-07; it must be at most the time between outputs, 1e-07");
  BOOST_TEST(message(with(control, "5e-3 0.1", "5e-7 0.1")) ==
             "CNTRL.DAT:4: STEP LOOP TIME: LOOP: found 5e-07; it must be at least 1e-06: a run has at most 100000 "
             "outputs");
  BOOST_TEST(message(with(control, "5e-3 0.1", "1e-6 0.1")).empty());  // 1e5 outputs, by the last bit but one
  BOOST_TEST(message("\xEF\xBB\xBF" + control).empty());
  BOOST_TEST(message(with(control, "5e-3 0.1", "0.2 0.1")) ==
             "CNTRL.DAT:4: STEP LOOP TIME: LOOP: found 0.2; it must be at most the time that the run takes, 0.1");
  BOOST_TEST(
      message(with(control, "2e-7 5e-3", "2e-6 5e-3")) ==
      "CNTRL.DAT:4: STEP LOOP TIME: STEP: found 2e-06; a contact lasts 1.234e-05, and central_difference needs 10 "
      "steps of it: at most 1.234e-06");
  BOOST_TEST(message(with(control, "0 1\n", "2 1\n")) ==
             "CNTRL.DAT:1: RESTRT GRAPH: RESTRT: found 2; it must be 0 or 1");
  BOOST_TEST(message(with(control, "8 10", "8.5 10")) ==
             "CNTRL.DAT:3: NHT NWID TWID VXT: NHT: found 8.5; it must be a whole number between 1 and 100000");
  BOOST_TEST(message(with(control, "9.81", "g")) ==
             "CNTRL.DAT:2: K1 K2 D M G MTOP: G: found \"g\"; it must be a number");
  BOOST_TEST(message(with(control, "9e-3", "0")) == "CNTRL.DAT:2: K1 K2 D M G MTOP: MTOP: found 0; it must be > 0");
  BOOST_TEST(
      message(with(control, "2e-7 5e-3 0.1\n", "2e-7 5e-3\n")).starts_with("CNTRL.DAT:4: STEP LOOP TIME: TIME: "));
  BOOST_TEST(message("").starts_with("CNTRL.DAT:1: RESTRT GRAPH: RESTRT: "));
}

BOOST_AUTO_TEST_CASE(cells_are_distinguished_from_bodies_by_their_tables) {
  const Folder folder;
  BOOST_TEST(describes_cell(folder.file("OTHER.DAT", control)));
  BOOST_TEST(!describes_cell(folder.file("MORE.DAT", control + "1\n")));
  BOOST_TEST(!describes_cell(folder.file("WORD.DAT", with(control, "9.81", "g"))));
  BOOST_TEST(describes_cell(folder.file("CNTRL.DAT", with(control, "9.81", "g"))));
  BOOST_TEST(describes_cell(folder.file("a.toml", "title = \"a\"\n[cell]\n")));
  BOOST_TEST(!describes_cell(folder.file("b.toml", "title = \"b\"\n[run]\n")));
}

BOOST_AUTO_TEST_CASE(steps_that_change_the_restitution_are_refused_but_in_a_historical_run) {
  const std::string slow = message(control, "CNTRL.DAT", {.integrator = "euler"});
  BOOST_TEST(
      slow.starts_with("CNTRL.DAT:4: STEP LOOP TIME: STEP: found 2e-07; with it euler changes a restitution of "
                       "0.7071 to 0.7"));
  const std::string historical = with(with(control, "3.4e4", "37777.777777777778"), "2e-7 5e-3", "1e-7 5e-3");
  const CellScene scene = read_cell(historical, "CNTRL.DAT", {.integrator = "euler", .historical = true});
  BOOST_TEST(scene.plan.historical);
  BOOST_TEST(message(control, "CNTRL.DAT", {.integrator = "euler", .historical = true})
                 .starts_with("CNTRL.DAT:2: K1 K2 D M G MTOP: K2: found 34000; a historical run has K1/K2 = 0.45"));
  BOOST_TEST(
      message(with(historical, "1e-7 5e-3", "1e-8 5e-3"), "CNTRL.DAT", {.integrator = "euler", .historical = true})
          .starts_with("CNTRL.DAT:4: STEP LOOP TIME: STEP: found 1e-08; a historical run has a step of 1e-7"));
  BOOST_TEST(message(historical, "CNTRL.DAT", {.historical = true}) ==
             "CNTRL.DAT: integrator: found central_difference; a historical run requires euler");
  BOOST_TEST(message(control, "CNTRL.DAT", {.integrator = "rk4"}).find("integrator of discs 'rk4' is not known") == 0U);
}

BOOST_AUTO_TEST_CASE(a_scene_file_says_the_same_with_units) {
  const CellScene scene = read_cell(toml, "cell.toml", {});
  BOOST_TEST(scene.cell.restitution() == 0.5, boost::test_tools::tolerance(1e-15));
  BOOST_TEST(scene.cell.overburden() == 8e3, boost::test_tools::tolerance(1e-15));
  BOOST_TEST(scene.cell.seed == 3U);
  BOOST_TEST(scene.plan.integrator == "euler_cromer");
  BOOST_TEST(scene.plan.jump);
  BOOST_TEST(!scene.pictures);
  BOOST_TEST((*scene.units == si));
  BOOST_TEST(read_cell(toml, "cell.toml", {.seed = 9}).cell.seed == 9U);
}

BOOST_AUTO_TEST_CASE(wrong_scene_files) {
  const auto refusal = [&](std::string_view what, std::string_view by) {
    return message(with(toml, what, by), "c.toml");
  };
  BOOST_TEST(refusal("restitution = 0.5", "") ==
             "c.toml:3: cell: unloading_stiffness: it is missing; give restitution or unloading_stiffness");
  BOOST_TEST(refusal("restitution = 0.5", "restitution = 0.5\nunloading_stiffness = \"2e4 N/m\"")
                 .find("give one of the two") != std::string::npos);
  BOOST_TEST(
      refusal("columns = 10", "columns = 12").starts_with("c.toml:11: cell: columns: found 12; it must be at most"));
  BOOST_TEST(refusal("\"0.2 us\"", "\"2 us\"")
                 .starts_with("c.toml:17: run: step: found \"2 us\", in SI: 2e-06; a contact lasts"));
  BOOST_TEST(refusal("seed = 3", "seeds = 3").find("nearest: seed") != std::string::npos);
  BOOST_TEST(refusal("euler_cromer", "rk4").find("rk4") != std::string::npos);
  BOOST_TEST(refusal("seed = 3", "seed = 9007199254740993") ==
             "c.toml:14: cell: seed: found 9007199254740993; it must be a whole number between 0 and 9007199254740991");
  BOOST_TEST(refusal("seed = 3", "seed = 99999999999").empty());
  BOOST_TEST(refusal("[run]", "[run]\nhistorical = \"on\"").starts_with("c.toml:"));
  // Values from the command line have no line number.
  BOOST_TEST(message(toml, "c.toml", {.integrator = "euler"}).starts_with("c.toml:17: run: step: "));
  BOOST_TEST(message(toml, "c.toml", {.integrator = "euler_cromer", .historical = true}) ==
             "--integrator: found euler_cromer; a historical run requires euler");
  BOOST_TEST(message(toml, "c.toml", {.units = us}) == "c.toml: a unit system is named in the file already");
}

BOOST_AUTO_TEST_CASE(a_scene_file_names_its_law_and_its_friction) {
  const auto read = [](const std::string& cell) {
    return read_cell(with(toml, "restitution = 0.5", cell), "c.toml", {}).cell;
  };
  BOOST_TEST((read("restitution = 0.5").law == DiscLaw{LatchingSpring{1.7e4, 6.8e4, 0.0}}));
  BOOST_TEST((read("law = \"latching_spring\"\nunloading_stiffness = \"2e4 N/m\"\ngrowth = \"5e-3 1/m\"").law ==
              DiscLaw{LatchingSpring{1.7e4, 2e4, 5e-3}}));
  BOOST_TEST((read("law = \"linear_spring_dashpot\"\ndamping = \"0.02 N s/m\"\nend_rule = \"attractive\"").law ==
              DiscLaw{LinearSpringDashpot{1.7e4, 0.02, EndRule::attractive}}));
  for (const char* const rule : {"clamped", "attractive"}) {
    const ShearCell cell =
        read(fmt::format("law = \"linear_spring_dashpot\"\nrestitution = 0.5\nend_rule = \"{}\"", rule));
    BOOST_TEST(cell.restitution() == 0.5, boost::test_tools::tolerance(1e-12));
    BOOST_TEST(!cell.friction.has_value());
  }
  BOOST_TEST((*read("restitution = 0.5\nfriction = 0.4").friction == DiscFriction{CoulombFriction{0.4, 1.7e4}}));
  BOOST_TEST((*read("restitution = 0.5\nfriction = 0.4\nshear_stiffness = \"1e4 N/m\"").friction ==
              DiscFriction{CoulombFriction{0.4, 1e4}}));
  // Two discs that stick oscillate along their surface with w_s^2 = 6 k_s/m: a leapfrog needs w_s h <= 1.
  const auto with_stiffness = [&](double w_s_h) {
    const double w_s = w_s_h / 2e-7, mass = read("restitution = 0.5\nfriction = 0.4").mass;
    return fmt::format("restitution = 0.5\nfriction = 0.4\nshear_stiffness = \"{:.17g} N/m\"", w_s * w_s * mass / 6.0);
  };
  BOOST_TEST(read(with_stiffness(0.999)).friction.has_value());
  const std::string stiff = message(with(toml, "restitution = 0.5", with_stiffness(1.001)), "c.toml");
  BOOST_TEST(
      stiff.find("run: step: found \"0.2 us\", in SI: 2.0000000000000002e-07; contacts that stick are so stiff "
                 "along their surface that euler_cromer needs a step of at most 1.998e-07, ") != std::string::npos,
      stiff);
}

BOOST_AUTO_TEST_CASE(fields_that_a_law_does_not_have_are_errors_with_their_line) {
  const auto refusal = [&](std::string_view what, std::string_view by) {
    return message(with(toml, what, by), "c.toml");
  };
  BOOST_TEST(refusal("restitution = 0.5", "restitution = 0.5\nlaw = \"hertzian\"") ==
             "c.toml:6: cell: law: found \"hertzian\"; nearest: hertz; known: linear_spring_dashpot, latching_spring, "
             "hertz, hunt_crossley");
  const std::string both =
      refusal("restitution = 0.5", "unloading_stiffness = \"2e4 N/m\"\nlaw = \"linear_spring_dashpot\"");
  BOOST_TEST(both.starts_with("c.toml:3: cell: damping: it is missing; give restitution or damping\n"), both);
  BOOST_TEST(both.find("c.toml:5: cell: unloading_stiffness: this key is not known; nearest: ") != std::string::npos);
  BOOST_TEST(refusal("restitution = 0.5", "restitution = 0.5\ndamping = \"1 N s/m\"")
                 .starts_with("c.toml:6: cell: damping: this key is not known; nearest: "));
  BOOST_TEST(refusal("restitution = 0.5", "damping = \"-1 N s/m\"\nlaw = \"linear_spring_dashpot\"") ==
             "c.toml:5: cell: damping: found \"-1 N s/m\"; it must be >= 0");
  BOOST_TEST(
      refusal("restitution = 0.5", "damping = \"1 N s/m\"\nlaw = \"linear_spring_dashpot\"\nend_rule = \"attractive\"")
          .starts_with("c.toml:5: cell: damping: found \"1 N s/m\", in SI: 1; it must be < 0.156"));
  BOOST_TEST(refusal("restitution = 0.5", "law = \"linear_spring_dashpot\"") ==
             "c.toml:3: cell: damping: it is missing; give restitution or damping");
  BOOST_TEST(refusal("restitution = 0.5", "restitution = 0.5\nshear_stiffness = \"1e4 N/m\"") ==
             "c.toml:6: cell: shear_stiffness: it requires friction; give friction, or remove it");
  BOOST_TEST(refusal("restitution = 0.5", "restitution = 0.5\nfriction = -0.1") ==
             "c.toml:6: cell: friction: found -0.1; it must be >= 0");
  std::vector<std::string> leapfrogs = disc_method_names();
  std::erase_if(leapfrogs,
                [](const std::string& name) { return integrator_traits(name).amplitude_growth_rate != 0.0; });
  for (const char* const other : {"damping = \"0.02 N s/m\"\nlaw = \"linear_spring_dashpot\"",
                                  "restitution = 0.5\nfriction = 0.4", "restitution = 0.5\ngrowth = \"5e-3 1/m\""}) {
    const std::string scene = with(toml, "restitution = 0.5", other);
    BOOST_TEST(message(scene, "c.toml").empty());
    BOOST_TEST(message(with(scene, "euler_cromer", "taylor"), "c.toml") ==
               fmt::format("c.toml:17: run: integrator: found taylor; its error of the restitution is known only for "
                           "latching springs that do not grow stiffer, without friction; with other laws it must be a "
                           "leapfrog: {}",
                           fmt::join(leapfrogs, ", ")));
    BOOST_TEST(
        message(with(scene, "jump = ", "historical = "), "c.toml") ==
        "c.toml:21: run: historical: found on; a historical run is of latching springs that do not grow stiffer, "
        "without friction");
  }
}

BOOST_AUTO_TEST_CASE(laws_that_are_not_linear_have_a_speed_of_impact) {
  const auto close = boost::test_tools::tolerance(1e-12);
  const auto text = [](const std::string& law) {
    return with(with(toml, "stiffness = \"1.7e4 N/m\"\n", ""), "restitution = 0.5", law);
  };
  const std::string hertz = "law = \"hertz\"\nmodulus = \"700 MPa\"\nradius = \"0.25 mm\"\n";
  const std::string hunt = "law = \"hunt_crossley\"\nstiffness = \"4.5e4 N/m\"\nreference_overlap = \"0.01 mm\"\n";
  const auto read = [&](const std::string& law) { return read_cell(text(law), "c.toml", {}).cell; };
  const auto refusal = [&](const std::string& law) { return message(text(law), "c.toml"); };
  BOOST_TEST((read(hertz + "damping = \"0.02 N s/m\"\ndashpot = \"constant\"\nend_rule = \"attractive\"").law ==
              DiscLaw{Hertz{7e8, 2.5e-4, 0.02, EndRule::attractive, HertzDashpot::constant}}));
  BOOST_TEST(
      (read(hunt + "exponent = 2.5\nhysteresis = \"0.5 s/m\"").law == DiscLaw{HuntCrossley{4.5e4, 1e-5, 2.5, 0.5}}));
  for (const std::string& law : {hertz, hertz + "dashpot = \"constant\"\n", hunt + "exponent = 1.5\n"}) {
    for (const double speed : {0.0, 0.7}) {
      const std::string at = speed > 0.0 ? fmt::format("\nimpact_speed = \"{} m/s\"", speed) : "";
      const ShearCell cell = read(law + "restitution = 0.6" + at);
      BOOST_TEST(cell.nominal_speed() == (speed > 0.0 ? speed : std::abs(cell.block_speed) / (cell.rows + 1)));
      BOOST_TEST(cell.restitution() == 0.6, close);
      std::visit(
          [&](const auto& of) { BOOST_TEST(of.restitution(0.5 * cell.mass, cell.nominal_speed()) == 0.6, close); },
          cell.law);
    }
    const ShearCell rough = read(law + "restitution = 0.6\nfriction = 0.4");
    BOOST_TEST((*rough.friction == DiscFriction{CoulombFriction{0.4, rough.stiffness()}}));
    BOOST_TEST(refusal(law) == (law.starts_with("law = \"hunt")
                                    ? "c.toml:3: cell: hysteresis: it is missing; give restitution or hysteresis"
                                    : "c.toml:3: cell: damping: it is missing; give restitution or damping"));
    BOOST_TEST(message(with(text(law + "restitution = 0.6"), "block_speed = \"5 m/s\"", "block_speed = \"0 m/s\""),
                       "c.toml") ==
               fmt::format("c.toml:3: cell: impact_speed: found 0; it must be > 0 for the law {}, and block_speed = 0 "
                           "gives none",
                           law.starts_with("law = \"hunt") ? "hunt_crossley" : "hertz"));
  }
  BOOST_TEST(refusal(hertz + "restitution = 0.6\nimpact_speed = \"-1 m/s\"")
                 .ends_with("cell: impact_speed: found \"-1 m/s\"; it must be > 0"));
  BOOST_TEST(refusal(hertz + "restitution = 0.6\nimpact_speed = \"1e-300 m/s\"")
                 .find("cell: impact_speed: found \"1e-300 m/s\", in SI: 1e-300; it must be such that impacts have a "
                       "duration; by hertz it is ") != std::string::npos);
  BOOST_TEST(refusal(hertz + "restitution = 0.6\ndashpot = \"tsujii\"")
                 .find("cell: dashpot: found \"tsujii\"; nearest: tsuji") != std::string::npos);
  BOOST_TEST(refusal(hertz + "damping = \"2 N s/m\"\nend_rule = \"attractive\"")
                 .ends_with("cell: damping: found \"2 N s/m\", in SI: 2; it must be smaller: with this end rule "
                            "overdamped contacts never separate"));
  const std::string strong = refusal(hertz + "damping = \"2e6 N s/m\"");
  BOOST_TEST(
      strong.find("cell: damping: found \"2e6 N s/m\", in SI: 2000000; it must be at most ") != std::string::npos,
      strong);
  BOOST_TEST(
      strong.ends_with("with it the damping force of an impact at the speed 0.5556 is 1000 times that of the spring"),
      strong);
  // A speed has no effect where impacts do not depend on it.
  BOOST_TEST(message(with(toml, "restitution = 0.5", "restitution = 0.5\nimpact_speed = \"1 m/s\""), "c.toml")
                 .find("cell: impact_speed: this key is not known") != std::string::npos);
  // The block presses its discs together so that they are stiffer than in an impact.
  const std::string stiff = "law = \"hertz\"\nmodulus = \"700 GPa\"\nradius = \"0.25 mm\"\nrestitution = 0.6\n";
  const std::string heavy = message(
      with(text(stiff + "impact_speed = \"1e-6 m/s\""), "overburden = \"8 kPa\"", "overburden = \"8 MPa\""), "c.toml");
  BOOST_TEST(heavy.find("run: step: found \"0.2 us\", in SI: 2.0000000000000002e-07; at an overlap of 6.6") !=
                 std::string::npos,
             heavy);
  BOOST_TEST(heavy.find("contacts are so stiff that euler_cromer needs a step of at most 1.4") != std::string::npos,
             heavy);
}

BOOST_AUTO_TEST_CASE(friction_of_a_law_with_a_radius_has_a_choice) {
  const auto text = [](const std::string& law, const std::string& more) {
    return with(with(toml, "stiffness = \"1.7e4 N/m\"\n", ""), "restitution = 0.5", law + "restitution = 0.6" + more);
  };
  const std::string hertz = "law = \"hertz\"\nmodulus = \"700 MPa\"\nradius = \"0.25 mm\"\n";
  const auto read = [&](const std::string& more) { return read_cell(text(hertz, more), "c.toml", {}).cell; };
  const auto refusal = [&](const std::string& more) { return message(text(hertz, more), "c.toml"); };
  const std::string mindlin = "\nfriction = 0.4\nshear_law = \"mindlin\"";
  const ShearCell cell = read(mindlin + "\nshear_modulus = \"500 MPa\"");
  BOOST_TEST((*cell.friction == DiscFriction{Mindlin{0.4, 5e8, 2.5e-4}}));
  BOOST_TEST(cell.shear_stiffness() == 8.0 * 5e8 * std::sqrt(2.5e-4 * cell.nominal_overlap()),
             boost::test_tools::tolerance(1e-14));
  const ShearCell linear = read("\nfriction = 0.4\nshear_law = \"linear\"\nshear_stiffness = \"1e4 N/m\"");
  BOOST_TEST((*linear.friction == DiscFriction{CoulombFriction{0.4, 1e4}}));
  BOOST_TEST(linear.shear_stiffness() == 1e4);
  BOOST_TEST(refusal(mindlin) == "c.toml:3: cell: shear_modulus: it is missing");
  BOOST_TEST(refusal(mindlin + "\nshear_modulus = \"0 Pa\"") ==
             "c.toml:10: cell: shear_modulus: found \"0 Pa\"; it must be > 0");
  BOOST_TEST(refusal(mindlin + "\nshear_modulus = \"1 Pa\"\nshear_stiffness = \"1 N/m\"") ==
             "c.toml:11: cell: shear_stiffness: it belongs to shear_law = \"linear\"; give shear_modulus instead");
  BOOST_TEST(refusal("\nfriction = 0.4\nshear_modulus = \"1 Pa\"") ==
             "c.toml:9: cell: shear_modulus: it belongs to shear_law = \"mindlin\"; give this law, or remove it");
  BOOST_TEST(refusal("\nshear_law = \"mindlin\"") ==
             "c.toml:8: cell: shear_law: it requires friction; give friction, or remove it");
  BOOST_TEST(refusal("\nshear_modulus = \"1 Pa\"") ==
             "c.toml:8: cell: shear_modulus: it requires friction; give friction, or remove it");
  BOOST_TEST(refusal("\nfriction = 0.4\nshear_law = \"minlin\"") ==
             "c.toml:9: cell: shear_law: found \"minlin\"; nearest: mindlin; known: linear, mindlin");
  BOOST_TEST(refusal(mindlin + "\nshear_modulus = \"1 Pa\"\nshear_damping = \"1 N s/m\"")
                 .starts_with("c.toml:11: cell: shear_damping: this key is not known"));
  BOOST_TEST(
      message(with(toml, "restitution = 0.5", "restitution = 0.5\nfriction = 0.4\nshear_law = \"mindlin\""), "c.toml")
          .starts_with("c.toml:7: cell: shear_law: this key is not known"));
}

BOOST_AUTO_TEST_CASE(images_across_the_borders_may_be_virtual_discs) {
  BOOST_TEST((read_cell(toml, "c.toml", {}).plan.images == Images::nearest));
  BOOST_TEST((read_cell(with(toml, "jump = \"on\"", "images = \"virtual\""), "c.toml", {}).plan.images ==
              Images::virtual_discs));
  BOOST_TEST((read_cell(control, "CNTRL.DAT", {.virtual_discs = true}).plan.images == Images::virtual_discs));
  BOOST_TEST(message(with(toml, "jump = \"on\"", "images = \"minimum\""), "c.toml") ==
             "c.toml:20: run: images: found \"minimum\"; nearest: virtual; known: nearest, virtual");
  BOOST_TEST(message(with(toml, "jump = \"on\"", "jump = \"on\"\nimages = \"virtual\""), "c.toml") ==
             "c.toml:20: run: jump: found on; it requires images = \"nearest\", not virtual discs");
  BOOST_TEST(message(control, "CNTRL.DAT", {.jump = true, .virtual_discs = true}) ==
             "--jump: found on; it requires images = \"nearest\", not virtual discs");
}

BOOST_AUTO_TEST_CASE(a_mistyped_key_is_reported_before_a_missing_one) {
  const auto refusal = [&](std::string_view what, std::string_view by) {
    return message(with(toml, what, by), "c.toml");
  };
  BOOST_TEST(refusal("stiffness = ", "stifness = ") ==
             "c.toml:4: cell: stifness: this key is not known; nearest: stiffness; known: law, stiffness, "
             "unloading_stiffness, growth, restitution, friction, shear_stiffness, overburden, seed, diameter, mass, "
             "gravity, block_mass, block_speed, rows, columns, wall_discs");
  BOOST_TEST(refusal("rows = ", "row = ").starts_with("c.toml:10: cell: row: this key is not known; nearest: rows; "));
  BOOST_TEST(refusal("step = ", "steps = ") ==
             "c.toml:17: run: steps: this key is not known; nearest: step; known: step, every, end, integrator, jump, "
             "images, historical, pictures");
  BOOST_TEST(refusal("[run]", "[runs]") ==
             "c.toml:15: runs: this key is not known; nearest: run; known: title, units, cell, run");
}

BOOST_AUTO_TEST_CASE(the_rough_cell_of_cases_is_the_other_one_with_another_law) {
  const CellScene ice = read_cell(std::filesystem::path{TALUS_CASES} / "cell/ice.toml", {});
  const CellScene rough = read_cell(std::filesystem::path{TALUS_CASES} / "cell/rough.toml", {});
  BOOST_TEST(rough.cell.contact_time() == ice.cell.contact_time(), boost::test_tools::tolerance(1e-4));
  BOOST_TEST(rough.cell.restitution() == ice.cell.restitution(), boost::test_tools::tolerance(1e-12));
  BOOST_TEST(rough.cell.overburden() == ice.cell.overburden());
  BOOST_TEST(std::get<CoulombFriction>(*rough.cell.friction).coefficient == 0.5);
  BOOST_TEST(rough.plan.step == ice.plan.step);
}

BOOST_AUTO_TEST_CASE(the_two_files_of_cases_are_the_same_cell) {
  const CellScene one = read_cell(std::filesystem::path{TALUS_CASES} / "cell/CNTRL.DAT", {.seed = 1});
  const CellScene other = read_cell(std::filesystem::path{TALUS_CASES} / "cell/ice.toml", {});
  BOOST_TEST(one.cell.overburden() == other.cell.overburden(), boost::test_tools::tolerance(1e-12));
  BOOST_TEST(one.cell.restitution() == other.cell.restitution(), boost::test_tools::tolerance(1e-12));
  BOOST_TEST(one.plan.step == other.plan.step, boost::test_tools::tolerance(1e-15));
  BOOST_TEST(one.plan.every == other.plan.every, boost::test_tools::tolerance(1e-15));
  BOOST_TEST(one.plan.end == other.plan.end, boost::test_tools::tolerance(1e-15));
  BOOST_TEST(one.cell.rows == other.cell.rows);
  BOOST_TEST(one.pictures == other.pictures);
}

BOOST_AUTO_TEST_SUITE_END()
