#include "verification/problems/program/fit/fit_files.hpp"

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "verification/record/csv.hpp"
#include "verification/record/json_node.hpp"
#include "verification/study/program/table_units.hpp"

namespace talus::verification::problems::fitted_parameters {

using records::Csv;
using records::Json;

namespace {

/// The columns of the data, of which fit.csv has those of inputs and the measured values.
void compare_column(const Csv& fit, std::size_t column, const Csv& data, const std::string& head, Differences& differ) {
  for (std::size_t row = 0; row < std::min(fit.rows(), data.rows()); ++row)
    differ.compare("value of the data: " + head, fit.number(row, column), data.number(row, head));
}

}  // namespace

void compare_fit_files(const Program& program, const std::string& folder, const std::string& data_file,
                       Differences& differ) {
  const Csv fit = program.csv(folder + "/fit.csv"), data = program.csv(data_file);
  const Json json = program.file(folder + "/fit.json");
  const Json& quantities = json.at("quantities");
  differ.compare("rows of a fit", fit.rows(), data.rows());
  const auto has_column = [&](const std::string& head) {
    return std::ranges::find(data.header(), head) != data.header().end();
  };
  // Inputs, and three columns for each quantity.
  const std::size_t inputs = fit.header().size() - 3 * quantities.size();
  for (std::size_t i = 0; i < inputs; ++i)
    compare_column(fit, i, data, fit.header()[i], differ);
  for (std::size_t k = 0; k < quantities.size(); ++k) {
    const std::size_t first = inputs + 3 * k;
    const TableHead head{fit.header()[first]};
    const std::string name = head.name.substr(0, head.name.rfind(", measured")),
                      unit = head.unit.empty() ? "" : " [" + head.unit + "]";
    for (std::size_t i = 0; i < 3; ++i)
      differ.compare("head of a quantity", fit.header()[first + i],
                     name + std::vector<std::string>{", measured", ", fitted", ", difference"}[i] + unit);
    // One that is named otherwise than its column is compared where it is fitted.
    if (has_column(name + unit)) compare_column(fit, first, data, name + unit, differ);
    double squares = 0.0;
    for (std::size_t row = 0; row < fit.rows(); ++row) {
      const double measured = fit.number(row, first), fitted = fit.number(row, first + 1),
                   difference = fit.number(row, first + 2);
      squares += difference * difference;
      // Differences of results in SI, whose units are products of up to three rounded factors.
      differ.holds("difference of " + name,
                   std::abs(fitted - measured - difference) <= 1e-15 * (std::abs(fitted) + std::abs(measured)));
    }
    const double mean = std::sqrt(squares / static_cast<double>(fit.rows()));
    differ.holds("root mean square of " + name,
                 std::abs(quantities.at(k).at("root_mean_square").get<double>() - mean) <= 1e-9 * mean);
  }
}

}  // namespace talus::verification::problems::fitted_parameters
