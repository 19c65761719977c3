/// Arithmetic of BodyForces, CableForces and ContactForces on spans of consecutive bodies, joints, cables and nodes,
/// one pack at a time. A bare pointer points to the number of the first element of the span; those of the others
/// follow.
#pragma once

#include "solver/dynamics/energies.hpp"
#include "solver/dynamics/lanes.hpp"
#include "solver/geometry/node_depth.hpp"
#include "solver/state/state.hpp"

namespace talus {

/// Computes positions and orientations of a span of free bodies from their coordinates q, three for each body. Leaves
/// the velocities in `poses` unchanged.
void set_body_poses(const BodySpan& span, const double* q, Poses& poses);
/// Computes the velocities of a span of free bodies from the rates v of these coordinates.
void set_body_velocities(const BodySpan& span, const double* v, Poses& poses);

/// Computes the joints of a span of bodies from the poses of the bodies; p_x, p_y in body coordinates [L].
void set_joints(const JointSpan& span, const Row& p_x, const Row& p_y, const Poses& poses, JointPoints& joints);

/// Limits of the displacement of bodies since the contact search listed them, one number for each body.
struct SkinLimits {
  Row radius;                   ///< of all points that a rotation moves, about the centre of mass [L]; 0 for a disc
  Row displacement;             ///< largest displacement of any point of it [L]; infinite if it is not limited
  std::size_t first{}, last{};  ///< bodies outside first .. last - 1 are not limited
};

/// True if a point of some body has, or may have, exceeded its limit; also if a pose is not a number.
bool any_exceeded_skin(const Poses& poses, const Positions& positions, const SkinLimits& limits);

/// Constants of free bodies, one number for each.
struct BodyConstants {
  Row inverse_mass, inverse_inertia;
  Row load_x, load_y;  ///< weight and applied force [F]
  Row moment;          ///< applied moment [F L]
  Row multiplicity;    ///< number of identical bodies that each represents
};

/// Computes the accelerations of a span of free bodies, three for each body.
void accelerate_bodies(const BodySpan& span, const BodyConstants& constants, const Wrenches& wrenches, double* a);

/// Adds the weights, applied forces and applied moments of a span of free bodies to the rates of the impulse, body by
/// body.
void add_impulses(const BodySpan& span, const BodyConstants& constants, const Poses& poses, Impulse<double>& sum);

/// Constants of all bodies that move, one number for each.
struct BodyWeights {
  Row kinetic;       ///< multiplicity * m/2
  Row turning;       ///< multiplicity * I/2, about the centre of mass
  Row weight;        ///< multiplicity * m
  Row multiplicity;  ///< number of identical bodies that each represents
  Row mass, inertia;
  Row force_x, force_y;                       ///< applied [F]
  Row moment;                                 ///< applied [F L]; zero for a body that does not turn
  Row reference_x, reference_y, angle;        ///< reference position [L] and orientation [rad]
  std::vector<std::size_t> angle_coordinate;  ///< of a body that does not turn: any
};

/// Adds the kinetic energies of a span of bodies, and the potentials of their weights, body by body.
void add_energies(const BodySpan& span, const BodyWeights& weights, Vec2 gravity, const Poses& poses, Energies& sum);
/// Adds the potentials of the applied forces and moments of a span of bodies with coordinates q, body by body.
void add_applied(const BodySpan& span, const BodyWeights& weights, const double* q, const Poses& poses, double& sum);
/// Adds the momenta of a span of bodies, body by body.
void add_momenta(const BodySpan& span, const BodyWeights& weights, const Poses& poses, Momenta& sum);

/// Sets the wrenches of the first `count` bodies, and some behind them, to zero, or copies them.
void clear(Wrenches& wrenches, std::size_t count);
void copy(const Wrenches& from, std::size_t count, Wrenches& to);

/// Constants of joints and cables, one number for each.
struct CableConstants {
  Row body_x, body_y;  ///< position of a joint in body coordinates [L]
  Row across_squared;  ///< squared distance of the ends of a cable along the fence [L^2]
  Row rest_length;     ///< [L]
  Row multiplicity;    ///< number of identical cables that each represents
  Row symmetry_weight_a,
      symmetry_weight_b;  ///< force on the body at an end of a cable for each unit of tension: above 1 where
                          ///< a cable that represents several ends at a body that represents only itself
};

/// Evaluates a row: its joints and the paths of its cables and, if all cables are on the linear branches of their
/// modes, the tensions and the forces at the joints, which are added to the forces on the bodies. True if all are on
/// their linear branches.
bool evaluate_chain(const CableSpan& span, const CableConstants& constants, const CableLinearization& lines,
                    const Poses& poses, JointPoints& joints, Paths& paths, Wrenches& pulls);
/// Computes the forces of a row on the bodies and at its joints alone: row by row, in the order of the joints. Reads
/// the positions only of those joints that are on no body.
bool chain_wrenches(const CableSpan& span, const CableConstants& constants, const CableLinearization& lines,
                    const Poses& poses, JointPoints& joints, Wrenches& pulls);

/// `sum` plus the energies stored in a span of cables on their linear branches, cable by cable [F L].
[[nodiscard]] double add_line_energies(double sum, const CableSpan& span, const CableConstants& constants,
                                       const CableLinearization& lines, const Paths& paths);

/// True if the `count` cables from `first` on, which are on their linear branches (see evaluate_chain()), remain there
/// for the time `horizon` [T] at their present rates.
bool remains_linear(std::size_t first, std::size_t count, const Row& rest_length, const CableLinearization& lines,
                    const Paths& paths, double horizon);

/// Computes the depths [L] of `count` points of A, from the `first` of those at x, y in A's coordinates on, in the box
/// around an outline of B: box_depth() of each. Writes up to one pack more to `depths`.
void box_depths(const Row& x, const Row& y, std::size_t first, std::size_t count, const Placement& A_in_B,
                const Superquadric& outline, double* depths);

/// As box_depths(), for balls of these radii in the half-plane y < 0 of B.
void plane_depths(const Row& x, const Row& y, const Row& radius, std::size_t first, std::size_t count,
                  const Placement& A_in_B, double* depths);

/// The largest of these depths [L], and that of balls in a circle around the origin of B.
[[nodiscard]] double largest_box_depth(const Row& x, const Row& y, std::size_t first, std::size_t count,
                                       const Placement& A_in_B, const Superquadric& outline);
[[nodiscard]] double largest_plane_depth(const Row& x, const Row& y, const Row& radius, std::size_t first,
                                         std::size_t count, const Placement& A_in_B);
[[nodiscard]] double largest_circle_depth(const Row& x, const Row& y, const Row& radius, std::size_t first,
                                          std::size_t count, const Placement& A_in_B, const Circle& circle);

/// Adds the forces at joints to the wrenches of the span of bodies that they are on.
void load_bodies(const JointSpan& span, const JointPoints& joints, Wrenches& wrenches);

}  // namespace talus
