#include <random>
#include <stdexcept>

#include "solver/base/error.hpp"
#include "verification/study/scenes/moved_scene.hpp"
#include "verification/study/scenes/scenes_in_motion.hpp"
#include "verification/study/toolkit.hpp"

namespace talus::verification::problems::frame_invariance {
namespace {

constexpr double step = 2.5e-4;

State run_to(const Scene& scene, const Integrator& method, double end, Findings& findings) {
  return run_scene(scene, method, {step, end, end, true}, findings).state;
}

Scene seen_scene(const Scene& scene, const Viewpoint& view, const Setup& setup) {
  Scene other = scene;
  other.model = seen(scene.model, view);
  other.initial = seen(scene.model, scene.initial, view);
  if (setup.has("gravity_not_turned")) other.model.gravity = scene.model.gravity;
  if (setup.has("spin_not_mirrored")) other.initial.v[2] = scene.initial.v[2];
  if (setup.has("one_body_left_behind")) other.initial.v[0] = scene.initial.v[0];
  return other;
}

/// The yard without contacts by nodes, and on a half-plane instead of terrain. A mirror changes the order of nodes; a
/// segment of terrain is measured from its first point, which becomes its last point in a mirror.
Scene level_yard() {
  Scene scene = mixed_pile();
  Body& field = scene.model.bodies[index(*find_body(scene.model, "field"))];
  field.shape = HalfPlane{};
  field.p_WB = {0.0, 0.31};
  field.angle = -0.03;
  std::erase_if(scene.model.contacts, [](const Contact& c) { return c.method == ContactMethod::nodes; });
  State rest = rest_state(scene.model);
  rest.q = scene.initial.q, rest.v = scene.initial.v;
  scene.initial = rest;
  return scene;
}

/// The group's bodies as round particles under gravity, with the cable attached at their centres.
Scene round_particles() {
  const Scene group = free_group();
  Scene scene{.title = "Round particles", .model = group.model};
  scene.model.gravity = {0.4, -3.1};
  for (Body& body : scene.model.bodies) {
    body.mobility = Mobility::particle;
    body.angle = 0.0;
    if (std::holds_alternative<Rectangle>(body.shape)) body.shape = Circle{0.43};
  }
  scene.model.cables[0].a.p = scene.model.cables[0].b.p = {};
  scene.initial = rest_state(scene.model);
  for (std::size_t i = 0; i < scene.model.bodies.size(); ++i) {
    scene.initial.v[2 * i] = group.initial.v[3 * i];
    scene.initial.v[2 * i + 1] = group.initial.v[3 * i + 1];
  }
  return scene;
}

/// Final states to compare: of the original run, transformed afterwards, and of the run of the transformed scene.
struct Compared {
  State expected, found;
};

Compared compare(const Scene& scene, const Viewpoint& view, const Integrator& method, double end, const Setup& setup,
                 Findings& findings) {
  return {seen(scene.model, run_to(scene, method, end, findings), view),
          run_to(seen_scene(scene, view, setup), method, end, findings)};
}

/// Largest final change of a coordinate or velocity, relative to random changes of up to 1e-9 of all initial
/// coordinates and velocities.
double growth(const Scene& scene, double end, Findings& findings) {
  constexpr double change = 1e-9;
  std::mt19937_64 random{7};
  std::uniform_real_distribution<double> any{-change, change};
  const State first = run_to(scene, VelocityVerlet{}, end, findings);
  double maximum = 0.0;
  for (int i = 0; i < 4; ++i) {
    Scene other = scene;
    for (double& q : other.initial.q)
      q += any(random);
    for (double& v : other.initial.v)
      v += any(random);
    const Difference end_change = difference(first, run_to(other, VelocityVerlet{}, end, findings));
    maximum = std::max({maximum, end_change.position / change, end_change.velocity / change});
  }
  return maximum;
}

/// Checks of transformations that change rounding: final states may differ by n u G.
class RoundedViews {
 public:
  RoundedViews(Findings& findings, const Setup& setup, std::string name, Scene scene, double end)
      : findings_{&findings}, setup_{&setup}, name_{std::move(name)}, scene_{std::move(scene)}, end_{end} {
    growth_ = growth(scene_, end_, findings);
    first_ = run_to(scene_, VelocityVerlet{}, end_, findings);
  }

  void look(const std::string& how, const Viewpoint& view) {
    const State found = run_to(seen_scene(scene_, view, *setup_), VelocityVerlet{}, end_, *findings_);
    expect(how, seen(scene_.model, first_, view), found);
  }
  void swap_contacts() {
    expect("contacts reversed with bodies exchanged", first_,
           run_to(with_contacts_swapped(scene_), VelocityVerlet{}, end_, *findings_));
  }
  const Table& table() const { return table_; }

 private:
  void expect(const std::string& how, const State& expected, const State& found) {
    double largest = 0.0;
    for (const State* state : {&expected, &found, static_cast<const State*>(&first_)}) {
      for (const double q : state->q)
        keep_largest(largest, q);
    }
    const double rounding = end_ / step * 0x1p-53 * largest * growth_;
    const Difference found_difference = difference(expected, found);
    const double maximum = std::max(found_difference.position, found_difference.velocity);
    const auto claim = findings_->in("integrator.velocity_verlet"), members = findings_->in(name_);
    findings_->in("differences")
        ->expect_round_off(fmt::format("difference of final states, {}, {}", name_, how), maximum, 0.0, rounding,
                           "n u G: each step rounds each coordinate once, by at most u of the largest one, and "
                           "rounding errors grow by at most G, as do all differences of the motion");
    table_.rows.push_back(
        {name_, how, fmt::format("{:.1f}", growth_), fmt::format("{:.1e}", maximum), fmt::format("{:.1e}", rounding)});
  }

  Findings* findings_;
  const Setup* setup_;
  std::string name_;
  Scene scene_;
  double end_;
  double growth_{};
  State first_;
  Table table_{.name = "views",
               .caption =
                   "Largest final difference of a coordinate or velocity between runs that round differently, and the "
                   "bound n u G from rounding and the growth G of differences.",
               .columns = {"scene", "transformation", "growth G", "difference", "n u G"}};
};

void check_bits(Findings& findings, const Setup& setup) {
  const char* const mirrored = "a change of sign causes no rounding, and no rule prefers a side";
  const Scene group = free_group(), yard = level_yard();
  const Viewpoint mirror{.mirrored = true};
  const auto expect = [&](const char* scene, const std::string& name, const Compared& two, const char* why,
                          const char* method = "velocity_verlet") {
    const auto claim = findings.in(fmt::format("integrator.{}", method)), members = findings.in(scene);
    findings.expect_exact({"numbers_that_differ", "numbers that differ, " + name},
                          differing_motion(two.expected, two.found), 0.0, why);
  };
  expect("group", "group in a mirror", compare(group, mirror, VelocityVerlet{}, 0.8, setup, findings), mirrored);
  expect("particles", "round particles turned by 90 degrees",
         compare(round_particles(), {.turn = quarter_turn}, VelocityVerlet{}, 0.8, setup, findings),
         "axes are exchanged and change sign; sums of two squares or two products do not depend on their order");
  if (setup.coarse) return;
  const Compared two = compare(yard, mirror, VelocityVerlet{}, 1.5, setup, findings);
  expect("yard", "level yard in a mirror", two, mirrored);
  findings.expect_true({"yard", "exactly mirrored state, level yard: contact history, modes, work, impulse"},
                       two.expected == two.found, mirrored);
  for (const char* name : {"central_difference", "rk4", "odeint_dopri5"})
    expect("yard", fmt::format("level yard in a mirror, {}", name),
           compare(yard, mirror, make_integrator(name), 0.8, setup, findings), mirrored, name);
  const Scene uneven = mixed_pile();
  Scene reversed = with_bodies_reversed(uneven);
  reversed.initial = run_to(reversed, VelocityVerlet{}, 1.5, findings);
  expect("yard", "yard with its bodies in the opposite order",
         {run_to(uneven, VelocityVerlet{}, 1.5, findings), with_bodies_reversed(reversed).initial},
         "forces are summed over contacts, in the order of the contacts");
}

/// Accelerations of both bodies of an overlapping pair, listed in either order; empty if the method does not support
/// the pair.
std::vector<double> accelerations(const Shape& a, const Shape& b, ContactMethod method, bool exchanged) {
  const auto ground = [](const Shape& s) {
    return std::holds_alternative<HalfPlane>(s) || std::holds_alternative<Terrain>(s);
  };
  SceneBuilder builder{si};
  const auto add = [&](const char* name, const Shape& shape, Vec2 at, double angle) {
    Body body{.name = name, .shape = shape, .p_WB = at, .angle = angle};
    if (ground(shape))
      body.mobility = Mobility::fixed;
    else
      body.mass = 2.0, body.inertia = 0.7;
    return builder.add(body);
  };
  const BodyId first = add("first", a, {0.3, 1.0}, 0.2), second = add("second", b, {0.0, ground(b) ? 0.6 : 0.0}, -0.1);
  try {
    builder.add(Contact{.name = "touch",
                        .a = exchanged ? second : first,
                        .b = exchanged ? first : second,
                        .law = LinearSpringDashpot{1e3, 2.0},
                        .method = method});
  } catch (const InputError&) {
    return {};
  }
  const Model model = builder.build();
  const Dynamics dynamics{model};
  record_use(model);
  Workspace work = dynamics.workspace();
  State state = rest_state(model);
  state.v[1] = -0.5;
  Rates rates{state};
  dynamics.evaluate(state, work, rates, false);
  return {rates.v.begin(), rates.v.end()};
}

/// Checks all pairs of outlines that can touch, listed in either order.
void check_pairs(Findings& findings) {
  const std::vector<Shape> shapes{Circle{0.7}, Rectangle{0.6, 0.7}, Superquadric{0.6, 0.7, 4.0}, HalfPlane{},
                                  Terrain{{{-5.0, 0.2}, {0.1, 0.0}, {5.0, 0.3}}}};
  double worst = 0.0, compared = 0.0, apart = 0.0;
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t j = i; j < shapes.size(); ++j) {
      for (const ContactMethod method : {ContactMethod::resultant, ContactMethod::nodes}) {
        const std::vector<double> one = accelerations(shapes[i], shapes[j], method, false),
                                  other = accelerations(shapes[i], shapes[j], method, true);
        if (one.empty() && other.empty()) continue;
        if (one.size() != other.size()) throw std::logic_error("a pair is supported in one order only");
        double largest = 0.0;
        for (std::size_t k = 0; k < one.size(); ++k) {
          keep_worst(worst, one[k] - other[k]);
          keep_largest(largest, one[k]);
        }
        compared += 1.0;
        apart += largest > 1.0 ? 0.0 : 1.0;
      }
    }
  }
  const auto group = findings.in("pairs");
  findings.expect_round_off("accelerations of a pair listed in either order, largest difference", worst, 0.0, 3e-12,
                            "a thousand roundings of forces of up to 1000 N on 1 kg, 3.3e-14 N rms each: 1e-12 as a "
                            "random walk, three times that",
                            "m/s^2");
  findings.expect_exact("pairs that do not touch", apart, 0.0, "each pair starts with an overlap");
  findings.expect_exact("pairs compared", compared, 22.0,
                        "five outlines, of which three can move, and two methods; terrain supports rectangles and "
                        "superquadrics with nodal contact only");
}

void run(Findings& findings, const Setup& setup) {
  check_bits(findings, setup);
  RoundedViews group{findings, setup, "group", free_group(), 0.8};
  group.look("seen from a moving frame", {.boost = {3.7, -1.9}});
  if (setup.coarse) return;
  check_pairs(findings);
  group.look("shifted", {.shift = {37.1, -11.9}});
  group.look("turned by 0.7 rad", {.turn = rotation(0.7), .angle = 0.7});
  group.look("turned by 90 degrees", {.turn = quarter_turn, .angle = 0.5 * std::numbers::pi});
  group.swap_contacts();
  RoundedViews yard{findings, setup, "yard", mixed_pile(), 0.5};
  yard.look("shifted", {.shift = {37.1, -11.9}});
  yard.look("turned by 90 degrees", {.turn = quarter_turn, .angle = 0.5 * std::numbers::pi});
  yard.look("in a mirror", {.mirrored = true});
  yard.swap_contacts();
  Table table = group.table();
  table.rows.insert(table.rows.end(), yard.table().rows.begin(), yard.table().rows.end());
  findings.table(table);
}

}  // namespace

Case definition() {
  return {.id = "frame_invariance",
          .title = "Frame invariance: turned, mirrored and reordered scenes",
          .requirements = {{"A6", {"numbers_that_differ", "differences"}},
                           {"law.linear_spring_dashpot, law.tension_only", {"group", "yard"}},
                           {"law.elastic_plastic", {"yard"}},
                           {"Eq. 18", {"group", "yard"}},
                           {"shape.superquadric", {"yard"}},
                           {"shape.rectangle", {"group", "yard"}},
                           {"shape.terrain", {"yard"}},
                           {"shape.circle, method.resultant", {"group", "yard"}},
                           {"method.nodes", {"yard"}}},
          .main_checks = {"numbers that differ, level yard in a mirror",
                          "numbers that differ, yard with its bodies in the opposite order",
                          "numbers that differ, round particles turned by 90 degrees",
                          "difference of final states, group, seen from a moving frame",
                          "difference of final states, group, turned by 0.7 rad"},
          .source = "Galilei 1638; Chen, Cheung & Yiu 1998 (metamorphic testing)",
          .faults = {{"gravity_not_turned", "gravity is not turned",
                      "numbers that differ, round particles turned by 90 degrees"},
                     {"spin_not_mirrored", "the spin of one body is not mirrored",
                      "numbers that differ, group in a mirror"},
                     {"one_body_left_behind", "the velocity of one body is not transformed to the moving frame",
                      "difference of final states, group, seen from a moving frame"}},
          .run = run};
}

}  // namespace talus::verification::problems::frame_invariance
