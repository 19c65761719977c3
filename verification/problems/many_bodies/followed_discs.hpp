#pragma once

#include <algorithm>

#include "solver/granular/fast_disc_system.hpp"
#include "solver/granular/packing.hpp"
#include "solver/granular/stress.hpp"
#include "solver/laws/latching_spring.hpp"
#include "solver/laws/linear_spring_dashpot.hpp"
#include "verification/study/runs/usage.hpp"

namespace talus::verification::problems {

/// Latching spring with this K1/K2, with which two discs of this mass touch for contact_time; e = sqrt(K1/K2).
[[nodiscard]] LatchingSpring latching_contact(double stiffness_ratio, double contact_time, double mass = 1.0);
/// Spring and clamped dashpot, with which two discs of this mass touch for contact_time and have this restitution.
[[nodiscard]] LinearSpringDashpot dashpot_contact(double restitution, double contact_time, double mass = 1.0);

/// Sample of the discs at one time; numbers from velocities are means of those half a step before and after.
struct SeenDiscs {
  double t{};
  double temperature{};
  double motion{};  ///< kinetic energy relative to the mean flow [F L]
  Virial stress;    ///< of motion and contacts [F/L]
  ContactSums contacts;
  double lost{};       ///< energy dissipated by history-dependent contacts since the start [F L]
  const Discs& discs;  ///< with velocities half a step later
};

struct FollowPlan {
  double step{};
  long steps{};
  long every{1};             ///< number of steps between two samples
  double skin{0.3};          ///< of the neighbour list
  bool rest_frame{};         ///< temperature and stress from absolute velocities, not relative to the mean flow
  bool motion_left_out{};    ///< stress from contacts alone
  bool contacts_left_out{};  ///< stress from motion alone
};

/// Runs free discs with the leapfrog, and calls see(SeenDiscs) every plan.every steps.
template <HasContactKernel L, class See>
void follow(const Packing& start, const L& law, const FollowPlan& plan, See&& see) {
  record_use(law);
  FastDiscSystem system{start.shapes, start.box, law, plan.skin};
  Discs discs = start.discs;
  system.begin(discs);
  const double area = start.width * start.height, count = static_cast<double>(discs.size());
  const auto moving = [&] {
    const MeanFlow flow = plan.rest_frame ? MeanFlow{} : mean_flow(system.shapes(), discs, start.box.shear_rate);
    return kinetic_virial(system.shapes(), discs, flow);
  };
  for (long n = 0; n < plan.steps; ++n) {
    const Virial before = moving();
    system.kick(discs, plan.step);
    const Virial motion = 0.5 * (before + moving());
    const ContactSums contacts = contact_sums(system, discs);
    Virial stress;
    if (!plan.motion_left_out) stress = stress + 1.0 / area * motion;
    if (!plan.contacts_left_out) stress = stress + 1.0 / area * contacts.virial;
    double lost = 0.0;
    if constexpr (L::memory_size > 0) lost = system.lost();
    if (lost > 0.0) record_use(fmt::format("mechanism.{}", name_of(L::dissipation)));
    see(SeenDiscs{static_cast<double>(n) * plan.step, motion.pressure() / count, motion.pressure(), stress, contacts,
                  lost, discs});
    system.drift(discs, plan.step);
    const long unseen = std::min(plan.every, plan.steps - n) - 1;
    system.advance(discs, plan.step, unseen);
    n += unseen;
  }
}

}  // namespace talus::verification::problems
