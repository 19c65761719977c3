#include <fmt/format.h>

#include <algorithm>
#include <boost/test/unit_test.hpp>
#include <cmath>
#include <filesystem>
#include <set>
#include <sstream>

#include "tests/solver/app/program.hpp"

BOOST_AUTO_TEST_SUITE(check_tests)

// `talus check` compared with the runs that it describes: the size of their output, and their warnings.

namespace {

/// A disc of 1 kg and radius 0.5 m over a floor: with all contacts closed its frequency is 100 rad/s.
std::string disc(double height, std::string_view run, std::string_view contact = "") {
  return fmt::format(R"(units = "SI"
[[body]]
name = "disc"
mobility = "free"
mass = "1 kg"
inertia = "0.125 kg m^2"
shape = {{ kind = "circle", radius = "0.5 m" }}
position = ["0 m", "{} m"]
[[body]]
name = "floor"
mobility = "fixed"
shape = {{ kind = "half_plane" }}
position = ["0 m", "0 m"]
[[contact]]
name = "landing"
between = ["disc", "floor"]
law = "linear_spring_dashpot"
stiffness = "1e4 N/m"
damping = "0 N s/m"
{}
[run]
{}
)",
                     height, contact, run);
}

std::set<std::string> lines_of(const std::string& text) {
  std::set<std::string> lines;
  std::istringstream in{text};
  for (std::string line; std::getline(in, line);)
    lines.insert(line);
  return lines;
}

/// Output of a run that `talus check` predicts.
struct Expected {
  long rows{}, columns{}, states{};
  double bytes{};
};
Expected expected_of(const std::string& checked) {
  const std::string expected = "expected output of --out";
  const std::size_t at = checked.find(expected);
  BOOST_REQUIRE(at != std::string::npos);
  Expected found;
  std::string unit, word;
  std::istringstream in{checked.substr(at + expected.size() + (checked[at + expected.size()] == ':' ? 1 : 0))};
  in >> found.rows >> word >> word >> word >> found.columns;
  const std::string line = checked.substr(at, checked.find('\n', at) - at);
  if (const std::size_t states = line.find("columns, "); line.find("states") != std::string::npos)
    found.states = std::stol(line.substr(states + 9));
  std::istringstream size{line.substr(line.find("about ") + 6)};
  size >> found.bytes >> unit;
  found.bytes *= unit.starts_with("kB") ? 1e3 : unit.starts_with("MB") ? 1e6 : 1e9;
  return found;
}

/// Runs a scene into a folder and compares its output with the prediction.
void check_output(const std::string& file, const std::string& command, const std::string& states) {
  const Folder folder;
  const Ended checked = talus_ran({"check", file});
  BOOST_REQUIRE(checked.code == 0);
  const Expected expected = expected_of(checked.out);
  BOOST_REQUIRE(talus_ran({command, file, "--out", folder.path.string()}).code == 0);
  double bytes = 0.0;
  long found_states = 0;
  for (const auto& [name, text] : files(folder.path)) {
    bytes += static_cast<double>(text.size());
    found_states += name.find(states) != std::string::npos ? 1 : 0;
  }
  const std::string history = talus::read_text(folder.path / "history.csv");
  const std::string head = history.substr(0, history.find('\n'));
  BOOST_TEST_CONTEXT(file) {
    BOOST_TEST(expected.rows == std::count(history.begin(), history.end(), '\n') - 1);
    BOOST_TEST(expected.columns == std::count(head.begin(), head.end(), ',') + 1);
    BOOST_TEST(expected.states == found_states);
    BOOST_TEST(std::abs(expected.bytes / bytes - 1.0) <= 0.2, expected.bytes << " bytes expected, " << bytes);
  }
}

}  // namespace

BOOST_AUTO_TEST_CASE(expected_output_of_scenes) {
  for (const char* const name : {"two_cable.toml", "pendulum.toml", "pivoted_cylinder.toml", "damped_disc.toml"})
    check_output(scene(name), "run", "_geometry/");
  const Folder folder;
  const std::string run = "integrator = \"velocity_verlet\"\nstep = \"0.3 ms\"\nend = \"0.4 s\"\ninterval = \"1 ms\"\n";
  check_output(folder.file("uneven.toml", disc(1.0, run)).string(), "run", "_geometry/");
  check_output(folder.file("off.toml", disc(1.0, run + "ledger = \"off\"")).string(), "run", "_geometry/");
}

BOOST_AUTO_TEST_CASE(expected_output_of_fences) {
  for (const char* const name : {"fence/sample2.DAT", "fence/table_2.toml", "fence/appendix_two_layers.toml"})
    check_output(scene(name), "run", "_geometry/");
  const Folder folder;
  check_output(folder.file("new.toml", talus_ran({"new", "fence"}).out).string(), "run", "_geometry/");
}

BOOST_AUTO_TEST_CASE(expected_output_of_cells) {
  for (const char* const name : {"cell/ice.toml", "cell/rough.toml", "cell/spheres.toml", "cell/CNTRL.DAT"})
    check_output(scene(name), "cell", "cell_states/");
  const Folder folder;
  check_output(folder.file("new.toml", talus_ran({"new", "cell"}).out).string(), "cell", "cell_states/");
}

BOOST_AUTO_TEST_CASE(histories_that_a_run_refuses) {
  const Folder folder;
  std::string text = talus::read_text(scene("fence/sample2.toml"));
  const std::size_t at = text.find("35, 36]");
  BOOST_REQUIRE(at != std::string::npos);
  const std::string file = folder.file("s.toml", text.replace(at, 7, "35, 39]")).string();
  const Ended checked = talus_ran({"check", file});
  BOOST_TEST(checked.code == 0);
  BOOST_TEST(holds(checked.err, "warning: talus run --out refuses this file: history_codes (variab): found 39"));
  const Ended ran = talus_ran({"run", file, "--out", (folder.path / "out").string()});
  BOOST_TEST(ran.code == 2);
  BOOST_TEST(holds(ran.err, "history_codes (variab): found 39"));
}

// A closed contact vibrates at 100 rad/s; the limit of velocity_verlet is 2/100 s.
BOOST_AUTO_TEST_CASE(the_verdict_on_the_step_is_that_of_the_run) {
  const Folder folder;
  const auto warnings = [&](double step, std::string_view command) {
    const std::string run = fmt::format("integrator = \"velocity_verlet\"\nstep = \"{} s\"\nend = \"0.2 s\"\n", step);
    const std::string file = folder.file("s.toml", disc(5.0, run)).string();
    const Ended ended = talus_ran({std::string{command}, file});
    BOOST_TEST(ended.code == (command == "check" && step > 0.02 ? 7 : 0));
    if (command == "check") BOOST_TEST(holds(ended.out, "TOO LONG") == (step > 0.02));
    return lines_of(ended.err);
  };
  const auto below = warnings(0.99 * 0.02, "check"), beyond = warnings(1.01 * 0.02, "check");
  BOOST_TEST(below.empty());
  BOOST_REQUIRE(beyond.size() == 1U);
  BOOST_TEST(holds(*beyond.begin(), "warning: h omega = 2.02 > 2, the linear limit of velocity_verlet"));
  BOOST_TEST((below == warnings(0.99 * 0.02, "run")));
  BOOST_TEST((beyond == warnings(1.01 * 0.02, "run")));
}

// 1/20 of the limit is 1 ms; 1/200 of the contact time, pi/100 s, is shorter.
BOOST_AUTO_TEST_CASE(the_automatic_step_is_what_the_help_says) {
  const Folder folder;
  BOOST_TEST(holds(talus_ran({"run", "--help"}).out, "1/20"));
  BOOST_TEST(holds(talus_ran({"run", "--help"}).out, "1/200"));
  const std::string run = "integrator = \"velocity_verlet\"\nstep = \"1 ms\"\nend = \"0.01 s\"\n";
  const std::string file = folder.file("s.toml", disc(5.0, run)).string();
  BOOST_TEST(holds(talus_ran({"run", file, "--step", "auto"}).out, ", step 0.00015708 s"));
  // Without contacts only the limit counts.
  const std::string hung = scene("cable_pendulum.toml");
  const Ended checked = talus_ran({"check", hung}), ended = talus_ran({"run", hung, "--step", "auto"});
  const auto number_after = [](const std::string& text, const std::string& expected) {
    return std::stod(text.substr(text.find(expected) + expected.size()));
  };
  BOOST_TEST(number_after(ended.out, ", step ") == number_after(checked.out, ", a step of ") / 20.0,
             boost::test_tools::tolerance(1e-5));
}

BOOST_AUTO_TEST_CASE(overlaps_at_the_start) {
  const Folder folder;
  const std::string run = "integrator = \"stormer_cowell\"\nend = \"0.01 s\"\n";
  const auto ended = [&](std::string_view command, double height, std::string_view contact) {
    return talus_ran({std::string{command}, folder.file("s.toml", disc(height, run, contact)).string()});
  };
  for (const std::string contact : {"", "method = \"nodes\"\nnodes = 12"}) {
    // Overlaps of 4 % of the radius, 0.2 %, none.
    const Ended large = ended("check", 0.48, contact), small = ended("check", 0.499, contact);
    const std::string expected =
        "contact 'landing' overlaps by 0.02 m at the start, 4 % of half the width of its smaller";
    BOOST_TEST(holds(large.out, "overlaps at the start 1\n  " + expected));
    BOOST_TEST(holds(large.err, "warning: " + expected));
    BOOST_TEST(large.err == ended("run", 0.48, contact).err);
    BOOST_TEST(holds(small.out, "overlaps by 0.001 m at the start, 0.2 %"));
    BOOST_TEST(small.err == "");
    BOOST_TEST(ended("run", 0.499, contact).err == "");
    for (const double height : {0.5, 0.6, 5.0}) {
      const Ended none = ended("check", height, contact);
      BOOST_TEST(!holds(none.out, "overlap"));
      BOOST_TEST(none.err == "");
    }
  }
}

// The record contains the warning too, once.
BOOST_AUTO_TEST_CASE(a_run_warns_of_overlaps_at_its_start) {
  const Folder folder;
  const std::string run = "integrator = \"stormer_cowell\"\nend = \"0.01 s\"\n";
  const std::string file = folder.file("s.toml", disc(0.45, run)).string(), out = (folder.path / "out").string();
  const Ended ended = talus_ran({"run", file, "--out", out});
  BOOST_TEST(ended.code == 0);
  BOOST_TEST(lines_of(ended.err).size() == 1U);
  BOOST_TEST(std::count(ended.err.begin(), ended.err.end(), '\n') == 1);
  BOOST_TEST(holds(talus::read_text(out + "/summary.json"), "overlaps by 0.05 m at the start, 10 %"));
}

// A step beyond its limit is an error of the check, as the results of the run are not usable; a run with the rules
// of 1993 must reproduce the errors of its step.
BOOST_AUTO_TEST_CASE(a_step_beyond_its_limit_has_an_exit_code) {
  const Folder folder;
  const std::string run = "integrator = \"velocity_verlet\"\nend = \"0.2 s\"\n";
  BOOST_TEST(talus_ran({"check", folder.file("s.toml", disc(0.6, run + "step = \"19 ms\"\n")).string()}).code == 0);
  const std::string beyond = run + "step = \"21 ms\"\n";
  BOOST_TEST(talus_ran({"check", folder.file("b.toml", disc(0.6, beyond)).string()}).code == 7);
  const std::string accepted = beyond + "watch = { quality = \"warning\" }\n";
  BOOST_TEST(talus_ran({"check", folder.file("a.toml", disc(0.6, accepted)).string()}).code == 0);
  const Ended deck = talus_ran({"check", scene("fence/sample2.DAT")});
  BOOST_TEST(deck.code == 0);
  BOOST_TEST(holds(deck.out, "TOO LONG"));
}

// A ball over the middle of a beam that is pinned there has its own mass of 2 kg; at an end of the beam, 1 m from the
// pin, it has 1/(1/2 + 1/1) = 2/3 kg, and contacts are shorter by sqrt(3).
BOOST_AUTO_TEST_CASE(effective_masses_hold_for_a_position) {
  const Folder folder;
  const auto beam = [&](const std::string& step) {
    return folder
        .file("beam.toml", fmt::format(R"(units = "SI"
[[body]]
name = "ball"
mobility = "particle"
mass = "2 kg"
shape = {{ kind = "circle", radius = "0.1 m" }}
position = ["0 m", "1 m"]
[[body]]
name = "beam"
mobility = "pinned"
mass = "3 kg"
inertia = "1 kg m^2"
pin = ["0 m", "0 m"]
shape = {{ kind = "rectangle", half_width = "1 m", half_height = "0.1 m" }}
position = ["0 m", "0 m"]
[[contact]]
name = "landing"
between = ["ball", "beam"]
law = "linear_spring_dashpot"
stiffness = "2e6 N/m"
damping = "0 N s/m"
[run]
integrator = "velocity_verlet"
step = "{}"
end = "1 s"
)",
                                       step))
        .string();
  };
  const Ended fine = talus_ran({"check", beam("10 us")});
  BOOST_TEST(fine.err == "");
  BOOST_TEST(holds(fine.out, "\n  landing              2e+06           0           2        1000 "), fine.out);
  BOOST_TEST(
      holds(fine.out, "\n  landing            0.66667           2         1732.1     0.0018138         181.38\n"),
      fine.out);
  BOOST_TEST(holds(fine.out, "\n  shortest contact: 0.0018138 s, 181.4 steps"), fine.out);
  // 1.5 ms is below 2/1000 s, and above 2/1732 s.
  const Ended coarse = talus_ran({"check", beam("1.5 ms")});
  BOOST_TEST(coarse.code == 0);
  BOOST_TEST(holds(coarse.err,
                   "warning: contact 'landing' can act with an effective mass of 0.6667 kg, less than at the "
                   "start: the step is then 1.3 times the linear limit of velocity_verlet"),
             coarse.err);
}

// Two bodies without a contact pass through each other: the check names the pair, and warns if they overlap at the
// start; the run warns when they come to overlap.
BOOST_AUTO_TEST_CASE(bodies_without_a_contact) {
  const Folder folder;
  const std::string run = "integrator = \"velocity_verlet\"\nstep = \"1 ms\"\nend = \"0.4 s\"\n";
  const auto two = [&](double x, double speed, const std::string& watch) {
    std::string text = disc(1.0, run + watch);
    const std::string post = fmt::format(
        "[[body]]\nname = \"post\"\nmobility = \"fixed\"\nshape = {{ kind = \"circle\", radius = \"0.5 m\" }}\n"
        "position = [\"{} m\", \"1 m\"]\n",
        x);
    text.insert(text.find("[[contact]]"), post);
    return text.insert(text.find("[[body]]\nname = \"floor"),
                       fmt::format("velocity = [\"{} m/s\", \"0 m/s\"]\n", speed));
  };
  const std::string expected =
      " of half the width of the smaller one, and no [[contact]] is declared between them: they pass through each "
      "other";
  const std::string apart = folder.file("apart.toml", two(3.0, 10.0, "")).string();
  const Ended checked = talus_ran({"check", apart});
  BOOST_TEST(checked.err == "");
  BOOST_TEST(
      holds(checked.out, "\npairs of bodies without a contact 1, which pass through each other: 'disc' and 'post'\n"),
      checked.out);
  // 2 m apart at 10 m/s: outlines meet at 0.2 s.
  const Ended met = talus_ran({"run", apart});
  BOOST_TEST(met.code == 0);
  BOOST_TEST(holds(met.err, "talus: warning: at t = 0.20"), met.err);
  BOOST_TEST(holds(met.err, " bodies 'disc' and 'post' overlap by "));
  BOOST_TEST(holds(met.err, expected));
  BOOST_TEST(std::ranges::count(met.err, '\n') == 1);
  const std::string inside = folder.file("inside.toml", two(0.9, 0.0, "")).string();
  const std::string said = "talus: warning: at the start bodies 'disc' and 'post' overlap by 20 %" + expected;
  BOOST_TEST(holds(talus_ran({"check", inside}).err, said));
  const Ended ran = talus_ran({"run", inside});
  BOOST_TEST(holds(ran.err, "talus: warning: at t = 0 bodies 'disc' and 'post' overlap by 20 %"));
  BOOST_TEST(std::ranges::count(ran.err, '\n') == 1);
  // The warning is known before the run: it is printed although the run then fails, as it cannot write its history.
  const std::filesystem::path out = folder.path / "out";
  std::filesystem::create_directories(out / "history.csv" / "in_the_way");
  const Ended failed = talus_ran({"run", inside, "--out", out.string()});
  BOOST_TEST(failed.code == 4);
  BOOST_TEST(holds(failed.err, "talus: warning: at t = 0 bodies 'disc' and 'post' overlap by 20 %"));
  const std::string off = folder.file("off.toml", two(0.9, 0.0, "watch = { missing_contacts = \"off\" }\n")).string();
  BOOST_TEST(talus_ran({"check", off}).err == "");
  BOOST_TEST(talus_ran({"run", off}).err == "");
  const std::string error =
      folder.file("error.toml", two(3.0, 10.0, "watch = { missing_contacts = \"error\" }\n")).string();
  BOOST_TEST(talus_ran({"run", error}).code == 3);
  BOOST_TEST(talus_ran({"check", error}).code == 0);
  // At the start: the check has the exit status of results that are not usable, whatever the rule of the quality.
  for (const std::string quality : {"error", "warning"}) {
    const std::string at_once =
        folder
            .file("at_once.toml",
                  two(0.9, 0.0, "watch = { missing_contacts = \"error\", quality = \"" + quality + "\" }\n"))
            .string();
    const Ended refused = talus_ran({"check", at_once});
    BOOST_TEST(refused.code == 7);
    BOOST_TEST(holds(refused.err, said));
    BOOST_TEST(talus_ran({"run", at_once}).code == 3);
  }
}

// A disc of 1 kg and radius 0.5 m has at most 0.25 kg m^2: both commands warn, and neither refuses it.
BOOST_AUTO_TEST_CASE(an_impossible_moment_of_inertia_is_a_warning) {
  const Folder folder;
  std::string text = disc(1.0, "integrator = \"velocity_verlet\"\nstep = \"1 ms\"\nend = \"10 ms\"\n");
  text.replace(text.find("0.125 kg"), 8, "0.3 kg");
  const std::string file = folder.file("disc.toml", text).string();
  for (const char* command : {"check", "run"}) {
    const Ended ended = talus_ran({command, file});
    BOOST_TEST(ended.code == 0);
    BOOST_TEST(
        ended.err ==
        "talus: warning: body 'disc': its moment of inertia, 0.3 kg m^2, is more than m R^2 = 0.25 kg m^2, that of "
        "its mass, 1 kg, at the largest distance of its outline from the centre of mass, 0.5 m\n");
  }
}

// Of 102 contacts, a hundred rows are printed: the first is that of the lightest one, the last beam of the scene.
BOOST_AUTO_TEST_CASE(the_worst_of_many_lighter_contacts_is_listed_first) {
  std::string text = "units = \"SI\"\n";
  for (int i = 1; i <= 102; ++i) {
    text += fmt::format(
        "[[body]]\nname = \"ball{0}\"\nmobility = \"particle\"\nmass = \"2 kg\"\n"
        "shape = {{ kind = \"circle\", radius = \"0.1 m\" }}\nposition = [\"{2} m\", \"1 m\"]\n"
        "[[body]]\nname = \"beam{0}\"\nmobility = \"pinned\"\nmass = \"3 kg\"\ninertia = \"{1} kg m^2\"\n"
        "pin = [\"0 m\", \"0 m\"]\nposition = [\"{2} m\", \"0 m\"]\n"
        "shape = {{ kind = \"rectangle\", half_width = \"1 m\", half_height = \"0.1 m\" }}\n"
        "[[contact]]\nname = \"hit{0}\"\nbetween = [\"ball{0}\", \"beam{0}\"]\nlaw = \"linear_spring_dashpot\"\n"
        "stiffness = \"1e4 N/m\"\ndamping = \"0 N s/m\"\n",
        i, i == 102 ? 0.5 : 1.0, 4 * i);
  }
  const Folder folder;
  // At the end of the beam 1/(1/2 + 1/0.5) = 0.4 kg; the step limit of velocity Verlet is 2 sqrt(m/k) = 12.6 ms.
  const std::string run = "[run]\nintegrator = \"velocity_verlet\"\nend = \"50 ms\"\nstep = \"13 ms\"\n";
  const Ended checked = talus_ran({"check", folder.file("beams.toml", text + run).string()});
  const std::size_t bounds =
      checked.out.find("Bounds over all positions in which the bodies touch, the worst first:\n");
  BOOST_REQUIRE(bounds != std::string::npos);
  const std::size_t worst = checked.out.find("\n  hit102 ", bounds), next = checked.out.find("\n  hit1 ", bounds);
  BOOST_TEST(worst < next);
  BOOST_TEST(next < std::string::npos);
  BOOST_TEST(holds(checked.err, "contact 'hit102' can act with an effective mass of 0.4 kg, less than at the start"),
             checked.err);
}

// 634 discs have 634 x 633/2 = 200661 pairs, more than are checked; 633 have 200028, and 632 have 199396.
BOOST_AUTO_TEST_CASE(pairs_that_are_too_many_to_check_are_reported_once) {
  const auto discs = [](int count) {
    std::string text = "units = \"SI\"\n";
    for (int i = 0; i < count; ++i)
      text += fmt::format(
          "[[body]]\nname = \"disc{}\"\nmobility = \"particle\"\nmass = \"1 kg\"\n"
          "shape = {{ kind = \"circle\", radius = \"1 m\" }}\nposition = [\"{} m\", \"0 m\"]\n",
          i, 3 * i);
    return text + "[run]\nend = \"1 ms\"\nstep = \"0.5 ms\"\nintegrator = \"velocity_verlet\"\n";
  };
  const Folder folder;
  const std::string many = folder.file("many.toml", discs(634)).string(),
                    few = folder.file("few.toml", discs(632)).string();
  const std::string warning = "talus: warning: more than 200000 pairs of bodies have no contact between them: their ";
  for (const std::string command : {"check", "run"}) {
    const std::string err = talus_ran({command, many}).err;
    BOOST_TEST(holds(err, warning), err);
    BOOST_TEST(err.find(warning) == err.rfind(warning), err);
    BOOST_TEST(!holds(talus_ran({command, few}).err, "pairs of bodies"));
  }
}

// Valid cases cause no warnings except about steps; for an implausible fence both commands print the same warnings.
BOOST_AUTO_TEST_CASE(unlikely_fences) {
  const Folder folder;
  for (const char* const name : {"fence/table_2.toml", "fence/table_3.toml"})
    BOOST_TEST(talus_ran({"check", scene(name)}).err == "");
  std::string text = talus_ran({"new", "fence"}).out;
  const auto change = [&](std::string_view from, std::string_view to) {
    const std::size_t at = text.find(from);
    BOOST_REQUIRE_MESSAGE(at != std::string::npos, from);
    text.replace(at, from.size(), to);
  };
  change("spacing = \"0.8 m\"", "spacing = \"0.6 m\"");
  change("position = [\"0 m\", \"-2 m\"]", "position = [\"0 m\", \"-1.4 m\"]");
  change("duration = \"0.8 s\"", "duration = \"5 ms\"");
  const std::string file = folder.file("f.toml", text).string();
  const Ended checked = talus_ran({"check", file}), ran = talus_ran({"run", file});
  BOOST_TEST(checked.code == 0);
  BOOST_TEST(holds(checked.err, "warning: spacing: columns of a width of 0.8 m have a spacing of 0.6 m"));
  BOOST_TEST(holds(checked.err, "warning: ground: it reaches 0.3 m into the columns"));
  const auto of_check = lines_of(checked.err), of_run = lines_of(ran.err);
  BOOST_TEST(std::ranges::includes(of_run, of_check), checked.err << "against\n" << ran.err);
}

BOOST_AUTO_TEST_SUITE_END()
