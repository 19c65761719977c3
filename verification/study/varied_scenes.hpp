#pragma once

#include <string>
#include <vector>

/// Scene files as users write them, with what each is run for; all that a file may leave to its default is left out.
namespace talus::verification::problems {

struct VariedScene {
  std::string name;
  std::string quantity;  ///< as quantity_named() takes it; of fences none
  std::string text;      ///< TOML
};

/// Thirty scenes: bounces, pivots, friction, rows, cables, laws, outlines, mobilities.
[[nodiscard]] std::vector<VariedScene> varied_scenes();

/// Twenty fences, each the template of `talus new fence` with other fields.
[[nodiscard]] std::vector<VariedScene> varied_fences();

/// A fence whose rock hits two columns at once, as its half and as a whole.
[[nodiscard]] std::vector<VariedScene> even_fences();

}  // namespace talus::verification::problems
