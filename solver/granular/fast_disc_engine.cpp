#include "solver/granular/fast_disc_engine.hpp"

#include <algorithm>
#include <functional>
#include <string>
#include <utility>

#include "solver/base/error.hpp"
#include "solver/granular/step_block.hpp"

namespace talus {
namespace {

/// The value of all numbers if they are equal, else 0.
double common(const std::vector<double>& numbers) {
  const bool equal = std::adjacent_find(numbers.begin(), numbers.end(), std::not_equal_to{}) == numbers.end();
  return equal && !numbers.empty() ? numbers.front() : 0.0;
}

}  // namespace

FastDiscEngine::FastDiscEngine(const Traits& traits, DiscShapes shapes, PeriodicBox box, double skin,
                               std::size_t threads)
    : traits_{traits},
      shapes_{std::move(shapes)},
      list_{box, skin, traits.reach},
      skin_{skin},
      kinds_{.largest = traits.has_history, .stretch = traits.turns, .normal = traits.turns},
      stripes_(threads) {
  if (threads == 0) throw InputError{"threads: found 0; it must be >= 1"};
  equal_radii_ = 2.0 * common(shapes_.radius);
  equal_masses_ = common(shapes_.inverse_mass) != 0.0;
  if (traits_.turns) {
    for (const double radius : shapes_.radius)
      per_mass_.push_back(2.0 / (radius * radius));
  }
  impulse_per_force_.resize(equal_masses_ ? 2 : 2 * shapes_.size());
  wall_forces_.resize(shapes_.walls.size() + 1);
  first_wall_ = static_cast<std::size_t>(
      std::find_if(shapes_.wall.begin(), shapes_.wall.end(), [](auto wall) { return wall != DiscShapes::free; }) -
      shapes_.wall.begin());
  for (std::size_t i = 0; i < shapes_.size(); ++i) {
    const std::size_t wall = shapes_.wall[i];
    if (wall == DiscShapes::free || !(shapes_.walls[wall - 1].mass > 0.0)) continue;
    if (moved_.empty() || moved_.back().wall != wall || moved_.back().end != i) moved_.push_back({wall, i, i});
    ++moved_.back().end;
  }
  for (Stripe& stripe : stripes_)
    stripe.wall_forces.resize(wall_forces_.size());
}

void FastDiscEngine::begin(Discs& discs) {
  if (traits_.turns) discs.spin.resize(discs.size());
  for (Stripe& stripe : stripes_)
    stripe.own.contacts.clear(kinds_), stripe.outgoing.contacts.clear(kinds_);
  lost_ = 0.0;
  rebuild(discs);
  if (!traits_.turns) return;
  // Contacts that exist already stick.
  std::vector<Kept> there;
  list_.for_each_pair(discs, [&](std::size_t a, std::size_t b, std::size_t, Vec2 d, const auto&) {
    if (norm(d) < shapes_.radius[a] + shapes_.radius[b])
      there.push_back({static_cast<std::uint32_t>(a), static_cast<std::uint32_t>(b), {.normal = 1.0}});
  });
  take_contacts(there);
}

void FastDiscEngine::kick(Discs& discs, double h) {
  load(discs);
  sweep(h, 0.0);
  store(discs);
}

void FastDiscEngine::drift(Discs& discs, double h) {
  load(discs);
  sweep(0.0, h);
  end_drift(discs, h);
  store(discs);
}

void FastDiscEngine::evaluate(Discs& discs, DiscRates& out) {
  load(discs);
  rates_.assign(velocities_.size(), 0.0), spin_rates_.assign(spins_.size(), 0.0);
  begin_kick();
  // Impulses over a time of 1, applied to discs at rest, are accelerations.
  velocities_.swap(rates_), spins_.swap(spin_rates_);
  sweep_pairs(1.0, 0.0);
  velocities_.swap(rates_), spins_.swap(spin_rates_);
  for (std::size_t i = 0; i < discs.size(); ++i)
    out.vx[i] = rates_[2 * i], out.vy[i] = rates_[2 * i + 1];
  std::copy(spin_rates_.begin(), spin_rates_.end(), out.spin.begin());
  discs.work = work_;
  out.work.fill(0.0);
  out.work[static_cast<std::size_t>(traits_.dissipation)] = power_;
  out.work[static_cast<std::size_t>(Mechanism::friction)] += friction_power_;
}

void FastDiscEngine::update_modes(Discs& discs) {
  DiscRates none{discs};
  evaluate(discs, none);
  --evaluations_;
}

/// One step: kick and drift, without those whose duration is 0.
void FastDiscEngine::sweep(double kick, double drift) {
  if (kick != 0.0) begin_kick();
  double fastest = sweep_pairs(kick, traits_.turns ? 0.0 : drift);
  if (kick != 0.0) {
    work_[static_cast<std::size_t>(traits_.dissipation)] += kick * power_;
    work_[static_cast<std::size_t>(Mechanism::friction)] += kick * friction_power_;
  }
  if (traits_.turns && drift != 0.0) {
    each([&](Stripe& stripe) {
      if (kick == 0.0) set_ghosts(stripe, positions_.data(), &NeighbourList::Shift::x);
      StepBlock of = work(stripe, false, drift);
      of.pairs = &numbered(stripe.own);
      stretch_contacts(of);
      of.pairs = &numbered(stripe.outgoing), of.contacts = &stripe.outgoing.contacts;
      stretch_contacts(of);
    });
    each([&](Stripe& stripe) { stripe.fastest = move_discs(work(stripe, false, drift)); });
    for (const Stripe& stripe : stripes_)
      fastest = std::max(fastest, stripe.fastest);
  }
  approach_ = list_.approach(drift, fastest);
}

void FastDiscEngine::begin_kick() {
  ++evaluations_;
  if (sees_rates()) each([this](Stripe& stripe) { copy_before(stripe); });
}

/// Kicks and drifts the discs; returns their largest squared speed relative to the mean flow, if they drift.
double FastDiscEngine::sweep_pairs(double kick, double drift) {
  if (kick != 0.0) {
    if (kick != kicked_) {
      kicked_ = kick;
      for (std::size_t k = 0; k < impulse_per_force_.size(); ++k)
        impulse_per_force_[k] = kick * shapes_.inverse_mass[k / 2];
    }
    each([&](Stripe& stripe) { find_outgoing(stripe); });
  }
  each([&](Stripe& stripe) {
    StepBlock of = work(stripe, kick != 0.0, drift);
    of.later = moved_;
    for (const Stripe& earlier : stripes_) {
      if (&earlier == &stripe || kick == 0.0) break;
      apply_incoming(of, earlier.pushes);
    }
    stripe.fastest = kick_and_drift(of);
  });
  if (kick != 0.0) accumulate_ledger(), kick_walls(kick);
  double fastest = 0.0;
  for (const Stripe& stripe : stripes_)
    fastest = std::max(fastest, stripe.fastest);
  if (drift != 0.0) fastest = std::max(fastest, drift_walls(drift));
  return fastest;
}

void FastDiscEngine::kick_walls(double kick) {
  for (std::size_t wall = 1; wall < wall_forces_.size(); ++wall) {
    Vec2 force;
    for (const Stripe& stripe : stripes_) {
      for (const Vec2 push : stripe.wall_forces[wall])
        force += push;
    }
    wall_forces_[wall] = force;
  }
  for (const WallDiscs& of : moved_) {
    const DiscWall& wall = shapes_.walls[of.wall - 1];
    const double change = kick * (wall_forces_[of.wall].y / wall.mass - wall.gravity);
    for (std::size_t disc = of.begin; disc < of.end; ++disc)
      velocities_[2 * disc + 1] += change;
  }
}

/// Moves the wall discs once the forces on walls are known; returns their largest squared speed relative to the mean
/// flow.
double FastDiscEngine::drift_walls(double drift) {
  double fastest = 0.0;
  for (const WallDiscs& of : moved_) {
    StepBlock those = work(stripes_.front(), false, drift);
    those.begin = of.begin, those.end = of.end;
    fastest = std::max(fastest, move_discs(those));
  }
  return fastest;
}

/// Accumulates the energy dissipated by contacts at this evaluation, in the order of pairs.
void FastDiscEngine::accumulate_ledger() {
  power_ = friction_power_ = 0.0;
  ended_.clear();
  for (Stripe& stripe : stripes_) {
    ended_.insert(ended_.end(), stripe.ended.begin(), stripe.ended.end());
    stripe.ended.clear();
  }
  const SweptContacts::Kinds kinds = stripes_.front().own.contacts.kinds;
  if (ended_.empty() && !kinds.reported()) return;
  std::sort(ended_.begin(), ended_.end(), [](const auto& a, const auto& b) { return a.pair < b.pair; });
  double& released = work_[static_cast<std::size_t>(traits_.release)];
  double& friction_work = work_[static_cast<std::size_t>(Mechanism::friction)];
  auto ended = ended_.begin();
  const auto record_ended = [&](std::size_t before) {
    for (; ended != ended_.end() && ended->pair < before; ++ended) {
      lost_ += hysteresis_loss(ended->largest);
      if (kinds.friction_work) friction_work += friction_energy(ended->stretch);
    }
  };
  if (kinds.reported()) {
    for_each_touching([&](const SweptContacts& of, std::size_t t, std::size_t pair) {
      if (kinds.friction_work) record_ended(pair), friction_work += of.friction_work[t];
      if (kinds.area_power) friction_power_ += of.area_power[t];
      if (kinds.power) power_ += of.power[t], released += of.released[t];
    });
  }
  record_ended(list_.size());
}

void FastDiscEngine::copy_before(Stripe& stripe) {
  const std::size_t discs = stripe.end - stripe.begin;
  std::copy_n(velocities_.data() + 2 * stripe.begin, 2 * discs, before_.data() + 2 * stripe.begin);
  if (traits_.turns) std::copy_n(spins_.data() + stripe.begin, discs, spins_before_.data() + stripe.begin);
}

/// Evaluates the outgoing pairs of a stripe.
void FastDiscEngine::find_outgoing(Stripe& stripe) {
  set_ghosts(stripe, positions_.data(), &NeighbourList::Shift::x);
  if (sees_rates()) set_ghosts(stripe, before_.data(), &NeighbourList::Shift::vx);
  for (std::vector<Vec2>& pushes : stripe.wall_forces)
    pushes.clear();
  if (stripes_.size() == 1) return;
  StepBlock of = work(stripe, true, 0.0);
  of.pairs = &stripe.outgoing.near, of.contacts = &stripe.outgoing.contacts;
  evaluate_pair_forces(of, stripe.pushes);
}

StepBlock FastDiscEngine::work(Stripe& stripe, bool kicks, double drift) {
  return {.kicks = kicks,
          .drift = drift,
          .reach = traits_.reach,
          .flow = list_.flow(),
          .positions = positions_.data(),
          .velocities = velocities_.data(),
          .spins = traits_.turns ? spins_.data() : nullptr,
          .before = sees_rates() ? before_.data() : nullptr,
          .spins_before = spins_before_.data(),
          .discs = shapes_.size(),
          .begin = stripe.begin,
          .end = stripe.end,
          .later = {},
          .ghost_disc = ghost_disc_.data(),
          .ghost_image = ghost_image_.data(),
          .shifts = shifts_.data(),
          .impulse_per_force = impulse_per_force_.data(),
          .radius = shapes_.radius.data(),
          .per_mass = per_mass_.data(),
          .per_disc_mass = equal_masses_ ? std::size_t{0} : ~std::size_t{0},
          .per_disc_radius = equal_radii_ > 0.0 ? std::size_t{0} : ~std::size_t{0},
          .equal_radii = equal_radii_,
          .wall = shapes_.wall.data(),
          .first_wall = 2 * first_wall_,
          .pairs = &pairs(stripe.own),
          .contacts = &stripe.own.contacts,
          .ended = &stripe.ended,
          .wall_forces = stripe.wall_forces.data(),
          .outgoing = &stripe.pushes};
}

/// Updates the lists after all discs have moved.
void FastDiscEngine::end_drift(Discs& discs, double h) {
  shear_displacement_ += h * list_.box().sliding();
  if (list_.box().sliding() != 0.0) list_.shifts(shear_displacement_, shifts_);
  list_.use(approach_);
  used_ += approach_;
  if (list_.may_end()) {
    store(discs);
    if (!list_.holds(discs)) return rebuild(discs);
  }
  if (all_near_ || used_ > (1.0 - round_off) * reach_) prune();
}

void FastDiscEngine::load(const Discs& discs) {
  each([&](const Stripe& stripe) {
    for (std::size_t i = stripe.begin; i < stripe.end; ++i) {
      positions_[2 * i] = discs.x[i], positions_[2 * i + 1] = discs.y[i];
      velocities_[2 * i] = discs.vx[i], velocities_[2 * i + 1] = discs.vy[i];
    }
  });
  if (traits_.turns) std::copy(discs.spin.begin(), discs.spin.end(), spins_.begin());
  shear_displacement_ = discs.shear_displacement, work_ = discs.work;
  list_.shifts(shear_displacement_, shifts_);
}

void FastDiscEngine::store(Discs& discs) {
  each([&](const Stripe& stripe) {
    for (std::size_t i = stripe.begin; i < stripe.end; ++i) {
      discs.x[i] = positions_[2 * i], discs.y[i] = positions_[2 * i + 1];
      discs.vx[i] = velocities_[2 * i], discs.vy[i] = velocities_[2 * i + 1];
    }
  });
  if (traits_.turns) std::copy(spins_.begin(), spins_.end(), discs.spin.begin());
  discs.shear_displacement = shear_displacement_, discs.work = work_;
}

/// Computes the positions of a stripe's ghosts, or their velocities before the kick.
void FastDiscEngine::set_ghosts(Stripe& stripe, double* numbers, double NeighbourList::Shift::*along) {
  const bool of_positions = along == &NeighbourList::Shift::x;
  double* ghost = numbers + velocities_.size() + 2 * stripe.first_ghost;
  for (std::size_t g = stripe.first_ghost; g < stripe.end_of_ghosts; ++g, ghost += 2) {
    const double* const of = numbers + 2 * std::size_t{ghost_disc_[g]};
    const NeighbourList::Shift& shift = shifts_[ghost_image_[g]];
    ghost[0] = of[0] + shift.*along, ghost[1] = of_positions ? of[1] + shift.y : of[1];
  }
}

double FastDiscEngine::lost() const {
  double lost = lost_;
  if (!traits_.has_history) return lost;
  for_each_touching([&](const SweptContacts& contacts, std::size_t t, std::size_t) {
    lost += hysteresis_loss(contacts.memory(contacts.now, t).largest);
  });
  return lost;
}

void FastDiscEngine::serialize(Archive& archive, const Discs& discs) {
  archive.scope("list", [&] { list_.serialize(archive, shapes_); });
  std::vector<double> first, second, largest, stretch, normal;
  if (!archive.is_loading()) {
    for (const Kept& contact : kept_contacts()) {
      first.push_back(contact.first), second.push_back(contact.second);
      largest.push_back(contact.memory.largest), stretch.push_back(contact.memory.stretch);
      normal.push_back(contact.memory.normal);
    }
  }
  archive.scope("contact", [&] {
    archive.list("first", first), archive.list("second", second);
    archive.list("largest", largest), archive.list("stretch", stretch), archive.list("normal", normal);
  });
  archive.number("dissipated", lost_);
  if (!archive.is_loading()) return;
  for (const auto* numbers : {&second, &largest, &stretch, &normal}) {
    if (numbers->size() != first.size()) {
      throw InputError{"contact: found " + std::to_string(numbers->size()) + " numbers of one kind and " +
                       std::to_string(first.size()) + " of another; there must be one of each for each contact"};
    }
  }
  list_stripes();
  list_positions();
  std::vector<Kept> kept;
  for (std::size_t k = 0; k < first.size(); ++k)
    kept.push_back({static_cast<std::uint32_t>(first[k]),
                    static_cast<std::uint32_t>(second[k]),
                    {largest[k], stretch[k], normal[k]}});
  take_contacts(kept);
  load(discs);
  prune();
}

}  // namespace talus
