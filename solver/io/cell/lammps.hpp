#pragma once

#include <filesystem>
#include <optional>
#include <string>

#include "solver/granular/discs.hpp"
#include "solver/granular/periodic_box.hpp"
#include "solver/laws/coulomb_friction.hpp"
#include "solver/laws/linear_spring_dashpot.hpp"

namespace talus {

/// Discs as LAMMPS (Thompson et al. 2022) takes them: spheres in a plane, of which its granular pair styles know the
/// linear spring-dashpot and friction with memory. They let friction act at the radius of a disc, Talus in the middle
/// of the overlap; discs of a wall do not turn in either.
struct LammpsScene {
  DiscShapes shapes;
  Discs discs;
  PeriodicBox box;
  LinearSpringDashpot law;
  std::optional<CoulombFriction> friction{};  ///< then discs turn, with the inertia of a solid disc
};

/// What LAMMPS measures of a sheared cell, named as in the summary of `talus cell`: stresses on the wall that has a
/// mass, contacts of a free disc.
struct LammpsMeans {
  double area{};  ///< of that wall, over which forces are stresses [L^2]
  long every{};   ///< steps from one output to the next, which has the means between them; > 0
  long from{};    ///< steps before the means that are printed at the end begin
};

/// How LAMMPS is to step them, by velocity Verlet.
struct LammpsRun {
  /// Pair style. `granular` has dashpots and end rules as Talus has; `gran_hooke` is the older and simpler one, for
  /// laws without a dashpot: its own is a rate for each mass.
  enum class Style { granular, gran_hooke };

  double step{};  ///< [T]
  long steps{};   ///< >= 0
  double skin{};  ///< of its neighbour list [L]
  Style style{Style::granular};
  bool newton{true};  ///< each pair between two processors is computed once
  bool forces{true};  ///< forces.txt is wanted
  std::optional<LammpsMeans> means{};
};

/// Its data file: box, discs and velocities, to the last bit. Discs are of type 1; those of wall k of type k + 1.
/// Errors: InputError for a box that slides, which it shears in another way.
[[nodiscard]] std::string lammps_data(const LammpsScene& scene);

/// Its input: reads the data, writes forces.txt (number, place and force of each disc), steps it, and prints the
/// kinetic energy of the free discs ten times, or with `means` at each output and those beside it. Walls stand still,
/// move on, or move along y under their mass and weight, as here. Errors: InputError for a dashpot with the style
/// gran_hooke, and for means without a wall that has a mass. Friction takes its variant with history, in either style.
[[nodiscard]] std::string lammps_input(const LammpsScene& scene, const LammpsRun& run, const std::string& data_file);

/// Writes both to a folder: discs.data and in.discs, for `lmp -in in.discs` there. Errors: as above, and IoError.
void export_lammps(const std::filesystem::path& folder, const LammpsScene& scene, const LammpsRun& run);

}  // namespace talus
