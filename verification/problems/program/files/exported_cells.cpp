#include "verification/problems/program/files/exported_cells.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

#include "verification/check/case_file.hpp"
#include "verification/record/whole_file.hpp"
#include "verification/study/findings/expectations.hpp"
#include "verification/study/program/program_options.hpp"

namespace talus::verification::problems::converted_files {
namespace {

/// xi of a clamped contact with this restitution: ln(1/e) = 2 xi arccos(xi)/sqrt(1 - xi^2), by bisection.
double damping_ratio(double restitution) {
  double low = 0.0, high = 0.999;
  for (int n = 0; n < 60; ++n) {
    const double xi = 0.5 * (low + high);
    (2.0 * xi * std::acos(xi) / std::sqrt(1.0 - xi * xi) < -std::log(restitution) ? low : high) = xi;
  }
  return low;
}

/// A cell as read by LAMMPS: masses by the volumes of spheres, walls, law, step, and the area of the stresses.
void check_lammps(const TemporaryFolder& folder, Findings& findings, const Setup& setup) {
  constexpr double diameter = 1e-3, mass = 7.2e-7, gravity = 9.81, overburden = 8e3, speed = 5.0;
  constexpr int rows = 8, columns = 10, wall = 11, free = rows * columns;
  constexpr double step = 2e-7, width = wall * diameter, area = width * diameter,
                   block_mass = overburden * area / gravity;
  constexpr double stiffness = 20305.0, shear_stiffness = 14214.0, friction = 0.5;
  const double ratio = damping_ratio(setup.has("other_restitution") ? 0.7 + 1e-9 : 0.7);
  const auto damping = [&](double k) { return 2.0 * ratio * std::sqrt(k * 0.5 * mass); };
  // The cell with latching springs, which --dashpot replaces by springs with dashpots.
  constexpr double latching_stiffness = 1.7e4;
  folder.write("ice.toml", records::read_whole(case_file("cell/ice.toml")));
  (void)talus_output(folder, {"export", "lammps", "ice.toml", "--dashpot", "--out", "ice"});
  const std::vector<double> replaced = numbers_on_line_after(folder.read("ice/in.discs"), "pair_coeff * * hooke");
  folder.write("rough.toml", records::read_whole(case_file("cell/rough.toml")));
  (void)talus_output(folder, {"export", "lammps", "rough.toml", "--out", "lammps"});
  const std::string input = folder.read("lammps/in.discs"), data = folder.read("lammps/discs.data");
  const Tolerance round_off =
      Tolerance::round_off(5e-15, "about ten roundings on either side, 1.1e-16 each, in 17 digits; twice that");
  double law = 0.0, run = 0.0;
  const auto compare = [&](double& worst, const std::string& before, const std::vector<double>& exact) {
    const std::vector<double> found = numbers_on_line_after(input, before);
    keep_worst(worst, static_cast<double>(found.size()) - static_cast<double>(exact.size()));
    for (std::size_t k = 0; k < std::min(found.size(), exact.size()); ++k)
      keep_worst(worst, exact[k] != 0.0 ? found[k] / exact[k] - 1.0 : found[k]);
  };
  compare(law, "pair_coeff * * hooke", {stiffness, damping(stiffness), shear_stiffness, 0.0, friction});
  keep_worst(law, replaced.at(0) / latching_stiffness - 1.0);
  keep_worst(law, replaced.at(1) / damping(latching_stiffness) - 1.0);
  findings.expect("in.discs: coefficients of the contacts, largest relative error", law, 0.0, round_off);
  compare(run, "timestep", {step}), compare(run, "\nrun 0\nundump forces\nrun", {0.1 / step});
  compare(run, "fix fall2 wall2 gravity", {gravity, 0.0, -1.0, 0.0});
  compare(run, "variable shear equal -f_guide2[1]/", {area}),
      compare(run, "variable normal equal f_guide2[2]/", {area});
  compare(run, "print \"means after step", {0.25 * 0.1 / step});
  // A line each 5 ms, as in the history of the cell; contacts are sampled each 100 steps, first after the start-up.
  constexpr double line = 5e-3 / step, sampled = 100.0;
  compare(run, "fix stress all ave/time", {1.0, line, line}), compare(run, "\nthermo ", {line});
  compare(run, "fix contact all ave/time", {sampled, line / sampled, line});
  const double first = 0.25 * 0.1 / step + sampled;
  compare(run, "fix mean_stress all ave/time", {1.0, 1.0, 1.0, first});
  compare(run, "fix mean_contact all ave/time", {sampled, 1.0, sampled, first});
  findings.expect("in.discs: step, steps, weight of the block and area of the stresses, largest relative error", run,
                  0.0, round_off);

  // A prime number of steps, so that contacts are sampled at each.
  (void)talus_output(folder, {"export", "lammps", "rough.toml", "--steps", "4003", "--out", "prime"});
  const std::string shorter = folder.read("prime/in.discs");
  findings.expect("in.discs of 4003 steps: first step of the means",
                  numbers_on_line_after(shorter, "print \"means after step").at(0), 1000.0,
                  Tolerance::exact("they leave out the first quarter of the given steps, not of the scene's"));
  findings.expect("in.discs of 4003 steps: steps between two samples of the contacts",
                  numbers_on_line_after(shorter, "fix mean_contact all ave/time").at(0), 1.0,
                  Tolerance::exact("it divides the number of steps, which is prime"));
  double pushing = 0.0;
  for (const char* const types : {"2 2", "2 3", "3 3"})
    pushing += input.find(fmt::format("\nneigh_modify exclude type {}\n", types)) == std::string::npos ? 1.0 : 0.0;
  findings.expect("in.discs: pairs of walls whose discs would push each other", pushing, 0.0,
                  Tolerance::exact("base and block, types 2 and 3: each with itself and with the other"));

  // LAMMPS repeats what is between the ends of its box; each wall follows its fixes, in their order.
  double missing = 0.0, box = 0.0;
  for (const char* const command :
       {"boundary p s p", "fix hold1 wall1 setforce 0.0 0.0 0.0", "fix guide2 wall2 setforce 0.0 NULL 0.0",
        "fix together2 wall2 aveforce NULL 0.0 NULL"})
    missing += input.find(fmt::format("\n{}\n", command)) == std::string::npos ? 1.0 : 0.0;
  findings.expect("in.discs: commands of the borders and the walls that are missing", missing, 0.0,
                  Tolerance::exact("the cell repeats along x; the base is held, the block moves at its speed along x, "
                                   "and along y as one body"));
  const std::vector<double> ends = numbers_on_line_after(data, "3 atom types\n\n");
  keep_worst(box, static_cast<double>(ends.size()) - 2.0);
  for (std::size_t i = 0; i < std::min<std::size_t>(ends.size(), 2); ++i)
    keep_worst(box, ends[i] / ((i == 0 ? -0.5 : 0.5) * width) - 1.0);
  findings.expect("discs.data: ends of the box along x over half the width of the cell, largest error", box, 0.0,
                  round_off);

  // Atoms: number, type, diameter, density, x, y, z. The mass of a sphere is density pi d^3/6.
  std::istringstream atoms{data.substr(data.find("Atoms # sphere") + 14)};
  double masses = 0.0, positions = 0.0, block = 0.0;
  const double row = std::max(width / columns, 1.05 * diameter), top = row * (rows + 1);
  for (int i = 0; i < free + 2 * wall; ++i) {
    double number = 0.0, type = 0.0, across = 0.0, density = 0.0, x = 0.0, y = 0.0, z = 0.0;
    atoms >> number >> type >> across >> density >> x >> y >> z;
    const int of_wall = i < free ? 0 : 1 + (i - free) / wall;
    const double of_sphere = density * std::numbers::pi / 6.0 * across * across * across;
    keep_worst(positions, number - (i + 1)), keep_worst(positions, type - (of_wall + 1));
    keep_worst(positions, across / diameter - 1.0);
    if (of_wall == 0) keep_worst(masses, of_sphere / mass - 1.0);
    if (of_wall == 2) block += of_sphere;
    const double column = of_wall == 0 ? (i % columns + 0.5) / columns : ((i - free) % wall + 0.5) / wall;
    keep_worst(positions, (x - width * (column - 0.5)) / diameter);
    keep_worst(positions, (y - (of_wall == 0 ? row * (i / columns + 1) : of_wall == 1 ? 0.0 : top)) / diameter);
  }
  findings.expect("discs.data: masses of the free discs, largest relative error", masses, 0.0, round_off);
  findings.expect("discs.data: total mass of the block's discs over that of the block", block / block_mass, 1.0,
                  round_off);
  findings.expect("discs.data: numbers, types, diameters and positions, largest error", positions, 0.0, round_off);
  // Velocities: number, three components along the axes, three of the spin.
  std::istringstream velocities{data.substr(data.find("Velocities") + 10)};
  double along = 0.0;
  for (int i = 0; i < free + 2 * wall; ++i) {
    std::array<double, 7> of{};
    for (double& value : of)
      velocities >> value;
    const double height = i < free ? row * (i / columns + 1) : i < free + wall ? 0.0 : top;
    keep_worst(along, (of[1] - speed * height / top) / speed);
  }
  findings.expect("discs.data: velocities along x, largest error", along, 0.0, round_off);
}

/// Two cells of spheres as read by LAMMPS: Hertz's law and Mindlin's friction by the effective radius of the pair, a
/// quarter of the diameter. Forces are proportional to the root of the radius, which in the second cell is 1 mm, four
/// times that of LAMMPS.
void check_spheres(const TemporaryFolder& folder, Findings& findings, const Setup& setup) {
  constexpr double modulus = 700e6, shear_modulus = 144e6, friction = 0.5;
  std::string text = records::read_whole(case_file("cell/spheres.toml"));
  const std::string modulus_of_file = "144 MPa";
  if (setup.has("other_shear_modulus"))
    text.replace(text.find(modulus_of_file), modulus_of_file.size(), "144.0001 MPa");
  std::string blunt = text, input;
  const std::string quarter = "\"0.25 mm\"";
  blunt.replace(blunt.find(quarter), quarter.size(), "\"1 mm\"");
  double worst = 0.0;
  for (const auto& [scene, root] : {std::pair{blunt, 2.0}, std::pair{text, 1.0}}) {
    folder.write("spheres.toml", scene);
    (void)talus_output(folder, {"export", "lammps", "spheres.toml", "--out", "spheres"});
    input = folder.read("spheres/in.discs");
    const std::vector<double> normal = numbers_on_line_after(input, "pair_coeff * * hertz");
    const std::vector<double> found = numbers_on_line_after(input, "tangential mindlin_rescale/force");
    if (found.size() != 3 || normal.size() < 2) {
      worst = NAN;
      continue;
    }
    keep_worst(worst, normal[0] / (4.0 / 3.0 * modulus * root) - 1.0);
    keep_worst(worst, found[0] / (8.0 * shear_modulus * root) - 1.0), keep_worst(worst, found[1]);
    keep_worst(worst, found[2] - friction);
  }
  findings.expect("in.discs of spheres: moduli and friction, largest relative error", worst, 0.0,
                  Tolerance::round_off(5e-15,
                                       "about ten roundings on either side, 1.1e-16 each, in 17 digits; twice "
                                       "that"));
  findings.expect_true("in.discs of spheres: contacts that do not pull",
                       input.find(" damping velocity limit_damping\n") != std::string::npos,
                       "the end rule of the cell is clamped, which LAMMPS calls limit_damping");
}

/// `limit_damping` is in the commands exactly if the dashpot acts and contacts do not pull.
void check_end_rules(const TemporaryFolder& folder, Findings& findings) {
  const std::string text = records::read_whole(case_file("cell/rough.toml")), clamped = "end_rule = \"clamped\"",
                    damped = "restitution = 0.7";
  Differences rules;
  for (const std::string rule : {"clamped", "attractive"}) {
    for (const std::string dashpot : {"damping = \"0.05 N s/m\"", "damping = \"0 N s/m\""}) {
      std::string cell = text;
      cell.replace(cell.find(clamped), clamped.size(), "end_rule = \"" + rule + "\"");
      cell.replace(cell.find(damped), damped.size(), dashpot);
      folder.write("rule.toml", cell);
      (void)talus_output(folder, {"export", "lammps", "rule.toml", "--out", "rule"});
      const std::string input = folder.read("rule/in.discs");
      rules.contains("dashpot of LAMMPS", input, " damping velocity");
      rules.compare(rule + ", " + dashpot, input.find(" limit_damping") != std::string::npos,
                    rule == "clamped" && dashpot.find("\"0 N") == std::string::npos);
    }
  }
  rules.expect_none(
      findings, "in.discs: end rules other than those of the discs",
      "LAMMPS calls a contact that does not pull limit_damping, and contacts without dashpot do not pull");
}

}  // namespace

void check_exported_cells(const TemporaryFolder& folder, Findings& findings, const Setup& setup) {
  if (setup.needs("discs")) check_lammps(folder, findings, setup);
  if (setup.needs("end rules")) check_end_rules(folder, findings);
  if (setup.needs("spheres")) check_spheres(folder, findings, setup);
}

}  // namespace talus::verification::problems::converted_files
