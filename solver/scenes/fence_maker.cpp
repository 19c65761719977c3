#include "solver/scenes/fence_scene.hpp"

#include <cmath>
#include <numbers>

#include "solver/dynamics/dynamics.hpp"
#include "solver/scenes/fence_maker.hpp"

namespace talus::scenes {

FenceError::FenceError(FenceFault fault)
    : InputError{fmt::format("fence: {}{}: {}", fault.element > 0 ? fmt::format("element {}: ", fault.element) : "",
                             fault.field, fault.message)},
      fault_{std::move(fault)} {}

FenceMaker::FenceMaker(const Fence& fence) : fence_{fence}, builder_{fence.units} {
  builder_.gravity({0.0, fence.gravity_sign * fence.gravity});
  builder_.sleep(fence.options.sleep);
  for (const FenceElement& rock : fence.rocks)
    speed_ = std::max(speed_, norm(rock.velocity));
  if (speed_ == 0.0) {
    throw FenceError{{2, "velocity", "no rock moves; one must, since the contact stiffnesses follow from its speed"}};
  }
}

FenceScene FenceMaker::make() {
  if (fence_.options.hanger_strength > 0.0 && even() && !full()) {
    throw FenceError{
        {0, "options",
         "hanger_strength: the half model of an even count of columns omits the segment between the central ones, "
         "through which the cable continues when their hangers break; symmetry must be \"full\""}};
  }
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

void FenceMaker::add_ground() {
  const FenceElement& e = fence_.ground;
  if (e.held != std::array<bool, 3>{true, true, true})
    throw FenceError{{1, "held", "found a ground that can move; it must be held in x, y and rotation"}};
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

void FenceMaker::add_rocks() {
  for (std::size_t i = 0; i < fence_.rocks.size(); ++i) {
    const FenceElement& e = fence_.rocks[i];
    const std::string name = fence_.rocks.size() == 1 ? "rock" : fmt::format("rock{}", i + 1);
    const Body made = body(e, name, fence_.options.contact);
    rocks_.push_back(builder_.add(made));
    rock_masses_.push_back(made.mass);
    made_.members.push_back(
        {.body = rocks_.back(), .position = e.position, .angle = e.angle, .mass = made.mass, .inertia = made.inertia});
  }
}

void FenceMaker::plan() {
  const double central = made_.members[1 + fence_.rocks.size()].mass * (doubled() ? 2.0 : 1.0);
  made_.critical_step = 2.0 * std::numbers::pi * std::sqrt(central / (2.0 * first_stiffness_)) / 100.0;
  RunPlan& plan = made_.scene.plan;
  plan.step = fence_.step_factor == 0.0 ? made_.critical_step : fence_.step_factor * made_.critical_step;
  plan.end = static_cast<double>(fence_.steps) * plan.step;
  plan.interval = static_cast<double>(fence_.history_every) * plan.step;
  if (!(plan.step > 0.0 && std::isfinite(plan.end))) {
    throw FenceError{
        {0, "step_factor",
         fmt::format("the step is {:.3g} and the end {:.3g}; both must be finite and > 0. The critical step, "
                     "{:.3g}, follows from the masses of rock and column and the speed of the rock",
                     plan.step, plan.end, made_.critical_step)}};
  }
  plan.watch = fence_.options.watch;
  const IntegratorChoice chosen =
      choose_integrator(made_.scene.model, fence_.options.integrator, fence_.options.tolerance);
  made_.scene.integrator = chosen.integrator;
  made_.scene.integrator_reason = chosen.why;
  if (fence_.options.end == FenceEnd::exit) made_.scene.early_end = EarlyEnd{rocks_, fence_.options.exit_x, 0.0};
  if (fence_.options.end == FenceEnd::rest) made_.scene.early_end = EarlyEnd{rocks_, {}, 1e-3 * speed_};
}

/// Applies the initial contact forces alone for half a step. (Cables balance the weights; a rock's own weight is
/// excluded, as the printed fall of sample2's rock shows.)
void FenceMaker::kick_half_a_step() {
  const Dynamics dynamics{made_.scene.model};
  State& state = made_.scene.initial;
  Workspace work = dynamics.workspace();
  State touching = state;
  dynamics.update(touching, work);
  dynamics.begin(touching, work);
  State apart = touching;
  std::fill_n(apart.mode.begin(), dynamics.contacts().size(), Mode{0});
  Rates with{state}, without{state};
  dynamics.rates(touching, work, with, false);
  dynamics.update(apart, work);
  dynamics.rates(apart, work, without, false);
  for (std::size_t i = 0; i < state.v.size(); ++i)
    state.v[i] += 0.5 * made_.scene.plan.step * (with.v[i] - without.v[i]);
}

int columns_of_half(const Fence& fence) { return (fence.columns + 1) / 2; }

int element_count(const Fence& fence) {
  return 1 + static_cast<int>(fence.rocks.size()) + fence.layers * (columns_of_half(fence) + 1);
}

FenceScene fence_scene(const Fence& fence) { return FenceMaker{fence}.make(); }

FenceOptions current_options() {
  FenceOptions options;
  options.even_centre = EvenCentre::pair;
  options.contact = FenceContact::resultant;
  options.calibration = FenceCalibration::effective_mass;
  options.end_rule = EndRule::clamped;
  options.start = FenceStart::plain;
  options.integrator = automatic_integrator;
  options.tolerance = usual_tolerance;
  options.watch.quality = CheckAction::error;
  return options;
}

}  // namespace talus::scenes
