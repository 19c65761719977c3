#include "solver/python/script_scene.hpp"

#include "solver/app/sweep/sweep_base.hpp"
#include "solver/io/cell/read_cell.hpp"
#include "solver/io/scene/read_scene.hpp"

namespace talus::python {

std::string script_text(const std::string& file, std::string_view where) {
  return of_scene(file, [&] { return app::base_text(file, where); });
}

SceneFile read_scene_document(const TomlValue& document, const std::string& name) {
  if (describes_cell(document)) throw InputError{name + ": cell: this is a shear cell; use talus.Cell"};
  return read_scene_file(document, name);
}

SceneFile with_method(const ScriptScene& scene, const app::MethodOptions& options) {
  SceneFile file = scene.file();
  app::apply_options(options, file);
  check_step_count(file.scene.plan);
  return file;
}

}  // namespace talus::python
