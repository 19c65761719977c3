#pragma once

#include <string>
#include <vector>

/// Scene files as users write them, with the quantity of interest of each; fields with defaults are omitted.
namespace talus::verification::problems {

struct VariedScene {
  std::string name;
  std::string quantity;  ///< as accepted by quantity_named(); empty for fences
  std::string text;      ///< TOML
};

/// Thirty scenes: bounces, pivots, friction, rows, cables, laws, outlines, mobilities.
[[nodiscard]] std::vector<VariedScene> varied_scenes();

/// Twenty fences, each the template of `talus new fence` with other fields.
[[nodiscard]] std::vector<VariedScene> varied_fences();

/// A fence whose rock hits two columns at once, as a half model and as a whole.
[[nodiscard]] std::vector<VariedScene> even_fences();

}  // namespace talus::verification::problems
