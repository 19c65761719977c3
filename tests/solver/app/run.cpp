#include <fmt/format.h>

#include <sys/resource.h>

#include <algorithm>
#include <boost/test/unit_test.hpp>
#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>
#include <sstream>
#include <string>
#include <tuple>
#include <vector>

#include "solver/io/file/toml_document.hpp"
#include "tests/solver/app/program.hpp"

BOOST_AUTO_TEST_SUITE(run_tests)

// `talus run` of the built program from end to end: its files, changes of the plan, and failures.

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

// The last line lists the files written, or says how to have them written; with --json only the summary is printed.
BOOST_AUTO_TEST_CASE(a_run_without_a_folder_says_where_results_could_go) {
  const std::string none = "files: none; --out DIR writes ";
  for (const auto& [command, file, expected] :
       {std::tuple{"run", "pendulum.toml", "histories, geometry and summary\n"},
        {"run", "fence/table_2.toml", "histories, geometry and summary; with --sheet also the engineer's sheet\n"},
        {"cell", "cell/ice.toml", "histories, profiles, states and summary\n"}}) {
    std::vector<std::string> arguments{command, scene(file)};
    if (std::string_view{command} == "run") arguments.insert(arguments.end(), {"--end", "100 ms"});
    const Ended bare = talus_ran(arguments);
    BOOST_TEST(bare.code == 0);
    BOOST_TEST(bare.out.ends_with('\n' + none + expected), bare.out);
    const Folder folder;
    arguments.insert(arguments.end(), {"--out", (folder.path / "out").string()});
    BOOST_TEST(!holds(talus_ran(arguments).out, none));
    BOOST_TEST(folder.files() == 1);
    arguments.resize(arguments.size() - 2);
    arguments.emplace_back("--json");
    BOOST_TEST(!holds(talus_ran(arguments).out, "files: "));
  }
}

// Files of a run are JSON, XML and HTML, which are UTF-8: a deck's title is converted to it, and names must be UTF-8.
// The counts are those of the scene; the times are measured on this machine and are in no file.
BOOST_AUTO_TEST_CASE(a_run_says_what_its_steps_carried_and_cost) {
  const Ended ended = talus_ran({"run", scene("fence/table_2.DAT"), "--end", "8 ms", "--all"});
  BOOST_REQUIRE(ended.code == 0);
  BOOST_TEST(holds(ended.out, "extremes over all steps"));
  const Ended brief = talus_ran({"run", scene("fence/table_2.DAT"), "--end", "8 ms"});
  BOOST_TEST(!holds(brief.out, "extremes"));
  BOOST_TEST(!holds(brief.out, "a step "));
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

// Without a ledger the same rows end before the first column of the energy balance, and no file mentions it.
BOOST_AUTO_TEST_CASE(a_run_without_a_ledger_keeps_no_accounts) {
  const Folder folder;
  const std::string plain = talus::read_text(scene("pendulum.toml"));  // [run] is its last table
  std::ofstream{folder.path / "off.toml"} << plain << "ledger = \"off\"\n";
  const std::string with = (folder.path / "with").string();
  const std::string without = (folder.path / "without").string();
  BOOST_REQUIRE(talus_ran({"run", scene("pendulum.toml"), "--out", with}).code == 0);
  const Ended off = talus_ran({"run", (folder.path / "off.toml").string(), "--out", without});
  BOOST_REQUIRE(off.code == 0);
  BOOST_TEST(holds(off.out, "\nledger: off; no energies and balance errors were recorded\n"));
  const auto summary = nlohmann::json::parse(talus::read_text(without + "/summary.json"));
  BOOST_TEST(summary.at("ledger").get<std::string>() == "off");
  for (const char* file : {"/summary.json", "/history.csv", "/plot.json"}) {
    for (const char* part : {"energy.", "dissipated.", "balance_error."})
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

BOOST_AUTO_TEST_CASE(a_step_of_the_command_line_with_which_the_end_is_out_of_reach_is_refused) {
  const Folder folder;
  const Ended ended = talus_ran({"run", scene("two_cable.toml"), "--step", "1e-15 s", "--until", "1e-13 s", "--out",
                                 (folder.path / "out").string()});
  BOOST_TEST(ended.code == 2);
  BOOST_TEST(ended.err == "talus: run: the end is 3e+15 steps away; it must be at most 1e12\n");
}

// For several contacts the summary counts those that never touched, and gives the smallest gap.
BOOST_AUTO_TEST_CASE(contacts_that_never_touch_are_counted) {
  const Folder folder;
  const std::string text = talus::read_text(scene("rolling_disc.toml"));
  const std::string other =
      "[[body]]\nname = \"other\"\nmobility = \"fixed\"\nposition = [\"-1 m\", \"2 m\"]\n"
      "shape = { kind = \"circle\", radius = \"0.5 m\" }\n"
      "[[contact]]\nname = \"aside\"\nbetween = [\"disc\", \"other\"]\nlaw = \"linear_spring_dashpot\"\n"
      "stiffness = \"1e6 N/m\"\ndamping = \"0 N s/m\"\n";
  const std::size_t run = text.find("[run]");
  const std::string file = folder.file("two.toml", text.substr(0, run) + other + text.substr(run)).string();
  const std::string out = talus_ran({"run", file}).out;
  BOOST_TEST(holds(out, "; 1 of 2 contacts never touched; closest was aside with a gap of 1."), out);
  BOOST_TEST(!holds(talus_ran({"run", scene("rolling_disc.toml")}).out, "never touched"));
}

BOOST_AUTO_TEST_CASE(an_unknown_integrator_names_those_there_are) {
  const Ended ended = talus_ran({"run", scene("pendulum.toml"), "--integrator", "autoo"});
  BOOST_TEST(ended.code == 2);
  BOOST_TEST(holds(ended.err, "integrator 'autoo' is not known; nearest: auto; known: "), ended.err);
}

BOOST_AUTO_TEST_CASE(the_final_state_is_printed_in_the_columns_of_its_head) {
  const std::vector<std::string> command{"run", scene("rolling_disc.toml"), "--end", "20 ms"};
  const std::string text = talus_ran(command).out;
  std::vector<std::string> json = command;
  json.emplace_back("--json");
  const auto summary = nlohmann::json::parse(talus_ran(json).out);
  BOOST_TEST(holds(text, fmt::format("  {:<14}{:>14}{:>14}{:>14}{:>14}{:>14}{:>14}\n", "body", "x", "y", "angle", "vx",
                                     "vy", "spin")));
  for (const auto& body : summary.at("bodies")) {
    const auto number = [&](const char* of, std::size_t i) { return body.at(of).at(i).get<double>(); };
    const std::string line = fmt::format("  {:<14}{:>14.7g}{:>14.7g}{:>14.7g}{:>14.7g}{:>14.7g}{:>14.7g}\n",
                                         body.at("name").get<std::string>(), number("position", 0),
                                         number("position", 1), body.at("angle").get<double>(), number("velocity", 0),
                                         number("velocity", 1), body.at("spin").get<double>());
    BOOST_TEST(holds(text, line), line);
  }
}

BOOST_AUTO_TEST_CASE(boxes_in_a_bin_are_followed_to_the_end) {
  const Ended ended = talus_ran({"run", std::string{TALUS_TEST_SCENES} + "/boxes_in_a_bin.toml"});
  BOOST_TEST(ended.code == 0, ended.err);
  BOOST_TEST(holds(ended.out, "usable; energy balance within"), ended.out);
}

// The quality verdict does not depend on the settings of the run monitor.
BOOST_AUTO_TEST_CASE(quality_is_examined_whatever_is_watched) {
  const Folder folder;
  const std::string text = talus::read_text(std::string{TALUS_TEST_SCENES} + "/unstable.toml");
  const auto quality = [&](const char* name, const std::string& more) {
    const Ended ended = talus_ran({"run", folder.file(name, text + more).string()});
    return ended.out.substr(ended.out.find("quality"));
  };
  const std::string off = "watch = \"off\"\n";
  BOOST_TEST(quality("balance.toml", off).starts_with("quality      NOT USABLE: "));
  BOOST_TEST(quality("step.toml", off + "ledger = \"off\"\n").starts_with("quality      NOT USABLE: "));
  const Ended bare = talus_ran(
      {"run", folder.file("bare.toml", talus::read_text(scene("rolling_disc.toml")) + "ledger = \"off\"\n").string()});
  BOOST_TEST(holds(bare.out, "quality      not examined: no energy balance was kept"), bare.out);
}

// A default history has the same number of rows whatever the end.
BOOST_AUTO_TEST_CASE(another_end_keeps_the_rows_of_a_default_history) {
  const auto states = [](const std::string& out) {
    const std::string listing = talus::read_text(out + "/my.OUT");
    long count = 0;
    for (std::size_t at = listing.find("time = "); at != std::string::npos; at = listing.find("time = ", at + 1))
      ++count;
    return count;
  };
  for (const char* kind : {"scene", "fence"}) {
    const Folder folder;
    const std::string made = talus_ran({"new", kind}).out;
    std::string text;
    std::istringstream lines{made};
    for (std::string line; std::getline(lines, line);)
      if (!line.starts_with("interval")) text += line + '\n';
    const std::string file = folder.file("my.toml", text).string(), out = (folder.path / "out").string();
    const std::string usual = (folder.path / "usual").string();
    const std::string end = std::string_view{kind} == "scene" ? "6 s" : "2.4 s";
    BOOST_REQUIRE(talus_ran({"run", file, "--end", end, "--out", out}).code == 0);
    const std::string history = talus::read_text(out + "/history.csv");
    const auto rows = std::count(history.begin(), history.end(), '\n');
    BOOST_TEST(rows > 900);
    BOOST_TEST(rows < 1100);
    if (std::string_view{kind} == "scene") continue;
    // So has the listing of a fence.
    BOOST_REQUIRE(talus_ran({"run", file, "--out", usual}).code == 0);
    BOOST_TEST(states(out) == states(usual));
  }
}

// The history has a row each interval, whatever step is chosen; a longer step than the interval has one row a step.
BOOST_AUTO_TEST_CASE(a_chosen_step_is_at_most_the_interval) {
  const Folder folder;
  const auto rows = [&](const std::string& fields, const std::vector<std::string>& options) {
    const std::string text = talus::read_text(scene("rolling_disc.toml"));
    const std::string file = folder
                                 .file("short.toml", text.substr(0, text.find("[run]")) +
                                                         "[run]\nend = \"1 ms\"\ninterval = \"1 us\"\n" + fields)
                                 .string();
    std::vector<std::string> arguments{"run", file, "--out", folder.path / "out"};
    arguments.insert(arguments.end(), options.begin(), options.end());
    const Ended ended = talus_ran(arguments);
    BOOST_TEST(ended.code != 2, ended.err);
    const std::string history = talus::read_text(folder.path / "out/history.csv");
    return std::count(history.begin(), history.end(), '\n') - 2;  // without the header and the start
  };
  BOOST_TEST(rows("", {}) == 1000);
  BOOST_TEST(rows("integrator = \"velocity_verlet\"\nstep = \"auto\"\n", {}) == 1000);
  BOOST_TEST(rows("integrator = \"velocity_verlet\"\nstep = \"1 us\"\n", {"--step", "10 us"}) == 100);
}

// A scene without integrator and step has located events; its output interval is not used as the step of a method with
// fixed step.
BOOST_AUTO_TEST_CASE(another_integrator_keeps_the_tolerance_and_takes_a_step_of_its_own) {
  const Folder folder;
  const std::string text = talus::read_text(scene("rolling_disc.toml"));
  const std::string loose =
      folder.file("loose.toml", text + "integrator = \"stormer_cowell\"\ntolerance = 1e-5\n").string();
  const auto summary = [](const std::string& file, std::vector<std::string> more) {
    more.insert(more.begin(), {"run", file, "--json", "--end", "20 ms"});
    return nlohmann::json::parse(talus_ran(more).out);
  };
  const auto kept = summary(loose, {"--integrator", "odeint_dopri5"});
  // A tolerance of the command line replaces that of the scene.
  BOOST_TEST(summary(loose, {"--tolerance", "1e-10"}).at("evaluations").get<long>() >
             summary(loose, {}).at("evaluations").get<long>());
  BOOST_TEST(holds(kept.at("quality").at("step").get<std::string>(), "odeint_dopri5, tolerance 1e-05"));
  const auto own = summary(loose, {});
  const auto fixed = summary(loose, {"--integrator", "velocity_verlet"});
  const auto automatic = summary(loose, {"--integrator", "velocity_verlet", "--step", "auto"});
  BOOST_TEST(fixed.at("step") == automatic.at("step"));
  BOOST_TEST(fixed.at("step").get<double>() < 0.5 * own.at("step").get<double>());
}

// For a deck whose step of 1993 is too long, the first message is a single warning with the repair.
BOOST_AUTO_TEST_CASE(a_step_that_is_too_long_is_said_first_and_once) {
  const Ended ended = talus_ran({"run", scene("fence/sample2.DAT")});
  const std::string expected = "the linear limit of lagged_central_difference";
  BOOST_TEST(ended.err.starts_with("talus: warning: h omega = "), ended.err);
  const std::size_t first = ended.err.find(expected);
  BOOST_REQUIRE(first != std::string::npos);
  BOOST_TEST(ended.err.find(expected, first + 1) == std::string::npos, ended.err);
  BOOST_TEST(holds(ended.err, "`talus run " + scene("fence/sample2.DAT") + " --integrator auto`"));
}

// A particle between two pretensioned cables, with a step far beyond the linear limit, grows until it is no longer
// finite.
BOOST_AUTO_TEST_CASE(a_diverged_run_is_recorded) {
  const Folder folder;
  const std::string out = (folder.path / "run").string();
  const std::string scene_file = std::string{TALUS_TEST_SCENES} + "/unstable.toml";
  // Its step is beyond the linear limit: a warning before the run, and the run monitor ends it at once.
  const Ended watched = talus_ran({"run", scene_file, "--out", out});
  BOOST_TEST(watched.code == 3);
  BOOST_TEST(watched.err.rfind("talus: warning: h omega = ", 0) == 0U);
  // The reason is in the summary, once; a message after it names the time.
  BOOST_TEST(holds(watched.err, "\ntalus: the run diverged at t = 0 s; its summary gives the reason\n"));
  const std::string reason = "at t = 0 h omega = ";
  BOOST_TEST(holds(watched.out, "\n  quality      NOT USABLE: " + reason));
  BOOST_TEST(holds(watched.out, "\n  outcome      diverged at t = 0 s\n"));
  BOOST_TEST(watched.out.find(reason) == watched.out.rfind(reason));
  BOOST_TEST(!holds(watched.err, reason));
  // Without the run monitor it continues until numbers are no longer finite, and the limit is reported again as the
  // reason.
  const std::string alone = (folder.path / "alone.toml").string();
  std::ofstream{alone} << talus::read_text(scene_file) << "watch = { instability = \"off\", accuracy = \"off\" }\n";
  const Ended ended = talus_ran({"run", alone, "--out", out});
  BOOST_TEST(ended.code == 3);
  BOOST_TEST(holds(ended.out, "NOT USABLE: diverged at t = "));
  BOOST_TEST(holds(ended.err, "\ntalus: the run diverged at t = "));
  const auto summary = nlohmann::json::parse(talus::read_text(folder.path / "run" / "summary.json"));
  BOOST_TEST(summary.at("outcome").at("kind").get<std::string>() == "diverged");
  const std::string history = talus::read_text(folder.path / "run" / "history.csv");
  BOOST_TEST(std::count(history.begin(), history.end(), '\n') > 3);
  BOOST_TEST(!holds(history, "nan"));
  BOOST_TEST(!holds(history, "inf"));
}

BOOST_AUTO_TEST_CASE(a_step_of_its_own) {
  const Ended step = talus_ran({"run", scene("two_cable.toml"), "--step", "auto", "--end", "10 ms", "--json"});
  BOOST_TEST(step.code == 0);
  const double chosen = nlohmann::json::parse(step.out)["step"];
  BOOST_TEST(chosen > 0.0);
  const std::string step_text = nlohmann::json(chosen).dump() + " s";
  const Ended same = talus_ran({"run", scene("two_cable.toml"), "--step", step_text, "--end", "10 ms", "--json"});
  BOOST_TEST(same.out == step.out);
}

// The size of files is limited to 4096 bytes here; a state of the geometry needs more.
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

// The first lines state the result of a run; for a fence in the order of importance to an engineer.
BOOST_AUTO_TEST_CASE(a_summary_begins_with_the_verdict) {
  const Ended fence = talus_ran({"run", scene("fence/table_2.toml")});
  const std::vector<std::string> subjects{"\n  verdict      undecided at the end\n",
                                          "\n  rock         undecided",
                                          "\n  anchor       4.788e+04 lbf at t = 0.1986 s\n",
                                          "\n  cable        2.978e+05 lbf at t = 0.03025 s, top1: 0.3 % of its limit\n",
                                          "\n  hanger       9.711e+04 lbf at t = 0.03025 s, column1: no limit\n",
                                          "\n  quality      usable; energy balance within 0.072 %\n",
                                          "\n  outcome      finished",
                                          "\nfinal state\n"};
  std::size_t from = 0;
  for (const std::string& subject : subjects) {
    const std::size_t offset = fence.out.find(subject, from);
    BOOST_TEST_REQUIRE(offset != std::string::npos, subject << fence.out.substr(0, 1500));
    from = offset;
  }
  BOOST_TEST(holds(fence.out, "it still advances at 5.476 ft/s: a longer run decides"));
  const Ended cables = talus_ran({"run", scene("two_cable.toml")});
  BOOST_TEST(holds(cables.out, "  last contact impact, ended at t = 0.02628 s\n"));
  BOOST_TEST(holds(cables.out, "  quality      usable; energy balance within 0.018 %\n"));
  const Ended apart = talus_ran({"run", scene("two_cable.toml"), "--end", "1 ms"});
  BOOST_TEST(holds(apart.out, "  last contact impact, still touching at t = 0.001 s\n"));
  BOOST_TEST(holds(talus_ran({"run", scene("damped_disc.toml"), "--end", "100 us"}).out,
                   "  last contact none: nothing touched; closest was bounce with a gap of 0.5 m\n"));
}

// Three discs that fall through the floor: the results are usable, and say so. A resumed run keeps the pairs.
BOOST_AUTO_TEST_CASE(bodies_without_a_contact_are_named_with_the_quality) {
  const Folder folder;
  const std::string file = (folder.path / "fall.toml").string(), out = (folder.path / "run").string();
  std::string text =
      "units = \"SI\"\ngravity = [\"0 m/s^2\", \"-10 m/s^2\"]\n[run]\nend = \"1 s\"\n[[body]]\nname = \"floor\"\n"
      "mobility = \"fixed\"\nshape = { kind = \"half_plane\" }\nposition = [\"0 m\", \"0 m\"]\n";
  for (const int i : {1, 2, 3})
    text += fmt::format(
        "[[body]]\nname = \"disc{0}\"\nmobility = \"particle\"\nmass = \"1 kg\"\nshape = {{ kind = \"circle\", radius "
        "= "
        "\"0.1 m\" }}\nposition = [\"{0} m\", \"{0} m\"]\n",
        i);
  std::ofstream{file} << text;
  const auto pairs = [&] {
    return nlohmann::json::parse(talus::read_text(out + "/summary.json"))["quality"]["undeclared_overlaps"].dump();
  };
  const Ended whole = talus_ran({"run", file, "--out", out});
  BOOST_TEST(whole.code == 0);
  BOOST_TEST(holds(whole.out, "  quality      usable; "));
  BOOST_TEST(holds(whole.out, "  no contact   'floor' and 'disc1' passed through each other, and 2 other pairs\n"));
  BOOST_TEST(pairs() == R"([["floor","disc1"],["floor","disc2"],["floor","disc3"]])");
  BOOST_TEST(talus_ran({"run", file, "--out", out, "--until", "0.7 s"}).code == 0);
  BOOST_TEST(pairs() == R"([["floor","disc1"],["floor","disc2"]])");
  BOOST_TEST(talus_ran({"run", "--resume", out}).code == 0);
  BOOST_TEST(pairs() == R"([["floor","disc1"],["floor","disc2"],["floor","disc3"]])");
}

// Unusable results have an exit status, also from --resume; the files are written. The scene may accept
// them.
BOOST_AUTO_TEST_CASE(unusable_results_have_an_exit_code) {
  const Folder folder;
  const std::string out = (folder.path / "run").string();
  const std::vector<std::string> step{"--step", "2 ms", "--out", out};
  const auto ran = [&](const std::string& file) {
    std::vector<std::string> command{"run", file};
    command.insert(command.end(), step.begin(), step.end());
    return talus_ran(command);
  };
  const Ended ended = ran(scene("two_cable.toml"));
  BOOST_TEST(ended.code == 7);
  BOOST_TEST(holds(ended.out, "  quality      NOT USABLE: the energy balance is off by 1.61 %"));
  const auto quality = [&] { return nlohmann::json::parse(talus::read_text(out + "/summary.json")).at("quality"); };
  BOOST_TEST(!quality().at("usable").get<bool>());
  BOOST_TEST(quality().at("enforced").get<bool>());
  BOOST_TEST(fs::exists(out + "/history.csv"));
  BOOST_TEST(talus_ran({"run", "--resume", out}).code == 7);
  const std::string accepting =
      folder.file("accepting.toml", talus::read_text(scene("two_cable.toml")) + "watch = { quality = \"warning\" }\n")
          .string();
  const Ended accepted = ran(accepting);
  BOOST_TEST(accepted.code == 0);
  BOOST_TEST(holds(accepted.out, "  quality      NOT USABLE: the energy balance is off by 1.61 %"));
  BOOST_TEST(!quality().at("usable").get<bool>());
  BOOST_TEST(!quality().at("enforced").get<bool>());
  BOOST_TEST(talus_ran({"run", "--resume", out}).code == 0);
  // An interrupted run is not judged.
  std::vector<std::string> half{"run", scene("two_cable.toml"), "--until", "1.5 s"};
  half.insert(half.end(), step.begin(), step.end());
  BOOST_TEST(talus_ran(half).code == 0);
  BOOST_TEST(talus_ran({"run", "--resume", out}).code == 7);
}

BOOST_AUTO_TEST_CASE(a_run_whose_balance_fails_is_not_usable_and_a_repair_is_tried) {
  const Folder folder;
  const std::string out = (folder.path / "run").string();
  const Ended ended = talus_ran({"run", scene("fence/appendix_two_layers.toml"), "--out", out});
  BOOST_TEST(ended.code == 0);
  BOOST_TEST(holds(ended.out, "  quality      NOT USABLE: the energy balance is off by 2.54 % of the largest energy"));
  BOOST_TEST(holds(ended.out, "  repair       --integrator auto was tried and repairs it: "));
  const auto summary = nlohmann::json::parse(talus::read_text(out + "/summary.json"));
  BOOST_TEST(!summary.at("quality").at("usable").get<bool>());
  BOOST_TEST(summary.at("quality").at("repair").at("flaw").get<std::string>().empty());
  // The command of the repair gives the result that the repair announced.
  const auto repaired = nlohmann::json::parse(
      talus_ran({"run", scene("fence/appendix_two_layers.toml"), "--integrator", "auto", "--json"}).out);
  BOOST_TEST(repaired.at("quality").at("usable").get<bool>());
  BOOST_TEST(repaired.at("quality").at("energy_balance").get<double>() ==
             summary.at("quality").at("repair").at("energy_balance").get<double>());
  BOOST_TEST(repaired.at("verdict").at("fence").get<std::string>() ==
             summary.at("quality").at("repair").at("verdict").get<std::string>());
  // The warning about the step comes first, and once.
  BOOST_TEST(ended.err.rfind("talus: warning: h omega = ", 0) == 0U);
  BOOST_TEST(holds(ended.err, "`talus run " + scene("fence/appendix_two_layers.toml") +
                                  " --integrator auto` chooses its own steps\n"));
  BOOST_TEST(ended.err.find("h omega") == ended.err.rfind("h omega"));
}

BOOST_AUTO_TEST_CASE(a_run_into_the_folder_of_another_leaves_nothing_of_that) {
  const Folder folder;
  const fs::path out = folder.path / "run";
  BOOST_TEST(
      talus_ran({"run", scene("fence/sample2.DAT"), "--end", "5 ms", "--sheet", "--impacts", "--out", out.string()})
          .code == 0);
  fs::create_directories(out / "plots");
  std::ofstream{out / "plots" / "rock.x.svg"} << "old";
  std::ofstream{out / "notes.txt"} << "mine";
  std::ofstream{out / "plots" / "notes.txt"} << "mine";
  for (const char* name : {"sheet.pdf", "sheet.html", "sheet.json", "impacts.csv", "sample2.pvd", "sample2.OUT"})
    BOOST_TEST(fs::exists(out / name), name);
  BOOST_TEST(talus_ran({"run", scene("two_cable.toml"), "--end", "5 ms", "--out", out.string()}).code == 0);
  const Folder fresh;
  BOOST_TEST(
      talus_ran({"run", scene("two_cable.toml"), "--end", "5 ms", "--out", (fresh.path / "run").string()}).code == 0);
  auto left = files(out);
  BOOST_TEST(left.erase("notes.txt") == 1U);
  BOOST_TEST(left.erase("plots/notes.txt") == 1U);
  BOOST_TEST((left == files(fresh.path / "run")));
}

BOOST_AUTO_TEST_SUITE_END()
