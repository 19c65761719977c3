#include "solver/io/scene_file.hpp"

#include "solver/base/error.hpp"
#include "solver/io/dat_deck.hpp"
#include "solver/io/fence_file.hpp"
#include "solver/io/toml_document.hpp"
#include "solver/io/toml_scene.hpp"
#include "solver/scenes/fence_scene.hpp"

namespace talus {

Scene read_scene(const std::filesystem::path& file) {
  if (!is_deck(file)) return read_scene(read_text(file), file.string());
  const scenes::Fence fence = read_deck(file);
  try {
    return scenes::fence_scene(fence).scene;
  } catch (const InputError& error) {
    throw InputError{file.string() + ": " + error.what()};
  }
}

}  // namespace talus
