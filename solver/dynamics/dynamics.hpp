#pragma once

#include <limits>
#include <span>
#include <vector>

#include "solver/dynamics/body_forces.hpp"
#include "solver/dynamics/cable_forces.hpp"
#include "solver/dynamics/contact_forces.hpp"
#include "solver/dynamics/energies.hpp"
#include "solver/dynamics/workspace.hpp"
#include "solver/integrate/linear_segment.hpp"
#include "solver/model/layout.hpp"
#include "solver/model/model.hpp"
#include "solver/state/state.hpp"

namespace talus {

/// Forces of the laws of a scene.
struct LawForces {
  std::vector<double> instances;  ///< normal force of each law instance of the contacts [F], > 0 pushing apart
  std::vector<double> contacts;   ///< normal force of each contact [F]: the sum over its instances
  std::vector<double> tensions;   ///< tension of each cable [F]
};

/// Computes the rates of change of a State of a Model, by pure functions of both. Compiles the model once into flat
/// arrays, one for each kind of body, geometry and law, so that an evaluation dispatches once for each array.
///
/// Stages of one evaluation, evaluate(), and the functions that compute them:
///
///   state q, v, z, modes
///     |  1 hangers, sleepers   topology and active set                     follow_modes()
///     |  2 bodies              poses                                      BodyForces::set_poses()
///     |  3 cables, rates only  forces of rows, without joints and paths   CableForces::pull_rows()
///     |  4 contacts            pairs within reach                         ContactForces::find()
///     |  5 bodies              velocities                                 BodyForces::set_velocities()
///     |  6 cables              joints, paths, forces of rows              CableForces::update(), unless 3 succeeded
///     |  7 contacts            gaps                                       ContactForces::update()
///   geometry                                                              1 to 7 are update()
///     |  8 modes               contacts, cables, hangers, sleepers        update_modes(); 1 again if any broke or woke
///     |  9 normal forces       once: for friction in 8, or else in 11     ContactForces::push()
///   forces
///     | 10 memory              slip rates                                 memory_rates()
///     | 11 wrenches, powers    cables first, then contacts                CableForces::load(), ContactForces::add()
///   loads
///     | 12 accelerations       and powers and impulses of fields          BodyForces::rates()
///   rates of q, v, z                                                      9 to 12 are rates()
///
/// Workspace::evaluated records which of these stages a workspace has reached. Functions of a workspace require the
/// state of its evaluation, with the same modes and memory.
class Dynamics {
 public:
  explicit Dynamics(const Model& model);
  Dynamics(const Dynamics&) = delete;
  Dynamics& operator=(const Dynamics&) = delete;

  const Model& model() const { return model_; }
  const Layout& layout() const { return layout_; }
  const ContactForces& contacts() const { return contacts_; }
  const CableForces& cables() const { return cables_; }
  /// Inertia of each coordinate: m, m, I, or I about the pin.
  const std::vector<double>& inertias() const { return inertias_; }

  [[nodiscard]] Workspace workspace() const;

  /// Computes poses, paths and gaps of the state, which all functions below read. Gaps are computed only for bodies
  /// within reach of each other.
  void update(const State& state, Workspace& work, Need need = Need::everything) const;
  /// The whole evaluation: update(), update_modes() and rates().
  void evaluate(State& state, Workspace& work, Rates& out, bool ledger) const;
  /// As update(), for reports of the state: includes sleeping bodies and their cables.
  void update_everywhere(const State& state, Workspace& work) const;
  /// As update_everywhere(), with all gaps, however far apart the bodies.
  void update_all(const State& state, Workspace& work) const;
  /// After update(): computes also the gaps of bodies out of reach that may come within reach in the time `horizon`
  /// [T], at their present speed and under their weight. All other pairs have no gaps, and infinite guards. Returns
  /// longest_step(), at most `horizon`.
  double update_far(const State& state, double horizon, Workspace& work) const {
    return contacts_.update_far(state, horizon, gravity_magnitude_, work);
  }
  /// True if some memory has a rate of change, as the stretch of friction has.
  bool follows_motion() const { return follows_motion_; }
  /// Writes the rates of this memory alone to out.z; `out` must have been constructed from a state.
  void memory_rates(const State& state, Workspace& work, Rates& out) const;
  /// Advances this memory by the time h of constant velocities, from the geometry in the middle of this time.
  void drift_memory(State& state, Workspace& work, double h) const { contacts_.drift_memory(state, work, h); }
  /// Initialises the modes of the first state of a run: as update_modes(), except that the friction springs of
  /// overlapping bodies keep the stretch given in the state, instead of one estimated from the slip since the bodies
  /// touched.
  void begin(State& state, Workspace& work) const;
  /// Updates the mode of each law, breaks hangers, records the energy released by these changes, and wakes bodies on
  /// which forces differ from those at rest. `before`: the state at the beginning of the step that led here, if its
  /// rates were computed with `slip_power`. True if something broke or woke; the state was then evaluated again by
  /// update().
  bool update_modes(State& state, Workspace& work, const State* before = nullptr) const;
  /// Computes the rates of change in the state's modes; with `ledger` off, powers and impulses are zero. `slip_power`:
  /// the work of slipping friction is a power, too, which an integrator integrates with its own order. Without it
  /// update_modes() accumulates this work, with the friction limit at the end of the step.
  void rates(const State& state, Workspace& work, Rates& out, bool ledger = true, bool slip_power = false) const;
  /// Cheap sufficient test that all guards() are infinite.
  [[nodiscard]] bool none_ends(const Workspace& work, double horizon) const {
    return !work.any_near && cables_.none_ends(work, horizon);
  }
  /// Computes the guards of all law instances and hangers in the state's modes, by mode slot: positive while the mode
  /// lasts, and infinite if nothing can end it from here or, for rows of cables on their linear branches, if nothing
  /// ends it within the time `horizon` [T] at the present rates. True if any may be finite.
  bool guards(const State& state, Workspace& work, std::span<double> out,
              double horizon = std::numeric_limits<double>::infinity()) const;
  /// Computes the guards of a few modes; other elements of `out` may change, too. Evaluates only what these guards
  /// need: another update() is required before any other function.
  void guards_of(const State& state, std::span<const std::size_t> modes, Workspace& work, std::span<double> out) const;

  /// True if, in the state's modes, some memory is changed by update_modes() alone.
  [[nodiscard]] bool follows(const State& state) const;
  /// See ContactForces::safe_step(), with gravity as the acceleration.
  double safe_step(const Workspace& work, double horizon) const;
  /// After update(): longest step [T] from here in which no body can tunnel through another; infinite if none can.
  [[nodiscard]] double longest_step(const Workspace& work) const;
  /// Displacement [L] of a body for one unit of each coordinate: 1, or the radius of gyration.
  [[nodiscard]] std::vector<double> lengths() const;
  /// After update(): linearization of the springs and dashpots that act, with respect to the coordinates. The
  /// directions of forces are treated as constant; cables that continue through broken hangers are omitted.
  void linearization(const State& state, const Workspace& work, LinearSegment& out) const;
  /// After update(): linear equations of motion in the modes of the state, for a model without
  /// obstacle_to_closed_form().
  void linear_segment(const State& state, const Workspace& work, LinearSegment& out) const;
  /// After update(): number of coordinates up to the last of an awake body; all behind belong to sleeping bodies. The
  /// number of all coordinates if the sleepers have changed since.
  [[nodiscard]] std::size_t moving(const State& state, const Workspace& work) const;
  /// Wakes all bodies.
  void wake_all(State& state) const;

  [[nodiscard]] Energies energies(const State& state, const Workspace& work) const;
  [[nodiscard]] Momenta momenta(const Workspace& work) const;
  /// Forces of all contacts and cables in the state's modes.
  void forces(const State& state, Workspace& work, LawForces& out) const;
  /// After update_all(): largest overlap of a contact [L]; negative while its bodies are apart.
  [[nodiscard]] double contact_depth(const Workspace& work, ContactId contact) const;
  /// Elongation of a cable [L]; negative while slack.
  [[nodiscard]] double elongation(const Workspace& work, CableId cable) const;

 private:
  void find_rest();
  void follow_modes(const State& state, Workspace& work) const;
  void list_awake(const State& state, Workspace& work, bool whole) const;
  void wake(State& state, const std::vector<BodyId>& bodies) const;
  bool break_hangers(State& state, Workspace& work) const;
  bool handle_broken_chains(State& state, Workspace& work) const;
  /// Energy stored in cables, and total energy dissipated so far [F L].
  struct Energy {
    double stored{};
    double lost{};
  };
  Energy cable_energy(const State& state, const Workspace& work) const;
  void relax(State& state, Workspace& work, Energy before, Mechanism loss) const;

  Model model_;
  double gravity_magnitude_{};  ///< acceleration of free fall [L/T^2]
  Layout layout_;
  BodyForces bodies_;
  ContactForces contacts_;
  CableForces cables_;
  std::vector<double> inertias_;
  bool follows_motion_{};
  std::vector<BodyId> unbalanced_sleepers_;  ///< may sleep, but are not in equilibrium at their reference position
};

}  // namespace talus
