#include "verification/check/evidence.hpp"

#include <boost/test/unit_test.hpp>

BOOST_AUTO_TEST_SUITE(evidence_tests)

using namespace talus::verification;

namespace {

bool refused(const std::string& page, const std::string& expected) {
  const EvidenceParagraph found = evidence_of(page);
  BOOST_TEST_INFO(found.error);
  return found.error.find(expected) != std::string::npos;
}

}  // namespace

BOOST_AUTO_TEST_CASE(the_paragraph_names_kinds_and_limits) {
  const EvidenceParagraph found = evidence_of(
      "**Conclusion.** Yes.\n\n**Evidence.** Closed form, independent\nintegration, property. Not shown: "
      "friction;\nspin "
      "at $e = 0.5$.\n\n**What would break it.** All.\n");
  BOOST_TEST(found.error.empty(), found.error);
  BOOST_TEST(
      (found.kinds == std::vector{Evidence::closed_form, Evidence::independent_integration, Evidence::property}));
  BOOST_TEST(found.not_shown == "friction; spin at $e = 0.5$.");
  BOOST_TEST(text_of(found) ==
             "**Evidence.** Closed form, independent integration, property. Not shown: friction; spin at $e = 0.5$.\n");
}

BOOST_AUTO_TEST_CASE(limits_are_plain_text_with_formulas) {
  const std::string page = "**Evidence.** Property. Not shown: Hertz\\'s law \\<b\\>; $\\mu\\,g$ \\$.";
  BOOST_TEST(evidence_of(page).not_shown == "Hertz's law <b>; $\\mu\\,g$ $.");
}

BOOST_AUTO_TEST_CASE(every_kind_is_read_back) {
  for (const auto& [kind, name] : talus::records::Names<Evidence>::values) {
    const EvidenceParagraph found = evidence_of(text_of({{kind}, "more.", ""}));
    BOOST_TEST(found.error.empty(), found.error);
    BOOST_TEST((found.kinds == std::vector{kind}), name);
  }
}

BOOST_AUTO_TEST_CASE(an_incomplete_paragraph_is_refused) {
  const std::string none = "it has no paragraph **Evidence.**";
  BOOST_TEST(refused("", none));
  BOOST_TEST(refused("Text with **Evidence.** Property. Not shown: more.", none));
  BOOST_TEST(refused("**Evidence.** ", none));
  BOOST_TEST(refused("**Evidence.** Hearsay. Not shown: more.",
                     "evidence 'hearsay' is not known; known: measurement, closed form"));
  BOOST_TEST(refused("**Evidence.** Property, closed form. Not shown: more.",
                     "evidence 'closed form' is behind 'property'; the order must be: measurement, closed form"));
  BOOST_TEST(refused("**Evidence.** Property, property. Not shown: more.", "'property' is behind 'property'"));
  BOOST_TEST(refused("**Evidence.** Property.", "followed by ''; it must be 'Not shown: '"));
  BOOST_TEST(refused("**Evidence.** Property. Unknown: more.", "followed by 'Unknown: more.'"));
  BOOST_TEST(refused("**Evidence.** Property. Not shown: more", "followed by 'Not shown: more'"));
}

BOOST_AUTO_TEST_SUITE_END()
