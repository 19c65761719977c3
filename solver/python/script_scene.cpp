#include "solver/python/script_scene.hpp"

#include "solver/app/sweep/sweep_base.hpp"
#include "solver/io/file/toml_field.hpp"
#include "solver/io/scene/read_scene.hpp"

namespace talus::python {
namespace {

/// What `read` returns; its errors get the name of the scene.
template <class Read>
auto of_scene(const std::string& name, Read&& read) {
  try {
    return read();
  } catch (const InputError& error) {
    throw SceneInputError{error.what(), name};
  }
}

}  // namespace

ScriptScene::ScriptScene(TomlValue document, std::string name)
    : document_{std::move(document)}, name_{std::move(name)}, file_{of_scene(name_, [&] {
        return read_scene_file(document_, name_);
      })} {}

ScriptScene ScriptScene::with(const FieldValues& fields) const {
  TomlValue document = document_;
  for (const auto& [field, value] : fields)
    set_field(document, field, value);
  return {std::move(document), name_};
}

ScriptScene parse_script_scene(const std::string& text, const std::string& name) {
  return {of_scene(name, [&] { return parse_toml(text, name); }), name};
}

ScriptScene read_script_scene(const std::string& file) {
  return parse_script_scene(of_scene(file, [&] { return app::base_text(file); }), file);
}

SceneFile with_method(const ScriptScene& scene, const app::MethodOptions& options) {
  SceneFile file = scene.file();
  app::apply_options(options, file);
  check_step_count(file.scene.plan);
  return file;
}

}  // namespace talus::python
