#include <boost/test/unit_test.hpp>
#include <chrono>
#include <csignal>
#include <filesystem>
#include <string>
#include <thread>

#include "tests/solver/app/program.hpp"
#include "tests/temporary_folder.hpp"

BOOST_AUTO_TEST_SUITE(fit_tests)

using namespace talus;

namespace {

/// A fit of runs of an hour.
std::string long_fit(const Folder& folder) {
  folder.file("data.csv", "step [s],x [m]\n1e-10,1\n2e-10,2\n");
  return folder
      .file("long.toml", "scene = \"" + scene("two_cable.toml") +
                             "\"\ndata = \"data.csv\"\n[[input]]\ncolumn = \"step [s]\"\nfield = \"run.step\"\n"
                             "[[quantity]]\ncolumn = \"x [m]\"\nresult = \"particle.x.max\"\n[[parameter]]\n"
                             "field = \"body.particle.mass\"\nrange = [\"1 kg\", \"2 kg\"]\n")
      .string();
}

/// Waits until a fit that was started runs: its folder, which stays empty, is made and locked.
void wait_for(const fs::path& out) {
  for (int i = 0; i < 2000 && !fs::exists(out); ++i)
    std::this_thread::sleep_for(std::chrono::milliseconds{5});
  std::this_thread::sleep_for(std::chrono::milliseconds{300});
}

}  // namespace

BOOST_AUTO_TEST_CASE(a_signal_ends_it_and_nothing_is_written) {
  const Folder folder;
  const std::string file = long_fit(folder);
  for (const int signal : {SIGINT, SIGTERM}) {
    const fs::path out = folder.path / std::to_string(signal);
    StartedProgram program{TALUS_EXECUTABLE, {"fit", file, "--out", out.string(), "--threads", "2"}};
    wait_for(out);
    program.send(signal);
    BOOST_TEST(program.exit_code() == 128 + signal);
    BOOST_TEST(!fs::exists(out / "fit.json"));
  }
}

BOOST_AUTO_TEST_CASE(a_folder_has_one_fit_at_a_time) {
  const Folder folder;
  const std::string file = long_fit(folder), out = (folder.path / "out").string();
  StartedProgram first{TALUS_EXECUTABLE, {"fit", file, "--out", out}};
  wait_for(out);
  const Ended second = talus_ran({"fit", file, "--out", out});
  BOOST_TEST(second.code == 4);
  BOOST_TEST(second.err.find("is writing into it") != std::string::npos, second.err);
  first.send(SIGTERM);
  BOOST_TEST(first.exit_code() == 128 + SIGTERM);
}

BOOST_AUTO_TEST_SUITE_END()
