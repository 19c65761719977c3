#include <fmt/format.h>

#include <boost/test/unit_test.hpp>
#include <cmath>
#include <nlohmann/json.hpp>
#include <sstream>
#include <string>

#include "solver/laws/restitution.hpp"
#include "tests/solver/app/requested.hpp"

BOOST_AUTO_TEST_SUITE(calibrate_tests)

// `talus calibrate`: the printed lines give the restitution when pasted into a scene, and an impact is judged as by
// `talus run`.

namespace {

/// A ball of 2 kg that hits a wall at 5 m/s, with these lines of its contact.
std::string wall_scene(const std::string& contact) {
  return fmt::format(
      "title = \"Ball against a wall\"\nunits = \"SI\"\n"
      "[[body]]\nname = \"ball\"\nmobility = \"particle\"\nmass = \"2 kg\"\nposition = [\"-1 m\", \"0 m\"]\n"
      "velocity = [\"5 m/s\", \"0 m/s\"]\nshape = {{ kind = \"circle\", radius = \"0.1 m\" }}\n"
      "[[body]]\nname = \"wall\"\nmobility = \"fixed\"\nposition = [\"0 m\", \"0 m\"]\nangle = \"90 deg\"\n"
      "shape = {{ kind = \"half_plane\" }}\n"
      "[[contact]]\nname = \"hit\"\nbetween = [\"ball\", \"wall\"]\nlaw = \"linear_spring_dashpot\"\n{}"
      "[run]\nend = \"0.5 s\"\n",
      contact);
}

/// The lines to be pasted: of the form `  name = value`.
std::string pasted(const std::string& printed) {
  std::istringstream lines{printed};
  std::string contact;
  for (std::string line; std::getline(lines, line);) {
    for (const char* key : {"  stiffness = ", "  damping = ", "  end_rule = "})
      if (line.starts_with(key)) contact += line.substr(2) + '\n';
  }
  return contact;
}

double restitution_of_run(const std::string& file) {
  const Ended ended = talus_ran({"run", file, "--json"});
  BOOST_REQUIRE(ended.code == 0);
  BOOST_TEST(ended.err.empty(), ended.err);
  const auto summary = nlohmann::json::parse(ended.out);
  return -summary.at("bodies").at(0).at("velocity").at(0).get<double>() / 5.0;
}

}  // namespace

BOOST_AUTO_TEST_CASE(the_printed_lines_give_the_restitution) {
  for (const char* rule : {"", "clamped", "attractive"}) {
    std::vector<std::string> arguments{"calibrate",   "--restitution", "0.6",     "--masses", "2 kg",
                                       "--stiffness", "1e6 N/m",       "--speed", "5 m/s"};
    if (*rule != '\0') arguments.insert(arguments.end(), {"--end-rule", rule});
    const Ended ended = talus_ran(arguments);
    BOOST_REQUIRE(ended.code == 0);
    const std::string contact = pasted(ended.out);
    BOOST_TEST(holds(contact, fmt::format("end_rule = \"{}\"", *rule == '\0' ? "clamped" : rule)));
    const Folder folder;
    BOOST_TEST(restitution_of_run(folder.file("wall.toml", wall_scene(contact)).string()) == 0.6,
               boost::test_tools::tolerance(1e-6));
    // The end rule belongs to the damping: with the other rule the restitution differs.
    const std::string other = holds(contact, "clamped") ? "attractive" : "clamped";
    const std::string changed = contact.substr(0, contact.find("end_rule")) + fmt::format("end_rule = \"{}\"\n", other);
    BOOST_TEST(std::abs(restitution_of_run(folder.file("other.toml", wall_scene(changed)).string()) - 0.6) > 0.02);
  }
}

// JSON is in SI; text, and the lines to be pasted, in the units of the scene.
BOOST_AUTO_TEST_CASE(json_of_a_scene_in_other_units_is_in_si) {
  std::string text = wall_scene("stiffness = \"1e6 N/m\"\nrestitution = 0.6\n");
  const auto calibrated = [](const std::string& file) {
    return nlohmann::json::parse(
        talus_ran({"calibrate", file, "--contact", "hit", "--restitution", "0.6", "--json"}).out);
  };
  const Folder folder;
  const auto in_si = calibrated(folder.file("si.toml", text).string());
  const std::string units = "units = \"SI\"";
  text.replace(text.find(units), units.size(), "units = \"US\"");
  const auto in_us = calibrated(folder.file("us.toml", text).string());
  BOOST_TEST(in_us.at("units") == "SI");
  for (const char* number : {"damping", "damping_ratio", "largest_overlap", "step", "restitution"})
    BOOST_TEST(in_us.at(number).get<double>() == in_si.at(number).get<double>(), boost::test_tools::tolerance(1e-6));
  // Counted in whole steps: a contact that begins at the end of a step may have one more.
  const double apart = in_us.at("contact_time").get<double>() - in_si.at("contact_time").get<double>();
  BOOST_TEST(std::abs(apart) < 1.001 * in_si.at("step").get<double>());
}

// The damping ratio of an impact, not that of the spring at some overlap.
BOOST_AUTO_TEST_CASE(damping_ratio_of_a_scene_is_that_of_its_impacts) {
  const std::string law = "law = \"hertz\"\nmodulus = \"1 GPa\"\nradius = \"0.1 m\"\nrestitution = 0.6\n";
  const Folder folder;
  const auto calibrated = [&](const std::string& lines) {
    std::string text = wall_scene(lines);
    const std::string linear = "law = \"linear_spring_dashpot\"\n";
    text.erase(text.find(linear), linear.size());
    return nlohmann::json::parse(talus_ran({"calibrate", folder.file("wall.toml", text).string(), "--contact", "hit",
                                            "--restitution", "0.6", "--json"})
                                     .out);
  };
  BOOST_TEST(calibrated(law).at("damping_ratio").get<double>() == talus::damping_ratio(0.6, talus::EndRule::clamped),
             boost::test_tools::tolerance(1e-6));
  // That of a constant dashpot depends on the speed.
  BOOST_TEST(!calibrated(law + "dashpot = \"constant\"\nrestitution_speed = \"1 m/s\"\n").contains("damping_ratio"));
}

// With e = 0.9 the clamped contact takes 2 acos(xi)/sqrt(k/m) = 2.173 ms, 108.7 steps; it is counted in steps of the
// scene, not in its outputs.
BOOST_AUTO_TEST_CASE(contact_time_of_a_scene_is_in_seconds_and_in_its_steps) {
  const Folder folder;
  const auto calibrated = [&](const std::string& run, std::vector<std::string> more) {
    const std::string scene = wall_scene("stiffness = \"4e6 N/m\"\nrestitution = 0.9\n") + run;
    std::vector<std::string> arguments{"calibrate", folder.file("wall.toml", scene).string()};
    arguments.insert(arguments.end(), {"--contact", "hit", "--restitution", "0.9"});
    arguments.insert(arguments.end(), more.begin(), more.end());
    return talus_ran(arguments).out;
  };
  const std::string ten_steps = "step = \"20 us\"\ninterval = \"200 us\"\nintegrator = \"velocity_verlet\"\n";
  const auto json = nlohmann::json::parse(calibrated(ten_steps, {"--json"}));
  const long steps = json.at("contact_steps").get<long>();
  BOOST_TEST((steps == 109 || steps == 110), steps);
  BOOST_TEST(json.at("contact_time").get<double>() == 2e-5 * static_cast<double>(steps),
             boost::test_tools::tolerance(1e-9));
  const std::string text = calibrated(ten_steps, {});
  BOOST_TEST(holds(text, fmt::format(" s: {} steps, from the last one before the contact to the first", steps)), text);
  BOOST_TEST(holds(text, "2e-05 s, of the scene\n"), text);
  const std::string chosen = calibrated("step = \"20 us\"\nintegrator = \"odeint_dopri5\"\ntolerance = 1e-9\n", {});
  BOOST_TEST(holds(chosen, "2e-05 s, of the scene: times at which the method gives states"), chosen);
}

BOOST_AUTO_TEST_CASE(an_impact_that_a_run_refuses_is_not_calibrated) {
  const Folder folder;
  const std::string soft = "stiffness = \"200 N/m\"\nrestitution = 0.6\n";
  const std::string file = folder.file("soft.toml", wall_scene(soft)).string();
  const Ended run = talus_ran({"run", file});
  const Ended calibrated = talus_ran({"calibrate", file, "--contact", "hit", "--restitution", "0.6"});
  BOOST_TEST(run.code == 3);
  BOOST_TEST(calibrated.code == 2);
  BOOST_TEST(calibrated.out.empty());
  const std::size_t offset = run.err.find("overlap");
  BOOST_REQUIRE(offset != std::string::npos);
  BOOST_TEST(holds(calibrated.err, "overlap"), calibrated.err);
}

// A panel for each quantity that differs between the pairs, with the restitution wanted and its largest deviations.
BOOST_AUTO_TEST_CASE(a_range_of_calibrated_pairs_is_drawn) {
  const Folder folder;
  const Requested requested{{"calibrate",   "--law",     "hertz",
                             "--dashpot",   "constant",  "--restitution",
                             "0.7",         "--modulus", "1 GPa",
                             "--speeds",    "0.1 m/s",   "10 m/s",
                             "3",           "--radii",   "1 mm",
                             "5 mm",        "2",         "--density",
                             "2500 kg/m^3", "--out",     folder.path.string(),
                             "--format",    "svg",       "--units",
                             "US"}};
  BOOST_TEST(requested.request.target == folder.path);
  BOOST_TEST((requested.request.formats == std::vector<std::string>{"svg"}));
  BOOST_TEST(requested.request.lists_files);
  BOOST_TEST(requested.page().name == "calibration");
  BOOST_TEST(holds(requested.page().title, "hertz, constant dashpot, clamped end rule, damping = "));
  BOOST_REQUIRE(requested.page().panels.size() == 3U);
  const std::vector<std::string> labels{"sphere radius", "speed", "effective mass"}, units{"ft", "ft/s", "slug"};
  for (std::size_t i = 0; i < 3; ++i) {
    const talus::records::Figure& panel = requested.panel(i);
    BOOST_TEST(panel.x.label == labels[i]);
    BOOST_TEST(panel.x.unit == units[i]);
    BOOST_TEST(panel.x.log == (i > 0));  // five times the radius, a hundred times the speed, 125 times the mass
    BOOST_TEST(panel.y.label == "restitution");
    BOOST_REQUIRE(panel.series.size() == 1U);
    BOOST_TEST(panel.series[0].x.size() == 6U);
    const auto [smallest, largest] = std::minmax_element(panel.series[0].y.begin(), panel.series[0].y.end());
    BOOST_REQUIRE(panel.lines.size() == 3U);
    BOOST_TEST(panel.lines[0].at == 0.7);
    BOOST_TEST(panel.lines[1].at == *smallest, boost::test_tools::tolerance(1e-12));
    BOOST_TEST(panel.lines[2].at == *largest, boost::test_tools::tolerance(1e-12));
  }
  BOOST_TEST(requested.panel(1).series[0].x[1] == 1.0 / 0.3048, boost::test_tools::tolerance(1e-12));
  // Equal pairs have a panel, too.
  const fs::path file = folder.file("pairs.csv", "mass_2 [kg]\n2\n2\n");
  const Requested equal{{"calibrate", "--restitution", "0.7", "--stiffness", "1 N/m", "--pairs", file.string(), "--out",
                         folder.path.string(), "--json"}};
  BOOST_REQUIRE(equal.page().panels.size() == 1U);
  BOOST_TEST(equal.panel(0).x.label == "effective mass");
  BOOST_TEST(!equal.request.lists_files);
}

// A panel for each result, against the angle in degrees.
BOOST_AUTO_TEST_CASE(rebounds_at_several_angles_are_drawn) {
  const Folder folder;
  const Requested requested{{"calibrate", "--restitution", "0.8", "--masses", "1 g", "--stiffness", "1e9 N/m",
                             "--spheres", "1 cm", "--friction", "0.1", "--angles", "70 deg", "80 deg", "3", "--out",
                             folder.path.string(), "--format", "svg"}};
  BOOST_TEST(requested.page().name == "calibration");
  BOOST_TEST(holds(requested.page().title, "linear_spring_dashpot, clamped end rule; linear friction 0.1"));
  BOOST_REQUIRE(requested.page().panels.size() == 4U);
  const std::vector<std::string> labels{"tangential restitution", "rotational restitution", "rebound angle", "spin"},
      units{"", "", "deg", "rad/s"};
  for (std::size_t i = 0; i < 4; ++i) {
    const talus::records::Figure& panel = requested.panel(i);
    BOOST_TEST(panel.x.label == "angle");
    BOOST_TEST(panel.x.unit == "deg");
    BOOST_TEST(panel.y.label == labels[i]);
    BOOST_TEST(panel.y.unit == units[i]);
    BOOST_TEST(panel.lines.empty());
    BOOST_REQUIRE(panel.series.size() == 1U);
    BOOST_REQUIRE(panel.series[0].x.size() == 3U);
    for (std::size_t point = 0; point < 3; ++point)
      BOOST_TEST(panel.series[0].x[point] == 70.0 + 5.0 * static_cast<double>(point),
                 boost::test_tools::tolerance(1e-12));
  }
  // The contact slides throughout: e_t = 1 - mu (1 + e)/tan(angle).
  BOOST_TEST(requested.panel(0).series[0].y[2] == 1.0 - 0.18 / std::tan(80.0 * std::acos(-1.0) / 180.0),
             boost::test_tools::tolerance(1e-4));
}

BOOST_AUTO_TEST_CASE(wrong_oblique_calibrations) {
  const std::vector<std::string> base{"calibrate", "--restitution", "0.8", "--masses", "1 g", "--stiffness", "1e6 N/m"},
      body{"--spheres", "1 cm", "--angle", "10 deg"};
  const std::vector<std::pair<std::vector<std::string>, std::string>> wrong{
      {{"--friction", "0.1"}, "--friction: only oblique impacts use it; give --angle or --angles"},
      {{"--angle", "10 deg"},
       "--spheres: it is missing; give the radius of each body, e.g. --spheres \"1 cm\", or --discs"},
      {{"--angle", "10 deg", "--spheres", "1 cm", "2 cm"}, "--spheres: found 2 radii for 1 mass; give one for each"},
      {{"--angle", "90 deg", "--spheres", "1 cm"}, "--angle: found 90 deg; it must be in (0, 90) deg"},
      {{"--angle", "10 deg", "--spheres", "1 cm", "--pivot", "1 kg m^2", "1 m"},
       "--pivot and --offset: the bodies of an oblique impact are free and hit centrally; remove them"},
      {{"--angle", "10 deg", "--spheres", "1 cm", "--speeds", "1 m/s", "2 m/s", "2"},
       "--speeds: it gives a range of pairs, and an oblique impact has one pair; remove one of both"},
      {{"--angles", "10 deg", "20 deg", "2", "--spheres", "1 cm", "--tangential-restitution", "0.5"},
       "--angle: it is missing; give the angle of --tangential-restitution, e.g. --angle \"10 deg\""},
      {{"--out", "never"}, "--out: only the table of several angles is written to files; give --angles"},
      {{"--tangential-restitution", "1"}, "--tangential-restitution: found 1; it must be in (-1, 1)"},
      {{}, "--friction: it is missing; give e.g. --friction 0.3"},
      {{"--friction", "x"}, "--friction: found \"x\"; it must be a number >= 0"},
      {{"--friction", "0.1", "--shear-stiffness", "0 N/m"}, "--shear-stiffness: found \"0 N/m\"; it must be > 0"},
      {{"--friction", "0.1", "--shear-modulus", "1 Pa"},
       "--shear-modulus: the friction law 'linear' does not use this option; remove it"},
      {{"--friction", "0.1", "--shear-law", "mindlin"},
       "--shear-law: friction of linear_spring_dashpot 'mindlin' is not known; nearest: linear; known: linear"},
      {{"--friction", "0.1", "--shear-stiffness", "1 N/m", "--shear-damping", "1 N s/m", "--tangential-restitution",
        "0.5"},
       "--shear-damping: found with --tangential-restitution and all other parameters of the friction; leave out the "
       "one to be found"},
      {{"--friction", "0.1", "--tangential-restitution", "-0.5"},
       "--tangential-restitution: a tangential restitution of -0.5 is not reachable by shear_stiffness; at this angle "
       "it must be "}};
  for (const auto& [more, message] : wrong) {
    std::vector<std::string> arguments = base;
    const bool has_angle = std::ranges::any_of(more, [](const auto& text) { return text.starts_with("--angle"); });
    if (!has_angle && message.find("only oblique") == std::string::npos)
      arguments.insert(arguments.end(), body.begin(), body.end());
    arguments.insert(arguments.end(), more.begin(), more.end());
    const Ended ended = talus_ran(arguments);
    BOOST_TEST(ended.code == 2);
    BOOST_TEST(ended.err.starts_with("talus: " + message), ended.err);
    BOOST_TEST(ended.out.empty());
  }
  const Ended modulus =
      talus_ran({"calibrate", "--law", "hertz", "--restitution", "0.8", "--masses", "1 g", "--modulus", "1 GPa",
                 "--spheres", "1 cm", "--angle", "10 deg", "--friction", "0.1", "--shear-law", "mindlin"});
  BOOST_TEST(modulus.err == "talus: --shear-modulus: it is missing; give e.g. --shear-modulus \"1 N/m^2\"\n");
}

// Values of the closed forms (e = 0.5 needs xi = 0.2552756 clamped and 0.2154538 by Eq. 21), of the pivot's mass I/h^2,
// and the simulated e.
BOOST_AUTO_TEST_CASE(calibration_as_json) {
  const auto two = nlohmann::json::parse(
      talus_ran({"calibrate", "--restitution", ".5", "--masses", "3 kg", "6 kg", "--stiffness", "1e6 N/m", "--json"})
          .out);
  BOOST_TEST(two.at("effective_mass").get<double>() == 2.0, boost::test_tools::tolerance(1e-15));
  BOOST_TEST(two.at("end_rule").get<std::string>() == "clamped");
  BOOST_TEST(two.at("damping_ratio").get<double>() == 0.2552756, boost::test_tools::tolerance(1e-6));
  BOOST_TEST(two.at("damping").get<double>() == 2.0 * 0.2552756 * std::sqrt(2e6), boost::test_tools::tolerance(1e-6));
  BOOST_TEST(std::abs(two.at("restitution").get<double>() - 0.5) < 1e-3);
  const auto pivot =
      nlohmann::json::parse(talus_ran({"calibrate", "--restitution", ".5", "--masses", "1 kg", "--pivot", "8 kg m^2",
                                       "2 m", "--stiffness", "1e6 N/m", "--end-rule", "attractive", "--json"})
                                .out);
  BOOST_TEST(pivot.at("effective_mass").get<double>() == 2.0, boost::test_tools::tolerance(1e-15));
  BOOST_TEST(pivot.at("damping_ratio").get<double>() == 0.2154537620, boost::test_tools::tolerance(1e-6));
  BOOST_TEST(pivot.at("end_rule").get<std::string>() == "attractive");
  const auto offset =
      nlohmann::json::parse(talus_ran({"calibrate", "--restitution", ".5", "--masses", "1 kg", "--offset", "1 kg m^2",
                                       "1 m", "--stiffness", "1e6 N/m", "--json"})
                                .out);
  BOOST_TEST(offset.at("effective_mass").get<double>() == 0.5, boost::test_tools::tolerance(1e-15));
}

// The role of each body, and what its mass, inertia and arm make of it: 8 kg m^2/(2 m)^2 = 2 kg, 1/(1/6 + 16/8) kg =
// 0.4615 kg.
BOOST_AUTO_TEST_CASE(calibration_prints_the_roles_of_both_bodies) {
  const auto printed = [](std::vector<std::string> more) {
    more.insert(more.begin(), {"calibrate", "--restitution", ".5", "--stiffness", "1e6 N/m"});
    const Ended ended = talus_ran(more);
    BOOST_TEST(ended.code == 0, ended.err);
    return ended.out;
  };
  const auto line = [](const char* what, const char* value, const char* rest) {
    return fmt::format("  {:<32}{:>16} kg{}\n", what, value, rest);
  };
  const std::string first = line("body 1, free, hit centrally", "3", ": its mass");
  const std::string wall = printed({"--masses", "3 kg"});
  BOOST_TEST(holds(wall, "\n  body 1, fixed\n" + line("body 2, free, hit centrally", "3", ": its mass")), wall);
  const std::string pinned = printed({"--masses", "3 kg", "6 kg", "--pivot", "8 kg m^2", "2 m"});
  BOOST_TEST(holds(pinned, first + line("body 2, on a fixed pin", "2", ": inertia/arm^2, whatever its mass") +
                               line("effective mass", "1.2", "")),
             pinned);
  const std::string offset = printed({"--masses", "3 kg", "6 kg", "--offset", "8 kg m^2", "4 m"});
  BOOST_TEST(holds(offset, first + line("body 2, free, hit off centre", "0.461538462", ": 1/(1/mass + arm^2/inertia)")),
             offset);
  const std::string latching = printed(
      {"--law", "latching_spring", "--step", "10 us", "--masses", "3 kg", "6 kg", "--pivot", "8 kg m^2", "2 m"});
  BOOST_TEST(holds(latching, first + line("body 2, on a fixed pin", "2", ": inertia/arm^2, whatever its mass")),
             latching);
  const std::string help = talus_ran({"calibrate", "--help"}).out;
  BOOST_TEST(holds(help, "a single mass is that of body 2, and body 1 is fixed"), help);
  BOOST_TEST(holds(help, "body 2 turns about a fixed pin"), help);
}

// w1 h = sqrt(1.7e4/3.6e-7) 1e-7 = 0.021731: e of 0.45 by euler is 0.67082 exp[(pi/4) 0.021731 (1 + 1/0.67082)] =
// 0.70001.
BOOST_AUTO_TEST_CASE(calibration_of_a_latching_spring) {
  const auto found = nlohmann::json::parse(talus_ran({"calibrate", "--law", "latching_spring", "--restitution", ".7",
                                                      "--step", "1e-7", "--integrator", "euler", "--json"})
                                               .out);
  BOOST_TEST(found.at("default_discs").get<bool>());
  BOOST_TEST(std::abs(found.at("loading_angle").get<double>() - 0.021731) < 1e-6);
  BOOST_TEST(std::abs(found.at("ratio_by_formula").get<double>() - 0.45) < 5e-4);
  BOOST_TEST(std::abs(found.at("ratio_by_simulation").get<double>() - 0.45) < 5e-4);
  BOOST_TEST(std::abs(found.at("restitution").get<double>() - 0.7) < 1e-9);
  const auto verlet =
      nlohmann::json::parse(talus_ran({"calibrate", "--law", "latching_spring", "--restitution", ".7", "--step", "1 ms",
                                       "--masses", "2 kg", "2 kg", "--stiffness", "900 N/m", "--json"})
                                .out);
  BOOST_TEST(verlet.at("ratio_by_formula").get<double>() == 0.49, boost::test_tools::tolerance(1e-14));
  BOOST_TEST(std::abs(verlet.at("ratio_by_simulation").get<double>() - 0.49) < 1e-4);
  BOOST_TEST(verlet.at("largest_overlap").get<double>() == 1.0 / 30.0, boost::test_tools::tolerance(1e-14));
  const Ended text =
      talus_ran({"calibrate", "--law", "latching_spring", "--restitution", ".7", "--step", "1e-7", "--units", "US"});
  BOOST_TEST(text.code == 0);
  BOOST_TEST(holds(text.out, "K1/K2 by simulation"));
  BOOST_TEST(holds(text.out, "slug"));
  BOOST_TEST(holds(text.out, "are Talus's own choice"));
}

BOOST_AUTO_TEST_CASE(calibration_of_a_scene) {
  const auto found = nlohmann::json::parse(
      talus_ran({"calibrate", scene("two_cable.toml"), "--contact", "impact", "--restitution", ".6", "--json"}).out);
  BOOST_TEST(std::abs(found.at("restitution").get<double>() - 0.6) < 1e-5);
  for (const char* key : {"damping", "damping_ratio", "contact_time", "largest_overlap", "step"})
    BOOST_TEST(found.at(key).get<double>() > 0.0);
}

BOOST_AUTO_TEST_SUITE_END()
