#pragma once

#include <algorithm>
#include <string_view>
#include <variant>

#include "solver/base/error.hpp"

namespace talus {

/// Sets the parameter called `name` of the held law, which must have it.
template <class... Laws>
void set_parameter(std::variant<Laws...>& held, std::string_view name, double value) {
  std::visit(
      [&]<class L>(L& law) {
        const auto fields = L::fields();
        const auto field = std::find_if(fields.begin(), fields.end(), [&](const auto& of) { return of.name == name; });
        TALUS_DEMAND(field != fields.end());
        law.*field->member = value;
      },
      held);
}

}  // namespace talus
