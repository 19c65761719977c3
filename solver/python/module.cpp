#include <pybind11/pybind11.h>

#include <algorithm>
#include <exception>
#include <string>

#include "solver/base/error.hpp"
#include "solver/python/bindings.hpp"
#include "solver/python/python_signals.hpp"
#include "solver/version/version.hpp"

namespace talus::python {
namespace {

namespace py = pybind11;

/// Raises the errors of talus/errors.py, which take the message apart. Arguments have the names of the options of the
/// commands, without their hyphens.
void translate(std::exception_ptr thrown) {
  const auto raise = [](const char* name, std::string message, const py::object& scene) {
    if (message.starts_with("--")) {
      message.erase(0, 2);
      std::replace(message.begin(), message.begin() + static_cast<long>(std::min(message.find(':'), message.size())),
                   '-', '_');
    }
    const py::object error = py::module_::import("talus.errors").attr(name)(message, scene);
    PyErr_SetObject(py::type::of(error).ptr(), error.ptr());
  };
  try {
    if (thrown) std::rethrow_exception(thrown);
  } catch (const SceneInputError& error) {
    raise("InputError", error.what(), py::str(error.scene()));
  } catch (const InputError& error) {
    raise("InputError", error.what(), py::none());
  } catch (const IoError& error) {
    raise("io_error", error.what(), py::none());
  }
}

}  // namespace
}  // namespace talus::python

PYBIND11_MODULE(_talus, module) {
  using namespace talus::python;
  module.doc() = "Discrete-element runs of scenes of rigid bodies, contacts and cables, and of shear cells of discs.";
  module.attr("__version__") = talus::version_number;
  pybind11::register_exception_translator(&translate);
  bind_run(module);  // before what returns runs, so that its signatures name them
  bind_scene(module);
  bind_cell(module);
  bind_simulation(module);
  bind_studies(module);
  pybind11::module_::import("atexit").attr("register")(pybind11::cpp_function{&end_computations});
}
