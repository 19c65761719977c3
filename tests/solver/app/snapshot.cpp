#include <algorithm>
#include <array>
#include <boost/test/unit_test.hpp>
#include <cmath>
#include <cstdlib>
#include <fstream>
#include <map>

#include "solver/io/output/read_history.hpp"
#include "tests/solver/app/requested.hpp"
#include "tests/solver/app/sample_run.hpp"

BOOST_AUTO_TEST_SUITE(snapshot_tests)

// Pictures by `talus snapshot`: states.

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
  BOOST_TEST(panel.marks.at(0).text == "2");
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

BOOST_AUTO_TEST_SUITE_END()
