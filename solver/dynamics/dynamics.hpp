#pragma once

#include <limits>
#include <span>
#include <vector>

#include "solver/dynamics/body_forces.hpp"
#include "solver/dynamics/cable_forces.hpp"
#include "solver/dynamics/contact_forces.hpp"
#include "solver/dynamics/energies.hpp"
#include "solver/dynamics/workspace.hpp"
#include "solver/integrate/affine_piece.hpp"
#include "solver/model/layout.hpp"
#include "solver/model/model.hpp"
#include "solver/state/state.hpp"

namespace talus {

/// What the laws of a scene exert.
struct LawForces {
  std::vector<double> instances;  ///< normal force of each law instance of the contacts [F], > 0 pushing apart
  std::vector<double> contacts;   ///< the same summed for each contact
  std::vector<double> tensions;   ///< of each cable [F]
};

/// The rules that turn a Model and a State into rates of change: pure functions of both. Compiles the model once into
/// flat arrays, one for each kind of body, geometry and law, so that an evaluation dispatches once an array.
///
/// One evaluation, evaluate(), and where each part of it is:
///
///   state q, v, z, modes
///     |  1 hangers, sleepers   the topology, and what is awake             follow_modes()
///     |  2 bodies              poses                                      BodyForces::place()
///     |  3 cables, rates only  pulls of rows, without joints and paths    CableForces::pull_rows()
///     |  4 contacts            pairs within reach                         ContactForces::find()
///     |  5 bodies              velocities                                 BodyForces::place_velocities()
///     |  6 cables              joints, paths, pulls of rows               CableForces::update(), unless 3 was enough
///     |  7 contacts            gaps                                       ContactForces::update()
///   geometry                                                              1 to 7 are update()
///     |  8 modes               contacts, cables, hangers, sleepers        update_modes(); what breaks or wakes begins at 1 again
///     |  9 normal forces       once: for friction in 8, or else in 11     ContactForces::push()
///   forces
///     | 10 memory              slip rates                                 memory_rates()
///     | 11 wrenches, powers    cables first, then contacts                CableForces::load(), ContactForces::add()
///   loads
///     | 12 accelerations       and powers and impulses of fields          BodyForces::rates()
///   rates of q, v, z                                                      9 to 12 are rates()
///
/// Workspace::evaluated says which of these stages a workspace has reached. Functions of a workspace take the state of
/// its evaluation, with the same modes and memory.
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

  /// Poses, paths and gaps of the state: what every function below reads. Gaps are computed only of bodies within
  /// reach of each other.
  void update(const State& state, Workspace& work, Need need = Need::everything) const;
  /// The whole evaluation: update(), update_modes() and rates().
  void evaluate(State& state, Workspace& work, Rates& out, bool ledger) const;
  /// The same for who reports the state: sleeping bodies with their cables, too.
  void update_everywhere(const State& state, Workspace& work) const;
  /// As update_everywhere(), with all gaps, however far apart the bodies.
  void update_all(const State& state, Workspace& work) const;
  /// After update(): the gaps of bodies out of reach as well that may come within it in the time ahead [T] at the speed
  /// they have, under their weight. Those of others have none, and infinite guards. As longest_step(), up to that time.
  double update_far(const State& state, double ahead, Workspace& work) const {
    return contacts_.update_far(state, ahead, gravity_magnitude_, work);
  }
  /// Whether some memory follows the motion, as that of friction does.
  bool follows_motion() const { return follows_motion_; }
  /// Rates of that memory alone, to out.z, which was made from a state.
  void memory_rates(const State& state, Workspace& work, Rates& out) const;
  /// Brings the modes of a state with no motion behind it up to date: as update_modes(), but for friction where bodies
  /// overlap, whose springs have the stretch that the state says, and have not slipped since some touch before it.
  void begin(State& state, Workspace& work) const;
  /// Brings each law's mode up to date, breaks hangers, books the energy released by those changes, and wakes bodies on
  /// which something acts otherwise than at rest. `before`: the state at the beginning of the step that led here, if
  /// its rates were taken with `slip_power`. Whether something broke or woke: then it was evaluated again, by update().
  bool update_modes(State& state, Workspace& work, const State* before = nullptr) const;
  /// Rates of change in the state's modes; with `ledger` off the powers and impulses are left at zero. `slip_power`:
  /// the work of friction that slips is a power, too, which a method integrates to its order. Without it update_modes()
  /// accumulates that work with the limit at the end of the step.
  void rates(const State& state, Workspace& work, Rates& out, bool ledger = true, bool slip_power = false) const;
  /// Whether all guards() are infinite, as far as that is quickly said.
  [[nodiscard]] bool none_ends(const Workspace& work, double ahead) const {
    return !work.any_near && cables_.none_ends(work, ahead);
  }
  /// Guards of all law instances and hangers in the state's modes, by mode slot; positive while the mode lasts, and
  /// infinite where nothing can end it from here, or, for rows of cables on straight lines, at their rates nothing does
  /// in the time ahead [T]. Whether any may be finite.
  bool guards(const State& state, Workspace& work, std::span<double> out,
              double ahead = std::numeric_limits<double>::infinity()) const;
  /// Those of a few modes; the numbers of others may change, too. Computes what they need alone: nothing more
  /// may be asked after it without another update().
  void guards_of(const State& state, std::span<const std::size_t> modes, Workspace& work, std::span<double> out) const;

  /// Whether some memory is taken along by update_modes() alone, in the state's modes.
  [[nodiscard]] bool follows(const State& state) const;
  /// After update(): the longest step [T] from here in which no body can pass another unseen; infinite where none can.
  [[nodiscard]] double longest_step(const Workspace& work) const;
  /// Of each coordinate, the length [L] by which one unit moves its body: 1, or the radius of gyration.
  [[nodiscard]] std::vector<double> lengths() const;
  /// After update(): the springs and dashpots that act, seen from the coordinates. Directions of forces are taken as
  /// fixed; cables that run straight past broken hangers are left out.
  void linearization(const State& state, const Workspace& work, AffinePiece& out) const;
  /// After update(): the linear piece that the state is in, of a model without obstacle_to_closed_form().
  void affine_piece(const State& state, const Workspace& work, AffinePiece& out) const;
  /// Coordinates behind the first so many are of bodies that sleep. After update(); all, if the sleepers have changed
  /// since.
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
  /// What cables hold, and what has been lost in all [F L].
  struct Energy {
    double stored{};
    double lost{};
  };
  Energy cable_energy(const State& state, const Workspace& work) const;
  void relax(State& state, Workspace& work, Energy before, Mechanism loss) const;

  Model model_;
  double gravity_magnitude_{};  ///< of gravity [L/T^2]
  Layout layout_;
  BodyForces bodies_;
  ContactForces contacts_;
  CableForces cables_;
  std::vector<double> inertias_;
  bool follows_motion_{};
  std::vector<BodyId>
      unbalanced_sleepers_;  ///< bodies that may sleep but are not in balance at their reference position
};

}  // namespace talus
