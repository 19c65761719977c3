#include "solver/scenes/fence_summary.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <variant>

#include "solver/base/error.hpp"
#include "solver/scenes/fence_element.hpp"
#include "solver/state/state_archive.hpp"

namespace talus::scenes {
namespace {

Vec3 operator+(Vec3 a, Vec3 b) { return {a.x + b.x, a.y + b.y, a.z + b.z}; }

void add(ForceRecord& record, Vec3 force, Vec3& last, double time, double h) {
  // Evaluates the root only if needed. Different squares can have equal roots, so that magnitudes are compared again.
  if (dot(force, force) > dot(record.at_peak, record.at_peak)) {
    const double size = norm(force);
    if (size > record.peak) record.peak = size, record.peak_time = time, record.at_peak = force;
  }
  record.impulse = record.impulse + 0.5 * h * (last + force);
  last = force;
}

/// The tension at which a law stops being elastic; infinite if it never does.
double limit(const CableLaw& law) {
  const auto* plastic = std::get_if<ElasticPlastic>(&law);
  return plastic ? std::min(plastic->yield, plastic->strength) : std::numeric_limits<double>::infinity();
}

/// The item with the largest value, the first if there are several; nullptr for an empty list.
template <class Item, class Value>
const Item* largest(const std::vector<Item>& items, Value&& value) {
  const auto found = std::ranges::max_element(items, {}, value);
  return found == items.end() ? nullptr : &*found;
}

/// Position of a column from the centre outwards, read from its name: 3 for "back_column-3".
int column_number(const std::string& name) { return std::stoi(name.substr(name.find_first_of("123456789"))); }

/// Errors: InputError if the number in the checkpoint is not a verdict.
void serialize(Archive& archive, std::string_view name, Verdict& verdict) {
  constexpr long count = Names<Verdict>::list.size();
  long number = static_cast<long>(verdict);
  archive.count(name, number);
  if (number >= count) throw InputError{fmt::format("{}: found {}; it must be below {}", name, number, count)};
  verdict = static_cast<Verdict>(number);
}

void serialize(Archive& archive, ForceRecord& record) {
  archive.number("peak", record.peak);
  archive.number("peak_time", record.peak_time);
  archive.vector("at_peak", record.at_peak);
  archive.vector("impulse", record.impulse);
}

void serialize(Archive& archive, RockPassage& rock) {
  archive.flag("touched", rock.touched);
  archive.number("touch_time", rock.touch_time);
  archive.vector("approach_velocity", rock.approach_velocity);
  archive.number("approach_spin", rock.approach_spin);
  archive.number("approach_energy", rock.approach_energy);
  archive.flag("separated", rock.left);
  archive.number("exit_time", rock.exit_time);
  archive.vector("exit_velocity", rock.exit_velocity);
  archive.number("exit_spin", rock.exit_spin);
  archive.number("exit_energy", rock.exit_energy);
  archive.flag("turned", rock.turned);
  archive.number("braking_time", rock.braking_time);
  archive.number("travel", rock.travel);
  serialize(archive, "verdict", rock.verdict);
  archive.number("passed_time", rock.passed_time);
  archive.vector("end_velocity", rock.end_velocity);
  archive.number("end_energy", rock.end_energy);
  archive.number("highest", rock.highest);
  archive.number("distance", rock.distance);
}

void serialize(Archive& archive, LayerRecord::Height& height) {
  archive.number("start", height.start);
  archive.number("extreme", height.extreme);
  archive.number("extreme_time", height.extreme_time);
  archive.number("end", height.end);
}

/// Serializes each element in a separate scope, named by its index.
template <class List, class Visit>
void each(Archive& archive, std::string_view name, List& list, Visit&& visit) {
  for (std::size_t i = 0; i < list.size(); ++i)
    archive.scope(fmt::format("{}_{}", name, i), [&] { visit(list[i]); });
}

}  // namespace

Verdict FenceSummary::verdict() const {
  const auto less = [](const RockPassage& a, const RockPassage& b) { return a.verdict < b.verdict; };
  return rocks.empty() ? Verdict::undecided : std::ranges::max_element(rocks, less)->verdict;
}

const AnchorRecord* FenceSummary::largest_anchor() const {
  return largest(anchors, [](const AnchorRecord& anchor) { return anchor.force.peak; });
}
const SegmentRecord* FenceSummary::largest_segment() const {
  return largest(segments, [](const SegmentRecord& segment) { return segment.peak; });
}
const SegmentRecord* FenceSummary::closest_segment() const {
  return largest(segments, [](const SegmentRecord& segment) { return segment.margin(); });
}
const ColumnRecord* FenceSummary::largest_hanger() const {
  return largest(columns, [](const ColumnRecord& column) { return column.hanger.peak; });
}
const ColumnRecord* FenceSummary::closest_hanger() const {
  return largest(columns, [](const ColumnRecord& column) { return column.margin(); });
}

FenceMonitor::FenceMonitor(const Fence& fence, const FenceScene& made, const Dynamics& dynamics, FenceResults results)
    : fence_{&fence}, made_{&made}, dynamics_{&dynamics}, results_{results} {
  list_parts();
  list_positions();
  touch_x_.resize(rocks_.size());
  last_spin_.resize(rocks_.size());
  last_hanger_.resize(summary_.columns.size());
  last_anchor_.resize(summary_.anchors.size());
  last_tension_.resize(summary_.segments.size());
  summary_.layers.resize(static_cast<std::size_t>(fence.layers));
  summary_.start = summary_.at_travel = made.scene.initial;
  history_.columns = {{"time", dimension::time}};
  for (const RockPassage& rock : summary_.rocks) {
    history_.columns.push_back({rock.name + ".x", dimension::length});
    history_.columns.push_back({rock.name + ".y", dimension::length});
    history_.columns.push_back({rock.name + ".vx", dimension::velocity});
  }
  for (const char* force : {"hanger", "top", "bottom"})
    history_.columns.push_back({force, dimension::force});
}

/// Collects everything that does not move.
void FenceMonitor::list_positions() {
  const Model& model = dynamics_->model();
  const Body& ground = model.bodies[index(*made_->members.front().body)];
  const bool plane = !std::holds_alternative<Terrain>(ground.shape);
  const Pose pose{ground.p_WB, rotation(ground.angle), {}, 0.0};
  ground_ = {pose.p_WB, pose.R_WB * Vec2{0.0, 1.0}, plane ? nullptr : &ground, pose};
  of_layer_.resize(static_cast<std::size_t>(fence_->layers));
  const CableForces& cables = dynamics_->cables();
  const auto joint_at = [&](BodyId body, Vec2 p) {
    const std::vector<Joint>& joints = cables.joints();
    const auto found = std::ranges::find_if(
        joints, [&](const Joint& joint) { return joint.on_body && joint.body == body && joint.p == p; });
    cabled_ = cabled_ && found != joints.end();
    return ColumnJoint{index(body), p, static_cast<std::size_t>(found - joints.begin())};
  };
  for (std::size_t i = 0; i < summary_.columns.size(); ++i) {
    const BodyId body = summary_.columns[i].body;
    LayerJoints& layer = of_layer_[static_cast<std::size_t>(summary_.columns[i].layer - 1)];
    layer.top.push_back(joint_at(body, joints_[i][0]));
    layer.bottom.push_back(joint_at(body, joints_[i][1]));
    rest_x_.push_back(model.bodies[index(body)].p_WB.x);
  }
  for (const AnchorRecord& anchor : summary_.anchors) {
    std::vector<AnchoredCable>& listed = anchored_.emplace_back();
    for (std::size_t c = 0; c < cables.size(); ++c) {
      const auto [a, b] = cables.ends()[c];
      if (a != anchor.joint && b != anchor.joint) continue;
      listed.push_back({c, a == anchor.joint ? 1.0 : -1.0, cables.joints()[b].along - cables.joints()[a].along});
    }
  }
}

void FenceMonitor::add_column(const Joint& hanger, int layer) {
  const Model& model = dynamics_->model();
  double y_bottom = fence_->y_bottom, strength = std::numeric_limits<double>::infinity();
  for (const ChangedColumn& changed : fence_->changed_columns) {
    if (changed.number == column_number(model.bodies[index(hanger.body)].name)) y_bottom = changed.y_bottom;
  }
  for (const Hanger& breakable : model.hangers) {
    if (breakable.body == hanger.body) strength = breakable.strength;
  }
  summary_.columns.push_back({.body = hanger.body, .layer = layer, .limit = strength});
  joints_.push_back({hanger.p, Vec2{0.0, y_bottom}});
}

/// Lists rocks in the numbering of 1993; columns, segments and anchors in the order of the cables, so that both sides
/// of a full model are included. Segments begin at a column; names distinguish top and bottom.
void FenceMonitor::list_parts() {
  const Model& model = dynamics_->model();
  const CableForces& cables = dynamics_->cables();
  const auto layer_at = [&](double x) {
    const double behind = fence_->column.position.x - x;
    return fence_->layers == 1 ? 1 : 1 + static_cast<int>(std::lround(behind / fence_->layer_spacing));
  };
  for (std::size_t c = 0; c < model.cables.size(); ++c) {
    const auto [a, b] = cables.ends()[c];
    const bool top = model.cables[c].name.find("top") != std::string::npos;
    const int layer = layer_at(model.bodies[index(cables.joints()[a].body)].p_WB.x);
    summary_.segments.push_back(
        {.cable = static_cast<CableId>(c), .layer = layer, .top = top, .limit = limit(model.cables[c].law)});
    for (const std::size_t j : {a, b}) {
      const Joint& joint = cables.joints()[j];
      const auto listed = [j](const AnchorRecord& anchor) { return anchor.joint == j; };
      if (joint.on_body && top && std::find(hangers_.begin(), hangers_.end(), j) == hangers_.end()) {
        hangers_.push_back(j);
        add_column(joint, layer);
      }
      if (!joint.on_body && std::none_of(summary_.anchors.begin(), summary_.anchors.end(), listed))
        summary_.anchors.push_back({.joint = j, .layer = layer});
    }
  }
  const auto is_column = [&](BodyId body) {
    return std::any_of(summary_.columns.begin(), summary_.columns.end(),
                       [body](const ColumnRecord& column) { return column.body == body; });
  };
  for (std::size_t member = 1; made_->members[member].layer == 0; ++member) {
    const BodyId rock = *made_->members[member].body;
    rocks_.push_back(rock);
    summary_.rocks.push_back({.name = model.bodies[index(rock)].name, .mass = model.bodies[index(rock)].mass});
    auto& modes = touching_.emplace_back();
    auto& crossings = crossings_.emplace_back();
    for (std::size_t c = 0; c < model.contacts.size(); ++c) {
      const Contact& contact = model.contacts[c];
      if (!(contact.a == rock && is_column(contact.b)) && !(contact.b == rock && is_column(contact.a))) continue;
      const BodyId column = contact.a == rock ? contact.b : contact.a;
      const auto& columns = summary_.columns;
      const auto listed = std::ranges::find(columns, column, &ColumnRecord::body);
      crossings.push_back({.column = static_cast<std::size_t>(listed - columns.begin())});
      modes.push_back({dynamics_->layout().contact_slots[c].mode, dynamics_->layout().contact_instances[c]});
    }
  }
}

bool FenceMonitor::touches(std::size_t rock, const State& state) const {
  return std::any_of(touching_[rock].begin(), touching_[rock].end(),
                     [&](Modes modes) { return any_set(&state.mode[modes.first], modes.count); });
}

double FenceMonitor::kinetic(std::size_t rock, const State& state) const {
  const std::size_t body = index(rocks_[rock]);
  double energy = 0.0;
  for (std::size_t i = dynamics_->layout().first[body]; i < dynamics_->layout().first[body + 1]; ++i)
    energy += 0.5 * dynamics_->inertias()[i] * state.v[i] * state.v[i];
  return energy;
}

/// For a rock that touches from the start, the approach velocity is the one in the deck: the half kick has already
/// changed the state's velocity slightly.
void FenceMonitor::begin(const State& state) {
  started_ = true;
  time_ = state.t;
  summary_.start = summary_.at_travel = state;
  directions_.clear();
  for (std::size_t i = 0; i < rocks_.size(); ++i) {
    State given = state;
    set_velocity(dynamics_->model(), given, rocks_[i], fence_->rocks[i].velocity, fence_->rocks[i].spin);
    const Pose pose = talus::pose(dynamics_->model(), given, rocks_[i]);
    RockPassage& rock = summary_.rocks[i];
    rock.approach_velocity = pose.v_WB, rock.approach_spin = pose.w_WB, rock.approach_energy = kinetic(i, given);
    const Vec2 velocity = fence_->rocks[i].velocity;
    const double towards = fence_->column.position.x - fence_->rocks[i].position.x;
    directions_.push_back(std::copysign(1.0, velocity.x != 0.0 ? velocity.x : towards));
  }
}

void FenceMonitor::operator()(const Snapshot& snapshot, const StepInfo& info) {
  const State& state = snapshot.state();
  const bool first = !started_, all = results_ == FenceResults::all;
  now_ = all ? &snapshot.pulls() : &snapshot.geometry();
  forces_now_ = all ? &snapshot.forces() : nullptr;
  if (first) begin(state);
  watch_rocks(state);
  if (first || all) watch_heights(state);
  if (all) {
    watch_columns(state);
    watch_cables(state);
    watch_anchors(state);
    history_.proceed();
    if (info.due || info.stop) history_.add(row(state), info.due);
  }
  time_ = state.t;
}

bool FenceMonitor::anything_broken(const State& state) const {
  const auto& broken = now_->topology.broken;
  if (std::find(broken.begin(), broken.end(), true) != broken.end()) return true;
  const Model& model = dynamics_->model();
  for (std::size_t c = 0; c < model.cables.size(); ++c) {
    const Mode mode = state.mode[dynamics_->layout().cable_slots[c].mode];
    if (std::visit([mode]<class L>(const L&) { return is_broken<L>(mode); }, model.cables[c].law)) return true;
  }
  return false;
}

/// Call after the touch of this step has been detected.
void FenceMonitor::watch_passing(std::size_t i, const State& state) {
  RockPassage& rock = summary_.rocks[i];
  const Pose now = now_->poses[index(rocks_[i])];
  rock.end_velocity = now.v_WB, rock.end_energy = kinetic(i, state);
  rock.highest = std::max(rock.highest, ground_.height(now.p_WB));
  rock.distance = std::abs(now.p_WB.x - fence_->column.position.x);
  const double direction = directions_[i];
  bool all = !crossings_[i].empty();
  const Crossing* last = nullptr;
  for (Crossing& crossing : crossings_[i]) {
    const BodyId body = summary_.columns[crossing.column].body;
    const Pose column = now_->poses[index(body)];
    const double at_rest = dynamics_->model().bodies[index(body)].p_WB.x;
    const bool beyond = direction * (now.p_WB.x - column.p_WB.x) > 0.0 && direction * (now.p_WB.x - at_rest) > 0.0;
    // A rock that starts behind the fence has not passed it.
    if (beyond && !crossing.beyond && state.t > summary_.start.t) {
      crossing.time = state.t;
      crossing.how = rock.touched && anything_broken(state) ? Verdict::broke_through
                     : now.p_WB.y > column.p_WB.y           ? Verdict::passed_over
                                                            : Verdict::passed_under;
    }
    crossing.beyond = beyond;
    all = all && beyond;
    if (!last || crossing.time >= last->time) last = &crossing;
  }
  rock.passed_time = all ? last->time : 0.0;
  const double speed = direction * now.v_WB.x;
  // Below a hundredth of its approach speed the rock has at most a ten-thousandth of its energy.
  const bool still = rock.end_energy <= 1e-4 * rock.approach_energy;
  rock.verdict = all ? last->how : rock.touched && (speed <= 0.0 || still) ? Verdict::stopped : Verdict::undecided;
}

void FenceMonitor::watch_rocks(const State& state) {
  for (std::size_t i = 0; i < rocks_.size(); ++i) {
    RockPassage& rock = summary_.rocks[i];
    const Pose now = now_->poses[index(rocks_[i])];
    const bool touching = touches(i, state);
    if (touching && !rock.touched) {
      rock.touched = true;
      rock.touch_time = state.t;
      touch_x_[i] = now.p_WB.x;
      if (state.t > summary_.start.t) {
        rock.approach_velocity = rock.end_velocity, rock.approach_energy = rock.end_energy;
        rock.approach_spin = last_spin_[i];
      }
    }
    last_spin_[i] = now.w_WB;
    watch_passing(i, state);
    if (!rock.touched) continue;
    const double sign = rock.approach_velocity.x < 0.0 ? -1.0 : 1.0;
    const bool leaves = !touching && !rock.left;
    rock.left = !touching;
    if (!touching && !leaves) continue;
    rock.exit_time = state.t;
    rock.exit_velocity = now.v_WB, rock.exit_spin = now.w_WB, rock.exit_energy = rock.end_energy;
    rock.travel = std::max(rock.travel, sign * (now.p_WB.x - touch_x_[i]));
    if (rock.turned) continue;
    rock.turned = sign * now.v_WB.x <= 0.0;
    rock.braking_time = state.t - rock.touch_time;
  }
}

void FenceMonitor::watch_columns(const State& state) {
  const double h = state.t - time_, before = summary_.travel;
  const std::vector<char>& broken = now_->topology.broken;
  for (std::size_t i = 0; i < summary_.columns.size(); ++i) {
    ColumnRecord& column = summary_.columns[i];
    const Vec2 pull = !broken.empty() && broken[hangers_[i]] ? Vec2{} : now_->joints.force(hangers_[i]);
    add(column.hanger, {pull.x, pull.y, 0.0}, last_hanger_[i], state.t, h);
    const double travel = std::abs(now_->poses.x[index(column.body)] - rest_x_[i]);
    if (travel > column.travel) column.travel = travel, column.travel_time = state.t;
    summary_.travel = std::max(summary_.travel, travel);
  }
  if (summary_.travel > before) copy_numbers(state, summary_.at_travel);
}

void FenceMonitor::watch_cables(const State& state) {
  const double h = state.t - time_;
  for (std::size_t i = 0; i < summary_.segments.size(); ++i) {
    SegmentRecord& segment = summary_.segments[i];
    const double tension = forces_now_->tensions[index(segment.cable)];
    if (tension > segment.peak) segment.peak = tension, segment.peak_time = state.t;
    segment.impulse += 0.5 * h * (last_tension_[i] + tension);
    last_tension_[i] = tension;
  }
}

/// Each segment pulls its anchor towards the segment's other end, in 3-D.
void FenceMonitor::watch_anchors(const State& state) {
  const double h = state.t - time_;
  for (std::size_t i = 0; i < summary_.anchors.size(); ++i) {
    Vec3 force;
    for (const AnchoredCable& anchored : anchored_[i]) {
      const Vec2 pull = now_->paths.pull(anchored.cable);
      // Remaining component of the unit vector, not the joint's `along`: at a broken hanger the cable bypasses its
      // joint.
      const double along = std::copysign(std::sqrt(std::max(0.0, 1.0 - dot(pull, pull))), anchored.along);
      force = force + anchored.sign * forces_now_->tensions[anchored.cable] * Vec3{pull.x, pull.y, along};
    }
    add(summary_.anchors[i].force, force, last_anchor_[i], state.t, h);
  }
}

void FenceMonitor::watch_heights(const State& state) {
  const bool first = state.t == summary_.start.t;
  const JointPoints& joints = now_->joints;
  // At a broken hanger the cable is no longer at the column's joint.
  const bool by_cables = cabled_ && !ground_.body && now_->topology.free_joints.empty();
  const Vec2 p_W = ground_.p_W, up_W = ground_.up_W;
  for (std::size_t layer = 0; layer < summary_.layers.size(); ++layer) {
    const LayerJoints& of_columns = of_layer_[layer];
    double top = std::numeric_limits<double>::infinity(), bottom = -top;
    if (by_cables) {
      for (const ColumnJoint& at : of_columns.top)
        top = std::min(top, dot(joints.p_WP(at.joint) - p_W, up_W));
      for (const ColumnJoint& at : of_columns.bottom)
        bottom = std::max(bottom, dot(joints.p_WP(at.joint) - p_W, up_W));
    } else {
      for (const ColumnJoint& at : of_columns.top)
        top = std::min(top, ground_.height(world_point(now_->poses[at.body], at.p)));
      for (const ColumnJoint& at : of_columns.bottom)
        bottom = std::max(bottom, ground_.height(world_point(now_->poses[at.body], at.p)));
    }
    LayerRecord& record = summary_.layers[layer];
    if (first) record.top.start = top, record.bottom.start = bottom;
    if (first || top < record.top.extreme) record.top.extreme = top, record.top.extreme_time = state.t;
    if (first || bottom > record.bottom.extreme) record.bottom.extreme = bottom, record.bottom.extreme_time = state.t;
    record.top.end = top, record.bottom.end = bottom;
  }
}

std::vector<double> FenceMonitor::row(const State& state) const {
  std::vector<double> row{state.t};
  for (const BodyId rock : rocks_) {
    const Pose now = now_->poses[index(rock)];
    row.insert(row.end(), {now.p_WB.x, now.p_WB.y, now.v_WB.x});
  }
  double hanger = 0.0, top = 0.0, bottom = 0.0;
  for (const Vec3& force : last_hanger_)
    hanger = std::max(hanger, norm(force));
  for (std::size_t i = 0; i < summary_.segments.size(); ++i) {
    double& largest = summary_.segments[i].top ? top : bottom;
    largest = std::max(largest, last_tension_[i]);
  }
  row.insert(row.end(), {hanger, top, bottom});
  return row;
}

void FenceMonitor::serialize(Archive& archive) {
  FenceSummary& s = summary_;
  const auto force = [&archive](Vec3& value) { archive.vector("force", value); };
  archive.flag("started", started_);
  archive.number("time", time_);
  archive.numbers("touch_x", touch_x_);
  archive.numbers("last_spin", last_spin_);
  archive.numbers("last_tension", last_tension_);
  archive.list("directions", directions_);
  for (std::size_t i = 0; i < crossings_.size(); ++i) {
    each(archive, fmt::format("crossing_{}", i), crossings_[i], [&](Crossing& crossing) {
      archive.flag("beyond", crossing.beyond);
      scenes::serialize(archive, "how", crossing.how);
      archive.number("time", crossing.time);
    });
  }
  each(archive, "last_hanger", last_hanger_, force);
  each(archive, "last_anchor", last_anchor_, force);
  each(archive, "rock", s.rocks, [&](RockPassage& rock) { scenes::serialize(archive, rock); });
  each(archive, "column", s.columns, [&](ColumnRecord& column) {
    scenes::serialize(archive, column.hanger);
    archive.number("travel", column.travel);
    archive.number("travel_time", column.travel_time);
  });
  each(archive, "segment", s.segments, [&](SegmentRecord& segment) {
    archive.number("peak", segment.peak);
    archive.number("peak_time", segment.peak_time);
    archive.number("impulse", segment.impulse);
  });
  each(archive, "anchor", s.anchors, [&](AnchorRecord& anchor) { scenes::serialize(archive, anchor.force); });
  each(archive, "layer", s.layers, [&](LayerRecord& layer) {
    archive.scope("top", [&] { scenes::serialize(archive, layer.top); });
    archive.scope("bottom", [&] { scenes::serialize(archive, layer.bottom); });
  });
  archive.number("travel", s.travel);
  archive.scope("start", [&] { talus::serialize(archive, s.start); });
  archive.scope("at_travel", [&] { talus::serialize(archive, s.at_travel); });
  archive.scope("history", [&] { history_.serialize(archive); });
}

}  // namespace talus::scenes
