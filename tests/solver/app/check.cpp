#define BOOST_TEST_MODULE check
#include <fmt/format.h>

#include <algorithm>
#include <boost/test/unit_test.hpp>
#include <set>
#include <sstream>

#include "tests/solver/app/program.hpp"

// `talus check` against the runs that it speaks of: their warnings.

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

}  // namespace

// A contact that is closed vibrates at 100 rad/s; the limit of velocity_verlet is 2/100 s.
BOOST_AUTO_TEST_CASE(the_verdict_on_the_step_is_that_of_the_run) {
  const Folder folder;
  const auto warnings = [&](double step, std::string_view command) {
    const std::string run = fmt::format("integrator = \"velocity_verlet\"\nstep = \"{} s\"\nend = \"0.2 s\"\n", step);
    const std::string file = folder.file("s.toml", disc(5.0, run)).string();
    const Ended ended = talus_ran({std::string{command}, file});
    BOOST_TEST(ended.code == 0);
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

BOOST_AUTO_TEST_CASE(overlaps_at_the_start) {
  const Folder folder;
  const std::string run = "integrator = \"stormer_cowell\"\nend = \"0.01 s\"\n";
  const auto ended = [&](std::string_view command, double height, std::string_view contact) {
    return talus_ran({std::string{command}, folder.file("s.toml", disc(height, run, contact)).string()});
  };
  for (const std::string contact : {"", "method = \"nodes\"\nnodes = 12"}) {
    // 4 % of the radius; 0.2 %; none.
    const Ended large = ended("check", 0.48, contact), small = ended("check", 0.499, contact);
    const std::string words = "contact 'landing' overlaps by 0.02 m at the start, 4 % of half the width of its smaller";
    BOOST_TEST(holds(large.out, "overlaps at the start 1\n  " + words));
    BOOST_TEST(holds(large.err, "warning: " + words));
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

// The warning is in the record too, once.
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

// Sound cases have nothing to warn of but steps; an unlikely fence is warned of by both commands in the same words.
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
  BOOST_TEST(holds(checked.err, "warning: spacing: columns of a width of 0.8 m stand 0.6 m apart"));
  BOOST_TEST(holds(checked.err, "warning: ground: it reaches 0.3 m into the columns"));
  const auto of_check = lines_of(checked.err), of_run = lines_of(ran.err);
  BOOST_TEST(std::ranges::includes(of_run, of_check), checked.err << "against\n" << ran.err);
}
