#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <map>
#include <set>
#include <sstream>
#include <string>
#include <vector>

#include "verification/check/case.hpp"
#include "verification/record/csv.hpp"
#include "verification/record/json_node.hpp"
#include "verification/reference/constant_force.hpp"
#include "verification/study/expectations.hpp"
#include "verification/study/program_options.hpp"
#include "verification/study/program_run.hpp"

namespace talus::verification::problems::picture_options {
namespace {

namespace fs = std::filesystem;
using records::Json;

constexpr int discs = 10;
constexpr double gravity = 10.0, radius = 0.2, step = 0.05;
constexpr int steps = 20, steps_shown = 10;  ///< of the run, and up to the time of --until
constexpr double rope_y = 9.0, near_z = 0.5, far_z = 1.0;

std::string name_of(int disc) { return fmt::format("disc{}", disc); }
reference::ConstantForce along(int disc) { return {1.0 * disc, 0.5 * disc, 0.0}; }
reference::ConstantForce up(int disc) { return {0.0, disc + 0.25, -gravity}; }

/// A quantity of a disc at time t.
double exact(const std::string& quantity, int disc, double t) {
  const reference::ConstantForce flight = quantity.ends_with('x') ? along(disc) : up(disc);
  return quantity.starts_with('v') ? speed_at(flight, t) : place_at(flight, t);
}

std::string scene_text() {
  std::string text =
      fmt::format("title = \"Discs in free fall\"\nunits = \"SI\"\ngravity = [\"0 m/s^2\", \"{} m/s^2\"]\n", -gravity);
  for (int i = 1; i <= discs; ++i) {
    text += fmt::format(R"(
[[body]]
name = "{}"
mobility = "free"
mass = "1 kg"
inertia = "1 kg m^2"
shape = {{ kind = "circle", radius = "{} m" }}
position = ["{} m", "0 m"]
velocity = ["{} m/s", "{} m/s"]
)",
                        name_of(i), radius, along(i).place, along(i).speed, up(i).speed);
  }
  return text + fmt::format(R"(
[[cable]]
name = "rope"
law = "tension_only"
from = {{ body = "disc1", point = ["0 m", "0 m", "{} m"] }}
to = {{ point = ["0 m", "{} m", "{} m"] }}
stiffness = "100 N/m"
rest_length = "100 m"

[run]
integrator = "velocity_verlet"
step = "{} s"
end = "{} s"
interval = "{} s"
)",
                            near_z, rope_y, far_z, step, steps * step, step);
}

const std::string cell_text = R"(title = "Sheared discs"
units = "SI"
[cell]
stiffness = "1 kN/m"
unloading_stiffness = "2 kN/m"
diameter = "1 mm"
mass = "7.2e-7 kg"
gravity = "9.81 m/s^2"
overburden = "8 kPa"
rows = 4
columns = 5
wall_discs = 6
block_speed = "5 m/s"
[run]
step = "2 us"
every = "5 ms"
end = "20 ms"
pictures = "on"
)";

/// Takes the place of gnuplot: writes its script as each picture, after the dates of PDF and PostScript files, which
/// the program replaces.
const std::string recorder = R"(#!/bin/sh
sed -n "s/^set output '\(.*\)'$/\1/p" "$1" | while read -r file; do
  { echo '%%CreationDate: Thu Jan  1 00:00:00 1970'; echo '/CreationDate (D:19700101000000)'; cat "$1"; } > "$file"
done
)";

// --- scripts -------------------------------------------------------------------------------------------------------

using Point = std::array<double, 2>;

struct Curve {
  std::string label{};
  std::vector<std::vector<Point>> lines{};  ///< separated by empty rows
};

struct Panel {
  std::string title{}, x_label{}, y_label{};
  std::vector<double> x_range{}, y_range{}, x_tics{}, y_tics{};
  bool grid = true;
  double left{};  ///< margin
  std::vector<Curve> curves{};
  std::map<std::string, Point> marks{};
};

struct Picture {
  std::set<std::string> texts{};  ///< title and label of the colour scale
  std::vector<Panel> panels{};
};

/// Text between the first `before` and the next `after`; empty if there is none.
std::string between(const std::string& text, const std::string& before, const std::string& after) {
  const std::size_t from = text.find(before);
  if (from == std::string::npos) return {};
  const std::size_t begin = from + before.size(), end = text.find(after, begin);
  return end == std::string::npos ? "" : text.substr(begin, end - begin);
}

/// The numbers in a text, whatever separates them.
std::vector<double> numbers(std::string text) {
  for (char& letter : text)
    if (letter == ',' || letter == ':' || letter == '[' || letter == ']') letter = ' ';
  std::istringstream words{text};
  return {std::istream_iterator<double>{words}, {}};
}

Curve read_curve(std::istream& lines) {
  Curve curve;
  bool begins = true;
  for (std::string line; std::getline(lines, line) && line != "END";) {
    const std::vector<double> row = numbers(line);
    if (row.size() < 2) {
      begins = true;
      continue;
    }
    if (begins) curve.lines.emplace_back();
    begins = false;
    curve.lines.back().push_back({row[0], row[1]});
  }
  return curve;
}

/// Labels of the curves of a plot command, in order: "... title 'LABEL', ... notitle".
void label(std::vector<Curve>& curves, const std::string& command) {
  std::size_t at = 0;
  for (Curve& curve : curves) {
    at = command.find("title", at);
    if (at == std::string::npos) return;
    const std::string rest = command.substr(at);
    if (rest.starts_with("title '")) curve.label = between(rest, "'", "'");
    at += 5;
  }
}

/// Reads a script, or the part of it that draws one format or one frame.
Picture read_picture(const std::string& script) {
  Picture picture;
  Panel panel;
  std::istringstream lines{script};
  for (std::string line; std::getline(lines, line);) {
    const auto setting = [&](const std::string& name) { return line.starts_with("set " + name + " "); };
    const std::string quoted = between(line, "'", "'"), value = line.substr(line.find(' ', 4) + 1);
    if (line.starts_with("load ")) panel = {};
    if (line.starts_with("$")) panel.curves.push_back(read_curve(lines));
    if (setting("title")) panel.title = quoted;
    if (setting("xlabel")) panel.x_label = quoted;
    if (setting("ylabel")) panel.y_label = quoted;
    if (setting("xrange")) panel.x_range = numbers(value);
    if (setting("yrange")) panel.y_range = numbers(value);
    if (setting("xtics")) panel.x_tics = numbers(value);
    if (setting("ytics")) panel.y_tics = numbers(value);
    if (line == "unset grid") panel.grid = false;
    if (setting("lmargin")) panel.left = std::stod(line.substr(line.rfind(' ')));
    if (setting("label")) {
      const std::vector<double> place = numbers(between(line, " at ", " center"));
      if (place.size() == 2) panel.marks[quoted] = {place[0], place[1]};
      if (line.find(" at screen ") != std::string::npos) picture.texts.insert(quoted);
    }
    if (line.starts_with("plot $")) {
      label(panel.curves, line);
      picture.panels.push_back(panel);
    }
  }
  return picture;
}

/// The parts of a film's or page's script between "set multiplot" and "unset multiplot".
std::vector<std::string> pages(const std::string& script) {
  std::vector<std::string> found;
  for (std::size_t at = script.find("\nset multiplot"); at != std::string::npos;
       at = script.find("\nset multiplot", at + 1))
    found.push_back(script.substr(at, script.find("unset multiplot", at) - at));
  return found;
}

/// Names of the files of a folder.
std::set<std::string> files_of(const fs::path& folder) {
  std::set<std::string> names;
  if (!fs::exists(folder)) return names;
  for (const auto& entry : fs::directory_iterator(folder))
    names.insert(entry.path().filename().string());
  return names;
}

// --- the case ------------------------------------------------------------------------------------------------------

/// The program in a folder with a run of the discs in `out` and of a cell in `flow`.
class Pictures {
 public:
  explicit Pictures(const Setup& setup) : setup_{&setup} {
    fs::create_directory(folder_.path() / "tools");
    folder_.write("tools/gnuplot", recorder);
    fs::permissions(folder_.path() / "tools/gnuplot", fs::perms::owner_all);
    const char* const path = std::getenv("PATH");
    environment_["PATH"] = fmt::format("{}:{}", (folder_.path() / "tools").string(), path != nullptr ? path : "");
    folder_.write("scene.toml", scene_text());
    (void)talus_output(folder_, {"run", "scene.toml", "--out", "out", "--frames", fmt::format("{}", steps)});
  }

  std::string run(const std::vector<std::string>& command, const Options& options) const {
    return talus_output(folder_, with_options(command, options, *setup_), environment_);
  }
  /// The first page of a picture.
  Picture picture(const std::string& file) const {
    if (!fs::exists(folder_.path() / file)) return {};
    const std::string script = folder_.read(file);
    const std::vector<std::string> found = pages(script);
    return read_picture(found.empty() ? script : found.front());
  }
  std::set<std::string> files(const std::string& folder) const { return files_of(folder_.path() / folder); }
  const TemporaryFolder& folder() const { return folder_; }

 private:
  TemporaryFolder folder_;
  const Setup* setup_;
  Environment environment_;
};

using Names = std::set<std::string>;
using Numbers = std::vector<double>;

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
  (void)program.run({"plot", "out"}, {{"--history", {"y"}}});
  differ.compare("plot: files without options", program.files("out/plots"),
                 Names{"history_y.pdf", "history_y.png", "history_y.svg"});
  (void)program.run({"plot", "out"}, {{"--history", {"y"}}, {"--all", {}}, {"--name", {"every"}}});
  // Range of y over the states: the largest is that of disc 1 or 10, whose way up or down is longest.
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

/// Errors of discs and cable of a panel at step n: outlines, ends of the cable, numbers of the discs.
void check_state(const Panel& panel, int n, bool numbered, double& worst, Differences& differ) {
  const double t = n * step;
  if (panel.curves.size() != 2 || panel.curves[0].lines.size() != discs || panel.curves[1].lines.size() != 1) {
    worst = std::nan("");
    return;
  }
  for (int i = 1; i <= discs; ++i) {
    const double x = exact("x", i, t), y = exact("y", i, t);
    for (const Point& corner : panel.curves[0].lines[static_cast<std::size_t>(i) - 1])
      keep_worst(worst, std::hypot(corner[0] - x, corner[1] - y) - radius);
    const auto mark = panel.marks.find(fmt::format("{}", i));
    differ.compare("number of a disc", mark != panel.marks.end(), numbered && x < panel.x_range.at(1));
    if (mark != panel.marks.end()) keep_worst(worst, std::hypot(mark->second[0] - x, mark->second[1] - y));
  }
  const std::vector<Point>& rope = panel.curves[1].lines.front();
  keep_worst(worst, std::hypot(rope.front()[0] - exact("x", 1, t), rope.front()[1] - exact("y", 1, t)));
  keep_worst(worst, std::hypot(rope.back()[0], rope.back()[1] - rope_y));
}

double check_snapshots(const Pictures& program, Differences& differ) {
  (void)program.run({"snapshot", "out"}, {{"--times", {"0.1 s,0.5 s"}},
                                          {"--view", {"both"}},
                                          {"--window", {"-1", "-5", "11", "5"}},
                                          {"--numbers", {}},
                                          {"--divisions", {"3", "2"}},
                                          {"--no-grid", {}},
                                          {"--columns", {"2"}},
                                          {"--format", {"svg"}},
                                          {"--out", {"states"}},
                                          {"--name", {"mine"}},
                                          {"--title", {"Mine"}}});
  differ.compare("snapshot: files", program.files("states"), Names{"mine_side.svg", "mine_along.svg"});
  double worst = 0.0;
  const std::vector<int> shown{2, 10};
  for (const std::string view : {"side", "along"}) {
    const Picture picture = program.picture(fmt::format("states/mine_{}.svg", view));
    differ.compare("snapshot: title", picture.texts, Names{"Mine"});
    differ.compare("snapshot: panels", picture.panels.size(), shown.size());
    if (picture.panels.size() != shown.size()) return std::nan("");
    differ.compare("snapshot: side by side", picture.panels[0].left < picture.panels[1].left, true);
    for (std::size_t i = 0; i < shown.size(); ++i) {
      const Panel& panel = picture.panels[i];
      const double t = shown[i] * step;
      differ.compare("snapshot: time", panel.title, fmt::format("t = {} s", t));
      differ.compare("snapshot: window, x", panel.x_range, Numbers{-1.0, 11.0});
      differ.compare("snapshot: window, y", panel.y_range, Numbers{-5.0, 5.0});
      differ.compare("snapshot: divisions, x", panel.x_tics, Numbers{-1.0, 4.0});
      differ.compare("snapshot: divisions, y", panel.y_tics, Numbers{-5.0, 5.0});
      differ.compare("snapshot: grid", panel.grid, false);
      if (view == "side") {
        check_state(panel, shown[i], true, worst, differ);
        continue;
      }
      const std::vector<Point>& rope = panel.curves.back().lines.front();
      keep_worst(worst, std::hypot(rope.front()[0] - near_z, rope.front()[1] - exact("y", 1, t)));
      keep_worst(worst, std::hypot(rope.back()[0] - far_z, rope.back()[1] - rope_y));
    }
  }
  (void)program.run({"snapshot", "out"}, {{"--count", {"3"}}, {"--single", {}}, {"--name", {"each"}}});
  Names files = program.files("out/plots");
  std::erase_if(files, [](const std::string& name) { return !name.starts_with("each"); });
  Names expected;
  for (int i = 1; i <= 3; ++i) {
    const std::string name = fmt::format("each_side_0{}", i);
    for (const char* format : {"pdf", "png", "svg"})
      expected.insert(fmt::format("{}.{}", name, format));
    const Picture picture = program.picture(fmt::format("out/plots/{}.svg", name));
    differ.compare("snapshot: a panel on each page", picture.panels.size(), 1UL);
    if (picture.panels.size() != 1) return std::nan("");
    differ.compare("snapshot: grid without options", picture.panels[0].grid, true);
    check_state(picture.panels[0], (i - 1) * steps / 2, false, worst, differ);
  }
  differ.compare("snapshot: files of single states", files, expected);
  return worst;
}

double check_animations(const Pictures& program, Differences& differ) {
  constexpr double seconds = 3.0;
  const Numbers window{-1.0, -5.0, 12.0, 5.0};
  (void)program.run({"animate", "out"}, {{"--html", {}},
                                         {"--gif", {}},
                                         {"--seconds", {"3"}},
                                         {"--until", {"0.5 s"}},
                                         {"--window", {"-1", "-5", "12", "5"}},
                                         {"--numbers", {}},
                                         {"--out", {"films"}},
                                         {"--name", {"mine"}},
                                         {"--title", {"Mine"}}});
  differ.compare("animate: files", program.files("films"), Names{"mine.gif", "mine.html"});
  if (program.files("films").size() != 2) return std::nan("");
  const std::string film = program.folder().read("films/mine.gif");
  const std::vector<std::string> frames = pages(film);
  const auto count = static_cast<std::size_t>(steps_shown) + 1;
  differ.compare("animate: frames of the GIF", frames.size(), count);
  differ.compare("animate: hundredths of a second of a frame", between(film, " delay ", " "),
                 fmt::format("{}", std::lround(100.0 * seconds / static_cast<double>(count))));
  double worst = frames.size() == count ? 0.0 : std::nan("");
  for (std::size_t n = 0; n < std::min(count, frames.size()); ++n) {
    const Picture picture = read_picture(frames[n]);
    differ.compare("animate: title", picture.texts, Names{"Mine"});
    differ.compare("animate: views", picture.panels.size(), 2UL);
    if (picture.panels.empty()) return std::nan("");
    differ.compare("animate: window, x", picture.panels[0].x_range, Numbers{window[0], window[2]});
    differ.compare("animate: window, y", picture.panels[0].y_range, Numbers{window[1], window[3]});
    check_state(picture.panels[0], static_cast<int>(n), true, worst, differ);
  }
  const std::string page = program.folder().read("films/mine.html");
  differ.compare("animate: title of the page", between(page, "<title>", "</title>"), std::string{"Mine"});
  const Json data = Json::parse(between(page, "id=\"data\">", "</script>"));
  differ.compare("animate: window of the page", data.at("side").get<Numbers>(), window);
  differ.compare("animate: states of the page", data.at("frames").size(), count);
  for (std::size_t n = 0; n < std::min(count, data.at("frames").size()); ++n) {
    const Json& frame = data.at("frames")[n];
    const double t = static_cast<double>(n) * step;
    keep_worst(worst, frame.at("t").get<double>() - t);
    for (int i = 1; i <= discs; ++i) {
      const Json& body = frame.at("bodies").at(static_cast<std::size_t>(i) - 1);
      keep_worst(worst, std::hypot(body[0].get<double>() - exact("x", i, t), body[1].get<double>() - exact("y", i, t)));
    }
  }
  return worst;
}

/// Discs of a cell are coloured by their speed, or by the forces on them.
void check_colours(const Pictures& program, Differences& differ) {
  program.folder().write("cell.toml", cell_text);
  (void)talus_output(program.folder(), {"cell", "cell.toml", "--out", "flow"});
  const std::string speed = "speed of a disc [m/s]", force = "sum of the contact forces on a disc [N]";
  const auto scale = [&](const std::string& file) { return program.picture(file).texts; };
  (void)program.run({"snapshot", "flow"}, {{"--format", {"svg"}}, {"--name", {"plain"}}});
  (void)program.run({"snapshot", "flow"}, {{"--colour", {"force"}}, {"--format", {"svg"}}});
  (void)program.run({"animate", "flow"}, {{"--colour", {"force"}}, {"--gif", {}}});
  differ.compare("snapshot: colours", scale("flow/plots/plain_side.svg").contains(speed), true);
  differ.compare("snapshot: colours by force", scale("flow/plots/snapshot_side.svg").contains(force), true);
  differ.compare("animate: colours by force", scale("flow/plots/animation.gif").contains(force), true);
}

void run(Findings& findings, const Setup& setup) {
  const auto group = findings.in("pictures");
  const Pictures program{setup};
  Differences plots, states, films;
  double curves = check_chosen_histories(program, plots);
  keep_worst(curves, check_default_histories(program, plots));
  check_list(program, plots);
  double drawn = check_snapshots(program, states);
  keep_worst(drawn, check_animations(program, films));
  check_colours(program, states);
  findings.expect("talus plot: points of curves, over the larger of 1 and the exact value, largest error", curves, 0.0,
                  Tolerance::round_off(1e-15,
                                       "nine digits are written, and no exact value has more: the roundings of the "
                                       "program and of the closed form, 1.1e-16 each, fall away with the digits"));
  plots.expect_none(findings, "talus plot: files, titles, limits, divisions and curves that differ from the options",
                    "all options in one command, and what is drawn without them");
  findings.expect(
      "talus snapshot and animate: outlines, cables and numbers of discs, largest error", drawn, 0.0,
      Tolerance::model(7.1e-5, "coordinates of six digits, up to 15 m: half a unit of the last one in x and in y"),
      "m");
  states.expect_none(findings, "talus snapshot: files, times, windows and texts that differ from the options",
                     "two pages of two states in two views, three pages of one state, colours of discs");
  films.expect_none(findings, "talus animate: files, frames, windows and texts that differ from the options",
                    "a GIF and a page with the states up to --until");
}

}  // namespace

Case definition() {
  const std::string plots = "talus plot: files, titles, limits, divisions and curves that differ from the options",
                    states = "talus snapshot: files, times, windows and texts that differ from the options",
                    films = "talus animate: files, frames, windows and texts that differ from the options";
  return {.id = "picture_options",
          .title = "Options of `talus plot`, `snapshot` and `animate`",
          .requirements = {{"G11", {"pictures"}}},
          .main_checks = {"talus plot: points of curves, over the larger of 1 and the exact value, largest error",
                          "talus snapshot and animate: outlines, cables and numbers of discs, largest error"},
          .source = "Textbook mechanics",
          .faults = {{"without_until", "time of the end of curves and films not given",
                      "talus plot: points of curves, over the larger of 1 and the exact value, largest error"},
                     {"without_x", "abscissa not given",
                      "talus plot: points of curves, over the larger of 1 and the exact value, largest error"},
                     {"without_all", "eight curves in place of all", plots},
                     {"without_divisions", "divisions not given", plots},
                     {"without_times", "times of the states not given", states},
                     {"without_window", "window not given", films}},
          .run = run};
}

}  // namespace talus::verification::problems::picture_options
