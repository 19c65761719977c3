#include "tests/bench/bare_cell.hpp"

#include <algorithm>
#include <cstring>
#include <limits>
#include <variant>

#include "solver/granular/disc_lanes.hpp"
#include "solver/granular/disc_sweep.hpp"

namespace talus::bench {

BareCell::BareCell(const ShearCell& cell, const FilledCell& start, double skin)
    : shapes_{start.shapes},
      list_{start.box, skin},
      law_{std::get<LatchingSpring>(cell.law)},
      diameter_{cell.diameter},
      block_mass_{cell.block_mass},
      gravity_{cell.gravity},
      base_{2 * cell.free_discs()},
      block_{2 * first_block_disc(cell)} {}

void BareCell::advance(Discs& discs, double h, long steps) {
  impulses_.clear();
  for (const double inverse_mass : shapes_.inverse_mass)
    impulses_.insert(impulses_.end(), 2, h * inverse_mass);
  load(discs);
  for (long n = 0; n < steps; ++n) {
    place_ghosts();
    const std::size_t touching = find_touching();
    push(touching);
    give(touching);
    const double change = h * (force_on_block_ / block_mass_ - gravity_);
    for (std::size_t i = block_; i < velocities_.size(); i += 2)
      velocities_[i + 1] += change;
    DiscSweep all;
    all.drift = h, all.flow = list_.flow();
    all.places = places_.data(), all.velocities = velocities_.data(), all.end = shapes_.size();
    list_.use(list_.approach(h, move_discs(all)));
    if (!list_.may_end()) continue;
    store(discs);
    if (!list_.holds(discs)) list(discs);
  }
  store(discs);
}

void BareCell::list(Discs& discs) {
  struct Kept {
    std::size_t first, second;
    double largest;
  };
  std::vector<Kept> kept;
  for (std::size_t pair = 0; pair < largest_.size(); ++pair) {
    if (largest_[pair] == 0.0) continue;
    kept.push_back({first_[pair] / 2, own(second_[pair]) / 2, largest_[pair]});
  }
  wrap(list_.box(), discs);
  list_.build(shapes_, discs);

  const std::size_t room = (list_.size() + pack_size - 1) / pack_size * pack_size;
  largest_.assign(room, 0.0), touched_.assign(room / pack_size, 0), touching_now_.resize(room / pack_size);
  for (const Kept& contact : kept) {
    const std::size_t pair = list_.find(contact.first, contact.second);
    largest_[pair] = contact.largest;
    touched_[pair / pack_size] |= std::uint64_t{0xff} << (8 * (pair % pack_size));
  }
  first_.clear(), second_.clear(), ghosts_.clear(), shifts_.clear();
  list_.for_each_pair(discs, [&](std::size_t a, std::size_t b, std::size_t, Vec2, const NeighbourList::Shift& shift) {
    first_.push_back(static_cast<std::uint32_t>(2 * a));
    std::size_t place = b;
    if (shift.x != 0.0) {
      std::size_t ghost = 0;
      while (ghost < ghosts_.size() && (ghosts_[ghost] != 2 * b || shifts_[ghost] != shift.x))
        ++ghost;
      if (ghost == ghosts_.size()) ghosts_.push_back(static_cast<std::uint32_t>(2 * b)), shifts_.push_back(shift.x);
      place = shapes_.size() + ghost;
    }
    second_.push_back(static_cast<std::uint32_t>(2 * place));
  });
  const std::size_t nowhere = 2 * (shapes_.size() + ghosts_.size());
  first_.resize(room, static_cast<std::uint32_t>(nowhere)), second_.resize(room, static_cast<std::uint32_t>(nowhere));
  touching_.resize(room + pack_size), forces_.resize(2 * (room + pack_size));
  places_.assign(nowhere + 2, std::numeric_limits<double>::quiet_NaN());
  load(discs);
}

void BareCell::load(const Discs& discs) {
  velocities_.resize(2 * discs.size());
  for (std::size_t i = 0; i < discs.size(); ++i) {
    places_[2 * i] = discs.x[i], places_[2 * i + 1] = discs.y[i];
    velocities_[2 * i] = discs.vx[i], velocities_[2 * i + 1] = discs.vy[i];
  }
}

void BareCell::store(Discs& discs) const {
  for (std::size_t i = 0; i < discs.size(); ++i) {
    discs.x[i] = places_[2 * i], discs.y[i] = places_[2 * i + 1];
    discs.vx[i] = velocities_[2 * i], discs.vy[i] = velocities_[2 * i + 1];
  }
}

void BareCell::place_ghosts() {
  double* place = places_.data() + velocities_.size();
  for (std::size_t ghost = 0; ghost < ghosts_.size(); ++ghost, place += 2)
    place[0] = places_[ghosts_[ghost]] + shifts_[ghost], place[1] = places_[ghosts_[ghost] + 1];
}

TALUS_CLONES std::size_t BareCell::find_touching() {
  const double* const places = places_.data();
  const std::uint32_t *const first = first_.data(), *const second = second_.data();
  double* const largest = largest_.data();
  std::uint64_t *const touched = touched_.data(), *const now = touching_now_.data();
  std::uint32_t* const touching = touching_.data();
  const Pack within = Pack{} + diameter_ * diameter_;
  const std::size_t packs = touched_.size();
  for (std::size_t k = 0; k < packs; ++k) {
    Pack x, y;
    listed_differences(x, y, places, first + k * pack_size, second + k * pack_size);
    now[k] = bytes_of(x * x + y * y < within);
  }
  std::size_t count = 0;
  for (std::size_t k = 0; k < packs; ++k) {
    const std::uint64_t ended = touched[k] & ~now[k];
    touched[k] = now[k];
    if (ended != 0) {
      for (std::size_t l = 0; l < pack_size; ++l)
        if ((ended >> (8 * l) & 1U) != 0) largest[k * pack_size + l] = 0.0;
    }
    const std::size_t bits = bits_of(now[k]);
    Numbers numbers;
    std::memcpy(&numbers, chosen.lanes[bits].data(), sizeof numbers);
    numbers += static_cast<std::uint32_t>(k * pack_size);
    std::memcpy(touching + count, &numbers, sizeof numbers);
    count += chosen.count[bits];
  }
  std::fill_n(touching + count, pack_size, count == 0 ? 0 : touching[count - 1]);
  return count;
}

TALUS_CLONES void BareCell::push(std::size_t count) {
  const double* const places = places_.data();
  const std::uint32_t *const first = first_.data(), *const second = second_.data();
  double *const largest_of = largest_.data(), *const forces = forces_.data();
  const LatchingSpring law = law_;
  const double diameter = diameter_;
  for (std::size_t t = 0; t < count; t += pack_size) {
    const std::uint32_t* const pairs = touching_.data() + t;
    Pack x, y, largest, distance, force;
    differences(x, y, places, first, second, pairs);
    collect(largest, largest_of, pairs);
    distance = x * x + y * y;
    square_root(distance);
    const Pack overlap = diameter - distance;
    law.settled(overlap, overlap, largest, force);
    for (std::size_t l = 0; l < pack_size; ++l)
      largest_of[pairs[l]] = largest[l];
    store_places(force * (x / distance), force * (y / distance), forces + 2 * t);
  }
}

TALUS_CLONES void BareCell::give(std::size_t count) {
  const std::uint32_t *const first = first_.data(), *const second = second_.data();
  const double *const forces = forces_.data(), *const impulses = impulses_.data();
  double* const velocities = velocities_.data();
  double on_block = 0.0;
  for (std::size_t t = 0; t < count; ++t) {
    const std::size_t a = first[touching_[t]], b = own(second[touching_[t]]);
    Place force, v, impulse;
    std::memcpy(&force, forces + 2 * t, sizeof force);
    std::memcpy(&v, velocities + a, sizeof v), std::memcpy(&impulse, impulses + a, sizeof impulse);
    v -= impulse * force;
    std::memcpy(velocities + a, &v, sizeof v);
    if (b >= base_) {
      if (b >= block_) on_block += force[1];
      continue;
    }
    std::memcpy(&v, velocities + b, sizeof v), std::memcpy(&impulse, impulses + b, sizeof impulse);
    v += impulse * force;
    std::memcpy(velocities + b, &v, sizeof v);
  }
  force_on_block_ = on_block;
}

}  // namespace talus::bench
