#include "solver/app/sweep/swept_cell.hpp"

#include <boost/test/unit_test.hpp>
#include <string>

#include "solver/base/error.hpp"
#include "solver/io/cell/write_cell.hpp"
#include "tests/solver/app/program.hpp"

BOOST_AUTO_TEST_SUITE(swept_cell_tests)

using namespace talus;

BOOST_AUTO_TEST_CASE(means_have_standard_errors_and_groups_have_none) {
  const TomlValue document = parse_toml(talus::read_text(scene("cell/ice.toml")), "ice.toml");
  const CellScene cell = read_cell(document, "ice.toml", {});
  CellRun run{cell.cell, cell.plan};
  app::SweptCell swept{document, "ice.toml"};
  const auto has = [&](const std::string& name) {
    try {
      swept.choose({"cell." + name});
    } catch (const InputError& error) {
      BOOST_TEST(holds(error.what(), "number of a cell 'cell." + name + "' is not known"), error.what());
      return false;
    }
    return true;
  };
  for (const CellNumber& group : cell_groups(cell, run))
    BOOST_TEST((has(group.name) && !has(group.name + ".error")), group.name);
  for (const CellNumber& result : cell_results(run))
    BOOST_TEST((has(result.name) && has(result.name + ".error")), result.name);
}

BOOST_AUTO_TEST_SUITE_END()
