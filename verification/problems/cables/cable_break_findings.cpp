#include "verification/problems/cables/cable_findings.hpp"
#include "verification/reference/cables/cable_draw.hpp"
#include "verification/study/scenes/cable_scenes.hpp"
#include "verification/study/toolkit.hpp"

namespace talus::verification::problems {
namespace {

constexpr double stiffness = 1.0, mass = 1.0, speed = 1.0;  // peak tension 1
constexpr double half_swing = std::numbers::pi;

/// Number of phases of a root mean square: fewer if only a fault must be detected.
std::size_t phases(const Setup& setup) { return setup.coarse ? 16 : fewest_phases; }

/// Runs one throw, which starts the fraction `phase` of a step before the cable is taut.
CableRunResult throw_once(const ElasticPlastic& law, double step, double phase, Findings& findings) {
  const Scene scene = thrown_mass(law, mass, speed);
  State state = scene.initial;
  state.q[0] -= phase * step * speed;
  return run_cables(scene, state, VelocityVerlet{}, {step, 20.0, true}, findings);
}

bool broke(const CableRunResult& run) { return run.end.mode[0] == ElasticPlastic::broken; }

/// Strengths of 0.999 and 1.001 times the largest tension, and rupture stretches of 0.999 and 1.001 times the largest
/// plastic stretch: 64 phases each.
void check_both_sides(Findings& findings, const Setup& setup) {
  const double yield = 0.5;
  const double drawn = reference::perfectly_plastic_draw(stiffness, yield, mass, speed).stretch;
  const double off = setup.has("strength_unread") ? 0.998 : 1.0;
  int broken[4]{};
  for (std::size_t i = 0; i < phases(setup); ++i) {
    const double step = offset_step(half_swing, 400.0, i), phase = even_phases(phases(setup))[i];
    const ElasticPlastic laws[] = {{.stiffness = stiffness, .strength = off * 1.001 * speed},
                                   {.stiffness = stiffness, .strength = 0.999 * speed},
                                   {.stiffness = stiffness, .yield = yield, .rupture = off * 1.001 * drawn},
                                   {.stiffness = stiffness, .yield = yield, .rupture = 0.999 * drawn}};
    for (std::size_t l = 0; l < 4; ++l)
      broken[l] += broke(throw_once(laws[l], step, phase, findings)) ? 1 : 0;
  }
  const CheckName names[] = {
      {"broken/strong", "number of broken cables, strength 1.001 times the peak tension"},
      {"broken/weak", "number of broken cables, strength 0.999 times the peak tension"},
      {"broken/long rupture", "number of broken cables, rupture stretch 1.001 times the largest plastic stretch"},
      {"broken/short rupture", "number of broken cables, rupture stretch 0.999 times the largest plastic stretch"}};
  for (std::size_t l = 0; l < 4; ++l)
    findings.expect_exact(names[l], broken[l], l % 2 == 0 ? 0.0 : static_cast<double>(phases(setup)),
                          "the error of velocity Verlet's peak, (w h)^2/8 = 8e-6, is about 1 % of the margin of 0.001: "
                          "the cable breaks in all of the 64 phases or in none");
}

/// Energy released by a break, and the energy balance error.
void check_release(Findings& findings, const Setup& setup) {
  const double strength = 0.6;
  Convergence released, kept, balance_error;
  double ratio = 0.0, open_ratio = 0.0;
  for (const double count : doublings(setup.coarse ? 256.0 : 32.0, setup.coarse ? 1 : 4)) {
    PhaseError energy, exit, open;
    double step = 0.0;
    for (std::size_t i = 0; i < phases(setup); ++i) {
      step = offset_step(half_swing, count, i);
      CableRunResult run =
          throw_once({.stiffness = stiffness, .strength = strength}, step, even_phases(phases(setup))[i], findings);
      energy.add(recorded_work(run.end, Mechanism::cable_break) - reference::broken_energy(stiffness, strength));
      exit.add(run.end.v[0] - reference::speed_kept(stiffness, strength, mass, speed));
      if (setup.has("break_not_booked")) run.balance_error -= recorded_work(run.end, Mechanism::cable_break);
      open.add(run.balance_error);
    }
    step = half_swing / (count + 0.5);
    released.add(step, energy.rms());
    kept.add(step, exit.rms());
    balance_error.add(step, open.rms());
    const double left = reference::speed_kept(stiffness, strength, mass, speed);
    ratio = energy.rms() / (strength * left * step / std::sqrt(3.0));
    open_ratio = open.rms() / (0.5 * strength * left * step);
  }
  findings.expect_order({"break/order", "order of the energy released by a cable break"}, released, 0.95, 1.05,
                        "the cable breaks at the first step at which its tension exceeds its strength, late by a "
                        "uniformly distributed fraction of a step");
  findings.expect_model(
      {"break/energy", "energy released by a cable break, rms error over its prediction"}, ratio, 1.0, 0.03,
      "T v u h with u uniformly distributed in (0, 1): rms T v h/sqrt(3); the next order in h is 2 % of it");
  findings.expect_order(
      {"break_balance/order", "order of the energy balance error, cable break"}, balance_error, 0.95, 1.05,
      "the force ends with the half kick before the break is detected, but the energy is recorded at the detection");
  findings.expect_model({"break_balance/error", "energy balance error over its prediction, cable break"}, open_ratio,
                        1.0, 0.03,
                        "the half kick before the detection is omitted although the cable still counts as intact: T v "
                        "h/2 for every phase; the next order in h is 2 % of it");
}

/// Cables that yield until they break, at a rupture stretch or when they have hardened to their strength, by the
/// methods that locate events.
void check_located_breaks(Findings& findings, const Setup& setup) {
  constexpr double tolerance = 1e-10, thrown = 2.0;
  const double off = setup.has("strength_unread") ? 0.998 : 1.0;
  const reference::YieldingCable flat{stiffness, {{0.0, 0.5}}, 0.0}, line{stiffness, {{0.0, 0.5}}, 0.25},
      table{stiffness, {{0.0, 0.5}, {0.5, 0.75}, {1.5, 0.75}, {2.0, 1.25}}, 0.1};
  const std::vector<YieldPoint> points{{0.5, 0.75}, {1.5, 0.75}, {2.0, 1.25}};
  const struct {
    const char* name;
    const reference::YieldingCable& cable;
    double stretch;  ///< plastic stretch at the break
    ElasticPlastic law;
  } breaks[] = {
      {"rupture stretch, perfectly plastic", flat, 0.1, {.stiffness = stiffness, .yield = 0.5, .rupture = off * 0.1}},
      {"strength, linear hardening",
       line,
       1.0,
       {.stiffness = stiffness, .yield = 0.5, .hardening = 0.25, .strength = off * 0.75}},
      {"strength, tabulated hardening",
       table,
       1.75,
       {.stiffness = stiffness, .yield = 0.5, .hardening = 0.1, .strength = off * 1.0, .table = points}}};
  for (const std::string& name : integrator_names()) {
    const IntegratorTraits method = integrator_traits(name);
    if (!method.locates_events || !takes_tolerance(method.step_control)) continue;
    for (const auto& [what, cable, stretch, law] : breaks) {
      const Scene scene = thrown_mass(law, mass, thrown);
      const CableRunResult run =
          run_cables(scene, scene.initial, make_integrator(name, tolerance), {half_swing, 10.0, true}, findings);
      const char* const reason =
          "27 to 44 steps with local errors below 1e-10 of the distance travelled and the speed, a third of that on "
          "average: as a random walk, sqrt(44)/3 = 2.2 times; the event itself is located to round-off";
      const std::string by = fmt::format(", {}, {}", what, name);
      findings.expect_truncation({"located_breaks", "speed after a located break" + by}, run.end.v[0],
                                 reference::speed_kept(cable, mass, thrown, stretch), tolerance * thrown, 3.0, reason,
                                 "m/s");
      findings.expect_round_off(
          {"located_breaks", "plastic stretch at a located break" + by}, run.end.z[0], stretch, 4e-15,
          "the event is defined by the plastic stretch itself: a difference of lengths of up to 10 m", "m");
      if (!law.table.empty()) continue;  // the power of yielding jumps at its corners, which are not events
      findings.expect_truncation({"located_breaks", "energy balance error after a located break" + by},
                                 run.balance_error, 0.0, tolerance * mass * thrown * thrown, 3.0, reason, "J");
    }
  }
}

// ---- the hanger ----

const reference::HungPair pair{2.0, 1.0, 3.0, 5.0, 1.5};

CableRunResult run_pair(double strength, double step, double phase, double end, const Integrator& method,
                        Findings& findings, bool watched = false) {
  const Scene scene = hung_pair(pair, strength);
  State state = scene.initial;
  state.q[1] -= phase * step * pair.speed;
  return run_cables(scene, state, method, {step, end, false, watched}, findings);
}

/// Derivative of a quantity of the reference with respect to the time at which the hanger breaks.
template <class Of>
double change_with_time(const reference::HangerBreak& broken, Of&& of) {
  constexpr double d = 1e-5;
  const auto at = [&](double t) {
    return of(reference::break_hanger(pair, reference::hanger_load(pair, reference::held_pair(pair, t))));
  };
  return (at(broken.time + d) - at(broken.time - d)) / (2.0 * d);
}

void check_hanger_sides(Findings& findings, const Setup& setup) {
  const double peak = reference::first_load_peak(pair).load, time = reference::first_load_peak(pair).time;
  const double off = setup.has("strength_unread") ? 0.998 : 1.0;
  int above = 0, below = 0;
  for (std::size_t i = 0; i < phases(setup); ++i) {
    const double step = offset_step(time, 400.0, i), phase = even_phases(phases(setup))[i];
    above += run_pair(off * 1.001 * peak, step, phase, 1.5 * time, VelocityVerlet{}, findings).hanger_broken ? 1 : 0;
    below += run_pair(0.999 * peak, step, phase, 1.5 * time, VelocityVerlet{}, findings).hanger_broken ? 1 : 0;
  }
  const Tolerance all_or_none = Tolerance::exact(
      "the peak load is resolved to (w h)^2/8 = 2e-6: the hanger breaks in all of the 64 phases or in none");
  findings.expect("number of broken hangers, strength 1.001 times the peak load", above, 0.0, all_or_none);
  findings.expect("number of broken hangers, strength 0.999 times the peak load", below,
                  static_cast<double>(phases(setup)), all_or_none);
}

/// Errors of a break that is found up to a step late: speeds, energy lost, and energy balance.
void check_hanger_orders(Findings& findings, const Setup& setup) {
  const double strength = 0.7 * reference::first_load_peak(pair).load;
  const reference::HangerBreak exact = reference::break_hanger(pair, strength);
  const double b_rate = strength / pair.mass_b;
  const double lost_rate = change_with_time(exact, [](const auto& x) { return x.lost; });
  const double exit_rate = change_with_time(exact, [](const auto& x) { return x.exit_speed_c; });
  Convergence speed_b, lost, exit, balance_error;
  double ratios[4]{};
  // Change by the break of the power of the cable forces on both masses.
  const reference::PairState& at = exact.at_break;
  const double pull = pair.stiffness_2 * (at.c - at.b);
  const double power = -strength * at.speed_b + (pull - exact.merged_stiffness * at.c) * at.speed_c;
  for (const double count : doublings(setup.coarse ? 256.0 : 32.0, setup.coarse ? 1 : 4)) {
    PhaseError of_b, of_lost, of_exit, open;
    for (std::size_t i = 0; i < phases(setup); ++i) {
      const double step = offset_step(exact.slack_time, count * 4.0, i);
      CableRunResult run = run_pair(strength, step, even_phases(phases(setup))[i], 1.02 * exact.slack_time + 4.0 * step,
                                    VelocityVerlet{}, findings);
      of_b.add(run.end.v[0] - exact.at_break.speed_b);
      of_lost.add(recorded_work(run.end, Mechanism::hanger_break) - exact.lost);
      of_exit.add(-run.end.v[1] - exact.exit_speed_c);
      if (setup.has("hanger_not_booked")) run.balance_error -= recorded_work(run.end, Mechanism::hanger_break);
      open.add(run.balance_error);
    }
    const double step = exact.slack_time / (4.0 * count + 0.5), late = step / std::sqrt(3.0);
    speed_b.add(step, of_b.rms());
    lost.add(step, of_lost.rms());
    exit.add(step, of_exit.rms());
    balance_error.add(step, open.rms());
    ratios[0] = of_b.rms() / (0.5 * late * b_rate);
    ratios[1] = of_lost.rms() / (late * lost_rate);
    ratios[2] = of_exit.rms() / (0.5 * late * std::abs(exit_rate));
    ratios[3] = open.rms() / (0.5 * step * std::abs(power));
  }
  const Tolerance near = Tolerance::model(
      0.03,
      "the break is detected late by a uniformly distributed fraction of a step: the rms error of the lost energy is "
      "h/sqrt(3) times the reference's derivative with respect to the time of the break, that of speeds half as much, "
      "because the half kick before the detection already omits the hanger; the energy balance error is h/2 times the "
      "change of the power; the next order in h adds 2 %, and 64 unevenly spread phases 1 %");
  findings.expect({"hanger/speed", "speed of the mass released by the hanger, rms error over its prediction"},
                  ratios[0], 1.0, near);
  findings.expect({"hanger_energy/loss", "energy lost in the hanger break, rms error over its prediction"}, ratios[1],
                  1.0, near);
  findings.expect("exit speed of the mass on the merged cable, rms error over its prediction", ratios[2], 1.0, near);
  findings.expect({"hanger_balance", "energy balance error over its prediction, hanger break"}, ratios[3], 1.0, near);
  findings.expect_order({"hanger/order_of_speed", "order of the speed of the mass released by the hanger"}, speed_b,
                        0.98, 1.02, "the hanger breaks at the first step at which its load exceeds its strength");
  findings.expect_order(
      {"hanger_energy/order", "order of the energy balance error, hanger break"}, balance_error, 0.98, 1.02,
      "the forces change with the half kick before the break is detected, but the energy is recorded at the detection");
}

/// Differences between the two cables past the broken hanger and a scene that has a single cable.
struct MergedDifference {
  double position{};  ///< of the mass at the end [m]
  double tension{};   ///< from that of the one cable [N]
  double tensions{};  ///< between the two cables [N]
};

/// Runs both until the cables are nearly slack. A dashpot is its cable's stiffness times `relaxation`, so that the
/// dashpots in series are that of the one cable.
MergedDifference merged_difference(double relaxation, Findings& findings, const Setup& setup) {
  const double strength = 0.7 * reference::first_load_peak(pair).load;
  const reference::HangerBreak exact = reference::break_hanger(pair, strength);
  const double step = exact.slack_time / 400.0;
  // Until a few steps after the break.
  const Scene two = hung_pair(pair, strength, relaxation);
  State start = two.initial;
  start.q[1] -= 0.5 * step * pair.speed;
  const CableRunResult first =
      run_cables(two, start, VelocityVerlet{}, {step, exact.time + 4.0 * step, false}, findings);
  if (!first.hanger_broken) return {NAN, NAN, NAN};
  const double left = 0.9 * (exact.slack_time - first.end.t);
  reference::HungPair given = pair;
  if (setup.has("two_cables_side_by_side")) {
    given.stiffness_1 += given.stiffness_2;
    given.stiffness_2 = 1e9;
  }
  const Scene one = parted_pair_scene(given, first.end, relaxation);
  const CableRunResult a =
      run_cables(two, first.end, VelocityVerlet{}, {step, first.end.t + left, false, true}, findings);
  const CableRunResult b =
      run_cables(one, one.initial, VelocityVerlet{}, {step, first.end.t + left, false, true}, findings);
  MergedDifference found{.position = std::abs(a.end.q[1] - b.end.q[1])};
  for (std::size_t i = 0; i < a.time.size(); ++i) {
    keep_largest(found.tension, a.tension[i] - b.tension[i]);
    keep_largest(found.tensions, a.tension[i] - a.second_tension[i]);
  }
  return found;
}

/// Compares the two cables past the broken hanger with a scene that has a single cable.
void check_merged(Findings& findings, const Setup& setup) {
  const MergedDifference elastic = merged_difference(0.0, findings, setup);
  findings.expect_round_off(
      {"hanger/merged_position",
       "position of the mass, difference between two cables past the broken hanger and one cable"},
      elastic.position, 0.0, 1e-13,
      "round-off of the tensions, 1e-14, over 1 s^2 and a few hundred steps, accumulated as a random walk", "m");
  findings.expect_round_off(
      {"merged_tension", "tension, difference between two cables past the broken hanger and one cable"},
      elastic.tension, 0.0, 3e-14, "as for the difference between the two cables, once more for each cable", "N");
  findings.expect_round_off(
      {"hanger/tensions", "tension, difference between the two cables past the broken hanger"}, elastic.tensions, 0.0,
      3e-14, "k (l - l0) with lengths near 8 m: four roundings of half an ulp of 8, times the stiffness 5", "N");
  if (setup.coarse) return;
  MergedDifference damped = merged_difference(0.02, findings, setup);
  keep_largest(damped.tension, damped.tensions);
  findings.expect_round_off(
      "tension with dashpots, difference between the two cables past the broken hanger or from one cable",
      damped.tension, 0.0, 3e-14,
      "as without dashpots: dashpots proportional to the stiffness in series are one dashpot", "N");
}

/// Two cables with different plastic stretch also have one tension, given by the sum of their lengths.
void check_merged_plastic(Findings& findings) {
  constexpr double drawn[] = {0.05, 0.02};
  const double strength = 0.7 * reference::first_load_peak(pair).load;
  const reference::HangerBreak exact = reference::break_hanger(pair, strength);
  const Scene scene = hung_pair(pair, strength);
  State state = scene.initial;
  state.z = {drawn[0], drawn[1]};
  state.q[0] += drawn[0], state.q[1] += drawn[0] + drawn[1];
  const double step = exact.slack_time / 400.0, end = exact.time + 0.5 * (exact.slack_time - exact.time);
  const CableRunResult run = run_cables(scene, state, VelocityVerlet{}, {step, end, false, true}, findings);
  const double elongation = run.end.q[1] - 2.0 * cable_length - drawn[0] - drawn[1];
  double apart = std::abs(run.tension.back() - run.second_tension.back());
  keep_worst(apart, run.tension.back() - exact.merged_stiffness * elongation);
  findings.expect_round_off(
      "tensions of two plastically stretched cables past the broken hanger, difference from one cable",
      run.hanger_broken ? apart : std::nan(""), 0.0, 1e-13,
      "k (l - l0 - p) with lengths near 16 m: a few roundings, times the stiffness 5", "N");
  // The first cable ends at the point between the cables: at its plastic length plus the elastic elongation.
  const Dynamics dynamics{scene.model};
  const Snapshot seen{dynamics, run.end};
  const double x = seen.geometry().joints.p_WP(dynamics.cables().ends()[0].b).x;
  findings.expect_round_off("end point of the first of two plastically stretched cables past the broken hanger", x,
                            cable_length + drawn[0] + exact.merged_stiffness * elongation / pair.stiffness_1, 1e-14,
                            "a few roundings of lengths near 8 m", "m");
}

constexpr const char* control_reason =
    "local errors below 1e-11; a step across the break is rejected until the jump of the force times the square of the "
    "step is below that: the break is up to 1e-6 s early or late, with its full effect on the energy and half of it on "
    "the speed";

/// With step control the break is resolved to the tolerance.
void check_hanger_exactly(Findings& findings, const Setup& setup) {
  const double strength = (setup.has("strength_unread") ? 0.998 : 1.0) * 0.7 * reference::first_load_peak(pair).load;
  const reference::HangerBreak exact = reference::break_hanger(pair, 0.7 * reference::first_load_peak(pair).load);
  const CableRunResult run = run_pair(strength, exact.slack_time / 40.0, 0.5, 1.1 * exact.slack_time,
                                      make_integrator("odeint_dopri5", 1e-11), findings);
  findings.expect_truncation({"hanger_loss", "energy lost in the hanger break with step control"},
                             recorded_work(run.end, Mechanism::hanger_break), exact.lost, 2e-8, 1.0, control_reason,
                             "J");
  findings.expect_truncation({"hanger/exit_speed", "exit speed of the mass on the merged cable with step control"},
                             -run.end.v[1], exact.exit_speed_c, 2e-9, 1.0, control_reason, "m/s");
  // A method that locates the break finds it also if a hanger that holds comes first in the list.
  Scene scene = hung_pair(pair, strength);
  scene.model.hangers.insert(scene.model.hangers.begin(), Hanger{"holds", *find_body(scene.model, "c"), {}, 1e9});
  scene.initial.mode.push_back(Mode{0});
  const CableRunResult located = run_cables(scene, scene.initial, make_integrator("stormer_cowell", 1e-11),
                                            {exact.slack_time / 4.0, 1.1 * exact.slack_time, false}, findings);
  const Tolerance located_bound = Tolerance::truncation(
      1e-10, 1.0, "local errors below 1e-11 of speed and distance travelled, about ten of them with the same sign");
  findings.expect("energy lost in the located break of the second of two hangers",
                  recorded_work(located.end, Mechanism::hanger_break), exact.lost, located_bound, "J");
  findings.expect("exit speed of the mass after the located break of the second of two hangers", -located.end.v[1],
                  exact.exit_speed_c, located_bound, "m/s");
}

void draw_hanger(Findings& findings) {
  const double strength = 0.7 * reference::first_load_peak(pair).load;
  const reference::HangerBreak exact = reference::break_hanger(pair, strength);
  const CableRunResult run =
      run_pair(strength, exact.slack_time / 480.0, 0.5, 1.1 * exact.slack_time, VelocityVerlet{}, findings, true);
  Series one{"anchor to mass, solver", {}, {}, Style::points}, two{"mass to mass, solver", {}, {}, Style::crosses};
  for (std::size_t i = 0; i < run.time.size(); i += 11) {
    one.add(run.time[i], run.tension[i]);
    two.add(run.time[i], run.second_tension[i]);
  }
  Series exact_one{"anchor to mass, exact", {}, {}, Style::lines},
      exact_two{"mass to mass, exact", {}, {}, Style::lines};
  for (int i = 0; i <= 200; ++i) {
    const double t = exact.time * i / 200.0;
    const reference::PairState s = reference::held_pair(pair, t);
    exact_one.add(t, pair.stiffness_1 * s.b);
    exact_two.add(t, pair.stiffness_2 * (s.c - s.b));
  }
  for (int i = 0; i <= 200; ++i) {
    const double t = exact.time + (exact.slack_time - exact.time) * i / 200.0;
    const double tension = exact.merged_stiffness * reference::parted_pair(pair, exact, t).c;
    for (Series* s : {&exact_one, &exact_two}) {
      s->add(t, tension);
    }
  }
  findings.figure({.name = "hanger",
                   .title = "Cable tensions before and after a hanger breaks",
                   .caption = "Tension of the two cables on either side of a mass whose hanger breaks at 70 % of the "
                              "peak load. After the break they act as one cable.",
                   .x = {.label = "time", .unit = "s"},
                   .y = {.label = "tension", .unit = "N"},
                   .series = {exact_one, exact_two, one, two},
                   .slopes = {},
                   .lines = {{'x', exact.time, "break"}}});
}

/// Two equal cables from an anchor to a mass and back: when the hanger has broken, the chain begins and ends at one
/// point, has no length, and its middle is at this point.
void check_loop(Findings& findings) {
  const Vec2 anchor{1.0, 2.0};
  ModelBuilder builder;
  const BodyId body = builder.add(Body{.name = "mass", .mass = mass, .inertia = 1.0, .p_WB = {1.0, 0.0}});
  for (const char* const name : {"there", "back"})
    builder.add(Cable{.name = name,
                      .a = {std::nullopt, {anchor.x, anchor.y, 0.0}},
                      .b = {body, {}},
                      .rest_length = 1.0,
                      .law = ElasticPlastic{.stiffness = stiffness}});
  builder.add(Hanger{"hanger", body, {}, 0.5 * stiffness});
  const Model model = builder.build();
  const Dynamics dynamics{model};
  RigidBodySystem system{dynamics};
  State state = rest_state(model);
  system.begin(state);
  Workspace work = dynamics.workspace();
  dynamics.update(state, work);
  double farthest = 0.0;
  for (std::size_t joint = 0; joint < dynamics.cables().joints().size(); ++joint)
    keep_worst(farthest, norm(work.joints.p_WP(joint) - anchor));
  findings.expect_exact("loop past a broken hanger: distance of its joints from the anchor, largest",
                        work.topology.chains.empty() ? NAN : farthest, 0.0, "the chain has both its ends there", "m");
}

}  // namespace

void check_breaking(Findings& findings, const Setup& setup) {
  check_both_sides(findings, setup);
  check_release(findings, setup);
  if (!setup.coarse || setup.needs("located break")) check_located_breaks(findings, setup);
}

void check_hanger(Findings& findings, const Setup& setup) {
  check_hanger_orders(findings, setup);
  check_merged(findings, setup);
  if (setup.coarse) return;
  check_merged_plastic(findings);
  check_loop(findings);
  check_hanger_sides(findings, setup);
  check_hanger_exactly(findings, setup);
  draw_hanger(findings);
}

}  // namespace talus::verification::problems
