#include "solver/granular/step_block.hpp"

#include <algorithm>
#include <array>
#include <tuple>

#include "solver/granular/disc_lanes.hpp"
#include "solver/granular/disc_stages.hpp"
#include "solver/laws/law_list.hpp"

namespace talus {
namespace stages {

TALUS_CLONES void move(const StepBlock& w, std::size_t from, std::size_t to, Sizes& fastest) {
  const NeighbourList::Flow flow = w.flow;
  const double h = w.drift;
  double *const positions = w.positions, *const velocities = w.velocities;
  Sizes maximum = fastest;
  // Includes the discs of two packs in the largest squared speeds.
  const auto raise_speeds = [&](const Pack& p, const Pack& q, const Pack& v_p, const Pack& v_q)
      __attribute__((always_inline)) {
    const Pack y = __builtin_shufflevector(p, q, 1, 5, 3, 7);
    const Pack v_x = __builtin_shufflevector(v_p, v_q, 0, 4, 2, 6);
    const Pack v_y = __builtin_shufflevector(v_p, v_q, 1, 5, 3, 7);
    const Pack own_x = v_x - (flow.x + flow.rate * y), own_y = v_y - flow.y;
    raise(maximum, own_x * own_x + own_y * own_y);
  };
  double *position = positions + 2 * from, *v = velocities + 2 * from;
  std::size_t left = to - from;
  Pack p, q, v_p, v_q;
  for (; left >= 2 * points_per_pack; left -= 2 * points_per_pack, position += 2 * pack_size, v += 2 * pack_size) {
    load(p, position), load(q, position + pack_size), load(v_p, v), load(v_q, v + pack_size);
    raise_speeds(p, q, v_p, v_q);
    store(p + h * v_p, position), store(q + h * v_q, position + pack_size);
  }
  if (left >= points_per_pack) {
    load(p, position), load(v_p, v);
    raise_speeds(p, p, v_p, v_p);
    store(p + h * v_p, position);
    left -= points_per_pack, position += pack_size, v += pack_size;
  }
  for (; left > 0; --left, position += 2, v += 2) {
    raise(maximum, Pack{} + flow.own_speed_squared({v[0], v[1]}, position[1]));
    position[0] += h * v[0], position[1] += h * v[1];
  }
  fastest = maximum;
}

/// stretch_contacts() of one block.
template <class F>
TALUS_CLONES [[gnu::noinline]] void stretch(const F& friction, const StepBlock& w) {
  SweptContacts& contacts = *w.contacts;
  const double later = 0.5 * w.drift;
  for (std::size_t t = 0; t < contacts.now.count; t += pack_size) {
    const std::size_t last = std::min(contacts.now.count - t, pack_size) - 1;
    std::array<std::uint32_t, pack_size> pairs, a, b;
    std::array<double, pack_size> sliding;  // velocity of the second disc's image
    Pack radii = Pack{} + w.equal_radii, x, y, v_x, v_y, distance, arm_a = 0.5 * radii, arm_b = arm_a, spin_a, spin_b;
    for (std::size_t l = 0; l < pack_size; ++l) {
      pairs[l] = contacts.now.pair[t + std::min(l, last)];
      const std::size_t second = w.pairs->second[pairs[l]], disc_or_ghost = second / 2;
      a[l] = w.pairs->first[pairs[l]], b[l] = static_cast<std::uint32_t>(own_index(w, second));
      sliding[l] = disc_or_ghost < w.discs ? 0.0 : w.shifts[w.ghost_image[disc_or_ghost - w.discs]].vx;
    }
    differences(x, y, w.positions, w.pairs->first.data(), w.pairs->second.data(), pairs.data());
    collect(v_x, [&](std::size_t l) { return w.velocities[b[l]] + sliding[l] - w.velocities[a[l]]; });
    collect(v_y, [&](std::size_t l) { return w.velocities[b[l] + 1] - w.velocities[a[l] + 1]; });
    collect(spin_a, [&](std::size_t l) { return w.spins[a[l] / 2]; });
    collect(spin_b, [&](std::size_t l) { return w.spins[b[l] / 2]; });
    if (w.per_disc_radius != 0) {
      collect(arm_a, [&](std::size_t l) { return w.radius[a[l] / 2]; });
      collect(arm_b, [&](std::size_t l) { return w.radius[b[l] / 2]; });
      radii = arm_a + arm_b;
    }
    x += later * v_x, y += later * v_y;
    distance = x * x + y * y;
    square_root(distance);
    const Pack n_x = x / distance, n_y = y / distance, overlap = radii - distance;
    arm_a -= 0.5 * overlap, arm_b -= 0.5 * overlap;
    const Pack slip = v_x * -n_y + v_y * n_x - spin_a * arm_a - spin_b * arm_b, rate = -(v_x * n_x + v_y * n_y);
    Pack normal, stretch, moved;
    load(normal, &contacts.now.normal[t]), load(stretch, &contacts.now.stretch[t]);
    friction.move_stretch(stretch, slip, overlap, rate, w.drift, moved);
    store(normal > Pack{} ? moved : stretch, &contacts.now.stretch[t]);
  }
}

/// Names stretch_contacts() of each friction law, which is instantiated with it; never called.
template <class... F>
auto stretches(LawList<F...>) {
  return std::tuple{&stretch_contacts<F>...};
}

}  // namespace stages

template <class F>
void stretch_contacts(const F& friction, const StepBlock& sweep) {
  stages::stretch(friction, sweep);
}
template auto stages::stretches(DiscFrictions);

double move_discs(const StepBlock& sweep) {
  Sizes fastest{};
  stages::move(sweep, sweep.begin, sweep.end, fastest);
  return largest(fastest);
}

}  // namespace talus
