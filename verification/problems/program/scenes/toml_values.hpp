#pragma once

#include <optional>
#include <string>
#include <vector>

namespace talus::verification::problems {

/// A value of a scene, as written.
struct TomlValue {
  std::string key;               ///< tables and list positions included: "fence.rock[0].force[1]"
  std::optional<double> number;  ///< of a number or a quantity
  std::string text;              ///< unit of a quantity, or the text; empty for a pure number
};

/// All values of a TOML text, in alphabetic order of their keys. Throws toml::parse_error.
[[nodiscard]] std::vector<TomlValue> toml_values(const std::string& text);

}  // namespace talus::verification::problems
