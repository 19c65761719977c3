#include "verification/problems/program/sweeps/sweep_engines.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <thread>

#include "verification/study/program/program_run.hpp"

namespace talus::verification::problems::swept_scenes {

namespace fs = std::filesystem;

void check_engines(const Program& program, const std::string& sweep, Differences& differ) {
  const fs::path folder = program.folder().path();
  fs::create_directory(folder / "bin");
  program.write("bin/sbatch",
                "#!/bin/sh\nprintf '%s\\n' \"$@\" > sbatch.txt\nfor script; do :; done\n"
                "for part in 1 2 3; do SLURM_ARRAY_TASK_ID=$part /bin/sh \"$script\"; done\n");
  program.write("bin/parallel",
                "#!/bin/sh\nprintf '%s\\n' \"$@\" > parallel.txt\nwhile [ \"$1\" != /bin/sh ]; do shift; done\n"
                "script=$2\nwhile [ \"$1\" != ::: ]; do shift; done\nshift\n"
                "for part; do eval \"/bin/sh $script $part\"; done\n");
  for (const char* engine : {"sbatch", "parallel"})
    fs::permissions(folder / "bin" / engine, fs::perms::owner_all);
  const char* const path = std::getenv("PATH");
  // As if the command itself were a task of Slurm.
  const Environment environment{{"PATH", fmt::format("{}:{}", (folder / "bin").string(), path != nullptr ? path : "")},
                                {"SLURM_ARRAY_TASK_ID", "2"}};
  const auto submit = [&](const std::string& engine, const std::string& name, const Options& options) {
    program.write("engines.toml", sweep);
    program.run({"sweep", "plan", "engines.toml"}, {{"--out", {name}}});
    const std::string printed = talus_output(
        program.folder(), with_options({"sweep", "submit", name, "--engine", engine}, options, program.setup()),
        environment);
    differ.contains(engine + ": all runs are done", printed, "16 of 16 runs done: 16 finished\n");
    program.run({"sweep", "collect", name});
    differ.compare(engine + ": the same table", program.read(name + "/results.csv"), program.read("grid/results.csv"));
    return "\n" + program.read(engine == "slurm" ? "sbatch.txt" : "parallel.txt");
  };
  const fs::path whole = fs::canonical(folder);
  const std::string slurm =
      submit("slurm", "it's slurm", {{"--parts", {"3"}}, {"--wait", {}}, {"--option", {"--mem=1G"}}});
  for (const std::string& argument :
       {std::string{"--array=1-3"}, std::string{"--job-name=talus-it's slurm"}, std::string{"--wait"},
        std::string{"--mem=1G"}, "--output=" + (whole / "it's slurm/part-%a.log").string(),
        (whole / "it's slurm/part.sh").string()})
    differ.contains("sbatch " + argument, slurm, "\n" + argument + "\n");
  program.write("h.txt", "localhost\n");
  const std::string parallel =
      submit("parallel", "it's parallel", {{"--parts", {"2"}}, {"--hosts", {"h.txt"}}, {"--option", {"--bar"}}});
  differ.holds("parallel with hosts",
               parallel.starts_with("\n--sshloginfile\nh.txt\n--bar\n-I\nTALUS_PART_NUMBER\n/bin/sh\n"));
  differ.holds("parallel parts", parallel.ends_with("\nTALUS_PART_NUMBER\n:::\n1\n2\n"));
  const std::string here = submit("parallel", "here", {{"--parts", {"40"}}});
  // By default as many processes at a time as the machine has threads.
  differ.holds("parallel without hosts",
               here.starts_with(fmt::format("\n--jobs\n{}\n", std::max(1U, std::thread::hardware_concurrency()))));
  differ.holds("not more parts than runs", here.ends_with("\n15\n16\n"));
}

}  // namespace talus::verification::problems::swept_scenes
