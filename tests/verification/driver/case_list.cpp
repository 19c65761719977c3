/// All cases compared with the catalogue, without running them.
#include "verification/driver/case_list.hpp"

#include <algorithm>
#include <boost/test/unit_test.hpp>
#include <filesystem>
#include <regex>
#include <set>

#include "verification/driver/case_error.hpp"
#include "verification/record/audits.hpp"
#include "verification/record/whole_file.hpp"

BOOST_AUTO_TEST_SUITE(case_list_tests)

using namespace talus::verification;

namespace {

const Catalogue& catalogue() {
  static const Catalogue read = read_catalogue(TALUS_CATALOGUE);
  return read;
}
const std::vector<Case>& cases() {
  static const std::vector<Case> all = all_cases();
  return all;
}

/// The works cited by cases, checks of other codes or other works.
std::set<std::string> cited_works() {
  std::set<std::string> cited;
  const auto add = [&](const std::string& text) {
    const auto keys = citations_in(text, catalogue().bibliography).keys;
    cited.insert(keys.begin(), keys.end());
  };
  for (const Case& c : cases())
    add(c.source + "; " + c.page);
  for (const PeerCheck& peer : catalogue().peers) {
    cited.insert(peer.suite);
    add(peer.what + "; " + peer.form + "; " + peer.remark);
  }
  for (const Reference& work : catalogue().bibliography.works) {
    for (const Reference& other : catalogue().bibliography.works) {
      if (other.field("note").find(work.key) != std::string::npos) cited.insert(work.key);
    }
  }
  return cited;
}

}  // namespace

BOOST_AUTO_TEST_CASE(all_cases_are_well_formed) {
  BOOST_TEST(!cases().empty());
  for (const Case& c : cases())
    BOOST_TEST(case_error(c, cases(), catalogue()) == "", c.id);
}

BOOST_AUTO_TEST_CASE(each_erratum_is_proved_by_a_case) {
  for (const Erratum& erratum : catalogue().errata) {
    const bool there =
        std::any_of(cases().begin(), cases().end(), [&](const Case& c) { return c.id == erratum.proved_by; });
    BOOST_TEST(there, erratum.id << ": no case " << erratum.proved_by);
  }
}

BOOST_AUTO_TEST_CASE(each_defect_has_its_case_or_test) {
  const std::vector<talus::records::Defect> defects = talus::records::read_audits({}, TALUS_AUDITS).defects;
  std::set<std::string> tests;
  for (const auto& entry : std::filesystem::recursive_directory_iterator{TALUS_TESTS}) {
    if (entry.path().extension() != ".cpp") continue;
    static const std::regex name(R"(BOOST_(AUTO|FIXTURE|DATA)_TEST_(SUITE|CASE)\((\w+))");
    const std::string text = talus::records::read_whole(entry.path());
    std::string suite;
    for (std::sregex_iterator it(text.begin(), text.end(), name), end; it != end; ++it) {
      if ((*it)[2] == "SUITE") {
        suite = (*it)[3].str() + "/";
      } else {
        tests.insert(suite + (*it)[3].str());
      }
    }
  }
  for (const talus::records::Defect& defect : defects) {
    // A Boost.Test, or the file of another test.
    if (!defect.test.empty())
      BOOST_TEST((tests.contains(defect.test) || std::filesystem::exists(TALUS_TESTS "/../" + defect.test)),
                 "no test " << defect.test);
    if (!defect.case_id.empty())
      BOOST_TEST(std::any_of(cases().begin(), cases().end(), [&](const Case& c) { return c.id == defect.case_id; }),
                 "no case " << defect.case_id);
  }
  BOOST_TEST(defects.size() >= 50U);
}

BOOST_AUTO_TEST_CASE(each_finding_and_highlight_is_of_a_case) {
  const auto known = [](const std::string& id) {
    return std::any_of(cases().begin(), cases().end(), [&](const Case& c) { return c.id == id; });
  };
  for (const CatalogueFinding& finding : catalogue().findings)
    BOOST_TEST(known(finding.case_id), finding.case_id);
  for (const CatalogueHighlight& highlight : catalogue().highlights)
    BOOST_TEST(known(highlight.case_id), highlight.case_id);
  BOOST_TEST(!catalogue().findings.empty());
  BOOST_TEST(catalogue().highlights.size() == 4u);  // the first page has room for two rows of two
}

BOOST_AUTO_TEST_CASE(each_work_is_cited_or_called_background) {
  const std::set<std::string> cited = cited_works();
  for (const Reference& work : catalogue().bibliography.works) {
    const bool background = work.field("keywords") == "background";
    BOOST_TEST(
        (cited.count(work.key) == 1u) != background,
        work.key << (background ? " is cited: it is no background" : " is cited nowhere: keywords = {background}"));
  }
}

BOOST_AUTO_TEST_SUITE_END()
