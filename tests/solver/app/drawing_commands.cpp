#define BOOST_TEST_MODULE drawing_commands
#include <algorithm>
#include <array>
#include <boost/test/unit_test.hpp>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <map>
#include <nlohmann/json.hpp>
#include <pugixml.hpp>
#include <sstream>

#include "solver/base/error.hpp"
#include "solver/io/output/read_history.hpp"
#include "tests/solver/app/requested.hpp"

// Pictures by talus plot --history, snapshot and animate.

namespace {

/// sample2 run for 50 ms, once for all tests, with histories and geometry at the same times: every 60 steps.
const fs::path& sample() {
  static const Folder folder;
  static const bool made = [] {
    std::string deck = talus::read_text(scene("fence/sample2.DAT"));
    std::ofstream{folder.path / "fence.DAT"} << deck;
    const Ended ended = talus_ran({"run", (folder.path / "fence.DAT").string(), "--end", "50 ms", "--frames", "10",
                                   "--out", (folder.path / "run").string()});
    return ended.code == 0;
  }();
  BOOST_REQUIRE(made);
  static const fs::path run = folder.path / "run";
  return run;
}

}  // namespace

BOOST_AUTO_TEST_CASE(the_menu_lists_what_a_run_saved) {
  const Ended ended = talus_ran({"plot", sample().string(), "--list"});
  BOOST_TEST(ended.code == 0);
  BOOST_TEST(holds(ended.out, "  48  top_tension               [lbf]      tension in top cable"));
  BOOST_TEST(holds(ended.out, "      energy.kinetic                 [lbf ft]"));
  BOOST_TEST(holds(ended.out, "      balance_error.angular_momentum [lbf ft s]"));
}

// A history is selected by its number, its title, its name of 1993, or as a column, with the same curve.
BOOST_AUTO_TEST_CASE(a_history_has_many_names) {
  const Requested number{{"plot", sample().string(), "--history", "48", "--element", "3"}};
  const talus::records::Series& drawn = number.panel(0).series.at(0);
  for (const char* name : {"top_tension", "tension in TOP cable", "element3.top_tension"}) {
    const Requested other{{"plot", sample().string(), "--history", name, "--element", "3"}};
    BOOST_TEST((other.panel(0).series.at(0).x == drawn.x && other.panel(0).series.at(0).y == drawn.y));
  }
  const talus::KeptHistory kept = talus::read_history(sample() / "fence.history.csv");
  BOOST_TEST((drawn.x == kept.columns.front().values));
  BOOST_TEST((drawn.y == kept.find("element3.top_tension")->values));
}

BOOST_AUTO_TEST_CASE(the_dialogue_of_hplot_as_options) {
  const Requested requested{{"plot",
                             sample().string(),
                             "--history",
                             "6,48,52",
                             "--element",
                             "3,4",
                             "--apart",
                             "--until",
                             "20 ms",
                             "--title",
                             "Mine",
                             "--x-title",
                             "TIME IN (SECS.)",
                             "--y-limits",
                             "-5",
                             "10.5",
                             "--divisions",
                             "5",
                             "4",
                             "--no-grid",
                             "--name",
                             "mine"}};
  BOOST_TEST(requested.page().name == "mine");
  BOOST_TEST(requested.page().title == "Mine");
  BOOST_TEST(requested.page().columns == 2);
  BOOST_TEST(requested.page().panels.size() == 3U);
  const talus::records::Figure& panel = requested.panel(0);
  BOOST_TEST(panel.x.label == "TIME IN (SECS.)");
  BOOST_TEST(panel.x.divisions == 5);
  BOOST_TEST(panel.y.label == "x - velocity of element centroid");
  BOOST_TEST(panel.y.unit == "ft/s");
  BOOST_TEST(panel.y.min.value() == -5.0);
  BOOST_TEST(panel.y.max.value() == 10.5);
  BOOST_TEST(!panel.grid);
  BOOST_TEST(panel.series.at(1).label == "element 4");
  for (const talus::records::Series& series : panel.series) {
    BOOST_TEST(series.x.size() > 5U, series.label);
    BOOST_TEST(series.x.back() <= 0.02);
  }
}

// Panels are grouped by unit unless --apart is given: two forces share a panel. The abscissa may be a history of the
// same element; the number of an element also selects its body.
BOOST_AUTO_TEST_CASE(panels_and_abscissas) {
  const Requested forces{{"plot", sample().string(), "--history", "48,52,6", "--element", "3"}};
  BOOST_TEST(forces.page().panels.size() == 2U);
  BOOST_TEST(forces.panel(0).series.at(1).label == "tension in bottom cable");
  const Requested path{{"plot", sample().string(), "--history", "4", "--element", "2", "--x", "3"}};
  const talus::KeptHistory kept = talus::read_history(sample() / "history.csv");
  const talus::records::Series& drawn = path.panel(0).series.at(0);
  BOOST_TEST((drawn.x == kept.find("rock.x")->values));
  BOOST_TEST((drawn.y == kept.find("rock.y")->values));
  BOOST_TEST(path.panel(0).x.unit == "ft");
}

// Two layers of the half fence have 26 segments; 14 columns and a rock have 30 coordinates. If there are more
// than 8 curves, the 8 with the largest range are drawn.
BOOST_AUTO_TEST_CASE(a_panel_has_eight_curves_unless_more_are_requested) {
  const auto labels = [](const talus::records::Figure& figure) {
    std::vector<std::string> found;
    for (const talus::records::Series& series : figure.series)
      found.push_back(series.label);
    return found;
  };
  const auto notes = [](const Requested& requested) {
    std::string all;
    for (const std::string& note : requested.request.notes)
      all += note + "\n";
    return all;
  };
  const Requested usual{{"plot", sample().string()}}, all{{"plot", sample().string(), "--all"}};
  for (const talus::records::Figure& each : usual.request.pictures.figures)
    BOOST_TEST(each.series.size() <= 8U, each.name);
  const auto drawn = labels(usual.figure("positions")), kept = labels(all.figure("positions"));
  BOOST_TEST(drawn.size() == 8U);
  BOOST_TEST(kept.size() == 30U);
  BOOST_TEST(holds(notes(usual), "positions: 8 of 30 curves drawn, those with the largest range; --all draws all"),
             notes(usual));
  BOOST_TEST(notes(all) == "");
  const talus::KeptHistory history = talus::read_history(sample() / "history.csv");
  const auto range = [&](const std::string& name) {
    const auto& values = history.find(name)->values;
    const auto [low, high] = std::minmax_element(values.begin(), values.end());
    return *high - *low;
  };
  for (const std::string& one : kept) {
    if (std::find(drawn.begin(), drawn.end(), one) != drawn.end()) continue;
    for (const std::string& other : drawn)
      BOOST_TEST(range(one) <= range(other), one + " is left out for " + other);
  }
  // Elements by name and number; each figure draws the curves that it has of them.
  const Requested named{{"plot", sample().string(), "--element", "2,top1"}};
  BOOST_TEST((labels(named.figure("velocities")) == std::vector<std::string>{"rock.vx", "rock.vy"}));
  BOOST_TEST((labels(named.figure("tensions")) == std::vector<std::string>{"top1.tension"}));
  const Ended unknown = talus_ran({"plot", sample().string(), "--element", "top99"});
  BOOST_TEST(unknown.code == 2);
  BOOST_TEST(holds(unknown.err, "--element: element 'top99' is not known; nearest: top"), unknown.err);
  // The same limit applies to selected histories.
  const Requested tension{{"plot", sample().string(), "--history", "tension"}};
  BOOST_TEST(tension.panel(0).series.size() == 8U);
  BOOST_TEST(holds(notes(tension), "panel [lbf]: 8 of 26 curves drawn"), notes(tension));
  const Requested tensions{{"plot", sample().string(), "--history", "tension", "--all"}};
  BOOST_TEST(tensions.panel(0).series.size() == 26U);
}

BOOST_AUTO_TEST_CASE(several_runs_over_each_other) {
  const Folder folder;
  std::vector<std::string> arguments{"plot"};
  for (const char* step : {"20 us", "40 us"}) {
    arguments.push_back((folder.path / std::string{step}.substr(0, 2)).string());
    BOOST_REQUIRE(
        talus_ran({"run", scene("two_cable.toml"), "--step", step, "--out", arguments.back(), "--frames", "2"}).code ==
        0);
  }
  arguments.insert(arguments.end(), {"--history", "vx", "--element", "particle,striker"});
  const Requested requested{arguments};
  BOOST_TEST(requested.panel(0).series.size() == 4U);
  BOOST_TEST(requested.panel(0).series.at(2).label == "40, particle");
  arguments = {"plot", arguments[1], sample().string(), "--history", "energy.kinetic"};
  const Requested apart{arguments};
  BOOST_TEST(apart.page().panels.size() == 2U);  // N m and lbf ft do not share an axis
  arguments.push_back("--apart");
  BOOST_CHECK_THROW(Requested{arguments}, talus::InputError);
}

BOOST_AUTO_TEST_CASE(histories_that_cannot_be_drawn) {
  const std::string run = sample().string();
  const std::vector<std::pair<std::vector<std::string>, std::string>> wrong{
      {{"--history", "top_tensoin"},
       ": history 'top_tensoin' is not known; nearest: top_tension; known: vx, vy, omega, kinetic_translation, "},
      {{"--history", "46"},
       ": history 46 (TOP CABLE LENGTH, top_length) was not recorded; nearest: top_tension; recorded: vx, vy, "},
      {{"--history", "29"}, "talus: --history: 29 (NORMAL CONTACT STIFFNESS) has no history: a contact's stiffness "},
      {{"--history", "48", "--element", "2"},
       "fence.history.csv: history '48' was not recorded for element '2'; nearest: element 3; recorded for: element 3, "
       "element "
       "4, "},
      {{"--history", "48", "--x", "tmie"},
       "fence.history.csv: abscissa 'tmie' is not known; nearest: time; known: time, "},
      {{"--history", "48", "--until", "0 s"}, "--until: found \"0 s\"; "},
      {{"--history", "48", "--until", "1 ft"}, "--until: found \"1 ft\""},
      {{"--history", "48", "--y-limits", "3", "2"}, "--y-limits: found 3 2; the first must be less than the second"},
      {{run}, "several runs are drawn over each other by --history only; name one"},
      {{"--history", "48", "--format", "gif"}, "--format: gif not in {ps,pdf,svg,png}"}};
  for (const auto& [options, message] : wrong) {
    std::vector<std::string> arguments{"plot", run};
    arguments.insert(arguments.end(), options.begin(), options.end());
    const Ended ended = talus_ran(arguments);
    BOOST_TEST(ended.code == 2);
    BOOST_TEST(holds(ended.err, message), ended.err << " holds no " << message);
  }
  const Ended nowhere = talus_ran({"plot", "/nowhere", "--history", "48"});
  BOOST_TEST(nowhere.code == 4);
  BOOST_TEST(holds(nowhere.err, "/nowhere: found no folder of this name; it must be "), nowhere.err);
}

BOOST_AUTO_TEST_CASE(histories_are_drawn_in_each_format_the_same_each_time) {
  const Folder folder;
  for (const char* out : {"a", "b"}) {
    const Ended ended = talus_ran({"plot", sample().string(), "--history", "48,6", "--format", "ps,pdf,svg,png",
                                   "--out", (folder.path / out).string()});
    BOOST_TEST(ended.code == 0, ended.err);
    BOOST_TEST(ended.err.empty());
    BOOST_TEST(holds(ended.out, out + std::string{"/histories.ps\n"}));
  }
  for (const auto& [format, start] : std::map<std::string, std::string>{
           {"ps", "%!PS-Adobe"}, {"pdf", "%PDF"}, {"svg", "<?xml"}, {"png", "\x89PNG"}}) {
    const std::string bytes = talus::read_text(folder.path / "a" / ("histories." + format));
    BOOST_TEST(bytes.rfind(start, 0) == 0U, format);
    BOOST_TEST((bytes == talus::read_text(folder.path / "b" / ("histories." + format))), format);
  }
  BOOST_TEST(holds(talus::read_text(folder.path / "a/histories.svg"), "tension in top cable"));
  for (const auto& entry : fs::directory_iterator(folder.path / "a"))
    BOOST_TEST(entry.path().filename().string().front() != '.', "left behind: " << entry.path());
}

// Compares the centres of the outlines with positions in the histories, and taut and slack cables with tensions in the
// histories, which are independent of the geometry files.
BOOST_AUTO_TEST_CASE(snapshots_show_what_the_histories_say) {
  const Requested requested{{"snapshot", sample().string(), "--count", "11"}};
  BOOST_TEST(requested.page().panels.size() == 11U);
  const talus::KeptHistory kept = talus::read_history(sample() / "history.csv");
  const std::vector<double>& times = kept.columns.front().values;
  const auto last = rows(requested.panel(10));
  double x = 0.0;
  for (std::size_t i = 0; i < 96; ++i)
    x += last.at("rock")[i].x / 96.0;
  const auto middle = [&](const char* name, std::size_t at) { return kept.find(name)->values[at]; };
  // Both end with the last state.
  BOOST_TEST(std::abs(x - middle("rock.x", times.size() - 1)) < 1e-4);
  const auto first = rows(requested.panel(0));
  x = 0.0;
  for (std::size_t i = 0; i < 96; ++i)
    x += first.at("rock")[i].x / 96.0;
  BOOST_TEST(std::abs(x - middle("rock.x", 0)) < 1e-4);
  std::size_t taut = 0;
  std::size_t cables = 0;
  double sum = 0.0;
  for (const talus::SavedColumn& column : kept.columns) {
    if (column.quantity() != "tension") continue;
    ++cables;
    sum += column.values.front();
    if (column.values.front() > 0.0) ++taut;
  }
  BOOST_TEST(first.at("taut").size() == 2 * taut);
  BOOST_TEST(first.at("slack").size() == 2 * (cables - taut));
  for (const auto& end : first.at("taut"))
    sum -= 0.5 * end.value;  // each cable has two ends
  BOOST_TEST(std::abs(sum) < 1e-5 * 14 * 22e3);
}

// The half model seen along the fence, with its mirror image, equals the full model: the same outlines and cables, at
// the start and when the wave has reached half of the columns.
BOOST_AUTO_TEST_CASE(a_half_model_is_drawn_whole) {
  const Folder folder;
  const std::string text = talus::read_text(scene("fence/sample2.toml"));
  const auto drawn = [&](const std::string& symmetry) {
    const std::string name = (folder.path / symmetry).string();
    std::ofstream{name + ".toml"} << text << "\n[fence.options]\nsymmetry = \"" << symmetry << "\"\n";
    BOOST_REQUIRE(talus_ran({"run", name + ".toml", "--end", "10 ms", "--out", name}).code == 0);
    return Requested{{"snapshot", name, "--times", "0 s,10 ms", "--view", "along"}};
  };
  const Requested half = drawn("half"), full = drawn("full");
  for (const std::size_t frame : {0U, 1U}) {
    const auto some = rows(half.panel(frame)), all = rows(full.panel(frame));
    for (const char* const kind : {"column", "hanger", "taut", "slack"}) {
      // Compares both coordinates of each end and corner, and the tension, to six digits.
      const auto points = [&](const auto& of) {
        const auto rounded = [](double number) {
          char digits[32];
          std::snprintf(digits, sizeof digits, "%.6g", number);
          return std::strtod(digits, nullptr);
        };
        std::vector<std::array<double, 3>> found;
        for (const Row& row : of.at(kind))
          found.push_back({rounded(row.x), rounded(row.y), rounded(row.value)});
        std::sort(found.begin(), found.end());
        return found;
      };
      BOOST_TEST((points(some) == points(all)), frame << ": " << kind);
      const auto series = [&](const Requested& requested) {
        const auto& list = requested.panel(frame).series;
        return std::count_if(list.begin(), list.end(), [&](const auto& each) { return kind_of(each) == kind; });
      };
      BOOST_TEST((series(half) == 2 && series(full) == 1), frame << ": " << kind);
    }
  }
  const talus::records::Axis& x = half.panel(0).x;
  BOOST_TEST(x.label == "z, below 0 the mirror image");
  BOOST_TEST(x.min.value() == -x.max.value());
  BOOST_TEST(full.panel(0).x.label == "z");
}

// Hangers with a strength of 20,000 lbf: those of the two central columns break, at 11 and 23 ms according to the
// summary, and no other by 30 ms.
BOOST_AUTO_TEST_CASE(a_broken_hanger_is_drawn_no_more) {
  const Folder folder;
  const std::string deck = (folder.path / "weak.toml").string();
  std::ofstream{deck} << talus::read_text(scene("fence/sample2.toml"))
                      << "\n[fence.options]\nhanger_strength = \"20000 lbf\"\n";
  const std::string run = (folder.path / "run").string();
  const Ended ended = talus_ran({"run", deck, "--end", "30 ms", "--frames", "10", "--out", run});
  BOOST_REQUIRE(ended.code == 0);
  BOOST_TEST(holds(ended.out, "hanger 'hanger1' breaks"));
  BOOST_TEST(holds(ended.out, "hanger 'back_hanger1' breaks"));
  const Requested requested{{"snapshot", run, "--times", "0 s,17 ms,29 ms"}};
  // Two ends for each of 14, 13 and 12 columns.
  for (const auto& [frame, ends] : std::map<std::size_t, std::size_t>{{0, 28}, {1, 26}, {2, 24}})
    BOOST_TEST(rows(requested.panel(frame)).at("hanger").size() == ends);
  BOOST_REQUIRE(talus_ran({"animate", run, "--out", run}).code == 0);
  BOOST_TEST(holds(talus::read_text(run + "/animation.html"), "\"broken\":[2,9]}"));
}

BOOST_AUTO_TEST_CASE(the_dialogue_of_gplot_as_options) {
  const Requested requested{{"snapshot", sample().string(), "--times", "0 s,26 ms", "--view", "both", "--window", "-10",
                             "-15", "10", "9.69", "--numbers", "--no-grid", "--title", "Mine"}};
  BOOST_TEST(requested.pages().size() == 2U);
  BOOST_TEST(requested.pages().at(1).name == "snapshot_along");
  BOOST_TEST(requested.page().title == "Mine");
  BOOST_TEST(requested.page().scale.value().unit == "lbf");
  const talus::records::Figure& panel = requested.panel(1);
  BOOST_TEST(panel.title == "t = 0.02482 s");  // 300 steps of 82.7374 us: the state nearest to 26 ms
  BOOST_TEST((requested.request.notes ==
              std::vector<std::string>{"state drawn at t = 0 s",
                                       "state drawn at t = 0.0248212 s, the nearest one to \"26 ms\""}));
  BOOST_TEST(panel.y.max.value() == 9.69);
  BOOST_TEST(!panel.grid);
  BOOST_TEST(panel.marks.at(0).words == "2");
  const Requested single{{"snapshot", sample().string(), "--count", "3", "--single"}};
  BOOST_TEST(single.pages().size() == 3U);
  BOOST_TEST((single.request.notes == std::vector<std::string>{"3 states drawn from t = 0 s to t = 0.0500561 s"}));
  const Requested exact{{"snapshot", sample().string(), "--times", "24.8212 ms"}};
  BOOST_TEST((exact.request.notes == std::vector<std::string>{"state drawn at t = 0.0248212 s"}));
  const Requested last{{"snapshot", sample().string(), "--count", "1"}};
  BOOST_TEST((last.request.notes == std::vector<std::string>{"state drawn at t = 0.0500561 s"}));
  BOOST_TEST(single.pages().at(2).name == "snapshot_side_03");
}

BOOST_AUTO_TEST_CASE(snapshots_that_cannot_be_drawn) {
  const Folder folder;
  const std::string planar = (folder.path / "planar").string();
  BOOST_REQUIRE(talus_ran({"run", scene("pendulum.toml"), "--out", planar, "--frames", "4"}).code == 0);
  const std::string run = sample().string();
  const std::vector<std::pair<std::vector<std::string>, std::string>> wrong{
      {{run, "--times", "1 s"}, "--times: found \"1 s\"; the run has states from 0 s to 0.0"},
      {{run, "--times", "3"}, "--times: found \"3\"; the unit is missing"},
      {{run, "--times", "0 s", "--count", "3"}, "--times excludes --count"},
      {{run, "--window", "1", "0", "-1", "2"},
       "--window: found 1 0 -1 2; it must be x-min y-min x-max y-max, with min < max"},
      {{run, "--view", "top"}, "--view: top not in {side,along,both}"},
      {{planar, "--view", "along"}, "planar' is plane; this view requires a fence"},
      {{planar, "--colour", "force"},
       "--colour: found \"force\"; " + planar + " holds bodies and cables, and only discs are coloured so"}};
  for (const auto& [options, message] : wrong) {
    std::vector<std::string> arguments{"snapshot"};
    arguments.insert(arguments.end(), options.begin(), options.end());
    const Ended ended = talus_ran(arguments);
    BOOST_TEST(ended.code == 2);
    BOOST_TEST(holds(ended.err, message), ended.err << " holds no " << message);
  }
  std::ofstream{folder.path / "planar/plot.json"} << "{\"title\": \"older\"}";
  const Ended older = talus_ran({"snapshot", planar});
  BOOST_TEST(older.code == 2);
  BOOST_TEST(
      holds(older.err, "planar/plot.json: it is not a file written by `talus run --out` or `talus cell --out`: "));
}

BOOST_AUTO_TEST_CASE(a_gif_has_a_picture_for_each_state) {
  const Folder folder;
  const Ended ended =
      talus_ran({"animate", sample().string(), "--gif", "--until", "20 ms", "--out", folder.path.string()});
  BOOST_TEST(ended.code == 0, ended.err);
  BOOST_TEST(ended.err.empty());
  const std::string gif = talus::read_text(folder.path / "animation.gif");
  BOOST_TEST(gif.rfind("GIF89a", 0) == 0U);
  // Each picture begins with a graphic control block: 0x21 0xF9 0x04. States at 0, 5, 10, 15 and 20 ms.
  int pictures = 0;
  for (std::size_t at = 0; (at = gif.find("\x21\xF9\x04", at)) != std::string::npos; ++at)
    ++pictures;
  BOOST_TEST(pictures == 5);
  BOOST_TEST(!fs::exists(folder.path / "animation.html"));
}

BOOST_AUTO_TEST_CASE(the_player_is_one_file_that_needs_no_other) {
  const Folder folder;
  const Ended ended = talus_ran({"animate", sample().string(), "--out", folder.path.string()});
  BOOST_TEST(ended.code == 0, ended.err);
  std::string page = talus::read_text(folder.path / "animation.html");
  for (const char* part : {"src=", "href=", "@import", "fetch(", "url("})
    BOOST_TEST(!holds(page, part), part);
  const std::string mark = "<script type=\"application/json\" id=\"data\">";
  const std::size_t begin = page.find(mark) + mark.size();
  const auto data = nlohmann::json::parse(page.substr(begin, page.find("</script>", begin) - begin));
  BOOST_TEST(data.at("frames").size() == 12U);  // eleven, and the last state
  BOOST_TEST(data.at("bodies").size() == 16U);
  BOOST_TEST(data.at("charts").at(0).at("title") == "Energies");
  const talus::KeptHistory kept = talus::read_history(sample() / "history.csv");
  // Body 1 is the rock; positions have six digits.
  BOOST_TEST(data.at("frames").at(0).at("bodies").at(1).at(0).get<double>() == kept.find("rock.x")->values.front(),
             boost::test_tools::tolerance(1e-5));
  const Ended late = talus_ran({"animate", sample().string(), "--until", "1 us"});
  BOOST_TEST(late.code == 2);
  BOOST_TEST(
      holds(late.err, "--until: found \"1 us\"; the run has fewer than two states up to that time; give a later one"));
}

// A bounce in one of 1001 rows is the highest point of its curve, and the last row its end.
BOOST_AUTO_TEST_CASE(curves_of_the_player_keep_short_peaks) {
  const Folder folder;
  const std::string run = (folder.path / "run").string();
  BOOST_REQUIRE(talus_ran({"run", scene("fence/table_2.toml"), "--out", run}).code == 0);
  const talus::KeptHistory kept = talus::read_history(fs::path{run} / "history.csv");
  BOOST_TEST_REQUIRE(kept.find("time")->values.size() > 1000U);
  BOOST_REQUIRE(talus_ran({"animate", run}).code == 0);
  const std::string page = talus::read_text(fs::path{run} / "plots" / "animation.html");
  const std::string mark = "<script type=\"application/json\" id=\"data\">";
  const std::size_t begin = page.find(mark) + mark.size();
  const auto data = nlohmann::json::parse(page.substr(begin, page.find("</script>", begin) - begin));
  std::size_t curves = 0;
  for (const auto& chart : data.at("charts")) {
    BOOST_TEST(chart.at("t").size() <= 1001U);
    BOOST_TEST(chart.at("t").back().get<double>() == kept.find("time")->values.back(),
               boost::test_tools::tolerance(1e-5));
    for (const auto& series : chart.at("series")) {
      const auto values = series.at("values").get<std::vector<double>>();
      const std::vector<double>& all = kept.find(series.at("name").get<std::string>())->values;
      BOOST_TEST(values.size() == chart.at("t").size());
      const double scale = std::max(std::abs(std::ranges::max(all)), std::abs(std::ranges::min(all)));
      BOOST_TEST(std::abs(std::ranges::max(values) - std::ranges::max(all)) < 1e-5 * scale, series.at("name"));
      BOOST_TEST(std::abs(std::ranges::min(values) - std::ranges::min(all)) < 1e-5 * scale, series.at("name"));
      BOOST_TEST(std::abs(values.back() - all.back()) < 1e-5 * scale, series.at("name"));
      ++curves;
    }
  }
  BOOST_TEST(curves > 4U);

  // The cursor shows the value of each state, not an extreme of a stretch of rows.
  const std::vector<double>& times = kept.find("time")->values;
  const auto& frames = data.at("frames");
  const auto& first = data.at("charts").at(0).at("series").at(0);
  const std::vector<double>& all = kept.find(first.at("name").get<std::string>())->values;
  BOOST_TEST(first.at("at").size() == frames.size());
  for (std::size_t n = 0; n < frames.size(); ++n) {
    const double t = frames.at(n).at("t").get<double>();
    const auto row = std::ranges::min_element(times, {}, [t](double each) { return std::abs(each - t); });
    BOOST_TEST(first.at("at").at(n).get<double>() == all[static_cast<std::size_t>(row - times.begin())],
               boost::test_tools::tolerance(5.1e-6));
  }
}

// Six digits of a subnormal number, which std::stod does not read.
BOOST_AUTO_TEST_CASE(the_player_accepts_numbers_of_any_size) {
  const Folder folder;
  const std::string run = (folder.path / "run").string();
  BOOST_REQUIRE(talus_ran({"run", scene("pendulum.toml"), "--end", "0.1 s", "--frames", "2", "--out", run}).code == 0);
  const std::string file = run + "/history.csv";
  std::istringstream lines{talus::read_text(file)};
  std::string text, line, heading;
  for (int row = 0; std::getline(lines, line); ++row) {
    if (row == 0) heading = line;
    if (row == 2) {
      const std::string before = heading.substr(0, heading.find("energy.kinetic"));
      std::size_t from = 0;
      for (auto column = std::count(before.begin(), before.end(), ','); column > 0; --column)
        from = line.find(',', from) + 1;
      line.replace(from, line.find(',', from) - from, "4.25e-310");
    }
    text += line + '\n';
  }
  std::ofstream{file} << text;
  const Ended ended = talus_ran({"animate", run});
  BOOST_TEST(ended.code == 0, ended.err);
  BOOST_TEST(holds(talus::read_text(run + "/plots/animation.html"), "4.25e-310"));
}

// Without a title, or with an empty or blank one, every command uses the name of the scene's file.
BOOST_AUTO_TEST_CASE(a_blank_title_is_replaced_by_the_name_of_the_file) {
  for (const char* name : {"two_cable.toml", "fence/table_2.toml", "cell/ice.toml"}) {
    const std::string text = talus::read_text(scene(name));
    const std::size_t begin = text.find("title = "), end = text.find('\n', begin) + 1;
    for (const char* title : {"", "title = \"\"\n", "title = \"  \"\n"}) {
      BOOST_TEST_CONTEXT(name << ", " << title) {
        const Folder folder;
        const std::string file = folder.file("untitled.toml", std::string{text}.replace(begin, end - begin, title));
        const std::string run = (folder.path / "run").string();
        const bool cell = std::string{name} == "cell/ice.toml", fence = holds(name, "fence");
        std::vector<std::string> command{cell ? "cell" : "run", file, "--out", run};
        if (!cell) command.insert(command.end(), {"--end", "4 ms", "--frames", "4"});
        if (fence) command.push_back("--sheet");
        const Ended ended = talus_ran(command);
        BOOST_TEST_REQUIRE(ended.code == 0, ended.err);
        if (!fence) BOOST_TEST(ended.out.rfind("untitled\n", 0) == 0U, ended.out.substr(0, 80));
        BOOST_TEST(nlohmann::json::parse(talus::read_text(run + "/summary.json")).at("title") == "untitled");
        if (fence) BOOST_TEST(holds(talus::read_text(run + "/sheet.html"), "<h1>untitled</h1>"));
        const std::string quantity = cell ? "depth" : "energy.kinetic";
        BOOST_TEST(Requested({"plot", run, "--history", quantity}).page().title == "untitled");
        BOOST_TEST(Requested({"snapshot", run, "--count", "2"}).page().title == "untitled");
        BOOST_TEST(talus_ran({"plot", run, "--format", "svg"}).code == 0);
        const Ended animated = talus_ran({"animate", run});
        BOOST_TEST_REQUIRE(animated.code == 0, animated.err);
        BOOST_TEST(holds(talus::read_text(run + "/plots/animation.html"), "<h1>untitled</h1>"));
      }
    }
  }
}

// Strings of a scene are drawn as plain text everywhere: no markup, no commands of gnuplot or of a shell.
BOOST_AUTO_TEST_CASE(texts_of_a_scene_stay_text) {
  const Folder folder;
  std::string text = talus::read_text(scene("two_cable.toml"));
  const auto replace_all = [&](const std::string& part, const std::string& by) {
    BOOST_REQUIRE(holds(text, part));
    for (std::size_t at = 0; (at = text.find(part, at)) != std::string::npos; at += by.size())
      text.replace(at, part.size(), by);
  };
  const std::string touch = "touch " + (folder.path / "pwned").string();
  const std::string title = "</script><script>alert(1)</script> $x$ `" + touch + "` $(" + touch + ")";
  const std::size_t first = text.find("title = "), end = text.find('\n', first);
  text.replace(first, end - first, "title = '" + title + "'");
  replace_all("\"upper\"", "\"<b>'; system '" + touch + "' # $ \"");
  std::ofstream{folder.path / "hostile.toml"} << text;
  const fs::path out = folder.path / "out";
  BOOST_REQUIRE(
      talus_ran({"run", (folder.path / "hostile.toml").string(), "--end", "10 ms", "--out", out.string()}).code == 0);
  for (const std::vector<std::string>& command : {std::vector<std::string>{"plot", out.string(), "--format", "svg"},
                                                  {"snapshot", out.string(), "--format", "svg"},
                                                  {"animate", out.string()}})
    BOOST_TEST(talus_ran(command).code == 0, command[0]);
  BOOST_TEST(!fs::exists(folder.path / "pwned"));
  std::size_t titled = 0;
  for (const auto& entry : fs::recursive_directory_iterator(out)) {
    const std::string extension = entry.path().extension();
    if (extension == ".html") BOOST_TEST(!holds(talus::read_text(entry.path().string()), "<script>alert"));
    if (extension != ".svg" && extension != ".vtp" && extension != ".pvd") continue;
    pugi::xml_document document;
    BOOST_TEST(document.load_file(entry.path().c_str()).status == pugi::status_ok, entry.path());
    titled += holds(talus::read_text(entry.path().string()), "alert(1)&lt;/script> $x$") ? 1U : 0U;
  }
  BOOST_TEST(titled > 0U);
}

// A panel for each quantity that differs between the pairs, with the restitution wanted and its largest deviations.
BOOST_AUTO_TEST_CASE(a_range_of_calibrated_pairs_is_drawn) {
  const Folder folder;
  const Requested requested{{"calibrate",   "--law",     "hertz",
                             "--dashpot",   "constant",  "--restitution",
                             "0.7",         "--modulus", "1 GPa",
                             "--speeds",    "0.1 m/s",   "10 m/s",
                             "3",           "--radii",   "1 mm",
                             "5 mm",        "2",         "--density",
                             "2500 kg/m^3", "--out",     folder.path.string(),
                             "--format",    "svg",       "--units",
                             "US"}};
  BOOST_TEST(requested.request.target == folder.path);
  BOOST_TEST((requested.request.formats == std::vector<std::string>{"svg"}));
  BOOST_TEST(requested.request.lists_files);
  BOOST_TEST(requested.page().name == "calibration");
  BOOST_TEST(holds(requested.page().title, "hertz, constant dashpot, clamped end rule, damping = "));
  BOOST_REQUIRE(requested.page().panels.size() == 3U);
  const std::vector<std::string> labels{"sphere radius", "speed", "effective mass"}, units{"ft", "ft/s", "slug"};
  for (std::size_t i = 0; i < 3; ++i) {
    const talus::records::Figure& panel = requested.panel(i);
    BOOST_TEST(panel.x.label == labels[i]);
    BOOST_TEST(panel.x.unit == units[i]);
    BOOST_TEST(panel.x.log == (i > 0));  // five times the radius, a hundred times the speed, 125 times the mass
    BOOST_TEST(panel.y.label == "restitution");
    BOOST_REQUIRE(panel.series.size() == 1U);
    BOOST_TEST(panel.series[0].x.size() == 6U);
    const auto [least, largest] = std::minmax_element(panel.series[0].y.begin(), panel.series[0].y.end());
    BOOST_REQUIRE(panel.lines.size() == 3U);
    BOOST_TEST(panel.lines[0].at == 0.7);
    BOOST_TEST(panel.lines[1].at == *least, boost::test_tools::tolerance(1e-12));
    BOOST_TEST(panel.lines[2].at == *largest, boost::test_tools::tolerance(1e-12));
  }
  BOOST_TEST(requested.panel(1).series[0].x[1] == 1.0 / 0.3048, boost::test_tools::tolerance(1e-12));
  // Equal pairs have a panel, too.
  const fs::path file = folder.file("pairs.csv", "mass_2 [kg]\n2\n2\n");
  const Requested equal{{"calibrate", "--restitution", "0.7", "--stiffness", "1 N/m", "--pairs", file.string(), "--out",
                         folder.path.string(), "--json"}};
  BOOST_REQUIRE(equal.page().panels.size() == 1U);
  BOOST_TEST(equal.panel(0).x.label == "effective mass");
  BOOST_TEST(!equal.request.lists_files);
}
