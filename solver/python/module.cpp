#include <fmt/format.h>
#include <pybind11/functional.h>
#include <pybind11/numpy.h>
#include <pybind11/pybind11.h>
#include <pybind11/stl.h>
#include <pybind11/stl/filesystem.h>

#include <algorithm>
#include <filesystem>
#include <limits>
#include <map>
#include <memory>
#include <nlohmann/json.hpp>

#include "solver/app/calibration/impact_calibration.hpp"
#include "solver/app/calibration/scene_calibration.hpp"
#include "solver/app/check/scene_check.hpp"
#include "solver/base/error.hpp"
#include "solver/integrate/integrator_list.hpp"
#include "solver/io/output/write_advice.hpp"
#include "solver/laws/latching_spring.hpp"
#include "solver/python/python_signals.hpp"
#include "solver/python/python_values.hpp"
#include "solver/python/script_run.hpp"
#include "solver/python/script_scene.hpp"
#include "solver/python/script_simulation.hpp"
#include "solver/python/script_sweep.hpp"
#include "solver/version/version.hpp"

namespace talus::python {
namespace {

namespace py = pybind11;
using namespace py::literals;

/// Raises the classes of talus/errors.py, which take the message apart. Arguments have the names of the options of the
/// commands, without their hyphens.
void translate(std::exception_ptr thrown) {
  const auto raise = [](const char* name, std::string message, const py::object& scene) {
    if (message.starts_with("--")) {
      message.erase(0, 2);
      std::replace(message.begin(), message.begin() + static_cast<long>(std::min(message.find(':'), message.size())),
                   '-', '_');
    }
    const py::object type = py::module_::import("talus.errors").attr(name);
    PyErr_SetObject(type.ptr(), type(message, scene).ptr());
  };
  try {
    if (thrown) std::rethrow_exception(thrown);
  } catch (const SceneInputError& error) {
    raise("InputError", error.what(), py::str(error.scene()));
  } catch (const InputError& error) {
    raise("InputError", error.what(), py::none());
  } catch (const IoError& error) {
    raise("IoError", error.what(), py::none());
  }
}

template <class Item>
std::vector<std::string> names_of(const std::vector<Item>& items) {
  std::vector<std::string> names;
  for (const Item& item : items)
    names.push_back(item.name);
  return names;
}

/// The table that a mapping is.
TomlTable table_of(const py::object& mapping, const char* name) {
  TomlValue made = to_document(mapping);
  auto* const table = std::get_if<TomlTable>(&made.data);
  if (table == nullptr) throw InputError{fmt::format("{}: found {}; it must be a dict", name, found(made))};
  return std::move(*table);
}

FieldValues fields_of(const py::object& changes) {
  FieldValues fields;
  for (TomlEntry& entry : table_of(changes, "fields"))
    fields.emplace_back(std::move(entry.key), std::move(entry.value));
  return fields;
}

/// An argument that is a text; empty if it is not given. Errors: InputError for a text that is empty.
std::string given(const char* name, const std::optional<std::string>& text) {
  if (text && text->empty()) throw InputError{fmt::format("{}: found \"\"; leave it out, or give a text", name)};
  return text.value_or("");
}

MethodArguments method_of(const std::optional<std::string>& end, const std::optional<std::string>& step,
                          const std::optional<std::string>& integrator, double tolerance) {
  return {given("end", end), given("step", step), given("integrator", integrator), tolerance};
}

// --- Scene ----------------------------------------------------------------------------------------

py::dict check(const ScriptScene& scene) {
  const Scene& checked = scene.file().scene;
  const Dynamics dynamics{checked.model};
  const app::SceneCheck found = [&] {
    const Unlocked unlocked;
    return app::check_scene(scene.file(), dynamics, "scene.run(integrator='auto')");
  }();
  py::dict result;
  result["usable"] = !found.is_unusable;
  result["warnings"] = found.warnings;
  result["integrator"] = py::str(name(checked.integrator));
  result["step"] = checked.plan.step;
  result["step_limit"] = found.limit ? py::object{py::float_(found.limit->step)} : py::none();
  result["shortest_contact"] = found.shortest_contact;
  result["highest_frequency"] = found.advice ? py::object{py::float_(found.advice->highest_frequency())} : py::none();
  py::list springs;
  if (found.advice) {
    for (const SpringAdvice& item : found.advice->springs) {
      springs.append(py::dict("name"_a = item.name, "contact"_a = item.contact, "stiffness"_a = item.spring.stiffness,
                              "damping"_a = item.spring.damping, "effective_mass"_a = item.spring.effective_mass,
                              "frequency"_a = item.frequency, "damping_ratio"_a = item.damping_ratio,
                              "contact_time"_a = item.contact_time));
    }
  }
  result["springs"] = springs;
  return result;
}

py::object advise(const ScriptScene& scene, const std::string& of, double accuracy,
                  const std::vector<std::string>& among, long evaluations, bool allow_warnings) {
  const Scene& advised = scene.file().scene;
  const Quantity quantity = quantity_named(advised.model, of);
  PythonSignals signals;
  struct Interrupted {};
  AdviceRules rules;
  rules.accuracy = accuracy, rules.among = among, rules.evaluations = evaluations;
  rules.allows_warnings = allow_warnings;
  rules.progress = [&](long) {
    if (signals.pending()) throw Interrupted{};
  };
  nlohmann::ordered_json json;
  try {
    const Unlocked unlocked;
    json = advice_json(advised, quantity, rules, advise_method(advised, quantity, rules));
  } catch (const Interrupted&) {
  }
  signals.rethrow();
  return to_python(json);
}

py::object calibrate_scene(const ScriptScene& scene, const std::string& contact, double restitution) {
  nlohmann::ordered_json json;
  {
    const Unlocked unlocked;
    json = app::scene_calibration(scene.file().scene, contact, restitution);
  }
  return to_python(json);
}

void bind_scene(py::module_& module) {
  py::class_<ScriptScene>(
      module, "Scene", "A scene: bodies, contacts, cables and a plan. It is never changed; changes make another one.")
      .def(py::init([](const py::object& document, const std::string& name) {
             return ScriptScene{TomlValue{table_of(document, "document")}, name};
           }),
           "document"_a, "name"_a = "scene",
           "Scene from a dict with the names and quantities of a scene file, e.g. {'body': [{'name': 'ball', 'mass': "
           "'2 kg', ...}], ...}. `name` is named in errors. Raises InputError with all errors.")
      .def_static(
          "read", [](const std::filesystem::path& file) { return read_script_scene(file.string()); }, "file"_a,
          "Scene from a scene file (.toml) or a deck of 1993 (.DAT). Raises IoError, InputError.")
      .def_static("parse", &parse_script_scene, "text"_a, "name"_a = "scene.toml",
                  "Scene from the text of a scene file. Raises InputError.")
      .def(
          "changed", [](const ScriptScene& scene, const py::object& fields) { return scene.with(fields_of(fields)); },
          "fields"_a,
          "Scene with other values of fields, by their paths as in a sweep: {'body.ball.mass': '3 kg', "
          "'gravity[1]': '-9.81 m/s^2'}. Raises InputError.")
      .def_property_readonly(
          "document", [](const ScriptScene& scene) { return to_python(scene.document()); },
          "The scene as a dict; of a deck of 1993, the scene file that it is converted to.")
      .def_property_readonly("name", &ScriptScene::name, "File or name of the scene, as in errors.")
      .def_property_readonly(
          "title", [](const ScriptScene& scene) { return scene.file().scene.title; }, "Title.")
      .def_property_readonly(
          "units", [](const ScriptScene& scene) { return std::string{scene.file().scene.model.units.name}; },
          "'SI' or 'US': the consistent units of all numbers of its runs.")
      .def_property_readonly(
          "integrator", [](const ScriptScene& scene) { return std::string{name(scene.file().scene.integrator)}; },
          "Name of the integrator.")
      .def_property_readonly(
          "step", [](const ScriptScene& scene) { return scene.file().scene.plan.step; }, "[T]")
      .def_property_readonly(
          "end", [](const ScriptScene& scene) { return scene.file().scene.plan.end; }, "[T]")
      .def_property_readonly(
          "bodies", [](const ScriptScene& scene) { return names_of(scene.file().scene.model.bodies); }, "Names.")
      .def_property_readonly(
          "contacts", [](const ScriptScene& scene) { return names_of(scene.file().scene.model.contacts); }, "Names.")
      .def_property_readonly(
          "cables", [](const ScriptScene& scene) { return names_of(scene.file().scene.model.cables); }, "Names.")
      .def(
          "run",
          [](const ScriptScene& scene, const std::optional<std::string>& end, const std::optional<std::string>& step,
             const std::optional<std::string>& integrator,
             double tolerance) { return run_scene(scene, method_of(end, step, integrator, tolerance)); },
          py::kw_only(), "end"_a = py::none(), "step"_a = py::none(), "integrator"_a = py::none(), "tolerance"_a = 0.0,
          "Runs the scene as `talus run` does, with the same bits. The arguments are its options: end and step are "
          "texts with units, e.g. '2 s'; step may be 'auto'. Other threads of Python continue meanwhile.")
      .def("check", &check,
           "What `talus check` finds before a run, as a dict: whether the results could be usable, warnings, step, the "
           "linear limit of the method, highest frequency [rad/T], shortest contact [T], and the springs.")
      .def("advise", &advise, "of"_a, py::kw_only(), "accuracy"_a, "among"_a = std::vector<std::string>{},
           "evaluations"_a = AdviceRules{}.evaluations, "allow_warnings"_a = false,
           "The cheapest integrator and step that give a quantity to a relative accuracy: the dict that `talus advise "
           "--json` prints, in SI units; it has 'advice', or 'refusal' with the reason.")
      .def("calibrate", &calibrate_scene, "contact"_a, py::kw_only(), "restitution"_a,
           "The damping (or hysteresis) of a contact that gives its first impact this restitution, by runs of the "
           "scene: the dict that `talus calibrate SCENE --json` prints, in SI units.")
      .def("__repr__",
           [](const ScriptScene& scene) {
             const Model& model = scene.file().scene.model;
             return fmt::format("<talus.Scene '{}': {} bodies, {} contacts, {} cables, {}>", scene.file().scene.title,
                                model.bodies.size(), model.contacts.size(), model.cables.size(),
                                name(scene.file().scene.integrator));
           })
      .def(
          py::pickle([](const ScriptScene& scene) { return py::make_tuple(to_python(scene.document()), scene.name()); },
                     [](const py::tuple& saved) {
                       return ScriptScene{to_document(saved[0]), py::cast<std::string>(saved[1])};
                     }));
}

// --- Run ------------------------------------------------------------------------------------------

std::size_t column_named(const ScriptRun& run, const std::string& name) {
  const auto found = std::ranges::find(run.columns, name);
  if (found == run.columns.end()) throw unknown_name("column", name, run.columns);
  return static_cast<std::size_t>(found - run.columns.begin());
}

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
      .def_property_readonly(
          "outcome", [](const ScriptRun& run) { return to_python(run.summary.at("outcome").at("kind")); },
          "'finished' or 'diverged'.")
      .def_readonly("warnings", &ScriptRun::warnings, "What the program would print as warnings.")
      .def_property_readonly(
          "usable", [](const ScriptRun& run) { return to_python(run.summary.at("quality").at("usable")); },
          "False if the results are NOT USABLE; summary['quality'] has the reason.")
      .def("__repr__",
           [](const ScriptRun& run) {
             return fmt::format("<talus.Run: {}, {} columns, {} rows>",
                                run.summary.at("outcome").at("kind").get<std::string>(), run.columns.size(),
                                run.rows());
           })
      .def(py::pickle(
          [](const ScriptRun& run) {
            return py::make_tuple(run.columns, run.units, py::array(py::cast(run.numbers)), run.summary.dump(),
                                  run.warnings);
          },
          [](const py::tuple& saved) {
            return ScriptRun{py::cast<std::vector<std::string>>(saved[0]), py::cast<std::vector<std::string>>(saved[1]),
                             py::cast<std::vector<double>>(saved[2]),
                             nlohmann::ordered_json::parse(py::cast<std::string>(saved[3])),
                             py::cast<std::vector<std::string>>(saved[4])};
          }));
}

// --- Simulation -----------------------------------------------------------------------------------

/// A property that is a view of numbers that a simulation holds.
template <class Numbers>
py::cpp_function viewed(Numbers numbers) {
  return py::cpp_function{[numbers](const py::object& self) {
    return view(std::span<const double>{numbers(py::cast<const ScriptSimulation&>(self).idle())}, self);
  }};
}
py::cpp_function pose_row(Row Poses::*row) {
  return viewed([row](const ScriptSimulation& run) {
    return std::span<const double>{(run.seen().geometry().poses.*row).at(0), run.model().bodies.size()};
  });
}

/// The simulation of a property, while no step is taken.
const ScriptSimulation& read(const ScriptSimulation& simulation) { return simulation.idle(); }

bool advance(ScriptSimulation& simulation, long steps) {
  if (steps < 0) throw InputError{fmt::format("steps: found {}; it must be >= 0", steps)};
  if (steps == 1) return simulation.advance(1);
  PythonSignals signals;
  bool continues = false;
  {
    const Unlocked unlocked;
    continues = simulation.advance(steps, [&] { return signals.pending(); });
  }
  signals.rethrow();
  return continues;
}

/// Calls back after each `every` steps and at the end; a callback that returns something false but None stops the run.
void run_simulation(const py::object& self, const py::object& callback, long every) {
  if (every < 1) throw InputError{fmt::format("every: found {}; it must be >= 1", every)};
  auto& simulation = py::cast<ScriptSimulation&>(self);
  if (callback.is_none()) return static_cast<void>(advance(simulation, std::numeric_limits<long>::max()));
  while (!simulation.idle().outcome()) {
    advance(simulation, every);
    const py::object answer = callback(self);
    if (answer.is_none()) continue;
    const int is_true = PyObject_IsTrue(answer.ptr());
    if (is_true < 0) throw py::error_already_set{};
    if (is_true == 0) return;
  }
}

py::dict energies(const ScriptSimulation& simulation) {
  const Energies& energies = read(simulation).seen().energies();
  py::dict found("kinetic"_a = energies.kinetic, "gravity"_a = energies.gravity, "applied"_a = energies.applied,
                 "contacts"_a = energies.contacts, "cables"_a = energies.cables, "total"_a = energies.total());
  const State& state = simulation.seen().state();
  for (std::size_t i = 0; i < mechanism_count; ++i)
    found[py::str(fmt::format("dissipated.{}", mechanism_names[i]))] = state.work[i];
  return found;
}

/// The run between two steps, as objects that pickle.
py::dict saved(const ScriptSimulation& simulation) {
  Archive archive;
  // Saving changes nothing; the same function restores.
  const_cast<ScriptSimulation&>(simulation).serialize(archive);
  py::dict items;
  for (const auto& [name, item] : archive.items())
    std::visit([&](const auto& value) { items[py::str(name)] = value; }, item);
  return items;
}

std::unique_ptr<ScriptSimulation> restored(const py::tuple& saved) {
  const auto arguments = py::cast<py::tuple>(saved[1]);
  auto simulation = std::make_unique<ScriptSimulation>(
      py::cast<const ScriptScene&>(saved[0]),
      MethodArguments{py::cast<std::string>(arguments[0]), py::cast<std::string>(arguments[1]),
                      py::cast<std::string>(arguments[2]), py::cast<double>(arguments[3])});
  ArchiveItems items;
  for (const auto& [name, item] : py::cast<py::dict>(saved[2])) {
    auto& kept = items[py::cast<std::string>(name)];
    if (py::isinstance<py::str>(item)) {
      kept = py::cast<std::string>(item);
    } else {
      kept = py::cast<std::vector<double>>(item);
    }
  }
  Archive archive{items};
  simulation->serialize(archive);
  if (!archive.left_over().empty()) throw InputError{"the saved simulation is of another version of Talus"};
  return simulation;
}

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
      .def("advance", &advance, "steps"_a = 1,
           "Takes up to `steps` steps. True while steps are left; False: the run has ended or diverged (`outcome`).")
      .def("run", &run_simulation, "callback"_a = py::none(), py::kw_only(), "every"_a = 1,
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
          "time", [](const ScriptSimulation& run) { return read(run).seen().state().t; }, "[T]")
      .def_property_readonly(
          "steps", [](const ScriptSimulation& run) { return read(run).run_state().step; }, "Steps done.")
      .def_property_readonly(
          "evaluations", [](const ScriptSimulation& run) { return read(run).run_state().evaluations; },
          "Force evaluations done.")
      .def_property_readonly(
          "outcome",
          [](const ScriptSimulation& run) -> py::object {
            if (!read(run).outcome()) return py::none();
            return py::str(*run.outcome() ? "finished" : "diverged");
          },
          "None while steps are left, then 'finished' or 'diverged'.")
      .def_property_readonly(
          "message",
          [](const ScriptSimulation& run) { return read(run).outcome() ? run.outcome()->message : std::string{}; },
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
          "q", viewed([](const ScriptSimulation& run) { return std::span{run.seen().state().q}; }),
          "Generalised coordinates [L or rad]: x, y and angle of the bodies, as far as they can move.")
      .def_property_readonly("v", viewed([](const ScriptSimulation& run) { return std::span{run.seen().state().v}; }),
                             "Their rates [1/T of q].")
      .def_property_readonly("x", pose_row(&Poses::x), "Centre of mass of each body [L].")
      .def_property_readonly("y", pose_row(&Poses::y), "Centre of mass of each body [L].")
      .def_property_readonly("vx", pose_row(&Poses::vx), "Velocity of the centre of mass of each body [L/T].")
      .def_property_readonly("vy", pose_row(&Poses::vy), "Velocity of the centre of mass of each body [L/T].")
      .def_property_readonly("spin", pose_row(&Poses::w),
                             "Angular velocity of each body [rad/T], counter-clockwise > 0.")
      .def_property_readonly(
          "angle", [](const ScriptSimulation& run) { return py::array(py::cast(read(run).angles())); },
          "Angle of each body [rad], counter-clockwise > 0.")
      .def_property_readonly("overlaps",
                             viewed([](const ScriptSimulation& run) { return std::span{run.seen().depths()}; }),
                             "Largest overlap of each contact [L]; negative while its bodies are apart.")
      .def_property_readonly(
          "contact_forces", viewed([](const ScriptSimulation& run) { return std::span{run.seen().forces().contacts}; }),
          "Normal force of each contact [F], > 0 pushes apart.")
      .def_property_readonly(
          "tensions", viewed([](const ScriptSimulation& run) { return std::span{run.seen().forces().tensions}; }),
          "Tension of each cable [F].")
      .def_property_readonly(
          "elongations", [](const ScriptSimulation& run) { return py::array(py::cast(read(run).elongations())); },
          "Elongation of each cable [L]; negative while slack.")
      .def_property_readonly("energies", &energies,
                             "Mechanical energy by its form, and energy dissipated by each mechanism [F L].")
      .def("__repr__",
           [](const ScriptSimulation& run) {
             return fmt::format("<talus.Simulation '{}': t = {:.6g} {}, {} steps>", run.scene().file().scene.title,
                                read(run).seen().state().t, symbol(run.model().units, dimension::time),
                                run.run_state().step);
           })
      .def(py::pickle(
          [](const ScriptSimulation& run) {
            const MethodArguments& method = run.arguments();
            return py::make_tuple(
                run.scene(), py::make_tuple(method.end, method.step, method.integrator, method.tolerance), saved(run));
          },
          &restored));
}

// --- Studies --------------------------------------------------------------------------------------

py::dict sweep(const ScriptScene& scene, const std::vector<py::object>& runs, const std::vector<std::string>& outputs,
               long threads, long evaluations, double time) {
  constexpr long maximum_threads = 1024;
  if (threads < 0 || threads > maximum_threads)
    throw InputError{fmt::format("threads: found {}; it must be between 0 and {}", threads, maximum_threads)};
  if (evaluations < 0) throw InputError{fmt::format("evaluations: found {}; it must be >= 0", evaluations)};
  if (!(time >= 0.0)) throw InputError{fmt::format("time: found {}; it must be >= 0", time)};
  std::vector<FieldValues> changes;
  for (const py::object& run : runs)
    changes.push_back(fields_of(run));
  const ScriptSweep swept = sweep_scene(scene, changes, {outputs, {time, evaluations}, static_cast<unsigned>(threads)});
  const auto count = static_cast<py::ssize_t>(runs.size());
  py::list ends, reasons, verdicts;
  py::array_t<double> times{count};
  py::array_t<std::int64_t> counts{count};
  std::vector<py::array_t<double>> values;
  for (std::size_t i = 0; i < swept.outputs.size(); ++i)
    values.emplace_back(count);
  for (std::size_t i = 0; i < swept.results.size(); ++i) {
    const app::SweepResult& result = swept.results[i];
    const auto row = static_cast<py::ssize_t>(i);
    ends.append(py::str(name_of(result.end))), reasons.append(result.reason), verdicts.append(result.verdict);
    times.mutable_at(row) = result.time, counts.mutable_at(row) = result.evaluations;
    for (std::size_t k = 0; k < values.size(); ++k)
      values[k].mutable_at(row) = result.values.empty() ? std::numeric_limits<double>::quiet_NaN() : result.values[k];
  }
  py::dict table("end"_a = ends, "reason"_a = reasons, "time"_a = times, "evaluations"_a = counts);
  if (swept.is_fence) table["verdict"] = verdicts;
  for (std::size_t k = 0; k < values.size(); ++k)
    table[py::str(swept.outputs[k])] = values[k];
  return table;
}

py::dict planned(const std::filesystem::path& file) {
  const PlannedSweep sweep = plan_sweep(file.string());
  py::list runs;
  for (const app::SweptRun& run : sweep.runs) {
    py::dict fields;
    for (const auto& [field, value] : run.parameters)
      fields[py::str(field)] = to_python(value);
    runs.append(fields);
  }
  return py::dict("scene"_a = sweep.base, "runs"_a = runs, "outputs"_a = sweep.outputs,
                  "evaluations"_a = sweep.limits.evaluations, "time"_a = sweep.limits.time);
}

py::object calibrate(std::optional<double> restitution, const std::vector<std::string>& masses, const std::string& law,
                     const std::map<std::string, std::string>& parameters, const std::optional<std::string>& dashpot,
                     const std::optional<std::string>& end_rule, const std::vector<std::string>& pivot,
                     const std::vector<std::string>& offset, const std::optional<std::string>& speed, double bound,
                     const std::string& integrator) {
  // The command line has the same limits.
  if (law == LatchingSpring::name)
    throw InputError{"law: latching_spring is calibrated at a step, by `talus calibrate --law latching_spring`"};
  if (masses.size() > 2)
    throw InputError{fmt::format("masses: found {}; it must be one or two, of body 1 and body 2", masses.size())};
  for (const auto& [name, given] : {std::pair{"pivot", &pivot}, std::pair{"offset", &offset}}) {
    if (!given->empty() && given->size() != 2)
      throw InputError{fmt::format("{}: found {} texts; it must be an inertia and an arm", name, given->size())};
  }
  if (!pivot.empty() && !offset.empty()) throw InputError{"pivot: found both pivot and offset; give one of the two"};
  app::CalibrateOptions options;
  for (const auto& [name, value] : parameters) {
    const auto found = options.parameters.find(name);
    if (found == options.parameters.end()) {
      std::vector<std::string> known;
      for (const auto& [parameter, none] : options.parameters)
        known.push_back(parameter);
      throw unknown_name("parameter", name, known);
    }
    found->second = value;
  }
  options.restitution = restitution, options.masses = masses, options.law = law;
  options.pivot = pivot, options.offset = offset, options.bound = bound, options.integrator = integrator;
  // Options that not every law has are refused only if they are given.
  const auto take = [&](const char* option, const std::optional<std::string>& value, std::string& into) {
    if (!value) return;
    options.own_to_impact.emplace_back(option);
    into = *value;
  };
  take("--dashpot", dashpot, options.dashpot);
  take("--end-rule", end_rule, options.end_rule);
  take("--speed", speed, options.speed);
  nlohmann::ordered_json json;
  {
    const Unlocked unlocked;
    json = app::impact_calibration(options);
  }
  return to_python(json);
}

void bind_studies(py::module_& module) {
  module.def(
      "sweep", &sweep, "scene"_a, "runs"_a, "outputs"_a, py::kw_only(), "threads"_a = 0L, "evaluations"_a = 0L,
      "time"_a = 0.0,
      "Runs a scene once for each dict of fields in `runs`, on threads (0: all of the machine), as `talus sweep` "
      "does. Returns a dict of columns, one value for each run: 'end' (finished, unusable, diverged, refused, "
      "limited), 'reason', 'time', 'evaluations', of a fence 'verdict', and the outputs in units of the scene, NaN "
      "if the run did not reach its end. Limits of each run: evaluations, and time of the clock [s]; 0: none.");
  module.def("read_sweep", &planned, "file"_a,
             "The file of a sweep as arguments of sweep(): talus.sweep(**talus.read_sweep('sweep.toml')) gives what "
             "`talus sweep` collects. Raises InputError, IoError.");
  module.def("calibrate", &calibrate, py::kw_only(), "restitution"_a = py::none(), "masses"_a, "law"_a, "parameters"_a,
             "dashpot"_a, "end_rule"_a, "pivot"_a, "offset"_a, "speed"_a, "bound"_a, "integrator"_a);
  module.def("integrators", &integrator_names, "Names of all integrators.");
}

}  // namespace

}  // namespace talus::python

PYBIND11_MODULE(_talus, module) {
  using namespace talus::python;
  module.doc() = "Discrete-element runs of scenes of rigid bodies, contacts and cables.";
  module.attr("__version__") = talus::version_number;
  pybind11::register_exception_translator(&translate);
  bind_scene(module);
  bind_run(module);
  bind_simulation(module);
  bind_studies(module);
  pybind11::module_::import("atexit").attr("register")(pybind11::cpp_function{&end_computations});
}
