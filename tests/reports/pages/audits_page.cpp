#include "reports/pages/audits_page.hpp"

#include <boost/test/unit_test.hpp>

#include "reports/numbers.hpp"
#include "tests/temporary_folder.hpp"
#include "verification/record/error.hpp"

BOOST_AUTO_TEST_SUITE(audits_page_tests)

using namespace talus::reports;
using namespace talus::records;

namespace {

bool contains(const std::string& text, const std::string& part) { return text.find(part) != std::string::npos; }

constexpr const char* origins = R"({"audits": [{"audit": "fuzz", "revision": "0123456789", "date": "2026-02-03"}]})";

FuzzAudit fuzz(std::size_t findings) {
  return {7, {{"fence_toml", 1000, 100, 890, 10, 1.5, 0}, {"checkpoint", 2000, 0, 2000, 0, 2.5, findings}}};
}

std::string message_of(const std::filesystem::path& run, const std::filesystem::path& recorded) {
  try {
    (void)read_audits(run, recorded);
  } catch (const RecordError& error) {
    return error.what();
  }
  return "";
}

}  // namespace

BOOST_AUTO_TEST_CASE(readers_are_summed_and_findings_bold) {
  const std::string text = fuzz_text(fuzz(3));
  BOOST_TEST(contains(text, "| fence\\_toml | 1000 | 100 | 890 | 10 | 2 | 0 |"), text);
  BOOST_TEST(contains(text, "| **all** | 3000 | 100 | 2890 | 10 | 4 | **3** |"), text);
}

BOOST_AUTO_TEST_CASE(kills_are_counted) {
  const std::string text = faults_text({100, 46, 54, 3, 88, 87});
  BOOST_TEST(contains(text, "100 kills: 46 before the first checkpoint"), text);
  BOOST_TEST(contains(text, "54 later"), text);
  BOOST_TEST(contains(text, "**87 of 88 runs ended with the files of an undisturbed run, byte by byte.**"), text);
  BOOST_TEST(contains(text, "Kills left 3 temporary"), text);
}

BOOST_AUTO_TEST_CASE(files_with_lines_that_nothing_executes_are_listed) {
  const std::string text =
      lines_text({{{"solver/laws/hertz.cpp", 100, 100, 40, 39}, {"solver/laws/cone.cpp", 20, 18, 10, 5}}});
  BOOST_TEST(contains(text, "| solver/laws | 120 | 98.3 % | 50 | 88.0 % |"), text);
  BOOST_TEST(contains(text, "| **all** | 120 | 98.3 % | 50 | 88.0 % |"), text);
  BOOST_TEST(contains(text, "| solver/laws/cone.cpp | 20 | 90.0 % | 10 | 50.0 % |"), text);
  BOOST_TEST(!contains(text, "hertz"), text);
  BOOST_TEST(contains(lines_text({{{"solver/laws/hertz.cpp", 100, 95, 0, 0}}}), "No file has fewer"));
}

// An audit of the run itself comes before a recorded one, and only a recorded one has an origin.
BOOST_AUTO_TEST_CASE(audits_are_of_the_run_or_recorded) {
  const Folder run, recorded;
  BOOST_TEST(!read_audits(run.path, recorded.path).fuzz);
  write_fuzz(fuzz(1), recorded.path / "fuzz.json");
  BOOST_CHECK_THROW((void)read_audits(run.path, recorded.path), FileError);
  recorded.file("origins.json", R"({"audits": []})");
  BOOST_TEST(contains(message_of(run.path, recorded.path), "origins.json: audits: 'fuzz' is missing"));
  recorded.file("origins.json", origins);
  const Audits old = read_audits(run.path, recorded.path);
  BOOST_TEST(old.fuzz->readers.at(1).findings == 1U);
  BOOST_TEST(old.fuzz->seed == 7U);
  BOOST_TEST(origin_text(old, "fuzz", "make fuzz") ==
             "*Recorded on 2026-02-03 at revision 0123456789, not measured in this run; `make fuzz` repeats it.*\n\n");
  write_fuzz(fuzz(0), run.path / "fuzz.json");
  const Audits now = read_audits(run.path, recorded.path);
  BOOST_TEST(now.fuzz->readers.at(1).findings == 0U);
  BOOST_TEST(contains(origin_text(now, "fuzz", "make fuzz"), "The last result of `make fuzz` in this build"));
}

BOOST_AUTO_TEST_CASE(defects_are_listed_by_area) {
  const Folder recorded;
  recorded.file("defects.json", R"({"defects": [
    {"what": "A sign was wrong.", "area": "physics", "found_by": "case", "commit": "0123456789", "case": "column", "test": ""},
    {"what": "A file was lost.", "area": "files", "found_by": "fault test", "commit": "0123456789", "case": "",
     "test": "faults_tests/a_full_disk"}]})");
  const std::string text = defects_text(read_audits({}, recorded.path).defects, {});
  BOOST_TEST(contains(text, "| case | 0 | 1 | 1 |"), text);
  BOOST_TEST(contains(text, "## Physics"), text);
  BOOST_TEST(contains(text, "| A sign was wrong. | case | column |"), text);
  BOOST_TEST(contains(text, "| faults: a full disk |"), text);
  recorded.file("defects.json", R"({"defects": [{"what": "a", "area": "b", "found_by": "c", "commit": "d", "case": "",
                                                "test": ""}]})");
  BOOST_TEST(contains(message_of({}, recorded.path), "defects.json: defects.defects[0]: must have either a case or a"));
}

BOOST_AUTO_TEST_CASE(a_wrong_audit_is_refused) {
  const Folder run;
  run.file("faults.json", R"({"schema": "talus faults 1", "kills": -1})");
  BOOST_TEST(contains(message_of(run.path, {}), "faults.json: faults.kills: must be"));
  std::filesystem::remove(run.path / "faults.json");
  run.file("rounding.json", R"({"schema": "talus rounding 1", "modes": ["upward"],
                                "kinds": [{"kind": "exact", "checks": 1, "failed": []}], "checks": []})");
  BOOST_TEST(contains(message_of(run.path, {}), "must have one result for each of the modes"));
}

// The report is checked: sums and fractions of audits are derived from their records.
BOOST_AUTO_TEST_CASE(numbers_of_audits_are_in_their_records) {
  const Folder run, recorded;
  std::filesystem::copy(std::filesystem::path(TALUS_TEST_DATA) / "pass" / "results.json", run.path);
  write_fuzz(fuzz(3), recorded.path / "fuzz.json");
  write_faults({1000, 460, 540, 300, 880, 870}, recorded.path / "faults.json");
  write_inputs({{{"published/a.csv", "case", 1203, 1202}, {"published/b.csv", "case", 1310, 1310}}},
               recorded.path / "inputs.json");
  recorded.file("lines.json", R"({"files": [
    {"filename": "solver/laws/hertz.cpp", "line_total": 1000, "line_covered": 999, "branch_total": 400, "branch_covered": 397},
    {"filename": "solver/laws/cone.cpp", "line_total": 300, "line_covered": 280, "branch_total": 0, "branch_covered": 0}]})");
  recorded.file("origins.json",
                R"({"audits": [{"audit": "fuzz", "revision": "4444444444", "date": "2026-02-03"},
                               {"audit": "faults", "revision": "4444444444", "date": "2026-02-03"},
                               {"audit": "inputs", "revision": "4444444444", "date": "2026-02-03"},
                               {"audit": "lines", "revision": "4444444444", "date": "2026-02-03"}]})");
  const Audits audits = read_audits(run.path, recorded.path);
  const std::string text = fuzz_text(*audits.fuzz) + faults_text(*audits.faults) + inputs_text(*audits.inputs) +
                           lines_text(*audits.lines) + origin_text(audits, "fuzz", "make fuzz");
  const auto unfounded = [&](const std::string& of) {
    return unfounded_numbers(of, numbers_of_records(run.path, TALUS_TEMPLATES, recorded.path)).size();
  };
  BOOST_TEST(unfounded(text) == 0U);
  BOOST_TEST(contains(text, "| **all** | – | 2513 | **2512** |"), text);
  BOOST_TEST(unfounded("98.77 % of 777 lines") == 2U);
}

BOOST_AUTO_TEST_SUITE_END()
