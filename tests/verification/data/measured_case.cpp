/// Cases made from measurements, against sets whose deviations and uncertainties are known.
#include "verification/data/measured_case.hpp"

#include <boost/test/unit_test.hpp>
#include <cmath>

#include "tests/verification/data/measured_files.hpp"
#include "tests/verification/driver/text_parts.hpp"
#include "verification/driver/case_run.hpp"

BOOST_AUTO_TEST_SUITE(measured_case_tests)

using namespace talus::verification;
namespace records = talus::records;

namespace {

/// Heights that deviate from the flight by these numbers, in units of the uncertainty of the comparison: data 0.03 m,
/// speed 0.04 m/s for 0.5 s, model 0.02 m.
struct Heights {
  std::vector<double> deviations;

  [[nodiscard]] std::string csv() const {
    std::string text = "speed [m/s],height [m],u\n";
    const double uncertainty = std::sqrt(0.03 * 0.03 + 0.02 * 0.02 + 0.02 * 0.02);
    for (std::size_t i = 0; i < deviations.size(); ++i) {
      const double speed = 3.0 + 0.5 * static_cast<double>(i);
      text += std::to_string(speed) + "," + std::to_string(1.0 + 0.5 * speed - 1.25 - uncertainty * deviations[i]) +
              ",0.03\n";
    }
    return text;
  }
};

records::Record record_of(const MeasuredFolder& folder) {
  return run_case(measured_case(read_measured_set(folder.set())), records::Tier::quick);
}

const records::Check& check(const records::Record& record, const std::string& part) {
  for (const records::Check& each : record.checks) {
    if (holds_text(each.name, part)) return each;
  }
  throw std::runtime_error{"no check " + part + ": " + record.message};
}

}  // namespace

// The bounds are tabulated quantiles: chi squared with 5 degrees of freedom 15.086 at 99 %; the normal distribution
// 2.576 at 99.5 %, 3.089 at 1 - (1 - 0.99^(1/5))/2.
BOOST_AUTO_TEST_CASE(deviations_are_measured_in_their_uncertainty) {
  const Heights heights{{1.0, -2.0, 0.5, 1.5, -0.5}};
  const records::Record record = record_of(MeasuredFolder{heights.csv()});
  BOOST_TEST(record.message == "");
  BOOST_TEST((record.status == records::Status::pass));
  BOOST_TEST((record.evidence == std::vector{records::Evidence::measurement}));
  const double printed = 1e-4;  // std::to_string has six decimals
  const auto expect = [&](const char* part, double measured, double bound) {
    BOOST_TEST(check(record, part).measured == measured, boost::test_tools::tolerance(printed));
    BOOST_TEST(check(record, part).bound == bound, boost::test_tools::tolerance(1e-3));
  };
  expect("root mean square", std::sqrt(7.75 / 5.0), std::sqrt(15.086 / 5.0));
  expect("largest deviation", 2.0, 3.089);
  expect("mean of deviation", 0.1, 2.576 / std::sqrt(5.0));
  BOOST_TEST(check(record, "half the step").measured < 1e-9);
  BOOST_TEST(record.controls.at(0).pass());
  const std::vector<std::string> row{"2", "3.5", "1.5825", "1.5", "0.03", "0.02", "0", "0.02", "-2.00"};
  const std::vector<std::string>& found = record.tables.at(0).rows.at(1);
  for (std::size_t i = 0; i < row.size(); ++i) {
    if (i != 6) BOOST_TEST(found.at(i) == row[i]);
  }
  BOOST_TEST(std::abs(std::stod(found.at(6))) < 1e-9);
  const records::Series& data = record.figures.at(0).series.at(0);
  BOOST_TEST(data.y_high.at(1) - data.y.at(1) == 2.0 * std::sqrt(0.0017), boost::test_tools::tolerance(1e-6));
  BOOST_TEST(data.y.at(1) - data.y_low.at(1) == 2.0 * std::sqrt(0.0017), boost::test_tools::tolerance(1e-6));
  BOOST_TEST(record.figures.at(0).series.at(1).y.at(1) == 1.5, boost::test_tools::tolerance(1e-9));
}

BOOST_AUTO_TEST_CASE(each_check_fails_for_what_it_tests) {
  const auto red = [](const std::vector<double>& deviations, const std::string& part) {
    const records::Record record = record_of(MeasuredFolder{Heights{deviations}.csv()});
    std::string names;
    for (const records::Check& each : record.checks) {
      if (!each.pass) names += each.name + "; ";
    }
    BOOST_TEST(!check(record, part).pass, names);
  };
  red({0.0, 0.0, 3.2, 0.0, 0.0}, "largest deviation");
  red({1.3, 1.3, 1.3, 1.3, 1.3}, "mean of deviation");
  red({2.0, -2.0, 2.0, -2.0, 1.0}, "root mean square");
}

// Euler errs by g t h/2 in height, and changes by half of that with half the step: 1.25 mm.
BOOST_AUTO_TEST_CASE(a_coarse_step_is_noticed) {
  const std::string scene = with(with(flight_scene, "\"velocity_verlet\"", "\"euler\""), "1e5 N/m", "1 N/m");
  const std::string set = with(flight_set, "uncertainty = \"u\"", "uncertainty = 0.003");
  const records::Record record = record_of(MeasuredFolder{Heights{{0.0, 0.0, 0.0}}.csv(), set, scene});
  BOOST_TEST(!check(record, "half the step").pass);
  BOOST_TEST(check(record, "half the step").measured == 0.00125 / 0.003, boost::test_tools::tolerance(1e-6));
}

// A ball that bounces, by methods without a step: one has a tolerance, the other no error.
BOOST_AUTO_TEST_CASE(the_error_of_a_method_is_that_of_its_tolerance) {
  const auto record = [](const std::string& method) {
    std::string scene = with(flight_scene, "\"0 m\", \"-9 m\"", "\"0 m\", \"0.5 m\"");
    scene = with(with(scene, "\"velocity_verlet\"\nstep = \"1 ms\"", method), "1e5 N/m", "2e4 N/m");
    scene = with(scene, "end = \"0.5 s\"", "end = \"1.2 s\"");
    return record_of(MeasuredFolder{Heights{{0.0, 0.0}}.csv(), flight_set, scene});
  };
  const records::Record coarse = record("\"stormer_cowell\"\ntolerance = 1e-3");
  const records::Record fine = record("\"stormer_cowell\"\ntolerance = 1e-9");
  BOOST_TEST(check(coarse, "tenth of the tolerance").measured > 1e-4);
  BOOST_TEST(check(fine, "tenth of the tolerance").measured < 1e-5);
  BOOST_TEST(check(fine, "tenth of the tolerance").measured > 0.0);
  const records::Record exact = record("\"exact\"");
  BOOST_TEST(exact.checks.size() == 3U, exact.message);
}

BOOST_AUTO_TEST_CASE(results_have_names_and_units) {
  const auto message = [](const std::string& result, const std::string& column = "height [m]") {
    const std::string csv = "speed [m/s]," + column + ",u\n4,1.76,0.01\n6,2.74,0.02\n";
    const std::string set = with(with(flight_set, "final.ball.y", result), "height [m]", column);
    return record_of(MeasuredFolder{csv, set}).message;
  };
  const auto says = [&](const std::string& found, const std::string& text) {
    BOOST_TEST(holds_text(found, text), found);
  };
  says(message("last.ball.y"), "quantity 'height': result: result 'last' is not known");
  says(message("final.ball.z"), "column of history.csv 'ball.z' is not known; nearest: ball.");
  says(message("maximum.ball.z"), "extreme 'ball.z' is not known");
  says(message("impact.1.fall.restitution"),
       "found impact '1' of 'fall'; give one of the 0 impacts of this contact in the run");
  says(message("final.ball.vy"), "the result is in 'm/s', the column 'height [m]' in 'm'; they must be the same");
  says(message("final.ball.y / initial.ball.vy"), "the result is in 'm / m/s'");
  for (const char* result : {"maximum.ball.y", "minimum.ball.y", "initial.ball.y", "maximum_time.ball.y"}) {
    const std::string column = std::string{result}.find("time") == std::string::npos ? "height [m]" : "time [s]";
    BOOST_TEST(!holds_text(message(result, column), "result"), result);
  }
}

BOOST_AUTO_TEST_CASE(a_run_that_fails_names_its_row) {
  const records::Record record = record_of(
      MeasuredFolder{"speed [m/s],height [m],u\n4,1.76,0.01\n6,2.74,0.02\n",
                     with(flight_set, "gravity[1]\"\nvalue = \"-3.7 m/s^2\"", "run.step\"\nvalue = \"-1 ms\"")});
  BOOST_TEST(holds_text(record.controls.at(0).message, "row 1 of the data: talus run ended with 2"),
             record.controls.at(0).message);
}

BOOST_AUTO_TEST_SUITE_END()
