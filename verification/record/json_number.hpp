#pragma once

#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <string>
#include <string_view>

namespace talus::records {

/// A number in JSON. JSON has no non-finite numbers: they become the texts "nan", "inf" and "-inf".
[[nodiscard]] nlohmann::ordered_json json_number(double value);

/// The non-finite number with that name; no value for any other text.
[[nodiscard]] std::optional<double> not_finite_named(std::string_view name);

/// The number that json_number() wrote; no value for anything else.
template <class Json>
[[nodiscard]] std::optional<double> number_of(const Json& value) {
  if (value.is_number()) return value.template get<double>();
  if (value.is_string()) return not_finite_named(value.template get_ref<const std::string&>());
  return {};
}

}  // namespace talus::records
