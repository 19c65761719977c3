#include <tuple>

#include "verification/study/scenes/scaled_scene.hpp"
#include "verification/study/scenes/scenes_in_motion.hpp"
#include "verification/study/toolkit.hpp"

namespace talus::verification::problems::unit_scaling {
namespace {

constexpr UnitScale all_units{0x1p43, 0x1p-31, 0x1p-17};

/// Results of a run that the case compares: final state, energies, momenta and balance errors, in the original units.
struct UnitRun {
  State end;
  std::array<double, 9> accounts{};
};

struct UnitPlan {
  double step{}, end{};
};

UnitRun run_in_units(const Scene& scene, const Integrator& method, UnitPlan plan, const UnitScale& scale,
                     const Setup& setup, Findings& findings) {
  Model given = scaled(scene.model, scale);
  if (setup.has("gravity_overlooked")) given.gravity = scene.model.gravity;
  if (setup.has("strength_overlooked") && !given.hangers.empty())
    given.hangers[0].strength = scene.model.hangers[0].strength;
  if (setup.has("slip_stiffness_overlooked"))
    std::get<CoulombFriction>(*given.contacts[0].friction).stiffness *= scale.length / scale.mass;
  Scene other{.model = given, .initial = scaled(scene.model, scene.initial, scale)};
  RunLedger ledger{given, first_state(other)};
  const double end = plan.end * scale.time;
  const State state = run_scene(other, method, {plan.step * scale.time, end, end, true}, findings).state;
  const Accounts sums = ledger(state);
  UnitRun run{scaled(scene.model, state, scale.inverse()),
              {sums.energies.kinetic, sums.energies.gravity, sums.energies.contacts, sums.energies.cables,
               sums.energy_balance_error, sums.momenta.linear.x, sums.momenta.linear.y, sums.momenta.angular,
               sums.angular_momentum_balance_error}};
  const UnitScale back = scale.inverse();
  for (std::size_t i = 0; i < run.accounts.size(); ++i)
    run.accounts[i] *= back.of(i < 5 ? dimension::energy : i < 7 ? dimension::momentum : dimension::angular_momentum);
  return run;
}

int differing(const UnitRun& one, const UnitRun& other) {
  int count = differing_numbers(one.end, other.end);
  for (std::size_t i = 0; i < one.accounts.size(); ++i)
    count += one.accounts[i] == other.accounts[i] ? 0 : 1;
  return count;
}

const char* const same_bits = "powers of two change no digit: the same operations on the same digits";

/// Comparison of a scene in its original units with the same scene in other units.
class Units {
 public:
  Units(Findings& findings, const Setup& setup, std::string name, const Scene& scene, const Integrator& method,
        UnitPlan plan)
      : findings_{&findings}, setup_{&setup}, name_{std::move(name)}, scene_{&scene}, method_{method}, plan_{plan} {
    own_ = run_in_units(scene, method, plan, {}, Setup{}, findings);
  }
  void check(const std::string& how, UnitScale scale) const {
    if (setup_->has("units_of_three")) scale = {3.0, 1.0, 1.0};
    const UnitRun other = run_in_units(*scene_, method_, plan_, scale, *setup_, *findings_);
    const std::string claim = fmt::format("integrator.{}", name(method_));
    findings_->in(name_)
        ->in("numbers_that_differ")
        ->in(claim)
        ->expect_exact(fmt::format("numbers that differ, {}, {}, {}", name_, name(method_), how),
                       differing(own_, other), 0.0, same_bits);
  }
  const UnitRun& own() const { return own_; }

 private:
  Findings* findings_;
  const Setup* setup_;
  std::string name_;
  const Scene* scene_;
  Integrator method_;
  UnitPlan plan_;
  UnitRun own_;
};

/// Draws how many numbers differ with masses, lengths or times multiplied by 2^exponent, until the format's range ends.
void draw_range(Findings& findings, const Scene& scene) {
  Figure figure{.name = "range",
                .title = "Range of units with bit-identical results",
                .caption =
                    "Numbers of the yard's state after 0.15 s that differ in any bit, against the unit: the range of "
                    "doubles ends where squares and energies fall below $2^{-1074}$ or exceed $2^{1024}$.",
                .x = {.label = "log2 of the new unit"},
                .y = {.label = "numbers that differ"}};
  const UnitPlan plan{1e-3, 0.15};
  const UnitRun one = run_in_units(scene, VelocityVerlet{}, plan, {}, Setup{}, findings);
  int widest = 0;
  for (const char unit : {'M', 'L', 'T'}) {
    Series series{fmt::format("unit of {}", unit == 'M'   ? "mass"
                                            : unit == 'L' ? "length"
                                                          : "time"),
                  {},
                  {},
                  Style::linespoints};
    int reach = 0;
    for (int exponent = -600; exponent <= 600; exponent += 50) {
      const double value = std::ldexp(1.0, exponent);
      const UnitScale scale{unit == 'M' ? value : 1.0, unit == 'L' ? value : 1.0, unit == 'T' ? value : 1.0};
      const int count = differing(one, run_in_units(scene, VelocityVerlet{}, plan, scale, Setup{}, findings));
      series.add(exponent, count);
      if (count == 0 && exponent > reach) reach = exponent;
    }
    widest = widest == 0 ? reach : std::min(widest, reach);
    figure.series.push_back(series);
  }
  findings.figure(figure);
  findings.expect_between(
      "log2 of the largest unit that changes no bit, smallest of mass, length and time", widest, 200.0, 600.0,
      "energies contain the square of a length: half of the format's 1023 powers, less a few tens for the numbers "
      "themselves and for intermediate products; a quarter where a square is squared");
}

/// Tabulates the effect of units on odeint's steppers with step control. They compare errors with a pure number, so
/// that their steps depend on the units.
void tabulate_step_control(Findings& findings, const Scene& scene) {
  Table table{.name = "step_control",
              .caption =
                  "Largest change of a coordinate of the yard at 0.1 s, relative to the largest coordinate, when the "
                  "unit of length is changed, for odeint's steppers with tolerance 1e-8: the tolerance is absolute as "
                  "well as relative, and therefore has a unit.",
              .columns = {"method", "unit of length 1/1024", "unit of length 1024"}};
  double smallest = std::numeric_limits<double>::infinity(), largest_of_all = 0.0;
  for (const char* name : {"odeint_dopri5", "odeint_bulirsch_stoer"}) {
    const Integrator method = make_integrator(name, 1e-8);
    const UnitPlan plan{2e-3, 0.1};
    const UnitRun one = run_in_units(scene, method, plan, {}, Setup{}, findings);
    std::vector<std::string> row{name};
    for (const double unit : {0x1p10, 0x1p-10}) {
      const UnitRun other = run_in_units(scene, method, plan, {1.0, unit, 1.0}, Setup{}, findings);
      double change = 0.0, largest = 0.0;
      for (std::size_t i = 0; i < one.end.q.size(); ++i) {
        keep_largest(change, one.end.q[i] - other.end.q[i]);
        keep_largest(largest, one.end.q[i]);
      }
      row.push_back(fmt::format("{:.1e}", change / largest));
      keep_smallest(smallest, change / largest), keep_largest(largest_of_all, change / largest);
    }
    table.rows.push_back(row);
  }
  findings.table(table);
  const auto group = findings.in("step_control");
  const char* const why =
      "the tolerance, 1e-8, is relative and absolute: a unit of length 1024 times as long or short changes "
      "the absolute part, and with it all steps; results then differ by about the tolerance, not by roundings";
  group->expect_between("change of a coordinate with the unit of length, odeint's step control, smallest of four runs",
                        smallest, 1e-10, 1e-6, why);
  group->expect_between("change of a coordinate with the unit of length, odeint's step control, largest of four runs",
                        largest_of_all, 1e-10, 1e-6, why);
}

/// Number of values that differ between a fence built from a deck in its original units and in other units.
int differing_fences(const scenes::Fence& fence, const Setup& setup) {
  const scenes::FenceScene made = scenes::fence_scene(fence);
  scenes::Fence given = scaled(fence, all_units);
  if (setup.has("sag_overlooked")) given.sag *= 1.0 + 0x1p-40;
  const scenes::FenceScene other = scenes::fence_scene(given);
  const UnitScale back = all_units.inverse();
  return differing_numbers(scaled(other.scene.model, back), made.scene.model) +
         differing_numbers(scaled(made.scene.model, other.scene.initial, back), made.scene.initial) +
         (other.critical_step == made.critical_step * all_units.time ? 0 : 1) +
         (other.horizontal_tension == made.horizontal_tension * all_units.of(dimension::force) ? 0 : 1);
}

void check_decks(Findings& findings, const Setup& setup) {
  const char* const why =
      "static shape, stiffnesses and dashpots follow from the deck by sums, products and roots of numbers whose units "
      "are squares; the tolerance of the static equilibrium is relative to the forces";
  scenes::Fence fence = rough_fence();
  const auto fences = findings.in("fence"), numbers = findings.in("numbers_that_differ");
  findings.expect_exact({"other_units", "numbers that differ, fence built from a deck in other units"},
                        differing_fences(fence, setup), 0.0, why);
  fence.options.symmetry = scenes::FenceSymmetry::full;
  fence.stretched_cables = {{"top1", 0.03}, {"top-2", 0.02}, {"bottom1", 0.1}};
  findings.expect_exact("numbers that differ, fence after a first impact built from a deck in other units",
                        differing_fences(fence, setup), 0.0, why);
}

void check_fence(Findings& findings, const Setup& setup) {
  const scenes::FenceScene made = scenes::fence_scene(rough_fence());
  const UnitPlan plan{2e-5, 0.04};
  for (const char* name : {"velocity_verlet", "lagged_central_difference"}) {
    const Units fence{findings, setup, "fence", made.scene, make_integrator(name), plan};
    fence.check("all units", all_units);
    if (std::string{name} != "velocity_verlet") continue;
    findings.expect_exact({"fence", "number of active loss mechanisms, fence"}, mechanisms_at_work(fence.own().end),
                          5.0, "contact damping and release, cable yield, breaking of a hanger, friction");
  }
}

/// Checks two discs that fall from rest on posts of the same size. The step that weight alone allows is shorter for the
/// second disc, which is smaller.
void check_falls(Findings& findings, const Setup& setup) {
  SceneBuilder builder{si};
  builder.gravity({0.0, -0.5});
  for (const auto& [name, radius, x] : {std::tuple{"1", 1.0, 0.0}, std::tuple{"2", 0.4, 10.0}}) {
    const BodyId falling = builder.add_particle(fmt::format("disc{}", name), 1.0, {x, 20.0}, Circle{radius});
    const BodyId post = builder.add_fixed(fmt::format("post{}", name), Circle{radius}, {x, 0.0});
    builder.add(
        Contact{.name = fmt::format("hit{}", name), .a = falling, .b = post, .law = LinearSpringDashpot{1e4, 0.0}});
  }
  Scene scene = builder.at_rest("Falls");
  const Units falls{findings, setup, "falls", scene, make_integrator("stormer_cowell", 1e-8), {10.0, 10.0}};
  falls.check("short unit of time", {1.0, 1.0, 0x1p20});
}

void run(Findings& findings, const Setup& setup) {
  const Scene yard = mixed_pile();
  const Units verlet{findings, setup, "yard", yard, VelocityVerlet{}, {1e-3, setup.coarse ? 1.0 : 1.5}};
  verlet.check("all units", all_units);
  check_decks(findings, setup);
  if (setup.coarse) return;
  findings.expect_exact({"yard", "number of active loss mechanisms, yard"}, mechanisms_at_work(verlet.own().end), 8.0,
                        "the scene must use every loss mechanism");
  verlet.check("unit of mass", {0x1p-11, 1.0, 1.0});
  verlet.check("unit of length", {1.0, 0x1p7, 1.0});
  verlet.check("unit of time", {1.0, 1.0, 0x1p-5});
  for (const std::string& name : integrator_names()) {
    // The tolerance of odeint's method has a unit: see tabulate_step_control.
    if (name == "velocity_verlet" || name == "odeint_bulirsch_stoer") continue;
    const Integrator method = make_integrator(name, needs_tolerance(name) ? 1e-8 : 0.0);
    const Units units{findings, setup, "yard", yard, method, {1e-3, 0.5}};
    units.check("all units", all_units);
    // Steps of a thousand units: a time that is missing in a product, or occurs once too often, has a large effect.
    if (integrator_traits(name).locates_events) units.check("short unit of time", {1.0, 1.0, 0x1p20});
  }
  check_falls(findings, setup);
  check_fence(findings, setup);
  draw_range(findings, yard);
  tabulate_step_control(findings, yard);
}

}  // namespace

Case definition() {
  return {.id = "unit_scaling",
          .title = "Unit scaling: one scene in many units",
          .requirements = {{"A7", {"numbers_that_differ", "step_control"}},
                           {"law.linear_spring_dashpot", {"yard", "fence"}},
                           {"law.tension_only", {"yard"}},
                           {"law.elastic_plastic, Eq. 18", {"yard", "fence"}},
                           {"shape.superquadric, shape.rectangle, shape.terrain, method.nodes", {"yard"}},
                           {"method.resultant", {"yard", "fence"}}},
          .main_checks = {"numbers that differ, yard, velocity_verlet, all units", "other_units",
                          "number of active loss mechanisms, yard"},
          .source = "IEEE 754; Chen, Cheung & Yiu 1998 (metamorphic testing)",
          .faults = {{"gravity_overlooked", "gravity is not converted",
                      "numbers that differ, yard, velocity_verlet, all units"},
                     {"strength_overlooked", "the strength of the hanger is not converted",
                      "numbers that differ, yard, velocity_verlet, all units"},
                     {"slip_stiffness_overlooked",
                      "the friction stiffness of one contact is converted with a wrong dimension",
                      "numbers that differ, yard, velocity_verlet, all units"},
                     {"units_of_three", "a unit of three instead of a power of two",
                      "numbers that differ, yard, velocity_verlet, all units"},
                     {"sag_overlooked", "the sag is too large by 1e-12", "other_units"}},
          .run = run};
}

}  // namespace talus::verification::problems::unit_scaling
