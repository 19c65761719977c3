#include "verification/problems/program/sweeps/sweep_refusals.hpp"

#include <algorithm>
#include <filesystem>
#include <string>
#include <vector>

#include "verification/study/program/program_run.hpp"

namespace talus::verification::problems::swept_scenes {
namespace {

struct Wrong {
  std::string text, message;
  bool is_one{};  ///< it has no other errors, as consequences
};

const std::string head = "base = \"ball.toml\"\noutputs = [\"ball.vx.end\"]\n",
                  mass = "[[axis]]\nfield = \"body.ball.mass\"\n", good = mass + "values = [\"1 kg\", \"2 kg\"]\n",
                  sobol = "[design]\nkind = \"sobol\"\nruns = 4\n";

std::vector<Wrong> wrong_sweeps() {
  return {
      {"base = ", "wrong.toml:1: not TOML"},
      {"bas = \"ball.toml\"\noutputs = [\"ball.vx.end\"]\n" + good, "wrong.toml:1: bas: "},
      {"outputs = [\"ball.vx.end\"]\n" + good, "base: it is missing"},
      {"base = \"none.toml_\"\noutputs = [\"ball.vx.end\"]\n" + good, "none.toml_: No such file"},
      {"base = \"ball.toml\"\n" + good, "outputs: it is missing; give quantities"},
      {"base = \"ball.toml\"\noutputs = []\n" + good, "wrong.toml:2: outputs: found []; it must be an array of texts"},
      {"base = \"ball.toml\"\noutputs = [3]\n" + good, "wrong.toml:2: outputs: found 3; it must be a text"},
      {"base = \"ball.toml\"\noutputs = [\"ball.vz.end\"]\n" + good,
       "wrong.toml:2: outputs: column 'ball.vz' is not known"},
      {"base = \"ball.toml\"\noutputs = [\"ball.vz.end\", \"ball.vx.max\", \"ball.vw.end\"]\n" + good,
       "\ntalus: wrong.toml:2: outputs: column 'ball.vw' is not known"},
      {"base = \"own.toml\"\noutputs = [\"rock.vx.end\"]\n" + sobol +
           "[[axis]]\nfield = \"fence.columns\"\nrange = [5, 9]\n[[axis]]\nfield = \"fence.restitution\"\nrange = [0, "
           "1]\n",
       "wrong.toml:9: axis 2: range: found whole numbers for 'fence.restitution', which takes others, too"},
      {"base = \"ball.toml\"\noutputs = [\"ball.vx\"]\n" + good, "outputs: found \"ball.vx\"; it must end in .max"},
      {"base = \"ball.toml\"\noutputs = [\"impact.hut[0].touch_time\"]\n" + good,
       "wrong.toml:2: outputs: contact 'hut' is not known; nearest: hit"},
      {"base = \"ball.toml\"\noutputs = [\"impact.hit[0].touch\"]\n" + good,
       "outputs: number of an impact 'touch' is not known"},
      {"base = \"ball.toml\"\noutputs = [\"ball.z.peak[0]\"]\n" + good, "outputs: column 'ball.z' is not known"},
      {"base = \"ball.toml\"\noutputs = [\"ball.x.peak\"]\n" + good,
       "outputs: found \"ball.x.peak\"; give a local maximum with its index from 0, ball.x.peak[0]"},
      {"base = \"ball.toml\"\noutputs = [\"ball.x.peak[99999999999999999999]\"]\n" + good,
       "outputs: found \"ball.x.peak[99999999999999999999]\"; give a local maximum with its index"},
      {"base = \"ball.toml\"\noutputs = [\"ball.x.peaks[-1]\"]\n" + good,
       "outputs: found \"ball.x.peaks[-1]\"; give a local maximum with its index"},
      {head, "axis: it is missing; give at least one [[axis]]"},
      {head + mass, "axis 1: values: give one of values, range and quantiles, or a table"},
      {head + "[[axis]]\nvalues = [1]\n", "axis 1: field: it is missing"},
      {head + "[[axis]]\nfield = \"body..mass\"\nvalues = [1]\n",
       "wrong.toml:4: axis 1: field: found 'body..mass'; it must be a path"},
      {head + "[[axis]]\nfield = \"body.bal.mass\"\nvalues = [\"1 kg\"]\n",
       "wrong.toml:3: axis 1: 'body.bal.mass': name 'bal' is not known"},
      {head + "[[axis]]\nfield = \"body.ball.velocity[2]\"\nvalues = [\"1 m/s\"]\n",
       "'body.ball.velocity[2]': 'velocity' has no element [2]; give one of its 2 elements"},
      {head + "[[axis]]\nfield = \"body.ball.mass[0]\"\nvalues = [\"1 kg\"]\n",
       "'mass' is not an array; give it without"},
      {head + "[[axis]]\nfield = \"body.ball.shape\"\nvalues = [\"1 m\"]\n", "found a table; it must be a value"},
      {head + "[[axis]]\nfield = \"body.ball.mass.low\"\nvalues = [\"1 m\"]\n", "nothing can be below 'mass'"},
      {head + mass + "values = []\n", "wrong.toml:5: axis 1: values: found []; it must be an array of values"},
      {head + mass + "values = [[1]]\n", "axis 1: values: found [1]; each must be a number, a text, true or false"},
      {head + mass + "values = [\"1 kg\"]\ncount = 3\n", "axis 1: count"},
      {head + mass + "range = [\"1 kg\", \"2 kg\"]\n",
       "axis 1: count: it is missing; a grid needs the number of points"},
      {head + mass + "range = [\"2 kg\", \"1 kg\"]\ncount = 2\n", "the first value must be less than the second"},
      {head + mass + "range = [\"1 kg\", \"2 g\"]\ncount = 2\n",
       "found \"2 g\" and a value in kg; give all in one unit"},
      {head + mass + "range = [\"1 kg\"]\ncount = 2\n", "it must be an array of two values"},
      {head + mass + "range = [\"1 kf\", \"2 kf\"]\ncount = 2\n",
       "axis 1: range: found \"1 kf\"; unit 'kf' is not known"},
      {head + mass + "range = [\"1 kg\", \"2 kg\"]\ncount = 1\n", "axis 1: count: found 1"},
      {head + mass + "range = [\"0 kg\", \"2 kg\"]\ncount = 2\nspacing = \"logarithmic\"\n",
       "axis 1: spacing: found \"logarithmic\" from 0 on; the values must be > 0"},
      {head + mass + "range = [\"1 kg\", \"2 kg\"]\ncount = 2\nspacing = \"log\"\n", "axis 1: spacing: "},
      {head + mass + "quantiles = [[0.1, \"1 kg\"], [1, \"2 kg\"]]\ncount = 2\n",
       "found probabilities from 0.1 to 1; they must be from 0 to 1"},
      {head + mass + "quantiles = [[0, \"1 kg\"], [0.5, \"3 kg\"], [1, \"2 kg\"]]\ncount = 2\n",
       "found [1, 2] after [0.5, 3]; probabilities and values must grow"},
      {head + mass + "quantiles = [[0, \"1 kg\"], [1]]\ncount = 2\n", "found [1]; it must be an array of pairs"},
      {head + good + good, "axis 2: field: 'body.ball.mass' is varied by two axes"},
      {head + "[[axis]]\nfield = \"run.step\"\nvalues = [\"1e-4 s\"]\ntable = \"t.csv\"\n", "axis 1: field"},
      {head + "[[axis]]\ntable = \"none.csv\"\ncolumns = { \"run.step\" = \"s\" }\n",
       "wrong.toml:3: axis: table: none.csv: No such file or directory"},
      {head + "[[axis]]\nfield = \"body.ball.offset[0]\"\nvalues = [\"1 m\"]\n",
       "the base has no 'offset', of which an element could be set"},
      {head + "[[axis]]\ntable = \"bad.csv\"\ncolumns = { \"run.step\" = \"h [s]\" }\n", "column 'h [s]' is not known"},
      {head + sobol + mass + "range = [\"1 kg\", \"2 kg\"]\ncount = 2\n", "axis 1: count: only a grid has it"},
      {head + "[design]\nkind = \"grid\"\nruns = 4\n" + good,
       "design: runs: a grid has every combination of the axes' points"},
      {head + mass + "range = [1, 9]\ncount = 3\nspacing = \"logarithmic\"\n",
       "axis 1: spacing: found \"logarithmic\" of whole numbers; write the range with decimals"},
      {head + mass + "range = [1, 3]\ncount = 4\n", "axis 1: count: found 4; there are 3 whole numbers in the range"},
      {head + mass + "range = [0, 9007199254740994]\ncount = 3\n", "whole numbers must be at most 2^53"},
      {head + mass + "values = [nan]\n", "axis 1: values: found nan; it must be finite"},
      {head + mass + "range = [1.0, inf]\ncount = 3\n", "axis 1: range: found inf; it must be finite"},
      {head + mass + "values = [\"1 kg\"]\ncolumns = { \"run.step\" = \"s\" }\n",
       "axis 1: columns: it names columns of a table; give `table`, too"},
      {"base = \"ball.toml\"\noutputs = [\"ball.vx.end\", \"ball.vx.end\"]\n" + good,
       "wrong.toml:2: outputs: found \"ball.vx.end\" twice"},
      {head + good +
           "[[axis]]\nfield = \"body.ball.velocity[0]\"\nvalues = [\"1 m/s\"]\n[[axis]]\nfield = "
           "\"body.ball.velocity[00]\"\nvalues = [\"1 m/s\"]\n",
       "'body.ball.velocity[0]' and 'body.ball.velocity[00]' are the same field"},
      {head + "[[axis]]\ntable = \"bad.csv\"\ncolumns = { \"run.step\" = \"step [sec]\" }\n",
       "unit 'sec' is not known"},
      {head + "[[axis]]\nfield = \"run.stepp\"\nvalues = [1, 2]\n",
       "wrong.toml: run 1 is refused, as are all that were tried: run.stepp = 1: ball.toml:"},
      {head + "[[axis]]\ntable = \"bad.csv\"\n", "axis 1: columns: it must be a table of fields with their headings"},
      {head + "[design]\nkind = \"sobel\"\nruns = 4\n" + mass + "range = [1.0, 2.0]\n", "design: kind: ", true},
      {head + "[desing]\nkind = \"sobol\"\nruns = 4\n" + mass + "range = [1.0, 2.0]\n", "nearest: design", true},
      {head + mass + "range = [1, 3]\ncount = 4\n", "or write the range with decimals, e.g. [0.0, 1.0]", true},
      {head + "[axis]\nfield = \"body.ball.mass\"\nvalues = [\"1 kg\"]\n",
       "wrong.toml:3: axis: found a table; each axis is a separate table, headed [[axis]]", true},
      {head + "[[design]]\nkind = \"sobol\"\n" + good,
       "wrong.toml:3: design: found [a table]; it must be a table, headed [design] in place of [[design]]"},
      {head + "[design]\nkind = \"sobol\"\n" + good, "design: runs: it is missing"},
      {head + "[design]\nkind = \"sobol\"\nruns = 0\n" + good, "design: runs: found 0"},
      {head + "[limits]\ntime = \"0 s\"\n" + good, "limits: time: found \"0 s\"; it must be > 0"},
      {head + "[limits]\nevaluations = 0\n" + good, "limits: evaluations: found 0"},
      {head + good + "[[constraint]]\nfield = \"body.ball.mss\"\nat_most = \"1 kg\"\n",
       "constraint 1: field: field that is varied 'body.ball.mss' is not known"},
      {head + good + "[[constraint]]\nfield = \"body.ball.mass\"\n", "give one of at_most and at_least"},
      {head + good + "[[constraint]]\nfield = \"body.ball.mass\"\nat_most = \"one\"\n",
       "at_most: found \"one\"; it must be a field that is varied, a number or a quantity"},
      {head + good + "[[constraint]]\nfield = \"body.ball.mass\"\nat_most = \"1 m\"\n",
       "wrong.toml:6: constraint 1: 'body.ball.mass' is a mass, and \"1 m\" is a length; give values of one dimension"},
      {head + good + "[[constraint]]\nfield = \"body.ball.mass\"\nat_most = \"0.1 kg\"\n",
       "wrong.toml:6: constraint: none of the 2 runs satisfies all"},
      {head + mass +
           "range = [\"1 kg\", \"2 kg\"]\ncount = 1000000\n[[axis]]\nfield = \"run.step\"\nvalues = [\"1e-4 s\", "
           "\"1e-5 s\"]\n",
       "found a grid of at least 2e+06 runs; it must be at most 1000000"},
  };
}

}  // namespace

void check_refusals(const Program& program, Differences& differ) {
  program.write("bad.csv", "step [s],step [sec]\n1,1\n");
  program.write("own.toml", program.run({"new", "fence"}));
  for (const Wrong& wrong : wrong_sweeps()) {
    program.write("wrong.toml", wrong.text);
    const ProgramEnd end = program.end({"sweep", "plan", "wrong.toml"});
    const int expected = wrong.message.find("No such file") != std::string::npos ? 4 : 2;
    differ.ended("refusal: " + wrong.message, end, expected, wrong.message);
    if (wrong.is_one) differ.compare("errors of: " + wrong.message, std::ranges::count(end.messages, '\n'), 1L);
  }
  differ.compare("nothing is written of a wrong sweep", program.has("wrong/sweep.json"), false);
  struct WrongCommand {
    std::vector<std::string> command;
    Options options;
    std::string message;
    int exit_code{2};
  };
  const std::vector<WrongCommand> commands{
      {{"sweep"}, {}, "a command is missing; known: plan, run, status, submit, collect"},
      {{"sweep", "run", "grid"}, {{"--shard", {"0/2"}}}, "--shard: found \"0/2\"; it must be I/N"},
      {{"sweep", "run", "grid"}, {{"--shard", {"3/2"}}}, "--shard: found \"3/2\"; it must be I/N"},
      {{"sweep", "run", "grid"}, {{"--shard", {"1:2"}}}, "--shard: found \"1:2\"; it must be I/N"},
      {{"sweep", "run", "grid"}, {{"--shard", {"3/18446744073709551615"}}}, "of N parts, at most 1000000"},
      {{"sweep", "submit", "grid"}, {{"--parts", {"7"}}}, "the engine 'local' does not use them"},
      {{"sweep", "run", "grid"}, {{"--threads", {"0"}}}, "--threads"},
      {{"sweep", "submit", "grid"}, {{"--engine", {"pbs"}}}, "--engine: engine 'pbs' is not known"},
      {{"sweep", "submit", "grid"}, {{"--hosts", {"h"}}}, "the engine 'local' does not use them"},
      {{"sweep", "submit", "grid"},
       {{"--engine", {"slurm"}}, {"--hosts", {"h"}}},
       "--hosts: only the engine 'parallel'"},
      {{"sweep", "submit", "grid"}, {{"--engine", {"parallel"}}, {"--wait", {}}}, "--wait: only the engine 'slurm'"},
      {{"sweep", "submit", "grid"}, {{"--parts", {"0"}}}, "--parts"},
      {{"sweep", "submit", "grid"},
       {{"--engine", {"parallel"}}, {"--hosts", {"nowhere.txt"}}},
       "--hosts: nowhere.txt: No such file or directory",
       4},
      {{"sweep", "evaluate", "real.toml", "params.in", "results.out"},
       {},
       "real.toml:3: axis 1: range: found whole numbers for 'fence.restitution', which takes others, too"},
      {{"sweep", "plan", "lone.toml"}, {}, "lone.toml:1: base: nowhere.toml: No such file or directory", 4},
      {{"sweep", "run", "nowhere"}, {}, "nowhere", 4},
      {{"sweep", "status", "."}, {}, "found a folder without sweep.json; it must be the folder of a sweep", 4}};
  program.write("real.toml",
                "base = \"own.toml\"\noutputs = [\"rock.vx.end\"]\n[[axis]]\nfield = \"fence.restitution\"\n"
                "range = [0, 1]\ncount = 2\n");
  program.write("lone.toml", "base = \"nowhere.toml\"\noutputs = [\"ball.vx.end\"]\n" + good);
  for (const WrongCommand& wrong : commands) {
    const ProgramEnd end = program.end(wrong.command, wrong.options);
    differ.ended("refusal: " + wrong.message, end, wrong.exit_code, wrong.message);
  }
  const std::string manifest = program.read("grid/manifest.jsonl");
  program.write("grid/manifest.jsonl", manifest + "{\"id\": 3}\n");
  const ProgramEnd damaged = program.end({"sweep", "status", "grid"});
  differ.holds(
      "refusal: a damaged manifest",
      damaged.exit_code == 2 &&
          damaged.messages.find("grid/manifest.jsonl:17: not a run; remove this line and plan the sweep again: run.id: "
                                "must be a text, found 3\n") != std::string::npos);
  program.write("grid/manifest.jsonl", manifest.substr(0, manifest.find('\n') + 1));
  const ProgramEnd shorter = program.end({"sweep", "status", "grid"});
  differ.ended("refusal: a shorter manifest", shorter, 2, "found 1 runs; sweep.json has 16");
  std::string other = manifest;
  other.replace(other.find("\"id\":\"") + 6, 4, "0000");
  program.write("grid/manifest.jsonl", other);
  differ.ended("refusal: an id of other parameters", program.end({"sweep", "status", "grid"}), 2,
               "grid/manifest.jsonl:1: found the id 0000");
  program.write("grid/manifest.jsonl", manifest);
  std::filesystem::create_directory(program.folder().path() / "damaged");
  program.write("damaged/sweep.json", "{\"schema\": 1}\n");
  differ.ended("refusal: a damaged description", program.end({"sweep", "status", "damaged"}), 2,
               "damaged/sweep.json: not the description of a sweep; plan the sweep again: sweep.title: is missing\n");
  std::string lost = program.read(program.files("grid/results").front());
  lost.replace(lost.find("\"finished\""), 10, "\"lost\"");
  program.write("grid/results/wrong.jsonl", lost.substr(0, lost.find('\n') + 1));
  const ProgramEnd wrong = program.end({"sweep", "status", "grid"});
  differ.ended("refusal: a wrong result", wrong, 2, "wrong.jsonl:1: end 'lost' is not known");
}

}  // namespace talus::verification::problems::swept_scenes
