#include "solver/python/bindings.hpp"

#include <fmt/format.h>
#include <pybind11/numpy.h>
#include <pybind11/stl.h>

#include <memory>
#include <span>
#include <vector>

#include "solver/base/error.hpp"
#include "solver/python/advanced_run.hpp"
#include "solver/python/python_values.hpp"
#include "solver/python/script_simulation.hpp"

namespace talus::python {
namespace {

namespace py = pybind11;
using namespace py::literals;

py::cpp_function pose_row(Row Poses::*row) {
  return viewed<ScriptSimulation>([row](const ScriptSimulation& run) {
    return std::span<const double>{(run.seen().geometry().poses.*row).at(0), run.model().bodies.size()};
  });
}

/// One step is too short to give up the interpreter's lock.
bool advance_simulation(ScriptSimulation& simulation, long steps) {
  return steps == 1 ? simulation.advance(simulation.begin(), 1) : advance(simulation, steps, "steps");
}

py::dict energies(const ScriptSimulation& simulation) {
  const Energies& energies = simulation.idle().seen().energies();
  py::dict found("kinetic"_a = energies.kinetic, "gravity"_a = energies.gravity, "applied"_a = energies.applied,
                 "contacts"_a = energies.contacts, "cables"_a = energies.cables, "total"_a = energies.total());
  const State& state = simulation.seen().state();
  for (std::size_t i = 0; i < mechanism_count; ++i)
    found[py::str(fmt::format("dissipated.{}", name_of(static_cast<Mechanism>(i))))] = state.work[i];
  return found;
}

std::unique_ptr<ScriptSimulation> restored(const py::tuple& saved) {
  const auto arguments = py::cast<py::tuple>(saved[1]);
  const app::MethodOptions method{py::cast<std::string>(arguments[0]), py::cast<std::string>(arguments[1]),
                                  py::cast<std::string>(arguments[2]), py::cast<double>(arguments[3])};
  return restored_run(std::make_unique<ScriptSimulation>(py::cast<const ScriptScene&>(saved[0]), method), saved[2]);
}

}  // namespace

void bind_simulation(py::module_& module) {
  py::class_<ScriptSimulation>(
      module, "Simulation",
      "A run that is advanced step by step: the same states as Scene.run(), without its checks and records. Arrays are "
      "views of the state: they hold what they show until the next step; copy() keeps it.")
      .def(py::init([](const ScriptScene& scene, const std::optional<std::string>& end,
                       const std::optional<std::string>& step, const std::optional<std::string>& integrator,
                       double tolerance) {
             return std::make_unique<ScriptSimulation>(scene, method_of(end, step, integrator, tolerance));
           }),
           "scene"_a, py::kw_only(), "end"_a = py::none(), "step"_a = py::none(), "integrator"_a = py::none(),
           "tolerance"_a = 0.0, "At the start of a scene; the other arguments are those of Scene.run().")
      .def("advance", &advance_simulation, "steps"_a = 1,
           "Takes up to `steps` steps. True while steps are left; False: the run has ended or diverged (`outcome`).")
      .def("run", &run_to_end<ScriptSimulation>, "callback"_a = py::none(), py::kw_only(), "every"_a = 1,
           "Advances to the end, and calls callback(simulation) after each `every` steps and at the end. A callback "
           "that "
           "returns False stops there.")
      .def("restart", &ScriptSimulation::restart, py::kw_only(), "q"_a = py::none(), "v"_a = py::none(),
           "Back to the time of the start, with other coordinates [L or rad] and velocities if they are given. Raises "
           "InputError for lists of another length, or numbers that are not finite.")
      .def_property_readonly("scene", &ScriptSimulation::scene, py::return_value_policy::reference_internal,
                             "The scene that was given; the other arguments do not change it.")
      .def_property_readonly(
          "step", [](const ScriptSimulation& run) { return run.plan().step; }, "[T]")
      .def_property_readonly(
          "end", [](const ScriptSimulation& run) { return run.plan().end; }, "[T]")
      .def_property_readonly(
          "time", [](const ScriptSimulation& run) { return run.idle().seen().state().t; }, "[T]")
      .def_property_readonly(
          "steps", [](const ScriptSimulation& run) { return run.idle().run_state().step; }, "Steps done.")
      .def_property_readonly(
          "evaluations", [](const ScriptSimulation& run) { return run.idle().run_state().evaluations; },
          "Force evaluations done.")
      .def_property_readonly(
          "outcome",
          [](const ScriptSimulation& run) -> py::object {
            if (!run.idle().outcome()) return py::none();
            return py::str(*run.outcome() ? "finished" : "diverged");
          },
          "None while steps are left, then 'finished' or 'diverged'.")
      .def_property_readonly(
          "message",
          [](const ScriptSimulation& run) { return run.idle().outcome() ? run.outcome()->message : std::string{}; },
          "Why the run diverged.")
      .def_property_readonly(
          "coordinates",
          [](const ScriptSimulation& run) {
            std::vector<std::string> names;
            for (const Coordinate& coordinate : run.dynamics().layout().coordinates)
              names.push_back(name(run.model(), coordinate));
            return names;
          },
          "Names of the coordinates, e.g. 'rock.x'.")
      .def_property_readonly(
          "q", viewed<ScriptSimulation>([](const ScriptSimulation& run) { return std::span{run.seen().state().q}; }),
          "Generalised coordinates [L or rad]: x, y and angle of the bodies, as far as they can move.")
      .def_property_readonly(
          "v", viewed<ScriptSimulation>([](const ScriptSimulation& run) { return std::span{run.seen().state().v}; }),
          "Their rates [1/T of q].")
      .def_property_readonly("x", pose_row(&Poses::x), "Centre of mass of each body [L].")
      .def_property_readonly("y", pose_row(&Poses::y), "Centre of mass of each body [L].")
      .def_property_readonly("vx", pose_row(&Poses::vx), "Velocity of the centre of mass of each body [L/T].")
      .def_property_readonly("vy", pose_row(&Poses::vy), "Velocity of the centre of mass of each body [L/T].")
      .def_property_readonly("spin", pose_row(&Poses::w),
                             "Angular velocity of each body [rad/T], counter-clockwise > 0.")
      .def_property_readonly(
          "angle", [](const ScriptSimulation& run) { return py::array(py::cast(run.idle().angles())); },
          "Angle of each body [rad], counter-clockwise > 0.")
      .def_property_readonly("overlaps", viewed<ScriptSimulation>([](const ScriptSimulation& run) {
                               return std::span{run.seen().depths()};
                             }),
                             "Largest overlap of each contact [L]; negative while its bodies are apart.")
      .def_property_readonly("contact_forces", viewed<ScriptSimulation>([](const ScriptSimulation& run) {
                               return std::span{run.seen().forces().contacts};
                             }),
                             "Normal force of each contact [F], > 0 pushes apart.")
      .def_property_readonly("tensions", viewed<ScriptSimulation>([](const ScriptSimulation& run) {
                               return std::span{run.seen().forces().tensions};
                             }),
                             "Tension of each cable [F].")
      .def_property_readonly(
          "elongations", [](const ScriptSimulation& run) { return py::array(py::cast(run.idle().elongations())); },
          "Elongation of each cable [L]; negative while slack.")
      .def_property_readonly("energies", &energies,
                             "Mechanical energy by its form, and energy dissipated by each mechanism [F L].")
      .def("__repr__",
           [](const ScriptSimulation& run) {
             return fmt::format("<talus.Simulation '{}': t = {:.6g} {}, {} steps>", run.scene().file().scene.title,
                                run.idle().seen().state().t, symbol(run.model().units, dimension::time),
                                run.run_state().step);
           })
      .def(py::pickle(
          [](ScriptSimulation& run) {
            const app::MethodOptions& method = run.method();
            return py::make_tuple(run.scene(),
                                  py::make_tuple(method.end, method.step, method.integrator, method.tolerance),
                                  saved_run(run));
          },
          &restored));
}

}  // namespace talus::python
