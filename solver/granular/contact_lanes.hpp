#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <span>
#include <utility>

#include "solver/granular/disc_lanes.hpp"
#include "solver/granular/disc_stages.hpp"
#include "solver/laws/contact_kernel.hpp"
#include "solver/laws/friction_kernel.hpp"

/// The stage of a sweep that evaluates the law: forces of contacts on their discs.
namespace talus::stages {

/// Evaluates contacts, a pack at a time.
template <class L, class F>
class ContactLanes {
 public:
  using Kernel = decltype(contact_kernel(std::declval<const L&>()));
  static constexpr bool has_history = HasHysteresisLoss<Kernel>, turns = turns_discs<F>;

  [[gnu::always_inline]] ContactLanes(const L& law, const F& friction, const StepBlock& sweep)
      : kernel_{contact_kernel(law)},
        friction_{friction},
        w_{sweep},
        first_{w_.pairs->first.data()},
        second_{w_.pairs->second.data()},
        radii_{w_.pairs->radii.empty() ? nullptr : w_.pairs->radii.data()} {}

  /// Computes the forces on the second discs of a pack of touching pairs. The first `count` lanes count; the others
  /// repeat the last of these. at: index of the first contact; from: indices of the contacts before the step.
  [[gnu::always_inline]] void push(const std::uint32_t* pairs, std::size_t count, std::size_t at,
                                   const std::uint32_t* from, const Pushes& out) {
    SweptContacts& contacts = *w_.contacts;
    Pack x, y, v_x{}, v_y{}, distance, rate{}, largest{}, force, radii = Pack{} + w_.equal_radii;
    if (radii_ != nullptr) collect(radii, radii_, pairs);
    if constexpr (has_history) collect(largest, contacts.before.largest.data(), from);
    differences(x, y, w_.positions, first_, second_, pairs);
    distance = x * x + y * y;
    square_root(distance);
    const Pack overlap = radii - distance, n_x = x / distance, n_y = y / distance;
    if (turns || w_.before != nullptr) {
      differences(v_x, v_y, w_.before, first_, second_, pairs);
      rate = -(v_x * n_x + v_y * n_y);
    }
    kernel_.force(overlap, rate, largest, force);
    // Because of rounding, a pair that was found to touch may not overlap.
    Sizes overlaps;
    find_overlaps(overlap, overlaps);
    keep_where(force, overlaps);
    if constexpr (has_history) {
      if (any_bit(~overlaps)) [[unlikely]] {
        for (std::size_t l = 0; l < count; ++l)
          if (overlaps[l] == 0) part(w_, w_.pairs->number_in_list(pairs[l]), largest[l], 0.0);
      }
      keep_where(largest, overlaps);
      store(largest, &contacts.now.largest[at]);
    }
    if constexpr (!has_history) {
      if (damps()) damp(overlap, overlaps, rate, force, at, from);
    }
    if constexpr (turns) {
      Pack friction, arm_a = 0.5 * radii, arm_b = arm_a, spin_a, spin_b;
      if (w_.per_disc_radius != 0) {
        collect(arm_a, [&](std::size_t l) { return w_.radius[disc(w_, first_[pairs[l]])]; });
        collect(arm_b, [&](std::size_t l) { return w_.radius[disc(w_, second_[pairs[l]])]; });
      }
      arm_a -= 0.5 * overlap, arm_b -= 0.5 * overlap;
      collect(spin_a, [&](std::size_t l) { return w_.spins_before[disc(w_, first_[pairs[l]])]; });
      collect(spin_b, [&](std::size_t l) { return w_.spins_before[disc(w_, second_[pairs[l]])]; });
      const Pack slip = v_x * -n_y + v_y * n_x - spin_a * arm_a - spin_b * arm_b;
      Pack pressed = overlap;  // overlap since the surfaces met
      if constexpr (ActsAtDistance<L>) pressed = overlap > Pack{} ? overlap : Pack{};
      apply_friction(F::onset * slip * pressed / rate, overlap, rate, force, at, from, friction);
      keep_normal(overlaps, force, at);
      store_points(force * n_x + friction * n_y, force * n_y - friction * n_x, out.force);
      store(friction, out.friction), store(arm_a, out.arm_a), store(arm_b, out.arm_b);
    } else {
      store_points(force * n_x, force * n_y, out.force);
    }
  }

 private:
  /// Finds the lanes whose surfaces are within the law's reach.
  [[gnu::always_inline]] void find_overlaps(const Pack& overlap, Sizes& is) const {
    if constexpr (ActsAtDistance<L>)
      is = overlap > Pack{} - w_.reach;
    else
      is = overlap > Pack{};
  }
  /// Whether the work of the law's dashpot is recorded.
  bool damps() const { return !has_history && w_.contacts->kinds.power; }
  /// Stores the dissipated power and the released energy of contacts that overlap.
  [[gnu::always_inline]] void damp(const Pack& overlap, const Sizes& overlaps, const Pack& rate, const Pack& force,
                                   std::size_t at, const std::uint32_t* from) {
    SweptContacts& contacts = *w_.contacts;
    Pack normal, power, released;
    collect(normal, contacts.before.normal.data(), from);
    kernel_.dissipated_power(overlap, rate, normal, force, power, released);
    keep_where(power, overlaps), keep_where(released, overlaps);
    store(power, &contacts.power[at]), store(released, &contacts.released[at]);
    if constexpr (!turns) keep_normal(overlaps, force, at);
  }
  [[gnu::always_inline]] void keep_normal(const Sizes& overlaps, const Pack& force, std::size_t at) {
    const Pack none{}, normal = force > none ? force : none;
    store(overlaps ? normal : none - 1.0, &w_.contacts->now.normal[at]);
  }

  /// Limits the stretch of the friction springs (return mapping). slipped: stretch of a contact that begins, by the
  /// slip since the surfaces met [L].
  [[gnu::always_inline]] void apply_friction(const Pack& slipped, const Pack& overlap, const Pack& rate,
                                             const Pack& force, std::size_t at, const std::uint32_t* from,
                                             Pack& friction) {
    SweptContacts& contacts = *w_.contacts;
    Pack stretch, normal, initial, friction_work;
    collect(stretch, contacts.before.stretch.data(), from), collect(normal, contacts.before.normal.data(), from);
    SpringSlider<Pack> slider{friction_.coefficient, {}};
    friction_.stiffness_at(overlap, slider.stiffness);
    slider.initial_stretch(slipped, force, initial);
    const Sizes pushes = force > Pack{}, begins = pushes & (rate > Pack{}) & ~(normal > Pack{});
    stretch = begins ? initial : stretch;
    const Pack before = stretch;
    slider.returned_force(force, stretch, friction);
    if (contacts.kinds.friction_work) {
      slider.dissipated(before, force, stretch, friction_work);
      store(friction_work, &contacts.friction_work[at]);
    }
    if constexpr (has_varying_stiffness<F>) {
      if (contacts.kinds.area_power) {
        Pack power;
        friction_.area_power(stretch, overlap, rate, power);
        keep_where(power, pushes);
        store(power, &contacts.area_power[at]);
      }
    }
    keep_where(stretch, pushes), keep_where(friction, pushes);
    store(stretch, &contacts.now.stretch[at]);
  }

  Kernel kernel_;
  F friction_;
  const StepBlock& w_;
  const std::uint32_t *first_, *second_;
  const double* radii_;
};

/// Computes the forces of these touching pairs, the last that were found, without applying them.
template <class L, class F>
TALUS_CLONES [[gnu::noinline]] void push(const L& law, const F& friction, const StepBlock& sweep,
                                         std::span<const std::uint32_t> touching, Pushes out) {
  ContactLanes<L, F> lanes{law, friction, sweep};
  const std::size_t before = sweep.contacts->now.count - touching.size();
  for (std::size_t t = 0; t < touching.size(); t += pack_size)
    lanes.push(&touching[t], std::min(touching.size() - t, pack_size), before + t, &sweep.contacts->from[t],
               out.from(t));
}

}  // namespace talus::stages
