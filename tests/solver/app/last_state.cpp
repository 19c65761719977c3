/// The final state of a run is the last state in each of its files, however the run ends.
#include <boost/test/unit_test.hpp>
#include <fstream>
#include <nlohmann/json.hpp>

#include "solver/io/file/fortran.hpp"
#include "solver/io/output/read_geometry.hpp"
#include "solver/io/output/read_history.hpp"
#include "tests/solver/app/program.hpp"

BOOST_AUTO_TEST_SUITE(last_state_tests)

namespace {

struct Times {
  double end{};         ///< end of the run
  std::string listing;  ///< time of the last printed state
  double step{};
};

/// Runs a fence whose file is called sample2 and compares the times of the last states in its files.
Times last_times(std::vector<std::string> order, const fs::path& out) {
  order.insert(order.begin(), "run");
  order.insert(order.end(), {"--sheet", "--out", out.string()});
  const Ended ended = talus_ran(order);
  BOOST_TEST_REQUIRE(ended.code == 0, ended.err);
  const auto json = [&](const char* name) { return nlohmann::json::parse(talus::read_text(out / name)); };
  const auto summary = json("summary.json");
  const double end = summary.at("outcome").at("time");
  for (const char* name : {"history.csv", "sample2.history.csv"})
    BOOST_TEST(talus::read_history(out / name).columns.front().values.back() == end, name);
  BOOST_TEST(talus::read_geometry_index(out / "sample2.pvd").back().time == end);
  const auto sheet = json("sheet.json");
  BOOST_TEST(sheet.at("history").at("rows").back().at(0) == end);
  BOOST_TEST(sheet.at("drawing").at("states").back().at("time") == end);
  const std::string listing = talus::read_text(out / "sample2.OUT");
  const std::size_t offset = listing.rfind("time = ") + 7;
  return {end, listing.substr(offset, listing.find(" secs", offset) - offset), sheet.at("run").at("step")};
}

}  // namespace

BOOST_AUTO_TEST_CASE(of_a_run_that_is_left) {
  // 5 ms are 61 steps: one more than nprint, eleven more than nhisto.
  const Folder folder;
  const Times last = last_times({scene("fence/sample2.DAT"), "--until", "5 ms"}, folder.path);
  BOOST_TEST(last.end == 61.0 * last.step);
  BOOST_TEST(last.listing == talus::fortran_e(last.end, 3));
}

BOOST_AUTO_TEST_CASE(of_a_run_that_ends_where_the_rock_has_gone) {
  const Folder folder;
  const fs::path file = folder.path / "sample2.toml";
  std::ofstream{file} << talus::read_text(scene("fence/sample2.toml"))
                      << "[fence.options]\nend = \"exit\"\nexit_x = \"2.2 ft\"\n";
  const Times last = last_times({file.string()}, folder.path / "out");
  BOOST_TEST(last.listing == talus::fortran_e(last.end, 3));
}

BOOST_AUTO_TEST_CASE(of_a_run_that_ends_by_time_but_for_the_listing) {
  // The listing of 1993 has a state every nprint = 60 steps: here only the 60th of 61 steps.
  const Folder folder;
  const Times last = last_times({scene("fence/sample2.DAT"), "--end", "5 ms"}, folder.path);
  BOOST_TEST(last.end == 61.0 * last.step);
  BOOST_TEST(last.listing == talus::fortran_e(60.0 * last.step, 3));
}

BOOST_AUTO_TEST_SUITE_END()
