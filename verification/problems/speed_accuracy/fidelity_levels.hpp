#pragma once

#include "solver/scenes/fence_scene.hpp"
#include "verification/check/case.hpp"
#include "verification/reference/impacts/restitution.hpp"

/// One impact at increasing levels of fidelity: the rock of Table 2 against increasingly complete models of its fence.
namespace talus::verification::problems {

/// Parameters of the fence, from which the simpler levels are built. All in feet, pounds, slugs and seconds.
struct FenceNumbers {
  double speed{};              ///< of the rock, towards the fence
  double restitution{};        ///< e of its contact
  double rock_mass{};          ///< m_r
  double rock_radius{};        ///< R
  double column_mass{};        ///< m
  double column_inertia{};     ///< I about the centroid
  double half_width{};         ///< of the column
  double top_joint{};          ///< above the centroid
  double contact_stiffness{};  ///< k of rock against column
  double cable_modulus{};      ///< E A of the top cable [lb]
  double first_tension{};      ///< T_0 of its central segments at rest
  double segment{};            ///< horizontal length of these segments
  double half_span{};
  double gravity{};
};

/// The fence of Table 2 hit at `height` above the column's centre [ft]: one resultant per pair, never attractive, with
/// the dashpot for e and the effective mass of the contact, and without the initial half kick.
[[nodiscard]] scenes::Fence ladder_fence(double height);
[[nodiscard]] FenceNumbers fence_numbers(const scenes::Fence& fence);

/// 1/(1/m + y^2/I): effective mass of a free column at the point where it is hit.
[[nodiscard]] double free_column_mass(const FenceNumbers& numbers, double height);
/// I_p/h^2, the inertia about the top joint over the squared distance below it: effective mass of a column that hangs
/// from a pin.
[[nodiscard]] double hung_column_mass(const FenceNumbers& numbers, double height);
/// Speed of the rock after its impact on that mass, by the coefficient of restitution alone.
[[nodiscard]] double speed_by_formula(const FenceNumbers& numbers, double mass);
/// The same impact with the contact's spring and dashpot, in closed form.
[[nodiscard]] reference::Impact soft_impact(const FenceNumbers& numbers, double mass);

/// Fixed points at which the two cables of a particle end.
enum class Held { neighbours, ends };

/// Rock and free column as two particles, the column's mass that of free_column_mass().
[[nodiscard]] Scene free_pair(const FenceNumbers& numbers, double height);
/// The same between two cables of the fence's modulus and tension. Fault `cable_stiffness_halved`.
[[nodiscard]] Scene particle_on_cables(const FenceNumbers& numbers, double height, Held held, const Setup& setup);
/// The column as a rigid body on a pin at its top joint.
[[nodiscard]] Scene hung_column(const FenceNumbers& numbers, double height);
/// The half fence in which the central column and `beside` columns on either side of it move; the others are fixed at
/// their initial positions.
[[nodiscard]] Scene moving_columns(const scenes::Fence& fence, int beside);

/// Results of a run to 0.2 s.
struct Passage {
  double first{};  ///< speed of the rock after its first contact, > 0 in its initial direction [ft/s]
  double push{};   ///< largest force of rock on column [lb]
  double pull{};   ///< largest tension of a top cable [lb]; NaN without cables
  double exit{};   ///< speed of the rock at the end [ft/s]
  long evaluations{};
  std::size_t coordinates{};
  State end;
};

inline constexpr double passage_end = 0.2;  ///< [s]

/// Runs a level with located events. The results are NaN if the run fails.
[[nodiscard]] Passage passage(const Scene& scene, double tolerance, Findings& findings);

}  // namespace talus::verification::problems
