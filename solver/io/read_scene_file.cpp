#include "solver/io/read_scene_file.hpp"

#include "solver/base/error.hpp"
#include "solver/io/cell/read_cell.hpp"
#include "solver/io/fence1993/read_deck.hpp"
#include "solver/io/fence_file.hpp"
#include "solver/io/file/shown_title.hpp"
#include "solver/io/file/toml_document.hpp"
#include "solver/io/scene/read_scene.hpp"

namespace talus {

SceneFile read_scene_file(const std::filesystem::path& file) { return read_scene_text(read_text(file), file); }

SceneFile read_scene_text(std::string_view text, const std::filesystem::path& file) {
  if (!is_deck(file)) return read_scene_file(text, file.string());
  if (describes_cell(text, file)) throw InputError{file.string() + ": a shear cell is run by `talus cell`"};
  const scenes::Fence fence = read_deck(text, file.string());
  const scenes::FenceScene made = deck_scene(fence, text, file.string());
  SceneFile read{made.scene, FenceInput{fence, made}};
  read.scene.title = shown_title(fence.title, file);
  return read;
}

Scene read_scene(const std::filesystem::path& file) { return read_scene_file(file).scene; }

}  // namespace talus
