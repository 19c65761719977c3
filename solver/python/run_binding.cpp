#include "solver/python/bindings.hpp"

#include <fmt/format.h>
#include <pybind11/numpy.h>
#include <pybind11/stl.h>

#include <algorithm>
#include <span>
#include <vector>

#include "solver/base/error.hpp"
#include "solver/python/python_values.hpp"
#include "solver/python/script_run.hpp"

namespace talus::python {
namespace {

namespace py = pybind11;
using namespace py::literals;

std::size_t column_named(const ScriptRun& run, const std::string& name) {
  const auto found = std::ranges::find(run.columns, name);
  if (found == run.columns.end()) throw unknown_name("column", name, run.columns);
  return static_cast<std::size_t>(found - run.columns.begin());
}

}  // namespace

void bind_run(py::module_& module) {
  py::class_<ScriptRun>(module, "Run", "The results of a run, in the consistent units of its scene.")
      .def_readonly("columns", &ScriptRun::columns, "Names of the columns of the history; the first one is 'time'.")
      .def(
          "keys", [](const ScriptRun& run) { return run.columns; }, "The same, so that dict(run) has all columns.")
      .def("__iter__", [](const ScriptRun& run) { return py::iter(py::cast(run.columns)); })
      .def(
          "unit", [](const ScriptRun& run, const std::string& column) { return run.units[column_named(run, column)]; },
          "column"_a, "Unit of a column, e.g. 'ft/s'. Raises InputError for an unknown column, with the nearest one.")
      .def(
          "__getitem__",
          [](const py::object& self, const std::string& column) {
            const auto& run = py::cast<const ScriptRun&>(self);
            return view(std::span{run.numbers}.subspan(column_named(run, column) * run.rows(), run.rows()), self);
          },
          "column"_a, "A column of the history, e.g. run['rock.vx'], without a copy; it cannot be written.")
      .def("__contains__",
           [](const ScriptRun& run, const py::object& column) {
             return py::isinstance<py::str>(column) &&
                    std::ranges::find(run.columns, py::cast<std::string>(column)) != run.columns.end();
           })
      .def(
          "__len__", [](const ScriptRun& run) { return run.columns.size(); }, "Number of columns.")
      .def_property_readonly("rows", &ScriptRun::rows, "Number of rows of the history.")
      .def_property_readonly(
          "history",
          [](const py::object& self) {
            const auto& run = py::cast<const ScriptRun&>(self);
            const auto rows = static_cast<py::ssize_t>(run.rows());
            constexpr auto size = static_cast<py::ssize_t>(sizeof(double));
            py::array_t<double> array{
                {rows, static_cast<py::ssize_t>(run.columns.size())}, {size, size * rows}, run.numbers.data(), self};
            array.attr("setflags")("write"_a = false);
            return array;
          },
          "The history as an array of rows and columns, without a copy; it cannot be written.")
      .def_property_readonly(
          "summary", [](const ScriptRun& run) { return to_python(run.summary); },
          "What `talus run --json` prints, as a dict; without the second run of a fence and the command to resume.")
      .def_readonly("outcome", &ScriptRun::outcome, "'finished' or 'diverged'.")
      .def_readonly("warnings", &ScriptRun::warnings, "What the program would print as warnings.")
      .def_readonly("usable", &ScriptRun::usable,
                    "False if the results are NOT USABLE; summary['quality'] has the reason.")
      .def("__repr__",
           [](const ScriptRun& run) {
             return fmt::format("<talus.Run: {}, {} columns, {} rows>", run.outcome, run.columns.size(), run.rows());
           })
      .def(py::pickle(
          [](const ScriptRun& run) {
            return py::make_tuple(run.columns, run.units,
                                  py::array_t<double>{static_cast<py::ssize_t>(run.numbers.size()), run.numbers.data()},
                                  run.summary, run.outcome, run.usable, run.warnings);
          },
          [](const py::tuple& saved) {
            const auto numbers = py::cast<py::array_t<double>>(saved[2]);
            return ScriptRun{py::cast<std::vector<std::string>>(saved[0]),
                             py::cast<std::vector<std::string>>(saved[1]),
                             std::vector<double>(numbers.data(), numbers.data() + numbers.size()),
                             py::cast<std::string>(saved[3]),
                             py::cast<std::string>(saved[4]),
                             py::cast<bool>(saved[5]),
                             py::cast<std::vector<std::string>>(saved[6])};
          }));
}

}  // namespace talus::python
