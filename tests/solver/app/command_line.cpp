#define BOOST_TEST_MODULE command_line
#include <sys/resource.h>

#include <algorithm>
#include <boost/test/unit_test.hpp>
#include <cmath>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>
#include <sstream>
#include <string>
#include <vector>

#include "solver/io/toml_document.hpp"
#include "tests/solver/app/program.hpp"

// The built program from end to end: exit codes, messages, files.

namespace fs = std::filesystem;

BOOST_AUTO_TEST_CASE(help_and_version) {
  for (const std::string command :
       {"run", "check", "advise", "calibrate", "convert", "plot", "snapshot", "animate", "list"}) {
    const Ended help = talus_ran({command, "--help"});
    BOOST_TEST(help.code == 0);
    BOOST_TEST(holds(help.out, "Example"));
    BOOST_TEST(holds(talus_ran({"--help"}).out, "\n  " + command));
  }
  BOOST_TEST(talus_ran({"--version"}).out.rfind("talus ", 0) == 0U);
}

BOOST_AUTO_TEST_CASE(wrong_command_lines) {
  const std::vector<std::pair<std::vector<std::string>, std::string>> wrong{
      {{},
       "talus: a command is missing; known: run, check, advise, calibrate, convert, plot, snapshot, animate, "
       "list\nhelp: talus "
       "--help\n"},
      {{"rnu"},
       "talus: command 'rnu' is not known; nearest: run; known: run, check, advise, calibrate, convert, plot, "
       "snapshot, "
       "animate, list\n"
       "help: talus --help\n"},
      {{"run"}, "talus: SCENE is required, or --resume DIR\nhelp: talus run --help\n"},
      {{"run", scene("pendulum.toml"), "--uot", "d"},
       "talus: option '--uot' is not known; nearest: --out; known: --help, --out, --until, --resume, --sheet, "
       "--json, --end, --step, --integrator, --tolerance, --frames\nhelp: talus run --help\n"},
      {{"run", scene("pendulum.toml"), "more"}, "talus: 'more' is one argument too many\nhelp: talus run --help\n"},
      {{"run", scene("pendulum.toml"), "--step", "5"},
       "talus: --step: found \"5\"; the unit is missing; write e.g. \"5 s\"\n"},
      {{"run", scene("pendulum.toml"), "--end", "-5 s"}, "talus: --end: found \"-5 s\"; it must be > 0\n"},
      {{"calibrate", "--restitution", "1.5", "--masses", "1 kg", "--stiffness", "1 N/m"},
       "talus: --restitution: found 1.5; it must be in (0, 1]\n"},
      {{"calibrate", "--restitution", "0.5", "--masses", "0 kg", "--stiffness", "1 N/m"},
       "talus: --masses: found \"0 kg\"; it must be > 0\n"},
      {{"calibrate", scene("two_cable.toml"), "--contact", "impct", "--restitution", "0.5"},
       "talus: --contact: contact 'impct' is not known; nearest: impact; known: impact\n"},
      {{"list", "law"},
       "talus: topic 'law' is not known; nearest: laws; known: integrators, laws, shapes, units, fields\n"}};
  for (const auto& [arguments, message] : wrong) {
    const Ended ended = talus_ran(arguments);
    BOOST_TEST(ended.code == 2);
    BOOST_TEST(ended.err == message);
    BOOST_TEST(ended.out.empty());
  }
}

BOOST_AUTO_TEST_CASE(convert_between_decks_and_scenes) {
  const Folder folder;
  const std::string scene_file = (folder.path / "s.TOML").string();
  const std::string deck = (folder.path / "s.dat").string();
  const Ended there = talus_ran({"convert", scene("fence/sample2.DAT"), scene_file});
  BOOST_TEST(there.code == 0);
  BOOST_TEST(there.err.empty());
  BOOST_TEST(talus::read_text(scene_file) == talus::read_text(scene("fence/sample2.toml")));
  BOOST_TEST(talus_ran({"convert", scene_file, deck}).code == 0);
  const std::string again = (folder.path / "again.toml").string();
  BOOST_TEST(talus_ran({"convert", deck, again}).code == 0);
  BOOST_TEST(talus::read_text(again) == talus::read_text(scene_file));

  const Ended extension = talus_ran({"convert", deck, (folder.path / "s.txt").string()});
  BOOST_TEST(extension.code == 2);
  BOOST_TEST(holds(extension.err, "found the extension \".txt\"; it must be .DAT (a deck of 1993) or .toml (a scene)"));
  const Ended no_fence = talus_ran({"convert", scene("two_cable.toml"), deck});
  BOOST_TEST(no_fence.code == 2);
  BOOST_TEST(holds(no_fence.err, "two_cable.toml: it has no table [fence]; only a fence can be converted"));
  BOOST_TEST(talus_ran({"convert", (folder.path / "none.DAT").string(), scene_file}).code == 4);
  BOOST_TEST(talus_ran({"convert", deck, (folder.path / "no/folder.toml").string()}).code == 4);
}

BOOST_AUTO_TEST_CASE(decks_and_their_scenes_run_alike) {
  const std::string deck = scene("fence/sample2.DAT");
  const std::string converted = scene("fence/sample2.toml");
  const Ended checked = talus_ran({"check", deck});
  BOOST_TEST(checked.code == 0);
  BOOST_TEST(checked.out == talus_ran({"check", converted}).out);
  const Folder folder;
  const std::string by_deck = (folder.path / "deck").string();
  const std::string by_scene = (folder.path / "scene").string();
  BOOST_TEST(talus_ran({"run", deck, "--end", "5 ms", "--out", by_deck}).code == 0);
  BOOST_TEST(talus_ran({"run", converted, "--end", "5 ms", "--out", by_scene}).code == 0);
  for (const char* file : {"/history.csv", "/final_state.json"})
    BOOST_TEST(talus::read_text(by_deck + file) == talus::read_text(by_scene + file));
}

BOOST_AUTO_TEST_CASE(a_fence_leaves_its_listing_histories_and_geometry) {
  const Folder folder;
  const std::string by_deck = (folder.path / "deck").string();
  const std::string by_scene = (folder.path / "scene").string();
  const Ended ended = talus_ran({"run", scene("fence/sample2.DAT"), "--end", "10 ms", "--out", by_deck});
  BOOST_TEST(ended.code == 0);
  const std::string left_out = "element 2: codes 51, 52, 48 left out: no cable begins at it\n";
  BOOST_TEST(holds(ended.out, "\nnote: " + left_out));
  BOOST_TEST(holds(ended.out, "plot.json, sample2.OUT, sample2.history.csv, sample2.history.json, sample2.pvd\n"));
  BOOST_TEST(talus::read_text(by_deck + "/sample2.history.csv").rfind("# " + left_out + "time [s],element2.vx", 0) ==
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

BOOST_AUTO_TEST_CASE(fences_that_cannot_be_built) {
  const Folder folder;
  for (const char* name : {"fence/sample2.DAT", "fence/sample2.toml"}) {
    const std::string text = talus::read_text(scene(name));
    const std::size_t speed = text.find("-65");
    const std::string file = (folder.path / fs::path{name}.filename()).string();
    std::ofstream{file} << text.substr(0, speed) << '0' << text.substr(speed + 3);
    const Ended still = talus_ran({"check", file});
    BOOST_TEST(still.code == 2);
    BOOST_TEST(holds(still.err, "talus: " + file + ":"));
    BOOST_TEST(holds(still.err, "no rock moves"));
  }
}

BOOST_AUTO_TEST_CASE(files_that_cannot_be_read_or_written) {
  const Ended missing = talus_ran({"run", "nowhere.toml"});
  BOOST_TEST(missing.code == 4);
  BOOST_TEST(missing.err == "talus: nowhere.toml: No such file or directory\n");
  const Ended unwritable = talus_ran({"run", scene("pendulum.toml"), "--out", "/dev/full/out"});
  BOOST_TEST(unwritable.code == 4);
  BOOST_TEST(unwritable.err == "talus: /dev/full/out: Not a directory\n");
  BOOST_TEST(talus_ran({"run", scene("pendulum.toml")}, "/dev/full").code == 4);
  BOOST_TEST(talus_ran({"plot", "/nowhere"}).code == 4);
}

// Files may hold 4096 bytes here; a state of the geometry needs more.
BOOST_AUTO_TEST_CASE(a_full_disk_leaves_nothing_behind) {
  const Folder folder;
  const std::string out = (folder.path / "run").string();
  rlimit before{};
  BOOST_REQUIRE(::getrlimit(RLIMIT_FSIZE, &before) == 0);
  const rlimit small{4096, before.rlim_max};
  BOOST_REQUIRE(::setrlimit(RLIMIT_FSIZE, &small) == 0);
  const Ended ended = talus_ran({"run", scene("two_cable.toml"), "--out", out});
  BOOST_REQUIRE(::setrlimit(RLIMIT_FSIZE, &before) == 0);
  BOOST_TEST(ended.code == 4);
  BOOST_TEST(ended.err == "talus: " + out + "/two_cable_geometry/two_cable_00000000.vtp: File too large\n");
  for (const auto& entry : fs::recursive_directory_iterator(out))
    BOOST_TEST(entry.is_directory(), "left behind: " << entry.path());
}

BOOST_AUTO_TEST_CASE(a_run_leaves_its_files) {
  const Folder folder;
  const std::string out = (folder.path / "run").string();
  const Ended text = talus_ran({"run", scene("two_cable.toml"), "--out", out});
  BOOST_TEST(text.code == 0);
  BOOST_TEST(text.err.empty());
  BOOST_TEST(holds(text.out, "finished at t = 3 s"));
  for (const char* file : {"history.csv", "final_state.json", "summary.json", "plot.json"})
    BOOST_TEST(fs::exists(folder.path / "run" / file));
  const std::string history = talus::read_text(folder.path / "run" / "history.csv");
  BOOST_TEST(history.rfind("time [s],particle.x [m],", 0) == 0U);
  // 3 s in records of 10 ms, the start, and the header.
  BOOST_TEST(std::count(history.begin(), history.end(), '\n') == 302);
  const Ended json = talus_ran({"run", scene("two_cable.toml"), "--json"});
  BOOST_TEST(json.out == talus::read_text(folder.path / "run" / "summary.json"));
  const auto summary = nlohmann::json::parse(json.out);
  BOOST_TEST(summary.at("steps").get<long>() == 150000);
  BOOST_TEST(summary.at("outcome").at("kind").get<std::string>() == "finished");
}

// Files of a run are JSON, XML and HTML, which are UTF-8: so is a deck's title once it is read, and names must be.
// The counts are the scene's own; the times are this machine's, and in no file.
BOOST_AUTO_TEST_CASE(a_run_says_what_its_steps_carried_and_cost) {
  const Ended ended = talus_ran({"run", scene("fence/table_2.DAT"), "--end", "8 ms"});
  BOOST_REQUIRE(ended.code == 0);
  BOOST_TEST(holds(ended.out, "2 pairs: "));
  BOOST_TEST(holds(ended.out, "cables: 13.0 awake, "));
  BOOST_TEST(holds(ended.out, "13 values kept by laws (mean of 6 looks)"));
  double whole = 0.0, contacts = 0.0, cables = 0.0, bodies = 0.0;
  const std::size_t line = ended.out.find("  a step ");
  BOOST_REQUIRE(line != std::string::npos);
  BOOST_REQUIRE(std::sscanf(&ended.out[line], " a step %lf ns: contacts %lf, cables %lf, bodies %lf,", &whole,
                            &contacts, &cables, &bodies) == 4);
  BOOST_TEST(whole > 0.0);
  BOOST_TEST(contacts > 0.0);
  BOOST_TEST(cables > 0.0);
  BOOST_TEST(!holds(talus_ran({"run", scene("fence/table_2.DAT"), "--end", "8 ms", "--json"}).out, "looks"));
}

BOOST_AUTO_TEST_CASE(titles_and_names_in_other_encodings) {
  const Folder folder;
  std::string deck = talus::read_text(scene("fence/sample2.DAT"));
  const fs::path file = folder.file("latin.DAT", deck.replace(0, 6, "B\xf6schung <&\"\\"));
  const std::string out = (folder.path / "out").string();
  BOOST_TEST(talus_ran({"run", file.string(), "--end", "1 ms", "--sheet", "--out", out}).code == 0);
  for (const char* name : {"summary.json", "final_state.json", "plot.json", "sheet.json", "latin.history.json"}) {
    const auto json = nlohmann::json::parse(talus::read_text(out + "/" + name));
    BOOST_TEST(json.at("title").get<std::string>().substr(0, 14) == "B\xc3\xb6schung <&\"\\", name);
  }
  BOOST_TEST(holds(talus::read_text(out + "/latin.OUT"), "B\xc3\xb6schung <&\"\\"));
  // To a scene and back: the title as it was read, all else as it was.
  const fs::path toml = folder.path / "latin.toml", back = folder.path / "back.DAT", same = folder.path / "same.DAT";
  BOOST_TEST(talus_ran({"convert", file.string(), toml.string()}).code == 0);
  BOOST_TEST(talus_ran({"convert", toml.string(), back.string()}).code == 0);
  BOOST_TEST(talus_ran({"convert", scene("fence/sample2.DAT"), same.string()}).code == 0);
  const std::string text = talus::read_text(back), wanted = talus::read_text(same);
  BOOST_TEST(text.substr(0, 14) == "B\xc3\xb6schung <&\"\\");
  BOOST_TEST(text.substr(14) == wanted.substr(6));

  fs::copy_file(file, folder.path / "\xe9.DAT");
  const std::string words = ", which is not UTF-8; what names files and titles must be, since it is written to JSON";
  for (const char* const command : {"run", "check"}) {
    const Ended ended = talus_ran({command, (folder.path / "\xe9.DAT").string()});
    BOOST_TEST(ended.code == 2);
    BOOST_TEST(holds(ended.err, "/\xc3\xa9.DAT\"" + words));
  }
}

// Without a ledger the same rows end before the first column of the accounts, and no file speaks of them.
BOOST_AUTO_TEST_CASE(a_run_without_a_ledger_keeps_no_accounts) {
  const Folder folder;
  const std::string plain = talus::read_text(scene("pendulum.toml"));  // [run] is its last table
  std::ofstream{folder.path / "off.toml"} << plain << "ledger = \"off\"\n";
  const std::string with = (folder.path / "with").string();
  const std::string without = (folder.path / "without").string();
  BOOST_REQUIRE(talus_ran({"run", scene("pendulum.toml"), "--out", with}).code == 0);
  const Ended off = talus_ran({"run", (folder.path / "off.toml").string(), "--out", without});
  BOOST_REQUIRE(off.code == 0);
  BOOST_TEST(holds(off.out, "\nledger: off; no energies, losses and closures were kept\n"));
  const auto summary = nlohmann::json::parse(talus::read_text(without + "/summary.json"));
  BOOST_TEST(summary.at("ledger").get<std::string>() == "off");
  for (const char* file : {"/summary.json", "/history.csv", "/plot.json"}) {
    for (const char* part : {"energy.", "lost.", "closure."})
      BOOST_TEST(!holds(talus::read_text(without + file), part));
  }
  std::istringstream all{talus::read_text(with + "/history.csv")}, motion{talus::read_text(without + "/history.csv")};
  int lines = 0;
  for (std::string longer, shorter; std::getline(all, longer) && std::getline(motion, shorter); ++lines)
    BOOST_TEST(longer.rfind(shorter + ',', 0) == 0U);
  BOOST_TEST(lines == 1002);  // 10 s in records of 10 ms, the start, and the header
}

BOOST_AUTO_TEST_CASE(the_command_line_changes_the_plan) {
  const auto summary =
      nlohmann::json::parse(talus_ran({"run", scene("two_cable.toml"), "--json", "--end", "0.1 s", "--step", "1 ms",
                                       "--integrator", "odeint_dopri5", "--tolerance", "1e-9"})
                                .out);
  BOOST_TEST(summary.at("integrator").get<std::string>() == "odeint_dopri5");
  BOOST_TEST(summary.at("steps").get<long>() == 100);
}

// A particle between two pretensioned cables, stepped far beyond the linear limit, grows until it is no longer finite.
BOOST_AUTO_TEST_CASE(a_diverged_run_is_recorded) {
  const Folder folder;
  const std::string out = (folder.path / "run").string();
  const std::string scene_file = std::string{TALUS_TEST_SCENES} + "/unstable.toml";
  // Its step is beyond the linear limit: said before the run, and the watch ends it at once.
  const Ended watched = talus_ran({"run", scene_file, "--out", out});
  BOOST_TEST(watched.code == 3);
  BOOST_TEST(watched.err.rfind("talus: warning: h omega = ", 0) == 0U);
  BOOST_TEST(holds(watched.err, "\ntalus: at t = 0 h omega = "));
  // Without the watch it goes on until numbers are no longer finite, and the limit is said again as the reason.
  const std::string alone = (folder.path / "alone.toml").string();
  std::ofstream{alone} << talus::read_text(scene_file) << "watch = { instability = \"off\", accuracy = \"off\" }\n";
  const Ended ended = talus_ran({"run", alone, "--out", out});
  BOOST_TEST(ended.code == 3);
  BOOST_TEST(holds(ended.err, "\ntalus: diverged at t = "));
  const auto summary = nlohmann::json::parse(talus::read_text(folder.path / "run" / "summary.json"));
  BOOST_TEST(summary.at("outcome").at("kind").get<std::string>() == "diverged");
  const std::string history = talus::read_text(folder.path / "run" / "history.csv");
  BOOST_TEST(std::count(history.begin(), history.end(), '\n') > 10);
  BOOST_TEST(!holds(history, "nan"));
  BOOST_TEST(!holds(history, "inf"));
}

BOOST_AUTO_TEST_CASE(check_says_what_a_scene_carries) {
  const Ended ended = talus_ran({"check", scene("two_cable.toml")});
  BOOST_TEST(ended.code == 0);
  BOOST_TEST(holds(ended.out, "bodies 2, degrees of freedom 4"));
  BOOST_TEST(holds(ended.out, "contact pairs possible 1, with 1 law instances; cables 2"));
  // w0 = sqrt(k (1/m + 1/M)) = sqrt(1e4 * 1.5); cables alone would give 2 rad/s.
  BOOST_TEST(holds(ended.out, "122.47"));
  BOOST_TEST(holds(ended.out, "150000 steps"));
}

// Values of the closed forms (e = .5 needs xi = .2552756 clamped and .2154538 by Eq. 21), of the pivot's mass I/h^2,
// and the simulated e.
BOOST_AUTO_TEST_CASE(calibration_as_json) {
  const auto two = nlohmann::json::parse(talus_ran({"calibrate", "--restitution", ".5", "--masses", "3 kg", "6 kg",
                                                    "--stiffness", "1e6 N/m", "--end-rule", "clamped", "--json"})
                                             .out);
  BOOST_TEST(two.at("effective_mass").get<double>() == 2.0, boost::test_tools::tolerance(1e-15));
  BOOST_TEST(two.at("damping_ratio").get<double>() == 0.2552756, boost::test_tools::tolerance(1e-6));
  BOOST_TEST(two.at("damping").get<double>() == 2.0 * 0.2552756 * std::sqrt(2e6), boost::test_tools::tolerance(1e-6));
  BOOST_TEST(std::abs(two.at("restitution").get<double>() - 0.5) < 1e-3);
  const auto pivot = nlohmann::json::parse(talus_ran({"calibrate", "--restitution", ".5", "--masses", "1 kg", "--pivot",
                                                      "8 kg m^2", "2 m", "--stiffness", "1e6 N/m", "--json"})
                                               .out);
  BOOST_TEST(pivot.at("effective_mass").get<double>() == 2.0, boost::test_tools::tolerance(1e-15));
  BOOST_TEST(pivot.at("damping_ratio").get<double>() == 0.2154537620, boost::test_tools::tolerance(1e-6));
  BOOST_TEST(pivot.at("end_rule").get<std::string>() == "attractive");
  const auto offset =
      nlohmann::json::parse(talus_ran({"calibrate", "--restitution", ".5", "--masses", "1 kg", "--offset", "1 kg m^2",
                                       "1 m", "--stiffness", "1e6 N/m", "--json"})
                                .out);
  BOOST_TEST(offset.at("effective_mass").get<double>() == 0.5, boost::test_tools::tolerance(1e-15));
}

BOOST_AUTO_TEST_CASE(calibration_of_a_scene) {
  const auto found = nlohmann::json::parse(
      talus_ran({"calibrate", scene("two_cable.toml"), "--contact", "impact", "--restitution", ".6", "--json"}).out);
  BOOST_TEST(std::abs(found.at("restitution").get<double>() - 0.6) < 1e-5);
  for (const char* key : {"damping", "damping_ratio", "contact_time", "largest_overlap", "step"})
    BOOST_TEST(found.at(key).get<double>() > 0.0);
}

BOOST_AUTO_TEST_CASE(plot_without_its_tool_says_so) {
  const Folder folder;
  fs::copy_file(TALUS_EXECUTABLE, folder.path / "talus");
  const std::string out = (folder.path / "run").string();
  BOOST_REQUIRE(talus_ran({"run", scene("pendulum.toml"), "--out", out}).code == 0);
  const Ended ended = ran((folder.path / "talus").string(), {"plot", out}, "", "/nowhere");
  BOOST_TEST(ended.code == 4);
  BOOST_TEST(ended.err == "talus: talus_report draws the plots; it is neither beside talus nor in PATH\n");
}

BOOST_AUTO_TEST_CASE(lists_hold_the_closed_lists) {
  const Ended all = talus_ran({"list"});
  for (const char* name : {"velocity_verlet", "odeint_bulirsch_stoer", "linear_spring_dashpot", "tension_only",
                           "half_plane", "slug", "attractive"})
    BOOST_TEST(holds(all.out, name));
  for (const char* topic : {"integrators", "laws", "shapes", "units", "fields"})
    BOOST_TEST(talus_ran({"list", topic}).code == 0);
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

  std::ofstream{in("weak.toml")} << text << "\n[fence.options]\nhanger_strength = \"10000 lbf\"\n";
  const Ended weak = talus_ran({"run", in("weak.toml"), "--end", "10 ms", "--out", in("broken")});
  BOOST_TEST(holds(weak.out, "hanger 'hanger1' breaks"));
  const Ended refused = talus_ran({"convert", in("weak.toml"), in("third.toml"), "--after", in("broken")});
  BOOST_TEST(refused.code == 2);
  BOOST_TEST(holds(refused.err, "final_state.json: hanger 'hanger1': found it broken; a fence is mended before the"));
  BOOST_TEST(talus_ran({"convert", in("weak.toml"), in("third.toml"), "--after", in("none")}).code == 4);

  // A run ends where its rock has gone: at 65 ft/s and slower 2 ft take 30 ms and more.
  std::ofstream{in("exit.toml")} << text << "\n[fence.options]\nend = \"exit\"\nexit_x = \"1 ft\"\n";
  const Ended gone = talus_ran({"run", in("exit.toml"), "--json"});
  BOOST_TEST(gone.code == 0);
  const auto summary = nlohmann::json::parse(gone.out);
  BOOST_TEST(summary["outcome"]["kind"] == "finished");
  BOOST_TEST(summary["outcome"]["time"].get<double>() > 1.2 / 65.0);
  BOOST_TEST(summary["outcome"]["time"].get<double>() < 0.1);
}

BOOST_AUTO_TEST_CASE(a_step_of_its_own) {
  const Ended step = talus_ran({"run", scene("two_cable.toml"), "--step", "auto", "--end", "10 ms", "--json"});
  BOOST_TEST(step.code == 0);
  const double chosen = nlohmann::json::parse(step.out)["step"];
  BOOST_TEST(chosen > 0.0);
  const std::string words = nlohmann::json(chosen).dump() + " s";
  const Ended same = talus_ran({"run", scene("two_cable.toml"), "--step", words, "--end", "10 ms", "--json"});
  BOOST_TEST(same.out == step.out);
}
