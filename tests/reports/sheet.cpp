/// A fence's sheet from a record made by hand, whose numbers in feet, pounds and kips are easily recognized.
#include <algorithm>
#include <boost/test/unit_test.hpp>

#include "reports/base/error.hpp"
#include "reports/base/process.hpp"
#include "reports/sheet/sheet_tables.hpp"
#include "reports/sheet/sheet_verdict.hpp"
#include "tests/temporary_folder.hpp"
#include "verification/record/whole_file.hpp"

BOOST_AUTO_TEST_SUITE(sheet_tests)

using namespace talus::reports;
using talus::records::read_whole;
using talus::records::write_whole;
namespace fs = std::filesystem;

namespace {

const fs::path record_file = fs::path{TALUS_TEST_DATA} / "sheet" / "sheet.json";

using Row = std::vector<std::string>;

SheetTable table(const SheetRecord& record, const std::string& title) {
  for (SheetTable& found : fence_tables(record)) {
    if (found.title.rfind(title, 0) == 0) return found;
  }
  BOOST_FAIL("no table " + title);
  return {};
}

bool contains(const std::string& text, const std::string& part) { return text.find(part) != std::string::npos; }

std::string replaced(std::string text, const std::string& what, const std::string& by) {
  const std::size_t offset = text.find(what);
  BOOST_REQUIRE(offset != std::string::npos);
  return text.replace(offset, what.size(), by);
}

}  // namespace

BOOST_AUTO_TEST_CASE(numbers_in_both_systems) {
  const SheetRecord record = read_sheet(record_file);
  const SheetTable rocks = table(record, "Rocks");
  // 1000 lb; 13 m/s = 42.65 ft/s; 1 kJ = 737.56 ft lbf; exit 5 m/s.
  BOOST_TEST((rocks.rows.at(0) == Row{"rock", "453.6 (1000)", "13 (42.65)", "1 (0.7376)", "0.1000", "0.3000",
                                      "5 (16.4)", "0.25 (0.1844)", "75.0", "0.2000", "0.3048 (1)"}));
  BOOST_TEST(rocks.rows.at(1).at(4) == "never");
  // One kip, straight up, 5 kN s; the segment's 10 kip are 89 % of its limit; the bottom cable was never taut.
  BOOST_TEST((table(record, "Hangers").rows.at(0) == Row{"column1", "4.448 (1)", "0.2000", "50.0", "90", "5 (1.124)",
                                                         "44.48 (10)", "0.2100", "89.0", "slack", "", ""}));
  BOOST_TEST((table(record, "Anchors").rows.at(0) ==
              Row{"1, 5 m", "5 (1.124)", "0.2200", "0.00", "-0.60", "-0.80", "0.05 (0.01124)"}));
  BOOST_TEST(contains(table(record, "Anchors").note, "the same with -z"));
  BOOST_TEST((table(record, "Order").rows.at(0) == Row{"0.21100", "cable 'top1'", "yields"}));
  const SheetTable heights = table(record, "Heights");
  BOOST_TEST(
      (heights.rows.at(0) == Row{"lowest top joint (minimum)", "3.048 (10)", "1.524 (5)", "0.2000", "2 (6.562)"}));
  BOOST_TEST((heights.rows.at(1) ==
              Row{"gap below the columns (maximum)", "0.5 (1.64)", "0.75 (2.461)", "0.1000", "0.25 (0.8202)"}));
  BOOST_TEST(
      (heights.rows.at(2) == Row{"displacement of a column along x (maximum)", "", "1.5 (4.921)", "0.2500", ""}));
  const SheetTable energy = table(record, "Energy");
  BOOST_TEST(energy.rows.size() == 7U);  // energies that did not change and losses that are zero are omitted
  BOOST_TEST((energy.rows.at(2) == Row{"gained in height", "0.05 (0.03688)"}));
  BOOST_TEST((energy.rows.at(3) == Row{"gained in cables", "-0.001 (-0.0007376)"}));
  BOOST_TEST(energy.rows.at(4).at(0) == "dissipated: cable yield");
  // A scene in US units has US units first.
  SheetRecord us = record;
  us.us_units = true;
  BOOST_TEST(table(us, "Rocks").rows.at(0).at(1) == "1000 (453.6)");
  BOOST_TEST(table(us, "Rocks").heads.at(1).unit == "lb (kg)");
}

BOOST_AUTO_TEST_CASE(the_verdict_and_its_quality) {
  SheetRecord record = read_sheet(record_file);
  const auto fact = [](const std::vector<SheetFact>& facts, const std::string& name) {
    const auto found = std::ranges::find(facts, name, &SheetFact::name);
    return found == facts.end() ? std::string{"none"} : found->text;
  };
  const auto [passed, quality] = sheet_boxes(record);
  BOOST_TEST(passed.heading == "Verdict: passed under");
  BOOST_TEST(passed.colour == "red");
  BOOST_TEST(fact(passed.facts, "rocks") == "1 passed under, 1 undecided at the end");
  BOOST_TEST(fact(passed.facts, "rock") ==
             "passed under at 0.2500 s; after its last contact at 0.3000 s 5 m/s (16.4 ft/s), 0.25 kJ (0.1844 kip ft), "
             "25 % of its energy");
  BOOST_TEST(fact(passed.facts, "anchor force") == "5 kN (1.124 kip) at 0.2200 s");
  BOOST_TEST(fact(passed.facts, "cable force") == "44.48 kN (10 kip) at 0.2100 s, top1: 89 % of its limit");
  BOOST_TEST(fact(passed.facts, "hanger force") == "4.448 kN (1 kip) at 0.2000 s, column1: 50 % of its limit");
  BOOST_TEST(quality.heading == "Quality: usable");
  BOOST_TEST(quality.colour == "green");
  BOOST_TEST(fact(quality.facts, "energy balance") == "within 0.2 %");
  BOOST_TEST(fact(quality.facts, "steps") == "step 0.1 times its linear limit; 55 in the shortest contact");
  BOOST_TEST(fact(quality.facts, "at the end") == "rock-ground still touches");
  BOOST_TEST(fact(quality.facts, "sensitivity") ==
             "with 1.001 times the speed the verdict is unchanged; largest cable force -1.2 %");
  record.quality.repeat->verdict = "stopped";
  BOOST_TEST(contains(fact(sheet_boxes(record)[1].facts, "sensitivity"), "the verdict becomes: stopped"));
  record.rocks.resize(1);
  record.verdict = record.rocks.front().verdict = "stopped";
  BOOST_TEST(sheet_boxes(record)[0].colour == "green");
  BOOST_TEST(fact(sheet_boxes(record)[0].facts, "rocks") == "none");
  record.quality.usable = false;
  record.quality.flaw = "the energy balance is off by 18 %";
  record.quality.repair = SheetQuality::Repair{"--integrator auto", "", "stopped", 1e-5};
  const auto [verdict, flawed] = sheet_boxes(record);
  BOOST_TEST(verdict.colour == "red");
  BOOST_TEST(flawed.heading == "Quality: NOT USABLE");
  BOOST_TEST(flawed.colour == "red");
  BOOST_TEST(fact(flawed.facts, "reason") == "the energy balance is off by 18 %");
  BOOST_TEST(fact(flawed.facts, "repair") ==
             "--integrator auto was tried and repairs it: stopped, energy balance within 0.001 %");
  record.quality.repair->flaw = "it diverged";
  BOOST_TEST(fact(sheet_boxes(record)[1].facts, "repair") ==
             "--integrator auto was tried and does not help: it diverged");
}

BOOST_AUTO_TEST_CASE(long_lists_are_cut_and_say_so) {
  SheetRecord record = read_sheet(record_file);
  record.columns.resize(40, record.columns.front());
  record.events.resize(25, record.events.front());
  BOOST_TEST(table(record, "Hangers").rows.size() == 10U);  // including those of two rocks
  BOOST_TEST(contains(table(record, "Hangers").note, "30 more are in sheet.json."));
  BOOST_TEST(contains(table(record, "Order").note, "21 more are in sheet.json."));
  record.events.clear();
  BOOST_TEST(table(record, "Order").rows.at(0).at(1) == "none");
  BOOST_TEST(table(record, "Order").note == "Closest to its limit: top1, 89.0 %.");
}

BOOST_AUTO_TEST_CASE(the_same_record_gives_the_same_pages) {
  const Folder scratch;
  std::string before[2];
  for (std::string& pages : before) {
    write_whole(scratch.path / "sheet.json", read_whole(record_file));
    const Finished made = run({TALUS_REPORT_PROGRAM, {"--sheet", scratch.path.string()}, {}, {}});
    BOOST_TEST_REQUIRE(made.status == 0, made.messages);
    pages = read_whole(scratch.path / "sheet.pdf") + read_whole(scratch.path / "sheet.html");
  }
  BOOST_TEST((before[0] == before[1]));
  BOOST_TEST(std::distance(fs::directory_iterator{scratch.path}, {}) == 3);
  const std::string html = read_whole(scratch.path / "sheet.html");
  BOOST_TEST(contains(html, "<h1>A &amp; B: 50 % of {x_1} #2 &lt;\\&gt; ~ ^ µ ★</h1>"));
  BOOST_TEST(contains(html, "<svg"));
  BOOST_TEST(!contains(html, "src="));  // all in one file
  BOOST_TEST(contains(html, "Verdict: passed under"));
  BOOST_TEST(contains(html, "name=\"viewport\""));
  BOOST_TEST(!contains(html, "class=\"unusable\""));
  // A run that is not usable is crossed out.
  std::string flawed = replaced(read_whole(record_file), "\"usable\": true", "\"usable\": false");
  write_whole(scratch.path / "sheet.json", replaced(flawed, "\"flaw\": \"\"", "\"flaw\": \"it diverged\""));
  BOOST_TEST(run({TALUS_REPORT_PROGRAM, {"--sheet", scratch.path.string()}, {}, {}}).status == 0);
  BOOST_TEST(contains(read_whole(scratch.path / "sheet.html"), "class=\"unusable\""));
  BOOST_TEST(contains(read_whole(scratch.path / "sheet.html"), "it diverged"));
  BOOST_TEST(read_whole(scratch.path / "sheet.pdf") !=
             before[0].substr(0, read_whole(scratch.path / "sheet.pdf").size()));
}

// Without gnuplot both pages have no pictures; without pdflatex only the HTML page is made.
BOOST_AUTO_TEST_CASE(a_missing_tool_costs_only_what_needs_it) {
  const Folder scratch;
  write_whole(scratch.path / "sheet.json", read_whole(record_file));
  for (const bool draws : {false, true}) {
    const fs::path bin = scratch.path / (draws ? "draws" : "sets");
    fs::create_directory(bin);
    const std::string tool = draws ? "gnuplot" : "pdflatex", missing = draws ? "pdflatex" : "gnuplot";
    write_whole(bin / tool, "#!/bin/sh\nPATH=/usr/local/bin:/usr/bin:/bin\nexec " + tool + " \"$@\"\n");
    fs::permissions(bin / tool, fs::perms::owner_all);
    const Finished made = run({TALUS_REPORT_PROGRAM, {"--sheet", scratch.path.string()}, {}, {{"PATH", bin.string()}}});
    BOOST_TEST(made.status == 4);
    BOOST_TEST(contains(made.messages, missing + ": cannot be started: "), made.messages);
    BOOST_TEST(fs::exists(scratch.path / "sheet.pdf") != draws);
    const std::string html = read_whole(scratch.path / "sheet.html");
    BOOST_TEST(contains(html, "Hangers"));
    BOOST_TEST(contains(html, "<svg") == draws);
  }
}

// A title may contain characters with a meaning in HTML, LaTeX, gnuplot, a shell or a template.
BOOST_AUTO_TEST_CASE(a_title_is_text_in_every_format) {
  const Folder scratch;
  const std::string title =
      "<script>alert(1)</script> $x$ $(touch pwned) `touch pwned` \\\\input{/etc/passwd} \\\\write18{touch pwned} % # "
      "_ ^ ~ & { } "
      "\\\"; system 'touch pwned' \\u0007 {{title}} <%title%> \\n\\n'quit' @x";
  const std::string record = read_whole(record_file);
  const std::size_t offset = record.find("\"title\": \"") + 10, end = record.find('"', offset);
  const std::size_t name = record.find("top1");
  BOOST_REQUIRE((end != std::string::npos && name != std::string::npos && name > end));
  std::string text = record;
  for (std::size_t at = text.rfind("top1"); at != std::string::npos && at > end; at = text.rfind("top1", at - 1))
    text.replace(at, 4, "<b>`touch pwned` $ \\\\x % #");
  text.replace(offset, end - offset, title);
  write_whole(scratch.path / "sheet.json", text);
  const Finished made = run({TALUS_REPORT_PROGRAM, {"--sheet", scratch.path.string()}, scratch.path, {}});
  BOOST_TEST(made.status == 0, made.messages);
  BOOST_TEST(made.messages == "");
  const std::string html = read_whole(scratch.path / "sheet.html");
  BOOST_TEST(contains(html, "<title>&lt;script&gt;alert(1)&lt;/script&gt; $x$ $(touch pwned) `touch pwned` "));
  BOOST_TEST(contains(html, "{{title}}"));
  BOOST_TEST((!contains(html, "<script>") && !contains(html, "<b>`")));
  for (const auto& entry : fs::recursive_directory_iterator(scratch.path))
    BOOST_TEST(!contains(entry.path().filename().string(), "pwned"));
}

BOOST_AUTO_TEST_CASE(records_that_are_wrong) {
  const Folder scratch;
  const std::string good = read_whole(record_file);
  const fs::path file = scratch.path / "sheet.json";
  for (const auto& [text, expected] :
       {std::pair{replaced(good, "\"schema\": 3", "\"schema\": 2"),
                  ".schema: must be 3, found 2: run the fence again with --sheet, by this version of talus"},
        {replaced(good, "\"verdict\": \"passed_under\"", "\"verdict\": \"won\""),
         ".verdict: must be one of stopped, undecided"},
        {replaced(good, "\"travel\": 0.3048", "\"far\": 1"), ".rocks[0].travel: is missing"},
        {replaced(good, "\"margin\": 0.0", "\"margin\": \"inf\""), ".margin: must be a finite"},
        {std::string{"{"}, ": is truncated or not JSON"}}) {
    write_whole(file, text);
    const Finished refused = run({TALUS_REPORT_PROGRAM, {"--sheet", scratch.path.string()}, {}, {}});
    BOOST_TEST(refused.status == 2);
    BOOST_TEST(contains(refused.messages, expected), refused.messages);
    BOOST_TEST(!fs::exists(scratch.path / "sheet.pdf"));
  }
}

BOOST_AUTO_TEST_SUITE_END()
