#include "verification/problems/program/pictures/drawn_histories.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <sstream>

#include "verification/record/csv.hpp"
#include "verification/study/findings/expectations.hpp"

namespace talus::verification::problems::picture_options {
namespace {

namespace fs = std::filesystem;

std::vector<std::string> labels(const std::vector<Curve>& curves) {
  std::vector<std::string> found;
  for (const Curve& curve : curves)
    found.push_back(curve.label);
  return found;
}

/// Largest error of the points of a curve, over the larger of 1 and the exact number, up to a time; NaN if the number
/// of points differs.
double curve_error(const Panel& panel, std::size_t curve, const std::string& x, const std::string& y, int disc,
                   int last) {
  double worst = 0.0;
  if (curve >= panel.curves.size() || panel.curves[curve].lines.size() != 1) return std::nan("");
  const std::vector<Point>& points = panel.curves[curve].lines.front();
  if (points.size() != static_cast<std::size_t>(last) + 1) return std::nan("");
  for (int n = 0; n <= last; ++n) {
    const double t = n * step;
    const auto error = [&](double drawn, double right) { return (drawn - right) / std::max(1.0, std::abs(right)); };
    const Point& point = points[static_cast<std::size_t>(n)];
    keep_worst(worst, error(point[0], x.empty() ? t : exact(x, disc, t)));
    keep_worst(worst, error(point[1], exact(y, disc, t)));
  }
  return worst;
}

/// `talus plot` with every option at once.
double check_chosen_histories(const Pictures& program, Differences& differ) {
  (void)program.run({"plot", "out"}, {{"--history", {"x,y,vx"}},
                                      {"--element", {"disc2,disc5"}},
                                      {"--x", {"vy"}},
                                      {"--until", {"0.5 s"}},
                                      {"--apart", {}},
                                      {"--columns", {"3"}},
                                      {"--x-limits", {"-12", "12"}},
                                      {"--y-limits", {"-3", "9"}},
                                      {"--x-title", {"words below"}},
                                      {"--y-title", {"words beside"}},
                                      {"--divisions", {"6", "4"}},
                                      {"--no-grid", {}},
                                      {"--format", {"svg,ps"}},
                                      {"--out", {"pictures"}},
                                      {"--name", {"mine"}},
                                      {"--title", {"Mine"}}});
  differ.compare("plot: files", program.files("pictures"), Names{"mine.ps", "mine.svg"});
  check_formats(program, "pictures/mine", {"svg", "ps"}, differ);
  const Picture picture = program.picture("pictures/mine.svg");
  differ.compare("plot: title", picture.texts, Names{"Mine"});
  differ.compare("plot: panels", picture.panels.size(), 3UL);
  std::set<double> margins;
  double worst = picture.panels.size() == 3 ? 0.0 : std::nan("");
  const std::vector<std::string> quantities{"x", "y", "vx"};
  for (std::size_t i = 0; i < std::min(quantities.size(), picture.panels.size()); ++i) {
    const Panel& panel = picture.panels[i];
    margins.insert(panel.left);
    differ.compare("plot: title of the abscissa", panel.x_label, std::string{"words below"});
    differ.compare("plot: title of the ordinate", panel.y_label, std::string{"words beside"});
    differ.compare("plot: limits of the abscissa", panel.x_range, Numbers{-12.0, 12.0});
    differ.compare("plot: limits of the ordinate", panel.y_range, Numbers{-3.0, 9.0});
    differ.compare("plot: divisions of the abscissa", panel.x_tics, Numbers{-12.0, 4.0});
    differ.compare("plot: divisions of the ordinate", panel.y_tics, Numbers{-3.0, 3.0});
    differ.compare("plot: grid", panel.grid, false);
    differ.compare("plot: curves", labels(panel.curves), std::vector<std::string>{"disc2", "disc5"});
    keep_worst(worst, curve_error(panel, 0, "vy", quantities[i], 2, steps_shown));
    keep_worst(worst, curve_error(panel, 1, "vy", quantities[i], 5, steps_shown));
  }
  differ.compare("plot: panels side by side", margins.size(), 3UL);
  return worst;
}

/// What `talus plot` draws without options: all panels, the eight curves with the largest range, three formats.
double check_default_histories(const Pictures& program, Differences& differ) {
  const std::string noted = program.run({"plot", "out"}, {{"--history", {"y"}}});
  differ.holds("plot: printed number of curves", noted.starts_with("panel [m]: 8 of 10 curves drawn, "));
  differ.compare("plot: files without options", program.files("out/plots"),
                 Names{"history_y.pdf", "history_y.png", "history_y.svg"});
  check_formats(program, "out/plots/history_y", {"pdf", "png", "svg"}, differ);
  (void)program.run({"plot", "out"}, {{"--history", {"y"}}, {"--all", {}}, {"--name", {"every"}}});
  // Range of y over the states: the largest is that of disc 1 or 10, whose displacement up or down is largest.
  std::vector<std::pair<double, int>> ranges;
  for (int i = 1; i <= discs; ++i) {
    double low = 0.0, high = 0.0;
    for (int n = 0; n <= steps; ++n)
      low = std::min(low, exact("y", i, n * step)), high = std::max(high, exact("y", i, n * step));
    ranges.emplace_back(high - low, i);
  }
  std::ranges::sort(ranges, std::greater{});
  Names widest, all;
  for (const auto& [range, i] : ranges) {
    if (widest.size() < 8) widest.insert(name_of(i));
    all.insert(name_of(i));
  }
  const auto drawn = [&](const std::string& file) {
    Names found;
    const Picture picture = program.picture(file);
    for (const Panel& panel : picture.panels)
      for (const std::string& each : labels(panel.curves))
        found.insert(each);
    return found;
  };
  differ.compare("plot: curves with the largest range", drawn("out/plots/history_y.svg"), widest);
  differ.compare("plot: all curves", drawn("out/plots/every.svg"), all);
  const Picture every = program.picture("out/plots/every.svg");
  double worst = every.panels.size() == 1 ? 0.0 : std::nan("");
  for (int i = 1; i <= discs && every.panels.size() == 1; ++i)
    keep_worst(worst, curve_error(every.panels.front(), static_cast<std::size_t>(i) - 1, "", "y", i, steps));

  // Of two runs the four quantities with the largest range, each of both runs.
  fs::copy(program.folder().path() / "out", program.folder().path() / "again", fs::copy_options::recursive);
  (void)program.run({"plot", "out", "again"}, {{"--history", {"y"}}, {"--format", {"svg"}}, {"--out", {"both"}}});
  const auto widest_of = [&](const std::vector<std::string>& runs) {
    Names found;
    for (const std::string& run : runs)
      for (std::size_t k = 0; k < 4; ++k)
        found.insert(fmt::format("{}, {}", run, name_of(ranges[k].second)));
    return found;
  };
  differ.compare("plot: curves of two runs with the largest range", drawn("both/history_y.svg"),
                 widest_of({"out", "again"}));

  // A shorter run has a part of each path, so that the largest ranges of both are those of the whole one. In 0.25 s
  // disc 1 returns to its start, (1 + 1/4)/4 - 5/16 = 0, and is not among the first four of that run alone.
  (void)talus_output(program.folder(), {"run", "scene.toml", "--end", "0.25 s", "--out", "short"});
  (void)program.run({"plot", "out", "short"}, {{"--history", {"y"}}, {"--format", {"svg"}}, {"--out", {"unequal"}}});
  differ.compare("plot: curves of two unequal runs with the largest range", drawn("unequal/history_y.svg"),
                 widest_of({"out", "short"}));

  (void)program.run({"plot", "out"}, {{"--all", {}}, {"--format", {"svg"}}, {"--out", {"whole"}}});
  const Picture positions = program.picture("whole/positions.svg");
  std::vector<std::string> columns;
  for (int i = 1; i <= discs; ++i)
    columns.push_back(name_of(i) + ".x"), columns.push_back(name_of(i) + ".y");
  const bool whole = positions.panels.size() == 1;
  differ.compare("plot: positions of a whole run", whole ? labels(positions.panels.front().curves) : columns, columns);
  if (!whole) return std::nan("");
  for (std::size_t k = 0; k < columns.size(); ++k)
    keep_worst(worst, curve_error(positions.panels.front(), k, "", k % 2 == 0 ? "x" : "y", static_cast<int>(k / 2) + 1,
                                  steps));
  return worst;
}

/// The largest whole numbers that options of `talus plot` take by its help, 6 and 100, and those after them.
void check_largest_numbers(const Pictures& program, Differences& differ) {
  const auto plot = [&](const std::string& columns, const std::string& divisions) {
    return run_talus(program.folder(),
                     {"plot",     "out", "--history",  "x,y,vx,vy", "--apart", "--columns",   columns,   "--x-limits",
                      "0",        "100", "--y-limits", "-100",      "100",     "--divisions", divisions, divisions,
                      "--format", "svg", "--out",      "largest",   "--name",  "most"},
                     recorded_pictures());
  };
  differ.compare("plot: exit status with the largest numbers", plot("6", "100").exit_code, 0);
  const Picture picture = program.picture("largest/most.svg");
  differ.compare("plot: panels with the largest numbers", picture.panels.size(), 4UL);
  std::set<double> margins;
  for (const Panel& panel : picture.panels) {
    margins.insert(panel.left);
    // Both windows over a hundred parts: 100/100 and 200/100.
    differ.compare("plot: maximum divisions of the abscissa", panel.x_tics, Numbers{0.0, 1.0});
    differ.compare("plot: maximum divisions of the ordinate", panel.y_tics, Numbers{-100.0, 2.0});
  }
  differ.compare("plot: four panels in six columns", margins.size(), 4UL);
  differ.ended("plot: seven columns", plot("7", "100"), 2, "found 7; it must be a whole number between 1 and 6");
  differ.ended("plot: 101 divisions", plot("6", "101"), 2, "found 101; it must be a whole number between 1 and 100");
}

/// Angle and spin of a body by their names and codes of 1993.
void check_turning(const Pictures& program, Differences& differ) {
  constexpr double angle = 0.25, spin = 3.0;
  program.folder().write(
      "turning.toml",
      fmt::format(
          "units = \"SI\"\n[[body]]\nname = \"wheel\"\nmobility = \"free\"\nmass = \"1 kg\"\n"
          "inertia = \"1 kg m^2\"\nposition = [\"0 m\", \"0 m\"]\nangle = \"{} rad\"\nspin = \"{} rad/s\"\n[run]\n"
          "integrator = \"velocity_verlet\"\nstep = \"0.1 s\"\nend = \"1 s\"\n"
          "interval = \"0.1 s\"\n",
          angle, spin));
  (void)talus_output(program.folder(), {"run", "turning.toml", "--out", "turning"});
  for (const auto& [requested, rate] :
       {std::pair{"theta", spin}, std::pair{"omega", 0.0}, std::pair{"angle", spin}, std::pair{"spin", 0.0}}) {
    (void)program.run({"plot", "turning"},
                      {{"--history", {requested}}, {"--format", {"svg"}}, {"--name", {"requested"}}});
    const Picture drawn = program.picture("turning/plots/requested.svg");
    const std::string item = fmt::format("plot: history {}", requested);
    const bool one =
        drawn.panels.size() == 1 && drawn.panels[0].curves.size() == 1 && drawn.panels[0].curves[0].lines.size() == 1;
    differ.holds(item, one);
    if (!one) continue;
    differ.compare(item + ", points", drawn.panels[0].curves[0].lines[0].size(), 11UL);
    for (const Point& point : drawn.panels[0].curves[0].lines[0])
      differ.holds(item + ", values", std::abs(point[1] - (rate > 0.0 ? angle + rate * point[0] : spin)) < 1e-7);
  }
}

/// The list of what can be drawn against the columns of history.csv.
void check_list(const Pictures& program, Differences& differ) {
  const records::Csv history = records::read_csv(program.folder().path() / "out/history.csv");
  Names columns, listed;
  for (const std::string& head : history.header())
    if (!head.starts_with("time ")) columns.insert(head);
  std::istringstream lines{program.run({"plot", "out"}, {{"--list", {}}})};
  for (std::string line; std::getline(lines, line);) {
    const std::size_t unit = line.find(" [");
    if (!line.starts_with("  ") || unit == std::string::npos) continue;
    std::string name = line.substr(0, line.find_last_not_of(' ', unit) + 1);
    name = name.substr(name.rfind(' ') + 1);
    const std::string dimension = line.substr(unit, line.find(']') + 1 - unit);
    const std::size_t last_gap = line.rfind("  ");
    std::istringstream elements{line.substr(last_gap)};
    bool any = false;
    for (std::string element; std::getline(elements, element, ',');) {
      element = element.substr(std::min(element.find_first_not_of(' '), element.size()));
      if (element.empty() || element.find('[') != std::string::npos) continue;
      listed.insert(fmt::format("{}.{}{}", element, name, dimension));
      any = true;
    }
    if (!any) listed.insert(name + dimension);
  }
  differ.compare("plot: list of columns", listed, columns);
}

}  // namespace

double check_histories(const Pictures& program, const Setup& setup, Differences& differ) {
  double worst = check_chosen_histories(program, differ);
  keep_worst(worst, check_default_histories(program, differ));
  check_list(program, differ);
  if (setup.fault.empty()) {
    check_turning(program, differ);
    check_largest_numbers(program, differ);
  }
  return worst;
}

}  // namespace talus::verification::problems::picture_options
