#include "solver/scenes/fence_scene.hpp"

#include <fmt/format.h>

#include <Eigen/Dense>
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

/// What the fixities of an element leave it; the point that they hold is its pin.
Mobility mobility(const FenceElement& e) {
  const auto [x, y, turn] = e.held;
  if (x && y) return turn ? Mobility::fixed : Mobility::pinned;
  if (x) return turn ? Mobility::sliding_y : Mobility::guided_y;
  if (y) return turn ? Mobility::sliding_x : Mobility::guided_x;
  return turn ? Mobility::particle : Mobility::free;
}

Body body(const FenceElement& e, std::string name, FenceContact contact) {
  const MassProperties solid = mass_properties(e);
  Body made{.name = std::move(name), .mass = solid.mass, .inertia = solid.inertia};
  made.mobility = mobility(e);
  made.shape = outline(e, contact);
  made.p_WB = e.position;
  made.angle = e.angle;
  made.p_BPin = e.fixed_point;
  if (made.mobility != Mobility::fixed) made.force = e.force;
  if (turns(made.mobility)) made.moment = e.moment;
  return made;
}

std::string prefix(int layer) { return layer == 1 ? "" : "back_"; }

double reduced_mass(double a, double b) { return a * b / (a + b); }

/// Rise of a segment across d that carries V upwards at its inner end: k (l - l0) r/l = V, l^2 = d^2 + r^2. The left
/// side grows with r from where the segment is taut.
double rise_under(double load, double across, double rest_length, double stiffness) {
  double low = std::sqrt(std::max(0.0, rest_length * rest_length - across * across));
  double high = rest_length + across + load / stiffness;
  for (int halving = 0; halving < 200; ++halving) {
    const double r = 0.5 * (low + high), l = std::sqrt(across * across + r * r);
    (stiffness * (l - rest_length) * r / l < load ? low : high) = r;
  }
  return 0.5 * (low + high);
}

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
    check_stretched();
    made_.scene.model = balanced(fence_.stretched_cables.empty() ? builder_.build() : hung(builder_.build()));
    made_.scene.initial = rest_state(made_.scene.model);
    for (std::size_t i = 0; i < fence_.rocks.size(); ++i) {
      const FenceElement& rock = fence_.rocks[i];
      set_velocity(made_.scene.model, made_.scene.initial, rocks_[i], rock.velocity, rock.spin);
    }
    if (!(fence_.column.velocity == Vec2{}) || fence_.column.spin != 0.0) {
      for (const std::vector<Column>& layer : layers_) {
        for (const Column& column : layer)
          set_velocity(made_.scene.model, made_.scene.initial, column.body, fence_.column.velocity, fence_.column.spin);
      }
    }
    plan();
    if (fence_.options.start == FenceStart::half_kick) kick_half_a_step();
    return std::move(made_);
  }

 private:
  /// One column as it is hung.
  struct Column {
    BodyId body{};
    std::string number;  ///< in names: its place from 1, with a minus on the other side
    int place{};         ///< from the centre outwards, from 0
    double along{};      ///< its place along the fence [L]
    double mass{};       ///< of the body: twice its own where one stands for two
    double inertia{};
    int copies{1};
    bool struck{};  ///< stands in front of a rock
  };
  double column_weight() const { return mass_properties(fence_.column).mass * fence_.gravity; }
  bool full() const { return fence_.options.symmetry == FenceSymmetry::full; }
  bool even() const { return fence_.columns % 2 == 0; }
  bool doubled() const { return even() && !full() && fence_.options.even_centre == EvenCentre::doubled; }

  NodeDepth node_depth(NodeDepth of_1993) const {
    return fence_.options.contact == FenceContact::smoother ? NodeDepth::smoother : of_1993;
  }

  void add_ground() {
    const FenceElement& e = fence_.ground;
    if (e.held != std::array<bool, 3>{true, true, true})
      throw InputError{"fence: the ground must be held in x, y and rotation"};
    const Vec2 up{-rotation(e.angle).sine, rotation(e.angle).cosine};
    Body made{.name = "ground", .mobility = Mobility::fixed, .shape = HalfPlane{}, .p_WB = e.position + e.b * up};
    made.angle = e.angle;
    if (!fence_.ground_profile.empty()) {
      made.shape = Terrain{fence_.ground_profile};
      made.p_WB = {};
      made.angle = 0.0;
    }
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

  ChangedColumn column(int place) const;
  bool meets(const FenceElement& rock, const Column& column) const;
  void add_layer(int layer);
  void add_segments(int layer, bool top, const StaticShape& shape, const std::vector<std::array<std::size_t, 2>>& hung);
  void add_hangers(int layer);
  void add_member(int layer, const Column& column, const ChangedColumn& place, Vec2 position, double angle);
  CableId add_cable(const std::string& name, CableEnd a, CableEnd b, double stiffness, double rest_length, bool top);
  void add_contacts();
  void add_rock_contacts(std::size_t i);
  void add_rock_pairs();
  void add_column_pairs();
  void add_columns_on_ground();
  FenceContactLaw contact_law(double mass, double factor, double overlap, double damped_mass) const;
  double damped_mass(std::size_t rock, const Column& column) const;
  Contact contact(std::string name, BodyId a, BodyId b, FenceContactLaw law) const;
  void check_stretched() const;
  void hang_sides(Model& model) const;
  Model hung(Model model);
  Model balanced(Model model) const;
  void plan();
  void kick_half_a_step();

  const Fence& fence_;
  ModelBuilder builder_;
  FenceScene made_;
  double speed_{};
  double first_stiffness_{};
  BodyId ground_{};
  std::vector<BodyId> rocks_;
  std::vector<double> rock_masses_;
  std::vector<std::vector<Column>> layers_;  ///< columns of each layer, from the centre outwards
};

CableId FenceMaker::add_cable(const std::string& name, CableEnd a, CableEnd b, double stiffness, double rest_length,
                              bool top) {
  const FenceOptions& options = fence_.options;
  ElasticPlastic law{.stiffness = stiffness, .yield = top ? fence_.limit_top : fence_.limit_bottom};
  // The tangent stiffness k H/(k + H) is the given share of k.
  law.hardening = options.hardening / (1.0 - options.hardening) * stiffness;
  if (const double strength = top ? options.strength_top : options.strength_bottom; strength > 0.0)
    law.strength = strength;
  if (options.rupture > 0.0) law.rupture = options.rupture * rest_length;
  for (const StretchedCable& stretched : fence_.stretched_cables) {
    if (stretched.cable != name) continue;
    // Its memory starts at nought: what it was drawn out by before is part of its length, yield force and rupture.
    rest_length += stretched.stretch;
    law.yield += law.hardening * stretched.stretch;
    if (options.rupture > 0.0) law.rupture -= stretched.stretch;
    if (!(law.rupture > 0.0))
      throw InputError{
          fmt::format("fence: cable '{}' is stretched by {:.6g}, at which it breaks", name, stretched.stretch)};
  }
  Cable cable{.name = name, .a = a, .b = b, .rest_length = rest_length, .law = law};
  cable.copies = full() ? 1 : 2;
  return builder_.add(cable);
}

/// The column at a place, changed or not.
ChangedColumn FenceMaker::column(int place) const {
  for (const ChangedColumn& changed : fence_.changed_columns) {
    if (changed.place == place + 1) return changed;
  }
  const FenceElement& e = fence_.column;
  return {place + 1, e.a, e.b, e.density, fence_.y_top, fence_.y_bottom};
}

/// A rock meets the columns within half their distance along the fence: one, or two when it comes between them. In the
/// half model these are the central ones.
bool FenceMaker::meets(const FenceElement& rock, const Column& column) const {
  if (!full()) return column.place == 0;
  return std::abs(rock.along - column.along) <= 0.5 * fence_.spacing * (1.0 + 1e-9);
}

void FenceMaker::add_member(int layer, const Column& column, const ChangedColumn& place, Vec2 position, double angle) {
  FenceElement own = fence_.column;
  own.a = place.a, own.b = place.b, own.density = place.density;
  const MassProperties solid = mass_properties(own);
  made_.members.push_back({.body = column.body,
                           .layer = layer,
                           .position = position,
                           .angle = angle,
                           .mass = solid.mass,
                           .inertia = solid.inertia});
}

void FenceMaker::add_layer(int layer) {
  const FenceElement& e = fence_.column;
  const double x = e.position.x - (layer - 1) * fence_.layer_spacing;
  const StaticShape shape = static_shape(fence_);
  if (layer == 1) made_.horizontal_tension = shape.horizontal_tension;
  const int count = columns_of_half(fence_);
  const double inner = even() ? 0.5 * fence_.spacing : 0.0;  // z of the first column
  layers_.emplace_back();
  std::vector<std::array<std::size_t, 2>> hung;  // in layers_.back(), of each place the column on either side
  for (int i = 0; i < count; ++i) {
    const ChangedColumn place = column(i);
    FenceElement own = e;
    own.a = place.a, own.b = place.b, own.density = place.density;
    Body made = body(own, "", fence_.options.contact);
    made.sleeps = made.mobility == Mobility::free;
    const bool centre = i == 0;
    // The terms of equal columns are written so that nothing is lost in their sum.
    const double lower = place.y_top == column(0).y_top ? 0.0 : column(0).y_top - place.y_top;
    made.p_WB = {x, e.position.y + shape.heights[static_cast<std::size_t>(i)] + lower};
    if (!full() && !(centre && (!even() || doubled()))) made.copies = 2;
    if (centre && doubled()) made.mass *= 2.0, made.inertia *= 2.0;
    hung.emplace_back();
    const int sides = full() && !(centre && !even()) ? 2 : 1;
    for (int side = 0; side < 2; ++side) {
      if (side < sides) {
        Column column{.number = fmt::format("{}{}", side == 1 ? "-" : "", i + 1)};
        column.along = (side == 1 ? -1 : 1) * (inner + i * fence_.spacing);
        column.mass = made.mass, column.inertia = made.inertia, column.copies = made.copies;
        column.place = i;
        column.struck = std::ranges::any_of(fence_.rocks, [&](const FenceElement& r) { return meets(r, column); });
        made.name = fmt::format("{}column{}", prefix(layer), column.number);
        column.body = builder_.add(made);
        layers_.back().push_back(column);
      }
      hung.back()[static_cast<std::size_t>(side)] = layers_.back().size() - 1;
    }
    add_member(layer, layers_.back()[hung.back()[0]], place, made.p_WB, made.angle);
  }
  const MassProperties solid = mass_properties(e);
  const Vec2 end{x, e.position.y + shape.heights.back()};
  made_.members.push_back({.layer = layer, .position = end, .mass = solid.mass, .inertia = solid.inertia});
  add_segments(layer, true, shape, hung);
  if (fence_.connections == 2) add_segments(layer, false, shape, hung);
  if (fence_.options.hanger_strength > 0.0) add_hangers(layer);
}

void FenceMaker::add_segments(int layer, bool top, const StaticShape& shape,
                              const std::vector<std::array<std::size_t, 2>>& hung) {
  const std::vector<Column>& columns = layers_.back();
  const auto joint = [&](std::size_t place, std::size_t hand) {
    const ChangedColumn own = column(static_cast<int>(place));
    const Column& at = columns[hung[place][hand]];
    return CableEnd{at.body, {0.0, top ? own.y_top : own.y_bottom, at.along}};
  };
  // Top joints stand where the cable does; bottom joints of equal columns rise as the top ones do.
  const auto drop = [&](std::size_t place) {
    const ChangedColumn own = column(static_cast<int>(place));
    return top ? 0.0 : (own.y_bottom - own.y_top) - (fence_.y_bottom - fence_.y_top);
  };
  const std::string stem = prefix(layer) + (top ? "top" : "bottom");
  // The bottom cable is double wrapped.
  const double stiffness = top ? fence_.young * fence_.area_top : 2.0 * fence_.young * fence_.area_bottom;
  const std::size_t count = hung.size();
  if (full() && even()) {
    // The segment between the central columns, straight across.
    const double d = fence_.spacing, k = stiffness / d;
    add_cable(stem + "0", joint(0, 1), joint(0, 0), k, top ? d - shape.horizontal_tension / k : d + fence_.slack, top);
  }
  const std::size_t first_member = made_.members.size() - count - 1;
  const Vec2 end = made_.members.back().position;
  const std::size_t segments = top || fence_.options.bottom_end == BottomEnd::anchored ? count : count - 1;
  for (std::size_t s = 0; s < segments; ++s) {
    const double last_drop = s + 1 < count ? drop(s + 1) : drop(0);
    const double rise = shape.heights[s + 1] - shape.heights[s] + (last_drop - drop(s));
    const double length = std::sqrt(shape.distances[s] * shape.distances[s] + rise * rise);
    const double k = stiffness / length;
    if (top && s == 0 && layer == 1) first_stiffness_ = k;
    const double rest = top ? length - shape.tensions[s] / k : length + fence_.slack;
    for (const int side : full() ? std::vector{1, -1} : std::vector{1}) {
      const std::size_t hand = side > 0 ? 0 : 1;
      const CableEnd a = joint(s, hand);
      const double local_y = top ? column(0).y_top : column(0).y_bottom;
      const CableEnd b = s + 1 < count ? joint(s + 1, hand)
                                       : CableEnd{{}, {end.x, end.y + local_y, a.p.z + side * shape.distances[s]}};
      const CableId id = add_cable(fmt::format("{}{}{}", stem, side < 0 ? "-" : "", s + 1), a, b, k, rest, top);
      FenceMember& member = made_.members[first_member + s];
      if (side > 0) (top ? member.top : member.bottom) = id;
    }
  }
}

void FenceMaker::add_hangers(int layer) {
  const std::size_t first_member = made_.members.size() - static_cast<std::size_t>(columns_of_half(fence_)) - 1;
  for (const Column& hung : layers_.back()) {
    const HangerId id = builder_.add(Hanger{.name = fmt::format("{}hanger{}", prefix(layer), hung.number),
                                            .body = hung.body,
                                            .p = {0.0, column(hung.place).y_top, hung.along},
                                            .strength = fence_.options.hanger_strength});
    if (hung.along >= 0.0) made_.members[first_member + static_cast<std::size_t>(hung.place)].hanger = id;
  }
}

/// k = factor m v^2/overlap^2: the spring that takes the energy of m at the speed of the impact within the overlap,
/// with the factors of 1993; c by Eq. 21 with the same mass, or with the one that the contact feels.
FenceContactLaw FenceMaker::contact_law(double mass, double factor, double overlap, double damped_mass) const {
  const double stiffness = factor * mass * speed_ * speed_ / (overlap * overlap);
  return {stiffness, damping(damping_ratio(fence_.restitution, fence_.options.end_rule), stiffness, damped_mass)};
}

Contact FenceMaker::contact(std::string name, BodyId a, BodyId b, FenceContactLaw law) const {
  Contact made{.name = std::move(name), .a = a, .b = b};
  made.law = LinearSpringDashpot{law.stiffness, law.damping, fence_.options.end_rule};
  if (fence_.friction > 0.0)
    made.friction = CoulombFriction{fence_.friction, fence_.options.shear_ratio * law.stiffness};
  if (fence_.options.contact != FenceContact::resultant) made.method = ContactMethod::nodes;
  return made;
}

/// Mass from which the dashpot of rock and column is made. What the contact feels: the rock hits along its centre line,
/// the column, which hangs free for as long as the impact takes, at the height of the rock.
double FenceMaker::damped_mass(std::size_t rock, const Column& column) const {
  if (fence_.options.calibration == FenceCalibration::particles) return reduced_mass(rock_masses_[rock], column.mass);
  const FenceMember& struck = *std::ranges::find_if(
      made_.members, [&](const FenceMember& m) { return m.body && m.layer > 0 && m.body == column.body; });
  const double arm = fence_.rocks[rock].position.y - struck.position.y;
  return effective_mass(ContactSide{rock_masses_[rock], {}, 0.0, false},
                        ContactSide{column.mass, column.inertia, arm, false});
}

void FenceMaker::add_rock_contacts(std::size_t i) {
  const FenceElement& rock = fence_.rocks[i];
  const std::string name = fence_.rocks.size() == 1 ? "rock" : fmt::format("rock{}", i + 1);
  const double overlap = fence_.rock_overlap > 0.0 ? fence_.rock_overlap : fence_.penetration * rock.a;
  bool first = i == 0;
  for (std::size_t layer = 0; layer < layers_.size(); ++layer) {
    for (const Column& column : layers_[layer]) {
      if (!meets(rock, column)) continue;
      const FenceContactLaw law =
          contact_law(reduced_mass(rock_masses_[i], column.mass), 1.0, overlap, damped_mass(i, column));
      Contact made = contact(fmt::format("{}-{}column{}", name, prefix(static_cast<int>(layer) + 1), column.number),
                             rocks_[i], column.body, law);
      made.nodes = {node_count(rock), node_count(fence_.column)};
      made.node_depth = node_depth(NodeDepth::side_face);
      made.copies = column.copies;
      builder_.add(made);
      if (first) made_.rock_column = law;
      first = false;
    }
  }
  // Factor 2 in place of 1, fitted to the one printed value.
  const FenceContactLaw on_ground = contact_law(rock_masses_[i], 2.0, fence_.penetration * rock.a, rock_masses_[i]);
  Contact made = contact(name + "-ground", rocks_[i], ground_, on_ground);
  made.nodes = {node_count(rock), 3};
  builder_.add(made);
  if (i == 0) made_.rock_ground = on_ground;
}

void FenceMaker::add_rock_pairs() {
  for (std::size_t i = 0; i < fence_.rocks.size(); ++i) {
    for (std::size_t j = i + 1; j < fence_.rocks.size(); ++j) {
      const FenceElement& one = fence_.rocks[i];
      const FenceElement& other = fence_.rocks[j];
      // Side by side along the fence they pass each other.
      if (one.along != other.along && std::abs(one.along - other.along) >= one.a + other.a) continue;
      const double overlap =
          fence_.rock_overlap > 0.0 ? fence_.rock_overlap : fence_.penetration * std::min(one.a, other.a);
      const double mass = reduced_mass(rock_masses_[i], rock_masses_[j]);
      Contact made = contact(fmt::format("rock{}-rock{}", i + 1, j + 1), rocks_[i], rocks_[j],
                             contact_law(mass, 1.0, overlap, mass));
      made.nodes = {node_count(one), node_count(other)};
      builder_.add(made);
    }
  }
}

void FenceMaker::add_column_pairs() {
  const double overlap = fence_.layer_overlap > 0.0 ? fence_.layer_overlap : fence_.penetration * fence_.column.a;
  bool first = true;
  for (std::size_t c = 0; c < layers_[0].size(); ++c) {
    const Column& front = layers_[0][c];
    if (!front.struck) continue;
    const double mass = 0.5 * front.mass;
    const FenceContactLaw law = contact_law(mass, 1.0, overlap, mass);
    Contact made = contact(fmt::format("column{0}-back_column{0}", front.number), front.body, layers_[1][c].body, law);
    made.nodes = {node_count(fence_.column), node_count(fence_.column)};
    made.node_depth = node_depth(NodeDepth::centroid_ray);
    made.copies = front.copies;
    builder_.add(made);
    if (first) made_.column_column = law;
    first = false;
  }
}

/// As the rocks on the ground: the overlap a share of the half-width.
void FenceMaker::add_columns_on_ground() {
  for (std::size_t layer = 0; layer < layers_.size(); ++layer) {
    for (const Column& column : layers_[layer]) {
      const FenceContactLaw law = contact_law(column.mass, 2.0, fence_.penetration * fence_.column.a, column.mass);
      Contact made = contact(fmt::format("{}column{}-ground", prefix(static_cast<int>(layer) + 1), column.number),
                             column.body, ground_, law);
      made.nodes = {node_count(fence_.column), 3};
      made.copies = column.copies;
      builder_.add(made);
    }
  }
}

void FenceMaker::add_contacts() {
  for (std::size_t i = 0; i < fence_.rocks.size(); ++i)
    add_rock_contacts(i);
  add_rock_pairs();
  if (fence_.layers == 2) add_column_pairs();
  if (fence_.options.column_ground == ColumnGround::contact) add_columns_on_ground();
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
  // Contacts have no place in it: a rock may touch the fence at the start.
  std::vector<Vec2> pulls(model.bodies.size());
  for (std::size_t j = 0; j < work.joints.size(); ++j) {
    const Joint& joint = dynamics.cables().joints()[j];
    if (joint.on_body) pulls[index(joint.body)] += work.joints[j].force;
  }
  for (const std::vector<Column>& layer : layers_) {
    for (const Column& column : layer) {
      Body& body = model.bodies[index(column.body)];
      if (body.mobility == Mobility::free) body.force += -pulls[index(column.body)] - body.mass * model.gravity;
    }
  }
  return model;
}

void FenceMaker::check_stretched() const {
  const Model model = builder_.build();
  std::vector<std::string> known;
  for (const Cable& cable : model.cables)
    known.push_back(cable.name);
  for (const StretchedCable& stretched : fence_.stretched_cables) {
    if (!find_cable(model, stretched.cable)) throw unknown_name("cable", stretched.cable, known);
  }
}

/// Columns where each side's stretched segments alone would let them hang: exact if both sides are stretched alike and
/// the bottom cable is slack, and near enough to go on from if not.
void FenceMaker::hang_sides(Model& model) const {
  const StaticShape shape = static_shape(fence_);
  const double end = fence_.column.position.y + shape.heights.back() + column(0).y_top;
  for (std::size_t layer = 0; layer < layers_.size(); ++layer) {
    std::vector<double> sums(model.bodies.size(), 0.0), sides(model.bodies.size(), 0.0);
    for (const int side : full() ? std::vector{1, -1} : std::vector{1}) {
      double joint = end;
      for (std::size_t s = shape.distances.size(); s-- > 0;) {
        const double across = shape.distances[s];
        const double load = shape.horizontal_tension * (shape.heights[s + 1] - shape.heights[s]) / across;
        const auto id = find_cable(
            model, fmt::format("{}top{}{}", prefix(static_cast<int>(layer) + 1), side < 0 ? "-" : "", s + 1));
        const Cable& cable = model.cables[index(*id)];
        joint -= rise_under(load, across, cable.rest_length, std::get<ElasticPlastic>(cable.law).stiffness);
        const std::size_t body = index(*cable.a.body);
        sums[body] += joint - column(static_cast<int>(s)).y_top;
        sides[body] += 1.0;
      }
    }
    for (std::size_t body = 0; body < model.bodies.size(); ++body) {
      if (sides[body] > 0.0) model.bodies[body].p_WB.y = sums[body] / sides[body];
    }
  }
}

/// The columns as they hang on stretched cables: heights at which weights and pulls balance, by Newton's method. The
/// stiffness matrix is symmetric and positive wherever the cables are taut.
Model FenceMaker::hung(Model model) {
  hang_sides(model);
  std::vector<std::size_t> bodies;
  for (const std::vector<Column>& layer : layers_) {
    for (const Column& column : layer) {
      if (has_y(model.bodies[index(column.body)].mobility)) bodies.push_back(index(column.body));
    }
  }
  const auto count = static_cast<Eigen::Index>(bodies.size());
  const auto forces = [&](const Model& at) {
    const Dynamics dynamics{at};
    State state = rest_state(at);
    Workspace work = dynamics.workspace();
    Rates rates{state};
    dynamics.update_all(state, work);
    dynamics.cables().settle(state, work);
    dynamics.cables().add(state, work, nullptr);
    Eigen::VectorXd sum(count);
    for (Eigen::Index i = 0; i < count; ++i) {
      const std::size_t body = bodies[static_cast<std::size_t>(i)];
      sum[i] = work.wrenches[body].force.y + at.bodies[body].mass * at.gravity.y;
    }
    return sum;
  };
  constexpr double nudge = 1e-7;
  for (int pass = 0; pass < 100; ++pass) {
    const Eigen::VectorXd residual = forces(model);
    if (residual.cwiseAbs().maxCoeff() < 1e-9 * column_weight()) break;
    Eigen::MatrixXd stiffness(count, count);
    for (Eigen::Index j = 0; j < count; ++j) {
      Model moved = model;
      moved.bodies[bodies[static_cast<std::size_t>(j)]].p_WB.y += nudge;
      stiffness.col(j) = (forces(moved) - residual) / nudge;
    }
    const Eigen::VectorXd step = stiffness.fullPivLu().solve(-residual);
    // A longer step than a tenth of the sag leaves the neighbourhood in which the cables are taut.
    const double share = std::min(1.0, 0.1 * fence_.sag / step.cwiseAbs().maxCoeff());
    for (Eigen::Index i = 0; i < count; ++i)
      model.bodies[bodies[static_cast<std::size_t>(i)]].p_WB.y += share * step[i];
  }
  if (!(forces(model).cwiseAbs().maxCoeff() < 1e-6 * column_weight()))
    throw InputError{"fence: the stretched cables leave the columns no place at which they hang in balance"};
  for (FenceMember& member : made_.members) {
    if (member.layer > 0 && member.body) member.position = model.bodies[index(*member.body)].p_WB;
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
  State apart = touching;
  std::fill_n(apart.mode.begin(), dynamics.contacts().size(), Mode{0});
  Rates with{state}, without{state};
  dynamics.rates(touching, work, with, false);
  dynamics.rates(apart, work, without, false);
  for (std::size_t i = 0; i < state.v.size(); ++i)
    state.v[i] += 0.5 * made_.scene.plan.step * (with.v[i] - without.v[i]);
}

}  // namespace

int columns_of_half(const Fence& fence) { return (fence.columns + 1) / 2; }

int element_count(const Fence& fence) {
  return 1 + static_cast<int>(fence.rocks.size()) + fence.layers * (columns_of_half(fence) + 1);
}

StaticShape static_shape(const Fence& fence) {
  const int count = columns_of_half(fence);
  const bool even = fence.columns % 2 == 0;
  const double mass = mass_properties(fence.column).mass;
  const double weight = mass * fence.gravity;
  StaticShape shape;
  // Loads inside the segments, in weights of a column: of an odd count half the central one is carried to each side.
  std::vector<double> loads;
  double reach = even ? 0.5 * fence.spacing : 0.0;
  double load = 0.0;
  for (int i = 0; i < count; ++i) {
    const double distance = i + 1 < count ? fence.spacing : 0.5 * fence.span - reach;
    if (distance <= 0.0) {
      throw InputError{fmt::format("fence: {} columns {} apart do not fit into half the span, {}", fence.columns,
                                   fence.spacing, 0.5 * fence.span)};
    }
    double own = 1.0;
    for (const ChangedColumn& changed : fence.changed_columns) {
      FenceElement other = fence.column;
      other.a = changed.a, other.b = changed.b, other.density = changed.density;
      if (changed.place == i + 1) own = mass_properties(other).mass / mass;
    }
    load += i == 0 && !even ? 0.5 * own : own;
    shape.distances.push_back(distance);
    loads.push_back(load);
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
