#include "tests/bench/lammps_program.hpp"

#include <fmt/format.h>

#include <cstdlib>
#include <fstream>
#include <string>

namespace talus::bench {
namespace {

bool answers(const char* program) {
  return std::system(fmt::format("command -v {} > /dev/null 2>&1", program).c_str()) == 0;
}

}  // namespace

LammpsProgram::LammpsProgram() : there_{answers("lmp")}, has_mpi_{there_ && answers("mpirun")} {}

double LammpsProgram::seconds(const LammpsScene& scene, const LammpsRun& run, int cores) const {
  export_lammps(folder_.path, scene, run);
  const std::string together =
      cores > 1 ? fmt::format("mpirun --allow-run-as-root --oversubscribe -np {} ", cores) : "";
  const std::string command =
      fmt::format("cd '{}' && {}lmp -in in.discs > screen.txt 2>&1", folder_.path.string(), together);
  if (std::system(command.c_str()) != 0) return 0.0;
  std::ifstream log{folder_.path / "log.lammps"};
  double seconds = 0.0;
  for (std::string line; std::getline(log, line);) {
    if (line.rfind("Loop time of ", 0) == 0) seconds = std::stod(line.substr(13));
    if (cores == 1 && line.find("% CPU use") != std::string::npos) seconds *= 0.01 * std::stod(line);
  }
  return seconds;
}

LammpsRun LammpsProgram::best_run(const LammpsScene& scene, double step, long steps) const {
  LammpsRun best{.step = step, .steps = steps, .skin = 0.3, .style = LammpsRun::Style::gran_hooke, .forces = false};
  double smallest = seconds(scene, best);
  const auto attempt = [&](LammpsRun run) {
    const double taken = seconds(scene, run);
    if (taken > 0.0 && taken < smallest) best = run, smallest = taken;
  };
  for (const double skin : {0.05, 0.1, 0.15, 0.2, 0.5, 0.7}) {
    LammpsRun run = best;
    run.skin = skin;
    attempt(run);
  }
  LammpsRun run = best;
  run.newton = false;
  attempt(run);
  run = best;
  run.style = LammpsRun::Style::granular;
  attempt(run);
  return best;
}

}  // namespace talus::bench
