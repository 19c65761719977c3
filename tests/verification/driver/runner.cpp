// Cases that misbehave in each known way, from the command line of the driver to its exit status.
#include <sys/fsuid.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <boost/test/unit_test.hpp>
#include <chrono>
#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <limits>
#include <nlohmann/json.hpp>
#include <stdexcept>
#include <string>
#include <thread>
#include <vector>

#include "tests/temporary_folder.hpp"
#include "tests/verification/driver/driver_run.hpp"
#include "tests/verification/driver/synthetic_cases.hpp"

BOOST_AUTO_TEST_SUITE(runner_tests)

using namespace talus::verification;
namespace fs = std::filesystem;
namespace utf = boost::unit_test;
using nlohmann::json;

namespace {

/// Whether memory can be limited: the address sanitizer itself reserves terabytes of addresses, and ends a process
/// whose allocation is refused; a process that counts its lines needs memory at its end.
#if defined(__SANITIZE_ADDRESS__) || defined(TALUS_COUNTED_LINES)
constexpr bool limits_memory = false;
#else
constexpr bool limits_memory = true;
#endif

/// Checks one misbehaving case: exit status 1, its status, and text of its message; the sound case beside it still
/// passes.
void demand_failure(const Case& bad, const std::string& status, const std::string& expected) {
  const Run run({bad, synthetic("sound", sound)});
  BOOST_TEST_CONTEXT(bad.id) {
    BOOST_TEST(run.status == 1);
    BOOST_TEST(run.results.at("verdict") == "fail");
    BOOST_TEST(run.record().at("status") == status);
    BOOST_TEST(run.says(expected), run.record().at("message"));
    BOOST_TEST(run.record().at("controls").size() == bad.faults.size());
    BOOST_TEST(run.record(1).at("status") == "pass");
    BOOST_TEST(fs::exists(run.out / "junit.xml"));
  }
}

}  // namespace

BOOST_AUTO_TEST_CASE(a_sound_case_passes) {
  const Run run({synthetic("sound", sound)});
  BOOST_TEST(run.status == 0);
  BOOST_TEST(run.results.at("verdict") == "pass");
  BOOST_TEST(run.record().at("status") == "pass");
  const json control = run.record().at("controls").at(0);
  BOOST_TEST(control.at("observed") == "red");
  BOOST_TEST(control.at("unplanted") == "green");
  BOOST_TEST(control.at("measured") == 2.0);
  BOOST_TEST(run.results.at("counts").at("checks") == 1);
}

BOOST_AUTO_TEST_CASE(a_failed_check_fails) {
  demand_failure(synthetic("wrong", [](Findings& f,
                                       const Setup&) { f.expect("value", 3.0, 1.0, Tolerance::model(0.1, "chosen")); }),
                 "fail", "1 of 1 checks failed");
}

BOOST_AUTO_TEST_CASE(a_nan_fails) {
  demand_failure(synthetic("lost",
                           [](Findings& f, const Setup&) {
                             f.expect("value", std::numeric_limits<double>::quiet_NaN(), 1.0,
                                      Tolerance::model(0.1, "chosen"));
                           }),
                 "fail", "1 of 1 checks failed");
}

BOOST_AUTO_TEST_CASE(a_crash_fails) {
  demand_failure(synthetic("crashing", [](Findings&, const Setup&) { std::raise(SIGSEGV); }), "error", "signal 11");
}

BOOST_AUTO_TEST_CASE(an_abort_reports_its_last_message) {
  demand_failure(synthetic("aborting",
                           [](Findings&, const Setup&) {
                             std::fputs("the demand does not hold\n", stderr);
                             std::abort();
                           }),
                 "error", "the demand does not hold");
}

BOOST_AUTO_TEST_CASE(an_exception_fails_and_keeps_what_was_checked) {
  const Case thrower = synthetic("throwing", [](Findings& f, const Setup&) {
    f.expect_true("before", true, "made before the exception");
    throw std::runtime_error("no bracket \xff");
  });
  demand_failure(thrower, "error", "no bracket");
  BOOST_TEST(Run({thrower}).record().at("checks").size() == 1u);
}

BOOST_AUTO_TEST_CASE(a_case_that_hangs_is_stopped) {
  Case hanging =
      synthetic("hanging", [](Findings&, const Setup&) { std::this_thread::sleep_for(std::chrono::seconds(600)); });
  hanging.time_limit = 1.0;
  demand_failure(hanging, "timeout", "time limit of 1 s");
}

BOOST_AUTO_TEST_CASE(a_case_that_takes_too_much_memory_is_stopped) {
  Case hoarding = synthetic("hoarding", [](Findings&, const Setup&) {
    std::vector<std::string> hoard;
    for (int i = 0; i < 4096; ++i)
      hoard.emplace_back(std::size_t{1} << 20U, 'x');
    std::this_thread::sleep_for(std::chrono::seconds(600));
  });
  hoarding.memory_limit = 0.125;
  demand_failure(hoarding, "error", "memory limit of 0.125 GiB");
}

BOOST_AUTO_TEST_CASE(memory_that_is_refused_fails, *utf::enable_if<limits_memory>()) {
  demand_failure(synthetic("greedy",
                           [](Findings&, const Setup&) {
                             const std::vector<char> all(std::numeric_limits<std::ptrdiff_t>::max());
                             static_cast<void>(all);
                           }),
                 "error", "out of memory (std::bad_alloc)");
}

namespace {

/// A case whose record, a figure of 16 MB, a driver under a limit cannot read back. The case lifts the limit for
/// itself.
void large_record(Findings& findings, const Setup& setup) {
  rlimit limit{};
  ::getrlimit(RLIMIT_AS, &limit);
  limit.rlim_cur = limit.rlim_max;
  ::setrlimit(RLIMIT_AS, &limit);
  sound(findings, setup);
  if (setup.coarse) return;
  std::vector<double> x(1'000'000);
  for (std::size_t i = 0; i < x.size(); ++i)
    x[i] = static_cast<double>(i);
  findings.figure({.name = "curve",
                   .title = "Curve",
                   .caption = "Long.",
                   .x = {.label = "x"},
                   .y = {.label = "y"},
                   .series = {{"a", x, x}}});
}

/// Notes of 8 MB: the driver can read back two such records in less memory than writing its results requires.
void long_notes(Findings& findings, const Setup& setup) {
  sound(findings, setup);
  if (!setup.coarse) findings.note(std::string(std::size_t{8} << 20U, 'n'));
}

/// Runs the driver in a child process under `limited`; returns its exit status, or the negative number of a signal.
template <class Limit>
int verified_under(const std::vector<Case>& cases, const fs::path& out, Limit&& limited) {
  std::fflush(nullptr);
  const pid_t pid = ::fork();
  BOOST_REQUIRE(pid >= 0);
  if (pid == 0) {
    for (const int signal : {SIGABRT, SIGSEGV})
      ::signal(signal, SIG_DFL);
    const std::string folder = out.string();
    const char* argv[] = {"talus_verify", "--jobs", "1", "--out", folder.c_str()};
    limited();
    ::_exit(verify(cases, TALUS_CATALOGUE, 5, argv));
  }
  int status = 0;
  BOOST_REQUIRE(::waitpid(pid, &status, 0) == pid);
  return WIFEXITED(status) ? WEXITSTATUS(status) : -WTERMSIG(status);
}

/// Limits this process to `bytes` more address space than it has.
void limit_memory(std::size_t bytes) {
  std::size_t pages = 0;
  std::ifstream("/proc/self/statm") >> pages;
  rlimit limit{};
  ::getrlimit(RLIMIT_AS, &limit);
  limit.rlim_cur = pages * static_cast<std::size_t>(::sysconf(_SC_PAGESIZE)) + bytes;
  ::setrlimit(RLIMIT_AS, &limit);
}

}  // namespace

// From hardly more than the driver's reserve, with which it cannot even start a case, to enough for all.
BOOST_AUTO_TEST_CASE(a_driver_that_runs_out_of_memory_writes_its_results, *utf::enable_if<limits_memory>()) {
  const std::vector<Case> cases{synthetic("large", large_record), synthetic("sound", sound)};
  const Folder folder;
  const fs::path out = folder.path / "out";
  bool failed = false, passed = false;
  for (const std::size_t megabytes : {17U, 24U, 48U, 512U}) {
    fs::remove_all(out);
    const int status = verified_under(cases, out, [&] { limit_memory(megabytes << 20U); });
    BOOST_TEST_CONTEXT(megabytes << " MB: exit status " << status) {
      BOOST_REQUIRE((status == 0 || status == 1));
      BOOST_REQUIRE(fs::exists(out / "results.json"));
      BOOST_REQUIRE(fs::exists(out / "junit.xml"));
      const json results = json::parse(std::ifstream(out / "results.json"));
      BOOST_TEST(results.at("verdict") == (status == 0 ? "pass" : "fail"));
      BOOST_REQUIRE(results.at("cases").size() == 2u);
      const json& large = results.at("cases").at(0);
      BOOST_TEST(large.at("status") == (status == 0 ? "pass" : "error"));
      if (status == 1)
        BOOST_TEST(large.at("message").get<std::string>().find("ran out of memory") != std::string::npos);
      (status == 0 ? passed : failed) = true;
    }
  }
  BOOST_TEST(failed);
  BOOST_TEST(passed);
}

// If the records fit into memory and the results do not, they are written without their largest parts.
BOOST_AUTO_TEST_CASE(results_that_do_not_fit_into_memory_are_written_without_notes, *utf::enable_if<limits_memory>()) {
  const Folder folder;
  const fs::path out = folder.path / "out";
  bool shortened = false;
  for (std::size_t megabytes = 40; megabytes <= 120 && !shortened; megabytes += 4) {
    fs::remove_all(out);
    const std::vector<Case> cases{synthetic("noted", long_notes), synthetic("annotated", long_notes)};
    const int status = verified_under(cases, out, [&] { limit_memory(megabytes << 20U); });
    BOOST_TEST_CONTEXT(megabytes << " MB: exit status " << status) {
      BOOST_REQUIRE((status == 0 || status == 1));
      bool error = false;
      const json results = json::parse(std::ifstream(out / "results.json"));
      for (const json& record : results.at("cases")) {
        error = error || record.at("status") == "error";
        if (record.at("message").get<std::string>().find("are not in the results") == std::string::npos) continue;
        shortened = true;
        BOOST_TEST(record.at("checks").size() == 1u);
      }
      BOOST_TEST(error == (status == 1));
      BOOST_TEST(fs::file_size(out / "junit.xml") > 0u);
    }
  }
  BOOST_TEST(shortened);
}

// RLIMIT_NPROC does not apply to root: the driver then runs as user nobody, but accesses files as root, among them the
// catalogue, which may be in root's home folder.
BOOST_AUTO_TEST_CASE(a_case_without_a_process_fails) {
  const Folder folder;
  const fs::path out = folder.path / "out";
  const int status = verified_under({synthetic("sound", sound)}, out, [] {
    constexpr uid_t nobody = 65534;
    if (::geteuid() == 0) {
      if (::setresuid(nobody, nobody, 0) != 0) ::_exit(77);
      ::setfsuid(0);
    }
    const rlimit none{0, 0};
    ::setrlimit(RLIMIT_NPROC, &none);
  });
  BOOST_TEST(status == 1);
  BOOST_REQUIRE(fs::exists(out / "results.json"));
  const json record = json::parse(std::ifstream(out / "results.json")).at("cases").at(0);
  BOOST_TEST(record.at("status") == "error");
  BOOST_TEST(record.at("message").get<std::string>().find("no process for the case") == 0u, record.at("message"));
}

BOOST_AUTO_TEST_CASE(an_exit_without_record_fails) {
  demand_failure(synthetic("leaving", [](Findings&, const Setup&) { std::_Exit(0); }), "missing", "without");
  demand_failure(synthetic("exiting", [](Findings&, const Setup&) { std::_Exit(7); }), "error", "exit status 7");
}

BOOST_AUTO_TEST_CASE(a_broken_record_fails) {
  demand_failure(synthetic("truncating",
                           [](Findings&, const Setup&) {
                             std::ofstream(spoiled_folder + "/truncating/record.json") << "{\"schema\": 1, \"id\"";
                             std::_Exit(0);
                           }),
                 "error", "truncated");
  demand_failure(synthetic("emptying",
                           [](Findings&, const Setup&) {
                             std::ofstream(spoiled_folder + "/emptying/record.json") << "";
                             std::_Exit(0);
                           }),
                 "error", "is empty");
}

BOOST_AUTO_TEST_CASE(a_record_left_from_before_does_not_count) {
  const Case leaving = synthetic("leaving", [](Findings&, const Setup&) { std::_Exit(0); });
  const Folder folder;
  const fs::path out = folder.path / "out";
  const char* argv[] = {"talus_verify", "--out", out.c_str()};
  BOOST_TEST(verify({synthetic("leaving", sound)}, TALUS_CATALOGUE, 3, argv) == 0);
  BOOST_TEST(verify({leaving}, TALUS_CATALOGUE, 3, argv) == 1);
}

BOOST_AUTO_TEST_CASE(no_check_fails) {
  demand_failure(synthetic("idle", [](Findings&, const Setup&) {}), "fail", "no check was made");
}

BOOST_AUTO_TEST_CASE(a_control_that_stays_green_fails) {
  const Case blind = synthetic(
      "blind", [](Findings& f, const Setup&) { f.expect("value", 1.05, 1.0, Tolerance::model(0.1, "chosen")); });
  demand_failure(blind, "fail", "1 of 1 controls did not turn red");
  BOOST_TEST(Run({blind}).record().at("controls").at(0).at("observed") == "green");
}

BOOST_AUTO_TEST_CASE(a_control_whose_check_is_not_made_fails) {
  demand_failure(synthetic("silent",
                           [](Findings& f, const Setup& setup) {
                             if (setup.has("shifted")) throw std::runtime_error("diverged");
                             sound(f, setup);
                           }),
                 "fail", "1 of 1 controls did not turn red");
}

BOOST_AUTO_TEST_CASE(an_exception_after_the_named_check_leaves_the_control_red) {
  const Run run({synthetic("late", [](Findings& f, const Setup& setup) {
    sound(f, setup);
    if (setup.has("shifted")) throw std::runtime_error("diverged");
  })});
  BOOST_TEST(run.status == 0);
}

BOOST_AUTO_TEST_CASE(a_check_that_is_red_without_the_fault_proves_nothing) {
  const Case coarse = synthetic("coarse", [](Findings& f, const Setup& setup) {
    f.expect("value", setup.coarse ? 2.0 : 1.05, 1.0, Tolerance::model(0.1, "chosen"));
  });
  demand_failure(coarse, "fail", "1 of 1 controls are not judged, as their checks fail without the fault");
  BOOST_TEST(Run({coarse}).record().at("controls").at(0).at("unplanted") == "red");
}

BOOST_AUTO_TEST_CASE(a_main_check_that_is_not_made_fails) {
  Case c = synthetic("partial", sound);
  c.main_checks.push_back("gone");
  demand_failure(c, "fail", "main check 'gone' was not made");
}

/// Two checks that share the id "values", of which "values/first" is red with the fault.
void two_values(Findings& findings, const Setup& setup) {
  findings.expect_model({"values/first", "value"}, setup.has("shifted") ? 2.0 : 1.05, 1.0, 0.1, "chosen");
  findings.expect_model({"values/second", "other value"}, 1.05, 1.0, 0.1, "chosen");
}

BOOST_AUTO_TEST_CASE(a_definition_names_checks_by_their_ids) {
  Case c = synthetic("by_id", two_values);
  c.main_checks = {"values/first"};
  c.faults[0].turns_red = "values/first";
  c.requirements = {{"Eq. 14, Eq. 21", {"values"}}, {"Eq. 22", {"values/second"}}};
  const Run run({c});
  BOOST_TEST(run.status == 0);
  const auto& record = run.record();
  BOOST_TEST(record.at("main_checks").dump() == R"(["value"])");
  BOOST_TEST(record.at("controls").at(0).at("turns_red") == "value");
  BOOST_TEST(record.at("requirements").dump() == R"(["Eq. 14","Eq. 21","Eq. 22"])");
  BOOST_TEST(record.at("traces").at(1).at("checks").dump() == R"(["value","other value"])");
  BOOST_TEST(record.at("traces").at(2).at("checks").dump() == R"(["other value"])");
}

BOOST_AUTO_TEST_CASE(an_id_of_several_checks_is_no_main_check_and_turns_nothing_red) {
  Case c = synthetic("several", two_values);
  c.main_checks = {"values"};
  demand_failure(c, "fail", "main check 'values' was not made");
  c.main_checks = {"value"};
  c.faults[0].turns_red = "values";
  demand_failure(c, "fail", "1 of 1 controls did not turn red");
}

BOOST_AUTO_TEST_CASE(a_main_check_named_by_its_name_and_its_id_is_listed_twice) {
  Case c = synthetic("twice", two_values);
  c.main_checks = {"value", "values/first"};
  demand_failure(c, "fail", "main check 'value' is listed twice");
}

BOOST_AUTO_TEST_CASE(a_requirement_without_its_check_fails) {
  Case c = synthetic("partial", sound);
  c.requirements.push_back({"Eq. 21", {"value", "gone"}});
  demand_failure(c, "fail",
                 "case partial: claim Eq. 21: found 'gone'; it must be the name of a check or the id of a group of "
                 "checks of the case");
}

BOOST_AUTO_TEST_CASE(a_part_of_the_name_of_a_check_is_no_check) {
  Case c = synthetic("partial", sound);
  c.requirements.push_back({"Eq. 21", {"val"}});
  demand_failure(c, "fail", "case partial: claim Eq. 21: found 'val'");
}

BOOST_AUTO_TEST_CASE(a_claim_that_no_run_backs_fails) {
  Case c = synthetic("unbacked", [](Findings& f, const Setup& setup) {
    record_use("law.tension_only");
    sound(f, setup);
  });
  c.requirements.push_back({"law.tension_only", {"value"}});
  BOOST_TEST(Run({c}).status == 0);
  c.requirements.push_back({"law.hertz", {"value"}});
  demand_failure(c, "fail",
                 "case unbacked: claim law.hertz: no run of the case used it; its runs used law.tension_only");
}

BOOST_AUTO_TEST_CASE(a_group_named_by_an_integrator_that_did_not_run_fails) {
  demand_failure(synthetic("grouped",
                           [](Findings& f, const Setup& setup) {
                             const auto claim = f.in("integrator.rk4");
                             sound(f, setup);
                           }),
                 "fail", "case grouped: claim integrator.rk4: no run of the case used it; its runs used nothing");
}

BOOST_AUTO_TEST_CASE(a_figure_with_a_hole_fails) {
  demand_failure(synthetic("holed",
                           [](Findings& f, const Setup& setup) {
                             sound(f, setup);
                             const double hole = std::numeric_limits<double>::quiet_NaN();
                             f.figure({.name = "curve",
                                       .title = "Curve",
                                       .caption = "It has a hole.",
                                       .x = {.label = "x"},
                                       .y = {.label = "y"},
                                       .series = {{"a", {1.0, 2.0, 3.0}, {1.0, hole, 3.0}}}});
                           }),
                 "fail", "1 of 2 checks failed");
}

BOOST_AUTO_TEST_CASE(a_case_that_is_not_well_formed_fails_without_being_run) {
  const auto refuse = [](auto&& spoil, const std::string& expected) {
    Case bad = synthetic("bad", sound);
    spoil(bad);
    const Run run({bad});
    BOOST_TEST(run.status == 1);
    BOOST_TEST(run.record().at("status") == "error");
    BOOST_TEST(run.says(expected), run.record().at("message"));
  };
  refuse([](Case& c) { c.faults.clear(); }, "plants no fault");
  refuse([](Case& c) { c.source.clear(); }, "cites no source");
  refuse([](Case& c) { c.source = "Nobody & Noone 1993"; }, "no entry for 'nobody 1993'");
  refuse([](Case& c) { c.page += "\n**Source.** Nobody, J. None 9 (1993) 1.\n\nElse 1994."; },
         "no entry for 'nobody 1993'");
  refuse([](Case& c) { c.page = "A page."; }, "its page: it has no paragraph **Evidence.**");
  refuse([](Case& c) { c.page = "**Evidence.** Belief. Not shown: that it is true."; },
         "its evidence 'belief' is not known");
  refuse([](Case& c) { c.recorded = true; }, "does not rest on earlier results, but it is declared as recorded");
  refuse([](Case& c) { c.page = "**Evidence.** Earlier result. Not shown: that it was right."; },
         "rests on earlier results, but it is not declared as recorded");
  refuse([](Case& c) { c.requirements = {{"Eq. 99", {"value"}}}; }, "'Eq. 99' is in no closed list");
  refuse([](Case& c) { c.requirements = {{"Eq. 14", {}}}; }, "names no check for requirement 'Eq. 14'");
  refuse([](Case& c) { c.requirements.push_back(c.requirements[0]); }, "'Eq. 14' is listed twice");
  refuse([](Case& c) { c.requirements = {{"Eq. 14, Eq. 14", {"value"}}}; }, "'Eq. 14' is listed twice");
  refuse([](Case& c) { c.requirements = {{"Eq. 14, Eq. 99", {"value"}}}; }, "'Eq. 99' is in no closed list");
  refuse([](Case& c) { c.main_checks.clear(); }, "names no main check");
  refuse([](Case& c) { c.main_checks.push_back("value"); }, "main check 'value' is listed twice");
  refuse([](Case& c) { c.page.clear(); }, "page is empty");
  refuse([](Case& c) { c.run = nullptr; }, "nothing to run");
  refuse([](Case& c) { c.time_limit = 0.0; }, "time limit");
  refuse([](Case& c) { c.memory_limit = 0.0; }, "memory limit");
  refuse([](Case& c) { c.family.clear(); }, "names no family");
  refuse([](Case& c) { c.family = "fences"; }, "family 'fences' is not known");
  refuse([](Case& c) { c.faults.push_back(c.faults[0]); }, "listed twice");
  const Run twice({synthetic("same", sound), synthetic("same", sound)});
  BOOST_TEST(twice.status == 1);
}

BOOST_AUTO_TEST_SUITE_END()
