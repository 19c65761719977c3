#include "verification/problems/program/cells/cell_results.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <map>
#include <numbers>
#include <random>
#include <string>
#include <utility>
#include <vector>

#include "verification/problems/program/cells/written_cells.hpp"
#include "verification/study/findings/expectations.hpp"

namespace talus::verification::problems::cell_files {

using records::Node;

namespace {

/// A result of the summary as a function of means.
struct Result {
  const char* name;
  std::function<double(const Mean&)> of;
  double scale{};
  const char* unit{""};
  bool drifts{};  ///< a mean, of which the change between halves is reported
};

std::vector<Result> results_of(const Expected& expected) {
  const auto quotient = [](auto over, auto under) {
    return [=](const Mean& mean) { return over(mean) / under(mean); };
  };
  const auto of = [](Quantity quantity) { return [=](const Mean& mean) { return mean(quantity); }; };
  const auto ratio = [&](Quantity over, Quantity under) { return quotient(of(over), of(under)); };
  const auto deviation = [](const Mean& mean) {
    return std::sqrt(std::max(0.0, mean(depth_square) - mean(depth) * mean(depth)));
  };
  const auto binary = [](const Mean& mean) {
    return (mean(shear) - mean(multiple_shear)) / (mean(normal) - mean(multiple_normal));
  };
  const auto balance = [](const Mean& mean) { return (mean(shear) + mean(kinetic)) / mean(moment); };
  const double pressure = expected.steady(top_normal);
  return {{"stress_ratio_top", ratio(top_shear, top_normal), 1.0},
          {"stress_ratio_bottom", ratio(bottom_shear, bottom_normal), 1.0},
          {"top_shear", of(top_shear), pressure, "N/m^2", true},
          {"top_normal", of(top_normal), pressure, "N/m^2", true},
          {"bottom_shear", of(bottom_shear), pressure, "N/m^2", true},
          {"bottom_normal", of(bottom_normal), pressure, "N/m^2", true},
          {"depth", of(depth), diameter, "m", true},
          {"depth_deviation", deviation, diameter, "m"},
          {"solid_fraction", of(solid_fraction), 1.0, "", true},
          {"contact_time_fraction", of(touching), 1.0, "", true},
          {"multiple_fraction", ratio(multiple, contacts), 1.0},
          {"coordination", of(coordination), 1.0, "", true},
          {"multiple_shear_fraction", ratio(multiple_shear, shear), 1.0},
          {"multiple_stress_ratio", ratio(multiple_shear, multiple_normal), 1.0},
          {"binary_stress_ratio", binary, 1.0},
          {"kinetic_shear_fraction", ratio(kinetic, moment), 1.0},
          {"shear_balance", balance, 1.0}};
}

/// Means over series of the blocks after the start-up, drawn as sequences of `length` neighbours (circular block
/// bootstrap): 400 series, from the sequence of random numbers that the number of blocks starts.
std::vector<Mean> drawn_series(const Expected& expected, std::size_t length) {
  const std::size_t first = 25, blocks = expected.hundredths.size() - first;
  std::mt19937_64 random{blocks};
  std::vector<Mean> series(400);
  for (Mean& mean : series) {
    for (std::size_t drawn = 0; drawn < blocks;) {
      const std::size_t start = random() % blocks;
      for (std::size_t k = 0; k < length && drawn < blocks; ++k, ++drawn) {
        const Mean& block = expected.hundredths[first + (start + k) % blocks];
        mean.weight += block.weight;
        for (std::size_t q = 0; q < count; ++q)
          mean.sum[q] += block.sum[q];
      }
    }
  }
  return series;
}

/// Standard error of a result: scatter over the drawn series, about their mean, times 1/(1 - length/blocks).
double error_over(const std::vector<Mean>& series, std::size_t length, const Result& result) {
  double mean = 0.0, squares = 0.0, finite = 0.0;
  for (const Mean& drawn : series) {
    const double value = result.of(drawn);
    if (std::isfinite(value)) mean += value, finite += 1.0;
  }
  mean /= finite;
  for (const Mean& drawn : series) {
    const double value = result.of(drawn);
    if (std::isfinite(value)) squares += (value - mean) * (value - mean) / finite;
  }
  return std::sqrt(squares * 75.0 / (75.0 - static_cast<double>(length)));
}

/// Errors and changes between halves. The length of the blocks follows from the correlation of the series (case
/// mean_errors); here any length up to a third of the series may be the program's.
void check_errors(const Node& found, const Expected& expected, Findings& findings, const Setup& setup) {
  std::vector<std::vector<Mean>> series;
  for (std::size_t length = 1; length <= 25; ++length)
    series.push_back(drawn_series(expected, length));
  const auto mean_over = [&](std::size_t first, std::size_t last, const Result& result) {
    Mean mean;
    for (std::size_t block = first; block < last; ++block) {
      mean.weight += expected.hundredths[block].weight;
      for (std::size_t q = 0; q < count; ++q)
        mean.sum[q] += expected.hundredths[block].sum[q];
    }
    return result.of(mean);
  };
  double worst = 0.0, changes = 0.0;
  for (const Result& result : results_of(expected)) {
    const Node node = found.at(result.name);
    const double printed = node.has("error") ? node.at("error").number() : 0.0;
    double nearest = std::numeric_limits<double>::infinity(), own = 0.0;
    for (std::size_t k = 0; k < series.size(); ++k) {
      const double error = error_over(series[k], k + 1, result) * (setup.has("error_without_factor") ? 0.9 : 1.0);
      if (std::abs(error - printed) < nearest) nearest = std::abs(error - printed), own = error;
    }
    keep_worst(worst, (printed - own) / result.scale);
    const double change = mean_over(62, 100, result) - mean_over(25, 62, result);
    const double drift = node.has("drift") ? node.at("drift").number() : 0.0;
    // The difference of the means over two halves has four times the variance of the whole mean.
    keep_worst(changes, (drift * 2.0 * own - (result.drifts ? change : 0.0)) / result.scale);
  }
  findings.expect("summary.json: standard errors, largest difference to a bootstrap", worst, 0.0, of_paths());
  findings.expect("summary.json: drifts, largest difference to the change between halves", changes, 0.0, of_paths());
}

void check_parameters(const Node& summary, Findings& findings) {
  const Members exact{{"law", text_of("latching_spring")},
                      {"stiffness", number_of(k1)},
                      {"unloading_stiffness", number_of(k2)},
                      {"growth", number_of(0.0)},
                      {"diameter", number_of(diameter)},
                      {"mass", number_of(mass)},
                      {"gravity", number_of(gravity)},
                      {"block_mass", number_of(block_mass)},
                      {"block_speed", number_of(block_speed)},
                      {"rows", number_of(rows)},
                      {"columns", number_of(columns)},
                      {"wall_discs", number_of(wall_discs)},
                      {"overburden", number_of(block_mass * gravity / area)},
                      {"seed", number_of(0.0)},
                      {"integrator", text_of("euler_cromer")},
                      {"step", number_of(step)},
                      {"every", number_of(loop)},
                      {"end", number_of(end)},
                      {"historical", text_of("off")},
                      {"jump", text_of("off")},
                      {"images", text_of("nearest")}};
  const Members counts{{"discs", number_of(static_cast<double>(free_discs))},
                       {"wall_discs", number_of(2.0 * wall_discs)},
                       {"steps", number_of(steps)},
                       {"jumped", number_of(0.0)}};
  findings.expect("summary.json: parameters, counts and units that differ",
                  wrong_members(summary.at("parameters"), exact) + wrong_members(summary.at("counts"), counts) +
                      (summary.at("units").text() == "SI" ? 0.0 : 1.0),
                  0.0, Tolerance::exact("the numbers of CNTRL.DAT, to the last bits of quotients and products"));
}

}  // namespace

void check_summary(const Node& summary, const Expected& expected, const VirtualDiscs& before, const ProgramEnd& ended,
                   Findings& findings, const Setup& setup) {
  const Mean& mean = expected.steady;
  double worst = 0.0, texts = 0.0;
  const Node found = summary.at("results");
  std::map<std::string, std::string> units;
  for (const Result& result : results_of(expected)) {
    keep_worst(worst, (found.at(result.name).at("value").number() - result.of(mean)) / result.scale);
    if (*result.unit != '\0') units[result.name] = result.unit;
  }
  keep_worst(worst, found.at("largest_overlap").at("value").number() - expected.largest_overlap / diameter);
  keep_worst(worst, found.at("largest_solid_fraction").at("value").number() - expected.largest_fraction);
  findings.expect("summary.json: results", static_cast<double>(found.members().size()),
                  static_cast<double>(results_of(expected).size() + 2), Tolerance::exact("the results compared below"));
  findings.expect("summary.json: results, largest error", worst, 0.0, of_paths());
  if (setup.needs("summary.json: standard errors")) check_errors(found, expected, findings, setup);
  texts = wrong_texts(found, units, ended.output) + wrong_texts(summary.at("groups"), {}, ended.output) +
          wrong_warnings(summary, ended);
  findings.expect("summary.json: units, meanings and warnings that differ from those printed", texts, 0.0,
                  Tolerance::exact("the same texts"));
  check_parameters(summary, findings);

  const VirtualDiscs& discs = expected.states.back().discs;
  const auto kinetic_of = [](const VirtualDiscs& of) {
    double energy = 0.5 * block_mass * of.vy.back() * of.vy.back();
    for (std::size_t i = 0; i < free_discs; ++i)
      energy += 0.5 * mass * (of.vx[i] * of.vx[i] + of.vy[i] * of.vy[i]);
    return energy;
  };
  double stored = 0.0;  // energy recovered on the unloading branch, the stiffer one
  for (const VirtualDiscs::Contact& contact : discs.contacts)
    stored += 0.5 * contact.force * contact.force / k2;
  const double potential = block_mass * gravity * height_of(discs),
               first = kinetic_of(before) + block_mass * gravity * height_of(before);
  const double gained = kinetic_of(discs) + potential + stored + discs.lost - expected.work - first;
  const Node energy = summary.at("energy");
  double off = 0.0;
  for (const auto& [name, value] :
       {std::pair{"kinetic", kinetic_of(discs)}, std::pair{"potential", potential}, std::pair{"stored", stored},
        std::pair{"input", expected.work}, std::pair{"dissipated", discs.lost}, std::pair{"spurious_gain", gained}})
    keep_worst(off, (energy.at(name).number() - value) / expected.work);
  findings.expect("summary.json: energies at the end over the work of the drive, largest error", off, 0.0, of_paths());
  findings.expect("summary.json: energy balance error over the work",
                  energy.at("relative_balance_error").number() - gained / std::max(std::abs(expected.work), discs.lost),
                  0.0, of_paths());

  // The dimensionless groups by their definitions: semi-implicit Euler preserves amplitudes; two colliding discs have
  // the effective mass m/2.
  const double contact = 0.5 * std::numbers::pi * (std::sqrt(0.5 * mass / k1) + std::sqrt(0.5 * mass / k2));
  const double pressure = block_mass * gravity / area,
               density = mass / (0.25 * std::numbers::pi * std::pow(diameter, 3));
  double groups = 0.0;
  for (const auto& [name, value] :
       {std::pair{"restitution", 0.7}, std::pair{"stepped_restitution", 0.7},
        std::pair{"contact_steps", contact / step}, std::pair{"stiffness_number", k1 / (pressure * diameter)},
        std::pair{"inertial_number", block_speed / mean(depth) * diameter * std::sqrt(density / pressure)},
        std::pair{"contact_shear", contact * block_speed / mean(depth)},
        std::pair{"block_over_disc", block_mass / mass},
        std::pair{"columns_over_wall", static_cast<double>(columns) / wall_discs}})
    keep_worst(groups, summary.at("groups").at(name).at("value").number() / value - 1.0);
  findings.expect("summary.json: dimensionless groups, largest relative error", groups, 0.0, of_paths());
}

}  // namespace talus::verification::problems::cell_files
