#include "verification/problems/program/pictures/drawn_fence.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <numbers>
#include <set>
#include <string>
#include <vector>

#include "verification/check/case_file.hpp"
#include "verification/problems/program/pictures/picture_script.hpp"
#include "verification/record/whole_file.hpp"

namespace talus::verification::problems::picture_options {
namespace {

/// Numbers of the deck [ft].
constexpr double half_span = 27.5, spacing = 2.5, column_half_width = 1.25, column_half_height = 4.0,
                 rock_radius = 1.201;
constexpr int columns_on_a_side = 6;
/// Coordinates are drawn with six digits.
constexpr double digits = 1e-4;

bool near(double a, double b) { return std::abs(a - b) < digits; }

struct Extent {
  double left{}, right{}, low{}, high{};
};
Extent extent_of(const std::vector<Point>& line) {
  const auto [left, right] = std::ranges::minmax(line, {}, [](const Point& p) { return p[0]; });
  const auto [low, high] = std::ranges::minmax(line, {}, [](const Point& p) { return p[1]; });
  return {left[0], right[0], low[1], high[1]};
}

/// The rock, which turns, is the only part with an outline of more points than a rectangle.
void check_outlines(const Panel& panel, Differences& differ) {
  std::set<Point> points, images;
  std::set<long> positions;
  std::size_t rocks = 0;
  for (const Curve& curve : panel.curves) {
    for (const std::vector<Point>& line : curve.lines) {
      const Extent extent = extent_of(line);
      const double middle = 0.5 * (extent.left + extent.right), half = 0.5 * (extent.right - extent.left);
      if (line.size() > 5) {
        ++rocks;
        differ.holds("half fence: rock in the middle", near(middle, 0.0));
        // Its outline has 96 corners.
        const double corner = rock_radius * (1.0 - std::cos(std::numbers::pi / 96.0)) + digits;
        differ.holds(
            "half fence: radius of the rock",
            std::abs(half - rock_radius) < corner && std::abs(0.5 * (extent.high - extent.low) - rock_radius) < corner);
        continue;
      }
      for (const Point& point : line)
        points.insert(point), images.insert({-point[0], point[1]});
      if (line.size() < 5) continue;
      positions.insert(std::lround(middle / spacing));
      differ.holds("half fence: spacing of the columns",
                   near(middle, spacing * static_cast<double>(std::lround(middle / spacing))));
      differ.holds("half fence: width of a column", near(half, column_half_width));
      differ.holds("half fence: height of a column",
                   std::abs(0.5 * (extent.high - extent.low) - column_half_height) < 0.01);
    }
  }
  differ.holds("half fence: mirror images", points == images);
  differ.holds("half fence: both anchors", !points.empty() && (*points.rbegin())[0] == half_span);
  differ.compare("half fence: rocks", rocks, std::size_t{1});
  differ.holds("half fence: columns on both sides", positions.size() == 2 * columns_on_a_side + 1 &&
                                                        *positions.begin() == -columns_on_a_side &&
                                                        *positions.rbegin() == columns_on_a_side);
}

/// Of two columns that are drawn behind each other or closer than a twentieth of the width, one mark has both numbers.
void check_numbers(const Panel& panel, Differences& differ) {
  const std::map<std::string, double> expected{
      {"2", 0.0}, {"3 .. 12", 0.0}, {"5 .. 14", 2.0}, {"7 .. 16", 4.0}, {"9, 17", 6.0}};
  differ.compare("half fence: marks", panel.marks.size(), expected.size());
  for (const auto& [text, position] : expected) {
    const auto mark = panel.marks.find(text);
    differ.holds("half fence: numbers " + text, mark != panel.marks.end() && near(mark->second[0], position * spacing));
  }
}

}  // namespace

void check_half_fence(const TemporaryFolder& folder, Differences& differ) {
  const Environment recorded = recorded_pictures();
  folder.write("half.DAT", records::read_whole(case_file("fence/sample2.DAT")));
  (void)talus_output(folder, {"run", "half.DAT", "--end", "1 ms", "--out", "half"});
  (void)talus_output(folder, {"snapshot", "half", "--view", "along", "--count", "1", "--numbers", "--format", "svg"},
                     recorded);
  const Picture picture = read_picture(folder.read("half/plots/snapshot_along.svg"));
  differ.compare("half fence: panels", picture.panels.size(), 1UL);
  if (picture.panels.size() != 1) return;
  const Panel& panel = picture.panels.front();
  check_outlines(panel, differ);
  check_numbers(panel, differ);
  const std::vector<double>& window = panel.x_range;
  differ.holds("half fence: window", window.size() == 2 && window[0] == -window[1] && window[1] > half_span);
}

}  // namespace talus::verification::problems::picture_options
