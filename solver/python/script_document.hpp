#pragma once

#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "solver/app/sweep/sweep_runs.hpp"
#include "solver/base/error.hpp"
#include "solver/io/file/toml_document.hpp"

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

/// What `read` returns; its errors get the name of the scene.
template <class Read>
auto of_scene(const std::string& name, Read&& read) {
  try {
    return read();
  } catch (const InputError& error) {
    throw SceneInputError{error.what(), name};
  }
}

/// The scene file of a script: the document, and the File that `read` makes of it. It is never changed.
template <class File, File (*read)(const TomlValue& document, const std::string& name)>
class ScriptDocument {
 public:
  /// `name` is named in errors. Errors: SceneInputError with all errors of the document.
  ScriptDocument(TomlValue document, std::string name)
      : document_{std::move(document)}, name_{std::move(name)}, file_{of_scene(name_, [&] {
          return read(document_, name_);
        })} {}
  /// From a text. Errors: SceneInputError.
  static ScriptDocument parse(const std::string& text, const std::string& name) {
    return {of_scene(name, [&] { return parse_toml(text, name); }), name};
  }

  /// The scene with other values of some fields, set in the document as a sweep does. Errors: InputError for a field
  /// that is not there, or given twice; SceneInputError for a wrong value.
  [[nodiscard]] ScriptDocument with(const FieldValues& fields) const {
    const app::SweptRun run{{}, fields};
    app::check_fields(document_, run);
    return {app::with_parameters(document_, run), name_};
  }

  const TomlValue& document() const { return document_; }
  const std::string& name() const { return name_; }
  const File& file() const { return file_; }

 private:
  TomlValue document_;
  std::string name_;
  File file_;
};

/// The text of the file of a scene, with which documents are read: of a deck of 1993 that of the scene file that it is
/// converted to. `where` names the field that gives the file, if one does. Errors: IoError; SceneInputError, also for
/// CNTRL.DAT, which has no units.
[[nodiscard]] std::string script_text(const std::string& file, std::string_view where = {});

}  // namespace talus::python
