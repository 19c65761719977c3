#include "verification/problems/program/cells/reference_cell.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>

namespace talus::verification::problems::cell_files {

Tolerance of_paths() {
  return Tolerance::round_off(
      1e-10,
      "positions are rounded to 1e-16 in each of 2010 steps, and neighbouring trajectories diverge tenfold in about "
      "ten contacts of a disc, to 7e-12 here; one step or contact more or less causes more than 1e-4");
}

double wrapped(double x) { return x - width * std::floor(x / width + 0.5); }

VirtualDiscs start() {
  VirtualDiscs discs{.k1 = k1,
                     .k2 = k2,
                     .diameter = diameter,
                     .mass = mass,
                     .left = -half,
                     .width = width,
                     .gravity = gravity,
                     .block_mass = block_mass,
                     .free = free_discs,
                     .wall = wall_discs,
                     .x = {},
                     .y = {},
                     .vx = {},
                     .vy = {}};
  std::mt19937 random{7};
  const auto around = [&](double mean, double deviation) {
    return mean + deviation * (static_cast<double>(random()) / 2147483648.0 - 1.0);
  };
  const auto add = [&](double x, double y, double vx, double vy) {
    discs.x.push_back(x), discs.y.push_back(y), discs.vx.push_back(vx), discs.vy.push_back(vy);
  };
  for (int row = 0; row < rows; ++row) {
    for (int column = 0; column < columns; ++column) {
      // Each row is above the gaps of the row below, with hardly any distance between them.
      const double fraction = (column + (row % 2 == 0 ? 0.25 : 0.75)) / columns - 0.5;
      // The last disc is the highest, so that the block lies on it across the border.
      const bool highest = row == rows - 1 && column == columns - 1;
      const double x = around(width * fraction, 1e-5);
      const double y = around(1.02e-3 + 8.4e-4 * row, 1e-5) + (highest ? 1e-4 : 0.0);
      const double vx = around(block_speed * y / 4.5e-3, 0.5);
      add(x, y, vx, around(0.0, 0.5));
    }
  }
  for (int i = 0; i < wall_discs; ++i)
    add(-half + diameter * (i + 0.5), 0.0, 0.0, 0.0);
  double height = diameter;
  for (int i = 0; i < wall_discs; ++i) {
    add(wrapped(-half + diameter * (i + 0.5) + block_speed * elapsed), 0.0, block_speed, 0.0);
    for (std::size_t j = 0; j < free_discs; ++j) {
      const double across = wrapped(discs.x.back() - discs.x[j]);
      if (std::abs(across) < diameter)
        height = std::max(height, discs.y[j] + std::sqrt(diameter * diameter - across * across));
    }
  }
  std::fill_n(discs.y.end() - wall_discs, wall_discs, height);
  return discs;
}

std::string control_text(const Setup& setup) {
  const double speed = setup.has("faster_block") ? (1.0 + 1e-7) * block_speed : block_speed;
  return fmt::format("1 1\n{} {} {} {} {} {}\n{} {} {} {}\n{} {} {}\n", k1, k2, diameter, mass, gravity, block_mass,
                     rows, columns, wall_discs, speed, step, loop, end);
}

std::string restart_text(const VirtualDiscs& discs, const Setup& setup) {
  std::string text = fmt::format("{} {}\n", setup.has("started_later") ? elapsed + 1e-9 : elapsed, cycles);
  for (std::size_t i = 0; i < free_discs; ++i)
    text += fmt::format("{} {} {} {}\n", discs.x[i], discs.y[i], discs.vx[i], discs.vy[i]);
  return text;
}

State state_of(const VirtualDiscs& discs) {
  State state{discs, {}};
  state.discs.step(0.0);
  std::array<int, all_discs> touched{};
  for (const VirtualDiscs::Contact& contact : state.discs.contacts)
    ++touched[contact.a], ++touched[contact.b];
  for (const VirtualDiscs::Contact& contact : state.discs.contacts) {
    const auto has_another = [&](std::size_t disc) { return disc < free_discs && touched[disc] > 1; };
    state.multiple.push_back(has_another(contact.a) || has_another(contact.b));
  }
  return state;
}

double height_of(const VirtualDiscs& discs) { return discs.y[all_discs - 1] - discs.y[free_discs]; }

double fraction_of(const VirtualDiscs& discs) {
  const double disc = 0.25 * std::numbers::pi * diameter * diameter;
  return free_discs * disc / (width * (height_of(discs) - diameter));
}

namespace {

Values sampled(const State& state, Expected& expected) {
  Values values{};
  values[contacts] = static_cast<double>(state.multiple.size());
  values[touching] = state.multiple.empty() ? 0.0 : 1.0;
  for (std::size_t c = 0; c < state.multiple.size(); ++c) {
    const VirtualDiscs::Contact& contact = state.discs.contacts[c];
    const double length = std::hypot(contact.dx, contact.dy);
    const double fx = contact.force * contact.dx / length, fy = contact.force * contact.dy / length;
    const double along = -fx * contact.dy / area, across = fy * contact.dy / area;
    values[shear] += along, values[normal] += across;
    if (state.multiple[c]) values[multiple] += 1.0, values[multiple_shear] += along, values[multiple_normal] += across;
    values[coordination] += ((contact.a < free_discs ? 1.0 : 0.0) + (contact.b < free_discs ? 1.0 : 0.0)) / free_discs;
    expected.largest_overlap = std::max(expected.largest_overlap, contact.overlap);
  }
  for (std::size_t i = 0; i < free_discs; ++i)
    values[kinetic] -= mass * state.discs.vx[i] * state.discs.vy[i] / area;
  values[solid_fraction] = fraction_of(state.discs);
  expected.largest_fraction = std::max(expected.largest_fraction, values[solid_fraction]);
  return values;
}

}  // namespace

std::size_t part(double time, double whole, int parts) {
  return static_cast<std::size_t>(std::clamp(std::floor(parts * time / whole), 0.0, parts - 1.0));
}

Expected expected_of(VirtualDiscs discs, const Setup& setup) {
  Expected expected;
  expected.loops.resize((steps + steps_in_loop - 1) / steps_in_loop), expected.weights.resize(10);
  Values walls{};  // sums over the steps since the last sample
  int since = 0, samples = 0;
  double look = 0.0;
  for (int n = 1; n <= steps; ++n) {
    discs.step(step), ++since;
    const double height = height_of(discs), x = discs.force_on_block_x;
    walls[top_shear] -= x / area, walls[top_normal] += discs.force_on_block_y / area;
    walls[bottom_shear] += discs.force_on_base_x / area, walls[bottom_normal] -= discs.force_on_base_y / area;
    walls[depth] += height - diameter, walls[depth_square] += (height - diameter) * (height - diameter);
    walls[moment] -= x / area * height;
    expected.work -= step * x * block_speed;
    const bool last = n == steps;
    if (n % steps_in_sample != 0 && !last) continue;
    const State state = state_of(discs);
    Values values = sampled(state, expected);
    for (const Quantity k : {top_shear, top_normal, bottom_shear, bottom_normal, depth, depth_square, moment})
      values[k] = walls[k] / since;
    const double weight = since * step, time = n * step - 0.5 * weight;
    const auto of_loop = static_cast<std::size_t>((n - 1) / steps_in_loop);
    expected.loops[setup.has("samples_one_loop_late") && of_loop > 0 ? of_loop - 1 : of_loop].add(values, weight);
    expected.hundredths[part(time, end, 100)].add(values, weight);
    if (part(time, end, 100) >= 25) expected.steady.add(values, weight);
    look += weight;
    if (++samples == samples_in_look || last) {
      if (time >= start_up) {
        expected.weights[part(time - start_up, end - start_up, 10)] += look;
        for (std::size_t i = 0; i < free_discs; ++i)
          expected.seen.push_back({time, look, discs.y[i] - discs.y[free_discs], discs.vx[i], discs.vy[i]});
      }
      look = 0.0, samples = 0;
    }
    walls = {}, since = 0;
    if (n % steps_in_loop == 0 || last) expected.states.push_back(state);
  }
  return expected;
}

}  // namespace talus::verification::problems::cell_files
