#include <boost/test/unit_test.hpp>
#include <cstdlib>
#include <limits>
#include <nlohmann/json.hpp>
#include <numbers>

#include "solver/io/output/write_history.hpp"
#include "solver/io/output/write_plot.hpp"
#include "solver/io/output/write_summary.hpp"

BOOST_AUTO_TEST_SUITE(run_record_tests)

using namespace talus;

namespace {

RunRecord record() {
  RunRecord made;
  made.title = "A \"title\"";
  made.units = us;
  made.integrator = "rk4";
  made.plan = {0.1, 1.0, 0.1, true};
  made.outcome.time = 1.0;
  made.steps = 10;
  made.evaluations = 40;
  made.bodies = {{"rock", {1.0 / 3.0, -2.0}, 0.5, {3.0, 4.0}, 5.0}};
  made.accounts.energies.kinetic = 2.5;
  made.history.columns = {{"time", dimension::time},
                          {"rock.x", dimension::length},
                          {"hit.force", dimension::force},
                          {"energy.kinetic", dimension::energy}};
  made.history.rows = {{0.0, 1.0 / 3.0, 0.0, 1e-300}, {0.1, std::numbers::pi, 0.0, 6.02e23}};
  made.extremes = {{made.history.columns[1], {1.0 / 3.0, 0.0, std::numbers::pi, 0.1}}};
  return made;
}

}  // namespace

BOOST_AUTO_TEST_CASE(csv_has_units_and_gives_the_same_doubles_back) {
  const RunRecord made = record();
  const std::string text = csv(made.history, made.units);
  BOOST_TEST(text ==
             "time [s],rock.x [ft],hit.force [lbf],energy.kinetic [lbf ft]\n"
             "0,0.3333333333333333,0,1e-300\n"
             "0.1,3.141592653589793,0,6.02e+23\n");
  BOOST_TEST(std::strtod("0.3333333333333333", nullptr) == 1.0 / 3.0);
}

BOOST_AUTO_TEST_CASE(summary_holds_every_number_to_the_bit) {
  const RunRecord made = record();
  const auto json = nlohmann::json::parse(summary_json(made));
  BOOST_TEST(json.at("title").get<std::string>() == made.title);
  BOOST_TEST(json.at("outcome").at("kind").get<std::string>() == "finished");
  BOOST_TEST(json.at("bodies").at(0).at("position").at(0).get<double>() == 1.0 / 3.0);
  BOOST_TEST(json.at("ledger").at("energy").at("kinetic").get<double>() == 2.5);
  BOOST_TEST(json.at("units").at("energy").get<std::string>() == "lbf ft");
  BOOST_TEST(json.at("extremes").at(0).at("maximum").get<double>() == std::numbers::pi);
  BOOST_TEST(json.at("steps").get<long>() == 10);
}

BOOST_AUTO_TEST_CASE(what_is_not_finite_is_written_as_text) {
  RunRecord made = record();
  made.outcome = {Outcome::Kind::diverged, 0.5, "diverged at t = 0.5"};
  made.accounts.energy_balance_error = std::numeric_limits<double>::quiet_NaN();
  made.accounts.energies.kinetic = std::numeric_limits<double>::infinity();
  const auto json = nlohmann::json::parse(summary_json(made));
  BOOST_TEST(json.at("ledger").at("energy_balance_error").get<std::string>() == "nan");
  BOOST_TEST(json.at("ledger").at("energy").at("kinetic").get<std::string>() == "inf");
  BOOST_TEST(json.at("outcome").at("message").get<std::string>() == "diverged at t = 0.5");
}

BOOST_AUTO_TEST_CASE(a_ledger_that_is_off_is_said) {
  RunRecord made = record();
  made.plan.ledger = false;
  BOOST_TEST(nlohmann::json::parse(summary_json(made)).at("ledger").get<std::string>() == "off");
}

BOOST_AUTO_TEST_CASE(final_state) {
  const auto json = nlohmann::json::parse(final_state_json(record()));
  BOOST_TEST(json.at("time").get<double>() == 1.0);
  BOOST_TEST(json.at("bodies").at(0).at("spin").get<double>() == 5.0);
}

// Curves that are zero throughout are omitted, and so are figures without curves.
BOOST_AUTO_TEST_CASE(plots_name_the_columns_of_the_csv) {
  const auto json = nlohmann::json::parse(plot_json(record(), "history.csv", {{"history.csv"}, "scene.pvd", {}, {}}));
  BOOST_TEST(json.at("figures").size() == 2U);
  const auto& figure = json.at("figures").at(0);
  BOOST_TEST(figure.at("name").get<std::string>() == "positions");
  BOOST_TEST(figure.at("csv").get<std::string>() == "history.csv");
  BOOST_TEST(figure.at("y").at("unit").get<std::string>() == "ft");
  BOOST_TEST(figure.at("series").at(0).at("y").get<std::string>() == "rock.x [ft]");
  BOOST_TEST(json.at("figures").at(1).at("name").get<std::string>() == "energies");
}

BOOST_AUTO_TEST_SUITE_END()
