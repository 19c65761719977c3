#include "solver/io/cell/lammps.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <iterator>
#include <numbers>
#include <numeric>
#include <utility>
#include <vector>

#include "solver/base/error.hpp"
#include "solver/io/file/atomic_file.hpp"

namespace talus {
namespace {

/// Mass of the discs of a held wall: it has no effect, but LAMMPS requires one.
constexpr double any_mass = 1.0;

std::size_t type(const LammpsScene& scene, std::size_t disc) { return scene.shapes.wall[disc] + 1; }

double mass(const LammpsScene& scene, std::size_t disc) {
  const std::size_t wall = scene.shapes.wall[disc];
  if (wall == DiscShapes::free) return 1.0 / scene.shapes.inverse_mass[disc];
  const double whole = scene.shapes.walls[wall - 1].mass;
  const auto discs = std::count(scene.shapes.wall.begin(), scene.shapes.wall.end(), wall);
  return whole > 0.0 ? whole / static_cast<double>(discs) : any_mass;
}

/// Ends of the box along one axis; along an axis that is not periodic, those of all discs with a margin of `room`.
std::pair<double, double> ends(const std::vector<double>& at, double period, double room) {
  if (period < PeriodicBox::unbounded) return {-0.5 * period, 0.5 * period};
  const auto [low, high] = std::minmax_element(at.begin(), at.end());
  return {*low - room, *high + room};
}

/// Commands for the walls: zero force along x; along y zero too, or for a wall with mass the mean over its discs of
/// contact force and weight.
std::string walls(const LammpsScene& scene) {
  std::string text;
  const std::size_t count = scene.shapes.walls.size();
  for (std::size_t wall = 1; wall <= count; ++wall) {
    const DiscWall& shape = scene.shapes.walls[wall - 1];
    text += fmt::format("group wall{0} type {1}\n", wall, wall + 1);
    for (std::size_t other = wall; other <= count; ++other)
      text += fmt::format("neigh_modify exclude type {} {}\n", wall + 1, other + 1);
    if (shape.mass == 0.0) {
      text += fmt::format("fix hold{0} wall{0} setforce 0.0 0.0 0.0\n", wall);
      continue;
    }
    text += fmt::format("fix guide{0} wall{0} setforce 0.0 NULL 0.0\n", wall);
    if (shape.gravity != 0.0)
      text += fmt::format("fix fall{0} wall{0} gravity {1:.17g} vector 0 -1 0\n", wall, shape.gravity);
    text += fmt::format("fix together{0} wall{0} aveforce NULL 0.0 NULL\n", wall);
  }
  return text;
}

/// Pair style gran/hooke.
std::string old_pair_style(const LammpsScene& scene) {
  const auto* const law = std::get_if<LinearSpringDashpot>(&scene.law);
  if (law == nullptr) throw InputError{"law: found hertz; for the style gran/hooke it must be linear_spring_dashpot"};
  if (law->damping != 0.0)
    throw InputError{fmt::format("damping: found {:g}; the style gran/hooke supports only 0", law->damping)};
  if (!scene.friction) return fmt::format("pair_style gran/hooke {:.17g} 0 0 0 0 0\npair_coeff * *\n", law->stiffness);
  const auto* const friction = std::get_if<CoulombFriction>(&*scene.friction);
  if (friction == nullptr) throw InputError{"shear_law: found mindlin; for the style gran/hooke it must be linear"};
  return fmt::format("pair_style gran/hooke/history {:.17g} {:.17g} 0 0 {:.17g} 0\npair_coeff * *\n", law->stiffness,
                     friction->stiffness, friction->coefficient);
}

/// Factor between a length sqrt(R d) with the effective radius of the law and with that of LAMMPS: half of that of
/// equal discs.
double radius_factor(double radius, const LammpsScene& scene) {
  return std::sqrt(radius / (0.5 * scene.shapes.radius.front()));
}

/// Normal force of the style granular: its model with its coefficient, and the dashpot coefficient.
std::string normal_model(const LinearSpringDashpot& law, const LammpsScene& /* scene */) {
  return fmt::format("hooke {:.17g} {:.17g}", law.stiffness, law.damping);
}
/// LAMMPS multiplies the coefficient by the square root of the pair's effective radius.
std::string normal_model(const Hertz& law, const LammpsScene& scene) {
  if (law.dashpot == HertzDashpot::tsuji && law.damping != 0.0)
    throw InputError{"dashpot: found tsuji, which LAMMPS sets by another number; it must be constant"};
  const std::vector<double>& radii = scene.shapes.radius;
  if (std::adjacent_find(radii.begin(), radii.end(), std::not_equal_to{}) != radii.end())
    throw InputError{"law: found hertz with discs of different size; for LAMMPS they must be equal"};
  return fmt::format("hertz {:.17g} {:.17g}", 4.0 / 3.0 * law.modulus * radius_factor(law.radius, scene), law.damping);
}

/// Tangential force of the style granular, without dashpot.
std::string tangential_model(const CoulombFriction& friction, const LammpsScene& /* scene */) {
  return fmt::format("linear_history {:.17g} 0.0 {:.17g}", friction.stiffness, friction.coefficient);
}
/// LAMMPS adds k_t a u to the force for a slip rate u, with the contact radius a of the pair's effective radius, and
/// reduces the force in the ratio of the radii while a decreases. `mindlin_rescale` without `/force` stores the slip
/// instead: its force grows with the contact area.
std::string tangential_model(const Mindlin& friction, const LammpsScene& scene) {
  if (!std::holds_alternative<Hertz>(scene.law))
    throw InputError{
        "shear_law: found mindlin with linear_spring_dashpot, which has no contact radius; it must be linear"};
  return fmt::format("mindlin_rescale/force {:.17g} 0.0 {:.17g}",
                     8.0 * friction.modulus * radius_factor(friction.radius, scene), friction.coefficient);
}

std::string pair_style(const LammpsScene& scene, LammpsRun::Style style) {
  if (style == LammpsRun::Style::gran_hooke) return old_pair_style(scene);
  const std::string tangential =
      scene.friction ? std::visit([&](const auto& of) { return tangential_model(of, scene); }, *scene.friction)
                     : "linear_nohistory 0.0 0.0";
  return std::visit(
      [&](const auto& law) {
        const bool clamped = law.end_rule == EndRule::clamped && law.damping != 0.0;
        return fmt::format("pair_style granular\npair_coeff * * {} tangential {} damping velocity{}\n",
                           normal_model(law, scene), tangential, clamped ? " limit_damping" : "");
      },
      scene.law);
}

/// Commands that integrate the motion of all discs; discs that turn have the inertia of solid discs.
std::string motion(const LammpsScene& scene) {
  if (!scene.friction) return "fix move all nve\n";
  if (scene.shapes.walls.empty()) return "fix move all nve/sphere disc\n";
  return "group walls subtract all free\nfix move free nve/sphere disc\nfix shift walls nve\n";
}

/// Steps between samples of the contacts: the largest number up to 100 (each sample costs a pass over the neighbours)
/// that divides all averaging intervals.
long sample_stride(const LammpsRun& run) {
  const long common = std::gcd(run.means->every, run.steps);
  for (long stride = std::min(100L, common); stride > 1; --stride)
    if (common % stride == 0) return stride;
  return 1;
}

/// Computes and fixes for the averages of LammpsMeans. The force that `guide` removes from a wall is that of its
/// contacts, because gravity is added after it.
std::string averages(const LammpsScene& scene, const LammpsRun& run) {
  const LammpsMeans& means = *run.means;
  const std::vector<DiscWall>& shapes = scene.shapes.walls;
  const auto heavy = std::find_if(shapes.begin(), shapes.end(), [](const DiscWall& wall) { return wall.mass > 0.0; });
  if (heavy == shapes.end()) throw InputError{"walls: found none with a mass; means are of the stresses on one"};
  const auto wall = heavy - shapes.begin() + 1;
  const long stride = sample_stride(run);
  return fmt::format(
      "compute touching all contact/atom\ncompute contacts free reduce ave c_touching\n"
      "variable shear equal -f_guide{0}[1]/{1:.17g}\nvariable normal equal f_guide{0}[2]/{1:.17g}\n"
      "fix stress all ave/time 1 {2} {2} v_shear v_normal\n"
      "fix contact all ave/time {3} {4} {2} c_contacts\n"
      "fix mean_stress all ave/time 1 1 1 v_shear v_normal ave running start {5}\n"
      "fix mean_contact all ave/time {3} 1 {3} c_contacts ave running start {5}\n",
      wall, means.area, means.every, stride, means.every / stride, (means.from / stride + 1) * stride);
}

/// Commands that print the means, with the names that `talus cell` uses.
std::string printed_means(const LammpsMeans& means) {
  return fmt::format(
      "variable ratio equal f_mean_stress[1]/f_mean_stress[2]\n"
      "print \"means after step {}, to be compared with those of talus cell:\"\n"
      "print \"stress_ratio_top $(v_ratio:%.4g)\"\n"
      "print \"top_shear        $(f_mean_stress[1]:%.4g)\"\n"
      "print \"top_normal       $(f_mean_stress[2]:%.4g)\"\n"
      "print \"coordination     $(f_mean_contact:%.4g)\"\n",
      means.from);
}

std::string output(const LammpsScene& scene, const LammpsRun& run) {
  if (!run.means) {
    return fmt::format("thermo_style custom step c_energy\nthermo_modify norm no format float %.17g\nthermo {}\n",
                       std::max(run.steps / 10, 1L));
  }
  return averages(scene, run) +
         fmt::format(
             "# kinetic energy of the free discs; mean stresses on the block and contacts of a free disc since the "
             "last line\n"
             "thermo_style custom step time c_energy f_stress[1] f_stress[2] f_contact\n"
             "thermo_modify norm no format float %12.6g\nthermo {}\n",
             run.means->every);
}

}  // namespace

std::string lammps_data(const LammpsScene& scene) {
  if (scene.box.sliding() != 0.0) {
    throw InputError{
        fmt::format("shear_rate of the periodic box: found {:g}; for LAMMPS it must be 0", scene.box.shear_rate)};
  }
  const DiscShapes& shapes = scene.shapes;
  const double room = 4.0 * *std::max_element(shapes.radius.begin(), shapes.radius.end());
  const auto [left, right] = ends(scene.discs.x, scene.box.width, room);
  const auto [bottom, top] = ends(scene.discs.y, scene.box.height, room);
  std::string text =
      fmt::format("Discs, written by Talus\n\n{} atoms\n{} atom types\n\n", shapes.size(), shapes.walls.size() + 1);
  const auto out = std::back_inserter(text);
  fmt::format_to(out, "{:.17g} {:.17g} xlo xhi\n{:.17g} {:.17g} ylo yhi\n{:.17g} {:.17g} zlo zhi\n\nAtoms # sphere\n\n",
                 left, right, bottom, top, -room, room);
  for (std::size_t i = 0; i < shapes.size(); ++i) {
    const double radius = shapes.radius[i];
    // LAMMPS reads spheres and computes their masses from a density.
    const double density = mass(scene, i) / (4.0 / 3.0 * std::numbers::pi * radius * radius * radius);
    fmt::format_to(out, "{} {} {:.17g} {:.17g} {:.17g} {:.17g} 0\n", i + 1, type(scene, i), 2.0 * radius, density,
                   scene.discs.x[i], scene.discs.y[i]);
  }
  text += "\nVelocities\n\n";
  for (std::size_t i = 0; i < shapes.size(); ++i)
    fmt::format_to(out, "{} {:.17g} {:.17g} 0 0 0 {:.17g}\n", i + 1, scene.discs.vx[i], scene.discs.vy[i],
                   scene.discs.spin.empty() ? 0.0 : scene.discs.spin[i]);
  return text;
}

std::string lammps_input(const LammpsScene& scene, const LammpsRun& run, const std::string& data_file) {
  constexpr const char* forces =
      "dump forces all custom 1 forces.txt id x y fx fy\ndump_modify forces sort id format float %.17g\n"
      "run 0\nundump forces\n";
  const auto border = [](bool repeats) { return repeats ? 'p' : 's'; };
  return fmt::format(
             "# Discs in a plane, written by Talus; {} steps of {:.17g}\n"
             "units lj\ndimension 2\nnewton {}\nboundary {} {} p\natom_style sphere\ncomm_modify vel yes\n"
             "read_data {}\n",
             run.steps, run.step, run.newton ? "on" : "off", border(scene.box.repeats_x()),
             border(scene.box.repeats_y()), data_file) +
         pair_style(scene, run.style) +
         fmt::format("neighbor {:.17g} bin\nneigh_modify every 1 delay 0 check yes\ngroup free type 1\n", run.skin) +
         walls(scene) + motion(scene) +
         fmt::format("timestep {:.17g}\ncompute energy free ke\n{}{}run {}\n{}", run.step, output(scene, run),
                     run.forces ? forces : "", run.steps, run.means ? printed_means(*run.means) : "");
}

void export_lammps(const std::filesystem::path& folder, const LammpsScene& scene, const LammpsRun& run) {
  const std::string data = "discs.data", input = lammps_input(scene, run, data);
  make_folder(folder);
  write_whole(folder / data, lammps_data(scene));
  write_whole(folder / "in.discs", input);
}

}  // namespace talus
