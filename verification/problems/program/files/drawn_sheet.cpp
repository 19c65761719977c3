#include "verification/problems/program/files/drawn_sheet.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <sstream>
#include <string>
#include <vector>

#include "verification/problems/program/pictures/picture_script.hpp"
#include "verification/study/findings/expectations.hpp"
#include "verification/study/program/program_options.hpp"

namespace talus::verification::problems::two_rocks {
namespace {

using picture_options::between;
using picture_options::Point;
using records::Json;

/// Polylines by the name of their block of data.
using Blocks = std::map<std::string, std::vector<std::vector<Point>>>;

Blocks drawn_blocks(const std::string& script) {
  Blocks blocks;
  std::string name;
  bool begins = true;
  std::istringstream rows{script};
  for (std::string row; std::getline(rows, row);) {
    if (row.starts_with("$")) {
      name = row.substr(1, row.find(' ') - 1), begins = true;
    } else if (row == "EOD") {
      name.clear();
    } else if (row.empty()) {
      begins = true;
    } else if (!name.empty()) {
      if (begins) blocks[name].emplace_back();
      begins = false;
      Point point{};
      std::istringstream{row} >> point[0] >> point[1];
      blocks[name].back().push_back(point);
    }
  }
  return blocks;
}

constexpr std::array<const char*, 3> forces{"hanger", "top", "bottom"};

/// A later state of the same time is drawn in place of this one.
bool is_hidden(const Json& states, std::size_t s) {
  return s + 1 < states.size() && states[s].at("time") == states[s + 1].at("time");
}

/// The view along the fence of one state: cables and columns of the first layer, at z and at -z. Columns are drawn as
/// wide as leaves a gap of 16 % of their spacing.
std::vector<std::vector<Point>> seen_along(const Json& sheet, const Json& state) {
  std::vector<std::vector<Point>> lines;
  const double half = 0.42 * sheet.at("fence").at("spacing").get<double>();
  for (const double side : {1.0, -1.0}) {
    for (const Json& cable : state.at("cables")) {
      if (cable.at("layer") != 1) continue;
      std::vector<Point>& line = lines.emplace_back();
      for (const Json& end : cable.at("ends"))
        line.push_back({side * end[2].get<double>(), end[1].get<double>()});
    }
    for (const Json& column : sheet.at("columns")) {
      if (column.at("layer") != 1) continue;
      const double z = side * column.at("along").get<double>();
      std::vector<double> heights;
      for (const Json& body : state.at("bodies"))
        for (const Json& point : body.at("outline"))
          if (body.at("name") == column.at("name")) heights.push_back(point[1].get<double>());
      const auto [low, high] = std::ranges::minmax(heights);
      lines.push_back({{z - half, low}, {z + half, low}, {z + half, high}, {z - half, high}, {z - half, low}});
    }
  }
  return lines;
}

Blocks expected_blocks(const Json& sheet) {
  Blocks blocks;
  const Json &drawing = sheet.at("drawing"), &states = drawing.at("states"), &rows = sheet.at("history").at("rows");
  const auto names = sheet.at("history").at("columns").get<std::vector<std::string>>();
  const auto add = [&](const std::string& block, const Json& points) {
    std::vector<Point>& line = blocks[block].emplace_back();
    for (const Json& point : points)
      line.push_back({point[0].get<double>(), point[1].get<double>()});
  };
  const auto add_history = [&](const std::string& block, const std::string& x, const std::string& y, double unit) {
    const auto column = [&](const std::string& name) {
      return static_cast<std::size_t>(std::ranges::find(names, name) - names.begin());
    };
    std::vector<Point>& line = blocks[block].emplace_back();
    for (const Json& row : rows)
      line.push_back({row.at(column(x)).get<double>(), row.at(column(y)).get<double>() / unit});
  };
  add("ground", drawing.at("ground"));
  for (std::size_t r = 0; r < sheet.at("rocks").size(); ++r) {
    const std::string rock = sheet.at("rocks")[r].at("name").get<std::string>();
    add_history(fmt::format("path{}", r), rock + ".x", rock + ".y", 1.0);
  }
  for (std::size_t s = 0; s < states.size(); ++s) {
    if (is_hidden(states, s)) continue;
    for (const Json& body : states[s].at("bodies")) {
      // The rocks, and the columns behind them in the middle of the fence.
      const bool is_central = std::ranges::any_of(sheet.at("columns"), [&](const Json& column) {
        return column.at("name") == body.at("name") && column.at("along") == 0.0;
      });
      if (body.at("layer") == 0 || is_central) add(fmt::format("bodies{}", s), body.at("outline"));
    }
    for (const Json& cable : states[s].at("cables"))
      add(fmt::format("cables{}", s), cable.at("ends"));
    blocks[fmt::format("front{}", s)] = seen_along(sheet, states[s]);
  }
  constexpr double kilonewton = 1e3;
  for (std::size_t i = 0; i < forces.size(); ++i) {
    const std::string block = fmt::format("force{}", i);
    add_history(block, "time", forces[i], kilonewton);
    const auto acts = [](const Point& point) { return point[1] > 0.0; };
    if (std::ranges::none_of(blocks.at(block).front(), acts)) blocks.erase(block);
  }
  return blocks;
}

/// The title of the curve of a block; empty without one.
std::string title_of(const std::string& script, const std::string& block) {
  return between(between(script, "$" + block + " using", "\n"), "title '", "'");
}

}  // namespace

void check_drawn_sheet(const TemporaryFolder& folder, const Json& sheet, Findings& findings) {
  const std::string page = folder.read("out/sheet.html");
  const std::string script = between(page, "<div class=\"page\">", "</div>");
  const Blocks drawn = drawn_blocks(script), expected = expected_blocks(sheet);
  Differences differ;
  double worst = 0.0;
  differ.compare("number of blocks", drawn.size(), expected.size());
  for (const auto& [name, lines] : expected) {
    const auto found = drawn.find(name);
    differ.compare("lines of " + name, found == drawn.end() ? 0 : found->second.size(), lines.size());
    if (found == drawn.end() || found->second.size() != lines.size()) continue;
    for (std::size_t i = 0; i < lines.size(); ++i) {
      differ.compare("points of " + name, found->second[i].size(), lines[i].size());
      for (std::size_t k = 0; k < std::min(found->second[i].size(), lines[i].size()); ++k)
        for (const std::size_t axis : {0UL, 1UL}) {
          const double there = found->second[i][k][axis], exact = lines[i][k][axis];
          keep_largest(worst, there == exact ? 0.0 : there / exact - 1.0);
        }
    }
  }
  differ.holds("drawing for phones", drawn == drawn_blocks(between(page, "<div class=\"phone\">", "</div>")));
  for (std::size_t i = 0; i < forces.size(); ++i) {
    const std::string block = fmt::format("force{}", i);
    if (!expected.contains(block)) continue;
    differ.compare("title of a force", title_of(script, block), std::string{forces[i]} + (i == 0 ? "" : " cable"));
  }
  const Json& states = sheet.at("drawing").at("states");
  for (std::size_t s = 0; s < states.size(); ++s) {
    if (is_hidden(states, s)) continue;
    differ.compare(
        "title of a state", title_of(script, fmt::format("front{}", s)),
        fmt::format("{}, {:.4g} s", states[s].at("name").get<std::string>(), states[s].at("time").get<double>()));
  }
  findings.expect("sheet: points of the drawing, largest relative error", worst, 0.0,
                  Tolerance::model(5.1e-6, "half a unit of the sixth digit"));
  differ.expect_none(findings, "sheet: lines and titles of the drawing that differ from sheet.json",
                     "paths, bodies, cables, both halves of the fence and forces, also in the drawing for phones");
}

}  // namespace talus::verification::problems::two_rocks
