#pragma once

#include <vector>

#include "solver/dynamics/energies.hpp"
#include "solver/dynamics/spans.hpp"
#include "solver/dynamics/workspace.hpp"
#include "solver/model/layout.hpp"
#include "solver/state/state.hpp"

namespace talus {

/// The bodies of a model, compiled into one array for each mobility: poses, weights, and accelerations from wrenches.
class BodyForces {
 public:
  BodyForces(const Model& model, const Layout& layout);

  /// Computes the poses of the bodies that cannot move: called once, when the workspace is made.
  void set_fixed_poses(Workspace& work) const;
  /// Lists the free bodies that are awake.
  void list_awake(ActiveSet& active) const;
  /// Computes the poses of all others, or of those that are awake, except for the velocities of free bodies.
  void set_poses(const State& state, Workspace& work) const;
  /// Computes the velocities of the free bodies whose poses set_poses() sets.
  void set_velocities(const State& state, Workspace& work) const;
  /// Calls set_poses() and set_velocities().
  void update(const State& state, Workspace& work) const { set_poses(state, work), set_velocities(state, work); }
  /// Computes the accelerations from the wrenches in `work` (contacts and cables), the weights and the applied forces;
  /// with `ledger` also the impulse from outside: weights, applied forces and the reactions of supports.
  void rates(Workspace& work, Rates& out, bool ledger) const;
  /// Kinetic energy and the potentials of weights and applied forces.
  [[nodiscard]] Energies energies(const State& state, const Workspace& work) const;
  [[nodiscard]] Momenta momenta(const Workspace& work) const;

 private:
  /// Data of one body for an evaluation.
  struct Compiled {
    std::size_t body{};
    std::size_t first{};  ///< its first coordinate
    double mass{};
    double inertia{};  ///< about the centre of mass
    double inverse_mass{};
    double inverse_inertia{};  ///< about the centre of mass, or about the pin
    Vec2 load;                 ///< weight and applied force [F]
    double moment{};           ///< applied moment [F L]
    Vec2 force;                ///< applied force alone [F]
    Vec2 p_WB;                 ///< reference position [L]
    double angle{};            ///< reference orientation [rad]
    Rotation R_WB;             ///< the same
    Vec2 p_WPin;               ///< pin in the world [L]
    Vec2 p_PinB;               ///< from the pin to the centre of mass, body coordinates [L]
    double multiplicity{1.0};  ///< number of identical bodies that this one represents
    bool along_x{};            ///< a sliding or guided body: whether its guide is along x, else y
  };

  static constexpr std::size_t none = ~std::size_t{0};
  void weigh(const Compiled& body, std::size_t angle);

  void pinned_rates(const Compiled& body, const Workspace& work, Rates& out, bool ledger) const;
  void sliding_rates(const Compiled& body, const Workspace& work, Rates& out, bool ledger) const;
  void guided_rates(const Compiled& body, const Workspace& work, Rates& out, bool ledger) const;

  std::vector<Compiled>& array(Mobility mobility);
  const std::vector<BodySpan>& evaluated_spans(const Workspace& work) const {
    return work.active.complete ? free_runs_ : work.active.bodies;
  }
  BodySpan run_of(std::size_t free) const { return {free, free_[free].body, 1}; }

  Vec2 gravity_;
  std::vector<Compiled> free_;
  BodyConstants constants_;  ///< of the free bodies
  std::vector<BodySpan> free_runs_;
  std::vector<Compiled> particles_;
  std::vector<Compiled> pinned_;
  std::vector<Compiled> sliding_;
  std::vector<Compiled> guided_;
  std::vector<Compiled> fixed_;
  BodyWeights weights_;            ///< of all bodies that move, by mobility
  std::vector<BodySpan> weighed_;  ///< the same bodies
  bool any_applied_{};             ///< one of them has an applied force or moment
  bool only_free_{};               ///< all bodies that move are free
};

}  // namespace talus
