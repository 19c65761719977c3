#include "verification/reference/impacts/restitution.hpp"
#include "verification/study/toolkit.hpp"

namespace talus::verification::problems::constrained_bodies {
namespace {

constexpr Vec2 gravity{0.8, -2.0};
constexpr double end = 1.5;

/// Number of blocks in the scene: one that represents two (`half`), or two.
enum class Bodies { half, both };

std::string name_of_mobility(Mobility mobility) { return std::string{name_of(mobility)}; }

/// A disc thrown at an oblique block, off its centre, both pulled by cables off their centres: every kind of load on a
/// block of the given mobility. `half`: the block represents two; `both`: there are two at the same position.
Scene scene_of(Mobility mobility, Bodies bodies, const Setup& setup) {
  SceneBuilder builder;
  builder.gravity(gravity);
  const BodyId disc = builder.add(Body{.name = "disc",
                                       .mass = 1.3,
                                       .inertia = 0.09,
                                       .shape = Circle{0.4},
                                       .p_WB = {1.6, 1.5},
                                       .angle = 0.2,
                                       .force = {-0.4, 0.3},
                                       .moment = 0.15});
  const int multiplicity = bodies == Bodies::half ? 2 : 1;
  std::vector<BodyId> blocks;
  for (const char* const name : {"block", "other"}) {
    Body block{.name = name, .mobility = mobility, .mass = 1.7, .inertia = 0.45, .shape = Rectangle{0.7, 0.35}};
    block.p_WB = {0.5, 0.6}, block.angle = 0.35, block.p_BPin = {0.3, -0.2}, block.multiplicity = multiplicity;
    if (mobility != Mobility::fixed) block.force = {0.6, 0.9};
    if (turns(mobility)) block.moment = -0.25;
    blocks.push_back(builder.add(block));
    const std::string stem = name;
    Contact touch{.name = stem + "_touch",
                  .a = disc,
                  .b = blocks.back(),
                  .law = LinearSpringDashpot{400.0, 6.0, EndRule::clamped},
                  .multiplicity = multiplicity};
    touch.friction = CoulombFriction{0.3, 250.0, 2.0};
    builder.add(std::move(touch));
    builder.add(Cable{.name = stem + "_tie",
                      .a = {disc, {0.1, 0.25}},
                      .b = {blocks.back(), {-0.5, 0.2}},
                      .rest_length = 1.2,
                      .law = ElasticPlastic{.stiffness = 20.0, .yield = 3.0, .hardening = 4.0},
                      .multiplicity = multiplicity});
    if (mobility != Mobility::fixed) {
      builder.add(Cable{.name = stem + "_stay",
                        .a = {{}, {-1.4, 2.1}},
                        .b = {blocks.back(), {-0.6, -0.3}},
                        .rest_length = 1.1,
                        .law = TensionOnly{8.0, 0.7},
                        .multiplicity = multiplicity});
    }
    if (bodies == Bodies::half) break;
  }
  Scene scene = builder.at_rest("Held bodies");
  set_velocity(scene.model, scene.initial, disc, {-1.1, -1.6}, 3.0);
  for (const BodyId block : blocks) {
    set_velocity(scene.model, scene.initial, block, {has_x(mobility) ? 0.4 : 0.0, has_y(mobility) ? 0.3 : 0.0},
                 turns(mobility) ? 1.2 : 0.0);
  }
  if (setup.has("heavier_copy") && bodies == Bodies::both) scene.model.bodies.back().mass *= 1.0 + 1e-9;
  return scene;
}

/// Energy and momenta of a state, summed here from masses and poses.
struct Sums {
  double kinetic{}, gravity{}, applied{};
  Vec2 momentum;
  double angular{};
};

Sums sums_of(const Model& model, const State& state) {
  Sums sums;
  for (std::size_t i = 0; i < model.bodies.size(); ++i) {
    const Body& body = model.bodies[i];
    if (body.mobility == Mobility::fixed) continue;
    const auto id = static_cast<BodyId>(i);
    const Pose now = pose(model, state, id);
    const double multiplicity = body.multiplicity, spin = turns(body.mobility) ? body.inertia * now.w_WB : 0.0;
    sums.kinetic += 0.5 * multiplicity * (body.mass * dot(now.v_WB, now.v_WB) + spin * now.w_WB);
    sums.gravity -= multiplicity * body.mass * dot(model.gravity, now.p_WB);
    sums.applied -=
        multiplicity * (dot(body.force, now.p_WB - body.p_WB) + body.moment * (angle(model, state, id) - body.angle));
    sums.momentum += multiplicity * body.mass * now.v_WB;
    sums.angular += multiplicity * (body.mass * cross(now.p_WB, now.v_WB) + spin);
  }
  return sums;
}

/// Largest errors of a run's balances, relative to the scale of their terms, and largest difference of the reported
/// quantities of bodies from the sums computed here, relative to the same scales.
struct Missed {
  double energy{}, momentum{}, angular{};
  struct Reported {
    double kinetic{}, potential{}, momenta{}, balances{};
  } reported;
};

Missed missed_by(Mobility mobility, Findings& findings, const Setup& setup) {
  const Scene scene = scene_of(mobility, Bodies::half, setup);
  const State start = first_state(scene);
  RunLedger ledger{scene.model, start};
  const Sums first = sums_of(scene.model, start);
  const Accounts before = ledger(start);
  const double impulse = norm(first.momentum) + 3.0 * end * norm(gravity), arm = norm(Vec2{1.6, 2.1});
  Missed missed;
  constexpr double interval = 0.05;
  long states = 0;
  const Watcher watch = [&](const State& seen, const StepInfo&) {
    ++states;
    State state = seen;
    if (setup.has("reaction_not_recorded")) state.impulse[2] *= 1.0 - 1e-6;
    if (setup.has("loss_not_recorded")) state.work[static_cast<std::size_t>(Mechanism::friction)] *= 1.0 - 1e-6;
    const Sums now = sums_of(scene.model, state);
    const Accounts accounts = ledger(state);
    const Energies& energies = accounts.energies;
    const double stored = energies.contacts + energies.cables - (before.energies.contacts + before.energies.cables);
    const double bodies = now.kinetic + now.gravity + now.applied - (first.kinetic + first.gravity + first.applied);
    keep_worst(missed.energy, (bodies + stored + accounts.total_dissipated()) / first.kinetic);
    const Vec2 momentum = now.momentum - first.momentum - Vec2{state.impulse[0], state.impulse[1]};
    keep_worst(missed.momentum, norm(momentum) / impulse);
    keep_worst(missed.angular, (now.angular - first.angular - state.impulse[2]) / (arm * impulse));
    keep_worst(missed.reported.kinetic, (energies.kinetic - now.kinetic) / first.kinetic);
    keep_worst(missed.reported.potential, (energies.gravity - now.gravity) / first.kinetic);
    keep_worst(missed.reported.potential, (energies.applied - now.applied) / first.kinetic);
    keep_worst(missed.reported.momenta, norm(accounts.momenta.linear - now.momentum) / impulse);
    keep_worst(missed.reported.momenta, (accounts.momenta.angular - now.angular) / (arm * impulse));
    for (const double off :
         {(accounts.energy_balance_error - (bodies + stored + accounts.total_dissipated())) / first.kinetic,
          norm(accounts.momentum_balance_error - momentum) / impulse,
          (accounts.angular_momentum_balance_error - (now.angular - first.angular - state.impulse[2])) /
              (arm * impulse)})
      keep_worst(missed.reported.balances, off);
  };
  const RunEnd run =
      run_scene(scene, make_integrator("stormer_cowell", 1e-13), {interval, end, end, true}, findings, watch);
  if (!run.finished || states != std::lround(end / interval) + 1) missed.energy = std::nan("");
  return missed;
}

/// Checks the three balances for a block of the given mobility that represents two.
void check_balances(Mobility mobility, Missed& worst, Findings& findings, const Setup& setup) {
  const Missed missed = missed_by(mobility, findings, setup);
  const std::string name = name_of_mobility(mobility);
  findings.expect_truncation({"energy_balance", "energy balance, " + name}, missed.energy, 0.0, 1e-12, 1.0,
                             "local errors of the motion below 1e-13, some ten of which add up; an omitted term would "
                             "be of the order 1e-2 to 1");
  const bool held = mobility != Mobility::free && mobility != Mobility::particle;
  const Tolerance closes =
      held ? Tolerance::round_off(
                 2e-13, "the reaction of a pin or guide follows from the accelerations, which are accurate to 1e-13")
           : Tolerance::round_off(1.5e-14,
                                  "momenta and impulses are the same sums over two thousand steps, each rounded to "
                                  "1.1e-16: 5e-15 as a random walk, three times that");
  findings.expect({"momentum_balance", "momentum balance with reactions, " + name}, missed.momentum, 0.0, closes);
  findings.expect(
      {"angular_momentum_balance", "angular momentum balance with reactions, " + name}, missed.angular, 0.0,
      mobility == Mobility::fixed
          ? Tolerance::truncation(6e-9, 2.0,
                                  "measured: the moment of the contact about the origin is integrated with the steps "
                                  "of the motion, without error control; 3e-7 at a tolerance of 1e-11")
          : closes);
  using Reported = Missed::Reported;
  for (double Reported::*const kind :
       {&Reported::kinetic, &Reported::potential, &Reported::momenta, &Reported::balances})
    keep_worst(worst.reported.*kind, missed.reported.*kind);
}

/// Checks that the scene with one block that represents two agrees with the scene with both, in the motion and in all
/// recorded quantities.
void check_half(Mobility mobility, Findings& findings, const Setup& setup) {
  const auto end_of = [&](Bodies bodies, Accounts& accounts) {
    const Scene scene = scene_of(mobility, bodies, setup);
    RunLedger ledger{scene.model, first_state(scene)};
    const RunEnd run = run_scene(scene, VelocityVerlet{}, {1e-3, end, end, true}, findings);
    accounts = ledger(run.state);
    return run.state;
  };
  Accounts of_half, of_both;
  const State half = end_of(Bodies::half, of_half), both = end_of(Bodies::both, of_both);
  double motion = 0.0, energies = 0.0, impulses = 0.0;
  for (std::size_t i = 0; i < half.q.size(); ++i)
    keep_worst(motion, half.q[i] - both.q[i]), keep_worst(motion, half.v[i] - both.v[i]);
  const auto energy = [&](double Energies::*part) {
    keep_worst(energies, of_half.energies.*part - of_both.energies.*part);
  };
  for (const auto part :
       {&Energies::kinetic, &Energies::gravity, &Energies::applied, &Energies::contacts, &Energies::cables})
    energy(part);
  for (std::size_t i = 0; i < mechanism_count; ++i)
    keep_worst(energies, of_half.dissipated[i] - of_both.dissipated[i]);
  for (std::size_t i = 0; i < 3; ++i)
    keep_worst(impulses, half.impulse[i] - both.impulse[i]);
  keep_worst(impulses, norm(of_half.momenta.linear - of_both.momenta.linear));
  keep_worst(impulses, of_half.momenta.angular - of_both.momenta.angular);
  const std::string name = name_of_mobility(mobility);
  const auto same = [](double fraction) {
    return Tolerance::round_off(fraction,
                                "F + F instead of 2 F: a rounding of 1e-16 in each of 1500 steps, of forces up to 40, "
                                "which an impact amplifies by less than 10");
  };
  findings.expect({"half_motion", "difference of positions and velocities, half and full model, " + name}, motion, 0.0,
                  same(1e-12));
  findings.expect({"half_energies", "difference of energies and losses, half and full model, " + name}, energies, 0.0,
                  same(1e-12));
  findings.expect({"half_impulses", "difference of impulses and momenta, half and full model, " + name}, impulses, 0.0,
                  same(1e-12));
}

/// Checks initial poses against those given, and their velocities against difference quotients.
void check_velocities(const std::vector<Mobility>& mobilities, Findings& findings, const Setup& setup) {
  constexpr double h = 1e-5;
  double worst = 0.0, rest = 0.0;
  for (const Mobility mobility : mobilities) {
    const Scene scene = scene_of(mobility, Bodies::half, setup);
    const auto moved = [&](double by) {
      State state = scene.initial;
      for (std::size_t i = 0; i < state.q.size(); ++i)
        state.q[i] += by * state.v[i];
      return pose(scene.model, state, BodyId{1});
    };
    const Pose before = moved(-h), now = moved(0.0), after = moved(h);
    keep_worst(worst, norm((0.5 / h) * (after.p_WB - before.p_WB) - now.v_WB));
    // The poses at which forces are evaluated and which observers receive.
    const Dynamics dynamics{scene.model};
    const Snapshot seen{dynamics, scene.initial};
    for (const Pose& at : {now, seen.geometry().poses[1]})
      keep_worst(rest, norm(at.p_WB - scene.model.bodies[1].p_WB));
    keep_worst(worst, norm(seen.geometry().poses[1].v_WB - now.v_WB));
    const Rotation turn = before.R_WB;
    const double by = std::asin(turn.cosine * after.R_WB.sine - turn.sine * after.R_WB.cosine);
    keep_worst(worst, 0.5 * by / h - now.w_WB);
  }
  findings.expect_round_off("initial positions of poses, largest difference from the given ones", rest, 0.0, 1e-15,
                            "conversion from the centre to the pin and back: four roundings");
  findings.expect_truncation(
      "velocities of poses, largest difference from difference quotients over all mobilities", worst, 0.0, 2e-11, 2.0,
      "h^2/6 times a third derivative of 1, and the rounding of a position divided by 2 h: 1e-16/2e-5");
}

/// Checks the impact of a disc on a slide on one that represents two, with a dashpot given by its damping ratio: both
/// speeds are known.
void check_mirrored_impact(Findings& findings, const Setup& setup) {
  constexpr double e = 0.6, m = 1.0, each = 0.75, speed = 2.0;
  SceneBuilder builder;
  builder.gravity(gravity);
  Body disc{.name = "disc", .mobility = Mobility::sliding_x, .mass = m, .shape = Circle{0.5}, .p_WB = {-1.25, 0.0}};
  const BodyId striker = builder.add(disc);
  disc.name = "pair", disc.mass = each, disc.p_WB = {}, disc.multiplicity = 2;
  const BodyId pair = builder.add(disc);
  LinearSpringDashpot law{300.0, 0.0, EndRule::clamped};
  law.set_every_restitution(setup.has("other_restitution") ? 0.999 * e : e, 1.0);
  builder.add(Contact{.name = "touch", .a = striker, .b = pair, .law = law, .multiplicity = 2});
  Scene scene = builder.at_rest("Impact on a mirrored disc");
  set_velocity(scene.model, scene.initial, striker, {speed, 0.0}, 0.0);
  const double common = m * speed / (m + 2.0 * each) + gravity.x;  // at the end, after a unit of time
  for (const char* const name : {"exact", "stormer_cowell"}) {
    const bool closed = std::string_view{name} == "exact";
    const RunEnd run = run_scene(scene, closed ? make_integrator(name) : make_integrator(name, 1e-12),
                                 {0.1, 1.0, 1.0, true}, findings);
    const std::vector<double> exact{common - 2.0 * each / (m + 2.0 * each) * e * speed,
                                    common + m / (m + 2.0 * each) * e * speed};
    expect_each(findings.in("mirrored_impact"),
                fmt::format("speeds after an impact on a disc that represents two, {}", name), run.state.v, exact,
                closed ? Tolerance::round_off(1.5e-14,
                                              "three roundings in each of some twenty steps, and at the events, of "
                                              "speeds below 2 m/s: 60 times 2.2e-16 if all have the same sign")
                       : Tolerance::truncation(1e-12 * speed, 3.0,
                                               "local errors below 1e-12 of the speed, a few of which add up"));
    const std::vector<double> impulses{(m + 2.0 * each) * gravity.x, 0.0, 0.0};
    expect_each(findings.in("mirrored_impulses"),
                fmt::format("external impulses in the run with a disc that represents two, {}", name),
                {run.state.impulse.begin(), run.state.impulse.end()}, impulses,
                Tolerance::round_off(
                    1e-13, "a constant force over twenty steps; across the slide, weight and reaction cancel"));
  }
}

/// Checks the impact of a disc on the side of a box, at an angle to the box's slide: the impulse is (1 + e) u m_e with
/// 1/m_e = 1/m + n_s^2/M, n_s the component of the normal along the slide.
void check_slides(Findings& findings) {
  constexpr double e = 0.6, m = 1.0, other = 1.75, angle = 0.6;
  const Vec2 n{std::cos(angle), std::sin(angle)}, across{-n.y, n.x}, thrown = 2.0 * n + 0.5 * across;
  for (const Mobility mobility : {Mobility::sliding_x, Mobility::sliding_y}) {
    SceneBuilder builder;
    const BodyId disc = builder.add(
        Body{.name = "disc", .mobility = Mobility::particle, .mass = m, .shape = Circle{0.5}, .p_WB = -2.0 * n});
    const BodyId box = builder.add(
        Body{.name = "box", .mobility = mobility, .mass = other, .shape = Rectangle{0.6, 4.0}, .angle = angle});
    LinearSpringDashpot law{300.0, 0.0, EndRule::clamped};
    law.set_every_restitution(e, 1.0);
    builder.add_contact("touch", disc, box, law);
    Scene scene = builder.at_rest("Impact on a slide");
    set_velocity(scene.model, scene.initial, disc, thrown, 0.0);
    const RunEnd run = run_scene(scene, make_integrator("stormer_cowell", 1e-12), {0.1, 1.5, 1.5, false}, findings);
    const double along = mobility == Mobility::sliding_x ? n.x : n.y;
    const double impulse = (1.0 + e) * dot(thrown, n) / (1.0 / m + along * along / other);
    const Vec2 after = thrown - impulse / m * n;
    expect_each(
        findings, "speeds after an impact oblique to a slide, " + name_of_mobility(mobility), run.state.v,
        {after.x, after.y, impulse * along / other},
        Tolerance::truncation(1e-12 * 2.0, 3.0, "local errors below 1e-12 of the speed, a few of which add up"));
  }
}

/// Checks simultaneous impacts of equal discs from all sides on a disc at rest. It acts like a wall, because their
/// impulses on it cancel. The discs touch from the start, so that all impacts begin in one evaluation.
void check_ring(Findings& findings) {
  constexpr double e = 0.6, m = 1.0, middle = 0.5, speed = 2.0, overlap = 1e-10;
  for (const int count : {2, 12}) {
    SceneBuilder builder;
    const BodyId struck = builder.add_particle("middle", middle, {}, Circle{3.0});
    LinearSpringDashpot law{300.0, 0.0, EndRule::clamped};
    law.set_every_restitution(e, 1.0);
    std::vector<BodyId> ring;
    std::vector<Vec2> out;
    for (int i = 0; i < count; ++i) {
      const double angle = 2.0 * std::numbers::pi * i / count;
      out.push_back({std::cos(angle), std::sin(angle)});
      ring.push_back(builder.add_particle(fmt::format("disc{}", i), m, (3.5 - overlap) * out.back(), Circle{0.5}));
      const bool first = i % 2 == 0;
      builder.add_contact(fmt::format("touch{}", i), first ? ring.back() : struck, first ? struck : ring.back(), law);
    }
    Scene scene = builder.at_rest("Discs from all around");
    for (std::size_t i = 0; i < ring.size(); ++i)
      set_velocity(scene.model, scene.initial, ring[i], -speed * out[i], 0.0);
    const RunEnd run = run_scene(scene, make_integrator("stormer_cowell", 1e-12), {0.1, 1.0, 1.0, false}, findings);
    std::vector<double> exact{0.0, 0.0};
    for (const Vec2 direction : out)
      exact.insert(exact.end(), {e * speed * direction.x, e * speed * direction.y});
    expect_each(
        findings, fmt::format("speeds after {} simultaneous impacts on one disc", count), run.state.v, exact,
        Tolerance::model(2e-9,
                         "the initial overlap of 1e-10: the dashpot, c = 5.6, takes 5.6e-10 less from the speed, and "
                         "the spring sqrt(k/m) = 17 times 1e-10 more, of which less than that remains at the end"));
  }
}

void run(Findings& findings, const Setup& setup) {
  std::vector<Mobility> mobilities;
  for (std::size_t i = 0; i < Names<Mobility>::list.size(); ++i)
    mobilities.push_back(static_cast<Mobility>(i));
  Missed worst;
  if (setup.needs("balance") || setup.needs("reported")) {
    for (const Mobility mobility : mobilities)
      check_balances(mobility, worst, findings, setup);
    // A check for each kind: its name says which one is wrong.
    const auto& [kinetic, potential, momenta, balances] = worst.reported;
    for (const auto& [kind, off] : {std::pair{"kinetic energy", kinetic},
                                    {"energies of gravity and applied forces", potential},
                                    {"linear and angular momenta", momenta},
                                    {"balance errors", balances}}) {
      findings.expect_round_off(fmt::format("reported {}, largest difference from sums over all poses", kind), off, 0.0,
                                5e-15,
                                "a dozen products for each of two bodies and as many sums, each about as large as the "
                                "scale and rounded by 1.1e-16 of it: 5e-15 if all errors have the same sign");
    }
  }
  if (setup.needs("half and full model")) {
    for (const Mobility mobility : mobilities)
      check_half(mobility, findings, setup);
  }
  if (setup.needs("of poses, largest difference")) check_velocities(mobilities, findings, setup);
  if (setup.needs("a disc that represents two")) check_mirrored_impact(findings, setup);
  if (setup.needs("a slide")) check_slides(findings);
  if (setup.needs("simultaneous impacts")) check_ring(findings);
}

}  // namespace

Case definition() {
  const std::string guided = "angular momentum balance with reactions, guided_x";
  return {.id = "constrained_bodies",
          .title = "Constrained bodies and symmetry multiplicity",
          .family = "A: motion and bodies",
          .requirements =
              {{"law.elastic_plastic, law.tension_only", {"energy_balance", "half_energies"}},
               {"Eq. 18", {"energy_balance", "angular_momentum_balance"}},
               {"mechanism.friction, mechanism.cable_yield, mechanism.contact_damping, mechanism.contact_release",
                {"energy_balance", "half_energies"}},
               {"integrator.exact", {"speeds after an impact on a disc that represents two, exact"}}},
          .main_checks = {"energy balance, guided_x", guided, "angular momentum balance with reactions, sliding_x",
                          "difference of energies and losses, half and full model, pinned",
                          "speeds after an impact on a disc that represents two, exact"},
          .source = "Textbook mechanics; Mustoe & Huttelmaier 1993, section 3.1",
          .faults = {{"reaction_not_recorded", "a millionth of the angular impulse is not recorded", guided},
                     {"loss_not_recorded", "a millionth of the work of friction is not recorded",
                      "energy balance, sliding_x"},
                     {"heavier_copy", "one of two identical bodies is heavier by 1e-9",
                      "difference of positions and velocities, half and full model, free"},
                     {"other_restitution", "the restitution is too small by a thousandth",
                      "speeds after an impact on a disc that represents two, exact"}},
          .run = run};
}

}  // namespace talus::verification::problems::constrained_bodies
