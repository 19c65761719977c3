#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <filesystem>
#include <map>
#include <set>
#include <sstream>
#include <string>
#include <vector>

#include "verification/check/case.hpp"
#include "verification/problems/program/pictures/coloured_discs.hpp"
#include "verification/problems/program/pictures/drawn_fence.hpp"
#include "verification/problems/program/pictures/picture_script.hpp"
#include "verification/record/csv.hpp"
#include "verification/record/json_node.hpp"
#include "verification/reference/motion/constant_force.hpp"
#include "verification/study/findings/expectations.hpp"
#include "verification/study/program/program_options.hpp"
#include "verification/study/program/program_run.hpp"

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
  return quantity.starts_with('v') ? speed_at(flight, t) : position_at(flight, t);
}

std::string scene_text(double each = step) {
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
                        name_of(i), radius, along(i).position, along(i).speed, up(i).speed);
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
                            near_z, rope_y, far_z, each, steps * step, each);
}

/// A cell of 20 discs between walls of six.
constexpr int free_discs_of_cell = 20;
constexpr double cell_width = 6e-3, cell_diameter = 1e-3;
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
every = "1 ms"
end = "20 ms"
pictures = "on"
)";

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
  explicit Pictures(const Setup& setup) : setup_{&setup}, environment_{recorded_pictures()} {
    folder_.write("scene.toml", scene_text());
    (void)talus_output(folder_, {"run", "scene.toml", "--out", "out", "--frames", fmt::format("{}", steps)});
  }

  std::string run(const std::vector<std::string>& command, const Options& options) const {
    return talus_output(folder_, with_options(command, options, *setup_), environment_);
  }
  /// A picture of a figure or of one page.
  Picture picture(const std::string& file) const { return read_picture(text(file)); }
  /// The recorded commands; empty without this file.
  std::string text(const std::string& file) const {
    return fs::exists(folder_.path() / file) ? folder_.read(file) : "";
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

/// The pictures of one stem: each drawn by the terminal of its format, all with the same content, and dated 1970.
void check_formats(const Pictures& program, const std::string& stem, const std::vector<std::string>& formats,
                   Differences& differ) {
  const std::map<std::string, std::string> terminals{
      {"pdf", "pdfcairo"}, {"png", "pngcairo"}, {"ps", "epscairo"}, {"svg", "svg"}};
  const std::string content = drawn_content(program.text(stem + "." + formats.front()));
  differ.contains("formats: a plot", content, "\nplot ");
  for (const std::string& format : formats) {
    const std::string text = program.text(stem + "." + format);
    differ.compare("formats: terminal of " + format, read_picture(text).terminal, terminals.at(format));
    differ.compare("formats: content of " + format, drawn_content(text), content);
    if (format == "pdf")
      differ.compare("formats: date of pdf", between(text, "/CreationDate (D:", ")"), std::string{"19700101000000"});
    if (format == "ps")
      differ.compare("formats: date of ps", between(text, "%%CreationDate: ", "\n"),
                     std::string{"Thu Jan  1 00:00:00 1970"});
  }
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
  (void)program.run({"plot", "out"}, {{"--history", {"y"}}});
  differ.compare("plot: files without options", program.files("out/plots"),
                 Names{"history_y.pdf", "history_y.png", "history_y.svg"});
  check_formats(program, "out/plots/history_y", {"pdf", "png", "svg"}, differ);
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

  // Of two runs the four quantities with the largest range, each of both runs.
  fs::copy(program.folder().path() / "out", program.folder().path() / "again", fs::copy_options::recursive);
  (void)program.run({"plot", "out", "again"}, {{"--history", {"y"}}, {"--format", {"svg"}}, {"--out", {"both"}}});
  Names of_both;
  for (const std::string run : {"out", "again"})
    for (std::size_t k = 0; k < 4; ++k)
      of_both.insert(fmt::format("{}, {}", run, name_of(ranges[k].second)));
  differ.compare("plot: curves of two runs with the largest range", drawn("both/history_y.svg"), of_both);

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
  const std::string printed = program.run({"snapshot", "out"}, {{"--times", {"0.1 s,0.51 s"}},
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
  differ.holds(
      "snapshot: printed times",
      printed.starts_with("state drawn at t = 0.1 s\nstate drawn at t = 0.5 s, the nearest one to \"0.51 s\"\n"));
  differ.compare("snapshot: files", program.files("states"), Names{"mine_side.svg", "mine_along.svg"});
  double worst = 0.0;
  const std::vector<int> shown{2, 10};
  for (const std::string view : {"side", "along"}) {
    const Picture picture = program.picture(fmt::format("states/mine_{}.svg", view));
    differ.compare("snapshot: title", picture.texts, Names{"Mine"});
    differ.compare("snapshot: panels", picture.panels.size(), shown.size());
    if (picture.panels.size() != shown.size()) return std::nan("");
    differ.holds("snapshot: side by side", picture.panels[0].left < picture.panels[1].left);
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
    check_formats(program, "out/plots/" + name, {"pdf", "png", "svg"}, differ);
    const Picture picture = program.picture(fmt::format("out/plots/{}.svg", name));
    differ.compare("snapshot: a panel on each page", picture.panels.size(), 1UL);
    if (picture.panels.size() != 1) return std::nan("");
    differ.holds("snapshot: grid without options", picture.panels[0].grid);
    check_state(picture.panels[0], (i - 1) * steps / 2, false, worst, differ);
  }
  differ.compare("snapshot: files of single states", files, expected);
  // One state is the last one.
  const std::string noted = program.run({"snapshot", "out"}, {{"--count", {"1"}}, {"--format", {"svg"}}});
  differ.holds("snapshot: printed time of one state", noted.starts_with("state drawn at t = 1 s\n"));
  const Picture one = program.picture("out/plots/snapshot_side.svg");
  differ.compare("snapshot: panels of one state", one.panels.size(), 1UL);
  if (one.panels.size() != 1) return std::nan("");
  differ.compare("snapshot: time of one state", one.panels[0].title, std::string{"t = 1 s"});
  check_state(one.panels[0], steps, false, worst, differ);
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
  const records::Csv history = records::read_csv(program.folder().path() / "out/history.csv");
  differ.compare("animate: states of the page", data.at("frames").size(), count);
  for (std::size_t n = 0; n < std::min(count, data.at("frames").size()); ++n) {
    const Json& frame = data.at("frames")[n];
    const double t = static_cast<double>(n) * step;
    keep_worst(worst, frame.at("t").get<double>() - t);
    // The history has a row each step.
    for (const Json& chart : data.at("charts")) {
      for (const Json& series : chart.at("series")) {
        const std::string head = series.at("name").get<std::string>() + " [";
        const auto column =
            std::ranges::find_if(history.header(), [&](const std::string& name) { return name.starts_with(head); });
        if (column == history.header().end()) return std::nan("");
        const double value = history.number(n, static_cast<std::size_t>(column - history.header().begin()));
        differ.holds("animate: values at the cursor",
                     std::abs(series.at("at").at(n).get<double>() - value) <= 5.1e-6 * std::abs(value));
      }
    }
    for (int i = 1; i <= discs; ++i) {
      const Json& body = frame.at("bodies").at(static_cast<std::size_t>(i) - 1);
      keep_worst(worst, std::hypot(body[0].get<double>() - exact("x", i, t), body[1].get<double>() - exact("y", i, t)));
    }
  }
  return worst;
}

/// A page of a run with more rows than it draws: its curves have the extremes of history.csv and end with its last row.
void check_long_history(const Pictures& program, Differences& differ) {
  constexpr int rows = 1024;
  program.folder().write("long.toml", scene_text(1.0 / rows));
  (void)talus_output(program.folder(), {"run", "long.toml", "--out", "long", "--frames", "2"});
  (void)talus_output(program.folder(), {"animate", "long", "--html", "--out", "long"});
  const records::Csv history = records::read_csv(program.folder().path() / "long/history.csv");
  differ.compare("animate: rows of a long history", history.rows(), rows + 1UL);
  const auto same = [](double drawn, double exact) { return std::abs(drawn - exact) <= 5.1e-6 * std::abs(exact); };
  const Json data = Json::parse(between(program.folder().read("long/animation.html"), "id=\"data\">", "</script>"));
  differ.holds("animate: curves of a long history", !data.at("charts").empty());
  for (const Json& chart : data.at("charts")) {
    const Numbers times = chart.at("t").get<Numbers>();
    differ.holds("animate: points of a long history", times.size() < rows);
    differ.holds("animate: last time of a long history", same(times.back(), steps * step));
    for (const Json& series : chart.at("series")) {
      const Numbers drawn = series.at("values").get<Numbers>(),
                    values = column(history, series.at("name").get<std::string>());
      differ.holds("animate: a value for each time of a long history", drawn.size() == times.size());
      differ.holds("animate: last value of a long history", same(drawn.back(), values.back()));
      differ.holds("animate: extremes of a long history", same(std::ranges::min(drawn), std::ranges::min(values)) &&
                                                              same(std::ranges::max(drawn), std::ranges::max(values)));
    }
  }
}

/// Discs of a cell are coloured by their speed, or by the forces on them. Returns the largest error of a value as read
/// from its colour, over the largest value.
double check_colours(const Pictures& program, Differences& differ, const Setup& setup) {
  program.folder().write("cell.toml", cell_text);
  (void)talus_output(program.folder(), {"cell", "cell.toml", "--out", "flow"});
  (void)program.run({"snapshot", "flow"}, {{"--format", {"svg"}}, {"--name", {"plain"}}});
  (void)program.run({"snapshot", "flow"}, {{"--colour", {"force"}}, {"--format", {"svg"}}});
  (void)program.run({"animate", "flow"}, {{"--colour", {"force"}}, {"--gif", {}}, {"--html", {}}});
  const std::vector<GeometryState> files = geometry_states(program.folder(), "flow", "cell");
  const std::vector<DiscState> speeds = disc_states(files, DiscValue::speed),
                               forces = disc_states(
                                   files, setup.has("speeds_as_forces") ? DiscValue::speed : DiscValue::force);
  double worst = 0.0;
  int coloured = 0;
  const auto compare = [&](const Picture& picture, const std::string& label, const std::vector<DiscState>& states) {
    differ.holds("colours: label of the scale", picture.texts.contains(label));
    const ColourErrors errors = colour_errors(picture, states, cell_width);
    differ.holds("colours: end of the scale, to the digits of its numbers", std::abs(errors.largest) < 1e-4);
    keep_worst(worst, errors.value), coloured += errors.discs;
  };
  const std::string speed = "speed of a disc [m/s]", force = "sum of the contact forces on a disc [N]";
  const Picture plain = program.picture("flow/plots/plain_side.svg");
  const Picture by_force = program.picture("flow/plots/snapshot_side.svg");
  (void)program.run({"snapshot", "flow"},
                    {{"--numbers", {}}, {"--count", {"1"}}, {"--format", {"svg"}}, {"--name", {"named"}}});
  const Picture named = program.picture("flow/plots/named_side.svg");
  differ.holds("colours: number of each disc", marks_are_numbers(named, speeds, cell_width));
  compare(plain, speed, shown_states(plain, speeds)), compare(by_force, force, shown_states(by_force, forces));
  const std::string film = program.text("flow/plots/animation.gif"), page = program.text("flow/plots/animation.html");
  const std::vector<std::string> frames = pages(film);
  differ.compare("animate: frames of a cell", frames.size(), files.size());
  differ.compare("animate: hundredths of a second of a frame without --seconds, which are 6",
                 between(film, " delay ", " "),
                 fmt::format("{}", std::lround(600.0 / static_cast<double>(files.size()))));
  differ.compare("animate: colours of the page",
                 Json::parse(between(page, "id=\"data\">", "</script>")).at("discs").at("colour").get<std::string>(),
                 std::string{"force"});
  int bars = 0;
  for (const std::string& frame : frames) {
    const Picture picture = read_picture(frame);
    compare(picture, force, forces);
    // A bar joins the centres of two discs that touch, also across the border of the field; six digits.
    const Bars drawn = contact_bars(picture);
    differ.holds("animate: lengths of bars of contacts", drawn.longest < cell_diameter * (1.0 + 1e-4));
    bars += drawn.count;
  }
  differ.holds("animate: bars of contacts", bars > 0);
  // At least all free discs of each panel; images at the borders are drawn, too.
  const std::size_t drawn = plain.panels.size() + by_force.panels.size() + frames.size();
  differ.holds("colours: all discs of each picture", coloured >= free_discs_of_cell * static_cast<int>(drawn));
  return worst;
}

void run(Findings& findings, const Setup& setup) {
  const auto group = findings.in("pictures");
  const Pictures program{setup};
  Differences plots, states, films;
  double curves = check_chosen_histories(program, plots);
  keep_worst(curves, check_default_histories(program, plots));
  check_list(program, plots);
  if (setup.fault.empty()) check_turning(program, plots);
  double drawn = check_snapshots(program, states);
  if (setup.fault.empty()) check_half_fence(program.folder(), states);
  keep_worst(drawn, check_animations(program, films));
  if (setup.fault.empty()) check_long_history(program, films);
  const double colours = check_colours(program, states, setup);
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
  findings.expect(
      "talus snapshot and animate: values of discs as read from their colours, over the largest, largest error",
      colours, 0.0,
      Tolerance::model(1.0 / 96.0 + 1e-5, "half a step of a scale of 48 steps; screen coordinates have six digits"));
  states.expect_none(
      findings, "talus snapshot: files, times, windows and texts that differ from the options",
      "two pages of two states in two views, three pages of one state in three formats, the last state alone, "
      "a half fence with its mirror image, labels and ends of colour scales");
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
                     {"without_window", "window not given", films},
                     {"speeds_as_forces", "colours by force compared with speeds",
                      "talus snapshot and animate: values of discs as read from their colours, over the largest, "
                      "largest error"}},
          .run = run};
}

}  // namespace talus::verification::problems::picture_options
