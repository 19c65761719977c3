#define BOOST_TEST_MODULE reports_report
#include "reports/report.hpp"

#include <boost/test/unit_test.hpp>
#include <fstream>
#include <regex>
#include <thread>

#include "reports/document.hpp"
#include "reports/error.hpp"
#include "reports/process.hpp"
#include "tests/reports/scratch.hpp"
#include "verification/record/whole_file.hpp"

using namespace talus::reports;
using talus::records::read_whole;
using talus::records::write_whole;
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
    BOOST_TEST((read_whole(first / name) == read_whole(second / name)), name);
  }
  for (const auto& entry : fs::directory_iterator(first)) {
    BOOST_TEST(entry.path().filename().string().front() != '.', "left behind: " << entry.path());
  }
}

BOOST_AUTO_TEST_CASE(links_lead_somewhere_and_the_page_is_self_contained) {
  const Scratch scratch("report");
  BOOST_TEST_REQUIRE(program({(data / "pass").string(), scratch.folder.string()}).status == 0);
  const std::string html = read_whole(scratch.folder / "verification.html");
  const std::regex link("href=\"#([^\"]+)\"");
  int links = 0;
  for (std::sregex_iterator it(html.begin(), html.end(), link), end; it != end; ++it) {
    ++links;
    BOOST_TEST(contains(html, "id=\"" + (*it)[1].str() + "\""), (*it)[1].str());
  }
  BOOST_TEST(links > 10);
  BOOST_TEST(!contains(html, "src=\"figures/"));
  BOOST_TEST(!contains(html, "http://talus"));
  const std::string markdown = read_whole(scratch.folder / "verification.md");
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
  const std::string text = read_whole(scratch.folder / "verification.md");
  const std::string front = text.substr(0, text.find("\n# Coverage"));
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
  write_whole(scratch.folder / "verify" / "pendulum" / "work.csv", "series,step\nrk4,1\n");
  const Finished finished = program({(scratch.folder / "verify").string(), (scratch.folder / "report").string()});
  BOOST_TEST(finished.status == 2);
  BOOST_TEST(contains(finished.messages, "work.csv: has no column 'error'"));
  BOOST_TEST(fs::is_empty(scratch.folder / "report"));
}

BOOST_AUTO_TEST_CASE(the_summary_comes_first_and_the_long_tables_last) {
  const Scratch scratch("report");
  BOOST_TEST_REQUIRE(program({(data / "pass").string(), scratch.folder.string()}).status == 0);
  const std::string text = read_whole(scratch.folder / "verification.md");
  std::size_t before = 0;
  for (const char* heading :
       {"\n## Cases", "\n# Coverage", "\n# Common formulas", "\n# Checks of other codes", "\n# Errata",
        "\n# two\\_cable", "\n# pendulum", "\n# Appendix: details", "\n# Appendix: margins",
        "\n# Appendix: traceability", "\n# Appendix: provenance", "\n# References", "\n# Colophon"}) {
    const std::size_t place = text.find(heading);
    BOOST_TEST_REQUIRE(place != std::string::npos, heading);
    BOOST_TEST(before < place, heading);
    before = place;
  }
  BOOST_TEST(contains(text, "exact or round-off ones are exempt"));
  const std::string page = read_whole(scratch.folder / "verification.html");
  const std::regex with_maths(R"(alt="[^"]*[$\\])");
  BOOST_TEST(!std::regex_search(page, with_maths));
}

BOOST_AUTO_TEST_CASE(the_bibliography_becomes_the_list_of_references) {
  const Scratch scratch("references");
  BOOST_TEST_REQUIRE(program({(data / "pass").string(), scratch.folder.string()}).status == 0);
  const std::string text = read_whole(scratch.folder / "verification.md");
  BOOST_TEST(contains(text,
                      "**schwager2007**: T. Schwager, T. Pöschel: Coefficient of restitution and linear-dashpot "
                      "model revisited. *Granular Matter* 9 (2007) 465--469.\n"));
  BOOST_TEST(contains(text, "**report1993**: *Rockfall fence report*. 1993.\n"));
  BOOST_TEST(contains(read_whole(scratch.folder / "verification.html"), "<em>Granular Matter</em>"));
}

BOOST_AUTO_TEST_CASE(references_of_all_types_keep_what_is_known_of_them) {
  const Scratch scratch("references");
  const Document document{scratch.folder, "page", "Page", find_resources() / "pandoc", 0};
  const std::string list = references_of(R"(
@string{unseen = {Not at hand.}}
@book{strutt1877, author = {{Strutt, Baron Rayleigh}, J. W.}, title = {{The Theory of Sound}}, volume = {I},
  publisher = {{Macmillan and Co}}, address = {London}, edition = 2, year = 1877, note = unseen}
@book{ed1964, editor = {Abramowitz, M. and Stegun, I. A.}, title = {{Handbook NBS}}, year = 1964}
@article{art1990, author = {da Cruz, J.-N.}, title = {{Title of “two” Words}}, journal = {ACM Notices}, volume = 25,
  number = 6, year = 1990, pages = {5-18, 112-126}, eprint = {cond-mat/06}, archiveprefix = {arXiv}}
@incollection{in1974, author = {Krogh, F.}, title = {{Changing}}, booktitle = {{The Book}}, series = {{Lecture Notes}},
  volume = 362, year = 1974, pages = {22-71}}
@mastersthesis{ms1989, author = {Lacy, J.}, title = {{Rockfalls}}, type = {M.S. thesis}, school = {{A University}},
  address = {Bozeman}, month = 4, year = 1989}
@phdthesis{phd1992, author = {Baraff, D.}, title = {{Bodies}}, school = {{Cornell}}, year = 1992}
@techreport{rep1993, author = {Mustoe, G.}, title = {{Fences}}, type = {Report}, number = {R-93-20},
  institution = {{A School and Department}}, month = 4, year = 1993, pagetotal = 79}
@misc{web, title = {{Web page}}, url = {https://a.org/b_c/}, note = {Chapter 4.}}
)",
                                         document);
  for (const char* entry :
       {"**strutt1877**: J. W. Strutt, Baron Rayleigh: *The Theory of Sound*, volume I. 2nd edition, Macmillan and Co, "
        "London, 1877. Not at hand.",
        "**ed1964**: M. Abramowitz, I. A. Stegun (eds.): *Handbook NBS*. 1964.",
        "**art1990**: J.-N. da Cruz: Title of \"two\" Words. *ACM Notices* 25, no. 6 (1990) 5--18, 112--126, "
        "[arXiv\u00a0cond-mat/06](https://arxiv.org/abs/cond-mat/06).",
        "**in1974**: F. Krogh: Changing. *The Book*, *Lecture Notes* 362, 1974, 22--71.",
        "**ms1989**: J. Lacy: Rockfalls. M.S. thesis, A University, Bozeman, April 1989.",
        "**phd1992**: D. Baraff: Bodies. PhD thesis, Cornell, 1992.",
        "**rep1993**: G. Mustoe: *Fences*. Report R-93-20, A School and Department, April 1993, 79 pages.",
        "**web**: Web page. <https://a.org/b_c/>. Chapter 4."})
    BOOST_TEST(contains(list, std::string(entry) + "\n"), entry << " in\n" << list);
  BOOST_CHECK_THROW(static_cast<void>(references_of("@article{broken, title = {", document)), OutputError);
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
  write_whole(scratch.folder / "history.csv", "time [s],x [m]\n0,1\n1,2\n2,1.5\n");
  write_whole(scratch.folder / "plot.json",
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

namespace {

/// A record that draws a page of two panels of shapes.
std::string page_record(const std::string& more) {
  const std::string panel = R"({"name": "p", "title": "t = 0 s", "csv": "shapes.csv", "equal": true,
      "x": {"label": "x", "min": -1, "max": 2}, "y": {"label": "y", "min": -1, "max": 2},
      "marks": [{"x": 0.5, "y": 0.5, "words": "7"}],
      "series": [{"label": "square", "x": "x", "y": "y", "style": "shapes", "where": "body", "colour": "#102030",
                  "fill": "#a0b0c0"},
                 {"x": "x", "y": "y", "style": "shapes", "where": "cable", "value": "pull", "width": 3}]})";
  const std::string page = R"({"name": "page", "title": "Two", "columns": 2, "panels": [)" + panel + "," + panel +
                           R"(], "scale": {"label": "tension", "unit": "N", "min": 0, "max": 8}})";
  return R"({"figures": [], "pages": [)" + page + R"(], "films": [{"name": "film", "delay": 0.1, "pages": [)" + page +
         "," + page + "]}]" + more + "}";
}

void write_shapes(const fs::path& folder) {
  write_whole(folder / "shapes.csv",
              "series,line,x,y,pull\nbody,0,0,0,0\nbody,0,1,0,0\nbody,0,1,1,0\nbody,0,0,1,0\nbody,0,0,0,0\n"
              "cable,1,0,0,8\ncable,1,0,1.5,8\ncable,2,1,0,0\ncable,2,1,1.5,0\n");
}

}  // namespace

BOOST_AUTO_TEST_CASE(a_page_shows_shapes_in_the_colours_of_their_values) {
  const Scratch scratch("page");
  write_shapes(scratch.folder);
  write_whole(scratch.folder / "player.json", R"({"title": "</script>"})");
  write_whole(scratch.folder / "plot.json",
              page_record(R"(, "players": [{"name": "play", "title": "A <b>", "data": "player.json"}])"));
  const Finished finished =
      program({"--plot", scratch.folder.string(), "--format", "svg,ps", "--to", (scratch.folder / "to").string()});
  BOOST_TEST_REQUIRE(finished.status == 0, finished.messages);
  BOOST_TEST(finished.messages == "");
  const std::string svg = read_whole(scratch.folder / "to" / "page.svg");
  // The scale's dark end for a pull of 8, its pale one for none; a fill and its line; title, key and number.
  for (const char* part :
       {"rgb(103,   0,  31)", "rgb(254, 196,  79)", "rgb(160, 176, 192)", "Two", "square", "tension [N]", ">7<"})
    BOOST_TEST(contains(svg, part), part);
  BOOST_TEST(contains(read_whole(scratch.folder / "to" / "page.ps"), "%%CreationDate: Thu Jan  1 00:00:00 1970"));
  BOOST_TEST(read_whole(scratch.folder / "to" / "film.gif").rfind("GIF89a", 0) == 0U);
  const std::string html = read_whole(scratch.folder / "to" / "play.html");
  BOOST_TEST(contains(html, "<title>A &lt;b&gt;</title>"));
  BOOST_TEST(contains(html, R"({"title": "\u003c/script>"})"));
}

// Of circles with a value the dark and the pale end of the scale, of the others their fill; outlines have few corners
// where they are small.
BOOST_AUTO_TEST_CASE(circles_are_filled_by_their_values) {
  const Scratch scratch("circles");
  write_whole(scratch.folder / "circles.csv",
              "series,x,y,radius,speed\ndisc,0,0,0.5,0\ndisc,2,0,0.5,8\nwall,0,-1,0.01,3\n");
  const std::string good = R"({"figures": [], "pages": [{"name": "page", "title": "", "columns": 1, "panels": [
      {"name": "p", "title": "", "csv": "circles.csv", "equal": true, "x": {"label": "x", "min": -1, "max": 3},
       "y": {"label": "y", "min": -2, "max": 1}, "series": [
         {"x": "x", "y": "y", "style": "circles", "where": "disc", "radius": "radius", "value": "speed"},
         {"label": "wall", "x": "x", "y": "y", "style": "circles", "where": "wall", "radius": "radius",
          "fill": "#a0b0c0", "colour": "#102030"}]}],
      "scale": {"label": "speed", "unit": "m/s", "min": 0, "max": 8}}]})";
  write_whole(scratch.folder / "plot.json", good);
  const Finished finished =
      program({"--plot", scratch.folder.string(), "--format", "svg", "--to", (scratch.folder / "to").string()});
  BOOST_TEST_REQUIRE(finished.status == 0, finished.messages);
  BOOST_TEST(finished.messages == "");
  const std::string svg = read_whole(scratch.folder / "to" / "page.svg");
  for (const char* part : {"rgb(103,   0,  31)", "rgb(254, 196,  79)", "rgb(160, 176, 192)", ">wall<", "speed [m/s]"})
    BOOST_TEST(contains(svg, part), part);
  for (const auto& [from, words] : std::vector<std::pair<std::string, std::string>>{
           {"\"radius\": \"radius\", \"value\"", "series[0].radius"},
           {", \"value\": \"speed\"", "series[0]: shapes need a colour, a fill or a value"},
           {"\"fill\": \"#a0b0c0\", ", "series[1]: circles need a fill or a value"}}) {
    std::string text = good;
    text.replace(text.find(from), from.size(), from.find("radius") != std::string::npos ? "\"value\"" : "");
    write_whole(scratch.folder / "plot.json", text);
    const Finished wrong = program({"--plot", scratch.folder.string()});
    BOOST_TEST(wrong.status == 2);
    BOOST_TEST(contains(wrong.messages, words), wrong.messages);
  }
}

BOOST_AUTO_TEST_CASE(wrong_pages_are_named) {
  const Scratch scratch("page");
  write_shapes(scratch.folder);
  const std::string good = page_record("");
  const std::vector<std::pair<std::pair<std::string, std::string>, std::string>> changes{
      {{"#102030", "blue"}, "series[0].colour: must be a colour such as #0072b2"},
      {{"\"min\": -1, ", ""}, "panels[0]: a figure with equal units needs min and max of both axes"},
      {{"\"columns\": 2", "\"columns\": 0"}, "pages[0].columns: must be from 1 to 12"},
      {{"\"max\": 8", "\"max\": 0"}, "pages[0].scale: min must be less than max"},
      {{"\"delay\": 0.1", "\"delay\": 0"}, "films[0].delay: must be > 0"},
      {{"\"value\": \"pull\", ", ""}, "series[1]: shapes need a colour, a fill or a value"},
      {{"\"where\": \"cable\"", "\"where\": \"rope\""}, "has no row"}};
  for (const auto& [change, words] : changes) {
    std::string text = good;
    text.replace(text.find(change.first), change.first.size(), change.second);
    write_whole(scratch.folder / "plot.json", text);
    const Finished finished = program({"--plot", scratch.folder.string()});
    BOOST_TEST(finished.status == 2);
    BOOST_TEST(contains(finished.messages, words), finished.messages);
  }
}
