#define BOOST_TEST_MODULE atomic_file
#include "solver/io/file/atomic_file.hpp"

#include <sys/resource.h>
#include <unistd.h>

#include <boost/test/unit_test.hpp>
#include <csignal>
#include <string>

#include "solver/base/error.hpp"
#include "solver/io/file/toml_document.hpp"
#include "tests/solver/io/folder.hpp"

using namespace talus;
namespace fs = std::filesystem;

namespace {

std::string message(const fs::path& file, std::string_view content) {
  try {
    write_whole(file, content);
  } catch (const IoError& error) {
    return error.what();
  }
  return "no error";
}

/// Files of this process can hold at most so many bytes while this lives.
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

}  // namespace

BOOST_AUTO_TEST_CASE(a_file_is_written_and_replaced) {
  const Folder folder;
  write_whole(folder.path / "a", "one");
  write_whole(folder.path / "a", "two\n");
  BOOST_TEST(read_text(folder.path / "a") == "two\n");
  BOOST_TEST(folder.files() == 1);
  BOOST_TEST(((fs::status(folder.path / "a").permissions() & fs::perms::owner_read) == fs::perms::owner_read));
}

// The disk fills up half-way: the old file stays as it was, nothing else is left behind.
BOOST_AUTO_TEST_CASE(nothing_is_half_written) {
  const Folder folder;
  const fs::path file = folder.path / "history.csv";
  write_whole(file, "old");
  std::string words;
  {
    const FileLimit limit{1000};
    words = message(file, std::string(5000, 'x'));
  }
  BOOST_TEST(words == file.string() + ": File too large");
  BOOST_TEST(read_text(file) == "old");
  BOOST_TEST(folder.files() == 1);
}

BOOST_AUTO_TEST_CASE(errors_give_the_systems_reason) {
  const Folder folder;
  BOOST_TEST(message("/dev/full", "text") == "/dev/full: No space left on device");
  BOOST_TEST(message(folder.path / "no" / "a", "text") ==
             (folder.path / "no" / "a").string() + ": No such file or directory");
  fs::create_directory(folder.path / "is_folder");
  BOOST_TEST(message(folder.path / "is_folder", "text") == (folder.path / "is_folder").string() + ": Is a directory");
  BOOST_TEST(folder.files() == 1);
}

BOOST_AUTO_TEST_CASE(folders_are_made) {
  const Folder folder;
  make_folder(folder.path / "a" / "b");
  make_folder(folder.path / "a" / "b");
  BOOST_TEST(fs::is_directory(folder.path / "a" / "b"));
  write_whole(folder.path / "file", "");
  BOOST_CHECK_THROW(make_folder(folder.path / "file" / "b"), IoError);
}
