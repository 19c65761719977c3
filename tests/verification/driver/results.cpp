#include "verification/driver/results.hpp"

#include <algorithm>
#include <boost/property_tree/ptree.hpp>
#include <boost/property_tree/xml_parser.hpp>
#include <boost/test/unit_test.hpp>
#include <cmath>
#include <cstdlib>
#include <map>
#include <nlohmann/json.hpp>
#include <sstream>

#include "tests/verification/driver/synthetic_cases.hpp"
#include "verification/driver/case_run.hpp"
#include "verification/driver/junit.hpp"
#include "verification/driver/provenance.hpp"
#include "verification/driver/terminal.hpp"

BOOST_AUTO_TEST_SUITE(results_tests)

using namespace talus::verification;

namespace {

nlohmann::json written(Results results) {
  complete(results, read_catalogue(TALUS_CATALOGUE));
  return nlohmann::json::parse(text_of(results));
}

Results one_case() {
  Results results;
  results.registered = {"a", "pivoted_cylinder"};
  results.selected = {"a"};
  results.records = {run_case(synthetic("a", sound), Tier::quick)};
  return results;
}

}  // namespace

BOOST_AUTO_TEST_CASE(the_date_follows_the_source_date) {
  ::setenv("SOURCE_DATE_EPOCH", "86400", 1);
  BOOST_TEST(provenance().date == "1970-01-02T00:00:00Z");
  ::unsetenv("SOURCE_DATE_EPOCH");
  BOOST_TEST(provenance().date > "2024");
}

BOOST_AUTO_TEST_CASE(the_provenance_names_build_and_machine) {
  const Provenance from = provenance();
  BOOST_TEST(!from.revision.empty());
  BOOST_TEST(from.flags.find("-ffp-contract=off") != std::string::npos);
  BOOST_TEST(!from.cpu.empty());
  BOOST_TEST(from.cores >= 1u);
  for (const auto& library : from.libraries)
    BOOST_TEST(!library.second.empty(), library.first);
  // The solver computes every sine and cosine with SLEEF.
  const auto sleef = std::find_if(from.libraries.begin(), from.libraries.end(),
                                  [](const auto& library) { return library.first == "SLEEF"; });
  BOOST_REQUIRE(sleef != from.libraries.end());
  BOOST_TEST(sleef->second.find_first_not_of("0123456789.") == std::string::npos, sleef->second);
}

BOOST_AUTO_TEST_CASE(a_selected_case_without_its_record_fails) {
  Results results = one_case();
  BOOST_TEST(holds(results));
  results.selected.push_back("b");
  BOOST_TEST(!holds(results));
  results.selected = {"b"};
  BOOST_TEST(!holds(results));
  results.selected.clear();
  results.records.clear();
  BOOST_TEST(!holds(results));
}

BOOST_AUTO_TEST_CASE(requirements_are_traced_and_open_ones_are_shown) {
  const auto json = written(one_case());
  bool traced = false;
  bool open = false;
  for (const auto& requirement : json.at("requirements")) {
    if (requirement.at("id") == "Eq. 14") {
      traced = requirement.at("cases") == nlohmann::json({"a"}) && requirement.at("checks") == 1 &&
               requirement.at("shown_by").at(0).at("checks") == nlohmann::json({"value"});
    }
    if (requirement.at("id") == "Eq. 18") open = requirement.at("cases").empty();
  }
  BOOST_TEST(traced);
  BOOST_TEST(open);
}

BOOST_AUTO_TEST_CASE(only_errata_of_registered_cases_are_printed) {
  const auto json = written(one_case());
  BOOST_TEST(!json.at("errata").empty());
  for (const auto& erratum : json.at("errata"))
    BOOST_TEST(erratum.at("case") == "pivoted_cylinder");
}

BOOST_AUTO_TEST_CASE(only_findings_and_figures_of_registered_cases_are_on_the_first_page) {
  Results results = one_case();
  complete(results, read_catalogue(TALUS_CATALOGUE));
  BOOST_TEST(!results.findings.empty());
  for (const auto& finding : results.findings)
    BOOST_TEST(finding.case_id == "pivoted_cylinder");
  for (const auto& shown : results.highlights)
    BOOST_TEST(shown.case_id == "pivoted_cylinder");
}

BOOST_AUTO_TEST_CASE(families_orders_and_peers_are_printed) {
  Results results = one_case();
  const auto json = written(results);
  BOOST_TEST(json.at("cases").at(0).at("family") == "founding problems");
  BOOST_TEST(json.at("families").back() == "speed and accuracy");
  for (const auto& requirement : json.at("requirements"))
    if (requirement.at("id") == "integrator.velocity_verlet") BOOST_TEST(requirement.at("order") == 2);
  for (const auto& peer : json.at("peers"))
    BOOST_TEST(peer.at("cases").empty());
  results.records[0].requirements.push_back({"C1", {"value"}});
  const auto shown = written(results);
  std::size_t found = 0;
  for (const auto& peer : shown.at("peers"))
    found += peer.at("cases").size();
  BOOST_TEST(found == 2u);  // MFiX's DEM04 and LAMMPS's sphere that slides until it rolls
}

// The report uses the references of a run without reading the sources again.
BOOST_AUTO_TEST_CASE(the_bibliography_is_recorded_as_it_is_in_the_file) {
  BOOST_TEST(written(one_case()).at("bibliography") == read_catalogue(TALUS_CATALOGUE).bibliography.text);
}

BOOST_AUTO_TEST_CASE(the_line_of_a_failed_check_shows_an_error_above_its_bound) {
  const Check check = compare("value", 1.0 + 1.0004 * 0.25, 1.0, Tolerance::model(0.25, "chosen"), "m");
  BOOST_TEST(!check.pass);
  BOOST_TEST(sentence("a", check) ==
             "a.value: measured 1.2501 m, reference 1 m, bound 0.25 m, error/bound 1.001 (chosen)");
  const Check relative = compare("value", 3.0, 2.0, Tolerance::truncation(0.25, 1.0, "chosen").relative(), "m");
  BOOST_TEST(sentence("a", relative) ==
             "a.value: measured 3 m, reference 2 m, bound 0.25 of the reference, error/bound 2 (chosen)");
}

BOOST_AUTO_TEST_CASE(xml_is_escaped) {
  BOOST_TEST(escaped("a<b & \"c\">\x01\n") == "a&lt;b &amp; &quot;c&quot;&gt;?&#10;");
}

// Read by an XML parser, which requires well-formed text.
BOOST_AUTO_TEST_CASE(junit_holds_times_that_add_up_and_the_numbers_of_each_check) {
  Record record = run_case(synthetic("a", sound), Tier::quick);
  record.seconds = 1.25;
  record.checks.push_back(compare("speed < \"c\" & finite", std::nan(""), 3.0, Tolerance::model(0.5, "chosen"), "m/s"));
  Record other = unfinished(synthetic("b", sound), Status::timeout, "stopped");
  other.seconds = 0.5;
  std::istringstream text(junit_of({record, other}));
  boost::property_tree::ptree tree;
  boost::property_tree::read_xml(text, tree);
  const auto& suites = tree.get_child("testsuites");
  BOOST_TEST(suites.get<double>("<xmlattr>.time") == 1.75);
  BOOST_TEST(suites.get<int>("<xmlattr>.tests") == 6);
  BOOST_TEST(suites.get<int>("<xmlattr>.failures") == 2);  // the check, and the control of b, which was not run
  BOOST_TEST(suites.get<int>("<xmlattr>.errors") == 1);
  std::map<std::string, std::map<std::string, std::string>> numbers;
  for (const auto& [tag, suite] : suites) {
    if (tag != "testsuite") continue;
    double sum = 0.0;
    for (const auto& [name, test] : suite) {
      if (name != "testcase") continue;
      const auto id = test.get<std::string>("<xmlattr>.classname") + "." + test.get<std::string>("<xmlattr>.name");
      const auto time = test.get<double>("<xmlattr>.time");
      sum += time;
      BOOST_TEST((time > 0.0) == (test.get<std::string>("<xmlattr>.name") == "run"), id);
      if (!test.get_child_optional("properties")) continue;
      for (const auto& [is, property] : test.get_child("properties"))
        numbers[id][property.get<std::string>("<xmlattr>.name")] = property.get<std::string>("<xmlattr>.value");
    }
    BOOST_TEST(sum == suite.get<double>("<xmlattr>.time"));
  }
  using Numbers = std::map<std::string, std::string>;
  const auto& value = numbers.at("a.value");  // it passes
  BOOST_TEST(value.at("measured") == "1.05");
  BOOST_TEST(value.at("reference") == "1");
  BOOST_TEST(std::stod(value.at("error")) == 0.05, boost::test_tools::tolerance(1e-12));
  BOOST_TEST(value.at("bound") == "0.1");
  BOOST_TEST(value.at("unit") == "1");
  BOOST_TEST(value.at("kind") == "model");
  const Numbers lost{{"measured", "nan"}, {"reference", "3"},    {"error", "nan"}, {"bound", "0.5"},
                     {"unit", "m/s"},     {"relative", "false"}, {"kind", "model"}};
  BOOST_TEST((numbers.at("a.speed < \"c\" & finite") == lost));
  BOOST_TEST(numbers.at("a.control: shifted").at("measured") == "2");
  BOOST_TEST(numbers.at("a.control: shifted").at("observed") == "red");
  BOOST_TEST((numbers.at("b.control: shifted") == Numbers{{"observed", "missing"}, {"check", "value"}}));
}

BOOST_AUTO_TEST_CASE(junit_holds_each_check_and_control_and_their_failures) {
  Record record = run_case(synthetic("a", sound), Tier::quick);
  BOOST_TEST(junit_of({record}).find("tests=\"3\" failures=\"0\" errors=\"0\"") != std::string::npos);
  BOOST_TEST(junit_of({record}).find("name=\"control: shifted\"") != std::string::npos);
  record = unfinished(synthetic("a", sound), Status::timeout, "stopped <late>");
  const std::string text = junit_of({record});
  BOOST_TEST(text.find("errors=\"1\"") != std::string::npos);
  BOOST_TEST(text.find("timeout: stopped &lt;late&gt;") != std::string::npos);
}

BOOST_AUTO_TEST_SUITE_END()
