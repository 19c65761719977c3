#include "solver/scenes/scene.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "solver/base/error.hpp"
#include "solver/dynamics/closed_form.hpp"

namespace talus {

bool reached(const EarlyEnd& end, const Model& model, const State& state) {
  return std::all_of(end.bodies.begin(), end.bodies.end(), [&](BodyId body) {
    const Pose at = pose(model, state, body);
    return end.x ? at.p_WB.x < *end.x : norm(at.v_WB) < end.speed;
  });
}

std::vector<std::string> integrator_choices() {
  std::vector<std::string> names = integrator_names();
  names.emplace_back(automatic_integrator);
  return names;
}

void demand_closed_form(const Model& model, const Integrator& integrator) {
  const IntegratorTraits& of = traits(integrator);
  if (!needs_closed_form(of.name)) return;
  if (const auto obstacle = obstacle_to_closed_form(model))
    throw InputError{
        fmt::format("integrator '{}': the motion between events must be linear, but {}", of.name, *obstacle)};
}

IntegratorChoice choose_integrator(const Model& model, std::string_view name, double tolerance) {
  if (name != automatic_integrator) {
    const double given = tolerance == 0.0 && needs_tolerance(name) ? usual_tolerance : tolerance;
    IntegratorChoice named{make_integrator(name, given)};
    demand_closed_form(model, named.integrator);
    return named;
  }
  const auto obstacle = obstacle_to_closed_form(model);
  if (!obstacle) return {make_integrator(Exact::name), "all motion between events is linear"};
  return {make_integrator(StormerCowell::name, tolerance == 0.0 ? usual_tolerance : tolerance),
          *obstacle + ", so that there is no closed form"};
}

}  // namespace talus
