#include "solver/integrate/integrator_list.hpp"

#include <fmt/format.h>

#include <cmath>
#include <optional>
#include <type_traits>
#include <utility>

#include "solver/base/error.hpp"

namespace talus {
namespace {

constexpr std::size_t count = std::variant_size_v<Integrator>;

/// Calls visit with each alternative of the list, default-made, in order.
template <class Visit, std::size_t... I>
void for_each(Visit&& visit, std::index_sequence<I...>) {
  (visit(std::variant_alternative_t<I, Integrator>{}), ...);
}

template <class T>
constexpr bool has_step_control() {
  if constexpr (requires { T::has_step_control; }) return T::has_step_control;
  return false;
}

template <class T>
constexpr bool must_have_tolerance() {
  if constexpr (requires { T::needs_tolerance; }) return T::needs_tolerance;
  return false;
}

template <class T>
Integrator with_tolerance(T integrator, double tolerance) {
  if (!(tolerance >= 0.0) || !std::isfinite(tolerance)) {
    throw InputError{fmt::format("integrator '{}': tolerance is {}; it must be > 0{}", T::name, tolerance,
                                 must_have_tolerance<T>() ? "" : ", or left out")};
  }
  if (tolerance != 0.0 && !has_step_control<T>()) {
    throw InputError{fmt::format("integrator '{}' has no step control; its tolerance must be left out", T::name)};
  }
  if (tolerance == 0.0 && must_have_tolerance<T>()) {
    throw InputError{fmt::format("integrator '{}' has no fixed step; it needs a tolerance > 0", T::name)};
  }
  if constexpr (has_step_control<T>()) integrator.tolerance = tolerance;
  return integrator;
}

/// What visit says of the integrator of that name. Errors: InputError if there is none.
template <class Visit>
auto asked(std::string_view wanted, Visit&& visit) {
  std::optional<std::decay_t<decltype(visit(VelocityVerlet{}))>> found;
  for_each(
      [&](const auto& integrator) {
        if (integrator.name == wanted) found = visit(integrator);
      },
      std::make_index_sequence<count>{});
  if (!found) throw unknown_name("integrator", wanted, integrator_names());
  return *found;
}

}  // namespace

std::vector<std::string> integrator_names() {
  std::vector<std::string> names;
  for_each([&](const auto& integrator) { names.emplace_back(integrator.name); }, std::make_index_sequence<count>{});
  return names;
}

bool needs_tolerance(std::string_view wanted) {
  return asked(wanted, []<class T>(const T&) { return must_have_tolerance<T>(); });
}

bool needs_closed_form(std::string_view wanted) {
  return asked(wanted, []<class T>(const T&) {
    if constexpr (requires { T::needs_closed_form; }) return T::needs_closed_form;
    return false;
  });
}

bool has_step_control(std::string_view wanted) {
  return asked(wanted, []<class T>(const T&) { return has_step_control<T>(); });
}

Integrator make_integrator(std::string_view wanted, double tolerance) {
  return asked(wanted, [&](const auto& integrator) { return with_tolerance(integrator, tolerance); });
}

std::string_view name(const Integrator& integrator) {
  return std::visit([](const auto& i) { return i.name; }, integrator);
}

double tolerance(const Integrator& integrator) {
  return std::visit(
      [](const auto& i) {
        if constexpr (requires { i.tolerance; }) return i.tolerance;
        return 0.0;
      },
      integrator);
}

int order(const Integrator& integrator) {
  return std::visit([](const auto& i) { return i.order; }, integrator);
}

std::optional<long> located_events(const Integrator& integrator) {
  return std::visit(
      [](const auto& i) -> std::optional<long> {
        if constexpr (requires { i.events(); }) return i.events();
        return std::nullopt;
      },
      integrator);
}

}  // namespace talus
