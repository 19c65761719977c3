#define BOOST_TEST_MODULE reports_report
#include "reports/report.hpp"

#include <boost/test/unit_test.hpp>
#include <fstream>
#include <regex>
#include <thread>

#include "reports/error.hpp"
#include "reports/file.hpp"
#include "reports/process.hpp"
#include "tests/reports/scratch.hpp"

using namespace talus::reports;
namespace fs = std::filesystem;

namespace {

const fs::path data = TALUS_TEST_DATA;

Finished program(const std::vector<std::string>& arguments,
                 const std::map<std::string, std::string>& environment = {}) {
  return run({TALUS_REPORT_PROGRAM, arguments, {}, environment});
}

bool contains(const std::string& text, const std::string& part) { return text.find(part) != std::string::npos; }

}  // namespace

BOOST_AUTO_TEST_CASE(the_same_records_give_the_same_bytes) {
  const Scratch scratch("report");
  const fs::path first = scratch.folder / "first";
  const fs::path second = scratch.folder / "second";
  BOOST_TEST_REQUIRE(program({(data / "pass").string(), first.string()}).status == 0);
  std::this_thread::sleep_for(std::chrono::milliseconds(1100));  // another second on the clock of PDF dates
  BOOST_TEST_REQUIRE(program({(data / "pass").string(), second.string()}).status == 0);
  for (const char* name : {"verification.md", "verification.html", "verification.pdf", "figures/margins.svg",
                           "figures/margins.pdf", "figures/two_cable-stiffness.svg", "figures/pendulum-work.pdf"}) {
    BOOST_TEST((read_file(first / name) == read_file(second / name)), name);
  }
  for (const auto& entry : fs::directory_iterator(first)) {
    BOOST_TEST(entry.path().filename().string().front() != '.', "left behind: " << entry.path());
  }
}

BOOST_AUTO_TEST_CASE(links_lead_somewhere_and_the_page_is_self_contained) {
  const Scratch scratch("report");
  BOOST_TEST_REQUIRE(program({(data / "pass").string(), scratch.folder.string()}).status == 0);
  const std::string html = read_file(scratch.folder / "verification.html");
  const std::regex link("href=\"#([^\"]+)\"");
  int links = 0;
  for (std::sregex_iterator it(html.begin(), html.end(), link), end; it != end; ++it) {
    ++links;
    BOOST_TEST(contains(html, "id=\"" + (*it)[1].str() + "\""), (*it)[1].str());
  }
  BOOST_TEST(links > 10);
  BOOST_TEST(!contains(html, "src=\"figures/"));
  BOOST_TEST(!contains(html, "http://talus"));
  const std::string markdown = read_file(scratch.folder / "verification.md");
  const std::regex picture(R"(\]\((figures/[^)]+\.svg)\))");
  int pictures = 0;
  for (std::sregex_iterator it(markdown.begin(), markdown.end(), picture), end; it != end; ++it) {
    ++pictures;
    BOOST_TEST(fs::exists(scratch.folder / (*it)[1].str()), (*it)[1].str());
  }
  BOOST_TEST(pictures == 4);
  BOOST_TEST(contains(markdown, "**PASS.** 2 cases"));
}

BOOST_AUTO_TEST_CASE(failures_stand_on_the_first_page) {
  const Scratch scratch("report");
  const Finished finished = program({(data / "fail").string(), scratch.folder.string()});
  BOOST_TEST_REQUIRE(finished.status == 0, finished.messages);
  const std::string text = read_file(scratch.folder / "verification.md");
  const std::string front = text.substr(0, text.find("\n# Checks"));
  BOOST_TEST(contains(front, "**FAIL.**"));
  BOOST_TEST(contains(front, "| distance \\[m\\] | 4.9 | 3.8265 | **2.15e+03** |"));
  BOOST_TEST(contains(front, "**green**"));
  BOOST_TEST(contains(front, "**error**. std::out\\_of\\_range: vector\\<T\\>"));
  BOOST_TEST(front.find("## Failures") < front.find("## Cases"));
  BOOST_TEST(contains(text, "is not drawn: "));
  BOOST_TEST(contains(text, "No check ran."));
  BOOST_TEST(fs::file_size(scratch.folder / "verification.pdf") > 10000U);
}

BOOST_AUTO_TEST_CASE(a_missing_column_stops_the_report_and_leaves_nothing) {
  const Scratch scratch("report");
  fs::copy(data / "pass", scratch.folder / "verify", fs::copy_options::recursive);
  write_file(scratch.folder / "verify" / "pendulum" / "work.csv", "series,step\nrk4,1\n");
  const Finished finished = program({(scratch.folder / "verify").string(), (scratch.folder / "report").string()});
  BOOST_TEST(finished.status == 2);
  BOOST_TEST(contains(finished.messages, "work.csv: has no column 'error'"));
  BOOST_TEST(fs::is_empty(scratch.folder / "report"));
}

BOOST_AUTO_TEST_CASE(the_first_page_holds_the_main_checks) {
  const Scratch scratch("report");
  BOOST_TEST_REQUIRE(program({(data / "pass").string(), scratch.folder.string()}).status == 0);
  const std::string text = read_file(scratch.folder / "verification.md");
  const std::size_t checks = text.find("## Main checks");
  const std::size_t provenance = text.find("## Provenance");
  BOOST_TEST(checks < provenance);
  BOOST_TEST(provenance < text.find("\n# "));
  BOOST_TEST(contains(text, "exact or round-off ones are exempt"));
  const std::string page = read_file(scratch.folder / "verification.html");
  const std::regex with_maths(R"(alt="[^"]*[$\\])");
  BOOST_TEST(!std::regex_search(page, with_maths));
}

BOOST_AUTO_TEST_CASE(missing_tools_and_wrong_usage_have_their_exit_codes) {
  const Scratch scratch("report");
  const Finished bare = program({(data / "pass").string(), scratch.folder.string()}, {{"PATH", "/nowhere"}});
  BOOST_TEST(bare.status == 4);
  BOOST_TEST(contains(bare.messages, "gnuplot: cannot be started"));
  BOOST_TEST(program({(data / "pass").string()}).status == 2);
  BOOST_TEST(program({"--format", "gif", "--plot", "x"}).status == 2);
  BOOST_TEST(program({(data / "none").string(), scratch.folder.string()}).status == 4);
  BOOST_TEST(program({"--help"}).status == 0);
}

BOOST_AUTO_TEST_CASE(a_run_is_plotted_in_each_format) {
  const Scratch scratch("plots");
  write_file(scratch.folder / "history.csv", "time [s],x [m]\n0,1\n1,2\n2,1.5\n");
  write_file(scratch.folder / "plot.json",
             R"({"title": "run", "figures": [{"name": "path", "title": "Path", "csv": "history.csv",
                 "x": {"label": "time", "unit": "s"}, "y": {"label": "x", "unit": "m"},
                 "series": [{"label": "rock", "x": "time [s]", "y": "x [m]", "style": "lines"}]}]})");
  const Finished finished = program({"--plot", scratch.folder.string()});
  BOOST_TEST_REQUIRE(finished.status == 0, finished.messages);
  for (const char* name : {"path.svg", "path.pdf", "path.png"}) {
    BOOST_TEST(contains(finished.output, name));
    BOOST_TEST(fs::file_size(scratch.folder / "plots" / name) > 500U);
  }
  fs::remove_all(scratch.folder / "plots");
  BOOST_TEST(program({"--plot", scratch.folder.string(), "--format", "svg"}).status == 0);
  BOOST_TEST(fs::exists(scratch.folder / "plots" / "path.svg"));
  BOOST_TEST(!fs::exists(scratch.folder / "plots" / "path.pdf"));
}
