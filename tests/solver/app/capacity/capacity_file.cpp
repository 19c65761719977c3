#include "solver/app/capacity/capacity_file.hpp"

#include <boost/test/unit_test.hpp>
#include <string>

#include "solver/base/error.hpp"
#include "tests/temporary_folder.hpp"

BOOST_AUTO_TEST_SUITE(capacity_file_tests)

using namespace talus;
using namespace talus::app;

namespace {

std::string message(const std::string& text, const Folder& folder) {
  try {
    static_cast<void>(read_capacity(text, folder.path / "c.toml"));
  } catch (const InputError& error) {
    std::string found = error.what();
    for (std::size_t at = found.find(folder.path.string()); at != std::string::npos;
         at = found.find(folder.path.string()))
      found.erase(at, folder.path.string().size() + 1);
    return found;
  }
  return "no error";
}

const std::string mass = "mass = [\"1 kg\", \"2 kg\"]\n", speed = "speed = [\"3 m/s\", \"4 m/s\"]\n",
                  head = "base = \"f.toml\"\n" + mass + speed;

}  // namespace

BOOST_AUTO_TEST_CASE(all_fields_are_read_and_all_but_three_have_defaults) {
  const Folder folder;
  const CapacityFile defaults = read_capacity(head, "sub/c.toml");
  BOOST_TEST(defaults.base.string() == "sub/f.toml");
  BOOST_TEST(defaults.mass[1] == 2.0);
  BOOST_TEST(defaults.speed[0] == 3.0);
  BOOST_TEST(defaults.heights.empty());
  BOOST_TEST(defaults.map.cells == 64);
  BOOST_TEST(defaults.map.trials == 20U);
  BOOST_TEST(defaults.audit == 50U);
  BOOST_TEST(defaults.changes.speed == 0.01);
  BOOST_TEST(defaults.changes.height == 0.0);
  BOOST_TEST(defaults.seed == 1);
  BOOST_TEST(!defaults.hazard);
  folder.file("rocks.csv", "speed [m/s],height [m],mass [kg]\n3,1,200\n4,2,100\n");
  const CapacityFile all = read_capacity(
      "title = \"T\"\n" + head +
          "height = [\"1 m\", \"250 cm\"]\nspin = \"-4 rad/s\"\nalong = [\"-1 cm\"]\nset = { \"fence.duration\" = \"2 "
          "s\" }\nseed = 7\n[map]\ncells = 24\n"
          "first_cells = 3\nruns = 5\nfew_runs = 2\naudit = 0\n[changes]\nspeed = 0.5\nheight = \"1 cm\"\nangle = "
          "\"180 deg\"\n"
          "spin = \"2 rad/s\"\nalong = \"3 cm\"\n[hazard]\nspin = [\"1 rad/s\", \"2 rad/s\"]\ntable = "
          "\"rocks.csv\"\nruns = 9\n[limits]\nevaluations = 8\n",
      folder.path / "c.toml");
  BOOST_TEST(all.title == "T");
  BOOST_TEST(all.heights == (std::vector<double>{1.0, 2.5}), boost::test_tools::per_element());
  BOOST_TEST(all.fields.at(0).first == "fence.duration");
  BOOST_TEST(all.seed == 7);
  BOOST_TEST(all.map.cells == 24);
  BOOST_TEST(all.map.first_cells == 3);
  BOOST_TEST(all.map.trials == 5U);
  BOOST_TEST(all.map.few == 2U);
  BOOST_TEST(all.audit == 0U);
  BOOST_TEST(all.changes.speed == 0.5);
  BOOST_TEST(all.changes.height == 0.01);
  BOOST_TEST(all.changes.angle == 3.141592653589793);
  BOOST_TEST(all.changes.spin == 2.0);
  BOOST_TEST(all.changes.along == 0.03);
  BOOST_TEST(all.spins == (std::vector<double>{-4.0}), boost::test_tools::per_element());
  BOOST_TEST(all.positions == (std::vector<double>{-0.01}), boost::test_tools::per_element());
  BOOST_TEST((all.hazard->spin == std::array{1.0, 2.0}));
  BOOST_TEST(!all.hazard->along);
  BOOST_TEST(!all.hazard->table_has_spin);
  BOOST_TEST(all.hazard->runs == 9U);
  BOOST_TEST(all.hazard->table.at(1).mass == 100.0);
  BOOST_TEST(all.hazard->table.at(1).height == 2.0);
  BOOST_TEST(all.limits.evaluations == 8);
  BOOST_TEST(read_capacity(head + "height = \"2 m\"\n", "c.toml").heights == (std::vector<double>{2.0}),
             boost::test_tools::per_element());
  folder.file("positions.csv", "along [m],speed [m/s],height [m],mass [kg],spin [rad/s]\n-2,3,1,200,8\n");
  const RockHazard positions =
      *read_capacity(head + "[hazard]\ntable = \"positions.csv\"\n", folder.path / "c.toml").hazard;
  BOOST_TEST(positions.table_has_spin);
  BOOST_TEST(positions.table_has_along);
  BOOST_TEST(positions.table.at(0).spin == 8.0);
  BOOST_TEST(positions.table.at(0).along == -2.0);
}

BOOST_AUTO_TEST_CASE(a_lognormal_number_has_its_percentiles) {
  const RockNumber number{2.0, 5.0};
  BOOST_TEST(number.at(1.6448536269514722) == 2.0, boost::test_tools::tolerance(1e-14));
  BOOST_TEST(number.at(2.3263478740408408) == 5.0, boost::test_tools::tolerance(1e-14));
  BOOST_TEST((RockNumber{3.0, 3.0}).at(-1.0) == 3.0);
}

BOOST_AUTO_TEST_CASE(wrong_files_are_refused_by_key) {
  const Folder folder;
  folder.file("short.csv", "mass [kg],speed [m/s]\n1,1\n");
  folder.file("zero.csv", "mass [kg],speed [m/s],height [m]\n1,1,1\n0,1,1\n");
  folder.file("metres.csv", "mass [m],speed [m/s],height [m]\n1,1,1\n");
  folder.file("good.csv", "mass [kg],speed [m/s],height [m]\n1,1,1\n");
  folder.file("empty.csv", "mass [kg],speed [m/s],height [m]\n");
  std::string spins = "\"0 rad/s\"";
  for (int i = 1; i <= 100; ++i)
    spins += ", \"" + std::to_string(i) + " rad/s\"";
  const std::vector<std::pair<std::string, std::string>> wrong{
      {"base = \"f.toml\"\n" + speed, "c.toml:1: mass: it is missing"},
      {"base = \"f.toml\"\nmass = [\"2 kg\", \"1 kg\"]\n" + speed,
       "c.toml:2: mass: found [\"2 kg\", \"1 kg\"]; both must be > 0, the first less than the second"},
      {head + "height = []\n", "c.toml:4: height: found []; it must have a quantity"},
      {head + "height = [3]\n", "c.toml:4: height[0]: found 3; the unit is missing; write e.g. \"3 m\""},
      {head + "height = [\"1 400\"]\n",
       "c.toml:4: height[0]: found \"1 400\"; '400' is not a unit; write e.g. \"1 m\""},
      {head + "height = [\"1 m\", \"100 cm\"]\n",
       "c.toml:4: height: found [\"1 m\", \"100 cm\"], with one value twice; remove it"},
      {head + "height = [\"-1 m\"]\n", "c.toml:4: height[0]: found \"-1 m\"; it must be > 0"},
      {head + "height = \"1 m\"\nspin = [" + spins + "]\n",
       "c.toml:4: height: with `spin` and `along` there are 101 maps; there may be at most 100"},
      {head + "[hazard]\ntable = \"good.csv\"\nalong = [\"1 m\"]\n",
       "c.toml:6: hazard: along: found [\"1 m\"]; it must be an array of 2 quantities, e.g. [\"1 m\", \"2 m\"]"},
      {head + "set = 3\n", "c.toml:4: set: it must be a table of fields of the base with their values"},
      {head + "[map]\ncells = 24\nfirst_cells = 5\n",
       "c.toml:5: map: cells: found 24 cells, 5 at first; the first must be a power of two times the second"},
      {head + "set = { \"fence.column.held\" = [\"x\"] }\n",
       "c.toml:4: set: fence.column.held: found [\"x\"]; it must be a number, a text, true or false"},
      {head + "[changes]\nspeed = 0.0\n",
       "c.toml:4: changes: all are 0, so that the runs of a node would be the same; give one that is > 0"},
      {head + "[limits]\ntime = \"1 s\"\n",
       "c.toml:5: limits: time: results would depend on the machine; give `evaluations`"},
      {head + "[map]\nfew_runs = 21\n", "c.toml:5: map: few_runs: found 21; it must be at most the runs of a node, 20"},
      {head + "[hazard]\nmass = \"1 kg\"\nheight = \"1 m\"\nspeed = { p95 = \"2 m/s\", p99 = \"1 m/s\" }\n",
       "c.toml:7: hazard: speed: p99: found \"1 m/s\", less than the percentile of 95 %, \"2 m/s\"; "
       "it must be at least that"},
      {head + "[hazard]\ntable = \"short.csv\"\n",
       "c.toml:5: hazard: table: short.csv: the column height is missing; give it"},
      {head + "[hazard]\ntable = \"zero.csv\"\n",
       "c.toml:5: hazard: table: zero.csv:3: column 'mass [kg]': found '0'; it must be > 0"},
      {head + "[hazard]\ntable = \"metres.csv\"\n",
       "c.toml:5: hazard: table: metres.csv: column 'mass [m]': found \"1 m\"; that is a length; it must be a mass, "
       "e.g. "
       "\"1 kg\""},
      {head + "[hazard]\ntable = \"empty.csv\"\n",
       "c.toml:5: hazard: table: empty.csv: found no line below the header; there must be one for each row"},
      {head + "[hazard]\ntable = \"good.csv\"\nspeed = \"1 m/s\"\n",
       "c.toml:6: hazard: speed: the rows of the table give it"}};
  for (const auto& [text, expected] : wrong)
    BOOST_TEST(message(text, folder) == expected);
}

BOOST_AUTO_TEST_CASE(a_wrong_number_is_one_error) {
  const Folder folder;
  const std::string base = "base = \"f.toml\"\n";
  BOOST_TEST(message(base + "mass = [600, 2400]\n" + speed, folder) ==
             "c.toml:2: mass[0]: found 600; the unit is missing; write e.g. \"600 kg\"\n"
             "c.toml:2: mass[1]: found 2400; the unit is missing; write e.g. \"2400 kg\"");
  BOOST_TEST(message(base + "mass = \"1 kg\"\n" + speed, folder) ==
             "c.toml:2: mass: found \"1 kg\"; it must be an array of 2 quantities, e.g. [\"1 kg\", \"2 kg\"]");
  const std::string hazard = head + "[hazard]\nspeed = \"1 m/s\"\nheight = \"1 m\"\n";
  BOOST_TEST(message(hazard + "mass = { p95 = \"2 kg\" }\n", folder) == "c.toml:7: hazard: mass: p99: it is missing");
  BOOST_TEST(message(hazard + "mass = \"2 kg\"\nspin = [\"5 rad/s\", 3]\n", folder) ==
             "c.toml:8: hazard: spin[1]: found 3; the unit is missing; write e.g. \"3 rad/s\"");
  BOOST_TEST(message("base = \"\"\n" + mass + speed, folder) ==
             "c.toml:1: base: found \"\"; it must be the name of a file, in quotes");
}

BOOST_AUTO_TEST_SUITE_END()
