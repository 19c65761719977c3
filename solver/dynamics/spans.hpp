/// What is computed for neighbouring bodies, joints, cables and nodes a pack at a time: the arithmetic of BodyForces,
/// CableForces and ContactForces. A bare pointer is to the number of the run's first, those of the others behind it.
#pragma once

#include "solver/dynamics/lanes.hpp"
#include "solver/geometry/node_depth.hpp"

namespace talus {

/// Places of neighbouring free bodies from their coordinates q, three for each body; of their poses the velocities stay
/// as they are.
void place_bodies(const BodySpan& run, const double* q, Poses& poses);
/// Their velocities, from the rates v of those coordinates.
void place_velocities(const BodySpan& run, const double* v, Poses& poses);

/// Joints on neighbouring bodies, from the bodies' poses; p_x, p_y in body coordinates [L].
void place_joints(const JointSpan& run, const Row& p_x, const Row& p_y, const Poses& poses, JointPoints& joints);

/// How far bodies may go, one number for each.
struct SkinLimits {
  Row radius;  ///< within which all of a body lies from its centre of mass [L]
  Row way;     ///< that no point of it may exceed from where it was [L]; infinite if it may go anywhere
  std::size_t first{}, last{};  ///< all others may
};

/// Whether a point of some body is, or may be, further from where it was than it may be; also if its pose is no number.
bool any_exceeded_skin(const Poses& poses, const Places& places, const SkinLimits& limits);

/// What is constant of free bodies, one number for each.
struct BodyConstants {
  Row inverse_mass, inverse_inertia;
  Row load_x, load_y;  ///< weight and applied force [F]
  Row moment;          ///< applied [F L]
};

/// Accelerations of neighbouring free bodies, three for each body.
void accelerate_bodies(const BodySpan& run, const BodyConstants& constants, const Wrenches& wrenches, double* a);

/// Of the first so many bodies, and some behind them: no force, no moment; or those of others.
void clear(Wrenches& wrenches, std::size_t count);
void copy(const Wrenches& from, std::size_t count, Wrenches& to);

/// What is constant of joints and cables, one number for each.
struct CableConstants {
  Row body_x, body_y;  ///< of a joint: its place in body coordinates [L]
  Row across_squared;  ///< of a cable: of the distance of its ends along the fence [L^2]
  Row rest_length;     ///< [L]
  Row symmetry_weight_a,
      symmetry_weight_b;  ///< how much of a cable's tension its ends take: one that stands for several pulls several
                          ///< times at a body that stands for itself alone
};

/// A row's joints and the lines of its cables; if all cables are on the straight lines of their modes, which it then
/// says, their tensions and the pulls at the joints as well, which are added to the pulls on the bodies.
bool evaluate_chain(const CableSpan& run, const CableConstants& constants, const CableLinearization& lines,
                    const Poses& poses, JointPoints& joints, Paths& paths, Wrenches& pulls);
/// The pulls on the bodies alone. Of joints those that are on no body are read.
bool chain_wrenches(const CableSpan& run, const CableConstants& constants, const CableLinearization& lines,
                    const Poses& poses, const JointPoints& joints, Wrenches& pulls);

/// Whether cables that are on their lines, as evaluate_chain() said, stay there for the time ahead [T] at the rates they have:
/// so many from the first on.
bool remains_linear(std::size_t first, std::size_t count, const Row& rest_length, const CableLinearization& lines,
                    const Paths& paths, double ahead);

/// Depths of points of A [L], from the `first` of those at x, y in A's coordinates on, in the box around an outline of
/// B: box_depth() of each. They are written to up to a pack further.
void box_depths(const Row& x, const Row& y, std::size_t first, std::size_t count, const Placement& A_in_B,
                const Superquadric& outline, double* depths);

/// The same of balls of these radii in the half-plane y < 0 of B.
void plane_depths(const Row& x, const Row& y, const Row& radius, std::size_t first, std::size_t count,
                  const Placement& A_in_B, double* depths);

/// Adds the pulls at joints to the wrenches of the neighbouring bodies that they are on.
void load_bodies(const JointSpan& run, const JointPoints& joints, Wrenches& wrenches);

}  // namespace talus
