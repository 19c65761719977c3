/// Every number of the report is one of its records, or a sum of such numbers.
#include "reports/numbers.hpp"

#include <boost/test/unit_test.hpp>
#include <filesystem>
#include <string>
#include <vector>

#include "tests/reports/report_program.hpp"
#include "tests/temporary_folder.hpp"
#include "verification/record/whole_file.hpp"

BOOST_AUTO_TEST_SUITE(numbers_tests)

namespace fs = std::filesystem;
using namespace talus::reports;

namespace {

const fs::path templates = TALUS_TEMPLATES;

}  // namespace

BOOST_AUTO_TEST_CASE(every_number_of_the_report_is_in_the_results) {
  for (const char* name : {"pass", "fail"}) {
    const Folder scratch;
    const fs::path verify = fs::path(TALUS_TEST_DATA) / name;
    write_markdown(verify, scratch.path);
    BOOST_TEST(count_of_numbers(talus::records::read_whole(scratch.path / "verification.md") +
                                talus::records::read_whole(scratch.path / "verification-details.md")) > 200U);
    for (const std::string& number : unfounded_numbers(verify, scratch.path, templates))
      BOOST_ERROR(name << ": " << number);
  }
}

BOOST_AUTO_TEST_CASE(a_number_that_is_not_in_the_results_is_found) {
  const Folder scratch;
  const std::string verify = (fs::path(TALUS_TEST_DATA) / "pass").string(), report = scratch.path.string();
  write_markdown(verify, report);
  const Finished sound = program({verify, report, "--check"});
  BOOST_TEST(sound.status == 0, sound.messages);
  const fs::path volume = scratch.path / "verification.md";
  std::string text = talus::records::read_whole(volume);
  const std::string shown = "3.8266";
  const std::size_t at = text.find(shown);
  BOOST_TEST_REQUIRE(at != std::string::npos);
  talus::records::write_whole(volume, text.replace(at, shown.size(), "3.8276"));
  const Finished wrong = program({verify, report, "--check"});
  BOOST_TEST(wrong.status == 1);
  BOOST_TEST(wrong.messages ==
             "talus_report: numbers of the report that are not in the records:\n  verification.md: 3.8276\n");
  for (const char* option : {"--check", "--audits"}) {
    std::vector<std::string> command{"--plot", scratch.path.string(), option};
    if (option == std::string{"--audits"}) command.push_back(scratch.path.string());
    const Finished useless = program(command);
    BOOST_TEST(useless.status == 2);
    BOOST_TEST(useless.messages.find(std::string{option} + " requires VERIFY and REPORT") != std::string::npos);
  }
  BOOST_TEST(unfounded_numbers("rk4, a_12345, 2D and 3.14 [of](page-99999.html)", {3.1416}).empty());
  BOOST_TEST(unfounded_numbers("3.14, 3.15, 2.5e+03, 2.6e+03", {3.1416, 2512.0}).size() == 2U);
}

// Counts of the chapters on the interface and on roundings are derived from their records.
BOOST_AUTO_TEST_CASE(numbers_of_trials_are_in_their_records) {
  const Folder scratch;
  const fs::path verify = scratch.path / "verify";
  fs::copy(fs::path(TALUS_TEST_DATA) / "pass", verify, fs::copy_options::recursive);
  talus::records::write_whole(
      verify / "interface.json",
      R"({"items": [{"kind": "option", "status": "killed"}, {"kind": "option", "status": "killed"},
                    {"kind": "field", "status": "survived"}]})");
  const std::set<double> known = numbers_of_records(verify, templates);
  BOOST_TEST(unfounded_numbers("66.7 %, 100.0 %", known).empty());
  BOOST_TEST(unfounded_numbers("66.6 %", known).size() == 1U);
}

BOOST_AUTO_TEST_SUITE_END()
