#include <fmt/format.h>
#include <fmt/ranges.h>
#include <sys/stat.h>

#include <algorithm>
#include <boost/test/unit_test.hpp>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>
#include <sstream>
#include <string>
#include <thread>
#include <vector>

#include "solver/granular/disc_method.hpp"
#include "solver/io/file/toml_document.hpp"
#include "tests/solver/app/program.hpp"

BOOST_AUTO_TEST_SUITE(command_line_tests)

// The built program from end to end: exit statuses, messages, files.

BOOST_AUTO_TEST_CASE(help_and_version) {
  for (const std::string command : {"run", "check", "advise", "calibrate", "cell", "completion", "convert", "plot",
                                    "snapshot", "animate", "study", "sweep", "list", "new"}) {
    const Ended help = talus_ran({command, "--help"});
    BOOST_TEST(help.code == 0);
    BOOST_TEST(holds(help.out, "Example"));
    BOOST_TEST(holds(talus_ran({"--help"}).out, "\n  " + command));
  }
  const Ended version = talus_ran({"--version"});
  BOOST_TEST(holds(version.out, "talus 0.1.0\nrevision "));
  BOOST_TEST(holds(version.out, "\nbuild "));
}

BOOST_AUTO_TEST_CASE(wrong_command_lines) {
  const std::vector<std::pair<std::vector<std::string>, std::string>> wrong{
      {{},
       "talus: a command is missing; known: run, check, advise, calibrate, capacity, cell, completion, convert, "
       "export, fit, plot, "
       "snapshot, "
       "animate, "
       "study, sweep, list, new\nhelp: talus "
       "--help\n"},
      {{"rnu"},
       "talus: command 'rnu' is not known; nearest: run; known: run, check, advise, calibrate, capacity, cell, "
       "completion, "
       "convert, export, "
       "fit, plot, "
       "snapshot, animate, study, sweep, list, new\n"
       "help: talus --help\n"},
      {{"run"}, "talus: SCENE is required, or --resume DIR\nhelp: talus run --help\n"},
      {{"run", scene("pendulum.toml"), "--uot", "d"},
       "talus: option '--uot' is not known; nearest: --out; known: --help, --out, --until, --resume, --sheet, "
       "--impacts, --json, --all, --end, --step, --integrator, --tolerance, --frames\nhelp: talus run --help\n"},
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
      {{"calibrate", "--law", "latching_sprong", "--restitution", "0.5"},
       "talus: --law: law 'latching_sprong' is not known; nearest: latching_spring; known: linear_spring_dashpot, "
       "latching_spring, hertz, hunt_crossley\n"},
      {{"calibrate", "--law", "latching_spring", "--restitution", "0.5"},
       "talus: --step: it is missing; give e.g. --step \"1e-7 s\"\n"},
      {{"calibrate", "--law", "latching_spring", "--restitution", "0.5", "--step", "0"},
       "talus: --step: found \"0\"; it must be > 0\n"},
      {{"calibrate", "--law", "latching_spring", "--restitution", "0.5", "--step", "1e-15"},
       "talus: --step: found 1e-15 s, 1.08e+10 steps in a contact; it must be at least 5.48e-11 s: more than 200000 "
       "steps "
       "take minutes to simulate, and hardly change the restitution\n"},
      {{"calibrate", "--law", "latching_spring", "--restitution", "0.5", "--step", "1 m"},
       "talus: --step: found \"1 m\"; that is a length; it must be a time, e.g. \"1 s\"\n"},
      {{"calibrate", "--law", "latching_spring", "--restitution", "0.5", "--step", "1e-7", "--masses", "1 kg"},
       "talus: --stiffness: it is missing; give --masses and --stiffness, or neither for discs of ice\n"},
      {{"calibrate", "--law", "latching_spring", "--restitution", "0.5", "--step", "1e-7", "--end-rule", "clamped"},
       "talus: --end-rule: the law 'latching_spring' does not use this option; remove it\n"},
      {{"calibrate", "--law", "latching_spring", "--restitution", "0.1", "--step", "1e-6", "--integrator", "euler"},
       "talus: --restitution: found 0.1; possible with euler at this step, w1 h = 0.2173: 0.5503 to 1; a shorter step "
       "extends this interval\n"},
      {{"calibrate", "--law", "latching_spring", "--restitution", "0.5", "--step", "1e-7", "--integrator", "rk4"},
       fmt::format("talus: integrator of discs 'rk4' is not known; nearest: euler; known: {}\n",
                   fmt::join(talus::disc_method_names(), ", "))},
      {{"calibrate", "--restitution", "0.5", "--masses", "1 kg", "--stiffness", "1 N/m", "--step", "1e-7"},
       "talus: --step: it is found for the law 'linear_spring_dashpot'; remove it\n"},
      {{"calibrate", scene("two_cable.toml"), "--contact", "impact", "--restitution", "0.5", "--law",
        "latching_spring"},
       "talus: --law: given by the scene; remove it\n"},
      {{"calibrate", "--restitution", "0.5", "--stiffness", "1 N/m", "--masses", "1 kg", "--speeds", "2 m/s", "1 m/s",
        "3"},
       "talus: --speeds: found \"2 m/s\" and \"1 m/s\"; the first must be less than the second\n"},
      {{"calibrate", "--restitution", "0.5", "--stiffness", "1 N/m", "--masses", "1 kg", "--speeds", "1 m/s", "2 m/s",
        "101"},
       "talus: --speeds: found \"101\"; the count must be a whole number from 2 to 100\n"},
      {{"calibrate", "--restitution", "0.5", "--stiffness", "1 N/m", "--radii", "1 m", "2 m", "2.5", "--density",
        "1 kg/m^3"},
       "talus: --radii: found \"2.5\"; the count must be a whole number from 2 to 100\n"},
      {{"calibrate", "--restitution", "0.5", "--stiffness", "1 N/m", "--radii", "1 m", "2 m", "2", "--density", "1 kg"},
       "talus: --density: found \"1 kg\"; that is a mass; it must be a density, e.g. \"1 kg/m^3\"\n"},
      {{"calibrate", "--stiffness", "1 N/m", "--masses", "1 kg", "--speeds", "1 m/s", "2 m/s", "2"},
       "talus: --restitution: it is missing; give e.g. --restitution 0.7\n"},
      {{"calibrate", "--restitution", "0.5", "--stiffness", "1 N/m", "--masses", "1 kg", "--speeds", "1 m/s", "2 m/s",
        "2", "--speed", "1 m/s"},
       "talus: --speed: each pair gives its own; remove it\n"},
      {{"calibrate", "--restitution", "0.5", "--stiffness", "1 N/m", "--masses", "1 kg", "2 kg", "2", "--bound", "-1"},
       "talus: --bound: found -1; it must be > 0\n"},
      {{"calibrate", "--restitution", "0.5", "--stiffness", "1 N/m", "--masses", "1 kg", "2 kg", "2", "--radii", "1 m",
        "2 m", "2", "--density", "1 kg/m^3"},
       "talus: --masses: found three values, an axis of masses, and --radii; give one of the two\n"},
      {{"calibrate", "--restitution", "0.5", "--stiffness", "1 N/m", "--masses", "1 kg", "2 kg", "2", "--offset",
        "1 kg m^2", "1 m"},
       "talus: --pivot and --offset: bodies of an axis of masses are hit centrally; remove them\n"},
      {{"calibrate", "--law", "latching_spring", "--restitution", "0.5", "--step", "1e-7", "--stiffness", "1 N/m",
        "--masses", "1 kg", "2 kg", "2"},
       "talus: --masses: found three values, an axis of masses; of the law 'latching_spring' it must be one or two "
       "masses\n"},
      {{"calibrate", "--restitution", "0.5", "--stiffness", "1 N/m", "--masses", "1 kg", "--radii", "1 m", "2 m", "2",
        "--density", "1 kg/m^3"},
       "talus: --masses, --pivot and --offset: each pair gives its own; remove them\n"},
      {{"calibrate", "--law", "hertz", "--restitution", "0.5", "--modulus", "1 Pa", "--radius", "1 m", "--radii", "1 m",
        "2 m", "2", "--density", "1 kg/m^3"},
       "talus: --radius: each pair gives its own; remove it\n"},
      {{"calibrate", "--law", "hertz", "--restitution", "0.5", "--modulus", "1 Pa", "--radius", "1 m", "--spheres",
        "1 m", "--masses", "1 kg", "--angle", "9 deg", "--friction", "0.1"},
       "talus: --radius: it follows from --spheres or --discs; remove it\n"},
      {{"calibrate", "--restitution", "0.5", "--stiffness", "1 N/m", "--masses", "1 kg", "--out", "never"},
       "talus: --out: only a table is written to files; give --speeds, --radii, --pairs, --angles or an axis of "
       "--masses\n"},
      {{"calibrate", "--law", "latching_spring", "--restitution", "0.5", "--step", "1e-7", "--speeds", "1 m/s", "2 m/s",
        "2"},
       "talus: --speeds: the law 'latching_spring' does not use this option; remove it\n"},
      {{"calibrate", scene("two_cable.toml"), "--contact", "impact", "--restitution", "0.5", "--out", "never"},
       "talus: --out: a range of pairs has no scene; remove one of both\n"},
      {{"calibrate", scene("two_cable.toml"), "--contact", "impact", "--restitution", "0.5", "--write-scene", "a.toml"},
       "talus: --write-scene: given by the scene; remove it\n"},
      {{"calibrate", "--law", "latching_spring", "--restitution", "0.5", "--step", "1e-7", "--write-scene", "a.toml"},
       "talus: --write-scene: only a single impact along the normal has this scene; latching_spring, oblique impacts "
       "and "
       "ranges have none; remove it\n"},
      {{"calibrate", "--restitution", "0.5", "--stiffness", "1 N/m", "--masses", "1 kg", "2 kg", "2", "--write-scene",
        "a.toml"},
       "talus: --write-scene: only a single impact along the normal has this scene; latching_spring, oblique impacts "
       "and "
       "ranges have none; remove it\n"},
      {{"calibrate", "--restitution", "0.5", "--stiffness", "1 N/m", "--masses", "1 kg", "--angle", "9 deg",
        "--spheres", "1 m", "--friction", "0.1", "--write-scene", "a.toml"},
       "talus: --write-scene: only a single impact along the normal has this scene; latching_spring, oblique impacts "
       "and "
       "ranges have none; remove it\n"},
      {{"calibrate", "--restitution", "0.5", "--stiffness", "1 N/m", "--masses", "1 kg", "--write-scene", "a.txt"},
       "talus: --write-scene: found \"a.txt\"; it must be a scene file, .toml\n"},
      {{"calibrate", "--restitusion", "0.5"},
       "talus: option '--restitusion' is not known; nearest: --restitution\nhelp: talus calibrate --help\n"},
      {{"new"}, "talus: KIND is required\nhelp: talus new --help\n"},
      {{"new", "fens"}, "talus: kind of scene 'fens' is not known; nearest: fence; known: fence, scene, cell\n"},
      {{"new", "cell", "--units", "si"}, "talus: unit system 'si' is not known; nearest: SI; known: SI, US\n"},
      {{"list", "law"},
       "talus: topic 'law' is not known; nearest: laws; known: integrators, laws, shapes, units, fields\n"},
      {{"completion", "zish"}, "talus: shell 'zish' is not known; nearest: zsh; known: bash, zsh, fish\n"}};
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

// For methods with step control, check runs the scene: its number of evaluations is that of the run.
BOOST_AUTO_TEST_CASE(check_gives_the_cost_of_a_run) {
  // Also a fence whose run ends when its rock has passed the exit.
  const Folder folder;
  std::string fence = talus_ran({"new", "fence"}).out;
  for (const char* option : {"# end = \"exit\"", "# exit_x = "})
    fence.erase(fence.find(option), 2);
  const std::size_t offset = fence.find("exit_x = \"");
  fence.replace(offset, fence.find('\n', offset) - offset, "exit_x = \"0.4 m\"");
  for (const std::string& file :
       {scene("rolling_disc.toml"), scene("sliding_block.toml"), folder.file("exit.toml", fence).string()}) {
    const auto summary = nlohmann::json::parse(talus_ran({"run", file, "--json"}).out);
    const std::string expected =
        std::to_string(summary.at("evaluations").get<long>()) + " force evaluations; each over";
    BOOST_TEST(holds(talus_ran({"check", file}).out, expected), file);
  }
}

// A user's file, with its comments and units, is not overwritten.
BOOST_AUTO_TEST_CASE(a_file_is_not_converted_into_itself) {
  const Folder folder;
  const std::string text = "# mine\n" + talus::read_text(scene("fence/sample2.toml"));
  const fs::path file = folder.file("my.toml", text);
  fs::create_directory(folder.path / "below");
  for (const fs::path& same : {file, folder.path / "below" / ".." / "my.toml"}) {
    const Ended ended = talus_ran({"convert", file.string(), same.string()});
    BOOST_TEST(ended.code == 2);
    BOOST_TEST(holds(ended.err, "which is IN; it must be another file"), ended.err);
    BOOST_TEST(talus::read_text(file) == text);
  }
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
    BOOST_TEST(holds(still.err, "no rock moves; one must"));
  }
}

BOOST_AUTO_TEST_CASE(a_file_without_end_is_an_error) {
  const Ended ended = talus_ran({"run", "/dev/zero"});
  BOOST_TEST(ended.code == 4);
  BOOST_TEST(ended.err ==
             "talus: /dev/zero: found more than 1073741824 bytes; a pipe or device must have at most that many\n");
}

// A pipe can be read once.
BOOST_AUTO_TEST_CASE(scenes_are_read_from_pipes) {
  const Folder folder;
  const fs::path pipe = folder.path / "pipe";
  BOOST_REQUIRE(::mkfifo(pipe.c_str(), 0600) == 0);
  for (const std::vector<std::string>& command :
       {std::vector<std::string>{"run", "two_cable.toml"}, {"check", "two_cable.toml"}, {"check", "cell/ice.toml"}}) {
    const std::string file = scene(command.back().c_str());
    std::thread writer{[&] { std::ofstream{pipe} << talus::read_text(file); }};
    const Ended ended = talus_ran({command.front(), pipe.string()});
    writer.join();
    BOOST_TEST(ended.code == 0, ended.err);
  }
}

// Control characters of a file neither move the cursor nor look like further messages.
BOOST_AUTO_TEST_CASE(control_characters_of_a_file_are_escaped) {
  const Folder folder;
  const std::string text = talus::read_text(scene("two_cable.toml"));
  const std::string title =
      folder.file("title.toml", replaced(text, "title = \"Two", R"(title = "\u001b[31m\b\r\nTwo)"));
  const Ended ended = talus_ran({"run", title, "--end", "1 ms"});
  BOOST_TEST(ended.code == 0, ended.err);
  BOOST_TEST(ended.out.starts_with(R"(\x1b[31m\x08\r\nTwo-cable particle impact)"
                                   "\n"),
             ended.out.substr(0, 100));
  const auto error = [&](std::string_view what, std::string_view by) {
    const std::string file = folder.file("wrong\x1b.toml", replaced(text, what, by));
    const std::string message = talus_ran({"check", file}).err;
    BOOST_TEST(!holds(message, "\x1b"), message);
    return message;
  };
  for (const auto& [what, by] :
       std::vector<std::pair<std::string, std::string>>{{"units = \"SI", R"(units = "S\u001b\u0007I)"},
                                                        {"\"2 kg", R"("2 \u001b\u0007kg)"},
                                                        {"name = \"particle", R"(name = "\u009b\u001b\u0007particle)"},
                                                        {"mobility", R"("mob\u001b\u0007ility")"}}) {
    const std::string message = error(what, by);
    BOOST_TEST(holds(message, R"(wrong\x1b.toml:)"), message);
    BOOST_TEST(holds(message, R"(\x1b\x07)"), message);
  }
  const std::string deck = talus::read_text(scene("fence/sample2.DAT"));
  const std::string wrong = folder.file("wrong.DAT", replaced(deck, "\n3 -1", "\n\x1b[31m -1"));
  BOOST_TEST(holds(talus_ran({"run", wrong}).err, R"(nel: found "\x1b[31m"; it must be)"));
}

BOOST_AUTO_TEST_CASE(files_that_cannot_be_read_or_written) {
  const Ended missing = talus_ran({"run", "nowhere.toml"});
  BOOST_TEST(missing.code == 4);
  BOOST_TEST(missing.err == "talus: nowhere.toml: No such file or directory\n");
  const Ended unwritable = talus_ran({"run", scene("pendulum.toml"), "--out", "/dev/full/out"});
  BOOST_TEST(unwritable.code == 4);
  BOOST_TEST(unwritable.err ==
             "talus: /dev/full/out: found the file '/dev/full' above it; only a folder can contain a folder\n");
  BOOST_TEST(talus_ran({"run", scene("pendulum.toml")}, "/dev/full").code == 4);
}

// A message gives the folder, what was found and what is allowed.
BOOST_AUTO_TEST_CASE(folders_that_are_not_there_or_hold_no_run) {
  const Folder folder;
  const std::string none = folder.path / "none", file = folder.file("file", ""), empty = folder.path / "empty";
  fs::create_directory(empty);
  const auto refused = [](const std::vector<std::string>& arguments, const std::string& expected) {
    const Ended ended = talus_ran(arguments);
    BOOST_TEST(ended.code == 4);
    BOOST_TEST(ended.err == "talus: " + expected + "\n");
  };
  const std::string of_run = "; it must be a folder that `talus run --out` or `talus cell --out` wrote";
  for (const std::string command : {"plot", "snapshot", "animate"}) {
    refused({command, none}, none + ": found no folder of this name" + of_run);
    refused({command, file}, file + ": found a file" + of_run);
    refused({command, empty}, empty + ": found a folder without plot.json" + of_run);
  }
  for (const std::string command : {"run", "cell"}) {
    const std::string interrupted =
        "; it must be that of an interrupted run, which `talus " + command + " --out` writes";
    refused({command, "--resume", none}, none + ": found no folder of this name" + interrupted);
    refused({command, "--resume", file}, file + ": found a file" + interrupted);
    refused({command, "--resume", empty}, empty + ": found a folder without checkpoint.json" + interrupted);
  }
  const std::string run = folder.path / "run";
  BOOST_TEST(talus_ran({"run", scene("pendulum.toml"), "--frames", "1", "--out", run}).code == 0);
  for (const std::vector<std::string>& command : {std::vector<std::string>{"run", scene("pendulum.toml")},
                                                  {"cell", scene("cell/rough.toml")},
                                                  {"study", "shear"},
                                                  {"export", "lammps", scene("cell/rough.toml")},
                                                  {"plot", run},
                                                  {"snapshot", run},
                                                  {"animate", run}}) {
    std::vector<std::string> into = command;
    into.insert(into.end(), {"--out", file});
    refused(into, file + ": found a file; it must be a folder, or a new one");
    into.back() += "/out";
    refused(into, into.back() + ": found the file '" + file + "' above it; only a folder can contain a folder");
  }
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
  // Converted to a scene and back: the title as it was read, everything else unchanged.
  const fs::path toml = folder.path / "latin.toml", back = folder.path / "back.DAT", same = folder.path / "same.DAT";
  BOOST_TEST(talus_ran({"convert", file.string(), toml.string()}).code == 0);
  BOOST_TEST(talus_ran({"convert", toml.string(), back.string()}).code == 0);
  BOOST_TEST(talus_ran({"convert", scene("fence/sample2.DAT"), same.string()}).code == 0);
  const std::string text = talus::read_text(back), wanted = talus::read_text(same);
  BOOST_TEST(text.substr(0, 14) == "B\xc3\xb6schung <&\"\\");
  BOOST_TEST(text.substr(14) == wanted.substr(6));

  fs::copy_file(file, folder.path / "\xe9.DAT");
  const std::string expected = ", which is not UTF-8; what names files and titles must be, since it is written to JSON";
  for (const char* const command : {"run", "check"}) {
    const Ended ended = talus_ran({command, (folder.path / "\xe9.DAT").string()});
    BOOST_TEST(ended.code == 2);
    BOOST_TEST(holds(ended.err, "/\xc3\xa9.DAT\"" + expected));
  }
}

BOOST_AUTO_TEST_CASE(check_distinguishes_cells_from_bodies) {
  for (const char* const cell : {"cell/ice.toml", "cell/CNTRL.DAT", "cell/rough.toml", "cell/spheres.toml"}) {
    const Ended ended = talus_ran({"check", scene(cell)});
    BOOST_TEST(ended.code == 0, ended.err);
    for (const char* const expected :
         {"80 free in 8 rows, 11 in each wall", "contact_steps", "inertial_number", "force evaluations to"})
      BOOST_TEST(holds(ended.out, expected), expected);
    const bool rough = std::string_view{cell} == "cell/rough.toml",
               spheres = std::string_view{cell} == "cell/spheres.toml";
    BOOST_TEST(holds(ended.out, "stepped_restitution") != (rough || spheres));
    BOOST_TEST(holds(ended.out, "linear_spring_dashpot, friction 0.5") == rough);
    BOOST_TEST(holds(ended.out, "hertz, friction 0.5 by mindlin") == spheres);
  }
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

// The program's exit status and message, and unchanged targets.
BOOST_AUTO_TEST_CASE(drawing_that_fails_says_why_and_leaves_nothing) {
  const Folder folder;
  const std::string run = (folder.path / "run").string(), pictures = (folder.path / "pictures").string();
  BOOST_REQUIRE(talus_ran({"run", scene("pendulum.toml"), "--frames", "4", "--out", run}).code == 0);
  BOOST_REQUIRE(talus_ran({"plot", run, "--format", "svg", "--out", pictures}).code == 0);
  const auto before = files(pictures);
  const std::string missing =
      "talus: gnuplot: cannot be started: No such file or directory (is it installed? Debian's packages: "
      "gnuplot-nox; scripts/setup installs what "
      "reports and pictures need)\n";
  const auto refused = [&](const std::vector<std::string>& command, const char* path, int code,
                           const std::string& expected) {
    const Ended ended = ran(TALUS_EXECUTABLE, command, "", path);
    BOOST_TEST(ended.code == code, ended.err);
    BOOST_TEST(holds(ended.err, expected), ended.err);
    const bool notes = command.front() == "snapshot";  // the times of the states, printed before they are drawn
    BOOST_TEST(ended.out == (notes ? "5 states drawn from t = 0 s to t = 10 s\n" : ""));
    BOOST_TEST((files(pictures) == before));
    BOOST_TEST(fs::exists(pictures));
  };
  for (const std::string command : {"plot", "snapshot"})
    refused({command, run, "--out", pictures}, "/nowhere", 4, missing);
  refused({"animate", run, "--gif", "--out", pictures}, "/nowhere", 4, missing);
  // A run is made without the programs that draw its sheet; the page then has no drawing.
  const std::string sheet = (folder.path / "sheet").string();
  const std::vector<std::string> with_sheet{"run", scene("fence/sample2.DAT"), "--end", "5 ms", "--sheet", "--out",
                                            sheet};
  const Ended bare = ran(TALUS_EXECUTABLE, with_sheet, "", "/nowhere");
  BOOST_TEST(bare.code == 4);
  BOOST_TEST(holds(bare.err, "/sheet.json: the sheet is not complete; "), bare.err);
  BOOST_TEST(holds(bare.err, "gnuplot: cannot be started: "), bare.err);
  BOOST_TEST(holds(bare.err, "\ntalus: pdflatex: cannot be started: "), bare.err);
  BOOST_TEST(holds(bare.out, "outcome      finished"), bare.out);
  BOOST_TEST(holds(bare.out, ", sheet.json, sheet.html\n"), bare.out);
  for (const char* const name : {"summary.json", "history.csv", "sheet.json", "sheet.html"})
    BOOST_TEST(fs::exists(fs::path{sheet} / name), name);

  // A gnuplot that begins a picture and fails.
  const fs::path broken = folder.path / "gnuplot";
  std::ofstream{broken} << "#!/bin/sh\necho half > \"$(dirname \"$1\")/energies.svg\"\necho no terminal >&2\nexit 3\n";
  fs::permissions(broken, fs::perms::owner_all);
  const std::string path = folder.path.string() + ":" + std::getenv("PATH");
  refused({"plot", run, "--out", pictures}, path.c_str(), 4, "(exit status 3):\ntalus: no terminal\n");
  // A run whose sheet is not drawn has the exit status of a failed output; its other files are complete.
  const Ended undrawn = ran(TALUS_EXECUTABLE, with_sheet, "", path.c_str());
  BOOST_TEST(undrawn.code == 4);
  BOOST_TEST(holds(undrawn.err, "(exit status 3):\ntalus: no terminal\n"), undrawn.err);
  BOOST_TEST(holds(undrawn.out, "outcome      finished"), undrawn.out);
  BOOST_TEST(holds(undrawn.err, "/sheet.json: the sheet is not complete; "), undrawn.err);
  BOOST_TEST(fs::exists(sheet + "/summary.json"));

  refused({"plot", run, "--out", "/proc/none"}, nullptr, 4, "talus: /proc/none");
  for (const std::string option : {"--title", "--x-limits", "--no-grid", "--until"}) {
    std::vector<std::string> command{"plot", run, "--out", pictures, option};
    const std::size_t values = option == "--no-grid" ? 0 : option == "--x-limits" ? 2 : 1;
    command.insert(command.end(), values, "1");
    refused(command, nullptr, 2, option + " requires --history");
  }
  refused({"plot", run, "--history", "vx", "--name", "a/b", "--out", pictures}, nullptr, 2,
          "talus: name of a page: found 'a/b'; it must be a plain file name\n");
  std::ofstream{fs::path{run} / "history.csv", std::ios::app} << "cut";
  refused({"plot", run, "--out", pictures}, nullptr, 2, "history.csv:");
}

BOOST_AUTO_TEST_CASE(lists_hold_the_closed_lists) {
  const Ended all = talus_ran({"list"});
  for (const char* name : {"velocity_verlet", "odeint_bulirsch_stoer", "linear_spring_dashpot", "tension_only",
                           "half_plane", "slug", "attractive"})
    BOOST_TEST(holds(all.out, name));
  for (const char* topic : {"integrators", "laws", "shapes", "units", "fields"})
    BOOST_TEST(talus_ran({"list", topic}).code == 0);
}

BOOST_AUTO_TEST_CASE(fields_are_listed_with_mark_form_range_and_default) {
  const Ended fields = talus_ran({"list", "fields"});
  for (const char* const text :
       {"\n[[hanger]]: ", "\n  * stiffness           normal stiffness k_n",
        "a stiffness, e.g. \"1 N/m\" or \"1 lbf/ft\"; > 0\n", "\n    shear_stiffness     tangential stiffness",
        "only with friction; default: the normal", "required with layers = 2", "\n  * duration ", "this or steps",
        "nearest, side_face, smoother, centroid_ray", "an inverse length"})
    BOOST_TEST(holds(fields.out, text), text);
  std::istringstream lines{fields.out};
  for (std::string line; std::getline(lines, line);)
    BOOST_TEST(line.size() <= 110U, line);
}

BOOST_AUTO_TEST_SUITE_END()
