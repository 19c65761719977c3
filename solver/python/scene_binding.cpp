#include "solver/python/bindings.hpp"

#include <fmt/format.h>
#include <pybind11/stl.h>

#include <nlohmann/json.hpp>
#include <utility>
#include <variant>
#include <vector>

#include "solver/app/calibration/scene_calibration.hpp"
#include "solver/app/check/scene_check.hpp"
#include "solver/base/error.hpp"
#include "solver/integrate/integrator_list.hpp"
#include "solver/io/output/write_advice.hpp"
#include "solver/python/document_binding.hpp"
#include "solver/python/python_signals.hpp"
#include "solver/python/python_values.hpp"
#include "solver/python/script_run.hpp"

namespace talus::python {
namespace {

namespace py = pybind11;
using namespace py::literals;

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

/// An argument that is a text; empty if it is not given. Errors: InputError for a text that is empty.
std::string given(const char* name, const std::optional<std::string>& text) {
  if (text && text->empty()) throw InputError{fmt::format("{}: found \"\"; leave it out, or give a text", name)};
  return text.value_or("");
}

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

/// The JSON of a search that calls `progress` now and then, without the interpreter's lock; Ctrl-C raises
/// KeyboardInterrupt.
template <class Search>
py::object searched(Search&& search) {
  PythonSignals signals;
  struct Interrupted {};
  const auto progress = [&] {
    if (signals.pending()) throw Interrupted{};
  };
  nlohmann::ordered_json json;
  try {
    const Unlocked unlocked;
    json = search(progress);
  } catch (const Interrupted&) {
  }
  signals.rethrow();
  return to_python(json.dump());
}

py::object advise(const ScriptScene& scene, const std::string& of, double accuracy,
                  const std::vector<std::string>& among, long evaluations, bool allow_warnings) {
  const Scene& advised = scene.file().scene;
  const Quantity quantity = quantity_named(advised.model, of);
  AdviceRules rules;
  rules.accuracy = accuracy, rules.among = among, rules.evaluations = evaluations;
  rules.allows_warnings = allow_warnings;
  return searched([&](const auto& progress) {
    rules.progress = [&](long) { progress(); };
    return advice_json(advised, quantity, rules, advise_method(advised, quantity, rules));
  });
}

py::object calibrate_scene(const ScriptScene& scene, const std::string& contact, double restitution) {
  return searched(
      [&](const auto& progress) { return app::scene_calibration(scene.file().scene, contact, restitution, progress); });
}

}  // namespace

TomlValue document_of(const py::object& mapping) { return TomlValue{table_of(mapping, "document")}; }

FieldValues fields_of(const py::object& changes) {
  FieldValues fields;
  for (TomlEntry& entry : table_of(changes, "fields"))
    fields.emplace_back(std::move(entry.key), std::move(entry.value));
  return fields;
}

app::MethodOptions method_of(const std::optional<std::string>& end, const std::optional<std::string>& step,
                             const std::optional<std::string>& integrator, double tolerance) {
  return {given("end", end), given("step", step), given("integrator", integrator), tolerance};
}

void bind_scene(py::module_& module) {
  bind_document<ScriptScene>(
      module, "Scene", "A scene: bodies, contacts, cables and a plan. It is never changed; changes make another one.")
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
      .def("__repr__", [](const ScriptScene& scene) {
        const Model& model = scene.file().scene.model;
        return fmt::format("<talus.Scene '{}': {} bodies, {} contacts, {} cables, {}>", scene.file().scene.title,
                           model.bodies.size(), model.contacts.size(), model.cables.size(),
                           name(scene.file().scene.integrator));
      });
}

}  // namespace talus::python
