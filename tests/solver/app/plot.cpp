#include <algorithm>
#include <boost/test/unit_test.hpp>
#include <cstdio>
#include <map>

#include "solver/base/error.hpp"
#include "solver/io/output/read_history.hpp"
#include "tests/solver/app/requested.hpp"
#include "tests/solver/app/sample_run.hpp"

BOOST_AUTO_TEST_SUITE(plot_tests)

// Pictures by `talus plot`: histories.

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

BOOST_AUTO_TEST_SUITE_END()
