#include "verification/problems/speed_accuracy/fidelity_levels.hpp"

#include <numeric>

#include "solver/laws/restitution.hpp"
#include "solver/scenes/pivoted_cylinder.hpp"
#include "verification/study/scenes/fence_table.hpp"
#include "verification/study/toolkit.hpp"

namespace talus::verification::problems {
namespace {

/// The fence's contact law, with the dashpot for the effective mass of this contact.
LinearSpringDashpot contact_law(const FenceNumbers& n, double felt_mass) {
  const double xi = damping_ratio(n.restitution, EndRule::clamped);
  return {n.contact_stiffness, damping(xi, n.contact_stiffness, felt_mass), EndRule::clamped};
}

double reduced(double a, double b) { return a * b / (a + b); }

/// Rock and column as two touching particles; the rock moves towards -x as in the fence.
SceneBuilder pair_of_particles(const FenceNumbers& n, double height) {
  SceneBuilder builder{us};
  const double mass = free_column_mass(n, height);
  const BodyId column = builder.add_particle("column1", mass, {}, Circle{n.half_width});
  const BodyId rock =
      builder.add_particle("rock", n.rock_mass, {n.half_width + n.rock_radius, 0.0}, Circle{n.rock_radius});
  builder.add_contact("impact", rock, column, contact_law(n, reduced(n.rock_mass, mass)));
  return builder;
}

Scene started(std::string title, Model model, Vec2 velocity) {
  Scene scene{.title = std::move(title), .model = std::move(model)};
  scene.initial = rest_state(scene.model);
  set_velocity(scene.model, scene.initial, *find_body(scene.model, "rock"), velocity, 0.0);
  return scene;
}

/// Records the Passage of a run.
class Monitor {
 public:
  explicit Monitor(const Scene& scene) : model_{&scene.model}, probe_{scene.model} {
    rock_ = Layout{scene.model}.first[index(*find_body(scene.model, "rock"))];
    direction_ = std::copysign(1.0, scene.initial.v[rock_]);
    for (std::size_t c = 0; c < model_->contacts.size(); ++c) {
      const std::string& name = model_->contacts[c].name;
      if (name == "impact" || name == "rock-column1") struck_ = c;
    }
    found.first = std::numeric_limits<double>::quiet_NaN();
    if (model_->cables.empty()) found.pull = std::numeric_limits<double>::quiet_NaN();
  }

  void check(const State& state) {
    probe_.evaluate(state);
    const double push = probe_.forces().contacts[struck_];
    found.exit = direction_ * state.v[rock_];
    if (touched_ && push == 0.0 && std::isnan(found.first)) found.first = found.exit;
    touched_ = touched_ || push > 0.0;
    found.push = std::max(found.push, push);
    for (std::size_t c = 0; c < model_->cables.size(); ++c) {
      if (model_->cables[c].name.find("top") != std::string::npos)
        found.pull = std::max(found.pull, probe_.forces().tensions[c]);
    }
  }

  Passage found;

 private:
  const Model* model_;
  Probe probe_;
  std::size_t rock_{}, struck_{};
  double direction_{};
  bool touched_{false};
};

}  // namespace

scenes::Fence ladder_fence(double height) {
  scenes::Fence fence = published_fence("table_2.DAT");
  fence.rocks.front().position.y = height;
  fence.options.contact = scenes::FenceContact::resultant;
  fence.options.calibration = scenes::FenceCalibration::effective_mass;
  fence.options.end_rule = EndRule::clamped;
  fence.options.start = scenes::FenceStart::plain;
  return fence;
}

FenceNumbers fence_numbers(const scenes::Fence& fence) {
  const scenes::FenceScene made = scenes::fence_scene(fence);
  const scenes::FenceMember& rock = made.members[1];
  const scenes::FenceMember& column = made.members[2];
  const scenes::StaticShape shape = scenes::static_shape(fence);
  return {.speed = norm(fence.rocks.front().velocity),
          .restitution = fence.restitution,
          .rock_mass = rock.mass,
          .rock_radius = fence.rocks.front().a,
          .column_mass = column.mass,
          .column_inertia = column.inertia,
          .half_width = fence.column.a,
          .top_joint = fence.y_top,
          .contact_stiffness = made.rock_column.stiffness,
          .cable_modulus = fence.young * fence.area_top,
          .first_tension = shape.tensions.front(),
          .segment = shape.distances.front(),
          .half_span = std::accumulate(shape.distances.begin(), shape.distances.end(), 0.0),
          .gravity = fence.gravity};
}

double free_column_mass(const FenceNumbers& n, double height) {
  return 1.0 / reference::free_mobility(n.column_mass, n.column_inertia, height);
}

double hung_column_mass(const FenceNumbers& n, double height) {
  const double about_pin = n.column_inertia + n.column_mass * n.top_joint * n.top_joint;
  return 1.0 / reference::pivoted_mobility(about_pin, n.top_joint - height);
}

double speed_by_formula(const FenceNumbers& n, double mass) {
  return n.speed * (n.rock_mass - n.restitution * mass) / (n.rock_mass + mass);
}

reference::Impact soft_impact(const FenceNumbers& n, double mass) {
  const double felt = reference::effective_mass(1.0 / n.rock_mass, 1.0 / mass);
  const double xi = reference::damping_ratio(n.restitution, reference::EndRule::clamped);
  return {n.contact_stiffness, 2.0 * xi * std::sqrt(n.contact_stiffness * felt), felt, n.speed};
}

Scene free_pair(const FenceNumbers& n, double height) {
  return started("Free pair", pair_of_particles(n, height).build(), {-n.speed, 0.0});
}

Scene particle_on_cables(const FenceNumbers& n, double height, Held held, const Setup& setup) {
  SceneBuilder builder = pair_of_particles(n, height);
  const double length = held == Held::ends ? n.half_span : n.segment;
  const double stiffness = n.cable_modulus / length;
  for (const double side : {1.0, -1.0}) {
    const double hung = setup.has("cable_stiffness_halved") ? 0.5 * stiffness : stiffness;
    builder.add_cable(side > 0.0 ? "top1" : "top-1", {BodyId{0}, {}}, {std::nullopt, {0.0, 0.0, side * length}},
                      length - n.first_tension / hung, TensionOnly{hung, 0.0});
  }
  return started("Particle on two cables", builder.build(), {-n.speed, 0.0});
}

Scene hung_column(const FenceNumbers& n, double height) {
  Scene scene =
      scenes::pivoted_cylinder({.mass = n.column_mass,
                                .length = 2.0 * n.top_joint,
                                .inertia = n.column_inertia,
                                .half_width = n.half_width,
                                .rock_mass = n.rock_mass,
                                .rock_radius = n.rock_radius,
                                .speed = n.speed,
                                .gravity = n.gravity,
                                .contact = contact_law(n, reduced(n.rock_mass, hung_column_mass(n, height)))});
  const Layout layout{scene.model};
  scene.initial.q[layout.first[index(*find_body(scene.model, "rock"))] + 1] += height;
  return scene;
}

Scene moving_columns(const scenes::Fence& fence, int beside) {
  Model model = scenes::fence_scene(fence).scene.model;
  for (Body& body : model.bodies) {
    if (body.name.rfind("column", 0) != 0 || std::stoi(body.name.substr(6)) <= 1 + beside) continue;
    body.mobility = Mobility::fixed;
    body.force = {};
    body.sleeps = false;
  }
  return started("Half fence with fixed outer columns", std::move(model), fence.rocks.front().velocity);
}

Passage passage(const Scene& scene, double tolerance, Findings& findings) {
  Monitor watch{scene};
  // Peaks are sampled every 2e-5 s. A radian of the contact lasts 0.9 ms: its peaks are low by at most 6e-5.
  constexpr double interval = 2e-5;
  const RunEnd end =
      run_scene(scene, make_integrator("stormer_cowell", tolerance), {interval, passage_end, interval, false}, findings,
                [&](const State& state, const StepInfo&) { watch.check(state); });
  Passage found = std::move(watch.found);
  found.evaluations = end.evaluations;
  found.coordinates = end.state.q.size();
  found.end = end.state;
  if (!end.finished) found.first = found.push = found.pull = found.exit = std::numeric_limits<double>::quiet_NaN();
  return found;
}

}  // namespace talus::verification::problems
