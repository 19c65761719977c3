#include <concepts>
#include <type_traits>

#include "solver/granular/disc_order.hpp"
#include "solver/granular/disc_system.hpp"
#include "solver/granular/fast_disc_system.hpp"
#include "solver/granular/packing.hpp"
#include "solver/laws/hertz.hpp"
#include "solver/laws/hunt_crossley.hpp"
#include "solver/laws/latching_spring.hpp"
#include "solver/laws/linear_spring_dashpot.hpp"
#include "verification/reference/many_bodies/all_pairs.hpp"
#include "verification/study/toolkit.hpp"

namespace talus::verification::problems::fast_disc_engine {
namespace {

constexpr double step = 0.157;
constexpr std::size_t count = 300;

const LatchingSpring latching{0.5, 0.5 / 0.49, 0.0}, growing{0.5, 0.6, 5.0};
const LinearSpringDashpot clamped{0.5, 0.1}, attractive{0.5, 0.1, EndRule::attractive};
// The secant stiffness of these is that of the others at an overlap of 0.01.
const Hertz tsuji{7.5, 0.25, 0.2}, constant{7.5, 0.25, 0.1, EndRule::attractive, HertzDashpot::constant};
const HuntCrossley hysteresis{0.5, 0.01, 1.5, 20.0}, any_power{0.5, 0.01, 2.3, 20.0};
const CoulombFriction rough{0.5, 0.35};

Packing sheared_packing(std::size_t discs) {
  Packing packing =
      grow({.discs = discs, .diameter = 1.0, .spread = 0.2, .mass = 1.0, .solid_fraction = 0.78, .seed = 3});
  agitate(packing, 1e-4, 4);
  packing.box.shear_rate = 0.01;
  for (std::size_t i = 0; i < packing.discs.size(); ++i)
    packing.discs.vx[i] += packing.box.shear_rate * packing.discs.y[i];
  const std::vector<std::size_t> order = order_by_rows(packing.shapes, packing.discs);
  packing.shapes = reordered(packing.shapes, order), packing.discs = reordered(packing.discs, order);
  return packing;
}

/// Number of positions, velocities, spins and dissipated energies that differ.
long differing(const Discs& a, const Discs& b) {
  long differ = 0;
  const auto compare = [&](const std::vector<double>& one, const std::vector<double>& other) {
    for (std::size_t i = 0; i < one.size(); ++i)
      differ += one[i] == other[i] ? 0 : 1;
  };
  compare(a.x, b.x), compare(a.y, b.y), compare(a.vx, b.vx), compare(a.vy, b.vy), compare(a.spin, b.spin);
  for (std::size_t k = 0; k < a.work.size(); ++k)
    differ += a.work[k] == b.work[k] ? 0 : 1;
  return differ;
}

double furthest(const Discs& a, const Discs& b, const PeriodicBox& box) {
  double maximum = 0.0;
  for (std::size_t i = 0; i < a.size(); ++i) {
    const Vec2 d{a.x[i] - b.x[i], a.y[i] - b.y[i]};
    const double offset = box.offset(a.shear_displacement);
    keep_largest(maximum, norm(d + box.shift(box.nearest(d, offset), offset)));
  }
  return maximum;
}

template <class Law, class Friction>
void expect_same(Findings& findings, const Setup& setup, const std::string& name, const Law& law,
                 const Friction& friction) {
  if (!setup.needs("values that differ from the plain engine, " + name)) return;
  const Packing start = sheared_packing(count);
  const long steps = setup.coarse ? 1500 : 4000;
  Discs plain_discs = start.discs, fast_discs = start.discs;
  DiscSystem plain{start.shapes, start.box, law, 0.4, friction};
  FastDiscSystem fast{start.shapes, start.box, law, 0.4, friction};
  if (!setup.has("work_not_kept")) fast.keep_work();
  plain.begin(plain_discs), fast.begin(fast_discs);
  if (setup.has("one_disc_off")) fast_discs.y[7] = std::nextafter(fast_discs.y[7], 100.0);
  for (long n = 0; n < steps; ++n)
    plain.kick(plain_discs, step), plain.drift(plain_discs, step);
  fast.advance(fast_discs, step, steps);
  findings.count(plain.evaluations() + fast.evaluations());
  constexpr auto lost = static_cast<std::size_t>(Law::dissipation);
  if constexpr (fast.has_history) fast_discs.work[lost] = plain_discs.work[lost];
  findings.expect_exact({"engines", "values that differ from the plain engine, " + name},
                        static_cast<double>(differing(plain_discs, fast_discs)), 0.0,
                        "the same sums in the same order");
  if constexpr (!std::same_as<Law, LatchingSpring> || !std::same_as<Friction, Frictionless>) return;
  long touching = 0;
  fast.for_each_contact(fast_discs, [&](const DiscContact&) { ++touching; });
  findings.expect_between("contacts per disc at the end, " + name,
                          2.0 * static_cast<double>(touching) / static_cast<double>(count), 0.3, 4.0,
                          "without contacts there is nothing to compare; jammed discs in a plane have four on average");
  findings.expect_between("number of builds of the neighbour list, " + name, static_cast<double>(fast.builds()), 3.0,
                          0.2 * static_cast<double>(steps), "contacts must be carried over from list to list");
}

/// Separate calls of kick, drift and evaluate, between which the caller changes the discs: velocities are reversed
/// between a kick and a drift and between a drift and a kick, and at the end one disc is displaced.
void expect_single_calls(Findings& findings, const Setup& setup) {
  const std::string name = "values that differ after separate calls with discs changed in between";
  if (!setup.needs(name)) return;
  const Packing start = sheared_packing(count);
  DiscSystem plain{start.shapes, start.box, clamped, 0.4, rough};
  FastDiscSystem fast{start.shapes, start.box, clamped, 0.4, rough};
  fast.keep_work();
  Discs of_plain = start.discs, of_fast = start.discs;
  plain.begin(of_plain), fast.begin(of_fast);
  const auto reverse = [](Discs& discs) {
    for (std::vector<double>* const numbers : {&discs.vx, &discs.vy, &discs.spin})
      for (double& number : *numbers)
        number = -number;
  };
  DiscRates rates_of_plain{of_plain}, rates_of_fast{of_fast};
  double differ = 0.0;
  const auto evaluate = [&] {
    plain.evaluate(of_plain, rates_of_plain), fast.evaluate(of_fast, rates_of_fast);
    for (const auto numbers : {&DiscRates::vx, &DiscRates::vy, &DiscRates::spin})
      for (std::size_t i = 0; i < count; ++i)
        differ += (rates_of_plain.*numbers)[i] == (rates_of_fast.*numbers)[i] ? 0.0 : 1.0;
    differ += static_cast<double>(differing(of_plain, of_fast));
  };
  constexpr long steps = 400;
  for (long n = 0; n < steps; ++n) {
    plain.kick(of_plain, step), fast.kick(of_fast, step);
    if (n == steps / 2) reverse(of_plain), reverse(of_fast);
    plain.drift(of_plain, step), fast.drift(of_fast, step);
    if (n == steps / 4) reverse(of_plain), reverse(of_fast);
  }
  evaluate();
  of_plain.x[7] += 0.02, of_fast.x[7] += 0.02;
  evaluate();
  findings.count(plain.evaluations() + fast.evaluations());
  findings.expect_exact({"engines", name}, differ, 0.0, "the same sums of the same numbers");
}

/// Two discs that a latching spring presses, and that part so fast that one step takes them beyond the neighbour list.
void expect_parted_discs(Findings& findings, const Setup& setup) {
  const std::string name = "energy lost by a contact that leaves the list within a step, over the closed form, ";
  if (!setup.needs(name + "fast engine") && !setup.needs(name + "plain engine")) return;
  constexpr double overlap = 0.1, skin = 0.4, far = 10.0;
  DiscShapes shapes;
  Discs start;
  for (const double side : {-1.0, 1.0})
    shapes.add(0.5, 1.0), start.add(0.5 * side * (1.0 - overlap), 0.0, side, 0.0);
  DiscSystem plain{shapes, PeriodicBox{}, latching, skin};
  FastDiscSystem fast{shapes, PeriodicBox{}, latching, skin};
  Discs of_plain = start, of_fast = start;
  plain.begin(of_plain), fast.begin(of_fast);
  plain.kick(of_plain, step), fast.kick(of_fast, step);
  plain.drift(of_plain, far), fast.drift(of_fast, far);
  findings.count(plain.evaluations() + fast.evaluations());
  // Loaded along K1 and unloaded along K2, a spring keeps K1/K2 of its energy.
  const double lost =
      0.5 * latching.stiffness * overlap * overlap * (1.0 - latching.stiffness / latching.unloading_stiffness);
  const char* const why =
      "the overlap is a difference of numbers ten times as large: 1.1e-15 of it, and twice that of its square; four "
      "times as much";
  findings.expect_round_off({"engines", name + "fast engine"}, fast.lost() / lost, 1.0, 1e-14, why);
  findings.expect_round_off({"engines", name + "plain engine"}, of_plain.dissipated() / lost, 1.0, 1e-14, why);
}

/// Several threads compared with one, over few steps: threads wait for each other where there are fewer processors.
void expect_threads(Findings& findings, const Setup& setup) {
  if (!setup.needs("threads")) return;
  const Packing start = sheared_packing(count);
  constexpr long steps = 500;
  Discs alone = start.discs;
  FastDiscSystem one{start.shapes, start.box, latching, 0.4};
  one.begin(alone);
  one.advance(alone, step, steps);
  for (const std::size_t threads : {2U, 3U, 7U}) {
    const std::string name = fmt::format("values that differ with {} threads", threads);
    if (!setup.needs(name)) continue;
    Discs together = start.discs;
    FastDiscSystem several{start.shapes, start.box, latching, 0.4, Frictionless{}, threads};
    several.begin(together);
    if (setup.has("thread_off")) together.y[count - 1] = std::nextafter(together.y[count - 1], 100.0);
    several.advance(together, step, steps);
    findings.expect_exact({"threads", name}, static_cast<double>(differing(together, alone)), 0.0,
                          "the same sums in the same order");
  }
}

/// The plain engine compared with a loop over all pairs, in the open plane, where no disc is wrapped back into a box.
void expect_all_pairs(Findings& findings, const Setup& setup) {
  const Packing start = sheared_packing(count);
  Discs discs = start.discs;
  for (std::size_t i = 0; i < discs.size(); ++i) {  // towards the middle
    discs.vx[i] -= 0.002 * discs.x[i], discs.vy[i] -= 0.002 * discs.y[i];
  }
  reference::AllPairs all{.stiffness = clamped.stiffness,
                          .damping = clamped.damping,
                          .radius = start.shapes.radius,
                          .inverse_mass = start.shapes.inverse_mass,
                          .x = discs.x,
                          .y = discs.y,
                          .vx = discs.vx,
                          .vy = discs.vy,
                          .backwards = setup.has("pairs_backwards")};
  DiscSystem system{start.shapes, {}, clamped, 0.2};
  system.begin(discs);
  const long steps = setup.coarse ? 800 : 2000;
  for (long n = 0; n < steps; ++n)
    all.step(step), system.kick(discs, step), system.drift(discs, step);
  Discs those = discs;
  those.x = all.x, those.y = all.y, those.vx = all.vx, those.vy = all.vy;
  findings.count(system.evaluations());
  findings.expect_exact({"all_pairs", "values that differ from a loop over all pairs"},
                        static_cast<double>(differing(those, discs)), 0.0,
                        "the same pairs in the same order; a list omits only pairs that do not touch");
}

/// Effect of another order of the sums.
void show_order(Findings& findings) {
  const Packing start = sheared_packing(count);
  std::vector<std::size_t> reverse(count);
  for (std::size_t i = 0; i < count; ++i)
    reverse[i] = count - 1 - i;
  FastDiscSystem there{start.shapes, start.box, latching, 0.4};
  FastDiscSystem back{reordered(start.shapes, reverse), start.box, latching, 0.4};
  DiscSystem plain{start.shapes, start.box, latching, 0.4};
  Discs discs = start.discs, of_plain = start.discs, turned = reordered(start.discs, reverse);
  there.begin(discs), plain.begin(of_plain), back.begin(turned);
  Series other{.label = "discs numbered backwards", .style = Style::lines};
  Series same{.label = "plain engine", .style = Style::lines};
  constexpr long between = 50;
  for (long n = between; n <= 6000; n += between) {
    there.advance(discs, step, between), back.advance(turned, step, between);
    for (long k = 0; k < between; ++k)
      plain.kick(of_plain, step), plain.drift(of_plain, step);
    other.x.push_back(static_cast<double>(n)), same.x.push_back(static_cast<double>(n));
    other.y.push_back(std::max(furthest(reordered(turned, reverse), discs, start.box), 1e-17));
    same.y.push_back(std::max(furthest(of_plain, discs, start.box), 1e-17));
  }
  findings.figure({.name = "order",
                   .title = "Effect of the order of summation",
                   .caption = "Largest distance between positions of the same disc in two runs with latching springs: "
                              "discs numbered backwards, so that impulses are summed in another order (blue), and "
                              "plain engine, which sums them in the same order (orange; zero is drawn as $10^{-17}$).",
                   .x = {"step", "1"},
                   .y = {.label = "distance over d", .log = true, .min = 1e-18, .max = 10.0},
                   .series = {other, same}});
}

void run(Findings& findings, const Setup& setup) {
  expect_same(findings, setup, "latching spring", latching, Frictionless{});
  expect_same(findings, setup, "stiffening latching spring, friction", growing, rough);
  expect_same(findings, setup, "spring and dashpot", clamped, Frictionless{});
  expect_same(findings, setup, "spring and dashpot, friction", clamped, rough);
  expect_same(findings, setup, "attractive end, friction", attractive, rough);
  expect_same(findings, setup, "Hertz, tsuji", tsuji, Frictionless{});
  expect_same(findings, setup, "Hertz, constant, friction", constant, rough);
  expect_same(findings, setup, "Hunt and Crossley", hysteresis, Frictionless{});
  expect_same(findings, setup, "Hunt and Crossley, n = 2.3, friction", any_power, rough);
  expect_single_calls(findings, setup);
  expect_parted_discs(findings, setup);
  expect_threads(findings, setup);
  if (setup.needs("a loop over all pairs")) expect_all_pairs(findings, setup);
  if (!setup.coarse) show_order(findings);
}

}  // namespace

Case definition() {
  return {.id = "fast_disc_engine",
          .title = "Vectorised and threaded disc engine against a loop over all pairs",
          .family = "the shear cell",
          .requirements = {{"F3", {"engines", "threads", "all_pairs"}}},
          .main_checks = {"values that differ from the plain engine, latching spring",
                          "values that differ from the plain engine, spring and dashpot, friction",
                          "values that differ with 2 threads", "values that differ with 7 threads", "all_pairs"},
          .source = "order of sums, derived here",
          .faults = {{"one_disc_off", "one disc of the fast engine initially higher by one unit in the last place",
                      "values that differ from the plain engine, latching spring"},
                     {"work_not_kept", "fast engine without the energies dissipated by dashpots and friction",
                      "values that differ from the plain engine, spring and dashpot, friction"},
                     {"thread_off", "last disc higher by one unit in the last place with threads",
                      "values that differ with 7 threads"},
                     {"pairs_backwards", "the loop over all pairs begins with the last disc", "all_pairs"}},
          .seconds = 5.0,
          .run = run};
}

}  // namespace talus::verification::problems::fast_disc_engine
