#include "solver/integrate/integrator_list.hpp"

#include <fmt/format.h>

#include <cmath>
#include <optional>

#include "solver/base/error.hpp"
#include "solver/integrate/hybrid_system.hpp"
#include "solver/integrate/method_list.hpp"

namespace talus {
namespace {

/// A system that any method can advance, only declared: all methods of the list are checked against it.
struct AnySystem {
  void drift(State& state, double h);
  void kick(State& state, double h);
  void update_modes(State& state);
  void evaluate(State& state, Rates& out);
  void derivative(const State& state, Rates& out);
};
template <class List>
constexpr bool all_fit = false;
template <class... I>
constexpr bool all_fit<std::variant<I...>> = (IntegratorFor<I, AnySystem> && ...);
static_assert(all_fit<Integrator::List>);

template <class T>
Integrator with_tolerance(T integrator, double tolerance) {
  constexpr bool is_required = T::step_control == StepControl::tolerance;
  if (!(tolerance >= 0.0) || !std::isfinite(tolerance)) {
    throw InputError{fmt::format("integrator '{}': tolerance is {}; it must be > 0{}", T::name, tolerance,
                                 is_required ? "" : ", or left out")};
  }
  if (tolerance != 0.0 && !takes_tolerance(T::step_control)) {
    throw InputError{
        fmt::format("integrator '{}': tolerance is {}; it has no step control, so leave it out", T::name, tolerance)};
  }
  if (tolerance == 0.0 && is_required) {
    throw InputError{
        fmt::format("integrator '{}': tolerance is missing; it has no fixed step and needs one > 0", T::name)};
  }
  if constexpr (takes_tolerance(T::step_control)) integrator.tolerance = tolerance;
  return integrator;
}

/// Returns visit's result for the integrator with this name. Errors: InputError if there is none.
template <class Visit>
auto visit_integrator(std::string_view name, Visit&& visit) {
  return visit_method<Integrator::List>(name, "integrator", visit);
}

}  // namespace

std::vector<std::string> integrator_names() { return method_names<Integrator::List>(); }

Integrator make_integrator(std::string_view name, double tolerance) {
  return visit_integrator(name, [&]<class T>(std::type_identity<T>) { return with_tolerance(T{}, tolerance); });
}

const IntegratorTraits& integrator_traits(std::string_view name) {
  return *visit_integrator(name, []<class T>(std::type_identity<T>) { return &traits_of<T>; });
}

bool needs_tolerance(std::string_view name) { return integrator_traits(name).step_control == StepControl::tolerance; }

bool needs_closed_form(std::string_view name) {
  return integrator_traits(name).step_control == StepControl::closed_form;
}

bool has_step_control(std::string_view name) { return takes_tolerance(integrator_traits(name).step_control); }

std::optional<double> linear_limit(std::string_view name, double damping_ratio) {
  const auto limit = integrator_traits(name).linear_limit;
  if (!limit) return std::nullopt;
  return limit(damping_ratio);
}

const IntegratorTraits& traits(const Integrator& integrator) {
  return *std::visit([]<class T>(const T&) { return &traits_of<T>; }, integrator);
}

std::string_view name(const Integrator& integrator) { return traits(integrator).name; }

int order(const Integrator& integrator) { return traits(integrator).order; }

double tolerance(const Integrator& integrator) {
  return std::visit(
      [](const auto& i) {
        if constexpr (requires { i.tolerance; }) return i.tolerance;
        return 0.0;
      },
      integrator);
}

bool chooses_steps(const Integrator& integrator) {
  return tolerance(integrator) > 0.0 || !has_fixed_steps(traits(integrator).step_control);
}

std::optional<long> located_events(const Integrator& integrator) {
  return std::visit(
      []<class T>(const T& i) -> std::optional<long> {
        if constexpr (NamesEvents<T>) return i.events();
        return std::nullopt;
      },
      integrator);
}

}  // namespace talus
