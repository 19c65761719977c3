#include <fmt/format.h>
#include <pybind11/numpy.h>
#include <pybind11/stl.h>

#include <algorithm>
#include <memory>
#include <span>
#include <vector>

#include "solver/base/error.hpp"
#include "solver/python/advanced_run.hpp"
#include "solver/python/bindings.hpp"
#include "solver/python/document_binding.hpp"
#include "solver/python/python_values.hpp"
#include "solver/python/script_cell.hpp"

namespace talus::python {
namespace {

namespace py = pybind11;
using namespace py::literals;

/// The columns of a table by their names.
py::dict columns_of(const CellTable& table) {
  py::dict found;
  for (std::size_t column = 0; column < table.columns.size(); ++column) {
    py::array_t<double> numbers{static_cast<py::ssize_t>(table.rows())};
    for (std::size_t row = 0; row < table.rows(); ++row)
      numbers.mutable_at(static_cast<py::ssize_t>(row)) = table.numbers[row * table.columns.size() + column];
    found[py::str(table.columns[column].name)] = numbers;
  }
  return found;
}

std::string unit_of(const ScriptCellRun& run, const std::string& name) {
  std::vector<std::string> known;
  for (const CellTable& table : {cell_history(run.scene(), run.idle()), cell_profile(run.scene(), run.idle())}) {
    for (const CellTable::Column& column : table.columns) {
      if (column.name == name) return symbol(*run.scene().units, column.dimension);
      if (std::ranges::find(known, column.name) == known.end()) known.push_back(column.name);
    }
  }
  throw unknown_name("column", name, known);
}

/// The contacts that act: pairs of discs by their numbers from 0, and numbers of each.
py::dict contacts_of(const ScriptCellRun& run) {
  const std::vector<CellRun::ActingContact> contacts = run.idle().acting_contacts();
  const auto count = static_cast<py::ssize_t>(contacts.size());
  py::array_t<std::int64_t> pairs{{count, py::ssize_t{2}}};
  py::array_t<double> normals{{count, py::ssize_t{2}}}, overlaps{count}, forces{count}, friction{count};
  for (py::ssize_t i = 0; i < count; ++i) {
    const CellRun::ActingContact& contact = contacts[static_cast<std::size_t>(i)];
    pairs.mutable_at(i, 0) = static_cast<std::int64_t>(contact.a);
    pairs.mutable_at(i, 1) = static_cast<std::int64_t>(contact.b);
    normals.mutable_at(i, 0) = contact.n_ab.x, normals.mutable_at(i, 1) = contact.n_ab.y;
    overlaps.mutable_at(i) = contact.depth, forces.mutable_at(i) = contact.force;
    friction.mutable_at(i) = contact.friction;
  }
  return py::dict("discs"_a = pairs, "normal"_a = normals, "overlap"_a = overlaps, "force"_a = forces,
                  "friction"_a = friction);
}

/// The run of a cell to its end.
py::object run_cell(const ScriptCell& cell, const py::object& callback) {
  py::object run = py::cast(std::make_unique<ScriptCellRun>(cell));
  run_to_end<ScriptCellRun>(run, callback, 1);
  return run;
}

void bind_cell_run(py::module_& module) {
  py::class_<ScriptCellRun>(
      module, "CellRun",
      "The run of a shear cell, in the consistent units of the cell. It is advanced interval by interval, each with an "
      "output (`every` of the scene file). Arrays of discs are views: they hold what they show until the run advances.")
      .def(py::init([](const ScriptCell& cell) { return std::make_unique<ScriptCellRun>(cell); }), "cell"_a,
           "At the start of a cell.")
      .def(
          "advance", [](ScriptCellRun& run, long intervals) { return advance(run, intervals, "intervals"); },
          "intervals"_a = 1,
          "Advances to the end of this interval, or of several. True while intervals are left; False: the run has "
          "ended or failed (`outcome`).")
      .def("run", &run_to_end<ScriptCellRun>, "callback"_a = py::none(), py::kw_only(), "every"_a = 1,
           "Advances to the end, and calls callback(run) after each `every` intervals and at the end. A callback that "
           "returns False stops there.")
      .def_property_readonly("cell", &ScriptCellRun::cell, py::return_value_policy::reference_internal,
                             "The cell that was given.")
      .def_property_readonly(
          "time", [](const ScriptCellRun& run) { return run.discs().t; }, "[T]")
      .def_property_readonly(
          "steps", [](const ScriptCellRun& run) { return run.idle().steps(); }, "Steps done.")
      .def_property_readonly(
          "evaluations", [](const ScriptCellRun& run) { return run.idle().evaluations(); }, "Force evaluations done.")
      .def_property_readonly(
          "outcome",
          [](const ScriptCellRun& run) -> py::object {
            if (!run.has_ended()) return py::none();
            return py::str(run.idle().finished() ? "finished" : "diverged");
          },
          "None while intervals are left, then 'finished' or 'diverged'.")
      .def_property_readonly(
          "message", [](const ScriptCellRun& run) { return run.idle().failure(); }, "Why the run failed.")
      .def_property_readonly(
          "warnings", [](const ScriptCellRun& run) { return run.outcome().warnings; },
          "What the program would print as warnings at the end.")
      .def_property_readonly(
          "summary",
          [](const ScriptCellRun& run) { return to_python(cell_summary_json(run.scene(), run.idle(), run.outcome())); },
          "What `talus cell --json` prints, as a dict: groups, means with their errors, energies.")
      .def_property_readonly(
          "history", [](const ScriptCellRun& run) { return columns_of(cell_history(run.scene(), run.idle())); },
          "Means over each interval so far: a dict of columns, those of history.csv.")
      .def_property_readonly(
          "profile", [](const ScriptCellRun& run) { return columns_of(cell_profile(run.scene(), run.idle())); },
          "Means of the layers after the start-up: a dict of columns, those of profile.csv.")
      .def("unit", &unit_of, "column"_a,
           "Unit of a column of the history or the profile, e.g. 'N/m^2'. Raises InputError for an unknown column.")
      .def_property_readonly("x",
                             viewed<ScriptCellRun>([](const ScriptCellRun& run) { return std::span{run.discs().x}; }),
                             "Centre of each disc [L]; it may lie in a periodic image of the cell.")
      .def_property_readonly("y",
                             viewed<ScriptCellRun>([](const ScriptCellRun& run) { return std::span{run.discs().y}; }),
                             "Centre of each disc [L].")
      .def_property_readonly("vx",
                             viewed<ScriptCellRun>([](const ScriptCellRun& run) { return std::span{run.discs().vx}; }),
                             "Velocity of each disc [L/T].")
      .def_property_readonly("vy",
                             viewed<ScriptCellRun>([](const ScriptCellRun& run) { return std::span{run.discs().vy}; }),
                             "Velocity of each disc [L/T].")
      .def_property_readonly(
          "spin", viewed<ScriptCellRun>([](const ScriptCellRun& run) { return std::span{run.discs().spin}; }),
          "Angular velocity of each disc [rad/T], counter-clockwise > 0; empty without friction.")
      .def_property_readonly("radius", viewed<ScriptCellRun>([](const ScriptCellRun& run) {
                               return std::span{run.idle().start().shapes.radius};
                             }),
                             "Radius of each disc [L].")
      .def_property_readonly(
          "wall",
          [](const ScriptCellRun& run) {
            const std::vector<std::uint32_t>& walls = run.idle().start().shapes.wall;
            return py::array_t<std::uint32_t>{static_cast<py::ssize_t>(walls.size()), walls.data()};
          },
          "0 of a free disc, 1 of the base's discs, 2 of the block's.")
      .def_property_readonly(
          "contacts", &contacts_of,
          "Contacts that act, as a dict of arrays: 'discs' (two numbers from 0), 'normal' (unit vector from the first "
          "to the second), 'overlap' [L], 'force' along the normal and 'friction' [F], on the first disc along the "
          "normal turned counter-clockwise. They are those of the last evaluation of forces, with staggered methods "
          "half a step from the positions.")
      .def("__repr__",
           [](const ScriptCellRun& run) {
             return fmt::format("<talus.CellRun '{}': t = {:.6g} {}, {} steps>", run.scene().title, run.discs().t,
                                symbol(*run.scene().units, dimension::time), run.idle().steps());
           })
      .def(py::pickle([](ScriptCellRun& run) { return py::make_tuple(run.cell(), saved_run(run)); },
                      [](const py::tuple& saved) {
                        const auto& cell = py::cast<const ScriptCell&>(saved[0]);
                        return restored_run(std::make_unique<ScriptCellRun>(cell), saved[1]);
                      }));
}

}  // namespace

void bind_cell(py::module_& module) {
  bind_document<ScriptCell>(module, "Cell",
                            "A shear cell of discs and its plan. It is never changed; changes make another one.")
      .def_property_readonly(
          "title", [](const ScriptCell& cell) { return cell.file().title; }, "Title.")
      .def_property_readonly(
          "units", [](const ScriptCell& cell) { return std::string{cell.file().units->name}; },
          "'SI' or 'US': the consistent units of all numbers of its runs.")
      .def_property_readonly(
          "integrator", [](const ScriptCell& cell) { return cell.file().plan.integrator; }, "Name of the integrator.")
      .def_property_readonly(
          "step", [](const ScriptCell& cell) { return cell.file().plan.step; }, "[T]")
      .def_property_readonly(
          "every", [](const ScriptCell& cell) { return cell.file().plan.every; }, "Interval between outputs [T].")
      .def_property_readonly(
          "end", [](const ScriptCell& cell) { return cell.file().plan.end; }, "[T]")
      .def_property_readonly(
          "discs", [](const ScriptCell& cell) { return cell.file().cell.free_discs(); }, "Number of free discs.")
      .def("run", &run_cell, "callback"_a = py::none(),
           "Runs the cell as `talus cell` does, with the same bits, and returns the CellRun; see CellRun.run(). Other "
           "threads of Python continue meanwhile.")
      .def("__repr__", [](const ScriptCell& cell) {
        return fmt::format("<talus.Cell '{}': {} discs, {}>", cell.file().title, cell.file().cell.free_discs(),
                           cell.file().plan.integrator);
      });
  bind_cell_run(module);
}

}  // namespace talus::python
