#include "solver/io/file/atomic_file.hpp"

#include <boost/test/unit_test.hpp>
#include <string>

#include "solver/base/error.hpp"
#include "solver/io/file/toml_document.hpp"
#include "tests/temporary_folder.hpp"

BOOST_AUTO_TEST_SUITE(atomic_file_tests)

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

}  // namespace

BOOST_AUTO_TEST_CASE(a_file_is_written_and_replaced) {
  const Folder folder;
  write_whole(folder.path / "a", "one");
  write_whole(folder.path / "a", "two\n");
  BOOST_TEST(read_text(folder.path / "a") == "two\n");
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
  BOOST_CHECK_THROW(make_folder(folder.path / "file"), IoError);
  demand_writable_folder(folder.path / "c" / "d");
  BOOST_TEST(!fs::exists(folder.path / "c"));
  const std::string meaning = "a folder that `talus run --out` or `talus cell --out` wrote";
  demand_folder_with(folder.path, "file", meaning);
  BOOST_CHECK_THROW(demand_folder_with(folder.path / "a", "plot.json", meaning), IoError);
}

BOOST_AUTO_TEST_SUITE_END()
