#include <algorithm>
#include <array>
#include <concepts>

#include "solver/granular/disc_lanes.hpp"
#include "solver/granular/disc_stages.hpp"

namespace talus {
namespace stages {
namespace {

/// Eight contacts at a time.
template <class L, class F>
class ContactLanes {
 public:
  static constexpr bool remembers = L::memory_size == 1, turns = std::same_as<F, CoulombFriction>;

  [[gnu::always_inline]] ContactLanes(const L& law, const F& friction, const DiscSweep& sweep)
      : law_{law},
        friction_{friction},
        w_{sweep},
        first_{w_.pairs->first.data()},
        second_{w_.pairs->second.data()},
        radii_{w_.pairs->radii.empty() ? nullptr : w_.pairs->radii.data()} {}

  /// Forces on the second discs of eight touching pairs, of which so many count; the others are the last of them again.
  /// at: which of the contacts the first is; from: which they were before.
  [[gnu::always_inline]] void push(const std::uint32_t* pairs, std::size_t count, std::size_t at,
                                   const std::uint32_t* from, const Pushes& out) {
    SweptContacts& contacts = *w_.contacts;
    Pack x, y, v_x{}, v_y{}, distance, rate{}, largest{}, force, radii = Pack{} + w_.equal_radii;
    if (radii_ != nullptr) collect(radii, radii_, pairs);
    if constexpr (remembers) collect(largest, contacts.before.largest.data(), from);
    differences(x, y, w_.places, first_, second_, pairs);
    distance = x * x + y * y;
    square_root(distance);
    const Pack overlap = radii - distance, n_x = x / distance, n_y = y / distance;
    if (turns || w_.before != nullptr) {
      differences(v_x, v_y, w_.before, first_, second_, pairs);
      rate = -(v_x * n_x + v_y * n_y);
    }
    law_.settled(overlap, rate, largest, force);
    // Rounded, an overlap may be none after all.
    const Sizes overlaps = overlap > Pack{};
    keep_where(force, overlaps);
    if constexpr (remembers) {
      if (any(~overlaps)) [[unlikely]] {
        for (std::size_t l = 0; l < count; ++l)
          if (overlaps[l] == 0) part(w_, w_.pairs->number_in_list(pairs[l]), largest[l], 0.0);
      }
      keep_where(largest, overlaps);
      store(largest, &contacts.now.largest[at]);
    }
    if constexpr (!remembers) {
      if (damps()) damp(overlap, rate, force, at, from);
    }
    if constexpr (turns) {
      Pack friction, arm_a = 0.5 * radii, arm_b = arm_a, spin_a, spin_b;
      if (w_.unlike_radius != 0) {
        collect(arm_a, [&](std::size_t l) { return w_.radius[disc(w_, first_[pairs[l]])]; });
        collect(arm_b, [&](std::size_t l) { return w_.radius[disc(w_, second_[pairs[l]])]; });
      }
      arm_a -= 0.5 * overlap, arm_b -= 0.5 * overlap;
      collect(spin_a, [&](std::size_t l) { return w_.spins_before[disc(w_, first_[pairs[l]])]; });
      collect(spin_b, [&](std::size_t l) { return w_.spins_before[disc(w_, second_[pairs[l]])]; });
      const Pack slip = v_x * -n_y + v_y * n_x - spin_a * arm_a - spin_b * arm_b;
      rub(slip * overlap / rate, rate, force, at, from, friction);
      keep_normal(overlap, force, at);
      store_places(force * n_x + friction * n_y, force * n_y - friction * n_x, out.force);
      store(friction, out.friction), store(arm_a, out.arm_a), store(arm_b, out.arm_b);
    } else {
      store_places(force * n_x, force * n_y, out.force);
    }
  }

  /// Whether what the law's dashpot keeps is asked for.
  bool damps() const { return !remembers && w_.contacts->kinds.power; }
  /// What the law keeps of contacts that overlap.
  [[gnu::always_inline]] void damp(const Pack& overlap, const Pack& rate, const Pack& force, std::size_t at,
                                   const std::uint32_t* from) {
    SweptContacts& contacts = *w_.contacts;
    Pack normal, power, released;
    collect(normal, contacts.before.normal.data(), from);
    law_.kept(overlap, rate, normal, force, power, released);
    const Sizes overlaps = overlap > Pack{};
    keep_where(power, overlaps), keep_where(released, overlaps);
    store(power, &contacts.power[at]), store(released, &contacts.released[at]);
    if constexpr (!turns) keep_normal(overlap, force, at);
  }
  [[gnu::always_inline]] void keep_normal(const Pack& overlap, const Pack& force, std::size_t at) {
    const Pack none{}, normal = force > none ? force : none;
    store(overlap > none ? normal : none - 1.0, &w_.contacts->now.normal[at]);
  }

  /// Takes the springs of friction back to their limit. slipped: of contacts since they began [L].
  [[gnu::always_inline]] void rub(const Pack& slipped, const Pack& rate, const Pack& force, std::size_t at,
                                  const std::uint32_t* from, Pack& friction) {
    SweptContacts& contacts = *w_.contacts;
    Pack stretch, normal, begun, slid;
    collect(stretch, contacts.before.stretch.data(), from), collect(normal, contacts.before.normal.data(), from);
    friction_.begun(slipped, force, begun);
    const Sizes pushes = force > Pack{}, begins = pushes & (rate > Pack{}) & ~(normal > Pack{});
    stretch = begins ? begun : stretch;
    const Pack before = stretch;
    friction_.settled(force, stretch, friction);
    if (contacts.kinds.slid) {
      friction_.dissipated(before, force, stretch, slid);
      store(slid, &contacts.slid[at]);
    }
    keep_where(stretch, pushes), keep_where(friction, pushes);
    store(stretch, &contacts.now.stretch[at]);
  }

  L law_;
  F friction_;
  const DiscSweep& w_;
  const std::uint32_t *first_, *second_;
  const double* radii_;
};

template <class L, class F>
[[gnu::always_inline]] inline void push_all(const L& law, const F& friction, const DiscSweep& sweep,
                                            std::span<const std::uint32_t> touching, const Pushes& out) {
  ContactLanes<L, F> lanes{law, friction, sweep};
  const std::size_t before = sweep.contacts->now.count - touching.size();
  for (std::size_t t = 0; t < touching.size(); t += pack_size)
    lanes.push(&touching[t], std::min(touching.size() - t, pack_size), before + t, &sweep.contacts->from[t],
               out.from(t));
}

}  // namespace

TALUS_CLONES void push(const LinearSpringDashpot& law, const Frictionless& friction, const DiscSweep& sweep,
                       std::span<const std::uint32_t> touching, Pushes out) {
  push_all(law, friction, sweep, touching, out);
}
TALUS_CLONES void push(const LinearSpringDashpot& law, const CoulombFriction& friction, const DiscSweep& sweep,
                       std::span<const std::uint32_t> touching, Pushes out) {
  push_all(law, friction, sweep, touching, out);
}
TALUS_CLONES void push(const LatchingSpring& law, const Frictionless& friction, const DiscSweep& sweep,
                       std::span<const std::uint32_t> touching, Pushes out) {
  push_all(law, friction, sweep, touching, out);
}
TALUS_CLONES void push(const LatchingSpring& law, const CoulombFriction& friction, const DiscSweep& sweep,
                       std::span<const std::uint32_t> touching, Pushes out) {
  push_all(law, friction, sweep, touching, out);
}

}  // namespace stages

TALUS_CLONES void stretch_contacts(const DiscSweep& w) {
  SweptContacts& contacts = *w.contacts;
  const double later = 0.5 * w.drift;
  for (std::size_t t = 0; t < contacts.now.count; t += pack_size) {
    const std::size_t last = std::min(contacts.now.count - t, pack_size) - 1;
    std::array<std::uint32_t, pack_size> pairs, a, b;
    std::array<double, pack_size> sliding;  // of the image of the second
    Pack radii = Pack{} + w.equal_radii, x, y, v_x, v_y, distance, arm_a = 0.5 * radii, arm_b = arm_a, spin_a, spin_b;
    for (std::size_t l = 0; l < pack_size; ++l) {
      pairs[l] = contacts.now.pair[t + std::min(l, last)];
      const std::size_t second = w.pairs->second[pairs[l]], place = second / 2;
      a[l] = w.pairs->first[pairs[l]], b[l] = static_cast<std::uint32_t>(stages::own_place(w, second));
      sliding[l] = place < w.discs ? 0.0 : w.shifts[w.ghost_image[place - w.discs]].vx;
    }
    differences(x, y, w.places, w.pairs->first.data(), w.pairs->second.data(), pairs.data());
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
    load(normal, &contacts.now.normal[t]), load(stretch, &contacts.now.stretch[t]);
    keep_where(slip, normal > Pack{});
    store(stretch + slip, &contacts.now.stretch[t]);
  }
}

}  // namespace talus
