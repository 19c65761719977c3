#pragma once

#include <algorithm>

#include "solver/granular/fast_disc_system.hpp"
#include "solver/granular/packing.hpp"
#include "solver/granular/stress.hpp"
#include "solver/laws/latching_spring.hpp"
#include "solver/laws/linear_spring_dashpot.hpp"
#include "verification/study/usage.hpp"

namespace talus::verification::problems {

/// A latching spring with that K1/K2, by which two discs of the mass touch for so long; e = sqrt(K1/K2).
[[nodiscard]] LatchingSpring latching_contact(double stiffness_ratio, double contact_time, double mass = 1.0);
/// A spring with a dashpot that cannot pull, by which two discs of the mass touch for so long and keep the share e.
[[nodiscard]] LinearSpringDashpot dashpot_contact(double restitution, double contact_time, double mass = 1.0);

/// Discs as they are at one time; their velocities are taken half a step before and after.
struct SeenDiscs {
  double t{};
  double temperature{};
  double motion{};  ///< energy relative to the mean flow [F L]
  Virial stress;    ///< of motion and contacts [F/L]
  ContactSums contacts;
  double lost{};       ///< by contacts of a law that remembers, from the start [F L]
  const Discs& discs;  ///< with velocities half a step after
};

struct FollowPlan {
  double step{};
  long steps{};
  long every{1};             ///< so many steps from look to look
  double skin{0.3};          ///< of the neighbour list
  bool rest_frame{};         ///< temperature and stress by the velocities as they are, not relative to the mean flow
  bool motion_left_out{};    ///< stress by the contacts alone
  bool contacts_left_out{};  ///< stress by the motion alone
};

/// Runs free discs by the leapfrog and shows them to see(SeenDiscs) now and then.
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
    if (lost > 0.0) record_use(fmt::format("mechanism.{}", mechanism_names[static_cast<std::size_t>(L::dissipation)]));
    see(SeenDiscs{static_cast<double>(n) * plan.step, motion.pressure() / count, motion.pressure(), stress, contacts,
                  lost, discs});
    system.drift(discs, plan.step);
    const long unseen = std::min(plan.every, plan.steps - n) - 1;
    system.advance(discs, plan.step, unseen);
    n += unseen;
  }
}

}  // namespace talus::verification::problems
