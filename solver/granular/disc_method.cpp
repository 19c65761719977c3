#include "solver/granular/disc_method.hpp"

#include <cmath>
#include <numbers>

#include "solver/integrate/method_list.hpp"

namespace talus {

std::vector<std::string> disc_method_names() { return method_names<DiscMethod>(); }

DiscMethod make_disc_method(std::string_view name) {
  return visit_method<DiscMethod>(name, "integrator of discs",
                                  []<class T>(std::type_identity<T>) { return DiscMethod{T{}}; });
}

const IntegratorTraits& traits(const DiscMethod& method) {
  return *std::visit([]<class T>(const T&) { return &traits_of<T>; }, method);
}

double stepped_restitution(const DiscMethod& method, double restitution, double loading_angle) {
  return restitution *
         std::exp(traits(method).amplitude_growth_rate * std::numbers::pi * loading_angle * (1.0 + 1.0 / restitution));
}

}  // namespace talus
