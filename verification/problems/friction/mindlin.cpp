#include "solver/laws/mindlin.hpp"

#include "solver/dynamics/springs.hpp"
#include "solver/io/scene/read_scene.hpp"
#include "verification/reference/friction/mindlin_impact.hpp"
#include "verification/study/toolkit.hpp"

namespace talus::verification::problems::mindlin {
namespace {

/// Unit mass, speed and K: lengths, times and forces are those of the reference. R is not 1, so that a lost radius
/// shows.
constexpr double mu = 0.3, radius = 2.5;
const double hertz_modulus = 0.75 / std::sqrt(radius);
/// Radius of the spheres [L]. Half the overlap shortens the arm of friction by d/2r: results are extrapolated from this
/// radius and twice this radius.
constexpr double sphere_radius = 1e4;

Hertz hertz(double dashpot) {
  Hertz law;
  law.modulus = hertz_modulus, law.radius = radius, law.damping = dashpot * std::pow(radius, 0.25);
  return law;
}

Mindlin friction(const reference::MindlinImpact& impact, const Setup& setup) {
  const double modulus = impact.stiffness_ratio / (8.0 * std::sqrt(radius));
  const double dashpot = setup.has("shear_dashpot_lost") ? 0.0 : impact.shear_dashpot * std::pow(radius, 0.25);
  return {setup.has("friction_halved") ? 0.5 * impact.friction : impact.friction,
          setup.has("modulus_halved") ? 0.5 * modulus : modulus, radius, dashpot};
}

/// A body that begins `lead` before it touches a plane.
Scene scene_of(const reference::MindlinImpact& impact, const Setup& setup, double lead = 0.1,
               double r = sphere_radius) {
  const bool rolls = impact.mobility > 1.0;
  SceneBuilder builder;
  const BodyId plane = builder.add_fixed("plane", HalfPlane{});
  const BodyId body = builder.add(Body{.name = "body",
                                       .mobility = rolls ? Mobility::free : Mobility::particle,
                                       .mass = 1.0,
                                       .inertia = rolls ? r * r / (impact.mobility - 1.0) : 0.0,
                                       .shape = Circle{r},
                                       .p_WB = {0.0, r + lead}});
  Contact touch{.name = "impact", .a = body, .b = plane, .law = hertz(impact.dashpot)};
  touch.friction = friction(impact, setup);
  if (setup.has("constant_stiffness")) touch.friction = friction(impact, setup).at(1.0);
  builder.add(touch);
  Scene scene = builder.at_rest();
  set_velocity(scene.model, scene.initial, body, {impact.slip_rate, -1.0}, 0.0);
  return scene;
}

double slip_rate(const State& end, double r = sphere_radius) {
  return end.v[0] + (end.v.size() > 2 ? r * end.v[2] : 0.0);
}

reference::MindlinImpact impact_of(double kappa, double ratio, double mobility, double dashpot) {
  reference::MindlinImpact impact{kappa, mu, mobility, dashpot};
  impact.slip_rate = ratio * reference::first_stick_ratio(impact);
  return impact;
}

// --- impacts --------------------------------------------------------------------------------------------------------

/// Result of an impact of the solver.
struct Impact {
  double slip_rate{};
  double dissipated{};  ///< by friction, less the energy of slip at the beginning and end
  double balance_error{};
};

Impact run_impact(const reference::MindlinImpact& impact, const Setup& setup, double r, Findings& findings) {
  const Scene scene = scene_of(impact, setup, 0.1, r);
  RunLedger ledger{scene.model, scene.initial};
  const double tolerance = impact.mobility > 1.0 ? 1e-10 : 1e-12;
  const RunEnd end = run_scene(scene, make_integrator("stormer_cowell", tolerance),
                               {0.05, 4.0, 1e9, true, MonitorRules::off()}, findings);
  const double u = slip_rate(end.state, r);
  const double slip_energy = 0.5 * (impact.slip_rate * impact.slip_rate - u * u) / impact.mobility;
  return {u, end.state.work[static_cast<std::size_t>(Mechanism::friction)] - slip_energy,
          ledger(end.state).energy_balance_error};
}

/// The same for an arm of friction that the overlap does not shorten.
Impact run_impact(const reference::MindlinImpact& impact, const Setup& setup, Findings& findings) {
  const Impact one = run_impact(impact, setup, sphere_radius, findings);
  if (impact.mobility == 1.0) return one;
  const Impact two = run_impact(impact, setup, 2.0 * sphere_radius, findings);
  return {2.0 * two.slip_rate - one.slip_rate, 2.0 * two.dissipated - one.dissipated,
          std::max(std::abs(one.balance_error), std::abs(two.balance_error))};
}

bool sticks_again(const reference::MindlinRebound& rebound) {
  return std::adjacent_find(rebound.phases.begin(), rebound.phases.end(), [](const auto& first, const auto& second) {
           return first.slips != 0 && second.slips == 0;
         }) != rebound.phases.end();
}

/// Worst errors of a set of impacts.
struct Worst {
  double slip_rate{}, after_stick{}, dissipated{}, balance{};
};

void expect(Findings& findings, const Worst& worst, const std::string& body, double bound, double energy_bound) {
  const std::string why =
      "local errors of the tolerance in some 500 steps; for spheres the square of the overlap over the radius, and "
      "positions rounded to 2e-12";
  findings.expect_truncation({"impacts", "slip rate after oblique impacts, largest error, " + body}, worst.slip_rate,
                             0.0, bound, 1.0, why, "v");
  findings.expect_truncation({"impacts", "slip rate after impacts that stick again, largest error, " + body},
                             worst.after_stick, 0.0, 3e-4, 1.0,
                             "a slider that sticks again is found at the end of a step, not located: an error of the "
                             "square of a step of some 0.02",
                             "v");
  findings.expect_truncation({"energy", "energy dissipated by friction less that of the slip rates, " + body},
                             worst.dissipated, 0.0, energy_bound, 1.0, why, "m v^2");
  findings.expect_truncation({"energy", "energy balance error of oblique impacts, largest, " + body}, worst.balance,
                             0.0, bound, 1.0, why);
}

void check_impacts(Findings& findings, const Setup& setup) {
  Figure figure{.name = "rebound",
                .title = "Rebound of the contact point",
                .caption =
                    "Slip rate after an oblique impact of an undamped sphere against that before, in units of $\\mu "
                    "v$, for three ratios of stiffness. Lines: reference; points: solver.",
                .x = {.label = "slip rate before / (mu v)"},
                .y = {.label = "slip rate after / (mu v)"}};
  const std::vector<double> ratios = setup.coarse ? std::vector{0.5, 1.5} : std::vector{0.1, 0.5, 0.9, 1.5, 3.0, 6.0};
  for (const double mobility : {1.0, 3.5}) {
    Worst worst;
    for (const double dashpot : {0.0, 0.3}) {
      for (const double kappa : {1.0, 1.286, 2.0}) {
        Series points{fmt::format("{:.3g}, solver", kappa), {}, {}, Style::points};
        for (const double ratio : ratios) {
          const reference::MindlinImpact impact = impact_of(kappa, ratio, mobility, dashpot);
          const reference::MindlinRebound exact = reference::rebound(impact);
          const Impact found = run_impact(impact, setup, findings);
          keep_worst(sticks_again(exact) ? worst.after_stick : worst.slip_rate, found.slip_rate - exact.slip_rate);
          keep_worst(worst.dissipated, found.dissipated);
          keep_worst(worst.balance, found.balance_error);
          points.add(impact.slip_rate / mu, found.slip_rate / mu);
        }
        if (mobility == 1.0 || dashpot > 0.0) continue;
        figure.series.push_back(
            curve(fmt::format("k_s/(K sqrt d) = {:.3g}", kappa), multiples(0.1, 1, 100), [&](double before) {
              reference::MindlinImpact of = impact_of(kappa, 1.0, mobility, dashpot);
              of.slip_rate = before * mu;
              return reference::rebound(of).slip_rate / mu;
            }));
        figure.series.push_back(points);
      }
    }
    expect(findings, worst, mobility > 1.0 ? "sphere" : "particle", mobility > 1.0 ? 4e-9 : 4e-11,
           mobility > 1.0 ? 8e-9 : 4e-12);
  }
  if (!setup.coarse) findings.figure(figure);
}

/// A contact that sticks, with a dashpot, and the same impact from a scene's text.
void check_dashpot(Findings& findings, const Setup& setup) {
  reference::MindlinImpact impact = impact_of(1.286, 1.0, 1.0, 0.3);
  impact.friction = 1e3, impact.shear_dashpot = 0.4;
  const Impact found = run_impact(impact, setup, findings);
  const std::string why = "local errors of 1e-12 in some 500 steps";
  findings.expect_truncation({"dashpot", "slip rate after an impact with a tangential dashpot"}, found.slip_rate,
                             reference::rebound(impact).slip_rate, 4e-12, 1.0, why, "v");
  findings.expect_truncation({"dashpot", "energy balance error with a tangential dashpot"}, found.balance_error, 0.0,
                             4e-11, 1.0, why);
  const Scene built = scene_of(impact, setup);
  const Mindlin law = friction(impact, setup);
  const Scene read = read_scene(
      fmt::format(
          "title = \"impact\"\nunits = \"SI\"\n[[body]]\nname = \"plane\"\nmobility = \"fixed\"\nshape = {{ kind = "
          "\"half_plane\" }}\nposition = [\"0 m\", \"0 m\"]\n[[body]]\nname = \"body\"\nmobility = \"particle\"\nmass "
          "= \"1 kg\"\nshape = {{ kind = \"circle\", radius = \"{0:.17g} m\" }}\nposition = [\"0 m\", \"{1:.17g} "
          "m\"]\nvelocity = [\"{2:.17g} m/s\", \"-1 m/s\"]\n[[contact]]\nname = \"impact\"\nbetween = [\"body\", "
          "\"plane\"]\nlaw = \"hertz\"\nmodulus = \"{3:.17g} Pa\"\nradius = \"{4:.17g} m\"\ndamping = \"{5:.17g} N "
          "s/m\"\nfriction = {6:.17g}\nshear_law = \"mindlin\"\nshear_modulus = \"{7:.17g} Pa\"\nshear_damping = "
          "\"{8:.17g} N s/m\"\n[run]\nintegrator = \"rk4\"\nstep = \"1 ms\"\nend = \"4 s\"\n",
          sphere_radius, sphere_radius + 0.1, impact.slip_rate, hertz_modulus, radius, hertz(impact.dashpot).damping,
          law.coefficient, setup.has("scene_modulus") ? 1.1 * law.modulus : law.modulus, law.damping),
      "impact.toml");
  const RunPlan plan{1e-3, 4.0, 4.0, false, MonitorRules::off()};
  const State a = run_scene(built, RungeKutta4{}, plan, findings).state,
              b = run_scene(read, RungeKutta4{}, plan, findings).state;
  findings.expect_exact({"dashpot", "slip rate of the same impact from a scene's text, difference"}, b.v[0] - a.v[0],
                        0.0, "the same model, read from 17 digits", "v");
}

/// A block that lands flat on two corners, each of a contact that represents two: four times the particle. It moves as
/// the particle does.
void check_copies(Findings& findings, const Setup& setup) {
  const reference::MindlinImpact impact = impact_of(1.286, 1.5, 1.0, 0.3);
  SceneBuilder builder;
  const BodyId plane = builder.add_fixed("plane", HalfPlane{});
  const BodyId block =
      builder.add_particle("block", setup.has("contact_forgotten") ? 3.0 : 4.0, {0.0, 1.1}, Rectangle{2.0, 1.0});
  builder.add(Contact{.name = "impact",
                      .a = block,
                      .b = plane,
                      .law = hertz(impact.dashpot),
                      .friction = friction(impact, setup),
                      .multiplicity = 2});
  Scene scene = builder.at_rest();
  set_velocity(scene.model, scene.initial, block, {impact.slip_rate, -1.0}, 0.0);
  RunLedger ledger{scene.model, scene.initial};
  const State end =
      run_scene(scene, make_integrator("stormer_cowell", 1e-12), {0.05, 4.0, 1e9, true, MonitorRules::off()}, findings)
          .state;
  const double u = slip_rate(end), slip_energy = 2.0 * (impact.slip_rate * impact.slip_rate - u * u);
  const Tolerance bound =
      Tolerance::truncation(4e-12, 1.0, "local errors of 1e-12 in some 500 steps, of which most cancel");
  findings.expect({"copies", "slip rate of a block on two corners of two contacts each"}, u,
                  reference::rebound(impact).slip_rate, bound, "v");
  findings.expect({"copies", "energy dissipated by friction of this block over that of its slip rates"},
                  end.work[static_cast<std::size_t>(Mechanism::friction)] / slip_energy, 1.0, bound);
  findings.expect({"copies", "energy balance error of this block"}, ledger(end).energy_balance_error, 0.0, bound);
}

// --- a closed loop of load and slip ---------------------------------------------------------------------------------

/// The law without rescaling: while separating, the force stays though its stiffness falls.
struct Unrescaled {
  talus::Mindlin law;
  double stretch_rate(double stretch, double slip, Kinematics x) const {
    return slip - stretch * x.deformation_rate / (2.0 * x.deformation);
  }
};

constexpr double near_overlap = 0.04, far_overlap = 0.01, loop_slip = 0.001;

/// A path of overlap and slip in `steps` steps, along which the stretch is integrated by the midpoint rule.
template <class Law>
class DrawnContact {
 public:
  DrawnContact(const Law& law, const talus::Mindlin& of) : law_{law}, of_{of} {}
  void move(double overlap, double slip) {
    constexpr int steps = 2000;
    const double d = (overlap - overlap_) / steps, u = (slip - slip_) / steps;
    for (int i = 0; i < steps; ++i) {
      const double before = of_.at(overlap_)(stretch_, pressed), from = stretch_;
      stretch_ += 0.5 * law_.stretch_rate(from, u, {overlap_, d});
      stretch_ = from + law_.stretch_rate(stretch_, u, {overlap_ + 0.5 * d, d});
      overlap_ += d, slip_ += u;
      work_ += 0.5 * (before + of_.at(overlap_)(stretch_, pressed)) * u;
    }
  }
  double work() const { return work_; }

 private:
  static constexpr double pressed = 1e9;
  Law law_;
  talus::Mindlin of_;
  double overlap_{near_overlap}, slip_{}, stretch_{}, work_{};
};

template <class Law>
double loop_work(const Law& law, const talus::Mindlin& of) {
  DrawnContact drawn{law, of};
  drawn.move(near_overlap, loop_slip);
  drawn.move(far_overlap, loop_slip);
  drawn.move(far_overlap, 0.0);
  drawn.move(near_overlap, 0.0);
  return drawn.work();
}

void check_loop(Findings& findings, const Setup& setup) {
  const talus::Mindlin law = friction(impact_of(1.286, 1.0, 1.0, 0.0), setup);
  const double exact = 0.5 * (law.stiffness(near_overlap) - law.stiffness(far_overlap)) * loop_slip * loop_slip;
  const double work = setup.has("not_rescaled") ? loop_work(Unrescaled{law}, law) : loop_work(law, law);
  findings.expect_round_off(
      {"loop", "work of a loop of load, slip, unload, slip back, over (k_1 - k_2) s^2/2"}, work / exact, 1.0, 1e-11,
      "the stretch is constant or changes evenly in each part: the midpoint rule is exact, with 8,000 rounded steps");
  findings.expect_truncation({"loop", "the same without rescaling: the loop creates this energy"},
                             loop_work(Unrescaled{law}, law) / exact, -1.0, 1e-6, 1.0,
                             "the midpoint rule in 2,000 steps, while the overlap falls to a quarter");
}

// --- order and step -------------------------------------------------------------------------------------------------

void check_orders(Findings& findings, const Setup& setup) {
  const reference::MindlinImpact impact = impact_of(1.286, 0.5, 1.0, 0.0);
  const reference::MindlinRebound exact = reference::rebound(impact);
  Figure figure{.name = "orders",
                .title = "Error of the slip rate of fixed steps",
                .caption =
                    "Error of the slip rate after an impact that sticks until shortly before its end, root mean square "
                    "over 64 phases.",
                .x = {.label = "step / contact time", .log = true},
                .y = {.label = "error of the slip rate / v", .log = true},
                .slopes = {{2.0, 1.0 / 64.0, 3e-6, "h^2"}}};
  const auto measure = [&](const std::string& name, double low, double high, const char* why) {
    const Convergence found = convergence(doublings(32.0, setup.coarse ? 3 : 5), [&](double count) {
      const PhaseError error = phase_error(exact.contact_time, count, [&](const Phase& phase) {
        const Scene scene = scene_of(impact, setup, phase.lead());
        return slip_rate(run_scene(scene, make_integrator(name),
                                   {phase.step, 1.3 * exact.contact_time, phase.step, false, MonitorRules::off()},
                                   findings)
                             .state) -
               exact.slip_rate;
      });
      return std::pair{1.0 / count, error.rms()};
    });
    findings.expect_order({"integrator." + name, "order of the slip rate, " + name}, found, low, high, why);
    figure.series.push_back({name, found.steps(), found.errors(), Style::points});
  };
  measure("velocity_verlet", 1.8, 2.3, "second order, and h^(5/2) from the onset and from slip at the end");
  measure("rk4", 1.8, 2.3, "the rate of the stretch has a kink at the largest overlap");
  if (!setup.coarse) findings.figure(figure);
}

void check_step(Findings& findings, const Setup& setup) {
  const reference::MindlinImpact impact = impact_of(1.286, 1.0, 1.0, 0.0);
  const Scene scene = scene_of(impact, setup);
  const Dynamics dynamics{scene.model};
  const double stiffness = springs(dynamics, scene.initial).back().stiffness;
  findings.expect_round_off({"step", "stiffness for step limits over kappa K sqrt(0.1 R)"},
                            stiffness / (1.286 * std::sqrt(0.1 * radius)), 1.0, 1e-14, "a product of five factors");
}

void run(Findings& findings, const Setup& setup) {
  if (setup.needs("impacts") || setup.needs("dissipated")) check_impacts(findings, setup);
  if (setup.needs("dashpot") || setup.needs("scene's text")) check_dashpot(findings, setup);
  if (setup.needs("block")) check_copies(findings, setup);
  if (setup.needs("loop")) check_loop(findings, setup);
  if (setup.needs("order")) check_orders(findings, setup);
  if (setup.needs("step limits")) check_step(findings, setup);
}

}  // namespace

Case definition() {
  const std::string slip = "slip rate after oblique impacts, largest error, sphere",
                    particle = "slip rate after oblique impacts, largest error, particle",
                    loop = "work of a loop of load, slip, unload, slip back, over (k_1 - k_2) s^2/2";
  return {
      .id = "mindlin",
      .title = "Friction with Mindlin's stiffness",
      .family = "C: friction and rotation",
      .requirements = {{"shear_law.mindlin", {"impacts", "energy", "dashpot", "copies", "loop", "step"}},
                       {"law.hertz", {"impacts"}},
                       {"mechanism.friction", {"energy"}},
                       {"integrator.stormer_cowell", {"impacts", "energy"}},
                       {"integrator.velocity_verlet", {"integrator.velocity_verlet"}},
                       {"integrator.rk4", {"integrator.rk4"}}},
      .main_checks = {slip, loop, "order of the slip rate, velocity_verlet"},
      .source = "Mindlin 1949; Thornton, Cummins & Cleary 2011",
      .faults = {{"modulus_halved", "half the shear modulus", slip},
                 {"friction_halved", "half the coefficient of friction", particle},
                 {"constant_stiffness", "a constant stiffness, that at the overlap L", slip},
                 {"shear_dashpot_lost", "no tangential dashpot", "slip rate after an impact with a tangential dashpot"},
                 {"scene_modulus", "a tenth more shear modulus in the scene's text",
                  "slip rate of the same impact from a scene's text, difference"},
                 {"contact_forgotten", "a block with the mass for three contacts",
                  "slip rate of a block on two corners of two contacts each"},
                 {"not_rescaled", "the force stays while its stiffness falls", loop}},
      .seconds = 3.0,
      .run = run};
}

}  // namespace talus::verification::problems::mindlin
