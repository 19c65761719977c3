#include <csignal>

#include <algorithm>
#include <boost/test/unit_test.hpp>
#include <chrono>
#include <cstdlib>
#include <nlohmann/json.hpp>
#include <string>
#include <thread>
#include <tuple>

#include "tests/solver/app/program.hpp"
#include "tests/temporary_folder.hpp"

BOOST_AUTO_TEST_SUITE(sweep_tests)

// `talus sweep run` that is killed or interrupted at any time, started again.

namespace {

/// Plans a sweep of short runs, and after them one of an hour for each of `threads`.
void plan_long(const Folder& folder, const std::string& out, std::size_t short_runs = 0, int threads = 1) {
  std::string steps;
  for (std::size_t i = 0; i < short_runs; ++i)
    steps += "\"0.1 ms\", ";
  for (int i = 0; i < threads; ++i)
    steps += "\"1e-10 s\", ";
  const std::string file =
      folder
          .file("long.toml", "base = \"" + scene("two_cable.toml") +
                                 "\"\noutputs = [\"particle.x.max\"]\n[[axis]]\nfield = \"run.step\"\n"
                                 "values = [" +
                                 steps +
                                 "]\n[[axis]]\nfield = \"run.integrator\"\nvalues = "
                                 "[\"velocity_verlet\"]\n")
          .string();
  BOOST_REQUIRE(talus_ran({"sweep", "plan", file, "--out", out}).code == 0);
}

/// Waits until a run has made its file of results, which is after it catches signals.
void wait_for_start(const std::string& out) {
  while (fs::is_empty(out + "/results"))
    std::this_thread::sleep_for(std::chrono::milliseconds{5});
}

/// Number of the runs that are done.
std::size_t done(const std::string& out) {
  const auto status = nlohmann::json::parse(talus_ran({"sweep", "status", out, "--json"}).out);
  return status.at("runs").get<std::size_t>() - status.at("missing").get<std::size_t>();
}

/// Waits until the folder has `count` results. Returns whether it has before the program ended, and within a minute.
bool wait_for_results(StartedProgram& program, const std::string& out, std::size_t count) {
  const auto start = std::chrono::steady_clock::now();
  for (bool runs = true; runs && std::chrono::steady_clock::now() - start < std::chrono::minutes{1};) {
    runs = program.is_running();
    std::size_t lines = 0;
    for (const auto& [name, text] : files(out + "/results"))
      lines += static_cast<std::size_t>(std::ranges::count(text, '\n'));
    if (lines >= count) return runs;
    std::this_thread::sleep_for(std::chrono::milliseconds{1});
  }
  return false;
}

constexpr int run_count = 120;

std::string planned(const Folder& folder, const std::string& name) {
  const std::string file =
      folder
          .file("rebounds.toml",
                "base = \"" + scene("fence/table_2.toml") +
                    "\"\noutputs = [\"rock.vx.end\", \"energy.kinetic.max\"]\n[[axis]]\nfield = "
                    "\"fence.steps\"\nvalues = "
                    "[2000]\n[[axis]]\nfield = \"fence.step_factor\"\nvalues = [0.17]\n[[axis]]\nfield = "
                    "\"fence.rock[0].velocity[0]\"\nrange = [\"20 ft/s\", \"90 ft/s\"]\ncount = " +
                    std::to_string(run_count) + "\n")
          .string();
  const std::string out = (folder.path / name).string();
  BOOST_REQUIRE(talus_ran({"sweep", "plan", file, "--out", out}).code == 0);
  return out;
}

std::string collected(const std::string& out) {
  const Ended ended = talus_ran({"sweep", "collect", out});
  BOOST_TEST(ended.code == 0, ended.err);
  return talus::read_text(out + "/results.csv") + talus::read_text(out + "/results.json");
}

}  // namespace

BOOST_AUTO_TEST_CASE(a_sweep_that_is_killed_continues_to_the_same_bytes) {
  const Folder folder;
  const std::string whole = planned(folder, "whole"), cut = planned(folder, "cut");
  BOOST_REQUIRE(talus_ran({"sweep", "run", whole, "--threads", "2"}).code == 0);
  std::size_t results = 0;
  for (int kill = 0; kill < 4; ++kill) {
    StartedProgram program{TALUS_EXECUTABLE, {"sweep", "run", cut, "--threads", "2"}};
    // Results are in the folder while it runs, and remain.
    BOOST_TEST_REQUIRE(wait_for_results(program, cut, results + 1), "killed " << kill << " times");
    program.send(SIGKILL);
    program.wait();
    const std::size_t kept = done(cut);
    BOOST_TEST(kept > results);
    results = kept;
  }
  BOOST_TEST(results < run_count);
  const Ended last = talus_ran({"sweep", "run", cut});
  BOOST_TEST(last.code == 0, last.err);
  BOOST_TEST(last.out == "120 of 120 runs done: 120 finished\n");
  BOOST_TEST((collected(cut) == collected(whole)));
}

BOOST_AUTO_TEST_CASE(a_signal_loses_the_runs_in_flight_alone) {
  const Folder folder;
  constexpr std::size_t short_runs = 41;
  for (const int signal : {SIGINT, SIGTERM, SIGKILL}) {
    const std::string out = (folder.path / std::to_string(signal)).string();
    plan_long(folder, out, short_runs, 2);
    StartedProgram program{TALUS_EXECUTABLE, {"sweep", "run", out, "--threads", "2"}};
    // All others are done as soon as both threads have a long run.
    BOOST_TEST_REQUIRE(wait_for_results(program, out, short_runs));
    program.send(signal);
    program.wait();
    BOOST_TEST(done(out) == short_runs);
  }
}

BOOST_AUTO_TEST_CASE(a_signal_ends_it_without_the_runs_in_flight) {
  const Folder folder;
  for (const int signal : {SIGINT, SIGTERM}) {
    const std::string out = (folder.path / std::to_string(signal)).string();
    plan_long(folder, out);
    StartedProgram program{TALUS_EXECUTABLE, {"sweep", "run", out, "--threads", "1"}};
    wait_for_start(out);
    program.send(signal);
    BOOST_TEST(program.exit_code() == 128 + signal);
    BOOST_TEST(talus_ran({"sweep", "status", out}).out == "0 of 1 runs done: 0 finished\n");
  }
}

BOOST_AUTO_TEST_CASE(a_signal_ends_the_engine_and_its_parts) {
  const Folder folder;
  // In place of GNU parallel: one part, which begins to end at the second signal.
  const fs::path engine =
      folder.file("parallel",
                  "#!/bin/sh\nwhile [ \"$1\" != /bin/sh ]; do shift; done\neval \"/bin/sh $2 1 &\"\n"
                  "trap 'trap \"kill $!\" TERM' TERM\nwait; wait; wait\n");
  fs::permissions(engine, fs::perms::owner_all);
  const std::string path = folder.path.string() + ":" + std::getenv("PATH");
  for (const int signal : {SIGINT, SIGTERM}) {
    const std::string out = (folder.path / std::to_string(signal)).string();
    plan_long(folder, out);
    const fs::path err = folder.path / ("err" + std::to_string(signal));
    StartedProgram program{
        TALUS_EXECUTABLE, {"sweep", "submit", out, "--engine", "parallel"}, {.err = err}, {{"PATH", path}}};
    wait_for_start(out);
    program.send(signal);
    BOOST_TEST(program.exit_code() == 128 + signal);
    BOOST_TEST(holds(talus::read_text(err), "parallel was ended; the same command continues"), talus::read_text(err));
    // Its part has ended, too: the lock of its folder is free, and there is no result.
    BOOST_TEST(talus_ran({"sweep", "status", out}).out == "0 of 1 runs done: 0 finished\n");
    StartedProgram again{TALUS_EXECUTABLE, {"sweep", "run", out}, {.err = folder.path / "again"}};
    std::this_thread::sleep_for(std::chrono::milliseconds{300});
    again.send(SIGTERM);
    BOOST_TEST(again.exit_code() == 128 + SIGTERM);
  }
}

BOOST_AUTO_TEST_CASE(results_of_runs_that_have_another_one_are_counted) {
  const Folder folder;
  const std::string out = planned(folder, "out");
  BOOST_REQUIRE(talus_ran({"sweep", "run", out}).code == 0);
  const fs::path results = fs::directory_iterator { out + "/results" } -> path();
  fs::copy_file(results, out + "/results/copy.jsonl");
  const std::string expected = "120 of 120 runs done: 120 finished\n120 results of runs that have another one\n";
  BOOST_TEST(talus_ran({"sweep", "run", out}).out == expected);
  BOOST_TEST(talus_ran({"sweep", "status", out}).out == expected);
}

BOOST_AUTO_TEST_CASE(a_missing_engine_names_its_packages) {
  const Folder folder;
  const std::string out = planned(folder, "out");
  for (const auto& [engine, program, package] :
       {std::tuple{"slurm", "sbatch", "slurm-client"}, std::tuple{"parallel", "parallel", "parallel"}}) {
    const Ended ended = ran(TALUS_EXECUTABLE, {"sweep", "submit", out, "--engine", engine}, "", "/none");
    BOOST_TEST(ended.code == 4);
    BOOST_TEST(holds(ended.err, std::string{program} + ": cannot be started"), ended.err);
    BOOST_TEST(holds(ended.err, std::string{"Debian's packages: "} + package + "; scripts/setup --engines installs it"),
               ended.err);
  }
}

BOOST_AUTO_TEST_CASE(a_folder_may_end_with_a_slash) {
  const Folder folder;
  const std::string out = planned(folder, "out") + "/";
  const Ended again = talus_ran({"sweep", "plan", (folder.path / "rebounds.toml").string(), "--out", out});
  BOOST_TEST(holds(again.out, "written: " + out + "sweep.json, base.toml"), again.out);
}

BOOST_AUTO_TEST_CASE(a_part_runs_once_at_a_time) {
  const Folder folder;
  const std::string out = planned(folder, "out");
  StartedProgram first{TALUS_EXECUTABLE, {"sweep", "run", out, "--threads", "1"}};
  while (fs::is_empty(out + "/results"))
    std::this_thread::sleep_for(std::chrono::milliseconds{1});
  const Ended second = talus_ran({"sweep", "run", out}), half = talus_ran({"sweep", "run", out, "--shard", "1/2"});
  BOOST_TEST(second.code == 4);
  BOOST_TEST(holds(second.err, "is writing into it"), second.err);
  BOOST_TEST(half.code == 4);
  BOOST_TEST(
      holds(half.err, "part 1-of-1 of another division runs, which has some of the same runs; it must end first"),
      half.err);
  BOOST_TEST(first.exit_code() == 0);
  BOOST_TEST(talus_ran({"sweep", "collect", out}).code == 0);
}

BOOST_AUTO_TEST_CASE(a_part_whose_folder_cannot_be_opened_does_not_count_as_running) {
  const Folder folder;
  const std::string out = planned(folder, "out");
  fs::create_directories(out + "/parts/1-of-2");
  // It can open two files, for the lock of its part and the list of parts. Permissions do not apply to root.
  const Ended ended =
      ran("/bin/sh", {"-c", "exec 3>&- 4>&-; ulimit -n 5; exec \"$0\" sweep run \"$1\"", TALUS_EXECUTABLE, out});
  BOOST_TEST(ended.code == 4);
  BOOST_TEST(ended.err == "talus: " + out + "/parts/1-of-2: Too many open files\n");
}

// With a limit of the processor time (ulimit -t) its clock advances in ticks of some milliseconds.
BOOST_AUTO_TEST_CASE(a_plan_estimates_the_time_of_runs_shorter_than_a_tick) {
  const Folder folder;
  const std::string file = folder.file("short.toml", "base = \"" + scene("two_cable.toml") +
                                                         "\"\noutputs = [\"particle.x.max\"]\n[[axis]]\n"
                                                         "field = \"run.end\"\nvalues = [\"1 ms\", \"2 ms\"]\n");
  const Ended ended = ran("/bin/sh", {"-c", "ulimit -t 600; exec \"$0\" sweep plan \"$1\" --out \"$2\" --json",
                                      TALUS_EXECUTABLE, file, (folder.path / "out").string()});
  BOOST_TEST_REQUIRE(ended.code == 0, ended.err);
  BOOST_TEST(nlohmann::json::parse(ended.out).at("processor_time").get<double>() > 0.0);
}

BOOST_AUTO_TEST_SUITE_END()
