#include "verification/problems/speed_accuracy/bilateral_findings.hpp"

#include <variant>

#include "solver/run/simulate.hpp"
#include "solver/scenes/fence_scene.hpp"
#include "verification/study/scenes/fence_table.hpp"
#include "verification/study/toolkit.hpp"

namespace talus::verification::problems {
namespace {

struct HighestMode {
  double frequency{};         ///< w [rad/T]; NaN without a restoring force
  std::vector<double> shape;  ///< of the coordinates; normalized: sum of inertia times square is 1
};

/// The state displaced by `distance` along a shape of the coordinates, with zero velocities.
State moved(RigidBodySystem& system, const State& rest, const std::vector<double>& shape, double distance) {
  State state = rest;
  state.v = shape;
  system.drift(state, distance);
  state.v.assign(state.v.size(), 0.0);
  return state;
}

/// Scalar product of two sets of coordinates, weighted by the inertias.
double product(const Dynamics& dynamics, const std::vector<double>& a, const std::vector<double>& b) {
  double sum = 0.0;
  for (std::size_t i = 0; i < a.size(); ++i)
    sum += dynamics.inertias()[i] * a[i] * b[i];
  return sum;
}

/// The highest mode by power iteration on the stiffness, computed from central differences of the forces at `distance`
/// [L] on either side of the state. The state drifts there, so that memory that follows the motion (the springs of
/// friction) is updated.
HighestMode highest_mode(const Dynamics& dynamics, const State& rest, double distance, int iterations) {
  RigidBodySystem system{dynamics, false};
  State settled = rest;
  system.begin(settled);
  HighestMode mode;
  for (std::size_t i = 0; i < rest.q.size(); ++i)
    mode.shape.push_back(std::cos(1.0 + 2.4 * static_cast<double>(i)));  // not orthogonal to the mode of any scene
  Rates there{settled}, back{settled};
  for (int n = 0; n < iterations; ++n) {
    const double length = std::sqrt(product(dynamics, mode.shape, mode.shape));
    for (double& x : mode.shape)
      x /= length;
    State ahead = moved(system, settled, mode.shape, distance), behind = moved(system, settled, mode.shape, -distance);
    system.evaluate(ahead, there);
    system.evaluate(behind, back);
    std::vector<double> pull(rest.q.size());
    for (std::size_t i = 0; i < pull.size(); ++i)
      pull[i] = (back.v[i] - there.v[i]) / (2.0 * distance);
    mode.frequency = std::sqrt(product(dynamics, mode.shape, pull));
    if (n + 1 < iterations) mode.shape = pull;
  }
  return mode;
}

/// ln growth per step of that mode in a run by velocity Verlet from the amplitude `start` [L], measured between 1e2 and
/// 1e5 times `start`; 0 if it does not exceed 1.5 times `start` within `steps` steps, NaN in any other case.
double mode_growth(const Dynamics& dynamics, const State& rest, const HighestMode& mode, double start, double step,
                   long steps) {
  RigidBodySystem system{dynamics, false};
  State state = rest;
  system.begin(state);
  state = moved(system, state, mode.shape, start);
  std::vector<double> sizes;
  const Observer watch = [&](const State& seen, const StepInfo&) {
    std::vector<double> displacement(seen.q.size());
    for (std::size_t i = 0; i < displacement.size(); ++i)
      displacement[i] = seen.q[i] - rest.q[i];
    sizes.push_back(std::hypot(product(dynamics, mode.shape, displacement),
                               product(dynamics, mode.shape, seen.v) / mode.frequency));
  };
  const StopCondition done = [&](const State&) { return !sizes.empty() && !(sizes.back() < 1e6 * start); };
  Integrator verlet = VelocityVerlet{};
  const RunPlan plan{.step = step, .end = step * static_cast<double>(steps), .interval = step, .ledger = false};
  record_use(dynamics.model());
  record_use(verlet);
  (void)simulate(system, verlet, state, plan, {&watch, 1}, done);
  std::size_t from = 0, to = 0;
  bool stays = true;
  for (std::size_t i = 0; i < sizes.size(); ++i) {
    stays = stays && sizes[i] <= 1.5 * start;
    if (from == 0 && sizes[i] > 1e2 * start) from = i;
    if (to == 0 && sizes[i] > 1e5 * start) to = i;
  }
  if (stays) return 0.0;
  if (to == 0) return std::numeric_limits<double>::quiet_NaN();
  return std::log(sizes[to] / sizes[from]) / static_cast<double>(to - from);
}

constexpr double stiffness = 1e4, depth = 0x1p-10;  // of contacts between discs of mass and radius 1

Body disc(const std::string& name, Mobility mobility, Vec2 position) {
  return {.name = name, .mobility = mobility, .mass = 1.0, .inertia = 0.5, .shape = Circle{1.0}, .p_WB = position};
}

Contact closed(const std::string& name, BodyId a, BodyId b) {
  return {.name = name, .a = a, .b = b, .law = LinearSpringDashpot{stiffness, 0.0, EndRule::clamped}};
}

Scene at_rest(const SceneBuilder& builder) { return builder.at_rest("Held together"); }

/// A disc pressed on a plane and sticking to it.
Scene pressed_on_plane(double tangential) {
  SceneBuilder builder;
  Body body = disc("disc", Mobility::free, {0.0, 1.0 - depth});
  body.force = {0.0, -stiffness * depth};
  const BodyId pressed = builder.add(body);
  const BodyId plane = builder.add({.name = "plane", .mobility = Mobility::fixed, .shape = HalfPlane{}});
  Contact contact = closed("contact", pressed, plane);
  contact.friction = CoulombFriction{.coefficient = 1e3, .stiffness = tangential};
  builder.add(contact);
  return at_rest(builder);
}

/// Two discs side by side: pressed together along their line of centres, or guided across it at a constant distance.
Scene pair(bool across, double tangential) {
  SceneBuilder builder;
  const Mobility mobility = across ? Mobility::guided_y : Mobility::sliding_x;
  Body left = disc("left", mobility, {0.0, 0.0}), right = disc("right", mobility, {2.0 - depth, 0.0});
  if (!across) left.force.x = stiffness * depth, right.force.x = -stiffness * depth;
  Contact contact = closed("contact", builder.add(left), builder.add(right));
  if (across) contact.friction = CoulombFriction{.coefficient = 1e3, .stiffness = tangential};
  builder.add(contact);
  return at_rest(builder);
}

/// n discs in a row between two walls, all contacts with the same overlap.
Scene row(int n) {
  SceneBuilder builder;
  const BodyId floor =
      builder.add({.name = "floor", .mobility = Mobility::fixed, .shape = HalfPlane{}, .p_WB = {0.0, depth - 1.0}});
  BodyId below = floor;
  for (int i = 0; i < n; ++i) {
    const BodyId next = builder.add(disc(fmt::format("disc{}", i), Mobility::sliding_y, {0.0, (2.0 - depth) * i}));
    builder.add(closed(fmt::format("contact{}", i), below, next));
    below = next;
  }
  const BodyId ceiling = builder.add({.name = "ceiling",
                                      .mobility = Mobility::fixed,
                                      .shape = HalfPlane{},
                                      .p_WB = {0.0, (2.0 - depth) * (n - 1) + 1.0 - depth},
                                      .angle = std::numbers::pi});
  builder.add(closed("top", below, ceiling));
  return at_rest(builder);
}

/// Checks runs on both sides of w h = 2: their growth against 2 acosh(w h/2), and the number of runs that grow or stay
/// although they must not.
void check_growth(const std::string& name, const Dynamics& dynamics, const State& rest, const HighestMode& mode,
                  double frequency, double start, Findings& findings) {
  double worst = 0.0;
  int wrong = 0;
  for (const double ratio : {0.98, 0.999, 1.001, 1.02}) {
    const double growth = mode_growth(dynamics, rest, mode, start, ratio * 2.0 / frequency, 250);
    wrong += (ratio > 1.0 ? growth > 0.0 : growth == 0.0) ? 0 : 1;
    if (ratio < 1.0) continue;
    const double error = growth / (2.0 * std::acosh(ratio)) - 1.0;
    keep_worst(worst, error);
  }
  findings.count(1000);
  const auto claim = findings.in("integrator.velocity_verlet");
  findings.expect_exact({"sides_of_2", name + ": runs on the wrong side of w h = 2"}, wrong, 0.0,
                        "count: at 0.98 and 0.999 of the limit the mode stays within 1.5 times its initial size, as "
                        "the leapfrog's invariant requires; at 1.001 and 1.02 it grows");
  findings.expect_round_off(name + ": ln growth per step at 1.001 and 1.02 of the limit, largest relative error", worst,
                            0.0, 2e-3,
                            "a relative frequency error of 2e-6 turns 1.001 into 1.001002: 0.1 % of the growth; the "
                            "decaying mode is 1e-4 of the growing one where the measurement begins");
}

/// Checks a system whose highest frequency has a closed form, and adds it to the table.
void check_system(const std::string& name, const std::string& formula, const Scene& scene, double exact,
                  Findings& findings, Table& table) {
  const Dynamics dynamics{scene.model};
  const HighestMode mode = highest_mode(dynamics, scene.initial, 0x1p-4 * depth, 400);
  findings.expect(name + ": highest frequency by power iteration", mode.frequency, exact,
                  Tolerance::round_off(2e-6,
                                       "forces a sixteenth of the overlap apart, 6e-5, are rounded to 1e-15 of 1; the "
                                       "formula neglects the square of the overlap, 1e-6")
                      .relative(),
                  "rad/s");
  check_growth(name, dynamics, scene.initial, mode, exact, 3e-11, findings);
  table.rows.push_back(cells("{} | {} | {:.6g} | {:.6g} |  | ", name, formula, exact, mode.frequency));
}

/// The fence of Table 2 at a given time of its impact, without dashpots, held in equilibrium there by a constant force
/// on each body.
Scene held_fence(const scenes::FenceScene& made, double time) {
  Scene scene = made.scene;
  for (Contact& contact : scene.model.contacts) {
    std::visit(
        []<class L>(L& law) {
          if constexpr (HasDamping<L>) law.damping = 0.0;
        },
        contact.law);
  }
  {
    const Dynamics dynamics{scene.model};
    RigidBodySystem system{dynamics, false};
    scene.initial =
        run_scene(scene, make_integrator("stormer_cowell", 1e-10), {time, time, time, false}, nullptr).state;
    scene.initial.t = 0.0;
    scene.initial.v.assign(scene.initial.v.size(), 0.0);
    Rates rates{scene.initial};
    system.begin(scene.initial);
    system.evaluate(scene.initial, rates);
    for (std::size_t i = 0; i < rates.v.size(); ++i) {
      const Coordinate& coordinate = dynamics.layout().coordinates[i];
      Body& body = scene.model.bodies[index(coordinate.body)];
      if (coordinate.axis == talus::Axis::x) body.force.x -= body.mass * rates.v[i];
      if (coordinate.axis == talus::Axis::y) body.force.y -= body.mass * rates.v[i];
      if (coordinate.axis == talus::Axis::angle) body.moment -= body.inertia * rates.v[i];
    }
  }
  return scene;
}

void check_fence_limit(Findings& findings, const Setup& setup, Table& table) {
  const scenes::FenceScene made = scenes::fence_scene(published_fence("table_2.DAT"));
  const double rule = 2.0 * std::numbers::pi / (100.0 * made.critical_step);  // sqrt(2 k/m) of the central segment
  double highest = 0.0;
  for (const double time : {0.02, 0.005, 0.01, 0.03, 0.05, 0.08}) {
    if (setup.coarse && time != 0.02) continue;
    const Scene scene = held_fence(made, time);
    const Dynamics dynamics{scene.model};
    const HighestMode mode = highest_mode(dynamics, scene.initial, 1e-6, 3000);
    highest = std::max(highest, mode.frequency);
    Workspace work = dynamics.workspace();
    dynamics.update_all(scene.initial, work);
    int taut = 0;
    for (std::size_t c = 0; c < scene.model.cables.size(); ++c)
      taut += dynamics.elongation(work, static_cast<CableId>(c)) > 0.0 ? 1 : 0;
    const std::string name = fmt::format("fence held at {:g} s", time);
    check_growth(name, dynamics, scene.initial, mode, setup.has("fence_by_rule") ? rule : mode.frequency, 1e-9,
                 findings);
    table.rows.push_back(cells("{} | {} cables taut |  | {:.0f} | {:.2f} | 1/{:.0f}", name, taut, mode.frequency,
                               mode.frequency / rule, 2.0 / mode.frequency / made.critical_step));
  }
  if (setup.coarse) return;
  findings.expect_between("fence: highest frequency of six held states over that of the 1993 rule", highest / rule, 1.0,
                          std::numbers::sqrt2,
                          "above that of one column between its neighbours, sqrt(2 k/m), which is therefore no bound; "
                          "below sqrt(4 k/m) of a long straight chain, which the angles of the cables reduce");
}

}  // namespace

void check_bilateral_systems(Findings& findings, const Setup& setup) {
  Table table{
      .name = "frequencies",
      .caption =
          "Highest frequency by closed form and by power iteration on the solver's forces; for the fence of Table 2, "
          "held in equilibrium at states of its impact, also over that of the 1993 rule, $\\sqrt{2k/m}$ (Eq. 25), and "
          "the rule's step over the limit $2/\\omega$.",
      .columns = {"system", "formula", "exact", "power iteration", "over that of the rule", "step of the rule"}};
  const double k = stiffness;
  // If kt > kn/3, the tangential mode has the higher frequency: w^2 = kt (1/m + a^2/I), with the contact point half the
  // overlap inside.
  const double arm = 1.0 - 0.5 * depth, turning = 1.0 + 2.0 * arm * arm;
  const double decides = setup.has("kt_ignored") ? std::sqrt(k) : std::sqrt(0.4 * k * turning);
  check_system("sticking disc, kt = 0.4 kn", "$\\sqrt{3 k_t/m}$", pressed_on_plane(0.4 * k), decides, findings, table);
  if (!setup.coarse) {
    check_system("sticking disc, kt = 0.28 kn", "$\\sqrt{k_n/m}$", pressed_on_plane(0.28 * k), std::sqrt(k), findings,
                 table);
    check_system("pair, normal mode", "$\\sqrt{2 k_n/m}$", pair(false, 0.0), std::sqrt(2.0 * k), findings, table);
    // The normal force pushes discs off their line of centres once they have left it: this lowers w^2 by 2 N/d times
    // the third of the motion that is displacement of the discs.
    const double across = std::sqrt(0.5 * k * 2.0 * turning - 2.0 * k * depth / (2.0 - depth) / turning);
    check_system("pair, tangential mode", "$\\sqrt{6 k_t/m}$", pair(true, 0.5 * k), across, findings, table);
    for (const int n : {3, 8}) {
      check_system(fmt::format("{} discs between walls", n), "$2\\sqrt{k/m}\\,\\sin\\frac{n\\pi}{2(n+1)}$", row(n),
                   2.0 * std::sqrt(k) * std::sin(n * std::numbers::pi / (2.0 * (n + 1))), findings, table);
    }
  }
  check_fence_limit(findings, setup, table);
  if (!setup.coarse) findings.table(table);
}

}  // namespace talus::verification::problems
