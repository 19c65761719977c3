#include "verification/problems/program/options/study_options.hpp"

#include <fmt/format.h>

#include <cmath>
#include <cstdint>
#include <map>
#include <numbers>
#include <string>
#include <utility>
#include <vector>

#include "verification/record/csv.hpp"
#include "verification/record/json_node.hpp"

namespace talus::verification::problems::calculation_options {
namespace {

using records::Json;

constexpr const char* study_file = "shear_study.csv";

/// Columns of the runs of a study by the beginnings of their names.
class Runs {
 public:
  explicit Runs(const records::Csv& csv) : csv_{&csv} {}
  [[nodiscard]] std::size_t count() const { return csv_->rows(); }
  [[nodiscard]] double number(std::size_t row, const char* column) const {
    return std::stod(std::string{csv_->cell(row, csv_->column(column))});
  }
  /// The text of the columns that name a point: series, load in kPa, speed and stiffness.
  [[nodiscard]] std::string point(std::size_t row) const {
    return fmt::format("{} {:g} {:g} {:g}", csv_->cell(row, csv_->column("series")),
                       number(row, "overburden [Pa]") / 1e3, number(row, "speed [D/s]"), number(row, "stiffness"));
  }

 private:
  const records::Csv* csv_;
};

/// Mean and standard error of the mean.
struct Mean {
  double value{}, error{};
  double runs{};
};
Mean mean_of(const std::vector<double>& numbers) {
  const auto count = static_cast<double>(numbers.size());
  double sum = 0.0, squares = 0.0;
  for (const double number : numbers)
    sum += number;
  for (const double number : numbers)
    squares += (number - sum / count) * (number - sum / count);
  return {sum / count, std::sqrt(squares / (count - 1.0) / count), count};
}

/// Rows by the points of a study.
std::map<std::string, std::vector<std::size_t>> rows_of(const Runs& runs) {
  std::map<std::string, std::vector<std::size_t>> rows;
  for (std::size_t row = 0; row < runs.count(); ++row)
    rows[runs.point(row)].push_back(row);
  return rows;
}

/// The printed table and its outcomes against means over the runs.
void compare_printed(const std::string& printed, const Runs& runs, Differences& differ) {
  const auto rows = rows_of(runs);
  const auto of = [&](const std::string& point, const char* column) {
    std::vector<double> numbers;
    for (const std::size_t row : rows.at(point))
      numbers.push_back(runs.number(row, column));
    return mean_of(numbers);
  };
  const std::string table = squeezed(printed);
  for (const auto& [point, found] : rows) {
    std::string line = fmt::format("{} {}", point, found.size());
    for (const auto& [column, digits] :
         {std::pair{"stress_ratio", 4}, std::pair{"depth [D]", 3}, std::pair{"multiple_fraction", 3},
          std::pair{"multiple_shear_fraction", 3}, std::pair{"largest_overlap [D]", 3}, std::pair{"order", 3}}) {
      const Mean mean = of(point, column);
      line += fmt::format(" {:.{}f} +- {:.{}f}", mean.value, digits, mean.error, digits);
    }
    differ.contains("study: printed line of " + point, table, line);
  }
  const auto mean = [&](const std::string& point, const char* column) {
    const Mean found = of(point, column);
    return fmt::format("{:.3f} +- {:.3f}", found.value, found.error);
  };
  // The measured numbers, and Welch's t of the differences by which the outcomes are decided, in their order.
  const auto t_of = [&](const std::string& later, const std::string& earlier, const char* column) {
    const Mean a = of(later, column), b = of(earlier, column);
    return fmt::format("(t = {:+.1f},", (a.value - b.value) / std::hypot(a.error, b.error));
  };
  const std::string low = "5000 d/s 2 5000 1", high = "5000 d/s 32 5000 1", low_slow = "1000 d/s 2 1000 1",
                    high_slow = "1000 d/s 32 1000 1", soft = "stiffness 15 5000 0.25", hard = "stiffness 15 5000 4";
  std::vector<double> apart;
  for (const auto& [point, found] : rows) {
    const double load = runs.number(found.front(), "overburden [Pa]");
    if (!point.starts_with("5000 d/s") || load > 32e3) continue;
    for (const std::size_t row : found)
      apart.push_back(runs.number(row, "binary_stress_ratio") - runs.number(row, "multiple_stress_ratio"));
  }
  const Mean lower = mean_of(apart);
  const std::vector<std::string> outcomes{
      fmt::format("depth {} D at 2 kPa, {} D at 32 kPa {}", mean(low, "depth [D]"), mean(high, "depth [D]"),
                  t_of(high, low, "depth [D]")),
      fmt::format("their fraction of contact time {} and {} {}", mean(low, "multiple_fraction"),
                  mean(high, "multiple_fraction"), t_of(high, low, "multiple_fraction")),
      fmt::format("lower by {:.4f} +- {:.4f}, mean of {:.0f} runs", lower.value, lower.error, lower.runs),
      fmt::format("S/N {} at 2 kPa, {} at 32 kPa, 5000 d/s {}", mean(low, "stress_ratio"), mean(high, "stress_ratio"),
                  t_of(high, low, "stress_ratio")),
      fmt::format("S/N {} at 2 kPa, {} at 32 kPa, 1000 d/s {}", mean(low_slow, "stress_ratio"),
                  mean(high_slow, "stress_ratio"), t_of(high_slow, low_slow, "stress_ratio")),
      fmt::format("S/N {} at 0.25 times the stiffness, fraction of multiple contacts {}; {} and {} at 4 times {}",
                  mean(soft, "stress_ratio"), mean(soft, "multiple_fraction"), mean(hard, "stress_ratio"),
                  mean(hard, "multiple_fraction"), t_of(soft, hard, "stress_ratio"))};
  std::size_t at = 0;
  for (const std::string& outcome : outcomes) {
    at = printed.find(outcome, at);
    differ.holds("study: printed outcome " + outcome, at != std::string::npos);
    if (at == std::string::npos) break;
  }
}

// Discs of ice of a millimetre, with the stiffness of a point of the study.
constexpr double diameter = 1e-3, disc_mass = 7.2e-7, gravity = 9.81, stiffness = 1.7e4;
constexpr int wall_discs = 11;

/// The cell of a run of the study as a scene: 20 steps in a contact, 40 outputs.
std::string cell_of(const Runs& runs, std::size_t row, double time) {
  const double k1 = stiffness * runs.number(row, "stiffness"), k2 = stiffness / 0.49 * runs.number(row, "stiffness");
  const double effective = 0.5 * disc_mass;
  const double contact = 0.5 * std::numbers::pi * (1.0 / std::sqrt(k1 / effective) + 1.0 / std::sqrt(k2 / effective));
  return fmt::format(R"(title = "A run of a study"
units = "SI"
[cell]
stiffness = "{} N/m"
unloading_stiffness = "{} N/m"
diameter = "{} m"
mass = "{} kg"
gravity = "{} m/s^2"
block_mass = "{} kg"
rows = 8
columns = 10
wall_discs = {}
block_speed = "{} m/s"
seed = {}
[run]
step = "{} s"
every = "{} s"
end = "{} s"
)",
                     k1, k2, diameter, disc_mass, gravity,
                     runs.number(row, "overburden [Pa]") * wall_discs * diameter * diameter / gravity, wall_discs,
                     diameter * runs.number(row, "speed [D/s]"), runs.number(row, "seed"), contact / 20.0, time / 40.0,
                     time);
}

/// A run of the study against the same cell run alone. The same steps are taken, so only conversions round.
void compare_cell(const Program& program, const Runs& runs, std::size_t row, double time, Differences& differ) {
  program.write("run_of_study.toml", cell_of(runs, row, time));
  const Json summary = program.json({"cell", "run_of_study.toml"}, {{"--json", {}}, {"--out", {"run_of_study"}}});
  differ.compare("study: summary of the cell printed and written", summary, program.file("run_of_study/summary.json"));
  const auto result = [&](const char* name) { return summary.at("results").at(name).at("value").get<double>(); };
  const double depth = result("depth") / diameter,
               density = disc_mass / (0.25 * std::numbers::pi * std::pow(diameter, 3));
  for (const auto& [column, expected] :
       {std::pair{"stress_ratio", result("stress_ratio_top")}, std::pair{"depth [D]", depth},
        std::pair{"touching", result("contact_time_fraction")},
        std::pair{"multiple_fraction", result("multiple_fraction")},
        std::pair{"multiple_shear_fraction", result("multiple_shear_fraction")},
        std::pair{"multiple_stress_ratio", result("multiple_stress_ratio")},
        std::pair{"binary_stress_ratio", result("binary_stress_ratio")},
        std::pair{"inertial_number", runs.number(row, "speed [D/s]") / depth * diameter *
                                         std::sqrt(density / runs.number(row, "overburden [Pa]"))},
        std::pair{"largest_overlap [D]", result("largest_overlap")}}) {
    differ.holds(fmt::format("study: {} of a run and of talus cell", column),
                 std::abs(runs.number(row, column) / expected - 1.0) < 1e-12);
  }
}

}  // namespace

void check_study(const Program& program, Differences& differ) {
  const auto study = [&](const std::string& time, const std::string& seeds, const std::string& threads) {
    const std::string folder = fmt::format("study_{}_{}_{}", time, seeds, threads);
    const std::string printed = program.run(
        {"study", "shear"}, {{"--time", {time}}, {"--seeds", {seeds}}, {"--threads", {threads}}, {"--out", {folder}}});
    return std::pair{printed, program.csv(fmt::format("{}/{}", folder, study_file))};
  };
  const auto [printed, two] = study("0.01", "2", "1");
  const records::Csv three = study("0.01", "3", "2").second, longer = study("0.014", "2", "1").second;
  const Runs runs{two};
  compare_printed(printed, runs, differ);
  compare_cell(program, runs, runs.count() - 1, 0.01, differ);
  const auto rows = [](const records::Csv& csv) {
    std::map<std::string, std::vector<std::string>> found;  // by series, overburden, speed, stiffness and seed
    for (std::size_t row = 0; row < csv.rows(); ++row) {
      std::string key;
      std::vector<std::string> values;
      for (std::size_t i = 0; i < csv.header().size(); ++i) {
        const std::string cell{csv.cell(row, i)};
        if (i < 5) {
          key += cell + " ";
        } else {
          values.push_back(cell);
        }
      }
      found[key] = values;
    }
    return found;
  };
  const auto few = rows(two), more = rows(three), later = rows(longer);
  differ.compare("study: rows of two seeds", few.size(), 2 * more.size() / 3);
  const std::size_t overlap = two.column("largest_overlap [D]") - 5;
  for (const auto& [key, values] : few) {
    differ.compare("study: a run with other threads and seeds", more.contains(key) ? more.at(key) : Option{}.second,
                   values);
    if (!later.contains(key)) continue;
    const auto& after = later.at(key);
    differ.holds("study: a longer run has the larger overlap", std::stod(after[overlap]) >= std::stod(values[overlap]));
    differ.compare("study: means of a longer run", after == values, false);
  }
  differ.compare("study: runs with another time", later.size(), few.size());
}

}  // namespace talus::verification::problems::calculation_options
