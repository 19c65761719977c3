/// The program talus_vtkhdf, as a user starts it.
#include <fmt/format.h>

#include <boost/test/unit_test.hpp>

#include "tests/solver/app/program.hpp"
#include "verification/record/whole_file.hpp"

BOOST_AUTO_TEST_SUITE(vtkhdf_program_tests)

using talus::records::read_whole;

namespace {

Ended vtkhdf(const std::vector<std::string>& arguments) { return ran(TALUS_VTKHDF, arguments); }

std::string replaced(std::string text, const std::string& from, const std::string& to) {
  const std::size_t at = text.find(from);
  BOOST_REQUIRE(at != std::string::npos);
  return text.replace(at, from.size(), to);
}

/// A run with few states.
struct Run {
  Run() {
    const Ended run = talus_ran({"run", scene("two_cable.toml"), "--end", "0.1 s", "--frames", "1", "--out", out()});
    BOOST_REQUIRE(run.code == 0);
  }
  std::string out() const { return (folder.path / "out").string(); }
  std::string index() const { return out() + "/two_cable.pvd"; }
  fs::path last() const { return folder.path / "out/two_cable_geometry/two_cable_00005000.vtp"; }
  std::string file() const { return (folder.path / "states.vtkhdf").string(); }

  Folder folder;
};

}  // namespace

BOOST_AUTO_TEST_CASE(it_writes_a_file_and_prints_its_name) {
  const Run run;
  const Ended ended = vtkhdf({run.index(), "--out", run.file()});
  BOOST_TEST(ended.code == 0);
  BOOST_TEST(ended.out == run.file() + "\n");
  BOOST_TEST(ended.err == "");
  BOOST_TEST(read_whole(run.file()).starts_with("\x89HDF"));
  BOOST_TEST(vtkhdf({"--version"}).out.starts_with("talus_vtkhdf "));
}

BOOST_AUTO_TEST_CASE(wrong_requests_and_files_are_refused) {
  const Run run;
  const std::string good = read_whole(run.last());
  struct Wrong {
    std::string from, to, message;
  };
  for (const Wrong& wrong :
       {Wrong{"Name=\"tension\"", "Name=\"pull\"", "CellData: the arrays must be those of the first state"},
        {"type=\"Float64\" Name=\"tension\"", "type=\"Int32\" Name=\"tension\"",
         "CellData: the arrays must be those of the first state"},
        {"type=\"Float64\" Name=\"tension\"", "type=\"Float16\" Name=\"tension\"",
         "CellData: array 'tension': found type \"Float16\"; it must be Float64, Int64, Int32 or UInt8"},
        {"Name=\"tension\" NumberOfComponents=\"1\"", "Name=\"tension\" NumberOfComponents=\"10\"",
         "CellData: array 'tension': found 10 components; there must be 1 to 9"},
        {"Name=\"tension\" NumberOfComponents=\"1\"", "Name=\"tension\" NumberOfComponents=\"2\"",
         "CellData: the arrays must be those of the first state"},
        {"Name=\"tension\"", "Name=\"a/b\"",
         "CellData: array 'a/b': found a name that is empty, a point, or has a slash; it must be another one"},
        {"\n0 1 2 3 ", "\n0 1 2 999 ", "Lines: array 'connectivity': found point 999; it must be below 198"},
        {"NumberOfLines=\"4\"", "NumberOfLines=\"5\"", "Lines: array 'offsets': found 4 numbers; it must have 5"},
        {"\n97 194 196 198 ", "\n97 194 196 197 ",
         "Lines: array 'offsets': the last is 197; it must be the number of points of all cells, 198"},
        {"\n0 0 0 0 \n</DataArray>\n</CellData>", "\n0 0 300 0 \n</DataArray>\n</CellData>",
         "CellData: array 'slack': found 300; it must be in 0 .. 255"},
        {"\n0 0 0 0 \n</DataArray>\n</CellData>", "\n0 0 0 \n</DataArray>\n</CellData>",
         "CellData: array 'slack': found 3 numbers; it must have 4, one for each point or cell"},
        {"\n0 0 0 0 \n</DataArray>\n</CellData>", "\n0 0 1.5 0 \n</DataArray>\n</CellData>",
         "CellData: array 'slack': found \"1.5\"; it must be a number"},
        {"Name=\"cable\"", "Name=\"body\"", "CellData: array 'body': found a second array of this name; remove one"},
        {"\n97 194 ", "\n97 96 ", "Lines: array 'offsets': found 96; it must be in 97 .. 198"}}) {
    talus::records::write_whole(run.last(), replaced(good, wrong.from, wrong.to));
    const Ended ended = vtkhdf({run.index(), "--out", run.file()});
    BOOST_TEST(ended.code == 2);
    BOOST_TEST(ended.err.find(wrong.message) != std::string::npos, wrong.message << " | " << ended.err);
    BOOST_TEST(ended.err.starts_with("talus_vtkhdf: " + run.last().string() + ":"), ended.err);
    BOOST_TEST(!fs::exists(run.file()));
  }
  talus::records::write_whole(run.last(), good);
  BOOST_TEST(run.folder.files() == 1);  // nothing half-written remains beside the folder of the run
  const Ended named = vtkhdf({run.index(), "--out", (run.folder.path / "states.h5").string()});
  BOOST_TEST(named.code == 2);
  BOOST_TEST(named.err.find("it must end with .vtkhdf, by which ParaView knows the format") != std::string::npos);
  BOOST_TEST(vtkhdf({run.index()}).code == 2);
  BOOST_TEST(vtkhdf({run.out() + "/none.pvd", "--out", run.file()}).code == 4);
  fs::create_symlink("/dev/full", run.file());
  const Ended full = vtkhdf({run.index(), "--out", run.file()});
  BOOST_TEST(full.code == 4);  // the library of HDF5 would end it by a signal
  BOOST_TEST(full.err == "talus_vtkhdf: " + run.file() + ": No space left on device\n");
  BOOST_TEST(vtkhdf({run.index(), "--out", run.out() + "/none/states.vtkhdf"}).code == 4);
}

BOOST_AUTO_TEST_SUITE_END()
