#include "solver/granular/disc_method.hpp"

#include <cmath>
#include <numbers>
#include <optional>
#include <utility>

#include "solver/base/error.hpp"

namespace talus {
namespace {

/// Calls visit with each method of the list, in order.
template <class Visit, std::size_t... I>
void for_each(Visit&& visit, std::index_sequence<I...>) {
  (visit(std::variant_alternative_t<I, DiscMethod>{}), ...);
}

constexpr auto all = std::make_index_sequence<std::variant_size_v<DiscMethod>>{};

}  // namespace

std::vector<std::string> disc_method_names() {
  std::vector<std::string> names;
  for_each([&](const auto& method) { names.emplace_back(method.name); }, all);
  return names;
}

DiscMethod make_disc_method(std::string_view name) {
  std::optional<DiscMethod> found;
  for_each(
      [&](const auto& method) {
        if (method.name == name) found = method;
      },
      all);
  if (!found) throw unknown_name("integrator of discs", name, disc_method_names());
  return *found;
}

double swing_gain(std::string_view name) {
  if (name == EulerOf<Discs>::name) return 0.25;
  return name == TaylorOf<Discs>::name ? 0.125 : 0.0;
}

double stepped_restitution(std::string_view name, double restitution, double loading_angle) {
  return restitution * std::exp(swing_gain(name) * std::numbers::pi * loading_angle * (1.0 + 1.0 / restitution));
}

}  // namespace talus
