#include "verification/problems/program/capacity/capacity_refusals.hpp"

#include <fmt/format.h>

#include <filesystem>
#include <string>
#include <vector>

#include "verification/problems/program/capacity/one_column.hpp"

namespace talus::verification::problems::fence_capacity {

namespace fs = std::filesystem;

void check_refusals(const Program& program, Differences& differ) {
  program.write("fence.toml", fence(guided));
  program.write("ball.toml", program.run({"new", "scene"}));
  std::string falling = fence("");
  falling.replace(falling.find("-5 m/s\", \"0 m/s"), 15, "0 m/s\", \"-5 m/s");
  program.write("falling.toml", falling);
  program.write("bad.csv", "mass [kg],speed [m/s]\n1,1\n");
  program.write("zero.csv", "mass [kg],speed [m/s],height [m]\n1,0,1\n");
  program.write("positions.csv", "mass [kg],speed [m/s],height [m],along [m]\n1,1,1,1\n");
  program.write("infinite.csv", "mass [kg],speed [m/s],height [m]\n1,1,inf\n");
  program.write("empty.csv", "mass [kg],speed [m/s],height [m]\n");
  program.write("own.toml", program.run({"new", "fence"}));
  const std::string mass = "mass = [\"1 kg\", \"2 kg\"]\n", speed = "speed = [\"1 m/s\", \"2 m/s\"]\n",
                    good = "base = \"fence.toml\"\n" + mass + speed;
  struct Wrong {
    std::string text, message;
    int exit_code{2};
  };
  const std::vector<Wrong> wrong{
      {"base = ", "wrong.toml:1: not TOML"},
      {mass + speed, "base: it is missing"},
      {"base = \"none.toml\"\n" + mass + speed, "none.toml: No such file", 4},
      {"base = \"ball.toml\"\n" + mass + speed, "ball.toml: it must be a fence, with a table [fence]"},
      {"base = \"falling.toml\"\n" + mass + speed,
       "rock: velocity: found none along x; it must move towards the fence"},
      {"base = \"fence.toml\"\n" + speed, "mass: it is missing"},
      {"base = \"fence.toml\"\nmass = [\"2 kg\", \"1 kg\"]\n" + speed,
       "wrong.toml:2: mass: found [\"2 kg\", \"1 kg\"]; both must be > 0"},
      {"base = \"fence.toml\"\nmass = [\"1 kg\", \"2 m\"]\n" + speed, "wrong.toml:2: mass[1]: "},
      {good + "height = []\n", "wrong.toml:4: height: found []; it must have a quantity"},
      {good + "height = [\"-1 m\"]\n", "wrong.toml:4: height[0]: found \"-1 m\"; it must be > 0"},
      {good + "height = [3]\n", "wrong.toml:4: height[0]: found 3; the unit is missing"},
      {good + "spin = [\"1 m\"]\n", "wrong.toml:4: spin[0]: "},
      {good + "along = \"1 m\"\n",
       "fence.toml: [fence.options]: symmetry: found \"half\"; it must be \"full\" for positions along the fence"},
      {good + "[changes]\nalong = \"1 m\"\n", "for positions along the fence"},
      {good + "[hazard]\ntable = \"positions.csv\"\n", "for positions along the fence"},
      {good + "[hazard]\ntable = \"positions.csv\"\nalong = \"1 m\"\n", "hazard: along: the rows of the table give it"},
      {good + "[hazard]\ntable = \"infinite.csv\"\n",
       "infinite.csv:2: column 'height [m]': found 'inf'; it must be a finite number"},
      {good + "[hazard]\nmass = \"1 kg\"\nspeed = \"1 m/s\"\nheight = \"1 m\"\nspin = [\"2 rad/s\", \"1 rad/s\"]\n",
       "hazard: spin: found [\"2 rad/s\", \"1 rad/s\"]; the first must be at most the second"},
      {good + "heigth = \"1 m\"\n", "wrong.toml:4: heigth: "},
      {good + "set = 3\n", "wrong.toml:4: set: it must be a table of fields"},
      {good + "set = { \"fence.colums\" = 3 }\n", "wrong.toml: set: fence.toml:4: fence: colums: "},
      {good + "set = { \"fence.rocks.a\" = 3 }\n", "wrong.toml: set: 'fence.rocks.a': field 'rocks' is not known"},
      {"base = \"own.toml\"\n" + mass + speed +
           "along = [\"-1.5 m\", \"0 m\"]\nset = { \"fence.options.symmetry\" = \"full\" }\n[changes]\nalong = \"50 "
           "m\"\n",
       "wrong.toml: along: own.toml:"},
      {"base = \"own.toml\"\n" + mass + speed +
           "set = { \"fence.options.symmetry\" = \"full\" }\n[hazard]\nmass = \"1 kg\"\nspeed = \"1 m/s\"\nheight = "
           "\"1 "
           "m\"\nalong = [\"-1 m\", \"50 m\"]\n",
       "along: found 50 m; it must be in front of the columns, within "},
      {good + "[map]\ncells = 24\nfirst_cells = 5\n",
       "found 24 cells, 5 at first; the first must be a power of two times the second"},
      {good + "[map]\ncells = 8\nfirst_cells = 16\n", "found 8 cells, 16 at first"},
      {good + "[map]\ncells = 10\nfirst_cells = 4\n", "found 10 cells, 4 at first"},
      {good + "[map]\nruns = 4\nfew_runs = 5\n",
       "wrong.toml:6: map: few_runs: found 5; it must be at most the runs of a node, 4"},
      {good + "[changes]\nspeed = 2\n", "changes: speed: found 2"},
      {good + "[changes]\nangle = \"1 m\"\n", "changes: angle: "},
      {good + "[hazard]\nmass = \"1 kg\"\nspeed = \"1 m/s\"\n", "hazard: height: it is missing"},
      {good + "[hazard]\nmass = \"1 kg\"\nheight = \"1 m\"\nspeed = { p95 = \"2 m/s\", p99 = \"1 m/s\" }\n",
       "found \"1 m/s\", less than the percentile of 95 %, \"2 m/s\""},
      {good + "[hazard]\ntable = \"bad.csv\"\n", "bad.csv: the column height is missing"},
      {good + "[hazard]\ntable = \"zero.csv\"\n", "zero.csv:2: column 'speed [m/s]': found '0'; it must be > 0"},
      {good + "[hazard]\ntable = \"empty.csv\"\n", "found no line below the header"},
      {good + "[hazard]\ntable = \"none.csv\"\n", "none.csv", 4},
      {good + "[hazard]\ntable = \"bad.csv\"\nmass = \"1 kg\"\n", "hazard: mass: the rows of the table give it"}};
  for (const Wrong& of : wrong) {
    program.write("wrong.toml", of.text);
    const ProgramEnd end = program.end({"capacity", "wrong.toml"});
    differ.ended("refusal: " + of.message, end, of.exit_code, of.message);
  }
  fs::create_directory(program.folder().path() / "other");
  program.write("other/base.toml", "");
  program.write("wrong.toml", good);
  const ProgramEnd other = program.end({"capacity", "wrong.toml"}, {{"--out", {"other"}}});
  differ.holds(
      "refusal: a folder of something else",
      other.exit_code == 2 &&
          other.messages.find("other: found base.toml of something else; give another folder") != std::string::npos &&
          program.read("other/base.toml").empty());
  differ.compare("nothing is written of a wrong question", program.has("wrong/sweep.json"), false);
  // A question whose runs all fail has an answer without boundary and probability.
  program.write("failing.toml", good +
                                    "[map]\ncells = 4\n[hazard]\nmass = \"1 kg\"\nspeed = \"1 m/s\"\nheight = "
                                    "\"1 m\"\nruns = 4\n[limits]\nevaluations = 1\n");
  const ProgramEnd failing = program.end({"capacity", "failing.toml"}, {{"--no-plots", {}}});
  differ.ended("a question whose runs all fail", failing, 3, "");
  for (const char* const text : {"  no boundary: no run finished\n", "  no probability of failure: no run finished\n",
                                 "  failed, for example: "})
    differ.contains("a question whose runs all fail", failing.output, text);
  for (const char* const text : {"below", "audit", "kinetic energy", "probability of failure per impact"})
    differ.compare(fmt::format("a question whose runs all fail: {}", text),
                   failing.output.find(text) == std::string::npos, true);
  const records::Json json = records::Json::parse(program.read("failing/capacity.json"));
  differ.holds("no boundary", json.at("maps").at(0).at("boundary").empty());
  differ.holds("no probability", json.at("hazard").at("probability_of_failure").is_null() &&
                                     json.at("hazard").at("interval").at(0).is_null());
}

}  // namespace talus::verification::problems::fence_capacity
