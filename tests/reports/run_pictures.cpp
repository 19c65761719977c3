#include "reports/report.hpp"

#include <array>
#include <boost/test/unit_test.hpp>
#include <cmath>

#include "reports/base/error.hpp"
#include "reports/base/process.hpp"
#include "tests/reports/report_program.hpp"
#include "tests/temporary_folder.hpp"
#include "verification/record/whole_file.hpp"

BOOST_AUTO_TEST_SUITE(run_pictures_tests)

using namespace talus::reports;
using talus::records::read_whole;
using talus::records::write_whole;
namespace fs = std::filesystem;

namespace {

Series shapes(const std::string& label, const Look& look, const std::vector<std::array<double, 4>>& points) {
  Series series{.label = label, .x = {}, .y = {}, .style = Style::shapes, .look = look};
  for (const auto& [line, x, y, pull] : points) {
    series.add(x, y);
    series.line.push_back(line);
    if (look.colour.empty()) series.values.push_back(pull);
  }
  return series;
}

/// A page of two panels of shapes: a square, and two cables coloured by tension.
Page two_panels() {
  Figure panel{.name = "p",
               .title = "t = 0 s",
               .caption = "",
               .x = {.label = "x", .min = -1.0, .max = 2.0},
               .y = {.label = "y", .min = -1.0, .max = 2.0},
               .series = {shapes("square", {"#102030", "#a0b0c0"},
                                 {{{0, 0, 0, 0}, {0, 1, 0, 0}, {0, 1, 1, 0}, {0, 0, 1, 0}, {0, 0, 0, 0}}}),
                          shapes("", {"", "", 3.0}, {{{1, 0, 0, 8}, {1, 0, 1.5, 8}, {2, 1, 0, 0}, {2, 1, 1.5, 0}}})},
               .marks = {{0.5, 0.5, "7"}},
               .equal = true};
  return {
      .name = "page", .title = "Two", .columns = 2, .panels = {panel, panel}, .scale = Scale{"tension", 0.0, 8.0, "N"}};
}

const ToolPaths tools{find_resources(), 2};

std::string page_error(const Pictures& pictures, const fs::path& target) {
  try {
    make_pictures(pictures, target, {"svg"}, tools);
  } catch (const RecordError& wrong) {
    return wrong.what();
  }
  return {};
}

}  // namespace

BOOST_AUTO_TEST_CASE(a_run_is_plotted_in_each_format) {
  const Folder scratch;
  write_whole(scratch.path / "history.csv", "time [s],x [m]\n0,1\n1,2\n2,1.5\n");
  write_whole(scratch.path / "plot.json",
              R"({"schema": 1, "title": "run", "figures": [{"name": "path", "title": "Path", "csv": "history.csv",
                 "x": {"label": "time", "unit": "s"}, "y": {"label": "x", "unit": "m"},
                 "series": [{"label": "rock", "x": "time [s]", "y": "x [m]", "style": "lines"}]}]})");
  const Finished finished = program({"--plot", scratch.path.string()});
  BOOST_TEST_REQUIRE(finished.status == 0, finished.messages);
  for (const char* name : {"path.svg", "path.pdf", "path.png"}) {
    BOOST_TEST(contains(finished.output, name));
    BOOST_TEST(fs::file_size(scratch.path / "plots" / name) > 500U);
  }
  fs::remove_all(scratch.path / "plots");
  BOOST_TEST(program({"--plot", scratch.path.string(), "--format", "svg"}).status == 0);
  BOOST_TEST(fs::exists(scratch.path / "plots" / "path.svg"));
  BOOST_TEST(!fs::exists(scratch.path / "plots" / "path.pdf"));
}

BOOST_AUTO_TEST_CASE(a_page_shows_shapes_in_the_colours_of_their_values) {
  const Folder scratch;
  const Page page = two_panels();
  const Made made = make_pictures({.pages = {page},
                                   .films = {{"film", 0.1, {page, page}}},
                                   .players = {{"play", "A <b>", R"({"title": "</script>"})"}}},
                                  scratch.path, {"svg", "ps"}, tools);
  BOOST_TEST(made.warnings == "");
  BOOST_TEST(made.files.size() == 4U);
  const std::string svg = read_whole(scratch.path / "page.svg");
  // The dark end of the scale for a tension of 8, its pale end for zero; a fill and its line; title, key and number.
  for (const char* part :
       {"rgb(103,   0,  31)", "rgb(254, 196,  79)", "rgb(160, 176, 192)", "Two", "square", "tension [N]", ">7<"})
    BOOST_TEST(contains(svg, part), part);
  BOOST_TEST(contains(read_whole(scratch.path / "page.ps"), "%%CreationDate: Thu Jan  1 00:00:00 1970"));
  BOOST_TEST(read_whole(scratch.path / "film.gif").rfind("GIF89a", 0) == 0U);
  const std::string html = read_whole(scratch.path / "play.html");
  BOOST_TEST(contains(html, "<title>A &lt;b&gt;</title>"));
  BOOST_TEST(contains(html, R"({"title": "\u003c/script>"})"));
}

// Circles with a value have the dark and the pale end of the scale, the others their fill; small circles have outlines
// with few corners.
BOOST_AUTO_TEST_CASE(circles_are_filled_by_their_values) {
  const Folder scratch;
  Figure panel{
      .name = "p",
      .title = "",
      .caption = "",
      .x = {.label = "x", .min = -1.0, .max = 3.0},
      .y = {.label = "y", .min = -2.0, .max = 1.0},
      .series =
          {{.label = "", .x = {0, 2}, .y = {0, 0}, .style = Style::circles, .values = {0, 8}, .radius = {0.5, 0.5}},
           {.label = "wall",
            .x = {0},
            .y = {-1},
            .style = Style::circles,
            .look = {"#102030", "#a0b0c0"},
            .radius = {0.01}}},
      .equal = true};
  const auto page = [](const Figure& figure) {
    return Pictures{
        .pages = {
            {.name = "page", .title = "", .columns = 1, .panels = {figure}, .scale = Scale{"speed", 0.0, 8.0, "m/s"}}}};
  };
  BOOST_TEST(make_pictures(page(panel), scratch.path, {"svg"}, tools).warnings == "");
  const std::string svg = read_whole(scratch.path / "page.svg");
  for (const char* part : {"rgb(103,   0,  31)", "rgb(254, 196,  79)", "rgb(160, 176, 192)", ">wall<", "speed [m/s]"})
    BOOST_TEST(contains(svg, part), part);
  const auto error_message = [&](auto&& change) {
    Figure wrong = panel;
    change(wrong);
    return page_error(page(wrong), scratch.path);
  };
  BOOST_TEST(error_message([](Figure& f) { f.series[0].radius = {}; }) ==
             "page 'page': panels[0]: series[0].radius: is missing: circles need it");
  BOOST_TEST(error_message([](Figure& f) { f.series[0].values = {}; }) ==
             "page 'page': panels[0]: series[0]: shapes need a colour, a fill or a value");
  BOOST_TEST(error_message([](Figure& f) { f.series[1].look.fill = ""; }) ==
             "page 'page': panels[0]: series[1]: circles need a fill or a value");
  BOOST_TEST(error_message([](Figure& f) { f.series[0].y[1] = NAN; }) ==
             "figure 'p': series '': found nan at point 2; it must be a finite number");
}

BOOST_AUTO_TEST_CASE(wrong_pages_are_named) {
  const Folder scratch;
  const auto error_message = [&](auto&& change) {
    Pictures pictures{.pages = {two_panels()}, .films = {{"film", 0.1, {two_panels()}}}, .players = {{"play", "", ""}}};
    change(pictures);
    return page_error(pictures, scratch.path);
  };
  BOOST_TEST(error_message([](Pictures& p) { p.pages[0].panels[1].series[0].look.colour = "blue"; }) ==
             "page 'page': panels[1]: series[0].colour: must be a colour such as #0072b2, found 'blue'");
  BOOST_TEST(error_message([](Pictures& p) { p.pages[0].panels[0].x.min = {}; }) ==
             "page 'page': panels[0]: a figure with equal units needs min and max of both axes");
  BOOST_TEST(error_message([](Pictures& p) { p.pages[0].columns = 0; }) ==
             "page 'page': columns: must be from 1 to 12, found 0");
  BOOST_TEST(error_message([](Pictures& p) { p.pages[0].panels = {}; }) ==
             "page 'page': panels: must hold at least one figure");
  BOOST_TEST(error_message([](Pictures& p) { p.pages[0].scale->max = 0.0; }) ==
             "page 'page': scale: min must be less than max, found 0 and 0");
  BOOST_TEST(error_message(
                 [](Pictures& p) { p.pages[0].panels[0].series[0] = {.label = "none", .look = {"#102030"}}; }) == "");
  BOOST_TEST(error_message([](Pictures& p) {
               for (Series& series : p.pages[0].panels[0].series)
                 series = {.label = "none"};
             }) == "figure 'p' is empty: no point can be drawn");
  BOOST_TEST(error_message([](Pictures& p) { p.films[0].delay = 0.0; }) == "film 'film': delay: must be > 0, found 0");
  BOOST_TEST(error_message([](Pictures& p) { p.films[0].pages = {}; }) ==
             "film 'film': pages: must hold at least one page");
  BOOST_TEST(error_message([](Pictures& p) { p.films[0].pages[0].columns = 13; }) ==
             "film 'film': pages[0]: columns: must be from 1 to 12, found 13");
  BOOST_TEST(error_message([](Pictures& p) { p.players[0].name = "../play"; }) ==
             "name of a player: found '../play'; it must be a plain file name");
  for (const auto& entry : fs::directory_iterator(scratch.path))
    BOOST_TEST(entry.path().filename().string().front() != '.', "left behind: " << entry.path());
}

BOOST_AUTO_TEST_CASE(wrong_figures_of_a_run_are_named) {
  const Folder scratch;
  write_whole(scratch.path / "history.csv", "time,x,kind\n0,1,a\n1,2,a\n");
  const std::string good =
      R"({"schema": 1, "figures": [{"name": "path", "title": "Path", "csv": "history.csv", "x": {"label": "time"},
          "y": {"label": "x"}, "series": [{"x": "time", "y": "x", "style": "lines"}]}]})";
  const std::vector<std::pair<std::pair<std::string, std::string>, std::string>> changes{
      {{"\"schema\": 1", "\"schema\": 2"}, "plot.schema: must be 1, found 2"},
      {{"\"lines\"", "\"wavy\""}, "figures[0].series[0].style: must be one of"},
      {{"\"path\"", "\"../path\""}, "figures[0].name: must be a plain file name"},
      {{"\"y\": \"x\"", "\"y\": \"z\""}, "history.csv: has no column 'z'"},
      {{"history.csv", "other.csv"}, "other.csv: No such file or directory"},
      {{"[{\"name\"", "[], \"unknown\": [{\"name\""}, "plot.figures: must hold at least one figure"}};
  for (const auto& [change, expected] : changes) {
    std::string text = good;
    text.replace(text.find(change.first), change.first.size(), change.second);
    write_whole(scratch.path / "plot.json", text);
    const Finished finished = program({"--plot", scratch.path.string()});
    BOOST_TEST(finished.status == 2);
    BOOST_TEST(contains(finished.messages, expected), finished.messages);
  }
}

BOOST_AUTO_TEST_SUITE_END()
