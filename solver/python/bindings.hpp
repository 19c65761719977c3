#pragma once

#include <pybind11/pybind11.h>

#include <optional>
#include <string>

#include "solver/python/script_scene.hpp"

/// The classes and functions of the module, by its parts.
namespace talus::python {

void bind_scene(pybind11::module_& module);
void bind_cell(pybind11::module_& module);
void bind_run(pybind11::module_& module);
void bind_simulation(pybind11::module_& module);
/// Sweeps and calibrations.
void bind_studies(pybind11::module_& module);

/// The document that a mapping is. Errors: InputError for another object.
[[nodiscard]] TomlValue document_of(const pybind11::object& mapping);

/// Fields and their values of a mapping. Errors: InputError for another object.
[[nodiscard]] FieldValues fields_of(const pybind11::object& changes);

/// The method that the arguments of a run or a simulation describe. Errors: InputError for a text that is empty.
[[nodiscard]] app::MethodOptions method_of(const std::optional<std::string>& end,
                                           const std::optional<std::string>& step,
                                           const std::optional<std::string>& integrator, double tolerance);

}  // namespace talus::python
