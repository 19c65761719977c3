#include "solver/granular/disc_sweep.hpp"

#include <algorithm>
#include <array>
#include <concepts>
#include <cstring>
#include <span>

#include "solver/base/pack.hpp"
#include "solver/granular/disc_lanes.hpp"

namespace talus {
namespace {

/// Numbers of the pairs from <= k < to, at most sweep_block, whose surfaces are nearer than so much; how many. Beyond
/// them `found` is written to up to the end of a pack.
[[gnu::always_inline]] inline std::size_t near_pairs(const DiscSweep& w, double nearer, std::size_t from,
                                                     std::size_t to, std::uint32_t* found) {
  const std::uint32_t *const first = w.pairs->first.data(), *const second = w.pairs->second.data();
  const double* const sums = w.pairs->radii.empty() ? nullptr : w.pairs->radii.data();
  // In two passes, for in one each pack would wait for where the last one's numbers end: half as long again.
  std::array<std::uint64_t, sweep_block / pack_size> near;
  Pack within = Pack{} + (w.equal_radii + nearer);
  for (std::size_t k = from; k < to; k += pack_size) {
    Pack x, y;
    listed_differences(x, y, w.places, first + k, second + k);
    if (sums != nullptr) load(within, sums + k), within += nearer;
    near[(k - from) / pack_size] = bytes_of(x * x + y * y < within * within);
  }
  std::size_t count = 0;
  for (std::size_t k = from; k < to; k += pack_size) {
    const std::size_t bits = bits_of(near[(k - from) / pack_size]);
    Numbers numbers;
    std::memcpy(&numbers, chosen.lanes[bits].data(), sizeof numbers);
    numbers += static_cast<std::uint32_t>(k);
    std::memcpy(found + count, &numbers, sizeof numbers);
    count += chosen.count[bits];
  }
  return count;
}

/// The disc that is, or whose image is, at the place that begins there.
[[gnu::always_inline]] inline std::size_t disc(const DiscSweep& w, std::size_t at) {
  const std::size_t place = at / 2;
  return place < w.discs ? place : w.ghost_disc[place - w.discs];
}

/// Arrays of DiscPushes: where those of touching pairs go, or stand.
template <class Number>
struct Pushes {
  Number *x, *y, *friction, *arm_a, *arm_b;

  Pushes from(std::size_t k) const { return {x + k, y + k, friction + k, arm_a + k, arm_b + k}; }
};
Pushes<const double> standing(const DiscPushes& of) {
  return {of.x.data(), of.y.data(), of.friction.data(), of.arm_a.data(), of.arm_b.data()};
}

/// A sweep over pairs, block by block.
template <class L, class F>
class Sweep {
 public:
  static constexpr bool remembers = L::memory_size == 1, turns = std::same_as<F, CoulombFriction>;

  /// Whether what the law's dashpot keeps is asked for.
  bool damps() const { return !remembers && w_.keeps && law_.needs_rate(); }

  Sweep(const L& law, const F& friction, const DiscSweep& sweep)
      : law_{law},
        friction_{friction},
        w_{sweep},
        first_{w_.pairs->first.data()},
        second_{w_.pairs->second.data()},
        listed_{w_.pairs->listed.empty() ? nullptr : w_.pairs->listed.data()},
        radii_{w_.pairs->radii.empty() ? nullptr : w_.pairs->radii.data()} {
    w_.touching->count = 0;
  }

  /// The touching ones of a block in order, with what they do; until the next block.
  [[gnu::always_inline]] std::span<const std::uint32_t> push(std::size_t from, std::size_t to,
                                                             const Pushes<double>& out) {
    TouchingPairs& now = *w_.touching;
    if (now.count + sweep_block + pack_size >= now.pair.size()) make_room(now.count + sweep_block + pack_size + 1);
    std::uint32_t* const touching = now.pair.data() + now.count;
    const std::size_t count = near_pairs(w_, 0.0, from, to, touching);
    if (count == 0) return {};
    std::fill_n(touching + count, pack_size, touching[count - 1]);
    if (remembers || turns || damps()) {
      // Once after a near list was made.
      if (w_.touched_as_listed && listed_ != nullptr)
        carry(count, [this, touching](std::size_t t) { return listed_[touching[t]]; });
      else
        carry(count, [touching](std::size_t t) { return touching[t]; });
    }
    for (std::size_t t = 0; t < count; t += pack_size)
      push_pack(touching + t, std::min(count - t, pack_size), now.count + t, out.from(t));
    now.count += count;
    return {touching, count};
  }

  /// After the last block.
  [[gnu::always_inline]] void end() {
    TouchingPairs& now = *w_.touching;
    if constexpr (remembers || turns) {
      for (; old_ < w_.touched->count; ++old_)
        part(old_);
    }
    now.pair.resize(std::max(now.pair.size(), now.count + 1));
    now.pair[now.count] = TouchingPairs::none;
  }

 private:
  [[gnu::noinline]] void make_room(std::size_t size) const {
    w_.touching->resize(size + size / 4, remembers, turns, w_.keeps);
  }
  [[gnu::noinline]] void part(std::uint32_t pair, double largest, double stretch) const {
    if (largest > 0.0 || (stretch != 0.0 && w_.keeps)) w_.parted->push_back({pair, largest, stretch});
  }
  std::uint32_t listed(std::uint32_t pair) const { return listed_ != nullptr ? listed_[pair] : pair; }
  void part(std::size_t old) const {
    const std::uint32_t pair = w_.touched->pair[old];
    part(w_.touched_as_listed ? pair : listed(pair), remembers ? w_.touched->largest[old] : 0.0,
         turns ? w_.touched->stretch[old] : 0.0);
  }

  /// What touching pairs remember that touched in the last sweep; number(t): of the t-th as those are numbered.
  template <class Number>
  [[gnu::always_inline]] void carry(std::size_t count, Number&& number) {
    TouchingPairs& now = *w_.touching;
    const TouchingPairs& before = *w_.touched;
    const std::uint32_t* const then = before.pair.data();
    const double *const largest_then = before.largest.data(), *const stretch_then = before.stretch.data();
    const double* const normal_then = before.normal.data();
    double *const largest = now.largest.data() + now.count, *const stretch = now.stretch.data() + now.count;
    double* const normal = now.normal.data() + now.count;
    std::size_t old = old_;
    for (std::size_t t = 0; t < count; ++t) {
      const std::uint32_t pair = number(t);
      for (; then[old] < pair; ++old) {
        if constexpr (remembers || turns) part(old);
      }
      const bool since = then[old] == pair;
      if constexpr (remembers) largest[t] = since ? largest_then[old] : 0.0;
      if constexpr (turns) stretch[t] = since ? stretch_then[old] : 0.0;
      if constexpr (turns || !remembers) normal[t] = since ? normal_then[old] : -1.0;
      old += since ? 1U : 0U;
    }
    old_ = old;
  }

  /// Forces on the second discs of eight touching pairs, of which so many count.
  [[gnu::always_inline]] void push_pack(const std::uint32_t* pairs, std::size_t count, std::size_t at,
                                        const Pushes<double>& out) {
    TouchingPairs& now = *w_.touching;
    std::array<std::uint32_t, pack_size> first, second;
    for (std::size_t l = 0; l < pack_size; ++l)
      first[l] = first_[pairs[l]], second[l] = second_[pairs[l]];
    Pack x, y, v_x{}, v_y{}, distance, rate{}, largest{}, force, radii = Pack{} + w_.equal_radii;
    if (radii_ != nullptr) collect(radii, [&](std::size_t l) { return radii_[pairs[l]]; });
    if constexpr (remembers) load(largest, &now.largest[at]);
    differences(x, y, w_.places, first.data(), second.data());
    distance = x * x + y * y;
    square_root(distance);
    const Pack overlap = radii - distance, n_x = x / distance, n_y = y / distance;
    if (turns || w_.before != nullptr) {
      differences(v_x, v_y, w_.before, first.data(), second.data());
      rate = -(v_x * n_x + v_y * n_y);
    }
    law_.settled(overlap, rate, largest, force);
    // Rounded, an overlap may be none after all.
    const Sizes overlaps = overlap > Pack{};
    keep_where(force, overlaps);
    if constexpr (remembers) {
      if (any(~overlaps)) {
        for (std::size_t l = 0; l < count; ++l)
          if (overlaps[l] == 0) part(listed(now.pair[at + l]), now.largest[at + l], 0.0);
      }
      keep_where(largest, overlaps);
      store(largest, &now.largest[at]);
    }
    if constexpr (!remembers) {
      if (damps()) damp(overlap, rate, force, at);
    }
    if constexpr (turns) {
      Pack friction, arm_a = 0.5 * radii, arm_b = arm_a, spin_a, spin_b;
      if (w_.unlike_radius != 0) {
        collect(arm_a, [&](std::size_t l) { return w_.radius[disc(w_, first[l])]; });
        collect(arm_b, [&](std::size_t l) { return w_.radius[disc(w_, second[l])]; });
      }
      arm_a -= 0.5 * overlap, arm_b -= 0.5 * overlap;
      collect(spin_a, [&](std::size_t l) { return w_.spins_before[disc(w_, first[l])]; });
      collect(spin_b, [&](std::size_t l) { return w_.spins_before[disc(w_, second[l])]; });
      const Pack slip = v_x * -n_y + v_y * n_x - spin_a * arm_a - spin_b * arm_b;
      rub(slip * overlap / rate, rate, force, at, friction);
      keep_normal(overlap, force, at);
      store(force * n_x + friction * n_y, out.x), store(force * n_y - friction * n_x, out.y);
      store(friction, out.friction), store(arm_a, out.arm_a), store(arm_b, out.arm_b);
    } else {
      store(force * n_x, out.x), store(force * n_y, out.y);
    }
  }

  /// What the law keeps of contacts that overlap.
  [[gnu::always_inline]] void damp(const Pack& overlap, const Pack& rate, const Pack& force, std::size_t at) {
    TouchingPairs& now = *w_.touching;
    Pack normal, power, released;
    load(normal, &now.normal[at]);
    law_.kept(overlap, rate, normal, force, power, released);
    const Sizes overlaps = overlap > Pack{};
    keep_where(power, overlaps), keep_where(released, overlaps);
    store(power, &now.power[at]), store(released, &now.released[at]);
    if constexpr (!turns) keep_normal(overlap, force, at);
  }
  [[gnu::always_inline]] void keep_normal(const Pack& overlap, const Pack& force, std::size_t at) {
    const Pack none{}, normal = force > none ? force : none;
    store(overlap > none ? normal : none - 1.0, &w_.touching->normal[at]);
  }

  /// Takes the springs of friction back to their limit. slipped: of contacts since they began [L].
  [[gnu::always_inline]] void rub(const Pack& slipped, const Pack& rate, const Pack& force, std::size_t at,
                                  Pack& friction) {
    TouchingPairs& now = *w_.touching;
    Pack stretch, normal, begun, slid;
    load(stretch, &now.stretch[at]), load(normal, &now.normal[at]);
    friction_.begun(slipped, force, begun);
    const Sizes pushes = force > Pack{}, begins = pushes & (rate > Pack{}) & ~(normal > Pack{});
    stretch = begins ? begun : stretch;
    const Pack before = stretch;
    friction_.settled(force, stretch, friction);
    if (w_.keeps) {
      friction_.dissipated(before, force, stretch, slid);
      store(slid, &now.slid[at]);
    }
    keep_where(stretch, pushes), keep_where(friction, pushes);
    store(stretch, &now.stretch[at]);
  }

  L law_;
  F friction_;
  DiscSweep w_;
  const std::uint32_t *first_, *second_, *listed_;
  const double* radii_;
  std::size_t old_{};  ///< first of the pairs that touched in the last sweep which is not passed yet
};

/// Gives discs their impulses, in the order of all pairs.
template <bool turns>
class Giver {
 public:
  explicit Giver(const DiscSweep& sweep) : w_{sweep}, first_{w_.pairs->first.data()}, second_{w_.pairs->second.data()} {
    go_on();
  }

  /// To both of touching pairs of a block; before them what goes out by earlier pairs.
  [[gnu::always_inline]] void give(std::span<const std::uint32_t> touching, const Pushes<double>& pushes) {
    for (std::size_t t = 0; t < touching.size(); ++t) {
      const std::uint32_t first = first_[touching[t]], second = second_[touching[t]];
      if (next_ < first) give_out(first);
      const Place force{pushes.x[t], pushes.y[t]};
      const std::size_t i = first / 2, j = disc(w_, second);
      push(i, -force, pushes.friction + t, pushes.arm_a + t), push(j, force, pushes.friction + t, pushes.arm_b + t);
      if (w_.wall != nullptr) to_walls(i, j, force);
    }
  }
  /// To the first discs of pairs that go out, up to those of this place.
  [[gnu::always_inline]] void give_out(std::size_t to_place) {
    for (; next_ < to_place; ++out_, go_on()) {
      const Pushes<const double> out = standing(*w_.outgoing);
      const Place force{out.x[out_], out.y[out_]};
      push(next_ / 2, -force, out.friction + out_, out.arm_a + out_);
      if (w_.wall != nullptr) to_walls(next_ / 2, disc(w_, w_.outgoing->second[out_]), force);
    }
  }
  /// To the second discs, of this sweep, of others' pairs.
  void take_in(const DiscPushes& others) {
    const Pushes<const double> in = standing(others);
    for (std::size_t k = 0; k < others.count; ++k) {
      const std::size_t j = disc(w_, others.second[k]);
      if (j >= w_.begin && j < w_.end) push(j, Place{in.x[k], in.y[k]}, in.friction + k, in.arm_b + k);
    }
  }

 private:
  /// The impulse of a force on a disc, and of the friction that turns it.
  [[gnu::always_inline]] void push(std::size_t disc, Place force, const double* friction, const double* arm) const {
    const double h_per_mass = w_.kick * w_.inverse_mass[disc & w_.unlike_mass];
    Place v;
    std::memcpy(&v, w_.velocities + 2 * disc, sizeof v);
    v += h_per_mass * force;
    std::memcpy(w_.velocities + 2 * disc, &v, sizeof v);
    if constexpr (turns) w_.spins[disc] += h_per_mass * *friction * *arm * w_.per_mass[disc & w_.unlike_radius];
  }
  void to_walls(std::size_t i, std::size_t j, Place force) const {
    const Vec2 push{force[0], force[1]};
    if (w_.wall[i] != DiscShapes::free) w_.wall_pushes->push_back({w_.wall[i], -push});
    if (w_.wall[j] != DiscShapes::free) w_.wall_pushes->push_back({w_.wall[j], push});
  }
  void go_on() {
    next_ = w_.outgoing != nullptr && out_ < w_.outgoing->count ? w_.outgoing->first[out_] : ~std::size_t{0};
  }

  DiscSweep w_;
  const std::uint32_t *first_, *second_;
  std::size_t out_{}, next_{};  ///< of the pairs that go out the next one, and where its first place begins
};

/// Moves the discs from <= i < to, whole packs of them; raises the largest square of their own speeds.
[[gnu::always_inline]] inline void move(const DiscSweep& w, std::size_t from, std::size_t to, Sizes& fastest) {
  const Pack mean{w.flow.x, w.flow.y, w.flow.x, w.flow.y, w.flow.x, w.flow.y, w.flow.x, w.flow.y};
  for (std::size_t i = 2 * from; i < 2 * to; i += pack_size) {
    Pack place, v;
    load(place, w.places + i), load(v, w.velocities + i);
    Pack own = v - (mean + w.flow.rate * __builtin_shufflevector(place, Pack{}, 1, 8, 3, 8, 5, 8, 7, 8));
    own *= own;
    raise(fastest, own + __builtin_shufflevector(own, own, 1, 0, 3, 2, 5, 4, 7, 6));
    store(place + w.drift * v, w.places + i);
  }
}

/// The same for the last ones, fewer than a pack.
[[gnu::always_inline]] inline void move_last(const DiscSweep& w, std::size_t from, Sizes& fastest) {
  for (std::size_t i = from; i < w.end; ++i) {
    double *const place = w.places + 2 * i, *const v = w.velocities + 2 * i;
    raise(fastest, Pack{} + w.flow.own_speed_squared({v[0], v[1]}, place[1]));
    place[0] += w.drift * v[0], place[1] += w.drift * v[1];
  }
}

/// Moves those from <= i.
[[gnu::always_inline]] inline double move_rest(const DiscSweep& w, std::size_t from, Sizes& fastest) {
  const std::size_t whole = from + (w.end - from) / places_per_pack * places_per_pack;
  move(w, from, whole, fastest), move_last(w, whole, fastest);
  return largest(fastest);
}

template <class L, class F>
[[gnu::always_inline]] inline double sweep_pairs(const L& law, const F& friction, const DiscSweep& w) {
  constexpr bool turns = std::same_as<F, CoulombFriction>;
  std::array<std::array<double, sweep_block + pack_size>, 5> numbers;
  const Pushes<double> pushes{numbers[0].data(), numbers[1].data(), numbers[2].data(), numbers[3].data(),
                              numbers[4].data()};
  const bool moves = !turns && w.drift != 0.0;
  Sizes fastest{};
  std::size_t moved = w.begin;
  if (w.kick != 0.0) {
    Sweep<L, F> sweep{law, friction, w};
    Giver<turns> giver{w};
    const std::size_t pairs = (w.pairs->count + pack_size - 1) / pack_size * pack_size;
    for (std::size_t from = 0; from < pairs; from += sweep_block) {
      const std::size_t to = std::min(from + sweep_block, pairs);
      giver.give(sweep.push(from, to, pushes), pushes);
      if (!moves || to == pairs) continue;
      const std::size_t first = std::min<std::size_t>(w.pairs->first[to] / 2, w.end);
      const std::size_t done = moved + (first - std::min(first, moved)) / places_per_pack * places_per_pack;
      giver.give_out(2 * done);
      move(w, moved, done, fastest);
      moved = done;
    }
    giver.give_out(2 * w.end);
    sweep.end();
  }
  return moves ? move_rest(w, moved, fastest) : 0.0;
}

template <class L, class F>
[[gnu::always_inline]] inline void find_pair_pushes(const L& law, const F& friction, const DiscSweep& w,
                                                    DiscPushes& out) {
  const std::size_t pairs = (w.pairs->count + pack_size - 1) / pack_size * pack_size;
  for (auto* numbers : {&out.x, &out.y, &out.friction, &out.arm_a, &out.arm_b})
    numbers->resize(pairs + pack_size);
  out.first.resize(pairs), out.second.resize(pairs);
  out.count = 0;
  Sweep<L, F> sweep{law, friction, w};
  const Pushes<double> all{out.x.data(), out.y.data(), out.friction.data(), out.arm_a.data(), out.arm_b.data()};
  for (std::size_t from = 0; from < pairs; from += sweep_block) {
    const std::size_t n = out.count;
    const std::span<const std::uint32_t> touching = sweep.push(from, std::min(from + sweep_block, pairs), all.from(n));
    for (std::size_t t = 0; t < touching.size(); ++t)
      out.first[n + t] = w.pairs->first[touching[t]], out.second[n + t] = w.pairs->second[touching[t]];
    out.count += touching.size();
  }
  sweep.end();
}

}  // namespace

void SweptPairs::list(std::size_t size, bool unlike) {
  resize(size + pack_size, false, unlike);
  count = size;
}

void SweptPairs::take(const SweptPairs& list, std::span<const std::uint32_t> numbers) {
  const std::size_t filled = count + numbers.size();
  if (filled > first.size()) resize(filled + filled / 8, true, !list.radii.empty());
  for (std::size_t k = 0; k < numbers.size(); ++k) {
    const std::uint32_t pair = numbers[k];
    first[count + k] = list.first[pair], second[count + k] = list.second[pair];
    listed[count + k] = pair;
    if (!list.radii.empty()) radii[count + k] = list.radii[pair];
  }
  count = filled;
}

void SweptPairs::fill_up(std::uint32_t nowhere) {
  if (count == 0) return;
  const std::size_t filled = count + pack_size;
  // The first reach of a near list is a guess, and may take much more room than is needed later.
  if (filled > first.size() || 2 * filled < first.size()) resize(filled, !listed.empty(), !radii.empty());
  std::fill_n(first.begin() + static_cast<std::ptrdiff_t>(count), pack_size, nowhere);
  std::fill_n(second.begin() + static_cast<std::ptrdiff_t>(count), pack_size, nowhere);
}

void SweptPairs::resize(std::size_t size, bool near, bool unlike) {
  const auto resize = [size](auto& numbers) {
    numbers.reserve(size);
    numbers.resize(size);
    if (numbers.capacity() > 2 * size) numbers.shrink_to_fit();
  };
  resize(first), resize(second);
  if (near) resize(listed);
  if (unlike) resize(radii);
}

TALUS_CLONES std::size_t find_near(const DiscSweep& sweep, double nearer, std::size_t from, std::size_t to,
                                   std::uint32_t* found) {
  return near_pairs(sweep, nearer, from, to, found);
}

TALUS_CLONES void find_pushes(const LinearSpringDashpot& law, const Frictionless& friction, const DiscSweep& sweep,
                              DiscPushes& pushes) {
  find_pair_pushes(law, friction, sweep, pushes);
}
TALUS_CLONES double sweep_discs(const LinearSpringDashpot& law, const Frictionless& friction, const DiscSweep& sweep) {
  return sweep_pairs(law, friction, sweep);
}
TALUS_CLONES void find_pushes(const LinearSpringDashpot& law, const CoulombFriction& friction, const DiscSweep& sweep,
                              DiscPushes& pushes) {
  find_pair_pushes(law, friction, sweep, pushes);
}
TALUS_CLONES double sweep_discs(const LinearSpringDashpot& law, const CoulombFriction& friction,
                                const DiscSweep& sweep) {
  return sweep_pairs(law, friction, sweep);
}
TALUS_CLONES void find_pushes(const LatchingSpring& law, const Frictionless& friction, const DiscSweep& sweep,
                              DiscPushes& pushes) {
  find_pair_pushes(law, friction, sweep, pushes);
}
TALUS_CLONES double sweep_discs(const LatchingSpring& law, const Frictionless& friction, const DiscSweep& sweep) {
  return sweep_pairs(law, friction, sweep);
}
TALUS_CLONES void find_pushes(const LatchingSpring& law, const CoulombFriction& friction, const DiscSweep& sweep,
                              DiscPushes& pushes) {
  find_pair_pushes(law, friction, sweep, pushes);
}
TALUS_CLONES double sweep_discs(const LatchingSpring& law, const CoulombFriction& friction, const DiscSweep& sweep) {
  return sweep_pairs(law, friction, sweep);
}

void receive(const DiscSweep& sweep, const DiscPushes& pushes) {
  if (sweep.spins != nullptr)
    Giver<true>{sweep}.take_in(pushes);
  else
    Giver<false>{sweep}.take_in(pushes);
}

TALUS_CLONES void stretch_contacts(const DiscSweep& w) {
  TouchingPairs& now = *w.touching;
  const double later = 0.5 * w.drift;
  for (std::size_t t = 0; t < now.count; t += pack_size) {
    const std::size_t count = std::min(now.count - t, pack_size);
    std::array<std::uint32_t, pack_size> first, second, a, b;
    std::array<double, pack_size> sliding;  // of the image of the second
    Pack radii = Pack{} + w.equal_radii, x, y, v_x, v_y, distance, arm_a = 0.5 * radii, arm_b = arm_a, spin_a, spin_b;
    for (std::size_t l = 0; l < pack_size; ++l) {
      const std::uint32_t pair = now.pair[t + std::min(l, count - 1)];
      first[l] = w.pairs->first[pair], second[l] = w.pairs->second[pair];
      a[l] = static_cast<std::uint32_t>(2 * disc(w, first[l])),
      b[l] = static_cast<std::uint32_t>(2 * disc(w, second[l]));
      const std::size_t place = second[l] / 2;
      sliding[l] = place < w.discs ? 0.0 : w.shifts[w.ghost_image[place - w.discs]].vx;
    }
    differences(x, y, w.places, first.data(), second.data());
    collect(v_x, [&](std::size_t l) { return w.velocities[b[l]] + sliding[l] - w.velocities[a[l]]; });
    collect(v_y, [&](std::size_t l) { return w.velocities[b[l] + 1] - w.velocities[a[l] + 1]; });
    collect(spin_a, [&](std::size_t l) { return w.spins[a[l] / 2]; });
    collect(spin_b, [&](std::size_t l) { return w.spins[b[l] / 2]; });
    if (w.unlike_radius != 0) {
      collect(arm_a, [&](std::size_t l) { return w.radius[a[l] / 2]; });
      collect(arm_b, [&](std::size_t l) { return w.radius[b[l] / 2]; });
      radii = arm_a + arm_b;
    }
    x += later * v_x, y += later * v_y;
    distance = x * x + y * y;
    square_root(distance);
    const Pack n_x = x / distance, n_y = y / distance, overlap = radii - distance;
    arm_a -= 0.5 * overlap, arm_b -= 0.5 * overlap;
    Pack slip = w.drift * (v_x * -n_y + v_y * n_x - spin_a * arm_a - spin_b * arm_b), normal, stretch;
    load(normal, &now.normal[t]), load(stretch, &now.stretch[t]);
    keep_where(slip, normal > Pack{});
    store(stretch + slip, &now.stretch[t]);
  }
}

TALUS_CLONES double move_discs(const DiscSweep& w) {
  Sizes fastest{};
  return move_rest(w, w.begin, fastest);
}

}  // namespace talus
