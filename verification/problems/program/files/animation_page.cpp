#include "verification/problems/program/files/animation_page.hpp"

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "verification/record/csv.hpp"
#include "verification/record/json_node.hpp"
#include "verification/study/findings/expectations.hpp"

namespace talus::verification::problems::two_rocks {

using records::Json;
using records::Node;

void check_animation_page(const TemporaryFolder& folder, Findings& findings, const Setup& setup) {
  (void)talus_output(folder, {"animate", "out"});
  const std::string page = folder.read("out/plots/animation.html"), begin = "id=\"data\">";
  const std::size_t from = page.find(begin) + begin.size();
  const Json data = Json::parse(page.substr(from, page.find("</script>", from) - from));
  const Node player{data, "animation.html"};
  const std::vector<GeometryState> states = geometry_states(folder, "out", "fence");
  const std::vector<Node> frames = player.at("frames").list(), bodies = player.at("bodies").list();
  findings.expect("animation: frames", static_cast<double>(frames.size()), static_cast<double>(states.size()),
                  Tolerance::exact("one for each state of the geometry"));
  double outlines = 0.0, cables = 0.0;
  const auto compare = [](double& worst, double found, double exact, double scale) {
    keep_worst(worst, (found - exact) / scale);
  };
  for (std::size_t f = 0; f < std::min(frames.size(), states.size()); ++f) {
    const std::string& text = states[setup.has("frame_one_late") ? (f + 1) % states.size() : f].text;
    const std::vector<double> points = data_array(text, "Points"), offsets = data_array(text, "offsets"),
                              tensions = data_array(text, "tension");
    compare(outlines, frames[f].at("t").number(), states[f].time, states.back().time);
    const std::vector<Node> poses = frames[f].at("bodies").list(), lines = frames[f].at("cables").list();
    std::size_t point = 0;
    for (std::size_t line = 0; line < offsets.size(); ++line) {
      const auto past = static_cast<std::size_t>(offsets[line]);
      if (line < bodies.size()) {
        const std::vector<Node> outline = bodies[line].at("outline").list(), pose = poses.at(line).list();
        const double x = pose.at(0).number(), y = pose.at(1).number(), c = std::cos(pose.at(2).number()),
                     s = std::sin(pose.at(2).number());
        // The animation draws the ground longer than the VTK file does.
        const bool ground = bodies[line].at("kind").text() == "ground";
        for (std::size_t i = 0; point < past; ++point, ++i) {
          if (ground) continue;
          const double u = outline.at(i).list().at(0).number(), v = outline[i].list().at(1).number();
          compare(outlines, x + c * u - s * v, points.at(3 * point), 1.0);
          compare(outlines, y + s * u + c * v, points.at(3 * point + 1), 1.0);
        }
        continue;
      }
      const std::vector<Node> cable = lines.at(line - bodies.size()).list();
      for (std::size_t i = 0; point < past; ++point)
        for (std::size_t axis = 0; axis < 3; ++axis, ++i)
          compare(cables, cable.at(i).number(), points.at(3 * point + axis), 30.0);
      compare(cables, cable.at(6).number(), tensions.at(line), 1e5);
    }
  }
  // Charts are of history.csv, which has a row for each state.
  const records::Csv history = records::read_csv(folder.path() / "out/history.csv");
  const std::vector<double> times = column(history, "time");
  double charts = 0.0;
  std::size_t energies = 0, tensions = 0;
  for (const Node& chart : player.at("charts").list()) {
    for (const Node& series : chart.at("series").list()) {
      const std::string name = series.at("name").text();
      energies += name.starts_with("energy.") ? 1 : 0, tensions += name.ends_with(".tension") ? 1 : 0;
      const std::vector<double> values = column(history, name);
      double scale = 0.0;
      for (const double value : values)
        keep_largest(scale, value);
      const std::vector<Node> at = series.at("at").list();
      for (std::size_t f = 0; f < std::min(at.size(), states.size()); ++f) {
        const auto row = std::ranges::min_element(times, {}, [&](double t) { return std::abs(t - states[f].time); });
        compare(charts, at[f].number(), values[static_cast<std::size_t>(row - times.begin())], scale);
      }
      keep_worst(charts, static_cast<double>(at.size()) - static_cast<double>(states.size()));
    }
  }
  findings.expect_true("animation: charts of energies and of tensions", energies > 3 && tensions > 1,
                       "the run has both, in history.csv alone");
  findings.expect("animation: values of the charts at the states, over the largest, largest error", charts, 0.0,
                  Tolerance::model(5.1e-6, "half a unit of the sixth digit"));
  findings.expect("animation: outlines of the bodies, largest error", outlines, 0.0,
                  Tolerance::model(1.5e-5, "six digits: 5e-6 for each of two lengths and for an angle of up to 3.2"));
  findings.expect("animation: ends and tensions of the cables, largest error", cables, 0.0,
                  Tolerance::model(5.1e-6, "half a unit of the sixth digit"));
}

}  // namespace talus::verification::problems::two_rocks
