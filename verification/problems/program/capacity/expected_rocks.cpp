#include "verification/problems/program/capacity/expected_rocks.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <boost/math/distributions/binomial.hpp>
#include <cmath>
#include <map>
#include <numbers>
#include <string>
#include <utility>
#include <vector>

#include "verification/problems/program/capacity/one_column.hpp"
#include "verification/record/csv.hpp"
#include "verification/record/json_node.hpp"
#include "verification/study/findings/expectations.hpp"
#include "verification/study/findings/sample_quantile.hpp"
#include "verification/study/program/sweep_results.hpp"

namespace talus::verification::problems::fence_capacity {
namespace {

using records::Json;

/// Standard normal numbers at 95 % and 99 %.
constexpr double z95 = 1.6448536269514722, z99 = 2.3263478740408408;

/// Worst relative deviation of a quantile of runs, and of the ends of its interval, from those of their sorted values:
/// the number of values below the quantile is binomial, and each tail has at most 2.5 %.
double quantile_error(const Json& found, const std::vector<double>& sorted, double probability) {
  const boost::math::binomial_distribution<double> number{static_cast<double>(sorted.size()), probability};
  double worst = 0.0;
  const auto compare = [&](const Json& value, double exact) {
    keep_worst(worst, (value.get<double>() - exact) / (std::abs(exact) + 1e-300));
  };
  compare(found.at("value"), sample_quantile(sorted, probability));
  compare(found.at("interval").at(0), sorted[static_cast<std::size_t>(boost::math::quantile(number, 0.025))]);
  compare(found.at("interval").at(1), sorted[static_cast<std::size_t>(boost::math::quantile(number, 0.975))]);
  return worst;
}

}  // namespace

void check_hazard(const Program& program, Findings& findings, Differences& differ) {
  const Setup& setup = program.setup();
  const int runs = setup.coarse ? 300 : 600;
  const double p95 = 9.0, p99 = 12.0;
  const double deviation = std::log(p99 / p95) / (z99 - z95), mean = std::log(p95) - z95 * deviation;
  const double speed = std::sqrt(2.0 * breaking_energy(setup) / own_mass);
  const double exact = 0.5 * std::erfc((std::log(speed) - mean) / (std::numbers::sqrt2 * deviation));
  program.write("hazard.toml",
                question(4, fmt::format("[hazard]\nmass = \"200 kg\"\nspeed = {{ p95 = \"9 m/s\", p99 = \"12 m/s\" }}\n"
                                        "height = \"4.5 m\"\nruns = {}\n",
                                        runs)));
  const Json printed = program.json({"capacity", "hazard.toml"}, {{"--no-plots", {}}, {"--json", {}}}),
             &found = printed.at("hazard");
  differ.holds("printed JSON of expected rocks", program.file("hazard/capacity.json") == printed);
  const double probability = found.at("probability_of_failure").get<double>();
  findings.expect("expected rocks: probability of failure, deviation from the closed form",
                  (probability - exact) / std::sqrt(exact * (1.0 - exact) / runs), 0.0,
                  Tolerance::model(4.0, "in standard deviations of that many runs"));
  differ.compare("runs of the hazard", found.at("runs").get<int>(), runs);
  differ.compare(
      "rocks of the hazard", found.at("rocks"),
      Json{{"mass", {{"value", 200.0}}}, {"speed", {{"p95", p95}, {"p99", p99}}}, {"height", {{"value", 4.5}}}});
  differ.compare("seed", printed.at("seed").get<int>(), 3);
  differ.holds("interval of the hazard", found.at("interval").at(0).get<double>() < probability &&
                                             found.at("interval").at(1).get<double>() > probability);

  const std::string text = squeezed(program.run({"capacity", "hazard.toml"}, {{"--no-plots", {}}}));
  differ.contains("printed probability", text,
                  fmt::format("probability of failure per impact {:.4g}, 95 %: {:.4g} to {:.4g}", probability,
                              found.at("interval").at(0).get<double>(), found.at("interval").at(1).get<double>()));

  // Two equally probable rocks of a table, of which one is stopped.
  program.write("rocks.csv", "height [m],mass [kg],speed [m/s]\n4.5,200,4\n4.5,200,11\n");
  program.write("table.toml", question(4, "[hazard]\ntable = \"rocks.csv\"\nruns = 200\n"));
  const Json table = program.json({"capacity", "table.toml"}, {{"--no-plots", {}}, {"--json", {}}}).at("hazard");
  findings.expect("expected rocks: probability of failure of a table, deviation from one half",
                  (table.at("probability_of_failure").get<double>() - 0.5) / std::sqrt(0.25 / 200.0), 0.0,
                  Tolerance::model(4.0, "in standard deviations of 200 runs"));
  differ.compare("rocks of a table", table.at("rocks"), Json{{"table", "rocks.csv"}, {"rows", 2}});
  const Json& forces = table.at("outputs").at("fence.cable_force");
  differ.holds("force that broke the cable",
               std::abs(forces.at("p95").at("value").get<double>() / strength - 1.0) < 0.01);
}

void check_drawn_rocks(const Program& program, Findings& findings, Differences& differ) {
  constexpr int runs = 400;
  program.write("fence.toml", fence(guided));
  program.write("drawn.toml",
                fmt::format("base = \"fence.toml\"\nmass = [\"100 kg\", \"800 kg\"]\nspeed = [\"2 m/s\", \"4 m/s\"]\n"
                            "[map]\ncells = 1\nfirst_cells = 1\nruns = 4\naudit = 0\n"
                            "[changes]\nspeed = 1e-9\nheight = \"0 m\"\n"
                            "[hazard]\nmass = {{ p95 = \"300 kg\", p99 = \"400 kg\" }}\n"
                            "speed = {{ p95 = \"9 m/s\", p99 = \"12 m/s\" }}\n"
                            "height = {{ p95 = \"4.6 m\", p99 = \"4.7 m\" }}\nruns = {}\n",
                            runs));
  differ.contains(
      "printed percentiles of rocks", program.run({"capacity", "drawn.toml"}, {{"--no-plots", {}}}),
      "\n  mass 300 kg (95 %), 400 kg (99 %); speed 9 m/s (95 %), 12 m/s (99 %); height 4.6 m (95 %), 4.7 m "
      "(99 %)\n");
  program.run({"sweep", "collect", "drawn"});
  const records::Csv results = compared_sweep(program, "drawn", differ);
  // Standard normal numbers, from the definition of the percentiles.
  std::array<std::vector<double>, 3> numbers;
  const auto add = [&](std::size_t of, double value, double p95, double p99) {
    numbers[of].push_back(z95 + (z99 - z95) * std::log(value / p95) / std::log(p99 / p95));
  };
  std::map<std::string, int> ends;
  std::map<std::string, std::vector<double>> outputs;
  for (std::size_t row = 0; row < results.rows(); ++row) {
    const double height = results.number(row, "fence.rock[0].position[1] [m]") - ground_top;
    if (std::abs(height + ground_top) < 1e-9) continue;  // a rock of the map
    std::string end{results.cell(row, "verdict")};
    std::ranges::replace(end, ' ', '_');
    ++ends[end];
    for (const auto& [output, column] : {std::pair{"fence.anchor_force", "fence.anchor_force [N]"},
                                         std::pair{"fence.cable_force", "fence.cable_force [N]"},
                                         std::pair{"fence.hanger_force", "fence.hanger_force [N]"},
                                         std::pair{"fence.cable_margin", "fence.cable_margin"},
                                         std::pair{"fence.exit_energy", "fence.exit_energy [N m]"}})
      outputs[output].push_back(results.number(row, column));
    add(0, results.number(row, "fence.rock[0].mass [kg]"), 300.0, 400.0);
    add(1, -results.number(row, "fence.rock[0].velocity[0] [m/s]"), 9.0, 12.0);
    add(2, height, 4.6, 4.7);
  }
  differ.compare("drawn rocks", numbers[0].size(), std::size_t{runs});
  const Json hazard = program.file("drawn/capacity.json").at("hazard");
  differ.compare("percentiles of rocks", hazard.at("rocks"),
                 Json{{"mass", {{"p95", 300.0}, {"p99", 400.0}}},
                      {"speed", {{"p95", 9.0}, {"p99", 12.0}}},
                      {"height", {{"p95", 4.6}, {"p99", 4.7}}}});
  for (const auto& [end, count] : hazard.at("ends").items())
    differ.compare("ends of expected rocks: " + end, count.get<int>(), ends[end]);
  double quantiles = 0.0;
  for (auto& [output, values] : outputs) {
    std::ranges::sort(values);
    const Json& of = hazard.at("outputs").at(output);
    differ.compare("runs of expected rocks: " + output, of.at("runs").get<std::size_t>(), values.size());
    keep_worst(quantiles, quantile_error(of.at("median"), values, 0.5));
    keep_worst(quantiles, quantile_error(of.at("p95"), values, 0.95));
  }
  findings.expect(
      "expected rocks: quantiles of forces and energies, and their intervals, over those of the rows of "
      "the runs, largest deviation from 1",
      quantiles, 0.0, Tolerance::round_off(1e-14, "numbers with all digits; two products and a sum"));
  // Four standard deviations of the mean and of the mean square of n normal numbers, and of their products.
  const double bound = 4.0 / std::sqrt(static_cast<double>(runs));
  for (std::size_t a = 0; a < numbers.size(); ++a) {
    double mean = 0.0, square = 0.0;
    for (const double value : numbers[a])
      mean += value / runs, square += value * value / runs;
    differ.holds(fmt::format("mean of drawn numbers {}", a), std::abs(mean) < bound);
    differ.holds(fmt::format("mean square of drawn numbers {}", a),
                 std::abs(square - 1.0) < bound * std::numbers::sqrt2);
    const std::size_t b = (a + 1) % numbers.size();
    double product = 0.0;
    for (std::size_t i = 0; i < numbers[a].size(); ++i)
      product += numbers[a][i] * numbers[b][i] / runs;
    differ.holds(fmt::format("drawn numbers {} and {} are independent", a, b), std::abs(product) < bound);
  }
}

}  // namespace talus::verification::problems::fence_capacity
