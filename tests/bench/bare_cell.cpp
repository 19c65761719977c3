#include "tests/bench/bare_cell.hpp"

#include <algorithm>
#include <array>
#include <cstring>
#include <limits>
#include <utility>
#include <variant>

#include "solver/granular/disc_lanes.hpp"

namespace talus::bench {
namespace {

constexpr double near = 0.02;  ///< reach of the near list beyond contact, in diameters: 0.01 to 0.04 take as long

std::size_t whole_packs(std::size_t pairs) { return (pairs + pack_size - 1) / pack_size * pack_size; }

}  // namespace

BareCell::BareCell(const ShearCell& cell, const FilledCell& start, double skin)
    : shapes_{start.shapes},
      list_{start.box, skin},
      law_{std::get<LatchingSpring>(cell.law)},
      diameter_{cell.diameter},
      block_mass_{cell.block_mass},
      gravity_{cell.gravity},
      reach_{near * cell.diameter},
      base_{2 * cell.free_discs()},
      block_{2 * first_block_disc(cell)} {}

void BareCell::advance(Discs& discs, double h, long steps) {
  impulse_ = h * shapes_.inverse_mass.front();
  load(discs);
  for (long n = 0; n < steps; ++n) {
    set_ghosts();
    give(push());
    const double change = h * (force_on_block_ / block_mass_ - gravity_);
    for (std::size_t i = block_; i < velocities_.size(); i += 2)
      velocities_[i + 1] += change;
    const double approach = list_.approach(h, move_discs(all(h)));
    list_.use(approach), used_ += approach;
    if (list_.may_end()) {
      store(discs);
      if (!list_.holds(discs)) {
        list(discs);
        continue;
      }
    }
    if (used_ + approach > reach_) prune();
  }
  store(discs);
}

StepBlock BareCell::all(double drift) {
  StepBlock all;
  all.drift = drift, all.flow = list_.flow();
  all.positions = positions_.data(), all.velocities = velocities_.data(), all.end = shapes_.size();
  all.equal_radii = diameter_;
  all.pairs = &listed_;
  return all;
}

void BareCell::list(Discs& discs) {
  struct Kept {
    std::size_t first, second;
    double largest;
  };
  std::vector<Kept> kept;
  for (std::size_t k = 0; k < near_.count; ++k) {
    if (largest_[k] != 0.0) kept.push_back({near_.first[k] / 2, own(near_.second[k]) / 2, largest_[k]});
  }
  wrap(list_.box(), discs);
  list_.build(shapes_, discs);

  listed_.list(list_.size(), false);
  ghosts_.clear(), shifts_.clear();
  list_.for_each_pair(discs, [&](std::size_t a, std::size_t b, std::size_t pair, Vec2, const auto& shift) {
    std::size_t position = b;
    if (shift.x != 0.0) {
      std::size_t ghost = 0;
      while (ghost < ghosts_.size() && (ghosts_[ghost] != 2 * b || shifts_[ghost] != shift.x))
        ++ghost;
      if (ghost == ghosts_.size()) ghosts_.push_back(static_cast<std::uint32_t>(2 * b)), shifts_.push_back(shift.x);
      position = shapes_.size() + ghost;
    }
    listed_.first[pair] = static_cast<std::uint32_t>(2 * a);
    listed_.second[pair] = static_cast<std::uint32_t>(2 * position);
  });
  positions_.assign(2 * (shapes_.size() + ghosts_.size() + 1), std::numeric_limits<double>::quiet_NaN());
  listed_.fill_up(static_cast<std::uint32_t>(positions_.size() - 2));
  kept_.assign(list_.size(), 0.0);
  for (const Kept& contact : kept)
    kept_[list_.find(contact.first, contact.second)] = contact.largest;
  near_.count = 0;
  load(discs);
  prune();
}

void BareCell::load(const Discs& discs) {
  velocities_.resize(2 * discs.size());
  for (std::size_t i = 0; i < discs.size(); ++i) {
    positions_[2 * i] = discs.x[i], positions_[2 * i + 1] = discs.y[i];
    velocities_[2 * i] = discs.vx[i], velocities_[2 * i + 1] = discs.vy[i];
  }
}

void BareCell::store(Discs& discs) const {
  for (std::size_t i = 0; i < discs.size(); ++i) {
    discs.x[i] = positions_[2 * i], discs.y[i] = positions_[2 * i + 1];
    discs.vx[i] = velocities_[2 * i], discs.vy[i] = velocities_[2 * i + 1];
  }
}

void BareCell::set_ghosts() {
  double* position = positions_.data() + velocities_.size();
  for (std::size_t ghost = 0; ghost < ghosts_.size(); ++ghost, position += 2)
    position[0] = positions_[ghosts_[ghost]] + shifts_[ghost], position[1] = positions_[ghosts_[ghost] + 1];
}

void BareCell::prune() {
  for (std::size_t k = 0; k < near_.count; ++k)
    kept_[near_.listed[k]] = largest_[k];
  used_ = 0.0;
  set_ghosts();
  std::array<std::uint32_t, sweep_block + pack_size> found;
  near_.count = 0;
  for (std::size_t from = 0; from < listed_.count; from += sweep_block) {
    const std::size_t to = std::min(from + sweep_block, whole_packs(listed_.count));
    near_.take(listed_, {found.data(), find_near(all(0.0), reach_, from, to, found.data())});
  }
  near_.fill_up(static_cast<std::uint32_t>(positions_.size() - 2));
  const std::size_t room = whole_packs(near_.count);
  largest_.assign(room, 0.0), forces_.resize(2 * room), touching_.resize(room + pack_size);
  for (std::size_t k = 0; k < near_.count; ++k)
    largest_[k] = std::exchange(kept_[near_.listed[k]], 0.0);
}

/// Computes the forces of the near pairs; returns the number of pairs in contact.
TALUS_CLONES std::size_t BareCell::push() {
  const double* const positions = positions_.data();
  const std::uint32_t *const first = near_.first.data(), *const second = near_.second.data();
  double *const largest_of = largest_.data(), *const forces = forces_.data();
  std::uint32_t* const touching = touching_.data();
  const LatchingSpring law = law_;
  const Pack diameter = Pack{} + diameter_;
  std::size_t count = 0;
  for (std::size_t k = 0; k < near_.count; k += pack_size) {
    Pack x, y, largest, distance, force;
    listed_differences(x, y, positions, first + k, second + k);
    talus::load(largest, largest_of + k);
    distance = x * x + y * y;
    square_root(distance);
    const Pack overlap = diameter - distance;
    law.force(overlap, overlap, largest, force);
    const Sizes overlaps = overlap > Pack{};
    keep_where(largest, overlaps);
    talus::store(largest, largest_of + k);
    store_points(force * (x / distance), force * (y / distance), forces + 2 * k);
    count += number_lanes(bits_of(overlaps), k, touching + count);
  }
  return count;
}

TALUS_CLONES void BareCell::give(std::size_t touching) {
  const std::uint32_t *const first = near_.first.data(), *const second = near_.second.data();
  const double* const forces = forces_.data();
  double* const velocities = velocities_.data();
  const double per_force = impulse_;
  double on_block = 0.0;
  for (std::size_t t = 0; t < touching; ++t) {
    const std::size_t pair = touching_[t], a = first[pair], b = own(second[pair]);
    Point force, v;
    std::memcpy(&force, forces + 2 * pair, sizeof force);
    const Point impulse = per_force * force;
    std::memcpy(&v, velocities + a, sizeof v);
    v -= impulse;
    std::memcpy(velocities + a, &v, sizeof v);
    if (b >= base_) {
      if (b >= block_) on_block += force[1];
      continue;
    }
    std::memcpy(&v, velocities + b, sizeof v);
    v += impulse;
    std::memcpy(velocities + b, &v, sizeof v);
  }
  force_on_block_ = on_block;
}

}  // namespace talus::bench
