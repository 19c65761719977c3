#include "solver/vtkhdf/hdf_file.hpp"

#include <boost/test/unit_test.hpp>

#include "solver/base/error.hpp"
#include "tests/temporary_folder.hpp"
#include "verification/record/whole_file.hpp"

BOOST_AUTO_TEST_SUITE(hdf_file_tests)

using namespace talus;
using records::read_whole;

namespace {

void fill(HdfFile& file) {
  file.group("/a");
  file.attribute("/a", "text", "abc");
  file.attribute("/a", "numbers", std::vector<std::int64_t>{2, 0});
  file.append("/a/rows", {1.0, 2.0, 3.0}, 3);
  file.append("/a/rows", {4.0, 5.0, 6.0, 7.0, 8.0, 9.0}, 3);
  file.append("/a/none", HdfType::uint8, {});
}

std::vector<double> rows_of(const std::filesystem::path& path, const char* table) {
  const hid_t file = H5Fopen(path.c_str(), H5F_ACC_RDONLY, H5P_DEFAULT), set = H5Dopen2(file, table, H5P_DEFAULT),
              space = H5Dget_space(set);
  std::vector<double> numbers(static_cast<std::size_t>(H5Sget_simple_extent_npoints(space)));
  H5Dread(set, H5T_NATIVE_DOUBLE, H5S_ALL, H5S_ALL, H5P_DEFAULT, numbers.data());
  H5Sclose(space), H5Dclose(set), H5Fclose(file);
  return numbers;
}

}  // namespace

BOOST_AUTO_TEST_CASE(rows_are_appended_and_bytes_repeat) {
  const Folder folder;
  for (const char* const name : {"a.h5", "b.h5"}) {
    HdfFile file{folder.path / name};
    fill(file);
    file.close();
  }
  const std::vector<double> expected{1, 2, 3, 4, 5, 6, 7, 8, 9};
  BOOST_TEST(rows_of(folder.path / "a.h5", "/a/rows") == expected, boost::test_tools::per_element());
  BOOST_TEST(rows_of(folder.path / "a.h5", "/a/none").empty());
  BOOST_TEST((read_whole(folder.path / "a.h5") == read_whole(folder.path / "b.h5")));
}

BOOST_AUTO_TEST_CASE(a_file_appears_when_it_is_closed) {
  const Folder folder;
  folder.file("a.h5", "old");
  {
    HdfFile file{folder.path / "a.h5"};
    fill(file);
    BOOST_TEST(read_whole(folder.path / "a.h5") == "old");
  }
  BOOST_TEST(read_whole(folder.path / "a.h5") == "old");
  BOOST_TEST(folder.files() == 1);  // not closed: nothing is left
}

BOOST_AUTO_TEST_CASE(errors_name_the_file_and_the_reason) {
  const Folder folder;
  HdfFile file{folder.path / "none/a.h5"};
  BOOST_CHECK_EXCEPTION(file.close(), IoError, [](const IoError& error) {
    return std::string{error.what()}.ends_with("none/a.h5: No such file or directory");
  });
}

BOOST_AUTO_TEST_SUITE_END()
