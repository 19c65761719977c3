#include "verification/problems/many_bodies/dense_runs.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <span>
#include <vector>

#include "solver/granular/disc_system.hpp"
#include "solver/granular/fast_disc_system.hpp"
#include "solver/laws/latching_spring.hpp"

namespace talus::verification::problems {

namespace {

constexpr double skin = 0.1;              ///< of neighbour lists [d]
constexpr long steps_a_look = 20;         ///< steps between two samples: two contact times
constexpr double tangential_ratio = 0.5;  ///< tangential over loading stiffness

using Plain = DiscSystem<LatchingSpring>;
using Smooth = FastDiscSystem<LatchingSpring>;
using Rough = FastDiscSystem<LatchingSpring, CoulombFriction>;

LatchingSpring law_of(const DensePlan& plan) { return {1.0, 1.0 / (plan.restitution * plan.restitution), 0.0}; }

double step_of(const DensePlan& plan) {
  return 0.5 * std::numbers::pi * (1.0 + plan.restitution) / std::sqrt(2.0) / plan.steps_in_contact;
}

/// Sums over the contacts that transmit a force.
struct Pushes {
  Virial virial;
  double depths{};  ///< sum of overlaps [d]
  double count{};

  void add(Vec2 force, Vec2 branch, double depth) {
    virial.add(force, branch);
    depths += depth;
    count += 1.0;
  }
};

template <class System>
Pushes pushes_of(const System& system, const Discs& discs) {
  Pushes sums;
  system.for_each_contact(discs, [&](const auto& contact) {
    if (contact.force != 0.0) sums.add(contact.force_on_b(), contact.distance * contact.n_ab, contact.depth);
  });
  return sums;
}

template <class System>
void advance(System& system, Discs& discs, double h, long steps) {
  if constexpr (requires { system.advance(discs, h, steps); }) {
    system.advance(discs, h, steps);
  } else {
    for (long n = 0; n < steps; ++n)
      system.kick(discs, h), system.drift(discs, h);
  }
}

/// Stress from motion and contacts, sampled at the kick of a step: the positions are at the time midway between those
/// of the velocities before and after.
struct Look {
  Virial stress{};
  Pushes pushes{};
};
template <class System>
Look kick_and_look(System& system, Discs& discs, double h, double area, bool with_contacts = true) {
  const auto moving = [&] {
    return kinetic_virial(system.shapes(), discs, mean_flow(system.shapes(), discs, system.list().box().shear_rate));
  };
  const Virial before = moving();
  system.kick(discs, h);
  const Pushes pushes = pushes_of(system, discs);
  const Virial motion = 0.5 * (before + moving());
  return {1.0 / area * (with_contacts ? motion + pushes.virial : motion), pushes};
}

enum Quantity : std::size_t { shear_stress, pressure, contacts, overlaps, quantities };

/// Runs one start; returns the number of steps.
template <class System>
long follow(System system, const Packing& start, double h, const DensePlan& plan, BlockMeans& means) {
  Discs discs = start.discs;
  system.begin(discs);
  const long first = std::lround(plan.before / plan.shear_rate / h);
  const long last = std::lround((plan.before + plan.strain) / plan.shear_rate / h);
  advance(system, discs, h, first);
  for (long n = first; n < last; n += steps_a_look) {
    const Look look = kick_and_look(system, discs, h, start.width * start.height, !plan.motion_alone);
    means.add(static_cast<double>(n - first) * h, 1.0,
              std::array{-look.stress.xy, look.stress.pressure(), look.pushes.count, look.pushes.depths});
    system.drift(discs, h);
    advance(system, discs, h, steps_a_look - 1);
  }
  return last;
}

/// Mean over the starts; its error is the larger of that from blocks and that from the scatter of the starts.
Estimate of_starts(std::span<const Estimate> starts) {
  const auto count = static_cast<double>(starts.size());
  double sum = 0.0, squares = 0.0, scatter = 0.0;
  for (const Estimate& one : starts)
    sum += one.value, squares += one.error * one.error;
  const double mean = sum / count;
  for (const Estimate& one : starts)
    scatter += (one.value - mean) * (one.value - mean);
  const double by_starts = starts.size() < 2 ? 0.0 : std::sqrt(scatter / (count - 1.0) / count);
  return {mean, std::max(std::sqrt(squares) / count, by_starts)};
}

}  // namespace

Packing dense_packing(const DensePlan& plan, std::uint64_t seed) {
  const double grown = std::min(plan.fraction, 0.82);
  Packing packing = grow({.discs = plan.discs,
                          .diameter = 1.0,
                          .spread = plan.spread,
                          .mass = 1.0,
                          .solid_fraction = grown,
                          .seed = seed});
  for (double& radius : packing.shapes.radius)
    radius *= std::sqrt(plan.fraction / grown);
  packing.box.shear_rate = plan.still_box ? 0.0 : plan.shear_rate;
  for (std::size_t i = 0; i < plan.discs; ++i)
    packing.discs.vx[i] += plan.shear_rate * packing.discs.y[i];
  return packing;
}

DenseFlow run_dense(const DensePlan& plan) {
  const LatchingSpring law = law_of(plan);
  const double h = step_of(plan), rate = plan.shear_rate;
  DenseFlow found{.fraction = plan.fraction};
  std::vector<Estimate> frictions, inertials, pressures;
  double contact_sum = 0.0, overlap_sum = 0.0;
  for (std::uint64_t seed = 1; seed <= plan.starts; ++seed) {
    const Packing start = dense_packing(plan, seed);
    BlockMeans means{quantities, plan.strain / rate, 10};
    const long steps =
        plan.friction == 0.0
            ? follow(Smooth{start.shapes, start.box, law, skin}, start, h, plan, means)
            : follow(Rough{start.shapes, start.box, law, skin, {plan.friction, tangential_ratio * law.stiffness}},
                     start, h, plan, means);
    found.steps += static_cast<std::uint64_t>(steps);
    frictions.push_back(means.ratio(shear_stress, pressure, 0));
    const Estimate p = means.estimate(pressure, 0);
    pressures.push_back(p);
    const double inertial = rate * std::sqrt(4.0 / (std::numbers::pi * p.value));
    inertials.push_back({inertial, 0.5 * inertial * p.error / p.value});
    contact_sum += means.mean(contacts, 0, means.blocks());
    overlap_sum += means.mean(overlaps, 0, means.blocks());
  }
  found.friction = of_starts(frictions), found.inertial = of_starts(inertials), found.pressure = of_starts(pressures);
  found.coordination = 2.0 * contact_sum / static_cast<double>(plan.discs * plan.starts);
  found.overlap = contact_sum > 0.0 ? overlap_sum / contact_sum : 0.0;
  return found;
}

BothStresses stress_by_both(const DensePlan& plan, long steps) {
  const Packing start = dense_packing(plan, 1);
  const double h = step_of(plan), area = start.width * start.height;
  const auto after = [&](auto system) {
    Discs discs = start.discs;
    system.begin(discs);
    advance(system, discs, h, steps);
    return kick_and_look(system, discs, h, area).stress;
  };
  const LatchingSpring law = law_of(plan);
  return {after(Smooth{start.shapes, start.box, law, skin}), after(Plain{start.shapes, start.box, law, skin})};
}

}  // namespace talus::verification::problems
