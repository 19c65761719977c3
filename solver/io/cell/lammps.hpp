#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <variant>

#include "solver/granular/discs.hpp"
#include "solver/granular/periodic_box.hpp"
#include "solver/laws/law_list.hpp"

namespace talus {

/// A system of discs for LAMMPS (Thompson et al. 2022), which represents them as spheres in a plane. Its granular pair
/// styles have the linear spring-dashpot, Hertz's law with a constant dashpot, and friction by a spring or, with
/// Hertz's law, by Mindlin's stiffness, whose force they rescale as Talus does (`mindlin_rescale/force`). They apply
/// friction at the radius of a disc, Talus in the middle of the overlap; discs of a wall turn in neither code.
struct LammpsScene {
  DiscShapes shapes;
  Discs discs;
  PeriodicBox box;
  std::variant<LinearSpringDashpot, Hertz> law;
  std::optional<DiscFriction> friction{};  ///< if set, discs turn, with the inertia of a solid disc
};

/// Averages of a sheared cell that LAMMPS computes, named as in the summary of `talus cell`: stresses on the wall that
/// has a mass, and contacts of a free disc.
struct LammpsMeans {
  double area{};  ///< of that wall: stress = force/area [L^2]
  long every{};   ///< steps between outputs, each of which has the means since the one before; > 0
  long from{};    ///< steps that the means printed at the end exclude
};

/// Settings of the run in LAMMPS, which integrates by velocity Verlet.
struct LammpsRun {
  /// Pair style. `granular` has the dashpots and end rules of Talus; `gran_hooke` is older and simpler, and is used
  /// only for laws without a dashpot, because its damping is a rate per mass.
  enum class Style { granular, gran_hooke };

  double step{};  ///< [T]
  long steps{};   ///< >= 0
  double skin{};  ///< of the neighbour list [L]
  Style style{Style::granular};
  bool newton{true};  ///< a pair across two processors is computed only once
  bool forces{true};  ///< forces.txt is written
  std::optional<LammpsMeans> means{};
};

/// Text of the data file: box, discs and velocities, exact to the last bit. Free discs are of type 1, those of wall k
/// of type k + 1. Errors: InputError for a sheared periodic box, because LAMMPS shears a box in another way.
[[nodiscard]] std::string lammps_data(const LammpsScene& scene);

/// Text of the input script: reads the data, writes forces.txt (number, position and force of each disc), integrates,
/// and prints the kinetic energy of the free discs ten times, or with `means` at each output, together with the means.
/// Walls are at rest, move at constant velocity, or move along y under their mass and weight, as in Talus. With
/// friction, either style is used in its variant with history. Errors: InputError for a dashpot, Hertz's law or
/// Mindlin's friction with the style gran_hooke, for Mindlin's friction with another law than Hertz's, for Hertz's law
/// with Tsuji's dashpot (which LAMMPS sets from a restitution by a polynomial, not by a coefficient) or discs of
/// different size (of which LAMMPS takes the radius of each pair), and for means without a wall that has a mass.
[[nodiscard]] std::string lammps_input(const LammpsScene& scene, const LammpsRun& run, const std::string& data_file);

/// Writes both files, discs.data and in.discs, to a folder, in which `lmp -in in.discs` runs them. Errors: as above,
/// and IoError.
void export_lammps(const std::filesystem::path& folder, const LammpsScene& scene, const LammpsRun& run);

}  // namespace talus
