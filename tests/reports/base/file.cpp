#include "reports/base/file.hpp"

#include <sys/wait.h>
#include <unistd.h>

#include <boost/test/unit_test.hpp>
#include <fstream>

#include "tests/temporary_folder.hpp"

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
  const Folder scratch;
  {
    const StagingFolder staging{scratch.path};
    std::ofstream{staging.folder() / "whole"} << "text";
    std::ofstream{staging.folder() / "half"} << "te";
    staging.publish("whole");
    BOOST_TEST(staging.folder().filename() == partial(::getpid()));
  }
  BOOST_TEST(fs::exists(scratch.path / "whole"));
  BOOST_TEST(std::distance(fs::directory_iterator{scratch.path}, {}) == 1);
}

BOOST_AUTO_TEST_CASE(folders_of_killed_processes_are_removed) {
  const Folder scratch;
  const std::string killed = partial(ended_process()), alive = partial(::getppid());
  for (const std::string& name : {killed, alive, std::string{".partial-"}, std::string{".partial-1x"}})
    fs::create_directories(scratch.path / name / "figures");
  const StagingFolder staging{scratch.path};
  BOOST_TEST(!fs::exists(scratch.path / killed));
  for (const std::string& name : {alive, std::string{".partial-"}, std::string{".partial-1x"}})
    BOOST_TEST(fs::exists(scratch.path / name), name);
}

BOOST_AUTO_TEST_SUITE_END()
