#include "solver/app/sweep/sweep_file.hpp"

#include <array>
#include <boost/test/unit_test.hpp>
#include <cmath>
#include <map>
#include <set>
#include <string>

#include "solver/app/sweep/design.hpp"
#include "solver/app/sweep/sweep_result.hpp"
#include "solver/app/sweep/sweep_runs.hpp"
#include "solver/base/error.hpp"
#include "solver/base/units.hpp"
#include "tests/temporary_folder.hpp"

BOOST_AUTO_TEST_SUITE(sweep_file_tests)

using namespace talus;
using namespace talus::app;

namespace {

SweepFile sweep_of(const std::string& text) {
  return read_sweep("base = \"a.toml\"\noutputs = [\"x.end\"]\n" + text, "folder/test.toml");
}

std::string written(const TomlValue& value) { return found(value); }

}  // namespace

BOOST_AUTO_TEST_CASE(a_range_is_written_in_its_unit) {
  const SweepFile sweep = sweep_of("[[axis]]\nfield = \"f\"\nrange = [\"0.1 ft\", \"0.3 ft\"]\ncount = 3\n");
  BOOST_TEST(sweep.base.string() == "folder/a.toml");
  const SweptRuns made = swept_runs(sweep);
  BOOST_REQUIRE(made.runs.size() == 3U);
  BOOST_TEST(written(made.runs[0].parameters[0].second) == "\"0.1 ft\"");
  BOOST_TEST(written(made.runs[1].parameters[0].second) == "\"0.2 ft\"");
  BOOST_TEST(written(made.runs[2].parameters[0].second) == "\"0.3 ft\"");
}

BOOST_AUTO_TEST_CASE(columns_of_a_table_are_numbers_quantities_texts_or_flags) {
  const Folder folder;
  folder.file("t.csv", "method,h [s],count,factor,on,mixed\nrk4,1e-3,2,2.0,true,1\nexact,2e-3,3,0.5,false,two\n");
  const auto rows_of = [&](const std::string& heading) {
    const SweepFile sweep = read_sweep(
        "base = \"a.toml\"\noutputs = [\"x.end\"]\n[[axis]]\ntable = \"t.csv\"\n"
        "columns = { \"f\" = \"" +
            heading + "\" }\n",
        folder.path / "test.toml");
    return written(sweep.axes[0].rows[0][0]) + ", " + written(sweep.axes[0].rows[1][0]);
  };
  BOOST_TEST(rows_of("method") == "\"rk4\", \"exact\"");
  BOOST_TEST(rows_of("h [s]") == "\"0.001 s\", \"0.002 s\"");
  BOOST_TEST(rows_of("count") == "2, 3");
  BOOST_TEST(rows_of("factor") == "2.0, 0.5");
  BOOST_TEST(rows_of("on") == "true, false");
  BOOST_CHECK_EXCEPTION(static_cast<void>(rows_of("mixed")), InputError, [](const InputError& error) {
    return std::string{error.what()}.ends_with("t.csv:3: column 'mixed': found 'two'; it must be a finite number");
  });
}

BOOST_AUTO_TEST_CASE(whole_numbers_stay_whole_and_are_equally_frequent) {
  const SweepFile sweep =
      sweep_of("[design]\nkind = \"latin_hypercube\"\nruns = 300\n[[axis]]\nfield = \"f\"\nrange = [4, 6]\n");
  std::map<std::string, int> counts;
  for (const SweptRun& run : swept_runs(sweep).runs)
    ++counts[written(run.parameters[0].second)];
  BOOST_TEST(counts.size() == 3U);
  for (const char* value : {"4", "5", "6"})
    BOOST_TEST(counts[value] == 100);
}

BOOST_AUTO_TEST_CASE(quantiles_of_a_grid_are_in_the_middle_of_equal_parts) {
  const SweepFile sweep =
      sweep_of("[[axis]]\nfield = \"f\"\nquantiles = [[0, 0], [0.5, 1], [0.75, 1], [1, 5]]\ncount = 4\n");
  const SweptRuns made = swept_runs(sweep);
  std::vector<double> values;
  for (const SweptRun& run : made.runs)
    values.push_back(std::get<double>(run.parameters[0].second.data));
  const std::vector<double> expected{0.25, 0.75, 1.0, 3.0};
  BOOST_TEST(values == expected, boost::test_tools::per_element());
}

BOOST_AUTO_TEST_CASE(ids_follow_from_the_parameters) {
  const std::string axis = "[[axis]]\nfield = \"f\"\nvalues = [1, 2]\n[[axis]]\nfield = \"g\"\nvalues = ";
  const SweptRuns few = swept_runs(sweep_of(axis + "[\"a\", true]\n")),
                  more = swept_runs(sweep_of(axis + "[\"b\", true, \"a\", \"a\"]\n"));
  std::set<std::string> ids;
  for (const SweptRun& run : more.runs)
    ids.insert(run.id);
  BOOST_TEST(ids.size() == 8U);  // also of the runs that are there twice
  for (const SweptRun& run : few.runs)
    BOOST_TEST(ids.contains(run.id));
}

BOOST_AUTO_TEST_CASE(lines_of_the_manifest_are_read_back) {
  const SweptRuns made = swept_runs(
      sweep_of("[[axis]]\nfield = \"f\"\nvalues = [1, 2.5, \"3 kg\", true, \"a \\\"quoted\\\" \\u00e4\"]\n"));
  for (const SweptRun& run : made.runs) {
    const SweptRun again = run_of_line(manifest_line(run));
    BOOST_TEST(again.id == run.id);
    BOOST_TEST(again.parameters[0].first == "f");
    BOOST_TEST((again.parameters[0].second.data.index() == run.parameters[0].second.data.index()));
    BOOST_TEST(written(again.parameters[0].second) == written(run.parameters[0].second));
  }
  BOOST_CHECK_THROW(static_cast<void>(run_of_line("{}")), InputError);
}

BOOST_AUTO_TEST_CASE(lines_of_results_are_read_back) {
  const SweepResult result{"12", SweepEnd::unusable, "why", 0.1, 7, "stopped", {1.0 / 3.0, -0.0, 5e-324}};
  BOOST_TEST((result_of_line(result_line(result, "s"), "s") == result));
  const SweepResult without{"1", SweepEnd::finished, "", 0.0, 1, "", {NAN}};
  BOOST_TEST(std::isnan(result_of_line(result_line(without, "s"), "s").values.at(0)));
  BOOST_CHECK_THROW(static_cast<void>(result_of_line(result_line(result, "s"), "t")), InputError);
  BOOST_CHECK_THROW(static_cast<void>(result_of_line("{\"id\": 1}", "s")), InputError);
  BOOST_CHECK_THROW(static_cast<void>(result_of_line("[", "s")), InputError);
}

BOOST_AUTO_TEST_CASE(designs_depend_on_the_seed_alone) {
  for (const DesignKind kind : {DesignKind::sobol, DesignKind::latin_hypercube, DesignKind::random}) {
    const Design design{kind, 10, 3}, other{kind, 10, 4};
    BOOST_TEST((design_points(design, 2) == design_points(design, 2)));
    BOOST_TEST((design_points(design, 2) != design_points(other, 2)));
    for (const auto& point : design_points(design, 3)) {
      for (const double coordinate : point)
        BOOST_TEST((coordinate >= 0.0 && coordinate < 1.0));
    }
  }
  BOOST_CHECK_THROW(static_cast<void>(design_points({DesignKind::sobol, 2, 1}, 100000)), InputError);
}

// Of the thirds of an axis, three runs have each of the six orders equally often: chi-squared with 5 degrees of freedom
// exceeds 25.7 once in ten thousand times. A shuffle that is not uniform gives some 80.
BOOST_AUTO_TEST_CASE(a_latin_hypercube_has_all_orders_equally_often) {
  constexpr std::size_t axes = 6000;
  const auto points = design_points({DesignKind::latin_hypercube, 3, 7}, axes);
  std::map<std::array<int, 3>, double> orders;
  for (std::size_t axis = 0; axis < axes; ++axis) {
    std::array<int, 3> order{};
    for (std::size_t run = 0; run < 3; ++run)
      order.at(run) = static_cast<int>(3.0 * points[run][axis]);
    orders[order] += 1.0;
  }
  double chi_squared = 0.0;
  for (const auto& [order, count] : orders)
    chi_squared += (count - axes / 6.0) * (count - axes / 6.0) / (axes / 6.0);
  BOOST_TEST(orders.size() == 6U);
  BOOST_TEST(chi_squared < 25.7);
}

// A Sobol sequence extends: more runs have the same first points. Of two axes, 16 points have one in each of 4 x 4
// boxes (Sobol's property A').
BOOST_AUTO_TEST_CASE(a_sobol_sequence_extends_and_fills_boxes) {
  const auto few = design_points({DesignKind::sobol, 16, 5}, 2), more = design_points({DesignKind::sobol, 32, 5}, 2);
  std::set<std::pair<int, int>> boxes;
  for (std::size_t i = 0; i < few.size(); ++i) {
    BOOST_TEST((few[i] == more[i]));
    boxes.emplace(static_cast<int>(4.0 * few[i][0]), static_cast<int>(4.0 * few[i][1]));
  }
  BOOST_TEST(boxes.size() == 16U);
}

BOOST_AUTO_TEST_CASE(logarithmic_ranges_may_be_as_wide_as_doubles) {
  const SweptRuns made =
      swept_runs(sweep_of("[[axis]]\nfield = \"f\"\nrange = [1e-200, 1e200]\ncount = 3\nspacing = \"logarithmic\"\n"));
  BOOST_TEST(std::get<double>(made.runs[1].parameters[0].second.data) == 1.0, boost::test_tools::tolerance(1e-12));
}

BOOST_AUTO_TEST_CASE(a_limit_is_met_but_for_round_off) {
  const SweptRuns made = swept_runs(
      sweep_of("[[axis]]\nfield = \"f\"\nrange = [\"0.1 kg\", \"0.7 kg\"]\ncount = 7\n[[constraint]]\nfield = "
               "\"f\"\nat_least = \"0.1 kg\"\nfactor = 3\n"));
  BOOST_TEST(made.runs.size() == 5U);
}

BOOST_AUTO_TEST_CASE(a_written_number_has_its_unit) {
  for (const char* text : {"5 kg", "+5 kg", " 5 kg ", "5\tkg"}) {
    const WrittenNumber number = written_number({std::string{text}, 0});
    BOOST_TEST(number.value == 5.0);
    BOOST_TEST(number.unit == "kg");
  }
}

BOOST_AUTO_TEST_CASE(quantities_of_any_dimension) {
  const AnyQuantity speed = parse_any_quantity("10 ft/s", si);
  BOOST_TEST((speed.dimension == dimension::velocity));
  BOOST_TEST(speed.value == parse_quantity("10 ft/s", dimension::velocity, si));
  BOOST_TEST((parse_any_quantity("3", si).dimension == dimension::number));
  BOOST_CHECK_THROW(static_cast<void>(parse_any_quantity("fast", si)), InputError);
}

BOOST_AUTO_TEST_SUITE_END()
