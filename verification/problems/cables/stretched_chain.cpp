#include "verification/reference/cables/stretched_chain.hpp"
#include "verification/study/toolkit.hpp"

namespace talus::verification::problems::stretched_chain {
namespace {

constexpr reference::StretchedChain chain{8, 1.0, 1.0};
constexpr double spacing = 1.0, rest_length = 0.5;
constexpr long steps = 4096;
constexpr auto modes = static_cast<std::size_t>(chain.masses);

enum class Direction { along, across };

/// The chain with the stiffness that acts in this direction: k along the row, T0/L across it.
reference::StretchedChain exact_chain(Direction direction) {
  const double tension = chain.stiffness * (spacing - rest_length);
  return {chain.masses, chain.mass, direction == Direction::along ? chain.stiffness : tension / spacing};
}

/// The row at rest, displaced by its modes with these amplitudes.
Scene chain_scene(Direction direction, const std::vector<double>& amplitudes, const Setup& setup) {
  SceneBuilder builder;
  std::vector<CableEnd> ends{CableEnd{}};
  for (int i = 1; i <= chain.masses; ++i) {
    const double mass = i == 3 && setup.has("third_mass_heavier") ? (1.0 + 1e-9) * chain.mass : chain.mass;
    ends.push_back(
        {builder.add(Body{.name = fmt::format("mass{}", i),
                          .mobility = direction == Direction::along ? Mobility::sliding_x : Mobility::sliding_y,
                          .mass = mass,
                          .p_WB = {spacing * i, 0.0}}),
         {}});
  }
  ends.push_back({.body = {}, .p = {spacing * (chain.masses + 1), 0.0, 0.0}});
  for (std::size_t i = 0; i + 1 < ends.size(); ++i) {
    const bool softer = i == 0 && setup.has("first_cable_softer");
    const bool longer = i == 0 && setup.has("first_cable_longer");
    builder.add_cable(fmt::format("cable{}", i + 1), ends[i], ends[i + 1],
                      longer ? (1.0 + 1e-8) * rest_length : rest_length,
                      TensionOnly{softer ? (1.0 - 1e-9) * chain.stiffness : chain.stiffness});
  }
  Scene scene = builder.at_rest("Stretched chain");
  for (std::size_t j = 0; j < modes; ++j) {
    const auto shape = reference::chain_shape(chain, static_cast<int>(j) + 1);
    for (std::size_t i = 0; i < modes; ++i)
      scene.initial.q[i] += amplitudes[j] * shape[i];
  }
  return scene;
}

/// Projection of one value per mass onto the modes.
class ModeView {
 public:
  ModeView() {
    for (int j = 1; j <= chain.masses; ++j)
      shapes_.push_back(reference::chain_shape(chain, j));
  }
  [[nodiscard]] double operator()(const std::vector<double>& values, std::size_t mode) const {
    double sum = 0.0;
    for (std::size_t i = 0; i < modes; ++i)
      sum += shapes_[mode][i] * values[i];
    return 2.0 / (chain.masses + 1) * sum;
  }

 private:
  std::vector<std::vector<double>> shapes_;
};

std::vector<double> displacements(const State& state, Direction direction) {
  std::vector<double> list = state.q;
  for (std::size_t i = 0; i < modes && direction == Direction::along; ++i)
    list[i] -= spacing * static_cast<double>(i + 1);
  return list;
}

struct Swings {
  std::vector<double> frequencies;  ///< measured, of each mode
  double error{};                   ///< largest error of a mode's displacement, over the amplitude
};

/// Runs all modes at once from rest, in steps of length h.
Swings swings(Direction direction, double amplitude, double h, const Setup& setup, Findings& findings) {
  static const ModeView view;
  const auto w = reference::chain_frequencies(exact_chain(direction));
  std::vector<double> scale, numerical, last(modes, 0.0), turns(modes, 0.0);
  for (const double exact : w) {
    numerical.push_back(reference::leapfrog_frequency(exact, h));
    scale.push_back(1.0 / (exact * std::sqrt((1.0 - 0.5 * exact * h) * (1.0 + 0.5 * exact * h))));
  }
  Swings found{.frequencies = std::vector<double>(modes)};
  const Watcher watch = [&](const State& state, const StepInfo& info) {
    const std::vector<double> q = displacements(state, direction);
    for (std::size_t j = 0; j < modes; ++j) {
      const double at = view(q, j), angle = std::atan2(-scale[j] * view(state.v, j), at);
      if (info.step > 0) turns[j] += std::round((last[j] - angle) / (2.0 * std::numbers::pi));
      last[j] = angle;
      const double exact = amplitude * std::cos(numerical[j] * h * static_cast<double>(info.step));
      const double error = std::abs(at - exact) / amplitude;
      keep_worst(found.error, error);
    }
  };
  const Scene scene = chain_scene(direction, std::vector<double>(modes, amplitude), setup);
  const Integrator method = make_integrator(setup.has("rk4") ? "rk4" : "velocity_verlet");
  const RunEnd end = run_steps(scene, method, h, steps, findings, watch);
  for (std::size_t j = 0; j < modes; ++j)
    found.frequencies[j] = (2.0 * std::numbers::pi * turns[j] + last[j]) / (h * static_cast<double>(steps));
  if (!std::isfinite(end.state.q[0])) found.error = NAN;
  return found;
}

double limit(Direction direction) { return 2.0 / reference::chain_frequencies(exact_chain(direction)).back(); }

/// Largest error of the eight frequencies relative to the numerical frequencies of the leapfrog.
double frequency_error(const Swings& found, Direction direction, double h) {
  const auto w = reference::chain_frequencies(exact_chain(direction));
  double largest = 0.0;
  for (std::size_t j = 0; j < modes; ++j) {
    const double error = std::abs(found.frequencies[j] / reference::leapfrog_frequency(w[j], h) - 1.0);
    keep_worst(largest, error);
  }
  return largest;
}

constexpr double ratios[] = {0.25, 0.5, 0.9, 0.999};  ///< steps over the limit

void check_frequencies(Findings& findings, const Setup& setup) {
  Figure figure{.name = "dispersion",
                .title = "Numerical frequencies of the chain",
                .caption =
                    "Frequency of each mode over its exact frequency, along the row, with four step sizes. Line: "
                    "numerical frequency of velocity Verlet, $\\sin(\\Omega h/2) = \\omega h/2$.",
                .x = {.label = "w h"},
                .y = {.label = "W / w"},
                .series = {{"sin(W h/2) = w h/2", {}, {}, Style::lines}}};
  for (int i = 1; i <= 200; ++i)
    figure.series[0].add(0.01 * i, reference::leapfrog_frequency(0.01 * i, 1.0) / (0.01 * i));
  const auto w = reference::chain_frequencies(chain);
  double worst = 0.0, farthest = 0.0, across = 0.0;
  for (const double ratio : ratios) {
    if (setup.coarse && ratio != 0.5) continue;
    const double h = ratio * limit(Direction::along);
    const Swings found = swings(Direction::along, 0.03, h, setup, findings);
    keep_largest(worst, frequency_error(found, Direction::along, h));
    // At 0.999 of the limit a rounding error of the velocity is amplified 22 times in the last mode.
    if (ratio < 0.95 && !(found.error <= farthest)) farthest = found.error;
    const double h_across = ratio * limit(Direction::across);
    across = std::max(across, frequency_error(swings(Direction::across, 1e-7, h_across, setup, findings),
                                              Direction::across, h_across));
    figure.series.push_back({fmt::format("h = {:g} of the limit", ratio), {}, {}, Style::points});
    for (std::size_t j = 0; j < modes; ++j) {
      figure.series.back().x.push_back(w[j] * h);
      figure.series.back().y.push_back(found.frequencies[j] / w[j]);
    }
  }
  findings.expect_round_off(
      {"along", "frequencies along the row, largest relative error against the leapfrog's numerical frequencies"},
      worst, 0.0, 4e-15,
      "rounding of a phase of several thousand radians, of its time and of 2 pi, and the phase error that corresponds "
      "to the error of the displacements (next check): a few eps");
  findings.expect_round_off({"all_modes", "displacements of all modes along the row over 4096 steps, largest error"},
                            farthest, 0.0, 4e-12,
                            "phases of up to 9200 rad, a product of three rounded factors: 3e-12; in addition, "
                            "positions below 8 rounded to 2.6e-16 rms at 4096 steps, 64 times that over 0.03: 6e-13");
  findings.expect_model(
      {"across", "frequencies across the row, largest relative error against the leapfrog's numerical frequencies"},
      across, 0.0, 5e-13,
      "the oscillation itself stretches the cables, which adds the fraction (k L - T0)/(2 T0) slope^2, half a slope^2, "
      "to each force, and three times that to its slope: with a mean square slope of 4e-14 from eight modes, 6e-14 of "
      "a stiffness and 3e-14 of a frequency. tan(a)/a = 14.6 with sin(a) = 0.999 amplifies it in the numerical "
      "frequency, to 4.4e-13 at 0.999 of the limit; a seventh more for the unequal parts of the modes");
  findings.figure(figure);
}

/// Amplitude of the last mode at each step, from 1e-9, with steps of `ratio` times the limit.
Series last_mode(double ratio, long count, const Setup& setup, Findings& findings) {
  static const ModeView view;
  std::vector<double> amplitudes(modes, 0.0);
  amplitudes.back() = 1e-9;
  Series series{fmt::format("h = {:g} of the limit", ratio), {}, {}, Style::points};
  const Watcher watch = [&](const State& state, const StepInfo& info) {
    series.add(static_cast<double>(info.step), std::abs(view(displacements(state, Direction::along), modes - 1)));
  };
  run_steps(chain_scene(Direction::along, amplitudes, setup), make_integrator("velocity_verlet"),
            ratio * limit(Direction::along), count, findings, watch);
  return series;
}

void check_growth(Findings& findings, const Setup& setup) {
  constexpr std::size_t first = 26, last = 40;
  const double ratio = setup.has("step_within_the_limit") ? 0.999 : 1.02;
  const Series grown = last_mode(ratio, last, setup, findings);
  const double rate = std::log(grown.y[last] / grown.y[first]) / static_cast<double>(last - first);
  const double exact =
      std::log(reference::leapfrog_growth(2.0 / limit(Direction::along), 1.02 * limit(Direction::along)));
  findings.expect_truncation(
      {"growth_beyond", "growth rate of the last mode beyond the step limit over the exact rate"}, rate / exact, 1.0,
      1.7e-10, 1.2,
      "contribution of the decaying root, g^-52 = 9.5e-10 of the amplitude at the first of 14 steps, over 14 ln g");
  if (setup.coarse) return;
  findings.figure({.name = "growth",
                   .title = "Last mode below and beyond the step limit",
                   .caption = "Amplitude of the last mode, initially $10^{-9}$: bounded just below $\\omega_n h = 2$; "
                              "beyond it growing by the factor $g$ per step (line).",
                   .x = {.label = "step"},
                   .y = {.label = "amplitude", .log = true},
                   .series = {last_mode(0.999, last, setup, findings),
                              grown,
                              {"g^s / 2",
                               {0.0, static_cast<double>(last)},
                               {0.5e-9, 0.5e-9 * std::exp(exact * static_cast<double>(last))},
                               Style::lines}}});
}

void run(Findings& findings, const Setup& setup) {
  check_frequencies(findings, setup);
  check_growth(findings, setup);
}

}  // namespace

Case definition() {
  const std::string along = "along";
  const std::string across = "across";
  const std::string growth = "growth_beyond";
  return {.id = "stretched_chain",
          .title = "Chain of masses under tension",
          .requirements = {{"D6", {"along", "all_modes", "across", "growth_beyond"}},
                           {"Eq. 14", {"along"}},
                           {"Eq. 15", {"across"}},
                           {"Eq. 25", {"growth_beyond"}},
                           {"law.tension_only", {"along"}},
                           {"integrator.velocity_verlet", {"along", "all_modes"}}},
          .main_checks = {along, across, growth},
          .source = "Rayleigh 1877, The Theory of Sound I, chapter VI",
          .faults = {{"third_mass_heavier", "one mass heavier by 1e-9", along},
                     {"first_cable_softer", "one cable softer by 1e-9", along},
                     {"first_cable_longer", "one cable longer by 1e-8", across},
                     {"rk4", "RK4 instead of velocity Verlet", along},
                     {"step_within_the_limit", "a step of 0.999 of the limit instead of 1.02", growth}},
          .run = run};
}

}  // namespace talus::verification::problems::stretched_chain
