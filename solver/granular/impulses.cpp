#include <cstring>

#include "solver/granular/disc_lanes.hpp"
#include "solver/granular/disc_stages.hpp"

namespace talus {
namespace stages {
namespace {

/// Gives discs the impulses of forces, in the order that it is told them.
template <bool turns>
class Giver {
 public:
  [[gnu::always_inline]] explicit Giver(const DiscSweep& w)
      : w_{w},
        velocities_{w.velocities},
        per_force_{w.impulse_per_force},
        unlike_mass_{w.unlike_mass},
        first_wall_{w.first_wall} {}

  /// To the disc there, by the k-th of these; and by the friction that turns it.
  [[gnu::always_inline]] void give(std::size_t at, Place force, const double* friction, const double* arm,
                                   std::size_t k) const {
    Place v, per_force;
    std::memcpy(&v, velocities_ + at, sizeof v);
    std::memcpy(&per_force, per_force_ + (at & unlike_mass_), sizeof per_force);
    v += per_force * force;
    std::memcpy(velocities_ + at, &v, sizeof v);
    if constexpr (turns)
      w_.spins[at / 2] += per_force[0] * friction[k] * arm[k] * w_.per_mass[at / 2 & w_.unlike_radius];
  }
  /// A force on b, of which a pushes back, to walls that they belong to.
  [[gnu::always_inline]] void give_walls(std::size_t a, std::size_t b, Place force) const {
    // The second disc of a pair has the larger number.
    if (b < first_wall_) return;
    const std::uint32_t of_a = w_.wall[a / 2], of_b = w_.wall[b / 2];
    if (of_a != DiscShapes::free) w_.wall_pushes[of_a].push_back({-force[0], -force[1]});
    if (of_b != DiscShapes::free) w_.wall_pushes[of_b].push_back({force[0], force[1]});
  }

 private:
  const DiscSweep& w_;
  double* const velocities_;
  const double* const per_force_;
  const std::size_t unlike_mass_, first_wall_;
};

[[gnu::always_inline]] inline Place force_of(const double* forces, std::size_t k) {
  Place force;
  std::memcpy(&force, forces + 2 * k, sizeof force);
  return force;
}

template <bool turns>
void give_out(const DiscSweep& w, std::size_t to_place, NextOutgoing& next) {
  const Giver<turns> giver{w};
  for (; next.first < to_place; next.go_on(w)) {
    const DiscPushes& out = *w.outgoing;
    const Place force = force_of(out.force.data(), next.pair);
    giver.give(next.first, -force, out.friction.data(), out.arm_a.data(), next.pair);
    giver.give_walls(next.first, own_place(w, out.second[next.pair]), force);
  }
}

template <bool turns>
[[gnu::always_inline]] inline void give_all(const DiscSweep& w, std::span<const std::uint32_t> touching,
                                            const Pushes& pushes, NextOutgoing& next) {
  const Giver<turns> giver{w};
  const std::uint32_t *const firsts = w.pairs->first.data(), *const seconds = w.pairs->second.data();
  std::size_t next_out = next.first;
  for (std::size_t t = 0; t < touching.size(); ++t) {
    const std::size_t a = firsts[touching[t]], b = own_place(w, seconds[touching[t]]);
    if (next_out < a) {
      give_out<turns>(w, a, next);
      next_out = next.first;
    }
    const Place force = force_of(pushes.force, t);
    giver.give(a, -force, pushes.friction, pushes.arm_a, t);
    giver.give(b, force, pushes.friction, pushes.arm_b, t);
    giver.give_walls(a, b, force);
  }
}

template <bool turns>
void give_in(const DiscSweep& w, const DiscPushes& pushes) {
  const Giver<turns> giver{w};
  for (std::size_t k = 0; k < pushes.count; ++k) {
    const std::size_t b = own_place(w, pushes.second[k]);
    if (b >= 2 * w.begin && b < 2 * w.end)
      giver.give(b, force_of(pushes.force.data(), k), pushes.friction.data(), pushes.arm_b.data(), k);
  }
}

}  // namespace

TALUS_CLONES void give(const DiscSweep& sweep, std::span<const std::uint32_t> touching, Pushes pushes,
                       NextOutgoing& next) {
  if (sweep.spins != nullptr)
    give_all<true>(sweep, touching, pushes, next);
  else
    give_all<false>(sweep, touching, pushes, next);
}

void give_outgoing(const DiscSweep& sweep, std::size_t to_place, NextOutgoing& next) {
  sweep.spins != nullptr ? give_out<true>(sweep, to_place, next) : give_out<false>(sweep, to_place, next);
}

}  // namespace stages

void receive(const DiscSweep& sweep, const DiscPushes& pushes) {
  sweep.spins != nullptr ? stages::give_in<true>(sweep, pushes) : stages::give_in<false>(sweep, pushes);
}

}  // namespace talus
