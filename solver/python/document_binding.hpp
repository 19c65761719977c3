#pragma once

#include <pybind11/pybind11.h>
#include <pybind11/stl.h>
#include <pybind11/stl/filesystem.h>

#include <filesystem>
#include <string>

#include "solver/python/bindings.hpp"
#include "solver/python/python_values.hpp"

namespace talus::python {

/// The class of a ScriptDocument: from dicts, texts and files, changed, pickled.
template <class Script>
pybind11::class_<Script> bind_document(pybind11::module_& module, const char* name, const char* description) {
  namespace py = pybind11;
  using namespace py::literals;
  py::class_<Script> bound{module, name, description};
  bound
      .def(py::init([](const py::object& document, const std::string& file) {
             return Script{document_of(document), file};
           }),
           "document"_a, "name"_a = "scene",
           "From a dict with the names and quantities of a scene file, e.g. {'title': 'Ball', 'run': {'step': '1 us', "
           "...}, ...}. `name` is named in errors. Raises InputError with all errors.")
      .def_static(
          "read",
          [](const std::filesystem::path& file) { return Script::parse(script_text(file.string()), file.string()); },
          "file"_a, "From a scene file (.toml); a Scene also from a deck of 1993 (.DAT). Raises IoError, InputError.")
      .def_static("parse", &Script::parse, "text"_a, "name"_a = "scene.toml",
                  "From the text of a scene file. Raises InputError.")
      .def(
          "changed", [](const Script& scene, const py::object& fields) { return scene.with(fields_of(fields)); },
          "fields"_a,
          "Another one, with other values of fields, by their paths as in a sweep: {'run.end': '3 s', "
          "'body.ball.mass': '3 kg'}, {'cell.seed': 2}. Raises InputError.")
      .def_property_readonly(
          "document", [](const Script& scene) { return to_python(scene.document()); },
          "The scene as a dict; of a deck of 1993, the scene file that it is converted to.")
      .def_property_readonly("name", &Script::name, "File or name of the scene, as in errors.")
      .def(py::pickle([](const Script& scene) { return py::make_tuple(to_python(scene.document()), scene.name()); },
                      [](const py::tuple& saved) {
                        return Script{to_document(saved[0]), py::cast<std::string>(saved[1])};
                      }));
  return bound;
}

}  // namespace talus::python
