#include "verification/problems/program/files/energy_scales.hpp"

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>

#include "verification/record/csv.hpp"
#include "verification/record/json_node.hpp"
#include "verification/study/findings/expectations.hpp"

namespace talus::verification::problems::run_files {
namespace {

using records::Csv;
using records::Json;

/// A body on a dashpot and a drawn rope, and a disc that a dashpot holds back from the ground: the energy that is
/// stored at the start becomes heat, so that of all energies this one changes most.
const std::string drawn = R"(
[[body]]
name = "hung"
mobility = "sliding_y"
mass = "1 kg"
position = ["0 m", "-1.5 m"]
[[cable]]
name = "rope"
law = "tension_only"
from = { body = "hung", point = ["0 m", "0 m"] }
to = { point = ["0 m", "0 m"] }
stiffness = "100 N/m"
damping = "60 N s/m"
rest_length = "1 m"
)";
const std::string pushed = R"(
[[body]]
name = "ground"
mobility = "fixed"
position = ["0 m", "0 m"]
shape = { kind = "half_plane" }
[[body]]
name = "disc"
mobility = "particle"
mass = "1 kg"
position = ["0 m", "0.45 m"]
shape = { kind = "circle", radius = "0.5 m" }
[[contact]]
name = "bed"
between = ["disc", "ground"]
law = "linear_spring_dashpot"
stiffness = "100 N/m"
damping = "60 N s/m"
)";

}  // namespace

double scale_error(const TemporaryFolder& folder) {
  double worst = 0.0;
  for (const auto& [body, stored] : {std::pair{&drawn, "energy.cables"}, std::pair{&pushed, "energy.contacts"}}) {
    folder.write("damped.toml", "units = \"SI\"\n" + *body +
                                    "[run]\nintegrator = \"velocity_verlet\"\nstep = \"1 ms\"\nend = \"1 s\"\n"
                                    "interval = \"1 ms\"\n");
    (void)talus_output(folder, {"run", "damped.toml", "--out", "damped"});
    const Csv rows = records::read_csv(folder.path() / "damped/history.csv");
    double largest = 0.0, of_stored = 0.0;
    for (std::size_t i = 0; i < rows.header().size(); ++i) {
      if (!rows.header()[i].starts_with("energy.")) continue;
      double change = 0.0;
      for (std::size_t row = 0; row < rows.rows(); ++row)
        change = std::max(change, std::abs(rows.number(row, i) - rows.number(0, i)));
      largest = std::max(largest, change);
      if (rows.header()[i].starts_with(stored)) of_stored = change;
    }
    const Json summary = records::read_json(folder.path() / "damped/summary.json");
    keep_worst(worst,
               of_stored == largest ? summary.at("ledger").at("energy_scale").get<double>() / largest - 1.0 : 1.0);
  }
  return worst;
}

}  // namespace talus::verification::problems::run_files
