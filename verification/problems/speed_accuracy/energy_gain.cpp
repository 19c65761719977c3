#include <cstdint>

#include "verification/reference/integration/leapfrog_bounce.hpp"
#include "verification/study/toolkit.hpp"

namespace talus::verification::problems::energy_gain {
namespace {

/// Run of a gas of undamped discs in a box by velocity Verlet, with w h = eta for its contacts, all of the same w.
struct GasRun {
  double ln_heating{};  ///< ln of the ratio of the energies at the last and first instant without a contact
  long collisions{};    ///< of discs with discs and with walls
};

/// Number of discs in the gas.
constexpr int gas_discs = 24;

/// Random numbers, uniform in (0, 1), the same on every machine (Lehmer's multiplicative congruential generator).
class Draw {
 public:
  explicit Draw(std::uint64_t seed) : state_{seed * 2654435761u % modulus + 1} {
    for (int i = 0; i < 20; ++i)
      (void)(*this)();
  }
  double operator()() {
    state_ = state_ * 48271u % modulus;
    return static_cast<double>(state_) / static_cast<double>(modulus);
  }

 private:
  static constexpr std::uint64_t modulus = 2147483647u;
  std::uint64_t state_;
};

constexpr double half_box = 11.0, speed = 4e-3;  // radius 1, mass 1, w = 1

/// Springs of k = 1/2 between discs, whose effective mass is 1/2, and of 1 against walls: w = 1 everywhere.
Scene gas(std::uint64_t seed) {
  SceneBuilder builder;
  Draw draw{seed};
  std::vector<BodyId> discs, walls;
  for (int i = 0; i < gas_discs; ++i) {
    const double column = i % 5, row = i / 5;
    const Vec2 position{4.2 * (column - 2.0) + draw() - 0.5, 4.2 * (row - 2.0) + draw() - 0.5};
    discs.push_back(builder.add({.name = fmt::format("disc{}", i),
                                 .mobility = Mobility::particle,
                                 .mass = 1.0,
                                 .shape = Circle{1.0},
                                 .p_WB = position}));
  }
  const Vec2 positions[] = {{0.0, -half_box}, {half_box, 0.0}, {0.0, half_box}, {-half_box, 0.0}};
  for (int i = 0; i < 4; ++i) {
    walls.push_back(builder.add({.name = fmt::format("wall{}", i),
                                 .mobility = Mobility::fixed,
                                 .shape = HalfPlane{},
                                 .p_WB = positions[i],
                                 .angle = 0.5 * std::numbers::pi * i}));
  }
  const LinearSpringDashpot soft{0.5, 0.0, EndRule::clamped}, hard{1.0, 0.0, EndRule::clamped};
  for (std::size_t i = 0; i < discs.size(); ++i) {
    for (std::size_t j = i + 1; j < discs.size(); ++j)
      builder.add_contact(fmt::format("pair{}_{}", i, j), discs[i], discs[j], soft);
    for (std::size_t j = 0; j < walls.size(); ++j)
      builder.add_contact(fmt::format("wall{}_{}", i, j), discs[i], walls[j], hard);
  }
  Scene scene = builder.at_rest("Gas in a box");
  for (const BodyId disc : discs) {
    const double angle = 2.0 * std::numbers::pi * draw(), size = speed * std::sqrt(-2.0 * std::log(draw()));
    set_velocity(scene.model, scene.initial, disc, {size * std::cos(angle), size * std::sin(angle)}, 0.0);
  }
  return scene;
}

/// Runs discs from random positions and velocities until `collisions` have occurred; equal seeds give bit-identical
/// results. Fault `gas_by_rk4`: another method.
GasRun run_gas(double eta, std::uint64_t seed, long collisions, const Setup& setup) {
  const Scene scene = gas(seed);
  std::vector<Mode> before(scene.initial.mode.size(), 0);
  GasRun gas;
  double first = 0.0, last = 0.0;
  // Contacts have one law instance each, whose mode is 0 while open.
  const Until enough = [&](const State& seen) {
    bool open = true;
    for (std::size_t i = 0; i < before.size(); ++i) {
      if (seen.mode[i] != 0) open = false;
      if (seen.mode[i] != 0 && before[i] == 0) ++gas.collisions;
    }
    before = seen.mode;
    if (!open) return false;
    last = 0.0;
    for (const double v : seen.v)
      last += 0.5 * v * v;
    if (first == 0.0) first = last;
    return gas.collisions >= collisions;
  };
  const char* method = setup.has("gas_by_rk4") ? "rk4" : "velocity_verlet";
  run_scene(scene, make_integrator(method), {eta, 2e7 * eta, eta, false}, nullptr, {}, enough);
  gas.ln_heating = gas.collisions >= collisions ? std::log(last / first) : std::nan("");
  return gas;
}

constexpr double frequency = 100.0, entry = 1.0;

Scene struck_plane(const Setup& setup) {
  SceneBuilder builder{si};
  const double k = frequency * frequency * (setup.has("stiffness_off") ? 1.0 + 1e-6 : 1.0);
  const double c = setup.has("slight_dashpot") ? 2e-4 * frequency : 0.0;
  const BodyId disc = builder.add({.name = "disc", .mobility = Mobility::particle, .mass = 1.0, .shape = Circle{1.0}});
  const BodyId plane = builder.add({.name = "plane", .mobility = Mobility::fixed, .shape = HalfPlane{}});
  builder.add_contact("contact", disc, plane, LinearSpringDashpot{k, c, EndRule::clamped});
  return builder.at_rest("Disc against a plane");
}

/// A disc that hits a plane, for repeated runs with different methods, steps and phases.
class Striking {
 public:
  explicit Striking(const Setup& setup) : scene_{struck_plane(setup)} {}

  /// Exit over entry speed; theta: fraction of the entry step inside the spring.
  double ratio(std::string_view method, double eta, double theta) const {
    const double h = eta / frequency;
    Scene scene = scene_;
    // A staggered method stores coordinates half a step later, so that the disc starts half a step further out.
    const double ahead = integrator_traits(method).is_staggered ? 0.5 : 0.0;
    scene.initial.q[1] = 1.0 + (1.0 - theta + ahead) * h * entry;
    scene.initial.v[1] = -entry;
    const long steps = static_cast<long>(std::ceil(3.1416 / (2.0 * std::asin(0.5 * eta)))) + 3;
    return run_steps(scene, make_integrator(method), h, steps).state.v[1] / entry;
  }

 private:
  Scene scene_;
};

double theta(int i, int phases, const Setup& setup) {
  return ((setup.has("bunched_phases") ? 0.25 * i : i) + 0.5) / phases;
}

/// Minimum, mean and maximum of e over 64 phases against the step; each e is compared with the closed form.
void check_bounces(const Striking& striking, Findings& findings, const Setup& setup) {
  Series minimum{"minimum", {}, {}, Style::points}, mean{"mean", {}, {}, Style::points},
      maximum{"maximum", {}, {}, Style::points};
  Series exact_minimum{"exact", {}, {}, Style::lines}, exact_maximum{"exact", {}, {}, Style::lines};
  Series bound{"bound", {}, {}, Style::lines};
  for (const char* method : {"velocity_verlet", "central_difference", "euler_cromer"}) {
    const bool drawn = std::string_view{method} == "velocity_verlet";
    if (setup.coarse && !drawn) continue;
    double worst = 0.0, above = 0.0;
    for (int n = setup.coarse ? 32 : 1; n <= 39; ++n) {
      const double eta = 0.05 * n;
      double low = 1e9, high = 0.0, sum = 0.0;
      for (int i = 0; i < 64; ++i) {
        const double at = theta(i, 64, setup), e = striking.ratio(method, eta, at);
        const double error = e - reference::leapfrog_bounce(eta, at).ratio;
        keep_worst(worst, error);
        low = std::min(low, e), high = std::max(high, e), sum += e / 64.0;
      }
      const double limit = 1.0 / std::sqrt(1.0 - 0.25 * eta * eta);
      above = std::max(above, high - limit);
      if (drawn && (n == 2 || n == 32)) {
        const bool fine = n == 2;
        findings.expect_between({"gain_of_speed", fmt::format("largest gain of speed at w h = {:g}", eta)}, high - 1.0,
                                fine ? 0.0005 : 0.5, fine ? 0.002 : 2.0 / 3.0,
                                fine ? "the bound is 0.00125; 0.2 % is accepted for a fine step, and less than 0.05 % "
                                       "would mean that nothing was hit"
                                     : "a gain of at least one half, up to the bound 1/sqrt(1 - 0.64)");
      }
      if (!drawn) continue;
      const reference::LeapfrogGain gain = reference::leapfrog_gain(eta, 500);
      for (const auto& [series, value] : {std::pair{&minimum, low},
                                          {&mean, sum},
                                          {&maximum, high},
                                          {&exact_minimum, gain.minimum},
                                          {&exact_maximum, gain.maximum},
                                          {&bound, limit}}) {
        series->add(eta, value);
      }
    }
    findings.count(39 * 64 * 12);
    const auto claim = findings.in(fmt::format("integrator.{}", method));
    findings.expect_round_off(
        {"exit_speeds", fmt::format("exit speeds by {}, 39 steps of 64 phases, largest error", method)}, worst, 0.0,
        5e-13,
        "an overlap, computed as a number near 1 minus 1, is off by 1.1e-16 and changes the velocity by w^2 h times "
        "that: 2e-14 of v0 at w h = 1.95, in a step or two, and sqrt(63) times 6e-16 at 0.05; where e varies fast with "
        "the phase, ten times that");
    findings.expect_true({"exit_speed_bound", fmt::format("exit speeds by {}: none above the bound", method)},
                         above <= 1e-11, "1/sqrt(1 - eta^2/4), derived on the page");
  }
  if (setup.coarse) return;
  exact_maximum.label = "exact maximum";
  exact_minimum.label = "exact minimum";
  findings.figure({.name = "gain",
                   .title = "Exit over entry speed of one bounce",
                   .caption = "Velocity Verlet, 64 phases of the touch, against $\\omega h$; the whole range is "
                              "stable. Where a contact lasts a whole number of steps (1, and 1.41 for two) the exit "
                              "speed equals the entry speed at all phases. Lines: closed form; above them the bound.",
                   .x = {.label = "w h", .min = 0.0, .max = 2.0},
                   .y = {.label = "exit over entry speed", .min = 0.0, .max = 3.0},
                   .series = {minimum, mean, maximum, exact_minimum, exact_maximum, bound}});
}

/// Checks means over many phases: that of e^-2, and that of ln e against its value to second order in the step.
void check_heating(const Striking& striking, Findings& findings, const Setup& setup, Figure& figure) {
  Series points{"velocity Verlet, one bounce", {}, {}, Style::points};
  const int phases = 2048;
  double worst = 0.0;
  for (const double eta : {0.3, 0.1, 0.2, 0.7}) {
    if (setup.coarse && eta != 0.3) continue;
    double inverse = 0.0, mean_ln = 0.0;
    for (int i = 0; i < phases; ++i) {
      const double e = striking.ratio("velocity_verlet", eta, theta(i, phases, setup));
      inverse += 1.0 / (e * e * phases);
      mean_ln += std::log(e) / phases;
    }
    findings.count(phases * 20);
    const double off = (inverse - 1.0) * 8.0 * phases * phases / (eta * eta);
    keep_worst(worst, off);
    findings.expect_model({"integrator.velocity_verlet",
                           fmt::format("mean of ln e at w h = {:g} over eta^4 delta^2 (1 - delta)^2/12", eta)},
                          mean_ln / reference::small_step_heating(eta), 1.0, 0.5 * eta * eta,
                          "the next order, eta^2, with half its size; 64 phases would not suffice: the terms are a "
                          "hundred times their mean");
    points.add(eta, mean_ln);
  }
  findings.expect_truncation(
      {"integrator.velocity_verlet", "mean of e^-2 minus one, over eta^2/(8 n^2), largest of four steps"}, worst, 0.0,
      1.0, 3.0,
      "a midpoint mean over n = 2048 phases misses, at each phase where the slope of e^-2 jumps by 2 eta^2, up to an "
      "eighth of the jump over n^2; there are two such phases");
  Series exact{"exact", {}, {}, Style::lines};
  for (double eta = 0.05; eta < 1.95; eta *= 1.015) {
    const double value = reference::leapfrog_gain(eta, 1000).mean_ln;
    if (value < 1e-10) continue;
    exact.add(eta, value);
    if (setup.coarse) break;
  }
  figure.series.push_back(exact);
  figure.series.push_back(points);
}

/// Checks the mean gain of ln energy per collision, times the number of discs, against the statistics of one bounce.
void check_gas(Findings& findings, const Setup& setup, Figure& figure) {
  struct Gas {
    double eta;
    int runs;
    long collisions;
  };
  Series points{"gas, N/4 times ln heating per collision", {}, {}, Style::errorbars};
  std::vector<Gas> gases{{1.2, setup.coarse ? 4 : 12, 800}, {1.0, 3, 800}, {1.5, 16, 150}};
  if (setup.tier == Tier::full) gases.push_back({0.7, 40, 800});
  const double n = gas_discs;
  for (const Gas& gas : gases) {
    if (setup.coarse && gas.eta != 1.2) continue;
    double heating = 0.0;
    long collisions = 0;
    for (int seed = 1; seed <= gas.runs; ++seed) {
      const GasRun run = run_gas(gas.eta, static_cast<std::uint64_t>(seed), gas.collisions, setup);
      heating += run.ln_heating;
      collisions += run.collisions;
    }
    const double measured = heating / static_cast<double>(collisions);
    const auto group = findings.in("gases"), claim = findings.in("integrator.velocity_verlet");
    const std::string name = fmt::format("gas at w h = {:g}, N times ln heating per collision", gas.eta);
    if (gas.eta == 1.0) {
      findings.expect_model(
          name, n * measured, 0.0, 5e-4,
          "every bounce is exact; contacts that are not head-on rotate by v/(r w) = 0.004 of their length, and discs "
          "spend 0.4 % of the time in a contact, during which a third disc may arrive");
      continue;
    }
    // Fraction B of the energy in a collision, of mean 1/(N + 1/2) and mean square 2/((N + 1/2)(N + 3/2)): that of the
    // motion along the normal among 2 N coordinates, weighted by the rate of collisions.
    const reference::LeapfrogGain gain = reference::leapfrog_gain(gas.eta, 20000);
    const double square = 2.0 / ((n + 0.5) * (n + 1.5));
    const double expected = n * (gain.mean_square / (n + 0.5) - 0.5 * square * gain.variance);
    const double error = n * std::sqrt(square * gain.variance / static_cast<double>(collisions));
    findings.expect_model(
        name, n * measured, expected, 3.0 * error,
        fmt::format(
            "three standard errors of the mean of {} collisions, each with a separate phase and fraction of the energy",
            collisions));
    if (!setup.has("gas_by_rk4") && n * measured > 3.0 * error) {
      points.add(gas.eta, 0.25 * n * measured);
      points.y_low.push_back(0.25 * (n * measured - error));
      points.y_high.push_back(0.25 * (n * measured + error));
    }
    findings.count(collisions * 60);
  }
  if (!points.x.empty()) figure.series.push_back(points);
}

void run(Findings& findings, const Setup& setup) {
  const Striking striking{setup};
  if (setup.needs("exit speeds")) check_bounces(striking, findings, setup);
  Figure figure{.name = "heating",
                .title = "Mean of ln e over all phases",
                .caption =
                    "Heating of a bounce by the step; for a gas a quarter of the heating of its energy, which is the "
                    "same for small gains. It vanishes wherever a contact lasts a whole number of steps.",
                .x = {.label = "w h", .log = true},
                .y = {.label = "mean of ln e", .log = true, .min = 1e-9},
                .series = {},
                .slopes = {{4.0, 0.3, 4.2e-5, "eta^4/192"}}};
  if (setup.needs("mean of")) check_heating(striking, findings, setup, figure);
  if (setup.needs("gas at")) check_gas(findings, setup, figure);
  if (!setup.coarse) findings.figure(figure);
}

}  // namespace

Case definition() {
  return {.id = "energy_gain",
          .title = "Energy gain of one-sided contacts below the stability limit",
          .family = "speed and accuracy",
          .requirements = {{"Eq. 25", {"gain_of_speed"}},
                           {"pair.circle.circle", {"gases"}},
                           {"pair.circle.half_plane", {"exit_speeds", "exit_speed_bound", "gases"}}},
          .main_checks = {"largest gain of speed at w h = 0.1", "largest gain of speed at w h = 1.6",
                          "exit speeds by velocity_verlet, 39 steps of 64 phases, largest error",
                          "mean of e^-2 minus one, over eta^2/(8 n^2), largest of four steps",
                          "mean of ln e at w h = 0.1 over eta^4 delta^2 (1 - delta)^2/12",
                          "gas at w h = 1.2, N times ln heating per collision",
                          "gas at w h = 1, N times ln heating per collision"},
          .source = "Hairer, Lubich & Wanner 2006; derived here",
          .faults = {{"stiffness_off", "a contact too stiff by a factor of 1 + 1e-6",
                      "exit speeds by velocity_verlet, 39 steps of 64 phases, largest error"},
                     {"slight_dashpot", "a dashpot of damping ratio 1e-4",
                      "mean of e^-2 minus one, over eta^2/(8 n^2), largest of four steps"},
                     {"bunched_phases", "phases from one quarter of the step only",
                      "mean of ln e at w h = 0.3 over eta^4 delta^2 (1 - delta)^2/12"},
                     {"gas_by_rk4", "a method that does not preserve areas",
                      "gas at w h = 1.2, N times ln heating per collision"}},
          .seconds = 3.0,
          .full_seconds = 6.0,
          .run = run};
}

}  // namespace talus::verification::problems::energy_gain
