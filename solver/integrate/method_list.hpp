#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <type_traits>
#include <utility>
#include <variant>
#include <vector>

#include "solver/base/error.hpp"

/// Lists of methods: variants whose alternatives have a static `name`.
namespace talus {

/// Calls visit(std::type_identity<Method>{}) for each method of a list, in order.
template <class List, class Visit>
void for_each_method(Visit&& visit) {
  [&]<std::size_t... I>(std::index_sequence<I...>) {
    (visit(std::type_identity<std::variant_alternative_t<I, List>>{}), ...);
  }
  (std::make_index_sequence<std::variant_size_v<List>>{});
}

/// Names of all methods, in the list's order.
template <class List>
std::vector<std::string> method_names() {
  std::vector<std::string> names;
  for_each_method<List>([&]<class Method>(std::type_identity<Method>) { names.emplace_back(Method::name); });
  return names;
}

/// Returns visit(std::type_identity<Method>{}) for the method with this name; the type must be the same for all
/// methods. `kind`: what a message calls the methods. Errors: InputError if the list has no method of that name.
template <class List, class Visit>
auto visit_method(std::string_view name, std::string_view kind, Visit&& visit) {
  using First = std::type_identity<std::variant_alternative_t<0, List>>;
  std::optional<std::decay_t<std::invoke_result_t<Visit, First>>> found;
  for_each_method<List>([&]<class Method>(std::type_identity<Method> type) {
    if (Method::name == name) found = visit(type);
  });
  if (!found) throw unknown_name(kind, name, method_names<List>());
  return *found;
}

}  // namespace talus
