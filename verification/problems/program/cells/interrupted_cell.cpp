#include "verification/problems/program/cells/interrupted_cell.hpp"

#include <filesystem>
#include <string>
#include <vector>

#include "verification/study/findings/expectations.hpp"
#include "verification/study/program/compared_folders.hpp"

namespace talus::verification::problems::cell_files {

void check_interrupted(const TemporaryFolder& folder, Findings& findings, const Setup& setup) {
  folder.write("interrupted.toml",
               "units = \"SI\"\n[cell]\nstiffness = \"1000 N/m\"\nunloading_stiffness = \"2000 N/m\"\n"
               "diameter = \"1 mm\"\nmass = \"7.2e-7 kg\"\ngravity = \"9.81 m/s^2\"\noverburden = \"8 kPa\"\n"
               "rows = 4\ncolumns = 5\nwall_discs = 6\nblock_speed = \"5 m/s\"\nseed = 2\n[run]\n"
               "step = \"2 us\"\nevery = \"1 ms\"\nend = \"5 ms\"\n");
  const auto cell = [&](const std::string& out, const std::string& seed) {
    return run_talus(folder, {"cell", "interrupted.toml", "--seed", seed, "--integrator", "velocity_verlet", "--jump",
                              "--out", out})
        .exit_code;
  };
  // The last file cannot be written: the run ends with status 4 and keeps its checkpoint, that of the start, since it
  // takes less than a second.
  const std::filesystem::path in_the_way = folder.path() / "halves/summary.json";
  std::filesystem::create_directories(in_the_way / "folder");
  double different = cell("whole", setup.has("resumed_cell_of_another_seed") ? "8" : "7") == 0 ? 0.0 : 1.0;
  different += cell("halves", "7") == 4 ? 0.0 : 1.0;
  std::filesystem::remove_all(in_the_way);
  different += run_talus(folder, {"cell", "--resume", "halves"}).exit_code == 0 ? 0.0 : 1.0;
  different += different_files(folder, "whole", "halves");
  findings.expect("cell with choices of the command line, resumed: files that differ from those in one run", different,
                  0.0, Tolerance::exact("a checkpoint contains the choices"));
}

}  // namespace talus::verification::problems::cell_files
