#include "verification/record/whole_file.hpp"

#include <sys/resource.h>
#include <sys/stat.h>

#include <csignal>
#include <fstream>
#include <thread>
#include <vector>

#include "tests/verification/record/error_message.hpp"

BOOST_AUTO_TEST_SUITE(whole_file_tests)

using namespace talus::records;

namespace {

/// Limits the size of the files that this process writes, like a disk that fills up.
struct FileLimit {
  rlimit before{};

  explicit FileLimit(rlim_t bytes) {
    BOOST_REQUIRE(::getrlimit(RLIMIT_FSIZE, &before) == 0);
    std::signal(SIGXFSZ, SIG_IGN);
    const rlimit now{bytes, before.rlim_max};
    BOOST_REQUIRE(::setrlimit(RLIMIT_FSIZE, &now) == 0);
  }
  FileLimit(const FileLimit&) = delete;
  FileLimit& operator=(const FileLimit&) = delete;
  ~FileLimit() { ::setrlimit(RLIMIT_FSIZE, &before); }
};

std::string message(const fs::path& file, std::string_view content) {
  return error_message([&] { write_whole(file, content); });
}

mode_t permissions(const fs::path& file) {
  struct stat status {};
  BOOST_REQUIRE(::stat(file.c_str(), &status) == 0);
  return status.st_mode & 0777U;
}

}  // namespace

BOOST_AUTO_TEST_CASE(a_file_is_written_and_replaced) {
  const Folder folder;
  const std::string bytes("one\0two\r\n", 9);
  write_whole(folder.path / "a", "first");
  write_whole(folder.path / "a", bytes);
  BOOST_TEST(read_whole(folder.path / "a") == bytes);
  write_whole(folder.path / "empty", "");
  BOOST_TEST(read_whole(folder.path / "empty") == "");
  BOOST_TEST(folder.files() == 2);
}

BOOST_AUTO_TEST_CASE(a_new_file_has_the_usual_permissions) {
  const Folder folder;
  const mode_t before = ::umask(027);
  write_whole(folder.path / "a", "text");
  BOOST_TEST(::umask(before) == 027U);
  BOOST_TEST(permissions(folder.path / "a") == 0640U);
}

// The disk fills up half-way: the old file is unchanged, and no other file remains.
BOOST_AUTO_TEST_CASE(a_failure_leaves_the_old_file) {
  const Folder folder;
  const fs::path file = folder.path / "results.json";
  write_whole(file, "old");
  std::string expected;
  {
    const FileLimit limit{1000};
    expected = message(file, std::string(5000, 'x'));
  }
  BOOST_TEST(expected == file.string() + ": File too large");
  BOOST_TEST(read_whole(file) == "old");
  BOOST_TEST(folder.files() == 1);
}

BOOST_AUTO_TEST_CASE(errors_give_the_systems_reason) {
  const Folder folder;
  BOOST_TEST(message("/dev/full", "text") == "/dev/full: No space left on device");
  const fs::path lost = folder.path / "no" / "a";
  BOOST_TEST(message(lost, "text") == lost.string() + ": No such file or directory");
  BOOST_TEST(error_message([&] { (void)read_whole(lost); }) == lost.string() + ": No such file or directory");
  fs::create_directory(folder.path / "is_folder");
  BOOST_TEST(message(folder.path / "is_folder", "text") == (folder.path / "is_folder").string() + ": Is a directory");
  BOOST_TEST(holds(error_message([&] { (void)read_whole(folder.path / "is_folder"); }), "Is a directory"));
  BOOST_TEST(folder.files() == 1);
}

// A device without end, a pipe, and a file whose size alone is too large: it has no blocks on the disk.
BOOST_AUTO_TEST_CASE(files_without_end_are_refused) {
  const Folder folder;
  BOOST_TEST(error_message([] { (void)read_whole("/dev/zero"); }) ==
             "/dev/zero: found more than 1073741824 bytes; a pipe or device must have at most that many");
  const fs::path large = folder.file("large", "");
  fs::resize_file(large, (std::uintmax_t{4} << 30) + 1);
  BOOST_TEST(error_message([&] { (void)read_whole(large); }) ==
             large.string() + ": found more than 4294967296 bytes; a file must have at most that many");
  const fs::path pipe = folder.path / "pipe";
  BOOST_REQUIRE(::mkfifo(pipe.c_str(), 0600) == 0);
  const std::string text(300'000, 'x');
  std::thread writer{[&] { std::ofstream{pipe} << text; }};
  BOOST_TEST((read_whole(pipe) == text));
  writer.join();
}

BOOST_AUTO_TEST_CASE(threads_write_side_by_side) {
  const Folder folder;
  std::vector<std::thread> threads;
  for (int t = 0; t < 4; ++t) {
    threads.emplace_back([&, t] {
      for (int i = 0; i < 25; ++i) {
        write_whole(folder.path / std::to_string(t), std::string(1000, static_cast<char>('a' + t)));
        write_whole(folder.path / "common", std::string(1000, static_cast<char>('a' + t)));
      }
    });
  }
  for (std::thread& thread : threads)
    thread.join();
  BOOST_TEST(folder.files() == 5);
  const std::string common = read_whole(folder.path / "common");
  BOOST_TEST(common == std::string(1000, common.front()));
}

BOOST_AUTO_TEST_CASE(the_remains_of_a_killed_program_are_removed) {
  const Folder folder;
  folder.file(".a.csv.talus-0000ab", "half");
  folder.file(".b.csv.talus-0000ab", "half");
  folder.file(".a.csv.talus-0", "another's");
  folder.file("a.csv", "whole");
  remove_remains(folder.path, [](std::string_view name) { return name == "a.csv"; });
  BOOST_TEST(folder.files() == 3);
  BOOST_TEST(!fs::exists(folder.path / ".a.csv.talus-0000ab"));
  remove_remains(folder.path / "none", [](std::string_view) { return true; });
}

BOOST_AUTO_TEST_SUITE_END()
