#include "verification/problems/program/cells/last_rows.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "verification/record/csv.hpp"
#include "verification/record/json_node.hpp"
#include "verification/study/findings/expectations.hpp"
#include "verification/study/program/program_options.hpp"

namespace talus::verification::problems::cell_files {
namespace {

using records::Csv;
using records::Json;

constexpr double step_of_rows = 2e-6, loop_of_rows = 1e-3;

/// 20 discs under 8 kPa [SI].
std::string cell_of(double stiffness, double end, double speed = 5.0) {
  return fmt::format(
      "units = \"SI\"\n[cell]\nstiffness = \"{} N/m\"\nunloading_stiffness = \"{} N/m\"\ndiameter = \"1 mm\"\nmass = "
      "\"7.2e-7 kg\"\ngravity = \"9.81 m/s^2\"\noverburden = \"8 kPa\"\nrows = 4\ncolumns = 5\nwall_discs = 6\n"
      "block_speed = \"{} m/s\"\nseed = 2\n[run]\nstep = \"{} s\"\nevery = \"{} s\"\nend = \"{} s\"\n",
      stiffness, 2.0 * stiffness, speed, step_of_rows, loop_of_rows, end);
}

/// Each row at the end of a LOOP, the last one at the end of the run, with values.
void check_rows(const Csv& history, double end, const std::string& name, Differences& differ) {
  const auto loops = static_cast<std::size_t>(std::ceil(end / loop_of_rows - 1e-9));
  differ.compare(name + ": rows", history.rows(), loops);
  if (history.rows() != loops || loops == 0) return;
  for (std::size_t row = 0; row + 1 < loops; ++row)
    differ.holds(name + ": times",
                 std::abs(history.number(row, 0) / (static_cast<double>(row + 1) * loop_of_rows) - 1.0) < 1e-9);
  differ.holds(name + ": last time", std::abs(history.number(loops - 1, 0) / end - 1.0) < 1e-9);
  // The block rests on discs that have not left: between no layer and five.
  const double depth = history.number(loops - 1, "depth [m]");
  differ.holds(name + ": last depth", depth > 1e-3 && depth < 5e-3);
  differ.holds(name + ": last solid fraction", history.number(loops - 1, "solid_fraction") > 0.1);
}

}  // namespace

void check_last_rows(const TemporaryFolder& folder, Findings& findings, const Setup& setup) {
  Differences differ;
  // A last LOOP of one step, which is shorter than half of the time between samples.
  const double beyond = 10.0 * loop_of_rows + step_of_rows;
  folder.write("last.toml", cell_of(1000.0, setup.has("whole_loops") ? 10.0 * loop_of_rows : beyond));
  (void)talus_output(folder, {"cell", "last.toml", "--out", "last"});
  check_rows(records::read_csv(folder.path() / "last/history.csv"), beyond, "short last loop", differ);

  // Contacts so soft that the discs pass through each other; the row of the failure shows it.
  folder.write("soft.toml", cell_of(1.0, 40.0 * loop_of_rows));
  differ.compare("exit status of a cell that fails",
                 run_talus(folder, {"cell", "soft.toml", "--out", "soft"}).exit_code, 3);
  const Json outcome = records::read_json(folder.path() / "soft/summary.json").at("outcome");
  const double failed = outcome.at("time").get<double>();
  differ.holds("a failure within a loop", std::abs(failed / loop_of_rows - std::round(failed / loop_of_rows)) > 0.01);
  check_rows(records::read_csv(folder.path() / "soft/history.csv"), failed, "failed loop", differ);

  // The text says that a mean is not steady if its halves differ by more than three standard errors, either way.
  int falling = 0, rising = 0;
  for (const double speed : {1.0, 5.0, 20.0}) {
    folder.write("filling.toml", cell_of(1000.0, 10.0 * loop_of_rows, speed));
    const std::string printed = talus_output(folder, {"cell", "filling.toml", "--out", "filling"});
    const Json summary = records::read_json(folder.path() / "filling/summary.json");
    for (const auto& [name, number] : summary.at("results").items()) {
      const double drift = number.value("drift", 0.0);
      const std::size_t line = printed.find("\n  " + name + " ");
      const std::string row = printed.substr(line + 1, printed.find('\n', line + 1) - line - 1);
      const bool unsteady = std::abs(drift) > 3.0;
      falling += drift < -3.0 ? 1 : 0, rising += drift > 3.0 ? 1 : 0;
      differ.compare(name + ": steady", row.find("not steady") != std::string::npos, unsteady);
      if (unsteady)
        differ.holds(name + ": its change",
                     row.ends_with(fmt::format("is {:+.1f} standard errors off the earlier", drift)));
    }
  }
  differ.holds("means that fall and means that rise", falling > 0 && rising > 0);
  differ.expect_none(findings, "last rows and steadiness of cells: values that differ",
                     "a row for each LOOP, also one that a failure or the end cuts short; the text follows the drifts "
                     "of summary.json");
}

}  // namespace talus::verification::problems::cell_files
