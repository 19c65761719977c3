#pragma once

#include <string>
#include <utility>
#include <vector>

#include "solver/app/scene_request.hpp"
#include "solver/base/error.hpp"
#include "solver/io/file/toml_document.hpp"
#include "solver/io/scene/scene_file.hpp"

namespace talus::python {

/// An InputError of a scene, whose name begins each line of the message that has one.
class SceneInputError : public InputError {
 public:
  SceneInputError(const std::string& message, std::string scene) : InputError{message}, scene_{std::move(scene)} {}
  const std::string& scene() const { return scene_; }

 private:
  std::string scene_;
};

/// A field of a scene by its path, and a value for it.
using FieldValues = std::vector<std::pair<std::string, TomlValue>>;

/// A scene of a script: the document, and the scene that the reader makes of it. It is never changed.
class ScriptScene {
 public:
  /// `name` is named in errors. Errors: SceneInputError with all errors of the document.
  ScriptScene(TomlValue document, std::string name);

  /// The scene with other values of some fields, set in the document as a sweep does. Errors: InputError for a field
  /// that is not there; SceneInputError for a wrong value.
  [[nodiscard]] ScriptScene with(const FieldValues& fields) const;

  const TomlValue& document() const { return document_; }
  const std::string& name() const { return name_; }
  const SceneFile& file() const { return file_; }

 private:
  TomlValue document_;
  std::string name_;
  SceneFile file_;
};

/// A scene from a text. Errors: SceneInputError.
[[nodiscard]] ScriptScene parse_script_scene(const std::string& text, const std::string& name);

/// A scene or deck from a file. Errors: IoError; SceneInputError, also for a shear cell.
[[nodiscard]] ScriptScene read_script_scene(const std::string& file);

/// The file of a scene with the changes that these options of `talus run` make. Errors: InputError naming the option.
[[nodiscard]] SceneFile with_method(const ScriptScene& scene, const app::MethodOptions& options);

}  // namespace talus::python
