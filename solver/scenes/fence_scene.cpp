#include "solver/scenes/fence_scene.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "solver/base/error.hpp"
#include "solver/dynamics/dynamics.hpp"
#include "solver/geometry/mass_properties.hpp"
#include "solver/laws/restitution.hpp"
#include "solver/model/model_builder.hpp"

namespace talus::scenes {
namespace {

/// 1993 replaced power 0 by this: exponent 2/.1 = 20 (fitted to the listing of sample2).
constexpr double blunt_power = 0.1;

MassProperties mass_properties(const FenceElement& e) {
  switch (e.solid) {
    case ElementSolid::ellipsoid:
      return ellipsoid(e.a, e.b, e.density);
    case ElementSolid::block:
      return block(e.a, e.b, e.density);
    case ElementSolid::cylinder:
      break;
  }
  return cylinder(e.a, e.b, e.density);
}

double exponent(const FenceElement& e) { return 2.0 / (e.power == 0.0 ? blunt_power : e.power); }

Shape outline(const FenceElement& e, FenceContact contact) {
  const bool round = e.solid == ElementSolid::ellipsoid && e.power == 0.0;
  if (round) return e.a == e.b ? Shape{Circle{e.a}} : Shape{Superquadric{e.a, e.b, 2.0}};
  if (contact == FenceContact::resultant) return Rectangle{e.a, e.b};
  return Superquadric{e.a, e.b, exponent(e)};
}

int node_count(const FenceElement& e) { return 4 * (e.points - 1); }

/// What the fixities of an element leave it: nothing, a turn about its fixed point, or all but a turn.
Mobility mobility(const FenceElement& e, std::string_view name) {
  const auto [x, y, turn] = e.held;
  if (x && y) return turn ? Mobility::fixed : Mobility::pinned;
  if (!x && !y) return turn ? Mobility::particle : Mobility::free;
  throw InputError{fmt::format("{}: only one of its x and y motions is fixed; it must be both or none", name)};
}

Body body(const FenceElement& e, std::string name, FenceContact contact) {
  const MassProperties solid = mass_properties(e);
  Body made{.name = std::move(name), .mass = solid.mass, .inertia = solid.inertia};
  made.mobility = mobility(e, made.name);
  made.shape = outline(e, contact);
  made.p_WB = e.position;
  made.angle = e.angle;
  made.p_BPin = e.fixed_point;
  if (made.mobility != Mobility::fixed) made.force = e.force;
  if (made.mobility == Mobility::free || made.mobility == Mobility::pinned) made.moment = e.moment;
  return made;
}

double reduced_mass(double a, double b) { return a * b / (a + b); }

/// Puts the parts of one fence together.
class FenceMaker {
 public:
  explicit FenceMaker(const Fence& fence) : fence_{fence}, builder_{fence.units} {
    builder_.gravity({0.0, fence.gravity_sign * fence.gravity});
    builder_.sleep(fence.options.sleep);
    for (const FenceElement& rock : fence.rocks)
      speed_ = std::max(speed_, norm(rock.velocity));
    if (speed_ == 0.0) throw InputError{"fence: no rock moves; the contact stiffnesses follow from a rock's speed"};
  }

  FenceScene make() {
    add_ground();
    add_rocks();
    for (int layer = 1; layer <= fence_.layers; ++layer)
      add_layer(layer);
    add_contacts();
    made_.scene.title = fence_.title;
    made_.scene.model = balanced(builder_.build());
    made_.scene.initial = rest_state(made_.scene.model);
    for (std::size_t i = 0; i < fence_.rocks.size(); ++i) {
      const FenceElement& rock = fence_.rocks[i];
      set_velocity(made_.scene.model, made_.scene.initial, rocks_[i], rock.velocity, rock.spin);
    }
    if (!(fence_.column.velocity == Vec2{}) || fence_.column.spin != 0.0) {
      for (const BodyId column : columns_)
        set_velocity(made_.scene.model, made_.scene.initial, column, fence_.column.velocity, fence_.column.spin);
    }
    plan();
    if (fence_.options.start == FenceStart::half_kick) kick_half_a_step();
    return std::move(made_);
  }

 private:
  struct Column {
    BodyId body;
    int side;  ///< 0 central, +1 and -1
  };
  bool full() const { return fence_.options.symmetry == FenceSymmetry::full; }
  bool even() const { return fence_.columns % 2 == 0; }
  bool doubled() const { return even() && !full() && fence_.options.even_centre == EvenCentre::doubled; }

  void add_ground() {
    const FenceElement& e = fence_.ground;
    if (e.held != std::array<bool, 3>{true, true, true})
      throw InputError{"fence: the ground must be held in x, y and rotation"};
    const Vec2 up{-rotation(e.angle).sine, rotation(e.angle).cosine};
    Body made{.name = "ground", .mobility = Mobility::fixed, .shape = HalfPlane{}, .p_WB = e.position + e.b * up};
    made.angle = e.angle;
    ground_ = builder_.add(made);
    const MassProperties solid = mass_properties(e);
    made_.members.push_back(
        {.body = ground_, .position = e.position, .angle = e.angle, .mass = solid.mass, .inertia = solid.inertia});
  }

  void add_rocks() {
    for (std::size_t i = 0; i < fence_.rocks.size(); ++i) {
      const FenceElement& e = fence_.rocks[i];
      const std::string name = fence_.rocks.size() == 1 ? "rock" : fmt::format("rock{}", i + 1);
      const Body made = body(e, name, fence_.options.contact);
      rocks_.push_back(builder_.add(made));
      rock_masses_.push_back(made.mass);
      made_.members.push_back({.body = rocks_.back(),
                               .position = e.position,
                               .angle = e.angle,
                               .mass = made.mass,
                               .inertia = made.inertia});
    }
  }

  void add_layer(int layer);
  CableId add_cable(const std::string& name, CableEnd a, CableEnd b, double stiffness, double rest_length,
                    double limit);
  void add_contacts();
  void add_rock_contacts(std::size_t i);
  FenceContactLaw contact_law(double mass, double factor, double overlap) const;
  Contact contact(std::string name, BodyId a, BodyId b, FenceContactLaw law) const;
  Model balanced(Model model) const;
  void plan();
  void kick_half_a_step();

  const Fence& fence_;
  ModelBuilder builder_;
  FenceScene made_;
  double speed_{};
  double column_mass_{};
  double first_stiffness_{};
  BodyId ground_{};
  std::vector<BodyId> rocks_;
  std::vector<double> rock_masses_;
  std::vector<std::vector<BodyId>> central_;  ///< of each layer
  std::vector<BodyId> columns_;
};

CableId FenceMaker::add_cable(const std::string& name, CableEnd a, CableEnd b, double stiffness, double rest_length,
                              double limit) {
  Cable cable{.name = name,
              .a = a,
              .b = b,
              .rest_length = rest_length,
              .law = ElasticPlastic{.stiffness = stiffness, .yield = limit}};
  cable.copies = full() ? 1 : 2;
  return builder_.add(cable);
}

void FenceMaker::add_layer(int layer) {
  const FenceElement& e = fence_.column;
  const std::string prefix = layer == 1 ? "" : "back_";
  const double x = e.position.x - (layer - 1) * fence_.layer_spacing;
  Body pattern = body(e, "", fence_.options.contact);
  pattern.sleeps = pattern.mobility == Mobility::free;
  const double weight = pattern.mass * fence_.gravity;
  const StaticShape shape = static_shape(fence_, weight);
  if (layer == 1) made_.horizontal_tension = shape.horizontal_tension;
  const int count = columns_of_half(fence_);
  const double inner = even() ? 0.5 * fence_.spacing : 0.0;  // z of the first column
  central_.emplace_back();

  const auto along = [&](int i) { return inner + i * fence_.spacing; };
  const auto name = [&](std::string_view what, int i, int side) {
    return fmt::format("{}{}{}{}", prefix, what, side < 0 ? "-" : "", i + 1);
  };
  std::vector<std::array<BodyId, 2>> bodies(static_cast<std::size_t>(count));
  const std::size_t first_member = made_.members.size();
  for (int i = 0; i < count; ++i) {
    Body made = pattern;
    const bool centre = i == 0;
    made.p_WB = {x, e.position.y + shape.heights[static_cast<std::size_t>(i)]};
    if (!full() && !(centre && (!even() || doubled()))) made.copies = 2;
    if (centre && doubled()) made.mass *= 2.0, made.inertia *= 2.0;
    made.name = name("column", i, 1);
    auto& pair = bodies[static_cast<std::size_t>(i)];
    pair[0] = builder_.add(made);
    columns_.push_back(pair[0]);
    if (full() && !(centre && !even())) {
      made.name = name("column", i, -1);
      pair[1] = builder_.add(made);
      columns_.push_back(pair[1]);
    } else {
      pair[1] = pair[0];
    }
    if (centre) {
      central_.back() = {pair[0]};
      if (pair[1] != pair[0]) central_.back().push_back(pair[1]);
      column_mass_ = made.mass;
    }
    made_.members.push_back({.body = pair[0],
                             .layer = layer,
                             .position = made.p_WB,
                             .angle = made.angle,
                             .mass = pattern.mass,
                             .inertia = pattern.inertia});
  }
  const Vec2 end{x, e.position.y + shape.heights.back()};
  made_.members.push_back({.layer = layer, .position = end, .mass = pattern.mass, .inertia = pattern.inertia});

  const double top_stiffness = fence_.young * fence_.area_top;
  const double bottom_stiffness = 2.0 * fence_.young * fence_.area_bottom;  // double wrapped
  const auto add_segments = [&](bool top) {
    const double local_y = top ? fence_.y_top : fence_.y_bottom;
    if (full() && even()) {
      // The segment between the central columns, straight across.
      const double d = fence_.spacing;
      const CableEnd a{bodies[0][1], {0.0, local_y, -inner}}, b{bodies[0][0], {0.0, local_y, inner}};
      const double k = (top ? top_stiffness : bottom_stiffness) / d;
      const double rest = top ? d - shape.horizontal_tension / k : d + fence_.slack;
      add_cable(prefix + (top ? "top0" : "bottom0"), a, b, k, rest, top ? fence_.limit_top : fence_.limit_bottom);
    }
    const int segments = top || fence_.options.bottom_end == BottomEnd::anchored ? count : count - 1;
    for (int i = 0; i < segments; ++i) {
      const auto s = static_cast<std::size_t>(i);
      const double rise = shape.heights[s + 1] - shape.heights[s];
      const double length = std::sqrt(shape.distances[s] * shape.distances[s] + rise * rise);
      const double k = (top ? top_stiffness : bottom_stiffness) / length;
      if (top && i == 0 && layer == 1) first_stiffness_ = k;
      const double rest = top ? length - shape.tensions[s] / k : length + fence_.slack;
      for (const int side : full() ? std::vector{1, -1} : std::vector{1}) {
        const std::size_t hand = side > 0 ? 0 : 1;
        const CableEnd a{bodies[s][hand], {0.0, local_y, side * along(i)}};
        const CableEnd b = i + 1 < count
                               ? CableEnd{bodies[s + 1][hand], {0.0, local_y, side * along(i + 1)}}
                               : CableEnd{{}, {end.x, end.y + local_y, side * (along(i) + shape.distances[s])}};
        const CableId id = add_cable(name(top ? "top" : "bottom", i, side), a, b, k, rest,
                                     top ? fence_.limit_top : fence_.limit_bottom);
        FenceMember& member = made_.members[first_member + s];
        if (side > 0) (top ? member.top : member.bottom) = id;
      }
    }
  };
  add_segments(true);
  if (fence_.connections == 2) add_segments(false);
}

/// k = factor m v^2/overlap^2: the spring that takes the energy of m at the speed of the impact within the overlap,
/// with the factors of 1993; c by Eq. 21 with the same mass.
FenceContactLaw FenceMaker::contact_law(double mass, double factor, double overlap) const {
  const double stiffness = factor * mass * speed_ * speed_ / (overlap * overlap);
  return {stiffness, damping(damping_ratio(fence_.restitution, fence_.options.end_rule), stiffness, mass)};
}

Contact FenceMaker::contact(std::string name, BodyId a, BodyId b, FenceContactLaw law) const {
  Contact made{.name = std::move(name), .a = a, .b = b};
  made.law = LinearSpringDashpot{law.stiffness, law.damping, fence_.options.end_rule};
  if (fence_.options.contact == FenceContact::nodes) made.method = ContactMethod::nodes;
  return made;
}

void FenceMaker::add_rock_contacts(std::size_t i) {
  const FenceElement& rock = fence_.rocks[i];
  const std::string name = fence_.rocks.size() == 1 ? "rock" : fmt::format("rock{}", i + 1);
  const double overlap = fence_.rock_overlap > 0.0 ? fence_.rock_overlap : fence_.penetration * rock.a;
  const FenceContactLaw on_column = contact_law(reduced_mass(rock_masses_[i], column_mass_), 1.0, overlap);
  for (std::size_t layer = 0; layer < central_.size(); ++layer) {
    for (std::size_t c = 0; c < central_[layer].size(); ++c) {
      Contact made = contact(fmt::format("{}-{}column{}", name, layer == 0 ? "" : "back_", c == 0 ? "1" : "-1"),
                             rocks_[i], central_[layer][c], on_column);
      made.nodes = {node_count(rock), node_count(fence_.column)};
      made.node_depth = NodeDepth::side_face;
      if (even() && !full() && !doubled()) made.copies = 2;
      builder_.add(made);
    }
  }
  // Factor 2 in place of 1, fitted to the one printed value.
  const FenceContactLaw on_ground = contact_law(rock_masses_[i], 2.0, fence_.penetration * rock.a);
  Contact made = contact(name + "-ground", rocks_[i], ground_, on_ground);
  made.nodes = {node_count(rock), 3};
  builder_.add(made);
  if (i == 0) made_.rock_column = on_column, made_.rock_ground = on_ground;
}

void FenceMaker::add_contacts() {
  for (std::size_t i = 0; i < fence_.rocks.size(); ++i)
    add_rock_contacts(i);
  for (std::size_t i = 0; i < fence_.rocks.size(); ++i) {
    for (std::size_t j = i + 1; j < fence_.rocks.size(); ++j) {
      const double smaller = std::min(fence_.rocks[i].a, fence_.rocks[j].a);
      const double overlap = fence_.rock_overlap > 0.0 ? fence_.rock_overlap : fence_.penetration * smaller;
      Contact made = contact(fmt::format("rock{}-rock{}", i + 1, j + 1), rocks_[i], rocks_[j],
                             contact_law(reduced_mass(rock_masses_[i], rock_masses_[j]), 1.0, overlap));
      made.nodes = {node_count(fence_.rocks[i]), node_count(fence_.rocks[j])};
      builder_.add(made);
    }
  }
  if (fence_.layers < 2) return;
  const double overlap = fence_.layer_overlap > 0.0 ? fence_.layer_overlap : fence_.penetration * fence_.column.a;
  made_.column_column = contact_law(0.5 * column_mass_, 1.0, overlap);
  for (std::size_t c = 0; c < central_[0].size(); ++c) {
    Contact made = contact(fmt::format("column{0}-back_column{0}", c == 0 ? "1" : "-1"), central_[0][c], central_[1][c],
                           made_.column_column);
    made.nodes = {node_count(fence_.column), node_count(fence_.column)};
    made.node_depth = NodeDepth::centroid_ray;
    if (even() && !full() && !doubled()) made.copies = 2;
    builder_.add(made);
  }
}

/// The static shape is in balance but for the last digit of its forces. What is left is held as a constant force, so
/// that a column at rest stays at rest exactly. (Weight and pull differ by less than a factor of 2, so their
/// difference is exact, and so is the sum of weight and residual.)
Model FenceMaker::balanced(Model model) const {
  const Dynamics dynamics{model};
  State state = rest_state(model);
  Workspace work = dynamics.workspace();
  Rates rates{state};
  dynamics.update(state, work);
  dynamics.settle(state, work);
  dynamics.rates(state, work, rates, false);
  for (const BodyId column : columns_) {
    Body& body = model.bodies[index(column)];
    if (body.mobility != Mobility::free) continue;
    // Contacts have no place in it: a rock may touch the fence at the start.
    Vec2 pull;
    for (std::size_t j = 0; j < work.joints.size(); ++j) {
      const Joint& joint = dynamics.cables().joints()[j];
      if (joint.on_body && joint.body == column) pull += work.joints[j].force;
    }
    body.force += -pull - body.mass * model.gravity;
  }
  return model;
}

void FenceMaker::plan() {
  const double central = made_.members[1 + fence_.rocks.size()].mass * (doubled() ? 2.0 : 1.0);
  made_.critical_step = 2.0 * std::numbers::pi * std::sqrt(central / (2.0 * first_stiffness_)) / 100.0;
  RunPlan& plan = made_.scene.plan;
  plan.step = fence_.step_factor == 0.0 ? made_.critical_step : fence_.step_factor * made_.critical_step;
  plan.end = static_cast<double>(fence_.steps) * plan.step;
  plan.interval = static_cast<double>(fence_.history_every) * plan.step;
  made_.scene.integrator = make_integrator(fence_.options.integrator, 0.0);
}

/// Contact forces alone, as the bodies touch at the start, act for half a step. (Cables are in balance with the
/// weights; a rock's own weight is left out, as the printed fall of sample2's rock shows.)
void FenceMaker::kick_half_a_step() {
  const Dynamics dynamics{made_.scene.model};
  State& state = made_.scene.initial;
  Workspace work = dynamics.workspace();
  State touching = state;
  dynamics.update(touching, work);
  dynamics.settle(touching, work);
  std::fill(work.wrenches.begin(), work.wrenches.end(), Wrench{});
  dynamics.contacts().add(touching, work, nullptr);
  for (std::size_t i = 0; i < state.v.size(); ++i) {
    const auto [body, axis] = dynamics.layout().coordinates[i];
    const Wrench& wrench = work.wrenches[index(body)];
    const double load = axis == Axis::x ? wrench.force.x : axis == Axis::y ? wrench.force.y : wrench.moment;
    state.v[i] += 0.5 * made_.scene.plan.step * load / dynamics.inertias()[i];
  }
}

}  // namespace

int columns_of_half(const Fence& fence) { return (fence.columns + 1) / 2; }

int element_count(const Fence& fence) {
  return 1 + static_cast<int>(fence.rocks.size()) + fence.layers * (columns_of_half(fence) + 1);
}

StaticShape static_shape(const Fence& fence, double weight) {
  const int count = columns_of_half(fence);
  const bool even = fence.columns % 2 == 0;
  StaticShape shape;
  // Loads inside the segments, in weights: of an odd count half the central column's is carried to each side.
  std::vector<double> loads;
  double reach = even ? 0.5 * fence.spacing : 0.0;
  for (int i = 0; i < count; ++i) {
    const double distance = i + 1 < count ? fence.spacing : 0.5 * fence.span - reach;
    if (distance <= 0.0) {
      throw InputError{fmt::format("fence: {} columns {} apart do not fit into half the span, {}", fence.columns,
                                   fence.spacing, 0.5 * fence.span)};
    }
    shape.distances.push_back(distance);
    loads.push_back(even ? i + 1.0 : i + 0.5);
    reach += distance;
  }
  double moment = 0.0;
  for (std::size_t i = 0; i < loads.size(); ++i)
    moment += loads[i] * shape.distances[i];
  const double H = shape.horizontal_tension = weight / fence.sag * moment;
  shape.heights = {0.0};
  for (std::size_t i = 0; i < loads.size(); ++i) {
    const double d = shape.distances[i];
    const double rise = loads[i] * (weight / H) * d;
    shape.heights.push_back(i + 1 < loads.size() ? shape.heights.back() + rise : fence.sag);
    shape.tensions.push_back(H * std::sqrt(d * d + rise * rise) / d);
  }
  return shape;
}

FenceScene fence_scene(const Fence& fence) { return FenceMaker{fence}.make(); }

}  // namespace talus::scenes
