/// Runs that are stopped and resumed by the built program, their files compared byte for byte with those of an
/// uninterrupted run; and refused requests.
#include <sys/wait.h>

#include <boost/test/unit_test.hpp>
#include <chrono>
#include <csignal>
#include <fstream>
#include <nlohmann/json.hpp>
#include <thread>

#include "solver/integrate/integrator_list.hpp"
#include "tests/solver/app/program.hpp"

BOOST_AUTO_TEST_SUITE(resume_tests)

namespace {

/// Steps of some runs are too long for usable results (7).
void runs(std::vector<std::string> arguments) {
  const Ended ended = talus_ran(std::move(arguments));
  BOOST_TEST_REQUIRE((ended.code == 0 || ended.code == 7), ended.err);
}

/// Compares a run of `command` to its end with the same run stopped in one folder, resumed in another, stopped, and
/// resumed there.
void stops_and_goes_on(std::vector<std::string> command, const std::string& first, const std::string& second) {
  const Folder folder;
  const auto in = [&](const char* name) { return (folder.path / name).string(); };
  const auto with = [&](std::vector<std::string> more) {
    more.insert(more.begin(), command.begin(), command.end());
    return more;
  };
  runs(with({"--out", in("whole")}));
  runs(with({"--out", in("stopped"), "--until", first}));
  BOOST_TEST(fs::exists(folder.path / "stopped/checkpoint.json"));
  const auto before = files(folder.path / "stopped");
  runs({"run", "--resume", in("stopped"), "--out", in("on"), "--until", second});
  BOOST_TEST((files(folder.path / "stopped") == before));
  // An uninterrupted run to the same step writes the same files, including the checkpoint.
  runs(with({"--out", in("straight"), "--until", second}));
  same_files(in("on"), in("straight"));
  runs({"run", "--resume", in("on")});
  same_files(in("on"), in("whole"));
}

}  // namespace

BOOST_AUTO_TEST_CASE(every_integrator_goes_on_to_the_same_files) {
  for (const std::string& integrator : talus::integrator_names()) {
    BOOST_TEST_CONTEXT(integrator) {
      // The run monitor would end undamped runs of methods whose amplitudes grow.
      const talus::IntegratorTraits& traits = talus::integrator_traits(integrator);
      const bool damped = traits.step_control == talus::StepControl::closed_form || traits.amplitude_growth_rate > 0.0;
      const char* file = damped ? "damped_disc.toml" : "two_cable.toml";
      std::vector<std::string> command{"run",   scene(file),    "--step",   "1 ms",     "--end",
                                       "0.4 s", "--integrator", integrator, "--frames", "7"};
      if (talus::needs_tolerance(integrator)) command.insert(command.end(), {"--tolerance", "1e-9"});
      // 7 ms: during the contact, not a multiple of the history's interval; 0.4 s: the plan's last step.
      stops_and_goes_on(command, "7 ms", "0.1234 s");
      stops_and_goes_on(command, "1 ms", "0.4 s");
    }
  }
}

BOOST_AUTO_TEST_CASE(why_auto_chose_is_still_said_at_the_end) {
  stops_and_goes_on({"run", scene("damped_disc.toml"), "--integrator", "auto", "--tolerance", "1e-9"}, "7 ms", "0.1 s");
  const Folder folder;
  const std::string out = (folder.path / "run").string();
  runs({"run", scene("damped_disc.toml"), "--integrator", "auto", "--tolerance", "1e-9", "--out", out});
  BOOST_TEST(!nlohmann::json::parse(talus::read_text(out + "/summary.json")).at("integrator_reason").empty());
}

BOOST_AUTO_TEST_CASE(a_fence_goes_on_to_the_same_listing_histories_and_geometry) {
  for (const char* file : {"fence/sample2.DAT", "fence/sample2.toml"})
    stops_and_goes_on({"run", scene(file), "--end", "20 ms"}, "5 ms", "11.1 ms");
}

BOOST_AUTO_TEST_CASE(another_end_and_step_keep_their_rows) {
  // Without an interval in the scene it follows from the end, and is at least the step.
  stops_and_goes_on({"run", scene("pendulum.toml"), "--end", "30 s"}, "3 s", "11 s");
  stops_and_goes_on({"run", scene("pendulum.toml"), "--end", "30 s", "--step", "40 ms"}, "3 s", "11 s");
  stops_and_goes_on({"run", scene("fence/table_2.toml"), "--end", "0.3 s"}, "0.1 s", "0.2 s");
}

BOOST_AUTO_TEST_CASE(a_sheet_sums_up_the_whole_run) {
  stops_and_goes_on({"run", scene("fence/sample2.DAT"), "--end", "10 ms", "--sheet"}, "3 ms", "6 ms");
}

BOOST_AUTO_TEST_CASE(a_table_of_impacts_continues) {
  // The first contact lasts from 6 to 9 ms.
  stops_and_goes_on({"run", scene("damped_disc.toml"), "--step", "1 ms", "--end", "0.4 s", "--impacts"}, "7 ms",
                    "0.1234 s");
  // Several contacts at once, by boundary nodes.
  stops_and_goes_on({"run", scene("fence/sample2.DAT"), "--end", "20 ms", "--impacts"}, "11 ms", "16 ms");
}

BOOST_AUTO_TEST_CASE(tables_of_impacts_that_cannot_be) {
  const Folder folder;
  const std::string out = (folder.path / "out").string();
  BOOST_TEST(talus_ran({"run", scene("two_cable.toml"), "--impacts"}).err ==
             "talus: --impacts: it requires --out, the folder in which impacts.csv is written\n");
  runs({"run", scene("two_cable.toml"), "--until", "1 ms", "--out", out});
  BOOST_TEST(talus_ran({"run", "--resume", out, "--impacts"}).err ==
             "talus: --impacts: a resumed run (--resume) keeps the options of its start\n");
  runs({"run", "--resume", out});
  BOOST_TEST(!fs::exists(out + "/impacts.csv"));
}

BOOST_AUTO_TEST_CASE(sheets_that_cannot_be) {
  const Folder folder;
  const std::string out = (folder.path / "out").string();
  const std::string requirement = "talus: --sheet: it requires a fence (a deck or a scene with [fence]) and --out\n";
  BOOST_TEST(talus_ran({"run", scene("two_cable.toml"), "--sheet", "--out", out}).err == requirement);
  BOOST_TEST(talus_ran({"run", scene("fence/sample2.DAT"), "--sheet"}).err == requirement);
  BOOST_TEST(!fs::exists(out));
  runs({"run", scene("fence/sample2.DAT"), "--until", "1 ms", "--out", out});
  BOOST_TEST(talus_ran({"run", "--resume", out, "--sheet"}).err ==
             "talus: --sheet: a resumed run (--resume) keeps the options of its start\n");
}

BOOST_AUTO_TEST_CASE(json_says_how_to_go_on) {
  const Folder folder;
  const std::string out = (folder.path / "out").string();
  const std::vector<std::string> command{"run", scene("two_cable.toml"), "--end", "20 ms", "--out", out, "--json"};
  std::vector<std::string> left = command;
  left.insert(left.end(), {"--until", "10 ms"});
  const auto summary = nlohmann::json::parse(talus_ran(left).out);
  BOOST_TEST(summary.at("resume").get<std::string>() == "talus run --resume " + out);
  BOOST_TEST(!nlohmann::json::parse(talus_ran({"run", "--resume", out, "--json"}).out).contains("resume"));
  BOOST_TEST(!nlohmann::json::parse(talus_ran(command).out).contains("resume"));
}

BOOST_AUTO_TEST_CASE(a_run_that_has_ended_is_not_resumed) {
  const Folder folder;
  const std::string out = (folder.path / "out").string();
  const Ended run = talus_ran({"run", scene("two_cable.toml"), "--end", "20 ms", "--out", out, "--json"});
  const auto before = files(out);
  const Ended again = talus_ran({"run", "--resume", out});
  BOOST_TEST(again.code == 0);
  BOOST_TEST(again.out == out + ": the run is finished; there is nothing to resume\n");
  BOOST_TEST(again.err == "");
  BOOST_TEST(talus_ran({"run", "--resume", out, "--json"}).out == run.out);
  const Ended longer = talus_ran({"run", "--resume", out, "--until", "30 ms"});
  BOOST_TEST(longer.code == 2);
  BOOST_TEST(longer.err ==
             "talus: --until: the run in " + out + " has ended; only an interrupted run can be resumed\n");
  BOOST_TEST((files(out) == before));

  const std::string lost = (folder.path / "lost").string();
  BOOST_TEST(talus_ran({"run", (fs::path{TALUS_TEST_SCENES} / "unstable.toml").string(), "--out", lost}).code == 3);
  const Ended diverged = talus_ran({"run", "--resume", lost});
  BOOST_TEST(diverged.code == 3);
  BOOST_TEST(diverged.err.rfind("talus: " + lost + ": the run diverged and cannot be resumed: ", 0) == 0U,
             diverged.err);
  const std::string summary = talus::read_text(lost + "/summary.json");
  std::ofstream{lost + "/summary.json"} << replaced(replaced(summary, "\"schema\": 2", "\"schema\": 1"),
                                                    "\"message\": ", "\"words\": ");
  BOOST_TEST(talus_ran({"run", "--resume", lost}).err == diverged.err);
}

BOOST_AUTO_TEST_CASE(wrong_orders) {
  const Folder folder;
  const std::string out = (folder.path / "out").string();
  const std::string two = scene("two_cable.toml");
  runs({"run", two, "--until", "10 ms", "--out", out});
  const auto before = files(out);
  const std::vector<std::pair<std::vector<std::string>, std::string>> wrong{
      {{"run", two, "--until", "1 s"}, "--until: it requires --out, the folder in which the run is saved"},
      {{"run", two, "--until", "1", "--out", out}, "--until: found \"1\"; the unit is missing; write e.g. \"1 s\""},
      {{"run", two, "--until", "0 s", "--out", out}, "--until: found \"0 s\"; it must be > 0"},
      {{"run", two, "--until", "3.1 s", "--out", out},
       "--until: found \"3.1 s\"; it must be at most 3 s, where the run ends"},
      {{"run", two, "--until", "1e300 s", "--out", out},
       "--until: found \"1e300 s\"; it must be at most 3 s, where the run ends"},
      {{"run", "--resume", out, "--until", "10 ms"},
       "--until: found \"10 ms\"; it must be beyond 0.01 s, the current time of the run"},
      {{"run", "--resume", out, "--until", "4 s"},
       "--until: found \"4 s\"; it must be at most 3 s, where the run ends"},
      {{"run", "--resume", out, "--step", "1 ms"}, "--step: a resumed run (--resume) keeps the options of its start"},
      {{"run", "--resume", out, "--end", "9 s"}, "--end: a resumed run (--resume) keeps the options of its start"},
      {{"run", "--resume", out, "--frames", "5"}, "--frames: a resumed run (--resume) keeps the options of its start"},
      {{"run", "--resume", out, "--tolerance", "1e-6"},
       "--tolerance: a resumed run (--resume) keeps the options of its start"},
      {{"run", "--resume", out, "--integrator", "rk4"},
       "--integrator: a resumed run (--resume) keeps the options of its start"}};
  for (const auto& [arguments, message] : wrong) {
    const Ended ended = talus_ran(arguments);
    BOOST_TEST(ended.code == 2);
    BOOST_TEST(ended.err == "talus: " + message + "\n");
    BOOST_TEST((files(out) == before), "a wrong order changed the folder");
  }
  const Ended none = talus_ran({"run", "--resume", (folder.path / "none").string()});
  BOOST_TEST(none.code == 4);
  BOOST_TEST(none.err == "talus: " + (folder.path / "none").string() +
                             ": found no folder of this name; it must be that of an interrupted run, which "
                             "`talus run --out` writes\n");
}

BOOST_AUTO_TEST_CASE(checkpoints_that_are_refused) {
  const Folder folder;
  const fs::path file = folder.path / "checkpoint.json";
  runs({"run", scene("two_cable.toml"), "--until", "10 ms", "--out", folder.path.string()});
  const std::string good = talus::read_text(file);
  const std::string prefix = "talus: " + file.string() + ": ";
  const std::string hash = good.substr(good.rfind(": \"") + 3, 16);
  const std::string remedy =
      "it must be 4: resume the run with the version of talus that wrote it, or run the scene again\n";
  const std::vector<std::pair<std::string, std::string>> wrong{
      {replaced(good, "\"schema\": 4", "\"schema\": 3"), "schema: found 3; " + remedy},
      {replaced(good, "\"schema\": 4,\n", ""), "schema: found nothing; " + remedy},
      {replaced(good, "\"talus\": \"", "\"talus\": \"9"), "talus: found \"9"},
      {replaced(good, "\"steps\": 500", "\"steps\": 501"), "fnv1a: found \"" + hash + "\"; it must be \""},
      {good.substr(0, good.size() / 2),
       "parse error at line " + std::to_string(1 + std::count(good.begin(), good.begin() + good.size() / 2, '\n')) +
           ","},
      {"[]", "found array instead of an object; it must be a checkpoint that talus wrote, whole"},
      {"", "parse error at line 1, column 1: "}};
  for (const auto& [text, message] : wrong) {
    std::ofstream{file} << text;
    const Ended ended = talus_ran({"run", "--resume", folder.path.string()});
    BOOST_TEST(ended.code == 2);
    BOOST_TEST(ended.err.rfind(prefix + message, 0) == 0U, ended.err);
  }
}

BOOST_AUTO_TEST_CASE(files_of_others_stay) {
  const Folder folder;
  runs({"run", scene("fence/sample2.DAT"), "--until", "5 ms", "--end", "10 ms", "--out", folder.path.string()});
  const fs::path geometry = folder.path / "sample2_geometry";
  std::ofstream{geometry / "view.pvsm"} << "state of ParaView";
  std::ofstream{geometry / "sample2_99999999.vtp"} << "of a run that was killed";
  runs({"run", "--resume", folder.path.string()});
  BOOST_TEST(fs::exists(geometry / "view.pvsm"));
  BOOST_TEST(!fs::exists(geometry / "sample2_99999999.vtp"));
}

BOOST_AUTO_TEST_CASE(geometry_that_is_gone_is_missed) {
  const Folder folder;
  runs({"run", scene("fence/sample2.DAT"), "--until", "5 ms", "--out", folder.path.string()});
  const fs::path lost = folder.path / "sample2_geometry/sample2_00000060.vtp";
  fs::remove(lost);
  const Ended ended = talus_ran({"run", "--resume", folder.path.string()});
  BOOST_TEST(ended.code == 4);
  BOOST_TEST(ended.err == "talus: " + lost.string() + ": No such file or directory\n");
}

// A run killed by SIGKILL is resumed from the checkpoint of the last second.
BOOST_AUTO_TEST_CASE(a_run_that_is_killed_loses_a_second) {
  for (const auto& [file, end] : {std::pair{"two_cable.toml", "2000 s"}, {"fence/table_2.toml", "100 s"}}) {
    const Folder folder;
    const std::string out = (folder.path / "out").string(), straight = (folder.path / "straight").string();
    const std::string path = scene(file);
    StartedProgram program{TALUS_EXECUTABLE, {"run", path, "--end", end, "--out", out}};
    while (!fs::exists(out + "/checkpoint.json"))
      std::this_thread::sleep_for(std::chrono::milliseconds{10});
    std::this_thread::sleep_for(std::chrono::milliseconds{300});
    program.send(SIGKILL);
    BOOST_REQUIRE(WIFSIGNALED(program.wait()));
    const auto kept = nlohmann::json::parse(talus::read_text(out + "/checkpoint.json"));
    const double later = (kept.at("steps").get<double>() + 1000.5) * kept.at("step").get<double>();
    const std::string until = std::to_string(later) + " s";
    runs({"run", "--resume", out, "--until", until});
    runs({"run", path, "--end", end, "--until", until, "--out", straight});
    same_files(out, straight);
  }
}

BOOST_AUTO_TEST_SUITE_END()
