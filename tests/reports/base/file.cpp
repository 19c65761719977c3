#include "reports/base/file.hpp"

#include <sys/wait.h>
#include <unistd.h>

#include <boost/test/unit_test.hpp>
#include <fstream>

#include "tests/reports/scratch.hpp"

BOOST_AUTO_TEST_SUITE(file_tests)

namespace fs = std::filesystem;
using talus::reports::StagingFolder;

namespace {

std::string partial(pid_t process) { return ".partial-" + std::to_string(process); }

/// Process id of a process that has ended.
pid_t ended_process() {
  const pid_t child = ::fork();
  if (child == 0) ::_exit(0);
  ::waitpid(child, nullptr, 0);
  return child;
}

}  // namespace

BOOST_AUTO_TEST_CASE(what_is_not_published_is_removed) {
  const Scratch scratch("file");
  {
    const StagingFolder staging{scratch.folder};
    std::ofstream{staging.folder() / "whole"} << "text";
    std::ofstream{staging.folder() / "half"} << "te";
    staging.publish("whole");
    BOOST_TEST(staging.folder().filename() == partial(::getpid()));
  }
  BOOST_TEST(fs::exists(scratch.folder / "whole"));
  BOOST_TEST(std::distance(fs::directory_iterator{scratch.folder}, {}) == 1);
}

BOOST_AUTO_TEST_CASE(folders_of_killed_processes_are_removed) {
  const Scratch scratch("file");
  const std::string killed = partial(ended_process()), alive = partial(::getppid());
  for (const std::string& name : {killed, alive, std::string{".partial-"}, std::string{".partial-1x"}})
    fs::create_directories(scratch.folder / name / "figures");
  const StagingFolder staging{scratch.folder};
  BOOST_TEST(!fs::exists(scratch.folder / killed));
  for (const std::string& name : {alive, std::string{".partial-"}, std::string{".partial-1x"}})
    BOOST_TEST(fs::exists(scratch.folder / name), name);
}

BOOST_AUTO_TEST_SUITE_END()
