#include "solver/python/bindings.hpp"

#include <fmt/format.h>
#include <pybind11/numpy.h>
#include <pybind11/stl.h>
#include <pybind11/stl/filesystem.h>

#include <filesystem>
#include <limits>
#include <map>
#include <nlohmann/json.hpp>
#include <variant>
#include <vector>

#include "solver/app/calibration/impact_calibration.hpp"
#include "solver/base/error.hpp"
#include "solver/integrate/integrator_list.hpp"
#include "solver/laws/latching_spring.hpp"
#include "solver/python/python_signals.hpp"
#include "solver/python/python_values.hpp"
#include "solver/python/script_sweep.hpp"

namespace talus::python {
namespace {

namespace py = pybind11;
using namespace py::literals;

template <class Script>
py::dict sweep(const Script& scene, const std::vector<py::object>& runs, const std::vector<std::string>& outputs,
               long threads, long evaluations, double time) {
  constexpr long maximum_threads = 1024;
  if (threads < 0 || threads > maximum_threads)
    throw InputError{fmt::format("threads: found {}; it must be between 0 and {}", threads, maximum_threads)};
  if (evaluations < 0) throw InputError{fmt::format("evaluations: found {}; it must be >= 0", evaluations)};
  if (!(time >= 0.0)) throw InputError{fmt::format("time: found {}; it must be >= 0", time)};
  std::vector<FieldValues> changes;
  for (const py::object& run : runs)
    changes.push_back(fields_of(run));
  const ScriptSweep swept = sweep_document(scene.document(), scene.name(), changes,
                                           {outputs, {time, evaluations}, static_cast<unsigned>(threads)});
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
  const py::object base = std::visit([](const auto& of) { return py::cast(of); }, sweep.base);
  return py::dict("scene"_a = base, "runs"_a = runs, "outputs"_a = sweep.outputs,
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
  return to_python(json.dump());
}

}  // namespace

void bind_studies(py::module_& module) {
  const char* const of_sweep =
      "Runs a scene or a shear cell once for each dict of fields in `runs`, on threads (0: all of the machine), as "
      "`talus sweep` does. Returns a dict of columns, one value for each run: 'end' (finished, unusable, diverged, "
      "refused, limited), 'reason', 'time', 'evaluations', of a fence 'verdict', and the outputs in units of the "
      "scene, "
      "NaN if the run did not reach its end or has no such number. Limits of each run: evaluations, and time of the "
      "clock [s]; 0: none.";
  const auto add_sweep = [&](auto function) {
    module.def("sweep", function, "scene"_a, "runs"_a, "outputs"_a, py::kw_only(), "threads"_a = 0L,
               "evaluations"_a = 0L, "time"_a = 0.0, of_sweep);
  };
  add_sweep(&sweep<ScriptScene>), add_sweep(&sweep<ScriptCell>);
  module.def("read_sweep", &planned, "file"_a,
             "The file of a sweep as arguments of sweep(): talus.sweep(**talus.read_sweep('sweep.toml')) gives what "
             "`talus sweep` collects. Raises InputError, IoError.");
  module.def("calibrate", &calibrate, py::kw_only(), "restitution"_a = py::none(), "masses"_a, "law"_a, "parameters"_a,
             "dashpot"_a, "end_rule"_a, "pivot"_a, "offset"_a, "speed"_a, "bound"_a, "integrator"_a);
  module.def("integrators", &integrator_names, "Names of all integrators.");
}

}  // namespace talus::python
