#include "verification/data/measured_case.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <boost/math/distributions/chi_squared.hpp>
#include <boost/math/distributions/normal.hpp>
#include <cmath>
#include <optional>
#include <stdexcept>

#include "reports/text/markdown.hpp"
#include "solver/base/error.hpp"
#include "verification/check/evidence.hpp"
#include "verification/data/run_results.hpp"
#include "verification/data/scene_field.hpp"
#include "verification/study/findings/expectations.hpp"
#include "verification/study/program/program_run.hpp"

namespace talus::verification {

namespace {

using problems::keep_largest;
using problems::TemporaryFolder;

/// The family of these cases in verification/catalogue/requirements.toml.
constexpr const char* family = "V: validation by measurements";
constexpr double confidence = 0.99;

/// A quantity in one row: computed and measured, and the parts of the uncertainty.
struct Comparison {
  double computed{}, measured{};
  double of_data{}, of_inputs{}, of_method{}, of_model{};

  [[nodiscard]] double uncertainty() const { return std::hypot(std::hypot(of_data, of_inputs), of_method, of_model); }
  [[nodiscard]] double ratio() const { return (computed - measured) / uncertainty(); }
};

std::string toml_of(double value, const std::string& unit) {
  return unit == "1" ? fmt::format("{:.17e}", value) : fmt::format("\"{} {}\"", value, unit);
}

/// Runs of the scene of a set.
class Runs {
 public:
  Runs(const MeasuredSet& set, const Setup& setup) : set_{set}, scene_{set.scene} {
    for (const MeasuredControl& control : set.controls) {
      if (setup.has(control.name)) scene_ = with_field(scene_, control.field, control.value);
    }
  }

  /// The run of a row, with one input increased by its uncertainty and with further options, if they are given.
  RunResults at(std::size_t row, std::optional<std::size_t> shifted = {},
                const std::vector<std::string>& options = {}) const {
    std::string scene = scene_;
    for (std::size_t i = 0; i < set_.inputs.size(); ++i) {
      const MeasuredInput& input = set_.inputs[i];
      const double value = input.values[row] + (i == shifted ? input.uncertainty[row] : 0.0);
      scene = with_field(scene, input.field, toml_of(value, input.unit));
    }
    const TemporaryFolder folder;
    folder.write("scene.toml", scene);
    std::vector<std::string> arguments{"run", "scene.toml", "--out", "out", "--impacts", "--frames", "1"};
    arguments.insert(arguments.end(), options.begin(), options.end());
    const problems::ProgramEnd end = problems::run_talus(folder, arguments);
    if (end.exit_code != 0) {
      throw std::runtime_error{fmt::format("row {} of the data: talus run ended with {}: {}", row + 1, end.exit_code,
                                           end.messages.empty() ? end.output : end.messages)};
    }
    return RunResults{folder.path() / "out"};
  }

 private:
  const MeasuredSet& set_;
  std::string scene_;
};

double value_of(const RunResults& results, const MeasuredQuantity& quantity) {
  RunResult found;
  try {
    found = results.at(quantity.result);
  } catch (const InputError& wrong) {
    throw std::runtime_error{quantity.at + wrong.what()};
  }
  if (found.unit != quantity.unit) {
    throw std::runtime_error{fmt::format("{}the result is in '{}', the column '{}' in '{}'; they must be the same",
                                         quantity.at, found.unit, quantity.column, quantity.unit)};
  }
  return found.value;
}

/// Whether the method has an error that a shorter step or a smaller tolerance reduces.
bool has_error(const Integrator& method) { return traits(method).step_control != StepControl::closed_form; }

/// Options for a run with a tenth of the tolerance, or with half the step of the first run.
std::vector<std::string> refinement(const Integrator& method, const RunResults& first) {
  if (const double of_method = tolerance(method); of_method > 0.0)
    return {"--tolerance", fmt::format("{}", 0.1 * of_method)};
  return {"--step", fmt::format("{} {}", 0.5 * first.step(), first.unit_of_time())};
}

/// Comparisons of all quantities in one row.
std::vector<Comparison> compared(const MeasuredSet& set, const Runs& runs, std::size_t row) {
  const RunResults results = runs.at(row);
  std::vector<Comparison> all;
  for (const MeasuredQuantity& quantity : set.quantities) {
    all.push_back({.computed = value_of(results, quantity),
                   .measured = quantity.values[row],
                   .of_data = quantity.uncertainty[row],
                   .of_model = quantity.model_error});
  }
  const auto change = [&](const RunResults& other, std::size_t q) {
    return value_of(other, set.quantities[q]) - all[q].computed;
  };
  if (has_error(set.integrator)) {
    const RunResults finer = runs.at(row, {}, refinement(set.integrator, results));
    for (std::size_t q = 0; q < all.size(); ++q)
      all[q].of_method = std::abs(change(finer, q));
  }
  for (std::size_t i = 0; i < set.inputs.size(); ++i) {
    if (set.inputs[i].uncertainty[row] == 0.0) continue;
    const RunResults shifted = runs.at(row, i);
    for (std::size_t q = 0; q < all.size(); ++q)
      all[q].of_inputs = std::hypot(all[q].of_inputs, change(shifted, q));
  }
  return all;
}

/// Bounds that 99 % of sets of `count` independent normal numbers keep.
struct Bounds {
  double root_mean_square{}, largest{}, mean{};
};

Bounds bounds_for(std::size_t count) {
  const double n = static_cast<double>(count);
  const boost::math::normal normal;
  const double each = std::pow(confidence, 1.0 / n);
  return {std::sqrt(quantile(boost::math::chi_squared{n}, confidence) / n), quantile(normal, 0.5 * (1.0 + each)),
          quantile(normal, 0.5 * (1.0 + confidence)) / std::sqrt(n)};
}

void check(Findings& findings, const std::string& name, const std::vector<Comparison>& rows, bool method_errs) {
  double squares = 0.0, largest = 0.0, sum = 0.0, step = 0.0;
  for (const Comparison& row : rows) {
    squares += row.ratio() * row.ratio(), sum += row.ratio();
    keep_largest(largest, row.ratio());
    keep_largest(step, row.of_method / row.of_data);
  }
  const double n = static_cast<double>(rows.size());
  const Bounds bounds = bounds_for(rows.size());
  const auto why = [](const char* what) {
    return fmt::format(
        "{} that 99 % of sets have whose deviations are normal and independent, with these uncertainties", what);
  };
  const auto group = findings.in(name);
  findings.expect(name + ": root mean square of deviation over uncertainty", std::sqrt(squares / n), 0.0,
                  Tolerance::model(bounds.root_mean_square, why("the root mean square (quantile of chi squared)")));
  findings.expect(name + ": largest deviation over uncertainty", largest, 0.0,
                  Tolerance::model(bounds.largest, why("the largest value")));
  findings.expect(name + ": mean of deviation over uncertainty", sum / n, 0.0,
                  Tolerance::model(bounds.mean, why("the mean")));
  if (!method_errs) return;
  findings.expect(name + ": change with half the step, or a tenth of the tolerance, over the uncertainty of the data",
                  step, 0.0,
                  Tolerance::model(0.2, "the largest; a fifth adds 2 % to the uncertainty: use a smaller step"));
}

Figure figure_of(const MeasuredSet& set, std::size_t q, const std::vector<Comparison>& rows) {
  const MeasuredQuantity& quantity = set.quantities[q];
  const MeasuredAxis& axis = set.axis;
  Figure figure{
      .name = fmt::format("quantity_{}", q + 1),
      .title = quantity.name,
      .caption = fmt::format("Measured, with two standard uncertainties (of data, inputs, method and model), and "
                             "computed, against {}.",
                             axis.label),
      .x = {.label = axis.label, .unit = axis.unit},
      .y = {.label = quantity.name, .unit = quantity.unit}};
  Series data{.label = "measured", .style = Style::errorbars}, run{.label = "computed", .style = Style::crosses};
  for (std::size_t i = 0; i < rows.size(); ++i) {
    const double x = axis.values[i];
    data.add(x, rows[i].measured);
    data.y_low.push_back(rows[i].measured - 2.0 * rows[i].uncertainty());
    data.y_high.push_back(rows[i].measured + 2.0 * rows[i].uncertainty());
    run.add(x, rows[i].computed);
  }
  figure.series = {data, run};
  return figure;
}

Table table_of(const MeasuredSet& set, std::size_t q, const std::vector<Comparison>& rows) {
  const MeasuredQuantity& quantity = set.quantities[q];
  Table table{.name = fmt::format("quantity_{}", q + 1),
              .caption = fmt::format("{} [{}]: E is the computed less the measured value, u its standard uncertainty.",
                                     quantity.name, quantity.unit),
              .columns = {"row"}};
  for (const MeasuredInput& input : set.inputs)
    table.columns.push_back(input.column);
  for (const char* column : {"measured", "computed", "u of data", "of inputs", "of method", "of model", "E/u"})
    table.columns.emplace_back(column);
  for (std::size_t i = 0; i < rows.size(); ++i) {
    std::vector<std::string> row{fmt::format("{}", i + 1)};
    for (const MeasuredInput& input : set.inputs)
      row.push_back(fmt::format("{:g}", input.values[i]));
    const Comparison& c = rows[i];
    for (const double each : {c.measured, c.computed})
      row.push_back(fmt::format("{:.5g}", each));
    for (const double each : {c.of_data, c.of_inputs, c.of_method, c.of_model})
      row.push_back(fmt::format("{:.2g}", each));
    row.push_back(fmt::format("{:+.2f}", c.ratio()));
    table.rows.push_back(row);
  }
  return table;
}

void run(const MeasuredSet& set, Findings& findings, const Setup& setup) {
  const Runs runs{set, setup};
  std::vector<std::vector<Comparison>> by_quantity(set.quantities.size());
  for (std::size_t row = 0; row < set.rows; ++row) {
    const std::vector<Comparison> all = compared(set, runs, row);
    for (std::size_t q = 0; q < all.size(); ++q)
      by_quantity[q].push_back(all[q]);
  }
  for (std::size_t q = 0; q < by_quantity.size(); ++q) {
    check(findings, set.quantities[q].name, by_quantity[q], has_error(set.integrator));
    if (setup.coarse) continue;
    findings.figure(figure_of(set, q, by_quantity[q]));
    findings.table(table_of(set, q, by_quantity[q]));
  }
}

std::string page_of(const MeasuredSet& set) {
  using reports::markdown::text;
  std::string page;
  if (!set.conclusion.empty()) page += "**Conclusion.** " + text(set.conclusion) + "\n\n";
  page += "**Problem.** " + text(set.what) + "\n\n";
  page +=
      "**Uncertainty.** With $E$ the computed less the measured value, $u^2 = u_D^2 + u_{in}^2 + u_{num}^2 + "
      "u_{model}^2$: of the measured value, of the conditions (change of the result with each), of the method (change "
      "with half the step, or a tenth of the tolerance), and what is granted to the model.\n\n";
  page += "**Source.** " + text(set.source) + (set.source.ends_with('.') ? "" : ".") + "\n\n";
  return page + text_of(EvidenceParagraph{{Evidence::measurement}, text(set.not_shown), ""});
}

}  // namespace

Case measured_case(const MeasuredSet& set) {
  Case made{.id = set.id,
            .title = set.title,
            .family = family,
            .requirements = {},
            .source = set.source,
            .page = page_of(set),
            .faults = {}};
  made.data_set = set.file.string();
  made.time_limit = 600.0;
  for (const MeasuredQuantity& quantity : set.quantities)
    made.main_checks.push_back(quantity.name + ": root mean square of deviation over uncertainty");
  for (const MeasuredControl& control : set.controls)
    made.faults.push_back(
        {control.name, control.what, control.turns_red + ": root mean square of deviation over uncertainty"});
  made.run = [set](Findings& findings, const Setup& setup) { run(set, findings, setup); };
  return made;
}

std::vector<Case> measured_cases(const std::filesystem::path& folder) {
  std::vector<Case> cases;
  for (const std::filesystem::path& file : measured_files(folder))
    cases.push_back(measured_case(read_measured_set(file)));
  return cases;
}

}  // namespace talus::verification
