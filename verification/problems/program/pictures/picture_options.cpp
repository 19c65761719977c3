#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "verification/check/case.hpp"
#include "verification/problems/program/pictures/coloured_discs.hpp"
#include "verification/problems/program/pictures/drawn_fence.hpp"
#include "verification/problems/program/pictures/drawn_histories.hpp"
#include "verification/problems/program/pictures/picture_script.hpp"
#include "verification/problems/program/pictures/thrown_discs.hpp"
#include "verification/record/csv.hpp"
#include "verification/record/json_node.hpp"
#include "verification/study/findings/expectations.hpp"
#include "verification/study/program/program_options.hpp"
#include "verification/study/program/program_run.hpp"

namespace talus::verification::problems::picture_options {
namespace {

using records::Json;

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
  double widest = 0.0;
  const std::string largest = fmt::format("; widest {:.3g} N", largest_force(files));
  for (const std::string& frame : frames) {
    const Picture picture = read_picture(frame);
    compare(picture, force, forces);
    // A bar joins the centres of two discs that touch, also across the border of the field; six digits.
    const Bars drawn = contact_bars(picture);
    differ.holds("animate: lengths of bars of contacts", drawn.longest < cell_diameter * (1.0 + 1e-4));
    bars += drawn.count;
    keep_largest(widest, drawn.widest);
    if (drawn.count > 0) differ.contains("animate: force of the widest bar of a contact", frame, largest);
  }
  differ.holds("animate: bars of contacts", bars > 0);
  // The bar of the largest force of all frames is as wide as 0.8 of a radius; six digits.
  differ.holds("animate: widest bar of a contact", std::abs(widest / (0.4 * cell_diameter) - 1.0) < 1e-3);
  // At least all free discs of each panel; images at the borders are drawn, too.
  const std::size_t drawn = plain.panels.size() + by_force.panels.size() + frames.size();
  differ.holds("colours: all discs of each picture", coloured >= free_discs_of_cell * static_cast<int>(drawn));
  return worst;
}

void run(Findings& findings, const Setup& setup) {
  const auto group = findings.in("pictures");
  const Pictures program{setup};
  Differences plots, states, films;
  const double curves = check_histories(program, setup, plots);
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
