#include "solver/app/fit/fit_results.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

#include "verification/record/csv.hpp"

namespace talus::app {
namespace {

using Json = nlohmann::ordered_json;

constexpr int fit_schema = 1;

/// Correlation above which two parameters cannot be distinguished: the standard error of one is ten times as large as
/// if the other were known.
constexpr double inseparable = 0.995;
/// Root mean square of deviations over their uncertainties above which a model does not describe the data.
constexpr double misfit = 2.0;

std::string head(const std::string& name, const std::string& unit) {
  return unit.empty() ? name : fmt::format("{} [{}]", name, unit);
}

double root_mean_square(const Fit& fit) { return std::sqrt(fit.sum / static_cast<double>(fit.deviations.size())); }

/// Of one quantity, in the unit of its column.
double root_mean_square(const FitFile& file, std::size_t quantity, const std::vector<double>& results) {
  double sum = 0.0;
  for (std::size_t row = 0; row < file.rows; ++row)
    sum += std::pow(results[row * file.quantities.size() + quantity] - file.quantities[quantity].values[row], 2);
  return std::sqrt(sum / static_cast<double>(file.rows));
}

Json number_json(double value) { return std::isfinite(value) ? Json(value) : Json(nullptr); }

}  // namespace

std::vector<std::string> fit_warnings(const FitFile& file, const Fit& fit) {
  std::vector<std::string> warnings;
  const std::size_t count = file.parameters.size();
  for (std::size_t i = 0; i < count; ++i) {
    const std::string& field = file.parameters[i].field;
    if (fit.at_bound[i])
      warnings.push_back(fmt::format("{} is at a bound: the best value may lie outside of its range", field));
    if (fit.undetermined[i])
      warnings.push_back(
          fmt::format("{} is not determined by these data: its standard error exceeds half of its range", field));
  }
  for (std::size_t i = 0; i < count; ++i) {
    for (std::size_t j = i + 1; j < count; ++j) {
      const double correlation = fit.correlation[i][j];
      if (std::abs(correlation) > inseparable) {
        warnings.push_back(fmt::format("{} and {} cannot be distinguished by these data: correlation {:.4f}",
                                       file.parameters[i].field, file.parameters[j].field, correlation));
      }
    }
  }
  if (const double scatter = std::sqrt(fit.sum / fit.degrees_of_freedom());
      file.has_uncertainties() && scatter > misfit) {
    warnings.push_back(
        fmt::format("the standard deviation of the data from the model is {:.3g} uncertainties: it does not describe "
                    "them, or the search has missed the best values; compare with a fit of narrower ranges. Intervals "
                    "are wrong",
                    scatter));
  }
  if (!fit.converged) warnings.emplace_back("the search has not converged; give another start or narrower ranges");
  if (fit.unconverged > 0) {
    warnings.push_back(fmt::format("the search of {} of {} samples of the bootstrap has not converged", fit.unconverged,
                                   fit.samples.size()));
  }
  if (!fit.samples.empty() && fit.tail * static_cast<double>(fit.samples.size() - 1) < 1.0) {
    warnings.push_back(
        fmt::format("intervals are the whole range of the samples: {} rows and {} samples are too few for 95 %",
                    file.rows, fit.samples.size()));
  }
  return warnings;
}

std::string fit_text(const FitFile& file, const Fit& fit) {
  std::string text =
      fmt::format("{} parameter{} fitted to {} values of {} rows, {} runs\n", file.parameters.size(),
                  file.parameters.size() == 1 ? "" : "s", fit.deviations.size(), file.rows, fit.evaluations);
  std::size_t width = 9;
  for (const FittedField& field : file.parameters)
    width = std::max(width, head(field.field, field.unit).size());
  const auto line = [&](const std::string& name, const std::string& value, const std::string& error,
                        const std::string& interval) {
    text += fmt::format("  {:<{}}  {:>11}  {:>14}", name, width, value, error) +
            (fit.intervals.empty() ? "\n" : fmt::format("  {:>24}\n", interval));
  };
  line("parameter", "value", "standard error", "95 %, bootstrap");
  for (std::size_t i = 0; i < file.parameters.size(); ++i) {
    const FittedField& field = file.parameters[i];
    line(head(field.field, field.unit), fmt::format("{:.5g}", fit.values[i]), fmt::format("{:.3g}", fit.errors[i]),
         fit.intervals.empty() ? ""
         : fit.undetermined[i] ? "not determined"
                               : fmt::format("{:.4g} to {:.4g}", fit.intervals[i][0], fit.intervals[i][1]));
  }
  text += file.has_uncertainties()
              ? fmt::format("root mean square of the deviations: {:.3g} uncertainties\n", root_mean_square(fit))
              : fmt::format("root mean square of the deviations: {:.3g} {}\n", root_mean_square(fit),
                            file.quantities.front().unit);
  text += "in the scene:\n";
  for (std::size_t i = 0; i < file.parameters.size(); ++i) {
    const FittedField& field = file.parameters[i];
    text += field.unit.empty() ? fmt::format("  {} = {}\n", field.field, fit.values[i])
                               : fmt::format("  {} = \"{} {}\"\n", field.field, fit.values[i], field.unit);
  }
  return text;
}

std::string fit_json(const FitFile& file, const Fit& fit, const std::vector<double>& results) {
  Json json{{"schema", fit_schema},
            {"title", file.title},
            {"scene", file.scene.filename().string()},
            {"data", file.data.filename().string()},
            {"rows", file.rows},
            {"values", fit.deviations.size()},
            {"runs", fit.evaluations},
            {"uncertainties", file.has_uncertainties()},
            {"sum_of_squares", fit.sum},
            {"degrees_of_freedom", fit.degrees_of_freedom()},
            {"converged", fit.converged}};
  json["parameters"] = Json::array();
  for (std::size_t i = 0; i < file.parameters.size(); ++i) {
    const FittedField& field = file.parameters[i];
    Json parameter{{"field", field.field},
                   {"unit", field.unit},
                   {"range", {field.parameter.lower, field.parameter.upper}},
                   {"value", fit.values[i]},
                   {"standard_error", number_json(fit.errors[i])},
                   {"interval", nullptr},
                   {"at_bound", static_cast<bool>(fit.at_bound[i])},
                   {"undetermined", static_cast<bool>(fit.undetermined[i])}};
    // The samples of a parameter without effect stay where the search puts them.
    if (!fit.intervals.empty() && !fit.undetermined[i]) parameter["interval"] = fit.intervals[i];
    json["parameters"].push_back(std::move(parameter));
  }
  json["correlation"] = Json::array();
  for (const std::vector<double>& correlations : fit.correlation) {
    Json row = Json::array();
    for (const double correlation : correlations)
      row.push_back(number_json(correlation));
    json["correlation"].push_back(std::move(row));
  }
  json["quantities"] = Json::array();
  for (std::size_t k = 0; k < file.quantities.size(); ++k) {
    const FitQuantity& quantity = file.quantities[k];
    json["quantities"].push_back({{"name", quantity.name},
                                  {"unit", quantity.unit},
                                  {"uncertainty", quantity.uncertainty ? Json(*quantity.uncertainty) : Json(nullptr)},
                                  {"root_mean_square", number_json(root_mean_square(file, k, results))}});
  }
  json["bootstrap"] = {{"samples", file.samples}, {"seed", file.seed}, {"unconverged", fit.unconverged}};
  json["warnings"] = fit_warnings(file, fit);
  return json.dump(2) + "\n";
}

std::string fit_csv(const FitFile& file, const std::vector<double>& results) {
  std::vector<std::string> heads;
  for (const FitInput& input : file.inputs)
    heads.push_back(input.heading);
  for (const FitQuantity& quantity : file.quantities) {
    for (const char* const of : {"measured", "fitted", "difference"})
      heads.push_back(head(fmt::format("{}, {}", quantity.name, of), quantity.unit));
  }
  records::CsvText text{heads};
  for (std::size_t row = 0; row < file.rows; ++row) {
    for (const FitInput& input : file.inputs)
      text.number(input.values[row]);
    for (std::size_t k = 0; k < file.quantities.size(); ++k) {
      const double measured = file.quantities[k].values[row], fitted = results[row * file.quantities.size() + k];
      for (const double value : {measured, fitted, fitted - measured})
        text.number(value);
    }
    text.end_row();
  }
  return std::move(text).text();
}

std::string bootstrap_csv(const FitFile& file, const Fit& fit) {
  std::vector<std::string> heads;
  for (const FittedField& field : file.parameters)
    heads.push_back(head(field.field, field.unit));
  records::CsvText text{heads};
  for (const std::vector<double>& sample : fit.samples) {
    for (const double value : sample)
      text.number(value);
    text.end_row();
  }
  return std::move(text).text();
}

std::vector<records::Figure> fit_figures(const FitFile& file, const Fit& fit, const std::vector<double>& results) {
  std::vector<records::Figure> figures;
  const bool has_input = !file.inputs.empty();
  for (std::size_t k = 0; k < file.quantities.size(); ++k) {
    const FitQuantity& quantity = file.quantities[k];
    records::Series measured{.label = "measured", .style = records::Style::points},
        fitted{.label = "fitted", .style = records::Style::crosses};
    if (quantity.uncertainty) measured.style = records::Style::errorbars;
    for (std::size_t row = 0; row < file.rows; ++row) {
      const double x = has_input ? file.inputs.front().values[row] : static_cast<double>(row + 1);
      measured.add(x, quantity.values[row]);
      if (quantity.uncertainty) {
        measured.y_low.push_back(quantity.values[row] - *quantity.uncertainty);
        measured.y_high.push_back(quantity.values[row] + *quantity.uncertainty);
      }
      fitted.add(x, results[row * file.quantities.size() + k]);
    }
    const std::string x_label = has_input ? file.inputs.front().heading : "row";
    figures.push_back(
        {.name = fmt::format("quantity_{}", k + 1),
         .title = fmt::format("{}: measured and fitted", quantity.name),
         .caption = "Measured values, with bars of their uncertainty, and those of runs with the fitted "
                    "parameters.",
         .x = {.label = x_label.substr(0, x_label.find(" [")), .unit = has_input ? file.inputs.front().unit : ""},
         .y = {.label = quantity.name, .unit = quantity.unit},
         .series = {measured, fitted}});
  }
  std::size_t number = 0;
  for (std::size_t i = 0; i < file.parameters.size() && !fit.samples.empty(); ++i) {
    for (std::size_t j = i + 1; j < file.parameters.size(); ++j) {
      records::Series samples{.label = "samples", .style = records::Style::crosses},
          best{.label = "fit", .style = records::Style::points};
      for (const std::vector<double>& sample : fit.samples)
        samples.add(sample[i], sample[j]);
      best.add(fit.values[i], fit.values[j]);
      figures.push_back({.name = fmt::format("parameters_{}", ++number),
                         .title = "Samples of the bootstrap",
                         .caption = "Parameters fitted to samples of the rows. A narrow oblique cloud: the data hardly "
                                    "distinguish the two.",
                         .x = {.label = file.parameters[i].field, .unit = file.parameters[i].unit},
                         .y = {.label = file.parameters[j].field, .unit = file.parameters[j].unit},
                         .series = {samples, best}});
    }
  }
  return figures;
}

}  // namespace talus::app
