#include "solver/granular/fast_disc_system.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <limits>

#include "solver/base/pack.hpp"
#include "solver/granular/disc_sweep.hpp"

namespace talus {
namespace {

constexpr double making_cost = 2.0;   ///< c: of a listed pair, when the near list is made; of a near pair in a step: 1
constexpr double first_reach = 0.05;  ///< of the near list, share of the skin
constexpr double long_time = 10.0;    ///< until a decision is looked at again, in skins that the fastest discs cross
constexpr double worth = 0.9;         ///< share of the cost of looking at all listed pairs that the near list saves

constexpr std::size_t whole(std::size_t count, std::size_t of) { return (count + of - 1) / of * of; }

/// What all of these are, or 0.
double common(const std::vector<double>& numbers) {
  const bool equal = std::adjacent_find(numbers.begin(), numbers.end(), std::not_equal_to{}) == numbers.end();
  return equal && !numbers.empty() ? numbers.front() : 0.0;
}

}  // namespace

template <SettledLaw L>
FastDiscSystem<L>::FastDiscSystem(DiscShapes shapes, PeriodicBox box, const L& law, double skin)
    : shapes_{std::move(shapes)}, law_{law}, list_{box, skin}, skin_{skin} {
  equal_radii_ = 2.0 * common(shapes_.radius);
  equal_masses_ = common(shapes_.inverse_mass) != 0.0;
  wall_forces_.resize(shapes_.walls.size() + 1);
  wall_impulses_.resize(wall_forces_.size());
  for (std::size_t i = 0; i < shapes_.size(); ++i) {
    const std::size_t wall = shapes_.wall[i];
    if (wall != DiscShapes::free && shapes_.walls[wall - 1].mass > 0.0) moved_.push_back(i);
  }
}

template <SettledLaw L>
void FastDiscSystem<L>::begin(Discs& discs) {
  pairs_.count = 0;
  rebuild(discs);
}

template <SettledLaw L>
void FastDiscSystem<L>::kick(Discs& discs, double h) {
  load(discs);
  sweep(h, 0.0);
  store(discs);
}

template <SettledLaw L>
void FastDiscSystem<L>::drift(Discs& discs, double h) {
  load(discs);
  sweep(0.0, h);
  end_drift(discs, h);
  // Who asks for a drift alone may do so with a copy that is then left: the near list is to hold for that, too.
  used_ += way_;
  store(discs);
}

template <SettledLaw L>
void FastDiscSystem<L>::advance(Discs& discs, double h, long steps) {
  load(discs);
  std::fill(wall_impulses_.begin(), wall_impulses_.end(), Vec2{});
  for (long n = 0; n < steps; ++n) {
    sweep(h, h);
    end_drift(discs, h);
    discs.t += h;
    for (std::size_t wall = 1; wall < wall_forces_.size(); ++wall)
      wall_impulses_[wall] += h * wall_forces_[wall];
  }
  store(discs);
}

/// One step, the parts of it whose length is not 0.
template <SettledLaw L>
void FastDiscSystem<L>::sweep(double kick, double drift) {
  const Pairs& near = all_near_ ? pairs_ : near_;
  const NeighbourList::Flow flow = list_.flow();
  if (kick != 0.0) begin_kick();
  // Discs of walls that forces move wait until all forces are known: till then they flow with the mean.
  for (std::size_t m = 0; m < moved_.size(); ++m) {
    double *const v = &velocities_[2 * moved_[m]], *const place = &places_[2 * moved_[m]];
    waiting_[m] = {{place[0], place[1]}, {v[0], v[1]}};
    v[0] = flow.x + flow.rate * place[1], v[1] = flow.y;
  }
  const DiscSweep work{.kick = kick,
                       .drift = drift,
                       .flow = flow,
                       .places = places_.data(),
                       .velocities = velocities_.data(),
                       .before = law_.needs_rate() ? before_.data() : nullptr,
                       .discs = shapes_.size(),
                       .ghost_disc = ghost_disc_.data(),
                       .pairs = whole(near.count, pack_size),
                       .first = near.first.data(),
                       .second = near.second.data(),
                       .listed = all_near_ ? nullptr : near.listed.data(),
                       .radii = equal_radii_ > 0.0 ? nullptr : near.radii.data(),
                       .equal_radii = equal_radii_,
                       .inverse_mass = shapes_.inverse_mass.data(),
                       .unlike = equal_masses_ ? std::size_t{0} : ~std::size_t{0},
                       .wall = shapes_.walls.empty() ? nullptr : shapes_.wall.data(),
                       .wall_forces = wall_forces_.data(),
                       .pasts = pasts_.data(),
                       .now = now_};
  double fastest = sweep_discs(law_, work);
  for (std::size_t m = 0; m < moved_.size(); ++m) {
    const std::size_t disc = moved_[m], wall = shapes_.wall[disc];
    double *const v = &velocities_[2 * disc], *const place = &places_[2 * disc];
    place[0] = waiting_[m].place.x, place[1] = waiting_[m].place.y;
    v[0] = waiting_[m].v.x, v[1] = waiting_[m].v.y;
    if (kick != 0.0)
      v[1] += kick * (wall_forces_[wall].y / shapes_.walls[wall - 1].mass - shapes_.walls[wall - 1].gravity);
    fastest = std::max(fastest, flow.own_speed_squared({v[0], v[1]}, place[1]));
    place[0] += drift * v[0], place[1] += drift * v[1];
  }
  way_ = list_.approach(drift, fastest);
}

template <SettledLaw L>
void FastDiscSystem<L>::begin_kick() {
  ++evaluations_;
  std::fill(wall_forces_.begin(), wall_forces_.end(), Vec2{});
  ++now_;
  if (!law_.needs_rate()) return;
  std::copy(velocities_.begin(), velocities_.end(), before_.begin());
  list_.shifts(slid_, shifts_);
  double* ghost = &before_[velocities_.size()];
  for (std::size_t g = 0; g < ghost_disc_.size(); ++g, ghost += 2) {
    const double* const v = &velocities_[2 * std::size_t{ghost_disc_[g]}];
    ghost[0] = v[0] + shifts_[ghost_image_[g]].vx, ghost[1] = v[1];
  }
}

/// After all discs have moved: what lists them follows.
template <SettledLaw L>
void FastDiscSystem<L>::end_drift(Discs& discs, double h) {
  slid_ += h * list_.box().sliding();
  list_.use(way_);
  used_ += way_;
  if (list_.may_end()) {
    store(discs);
    if (!list_.holds(discs)) return rebuild(discs);
  }
  place_ghosts();
  // Whether all are still to be near is asked again now and then.
  if (used_ > (all_near_ ? long_time * skin_ : (1.0 - round_off) * reach_)) prune();
}

template <SettledLaw L>
void FastDiscSystem<L>::load(const Discs& discs) {
  for (std::size_t i = 0; i < discs.size(); ++i) {
    places_[2 * i] = discs.x[i], places_[2 * i + 1] = discs.y[i];
    velocities_[2 * i] = discs.vx[i], velocities_[2 * i + 1] = discs.vy[i];
  }
  slid_ = discs.slid;
  place_ghosts();
}

template <SettledLaw L>
void FastDiscSystem<L>::store(Discs& discs) const {
  for (std::size_t i = 0; i < discs.size(); ++i) {
    discs.x[i] = places_[2 * i], discs.y[i] = places_[2 * i + 1];
    discs.vx[i] = velocities_[2 * i], discs.vy[i] = velocities_[2 * i + 1];
  }
  discs.slid = slid_;
}

template <SettledLaw L>
void FastDiscSystem<L>::place_ghosts() {
  if (ghost_disc_.empty()) return;
  list_.shifts(slid_, shifts_);
  double* ghost = &places_[velocities_.size()];
  for (std::size_t g = 0; g < ghost_disc_.size(); ++g, ghost += 2) {
    const double* const place = &places_[2 * std::size_t{ghost_disc_[g]}];
    const NeighbourList::Shift& shift = shifts_[ghost_image_[g]];
    ghost[0] = place[0] + shift.x, ghost[1] = place[1] + shift.y;
  }
}

/// Lists the pairs anew; what contacts remember goes with them.
template <SettledLaw L>
void FastDiscSystem<L>::rebuild(Discs& discs) {
  struct Contact {
    std::uint32_t first, second;
    double largest;
  };
  std::vector<Contact> touching;
  if constexpr (remembers) {
    for (std::size_t pair = 0; pair < pairs_.count; ++pair) {
      if (pasts_[pair].sweep == now_)
        touching.push_back({disc(pairs_.first[pair]), disc(pairs_.second[pair]), pasts_[pair].largest});
    }
  }
  wrap(list_.box(), discs);
  list_.build(shapes_, discs);
  ++builds_;
  list_places();
  load(discs);
  now_ = 1;
  if constexpr (remembers) {
    pasts_.assign(whole(pairs_.count, pack_size), {});
    for (const Contact& contact : touching) {
      const std::size_t pair = list_.find(contact.first, contact.second);
      if (pair < list_.size()) pasts_[pair] = {contact.largest, now_};
    }
  }
  prune();
}

/// Places of the discs, of the ghosts that the list needs, and one that is nowhere; the pairs of them.
template <SettledLaw L>
void FastDiscSystem<L>::list_places() {
  const std::size_t discs = shapes_.size();
  constexpr std::uint8_t here = NeighbourList::images / 2;
  std::vector<std::pair<std::uint32_t, std::uint8_t>> ghosts;
  for (std::size_t pair = 0; pair < list_.size(); ++pair) {
    if (list_.image(pair) != here)
      ghosts.emplace_back(static_cast<std::uint32_t>(list_.second(pair)), list_.image(pair));
  }
  std::sort(ghosts.begin(), ghosts.end());
  ghosts.erase(std::unique(ghosts.begin(), ghosts.end()), ghosts.end());
  ghost_disc_.clear(), ghost_image_.clear();
  for (const auto& [disc, image] : ghosts)
    ghost_disc_.push_back(disc), ghost_image_.push_back(image);
  const std::size_t nowhere = discs + ghosts.size();
  places_.resize(2 * (nowhere + 1));
  velocities_.resize(2 * discs);
  if (law_.needs_rate()) before_.resize(2 * (nowhere + 1));
  std::fill(places_.end() - 2, places_.end(), std::numeric_limits<double>::quiet_NaN());
  waiting_.resize(moved_.size());

  pairs_.clear();
  pairs_.first.reserve(whole(list_.size(), pack_size)), pairs_.second.reserve(whole(list_.size(), pack_size));
  for (std::size_t i = 0; i < list_.discs(); ++i) {
    for (std::size_t pair = list_.begin(i); pair < list_.end(i); ++pair) {
      const auto j = static_cast<std::uint32_t>(list_.second(pair));
      std::size_t place = j;
      if (list_.image(pair) != here) {
        const auto ghost = std::lower_bound(ghosts.begin(), ghosts.end(), std::pair{j, list_.image(pair)});
        place = discs + static_cast<std::size_t>(ghost - ghosts.begin());
      }
      pairs_.first.push_back(static_cast<std::uint32_t>(2 * i));
      pairs_.second.push_back(static_cast<std::uint32_t>(2 * place));
      if (equal_radii_ == 0.0) pairs_.radii.push_back(shapes_.radius[i] + shapes_.radius[j]);
    }
  }
  fill_up(pairs_);
}

/// Fills the lanes behind the last pair with pairs that are nowhere.
template <SettledLaw L>
void FastDiscSystem<L>::fill_up(Pairs& pairs) {
  pairs.count = pairs.first.size();
  const std::size_t filled = whole(pairs.count, pack_size);
  const auto nowhere = static_cast<std::uint32_t>(places_.size() - 2);
  pairs.first.resize(filled, nowhere), pairs.second.resize(filled, nowhere);
  if (remembers) pairs.listed.resize(filled);
  if (equal_radii_ == 0.0) pairs.radii.resize(filled);
}

/// Makes the near list.
template <SettledLaw L>
void FastDiscSystem<L>::prune() {
  used_ = 0.0;
  if (choose_reach()) return;
  ++prunings_;
  const DiscSweep work{.places = places_.data(),
                       .first = pairs_.first.data(),
                       .second = pairs_.second.data(),
                       .radii = equal_radii_ > 0.0 ? nullptr : pairs_.radii.data(),
                       .equal_radii = equal_radii_};
  std::array<std::uint32_t, sweep_block + pack_size> found;
  near_.clear();
  const std::size_t pairs = whole(pairs_.count, pack_size);
  for (std::size_t from = 0; from < pairs; from += sweep_block) {
    const std::size_t count = find_near(work, reach_, from, std::min(from + sweep_block, pairs), found.data());
    for (std::size_t f = 0; f < count; ++f) {
      const std::size_t pair = found[f];
      near_.first.push_back(pairs_.first[pair]), near_.second.push_back(pairs_.second[pair]);
      if (remembers) near_.listed.push_back(found[f]);
      if (equal_radii_ == 0.0) near_.radii.push_back(pairs_.radii[pair]);
    }
  }
  fill_up(near_);
}

/// The reach of the next near list from what the last one was like; whether all listed pairs are near instead.
template <SettledLaw L>
bool FastDiscSystem<L>::choose_reach() {
  all_near_ = false;
  if (reach_ == 0.0) reach_ = first_reach * skin_;
  if (way_ == 0.0 || near_.count == 0) return false;
  const double listed = static_cast<double>(pairs_.count), near = static_cast<double>(near_.count);
  const double making = making_cost * listed * way_;
  const double least = std::min(2.0 * way_, skin_), last = reach_;
  reach_ = std::clamp(std::sqrt(making * last / near), least, skin_);
  const bool settled = std::abs(reach_ / last - 1.0) < 0.2;
  return all_near_ = settled && near + making / last > worth * listed;
}

template <SettledLaw L>
double FastDiscSystem<L>::largest_overlap(std::size_t a, std::size_t b) const {
  if constexpr (remembers) {
    const std::size_t pair = list_.find(std::min(a, b), std::max(a, b));
    if (pair < list_.size() && pasts_[pair].sweep == now_) return pasts_[pair].largest;
  }
  return 0.0;
}

template class FastDiscSystem<LinearSpringDashpot>;
template class FastDiscSystem<LatchingSpring>;

}  // namespace talus
