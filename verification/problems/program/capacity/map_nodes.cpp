#include "verification/problems/program/capacity/map_nodes.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <string>
#include <vector>

#include "verification/study/findings/sample_quantile.hpp"
#include "verification/study/program/table_units.hpp"

namespace talus::verification::problems::fence_capacity {

using records::Csv;

namespace {

/// The column called `name`, whatever its unit, with the size of the unit in SI.
struct Column {
  Column(const Csv& of, const std::string& name) : csv{&of} {
    for (; index < of.header().size(); ++index) {
      const TableHead head{of.header()[index]};
      if (head.name != name) continue;
      unit = head.unit.empty() ? 1.0 : size_of_unit(head.unit);
      return;
    }
  }

  /// In SI units; NaN for an empty cell, and without such a column.
  [[nodiscard]] double number(std::size_t row) const {
    if (index == csv->header().size() || csv->cell(row, index).empty()) return NAN;
    return csv->number(row, index) * unit;
  }

  const Csv* csv;
  std::size_t index{};
  double unit{1.0};
};

bool is_near(double found, double exact, double tolerance = 1e-14) {
  return std::abs(found - exact) <= tolerance * std::abs(exact);
}

/// Rows of the runs with this speed and radius, in SI.
std::vector<std::size_t> rows_of(const Csv& runs, double speed, double radius) {
  const Column a{runs, "fence.rock[0].a"}, vx{runs, "fence.rock[0].velocity[0]"}, vy{runs, "fence.rock[0].velocity[1]"};
  std::vector<std::size_t> rows;
  for (std::size_t row = 0; row < runs.rows(); ++row)
    if (is_near(a.number(row), radius, 1e-6) && is_near(std::hypot(vx.number(row), vy.number(row)), speed, 0.02))
      rows.push_back(row);
  return rows;
}

/// The median and the 95th percentile of an output at a node; no cells if no run has a value.
void compare_quantiles(const Csv& nodes, std::size_t node, const std::string& output, const Csv& runs,
                       const std::vector<std::size_t>& rows, Differences& differ) {
  const Column column{runs, output};
  std::vector<double> values;
  for (const std::size_t row : rows)
    if (const double value = column.number(row); !std::isnan(value)) values.push_back(value);
  // Runs without a limit have margins of 0; all have a force.
  if (output.ends_with("margin") && !values.empty() && std::ranges::max(values) == 0.0) values.clear();
  std::ranges::sort(values);
  for (const auto& [name, probability] : {std::pair{"median", 0.5}, {"p95", 0.95}}) {
    const double found = Column{nodes, fmt::format("{}.{}", output, name)}.number(node);
    differ.holds(fmt::format("{} of {} at a node", name, output),
                 values.empty() ? std::isnan(found) : is_near(found, sample_quantile(values, probability)));
  }
}

}  // namespace

std::array<double, 2> wilson(double k, double n) {
  constexpr double z2 = 1.959963984540054 * 1.959963984540054;
  const double half = std::sqrt(z2 * (k * (n - k) / n + 0.25 * z2));
  return {(k + 0.5 * z2 - half) / (n + z2), (k + 0.5 * z2 + half) / (n + z2)};
}

void compare_nodes(const Csv& nodes, const Csv& runs, const OwnRock& own, Differences& differ) {
  const Column mass{nodes, "mass"}, speed{nodes, "speed"};
  for (std::size_t node = 0; node < nodes.rows(); ++node) {
    const std::vector<std::size_t> rows =
        rows_of(runs, speed.number(node), own.radius * std::cbrt(mass.number(node) / own.mass));
    std::map<std::string, int> ends;
    for (const std::size_t row : rows) {
      std::string end{runs.cell(row, "verdict")};
      std::ranges::replace(end, ' ', '_');
      ++ends[runs.cell(row, "end") == "finished" ? end : "failed"];
    }
    const auto number = [&](const char* head) { return nodes.number(node, head); };
    const double n = static_cast<double>(rows.size()), stopped = ends["stopped"];
    differ.compare("runs of a node", number("runs"), n);
    for (const char* const end : {"stopped", "undecided", "passed_under", "passed_over", "broke_through", "failed"})
      differ.compare(fmt::format("runs of a node that are {}", end), number(end), static_cast<double>(ends[end]));
    differ.holds("probability at a node", is_near(number("probability"), stopped / n));
    const auto [low, high] = wilson(stopped, n);
    differ.holds("interval of the probability at a node", std::abs(number("probability_low") - low) < 1e-14 &&
                                                              std::abs(number("probability_high") - high) < 1e-14);
    const double energy = 0.5 * mass.number(node) * speed.number(node) * speed.number(node);
    differ.holds("energy at a node", is_near(Column{nodes, "kinetic_energy"}.number(node), energy));
    for (const std::string output : {"fence.anchor_force", "fence.cable_force", "fence.hanger_force",
                                     "fence.cable_margin", "fence.hanger_margin", "fence.exit_energy"})
      compare_quantiles(nodes, node, output, runs, rows, differ);
  }
}

}  // namespace talus::verification::problems::fence_capacity
