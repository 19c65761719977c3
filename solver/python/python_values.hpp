#pragma once

#include <pybind11/numpy.h>
#include <pybind11/pybind11.h>

#include <span>
#include <string>

#include "solver/base/archive.hpp"
#include "solver/io/file/toml_document.hpp"

/// The module `talus` for Python: scenes, runs and studies as objects of a script.
namespace talus::python {

/// A value of a scene file as Python objects: dict, list, str, float, int or bool.
[[nodiscard]] pybind11::object to_python(const TomlValue& value);
/// A text of JSON, likewise.
[[nodiscard]] pybind11::object to_python(const std::string& json);

/// A value of a scene file from Python objects: mappings, sequences, texts and numbers, also those of numpy. `path` is
/// named in errors. Errors: InputError for an object of another type, a key that is no text, or deeper nesting than any
/// scene has.
[[nodiscard]] TomlValue to_document(pybind11::handle value, const std::string& path = {}, int depth = 0);

/// The key of a dict. Errors: InputError if it is no text.
[[nodiscard]] std::string key_of(pybind11::handle key);

/// What was saved in an archive, as a dict that pickles.
[[nodiscard]] pybind11::dict to_python(const Archive& archive);
/// The items of such a dict, for an archive that restores them.
[[nodiscard]] ArchiveItems to_items(const pybind11::dict& saved);

/// Numbers that `owner` holds, as an array of numpy that cannot be written and is no copy.
[[nodiscard]] pybind11::array_t<double> view(std::span<const double> numbers, pybind11::handle owner);

}  // namespace talus::python
