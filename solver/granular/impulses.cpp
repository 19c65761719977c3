#include <cstring>

#include "solver/granular/disc_lanes.hpp"
#include "solver/granular/disc_stages.hpp"

namespace talus {
namespace stages {
namespace {

/// Applies the impulses of forces to discs, in the order of the calls.
template <bool turns>
class ImpulseScatter {
 public:
  [[gnu::always_inline]] explicit ImpulseScatter(const StepBlock& w)
      : w_{w},
        velocities_{w.velocities},
        per_force_{w.impulse_per_force},
        per_disc_mass_{w.per_disc_mass},
        first_wall_{w.first_wall} {}

  /// Applies a force to the disc at index `at`, and the torque of the k-th friction and lever arm.
  [[gnu::always_inline]] void give(std::size_t at, Point force, const double* friction, const double* arm,
                                   std::size_t k) const {
    Point v, per_force;
    std::memcpy(&v, velocities_ + at, sizeof v);
    std::memcpy(&per_force, per_force_ + (at & per_disc_mass_), sizeof per_force);
    v += per_force * force;
    std::memcpy(velocities_ + at, &v, sizeof v);
    if constexpr (turns)
      w_.spins[at / 2] += per_force[0] * friction[k] * arm[k] * w_.per_mass[at / 2 & w_.per_disc_radius];
  }
  /// Records the force on b, and its reaction on a, for the walls that the discs belong to.
  [[gnu::always_inline]] void give_walls(std::size_t a, std::size_t b, Point force) const {
    // The second disc of a pair has the larger index.
    if (b < first_wall_) return;
    const std::uint32_t of_a = w_.wall[a / 2], of_b = w_.wall[b / 2];
    if (of_a != DiscShapes::free) w_.wall_forces[of_a].push_back({-force[0], -force[1]});
    if (of_b != DiscShapes::free) w_.wall_forces[of_b].push_back({force[0], force[1]});
  }

 private:
  const StepBlock& w_;
  double* const velocities_;
  const double* const per_force_;
  const std::size_t per_disc_mass_, first_wall_;
};

[[gnu::always_inline]] inline Point force_of(const double* forces, std::size_t k) {
  Point force;
  std::memcpy(&force, forces + 2 * k, sizeof force);
  return force;
}

template <bool turns>
void scatter_outgoing(const StepBlock& w, std::size_t to_index, NextOutgoing& next) {
  const ImpulseScatter<turns> scatter{w};
  for (; next.first < to_index; next.proceed(w)) {
    const PairForces& out = *w.outgoing;
    const Point force = force_of(out.force.data(), next.pair);
    scatter.give(next.first, -force, out.friction.data(), out.arm_a.data(), next.pair);
    scatter.give_walls(next.first, own_index(w, out.second[next.pair]), force);
  }
}

template <bool turns>
[[gnu::always_inline]] inline void give_all(const StepBlock& w, std::span<const std::uint32_t> touching,
                                            const Pushes& pushes, NextOutgoing& next) {
  const ImpulseScatter<turns> scatter{w};
  const std::uint32_t *const firsts = w.pairs->first.data(), *const seconds = w.pairs->second.data();
  std::size_t next_out = next.first;
  for (std::size_t t = 0; t < touching.size(); ++t) {
    const std::size_t a = firsts[touching[t]], b = own_index(w, seconds[touching[t]]);
    if (next_out < a) {
      scatter_outgoing<turns>(w, a, next);
      next_out = next.first;
    }
    const Point force = force_of(pushes.force, t);
    scatter.give(a, -force, pushes.friction, pushes.arm_a, t);
    scatter.give(b, force, pushes.friction, pushes.arm_b, t);
    scatter.give_walls(a, b, force);
  }
}

template <bool turns>
void scatter_incoming(const StepBlock& w, const PairForces& pushes) {
  const ImpulseScatter<turns> scatter{w};
  for (std::size_t k = 0; k < pushes.count; ++k) {
    const std::size_t b = own_index(w, pushes.second[k]);
    if (b >= 2 * w.begin && b < 2 * w.end)
      scatter.give(b, force_of(pushes.force.data(), k), pushes.friction.data(), pushes.arm_b.data(), k);
  }
}

}  // namespace

TALUS_CLONES void give(const StepBlock& sweep, std::span<const std::uint32_t> touching, Pushes pushes,
                       NextOutgoing& next) {
  if (sweep.spins != nullptr)
    give_all<true>(sweep, touching, pushes, next);
  else
    give_all<false>(sweep, touching, pushes, next);
}

void give_outgoing(const StepBlock& sweep, std::size_t to_index, NextOutgoing& next) {
  sweep.spins != nullptr ? scatter_outgoing<true>(sweep, to_index, next)
                         : scatter_outgoing<false>(sweep, to_index, next);
}

}  // namespace stages

void apply_incoming(const StepBlock& sweep, const PairForces& pushes) {
  sweep.spins != nullptr ? stages::scatter_incoming<true>(sweep, pushes)
                         : stages::scatter_incoming<false>(sweep, pushes);
}

}  // namespace talus
