#pragma once

#include <array>
#include <cmath>
#include <cstddef>
#include <span>
#include <utility>

#include "solver/base/vec.hpp"
#include "solver/granular/disc_contact.hpp"
#include "solver/granular/fast_disc_engine.hpp"
#include "solver/granular/step_block.hpp"
#include "solver/laws/law_list.hpp"
#include "solver/laws/mode_update.hpp"

namespace talus {

/// Many discs, several times as fast as DiscSystem, its plain reference implementation, and with the same bits:
/// positions, velocities, accelerations, forces on walls and contact memories; also the dissipated energy, if
/// keep_work() was called, except for the loss of a history-dependent law, which follows from the contact memories
/// (lost()). FastDiscEngine documents how.
///
/// The stages of its sweeps are those of step_block.hpp: for laws that are not in DiscLaws they must be instantiated
/// (law_sweep.hpp). F: Frictionless or one of DiscFrictions.
///
/// Errors: InputError for zero threads; functions that list pairs have the errors of NeighbourList::build.
template <Law L, class F = Frictionless>
requires(HasContactKernel<L>&& CanHaveFriction<L, F>) class FastDiscSystem : public FastDiscEngine {
 public:
  static constexpr bool has_history = L::memory_size == 1, turns = turns_discs<F>;

  /// skin [L] > 0: how far the neighbour list reaches beyond the law's reach. threads >= 1: used by advance();
  /// worthwhile from a few thousand discs on, if these are numbered by rows.
  FastDiscSystem(DiscShapes shapes, PeriodicBox box, const L& law, double skin, const F& friction = {},
                 std::size_t threads = 1)
      : FastDiscEngine{{.has_history = has_history,
                        .turns = turns,
                        .changes_stiffness = has_varying_stiffness<F>,
                        .needs_rate = contact_kernel(law).needs_rate(),
                        .reach = reach(law),
                        .dissipation = L::dissipation,
                        .release = L::release},
                       std::move(shapes),
                       box,
                       skin,
                       threads},
        law_{law},
        friction_{friction} {}

  const L& law() const { return law_; }
  const F& friction() const { return friction_; }

  /// Calls visit(contact), in order, for each pair that was within the law's reach at the last evaluation and still is
  /// at the present positions.
  template <class Visit>
  void for_each_contact(const Discs& discs, Visit&& visit) const {
    for_each_touching_pair(
        discs, [&](std::size_t a, std::size_t b, const NeighbourList::Shift& shift, const ContactMemory& then) {
          const Vec2 d{(discs.x[b] + shift.x) - discs.x[a], (discs.y[b] + shift.y) - discs.y[a]};
          const Vec2 v{(discs.vx[b] + shift.vx) - discs.vx[a], discs.vy[b] - discs.vy[a]};
          const double distance = norm(d);
          const Vec2 n{d.x / distance, d.y / distance};
          const Kinematics x{shapes().radius[a] + shapes().radius[b] - distance, -dot(v, n)};
          if (!(x.deformation > -reach(law_))) return;
          std::array<double, 1> memory{then.largest};
          const std::span<double> remembered{memory.data(), L::memory_size};
          Mode mode = 1;  // touching; update_mode() finds out whether another mode has followed
          talus::update_mode(law_, remembered, x, mode, [](double) {});
          DiscContact contact{.a = a, .b = b, .depth = x.deformation, .n_ab = n, .distance = distance};
          contact.force = mode == 0 ? 0.0 : law_(x, remembered, mode).total();
          contact.stored = law_.stored_energy(x, remembered, mode);
          if constexpr (turns) {
            const CoulombFriction friction = friction_.at(x.deformation);
            contact.friction = friction(then.stretch, contact.force);
            contact.stored += friction.stored_energy(then.stretch);
          }
          visit(contact);
        });
  }

 private:
  void evaluate_pair_forces(const StepBlock& sweep, PairForces& pushes) const override {
    talus::evaluate_pair_forces(law_, friction_, sweep, pushes);
  }
  double kick_and_drift(const StepBlock& sweep) const override { return talus::kick_and_drift(law_, friction_, sweep); }
  void stretch_contacts([[maybe_unused]] const StepBlock& sweep) const override {
    if constexpr (turns) talus::stretch_contacts(friction_, sweep);
  }
  double hysteresis_loss([[maybe_unused]] double largest) const override {
    if constexpr (has_history) return law_.hysteresis_loss(largest);
    return 0.0;
  }
  double friction_energy([[maybe_unused]] double stretch) const override {
    if constexpr (turns) return friction_.at(0.0).stored_energy(stretch);
    return 0.0;
  }

  L law_;
  F friction_;
};

}  // namespace talus
