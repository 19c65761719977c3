
#include <boost/test/unit_test.hpp>
#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "solver/app/run/verdict_text.hpp"
#include "solver/io/file/toml_document.hpp"
#include "tests/solver/app/program.hpp"

BOOST_AUTO_TEST_SUITE(fence_run_tests)

// `talus run` of fences from end to end: verdict and its sensitivity, a second rock, the files of a deck.

// The summary of a new fence states the sensitivity of its verdict; that of a long run, that it was not examined.
BOOST_AUTO_TEST_CASE(the_summary_of_a_fence_says_how_sensitive_its_verdict_is) {
  const Folder folder;
  const Ended made = talus_ran({"run", folder.file("my.toml", talus_ran({"new", "fence"}).out).string()});
  BOOST_TEST(holds(made.out, "sensitivity  with 1.001 times the rocks' speed the verdict is unchanged; "), made.out);
  const Ended deck = talus_ran({"run", scene("fence/table_2.DAT")});
  BOOST_TEST(holds(deck.out, "sensitivity  not examined; --sheet repeats the run"), deck.out);
}

BOOST_AUTO_TEST_CASE(a_rock_that_starts_at_rest_has_no_percentage_of_its_energy) {
  talus::scenes::RockPassage rock;
  rock.name = "rock", rock.verdict = talus::scenes::Verdict::stopped;
  rock.touched = true, rock.end_velocity = {3.0, -4.0}, rock.end_energy = 25.0;
  const auto line = [&](double approach_energy) {
    rock.approach_energy = approach_energy;
    talus::RunRecord record;
    record.fence.emplace().rocks = {rock};
    return talus::app::verdict_lines(record).at(1);
  };
  BOOST_TEST(line(100.0) == "rock         stopped; still touching at the end: 5 m/s, 25 N m of 100 N m (25.0 %)");
  BOOST_TEST(line(0.0) == "rock         stopped; still touching at the end: 5 m/s, 25 N m of 0 N m");
}

// The repeat changes the speed of each rock, and its verdict is that on all of them, whatever their order.
BOOST_AUTO_TEST_CASE(the_repeat_of_a_fence_counts_every_rock) {
  const Folder folder;
  const std::string text = talus_ran({"new", "fence"}).out, head = "[[fence.rock]]";
  const std::string over =
      "[[fence.rock]]\na = \"0.4 m\"\nb = \"0.4 m\"\nmass = \"700 kg\"\nposition = [\"2 m\", \"8 m\"]\n"
      "velocity = [\"-20 m/s\", \"0 m/s\"]\n\n";
  const std::size_t first = text.find(head), next = text.find("\n[", first) + 1;
  for (const std::size_t offset : {first, next}) {
    const std::string file = folder.file("two.toml", std::string{text}.insert(offset, over)).string();
    const auto summary = nlohmann::json::parse(talus_ran({"run", file, "--json"}).out);
    const auto& repeat = summary.at("quality").at("repeat");
    BOOST_TEST(summary.at("verdict").at("fence") == "passed_over");
    BOOST_TEST(repeat.at("verdict") == "passed_over");
    // Impact forces grow with the speed.
    const double change = repeat.at("change_of_largest_cable_force").get<double>();
    BOOST_TEST(change > 5e-4);
    BOOST_TEST(change < 2e-3);
  }
}

BOOST_AUTO_TEST_CASE(a_rock_that_has_not_arrived_does_not_touch) {
  const Folder folder;
  const std::string file = folder.file("my.toml", talus_ran({"new", "fence"}).out).string();
  const auto rocks = [&](const char* end) {
    return nlohmann::json::parse(talus_ran({"run", file, "--json", "--end", end}).out).at("verdict").at("rocks");
  };
  const auto before = rocks("1 ms"), during = rocks("50 ms");
  BOOST_TEST(!before.at(0).at("touched").get<bool>());
  BOOST_TEST(!before.at(0).at("still_touching").get<bool>());
  BOOST_TEST(during.at(0).at("still_touching").get<bool>());
}

BOOST_AUTO_TEST_CASE(the_next_rock_meets_the_cables_of_the_last) {
  const Folder folder;
  const auto in = [&](const char* name) { return (folder.path / name).string(); };
  std::string text = talus::read_text(scene("fence/table_2.toml"));
  const std::size_t limit = text.find("limit_top = ");
  text.replace(limit, text.find('\n', limit) - limit, "limit_top = \"60000 lbf\"");
  std::ofstream{in("fence.toml")} << text;
  const Ended first = talus_ran({"run", in("fence.toml"), "--end", "10 ms", "--out", in("first")});
  BOOST_TEST(first.code == 0);
  BOOST_TEST(holds(first.out, "cable 'top1' yields"));
  BOOST_TEST(talus_ran({"convert", in("fence.toml"), in("second.toml"), "--after", in("first")}).code == 0);
  BOOST_TEST(holds(talus::read_text(in("second.toml")), "[[fence.stretched_cable]]\ncable = \"top1\"\nstretch = "));
  BOOST_TEST(talus_ran({"run", in("second.toml"), "--end", "1 ms"}).code == 0);

  // The names that are read here are those of schema 1, too.
  const std::string state_file = in("first") + "/final_state.json", state = talus::read_text(state_file);
  std::ofstream{state_file} << replaced(state, "\"schema\": 2", "\"schema\": 1");
  BOOST_TEST(talus_ran({"convert", in("fence.toml"), in("again.toml"), "--after", in("first")}).code == 0);
  BOOST_TEST((talus::read_text(in("again.toml")) == talus::read_text(in("second.toml"))));
  std::ofstream{state_file} << replaced(state, "\"schema\": 2", "\"schema\": 3");
  const Ended later = talus_ran({"convert", in("fence.toml"), in("again.toml"), "--after", in("first")});
  BOOST_TEST(later.code == 2);
  BOOST_TEST(holds(later.err, state_file +
                                  ": schema: found 3; it must be 1 or 2: run the fence again with this version "
                                  "of talus\n"));

  std::ofstream{in("weak.toml")} << text << "\n[fence.options]\nhanger_strength = \"10000 lbf\"\n";
  const Ended weak = talus_ran({"run", in("weak.toml"), "--end", "10 ms", "--out", in("broken")});
  BOOST_TEST(holds(weak.out, "hanger 'hanger1' breaks"));
  const Ended refused = talus_ran({"convert", in("weak.toml"), in("third.toml"), "--after", in("broken")});
  BOOST_TEST(refused.code == 2);
  BOOST_TEST(holds(refused.err, "final_state.json: hanger 'hanger1': found it broken; broken parts cannot be carried"));
  BOOST_TEST(talus_ran({"convert", in("weak.toml"), in("third.toml"), "--after", in("none")}).code == 4);

  // A run ends when its rock has passed the exit: at 65 ft/s and slower 2 ft take 30 ms or more.
  std::ofstream{in("exit.toml")} << text << "\n[fence.options]\nend = \"exit\"\nexit_x = \"1 ft\"\n";
  const Ended gone = talus_ran({"run", in("exit.toml"), "--json"});
  BOOST_TEST(gone.code == 0);
  const auto summary = nlohmann::json::parse(gone.out);
  BOOST_TEST(summary["outcome"]["kind"] == "finished");
  BOOST_TEST(summary["outcome"]["time"].get<double>() > 1.2 / 65.0);
  BOOST_TEST(summary["outcome"]["time"].get<double>() < 0.1);
}

BOOST_AUTO_TEST_CASE(history_codes_that_are_none_stop_a_run_at_its_start) {
  const Folder folder;
  std::string text = talus::read_text(scene("fence/sample2.DAT"));
  text.replace(text.find("51 52 48"), 8, "51 28 48");
  const std::string deck = (folder.path / "old.DAT").string();
  std::ofstream{deck} << text;
  const Ended ended = talus_ran({"run", deck, "--out", (folder.path / "run").string()});
  BOOST_TEST(ended.code == 2);
  BOOST_TEST(ended.err.rfind("talus: " + deck +
                                 ": history_codes (variab): found 28 (OLD ELEMENT VELOCITY AT CENTROID "
                                 "ROT.): ",
                             0) == 0U);
  BOOST_TEST(!fs::exists(folder.path / "run" / "history.csv"));
}

BOOST_AUTO_TEST_CASE(a_fence_leaves_its_listing_histories_and_geometry) {
  const Folder folder;
  const std::string by_deck = (folder.path / "deck").string();
  const std::string by_scene = (folder.path / "scene").string();
  const Ended ended = talus_ran({"run", scene("fence/sample2.DAT"), "--end", "10 ms", "--out", by_deck});
  BOOST_TEST(ended.code == 0);
  const std::string skipped = "element 2: codes 51, 52, 48 skipped: no cable begins at it\n";
  BOOST_TEST(holds(ended.out, "\nnote: " + skipped));
  BOOST_TEST(holds(ended.out, "plot.json, sample2.OUT, sample2.history.csv, sample2.history.json, sample2.pvd\n"));
  BOOST_TEST(talus::read_text(by_deck + "/sample2.history.csv").rfind("# " + skipped + "time [s],element2.vx", 0) ==
             0U);
  const auto summary = nlohmann::json::parse(talus::read_text(by_deck + "/summary.json"));
  BOOST_TEST(summary.at("notes").size() == 1U);
  BOOST_TEST(holds(talus::read_text(by_deck + "/sample2.OUT"), "\ntime = .993E-02 secs\n"));
  BOOST_TEST(fs::exists(by_deck + "/sample2_geometry/sample2_00000120.vtp"));
  BOOST_TEST(talus_ran({"run", scene("fence/sample2.toml"), "--end", "10 ms", "--out", by_scene}).code == 0);
  for (const char* file : {"/sample2.OUT", "/sample2.history.csv", "/sample2.history.json", "/sample2.pvd",
                           "/sample2_geometry/sample2_00000120.vtp"})
    BOOST_TEST(talus::read_text(by_deck + file) == talus::read_text(by_scene + file));
}

// A file of times alone would look as if its values were lost.
BOOST_AUTO_TEST_CASE(a_fence_without_requested_histories_has_no_file_of_them) {
  const Folder folder;
  const std::string out = (folder.path / "out").string();
  const std::string file = folder.file("new.toml", talus_ran({"new", "fence"}).out).string();
  const Ended ended = talus_ran({"run", file, "--end", "10 ms", "--out", out});
  BOOST_TEST(ended.code == 0);
  BOOST_TEST(!holds(ended.out, ".history."));
  BOOST_TEST(!fs::exists(out + "/new.history.csv"));
  BOOST_TEST(!fs::exists(out + "/new.history.json"));
  BOOST_TEST(!holds(talus::read_text(out + "/plot.json"), ".history."));
  BOOST_TEST(talus_ran({"plot", out, "--history", "rock.vx"}).code == 0);
}

// A sheet's verdict is compared with that of a run with the speed changed by a thousandth; a separate run confirms it.
BOOST_AUTO_TEST_CASE(a_sheet_says_how_sensitive_its_verdict_is) {
  const Folder folder;
  const std::string text = talus::read_text(scene("fence/table_2.toml"));
  const auto json = [&](const std::string& file, std::vector<std::string> more) {
    std::vector<std::string> command{"run", file, "--json", "--end", "0.05 s"};
    command.insert(command.end(), more.begin(), more.end());
    return nlohmann::json::parse(talus_ran(command).out);
  };
  const auto plain = json(scene("fence/table_2.toml"), {"--sheet", "--out", (folder.path / "run").string()});
  const auto& repeat = plain.at("quality").at("repeat");
  BOOST_TEST(repeat.at("change_of_speed").get<double>() == 1e-3);
  const std::size_t offset = text.find("velocity = [\"-65 ft/s\"");
  BOOST_TEST_REQUIRE(offset != std::string::npos);
  std::string faster = text;
  faster.replace(offset, std::string{"velocity = [\"-65 ft/s\""}.size(), "velocity = [\"-65.065 ft/s\"");
  std::ofstream{folder.path / "faster.toml"} << faster;
  const auto other = json((folder.path / "faster.toml").string(), {});
  const double change = other.at("verdict").at("largest_cable_force").at("peak").get<double>() /
                            plain.at("verdict").at("largest_cable_force").at("peak").get<double>() -
                        1.0;
  // The deck's stiffness, and hence the step, also depends on the speed: agreement to first order in the change.
  BOOST_TEST(std::abs(repeat.at("change_of_largest_cable_force").get<double>() - change) < 2e-3);
  BOOST_TEST(repeat.at("change_of_largest_cable_force").get<double>() != 0.0);
}

BOOST_AUTO_TEST_SUITE_END()
