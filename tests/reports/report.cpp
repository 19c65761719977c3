#include "reports/report.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <boost/test/unit_test.hpp>
#include <map>
#include <nlohmann/json.hpp>
#include <regex>
#include <set>
#include <sstream>
#include <thread>

#include "reports/base/error.hpp"
#include "reports/base/process.hpp"
#include "reports/text/document.hpp"
#include "reports/text/markdown.hpp"
#include "tests/reports/report_program.hpp"
#include "tests/temporary_folder.hpp"
#include "verification/record/whole_file.hpp"

BOOST_AUTO_TEST_SUITE(report_tests)

using namespace talus::reports;
using talus::records::read_whole;
using talus::records::write_whole;
namespace fs = std::filesystem;

namespace {

const fs::path data = TALUS_TEST_DATA;

/// Folder of the report of data/pass. It takes 6 s, and is written once for all tests that only read it.
const fs::path& passed_report() {
  static const Folder scratch;
  static const Finished finished = program({(data / "pass").string(), scratch.path.string()});
  BOOST_TEST_REQUIRE(finished.status == 0, finished.messages);
  return scratch.path;
}

}  // namespace

BOOST_AUTO_TEST_CASE(the_same_records_give_the_same_bytes) {
  const Folder scratch;
  const fs::path& first = passed_report();
  const fs::path& second = scratch.path;
  std::this_thread::sleep_for(std::chrono::milliseconds(1100));  // the clock of PDF dates shows another second
  BOOST_TEST_REQUIRE(program({(data / "pass").string(), second.string()}).status == 0);
  for (const char* name : {"verification.md", "verification-details.md", "html/index.html", "html/two_cable.html",
                           "html/search.js", "verification.pdf", "verification-details.pdf", "figures/margins.svg",
                           "figures/margins.pdf", "figures/two_cable-stiffness.svg", "figures/pendulum-work.pdf"}) {
    BOOST_TEST((read_whole(first / name) == read_whole(second / name)), name);
  }
  for (const auto& entry : fs::directory_iterator(first)) {
    BOOST_TEST(entry.path().filename().string().front() != '.', "left behind: " << entry.path());
  }
}

// Each link of the site leads to a file, and to an id there; each picture is a file; nothing is loaded from the
// network.
BOOST_AUTO_TEST_CASE(the_site_has_a_page_for_each_case_and_no_dead_link) {
  const fs::path site = passed_report() / "html";
  int links = 0, pictures = 0, tables = 0;
  for (const auto& entry : fs::directory_iterator(site)) {
    if (entry.path().extension() != ".html") continue;
    const std::string html = read_whole(entry.path());
    const std::regex link("(href|src)=\"([^\"#]*)(#([^\"]+))?\"");
    for (std::sregex_iterator it(html.begin(), html.end(), link), end; it != end; ++it) {
      const std::string name = (*it)[2].str(), id = (*it)[4].str();
      if (name.rfind("https://", 0) == 0 && (*it)[1] == "href") continue;  // links of the references
      const fs::path file = name.empty() ? entry.path() : site / name;
      BOOST_TEST(fs::exists(file), entry.path() << ": " << name);
      if (!id.empty())
        BOOST_TEST(contains(read_whole(file), "id=\"" + id + "\""), entry.path() << ": " << name << "#" << id);
      ++links;
      if (name.rfind("../figures/", 0) == 0) ++pictures;
      if (name.rfind("../data/", 0) == 0) ++tables;
    }
    BOOST_TEST(contains(html, "<input id=\"search\""), entry.path());
    BOOST_TEST(!contains(html, "page:"), entry.path());
  }
  BOOST_TEST(links > 100);
  BOOST_TEST(pictures == 5);  // three figures, the margins and a sketch
  BOOST_TEST(tables == 3);
  for (const char* name :
       {"index.html", "two_cable.html", "pendulum.html", "coverage.html", "margins.html", "site.css"})
    BOOST_TEST(fs::exists(site / name), name);
  BOOST_TEST(fs::file_size(site / "index.html") < 2000000U);
  const std::string page = read_whole(site / "two_cable.html");
  BOOST_TEST(contains(page, "id=\"details-of-two_cable\""));
  // A case is found by its name and by those of its checks.
  for (const char* name : {"two_cable", "speed after impact", "period at 170 degrees"})
    BOOST_TEST(contains(read_whole(site / "search.js"), name), name);
}

BOOST_AUTO_TEST_CASE(links_of_the_volumes_lead_to_headings_and_pictures) {
  const fs::path& report = passed_report();
  std::map<std::string, std::set<std::string>> headings;
  std::map<std::string, std::string> texts;
  for (const char* name : {"verification.md", "verification-details.md"}) {
    texts[name] = read_whole(report / name);
    std::istringstream lines(texts[name]);
    for (std::string line; std::getline(lines, line);) {
      if (line.rfind("#", 0) != 0) continue;
      line.erase(std::remove(line.begin(), line.end(), '\\'), line.end());
      headings[name].insert(markdown::heading_id(line.substr(line.find_first_not_of("# "))));
    }
  }
  int between = 0, pictures = 0;
  for (const auto& [name, text] : texts) {
    const std::regex link(R"(\]\(([^)#]*)#([^)]+)\))"), picture(R"(\]\((figures/[^)]+\.svg)\))");
    for (std::sregex_iterator it(text.begin(), text.end(), link), end; it != end; ++it) {
      const std::string there = (*it)[1].length() == 0 ? name : (*it)[1].str();
      BOOST_TEST(headings[there].count((*it)[2].str()) == 1u, name << ": " << it->str());
      between += there != name;
    }
    for (std::sregex_iterator it(text.begin(), text.end(), picture), end; it != end; ++it, ++pictures)
      BOOST_TEST(fs::exists(report / (*it)[1].str()), (*it)[1].str());
  }
  BOOST_TEST(between >= 3);
  BOOST_TEST(pictures == 5);
  BOOST_TEST(contains(texts["verification.md"], "**PASS.** 2 cases"));
}

BOOST_AUTO_TEST_CASE(links_between_the_volumes_lead_from_pdf_to_pdf) {
  const Folder scratch;
  write_whole(scratch.path / "volume.md",
              "[a](verification-details.md#a), [b](verification.md#b), [c](other.md#c)\n\n![d](d.svg)\n");
  const Finished made =
      run({"pandoc",
           {"volume.md", "-o", "volume.tex", "--lua-filter", (find_resources() / "pandoc" / "pdf.lua").string()},
           scratch.path,
           {}});
  BOOST_TEST_REQUIRE(made.status == 0, made.messages);
  const std::string tex = read_whole(scratch.path / "volume.tex");
  for (const char* there : {"{verification-details.pdf}", "{verification.pdf}", "{other.md\\#c}", "{d.pdf}"})
    BOOST_TEST(contains(tex, there), tex);
}

// A chapter of a few lines more than a page is set smaller; one of many more is not.
BOOST_AUTO_TEST_CASE(a_chapter_ends_on_its_page_where_it_can) {
  const Folder scratch;
  std::string text = "# Front\n\n| a |\n|:--|\n| 1 |\n\n# Contents\n\n";
  for (const int lines : {20, 62, 90})
    for (int i = 0; i < lines; ++i)
      text += i == 0 ? fmt::format("# Chapter of {} lines\n\n", lines) : fmt::format("Line {}.\n\n", i);
  write_whole(scratch.path / "book.md", text + "# Last\n");
  const Document book{scratch.path, "book", "Book", find_resources() / "pandoc", 0};
  make_latex(book);
  make_pdf(book);
  const std::string measured = read_whole(scratch.path / "book.aux");
  BOOST_TEST(!contains(measured, "\\TalusTight{1}"));
  BOOST_TEST(contains(measured, "\\TalusTight{2}"));
  BOOST_TEST(!contains(measured, "\\TalusTight{3}"));
  // Front, contents, 20 lines, 62 lines, 90 lines on two pages, last.
  BOOST_TEST(contains(read_whole(scratch.path / "book.log"), "Output written on book.pdf (7 pages"));
  BOOST_TEST(contains(read_whole(scratch.path / "book.toc"), "Chapter of 90 lines}{5}"));
}

BOOST_AUTO_TEST_CASE(the_first_page_names_the_machine_and_what_did_not_run) {
  const Folder scratch;
  fs::copy(data / "pass", scratch.path / "verify", fs::copy_options::recursive);
  const fs::path file = scratch.path / "verify" / "results.json";
  nlohmann::json results = nlohmann::json::parse(read_whole(file));
  const auto first_page = [&] {
    write_whole(file, results.dump(1));
    write_markdown(scratch.path / "verify", scratch.path / "report");
    const std::string text = read_whole(scratch.path / "report" / "verification.md");
    return text.substr(0, text.find("\n# Coverage"));
  };
  results["provenance"]["cpu"] = "Some Processor";
  results["provenance"]["cores"] = 4;
  results["registered"].push_back("long_study");
  const std::string of_tier = first_page();
  BOOST_TEST(contains(of_tier, ", on Some Processor, 4 cores."), of_tier);
  BOOST_TEST(contains(of_tier, "**Only in the full tier** (`make verify-full`): long\\_study."), of_tier);
  BOOST_TEST(!contains(of_tier, "Only a selection ran"));
  results["only"] = results["selected"];
  const std::string selected = first_page();
  BOOST_TEST(contains(selected, "**Only a selection ran.** Registered but not requested: long\\_study."), selected);
  BOOST_TEST(!contains(selected, "full tier"));
}

BOOST_AUTO_TEST_CASE(failures_stand_on_the_first_page) {
  const Folder scratch;
  const Finished finished = program({(data / "fail").string(), scratch.path.string()});
  BOOST_TEST_REQUIRE(finished.status == 0, finished.messages);
  const std::string text = read_whole(scratch.path / "verification.md");
  const std::string front = text.substr(0, text.find("\n# Coverage"));
  BOOST_TEST(contains(front, "**FAIL.**"));
  BOOST_TEST(contains(front, "| distance \\[m\\] | 4.9 | 3.8265 | **2.15e+03** |"));
  BOOST_TEST(contains(front, "**green**"));
  BOOST_TEST(contains(front, "**error**. std::out\\_of\\_range: vector\\<T\\>"));
  BOOST_TEST(front.find("## Failures") < front.find("## Cases"));
  BOOST_TEST(contains(text, "is not drawn: "));
  BOOST_TEST(contains(text, "No check ran."));
  BOOST_TEST(fs::file_size(scratch.path / "verification.pdf") > 10000U);
}

BOOST_AUTO_TEST_CASE(a_missing_column_stops_the_report_and_leaves_nothing) {
  const Folder scratch;
  fs::copy(data / "pass", scratch.path / "verify", fs::copy_options::recursive);
  write_whole(scratch.path / "verify" / "pendulum" / "work.csv", "series,step\nrk4,1\n");
  const Finished finished = program({(scratch.path / "verify").string(), (scratch.path / "report").string()});
  BOOST_TEST(finished.status == 2);
  BOOST_TEST(contains(finished.messages, "work.csv: has no column 'error'"));
  BOOST_TEST(fs::is_empty(scratch.path / "report"));
}

BOOST_AUTO_TEST_CASE(the_summary_comes_first_and_the_long_tables_in_a_volume_of_their_own) {
  const fs::path& report = passed_report();
  const auto in_order = [](const std::string& text, const std::vector<const char*>& headings) {
    std::size_t before = 0;
    for (const char* heading : headings) {
      const std::size_t offset = text.find(heading, before);
      BOOST_TEST_REQUIRE(offset != std::string::npos, heading);
      before = offset;
    }
  };
  in_order(read_whole(report / "verification.md"), {"**Verified.**", "**Not verified.**", "\n## Findings", "\n## Cases",
                                                    "\n# Coverage", "\n# Errata", "\n# two\\_cable", "\n# pendulum"});
  const std::string details = read_whole(report / "verification-details.md");
  in_order(details, {"# Talus verification: details", "\n## Details of two\\_cable", "\n## Details of pendulum",
                     "\n# Common formulas", "\n# Checks of other codes", "\n# Margins", "\n# Mutants", "\n# Interface",
                     "\n# Rounding", "\n# Traceability", "\n# References", "\n# Provenance", "\n# Colophon"});
  // One round-off check has used more than half of its bound.
  BOOST_TEST(contains(details, "| round\\_off | 2 | 1 | 1 |"));
  BOOST_TEST(contains(details, "| **all** | 13 | 12 | 1 |"));
  BOOST_TEST(contains(read_whole(report / "verification.md"), "exact or round-off ones are exempt"));
  const std::string page = read_whole(report / "html" / "two_cable.html");
  const std::regex with_maths(R"(alt="[^"]*[$\\])");
  BOOST_TEST(!std::regex_search(page, with_maths));
}

BOOST_AUTO_TEST_CASE(the_bibliography_becomes_the_list_of_references) {
  const std::string text = read_whole(passed_report() / "verification-details.md");
  BOOST_TEST(contains(text,
                      "**schwager2007**: T. Schwager, T. Pöschel: Coefficient of restitution and linear-dashpot "
                      "model revisited. *Granular Matter* 9 (2007) 465--469.\n"));
  BOOST_TEST(contains(text, "**report1993**: *Rockfall fence report*. 1993.\n"));
  BOOST_TEST(contains(read_whole(passed_report() / "html" / "references.html"), "<em>Granular Matter</em>"));
}

BOOST_AUTO_TEST_CASE(references_of_all_types_keep_what_is_known_of_them) {
  const Folder scratch;
  const Document document{scratch.path, "page", "Page", find_resources() / "pandoc", 0};
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
  const Folder scratch;
  const Finished bare = program({(data / "pass").string(), scratch.path.string()}, {{"PATH", "/nowhere"}});
  BOOST_TEST(bare.status == 4);
  for (const char* expected :
       {"gnuplot: cannot be started: No such file or directory (is it installed? Debian's packages: gnuplot-nox; ",
        "Debian's packages: pandoc; "})
    BOOST_TEST(contains(bare.messages, expected), bare.messages);
  BOOST_TEST(bare.output == (scratch.path / "verification.md").string() + "\n" +
                                (scratch.path / "verification-details.md").string() + "\n");
  BOOST_TEST(program({(data / "pass").string()}).status == 2);
  BOOST_TEST(program({"--format", "gif", "--plot", "x"}).status == 2);
  BOOST_TEST(program({(data / "none").string(), scratch.path.string()}).status == 4);
  BOOST_TEST(program({"--help"}).status == 0);
  const Finished hostile = program({(data / "none\x1b[2J").string(), scratch.path.string()});
  BOOST_TEST(contains(hostile.messages, "none\\x1b[2J"), hostile.messages);
  const Finished unknown = program({"--sketch", "x"});
  BOOST_TEST(unknown.status == 2);
  BOOST_TEST(
      contains(unknown.messages, "talus_report: option '--sketch' is not known; nearest: --sketches; known: --help, "),
      unknown.messages);
  BOOST_TEST(unknown.messages.ends_with("\nhelp: talus_report --help\n"), unknown.messages);
}

// A PATH with all tools but one: outputs that do not need it are made, and an earlier report's files of a kind that
// cannot be made are removed.
BOOST_AUTO_TEST_CASE(a_missing_tool_costs_only_what_needs_it) {
  const Folder scratch;
  const std::vector<std::string> tools{"gnuplot", "pandoc", "pdflatex"};
  for (const auto& [missing, package, made] :
       {std::tuple{"gnuplot", "gnuplot-nox",
                   std::vector<std::string>{"html", "verification-details.pdf", "verification.pdf"}},
        {"pandoc", "pandoc", {"figures"}},
        {"pdflatex", "texlive-latex-recommended and lmodern", {"figures", "html"}}}) {
    const fs::path bin = scratch.path / missing / "bin", report = scratch.path / missing / "report";
    fs::create_directories(bin), fs::create_directories(report);
    for (const std::string& tool : tools) {
      if (tool == missing) continue;
      write_whole(bin / tool, "#!/bin/sh\nPATH=/usr/local/bin:/usr/bin:/bin\nexec " + tool + " \"$@\"\n");
      fs::permissions(bin / tool, fs::perms::owner_all);
    }
    fs::create_directory(report / "figures");
    fs::create_directory(report / "html");
    for (const char* earlier :
         {"html/index.html", "verification-details.pdf", "verification.pdf", "figures/earlier.svg"})
      write_whole(report / earlier, "earlier");
    const Finished finished = program({(data / "pass").string(), report.string()}, {{"PATH", bin.string()}});
    BOOST_TEST(finished.status == 4);
    BOOST_TEST(contains(finished.messages, std::string("talus_report: ") + missing + ": cannot be started"),
               finished.messages);
    BOOST_TEST(contains(finished.messages, std::string("Debian's packages: ") + package + ";"), finished.messages);
    std::vector<std::string> expected = made, found;
    expected.push_back("data"), expected.push_back("verification.md"), expected.push_back("verification-details.md");
    for (const auto& entry : fs::directory_iterator(report))
      found.push_back(entry.path().filename().string());
    std::sort(expected.begin(), expected.end()), std::sort(found.begin(), found.end());
    BOOST_TEST(found == expected, boost::test_tools::per_element());
    BOOST_TEST(!fs::exists(report / "figures/earlier.svg"));
    const std::string text = read_whole(report / "verification.md");
    BOOST_TEST(contains(text, "is not drawn: gnuplot: cannot be started") == (missing == tools[0]));
    BOOST_TEST(contains(text, "](figures/") == (missing != tools[0]));
    BOOST_TEST(contains(read_whole(report / "verification-details.md"), std::string("no ") + missing), "the colophon");
  }
}

BOOST_AUTO_TEST_CASE(a_site_is_made_of_markdown_pages) {
  const Folder scratch;
  write_whole(scratch.path / "README.md", "# First\n\nSee [the other](other.html#part-two).\n");
  write_whole(scratch.path / "other.md", "# Other\n\n## Part two\n\n$x^2$\n");
  const auto site = [&](const char* first) {
    return program({"--title", "Guide", "--to", (scratch.path / "out").string(), "--site",
                    (scratch.path / first).string(), (scratch.path / "other.md").string()});
  };
  const Finished finished = site("README.md");
  BOOST_TEST_REQUIRE(finished.status == 0, finished.messages);
  const std::string index = read_whole(scratch.path / "out" / "index.html");
  BOOST_TEST(contains(index, "<title>First - Guide</title>"));
  BOOST_TEST(contains(index, "<a href=\"other.html\">Other</a>"));
  BOOST_TEST(contains(read_whole(scratch.path / "out" / "other.html"), "<h2 id=\"part-two\">"));
  BOOST_TEST(contains(read_whole(scratch.path / "out" / "search.js"), "Part two"));
  write_whole(scratch.path / "bare.md", "No heading.\n");
  BOOST_TEST(site("bare.md").status == 2);
  BOOST_TEST(contains(site("bare.md").messages, "bare.md:1: must begin with '# '"));
  BOOST_TEST(contains(program({"--site", (scratch.path / "other.md").string()}).messages,
                      "--site and --sketches require --to"));
}

BOOST_AUTO_TEST_CASE(sketches_of_pages_are_drawn_for_their_authors) {
  const Folder scratch;
  const auto sketch = [&](const std::string& page) {
    write_whole(scratch.path / "drop.md", page);
    return program({"--sketches", (scratch.path / "drop.md").string(), "--to", (scratch.path / "out").string()});
  };
  const Finished finished = sketch("Text.\n\n```sketch A ball\ndisc 0 0 1\n```\n\n```sketch A box\nbox 0 0 1 1\n```\n");
  BOOST_TEST_REQUIRE(finished.status == 0, finished.messages);
  for (const char* name : {"drop-sketch-1.svg", "drop-sketch-1.pdf", "drop-sketch-1.png", "drop-sketch-2.svg"}) {
    BOOST_TEST(contains(finished.output, name));
    BOOST_TEST(fs::file_size(scratch.path / "out" / name) > 500U);
  }
  BOOST_TEST(sketch("No sketch.\n").status == 2);
  BOOST_TEST(contains(sketch("No sketch.\n").messages, "drop.md: it has no sketch"));
  BOOST_TEST(
      contains(sketch("```sketch A ball\ndisc 0\n```\n").messages, "drop.md: sketch, line 1: disc has 1 numbers"));
}

BOOST_AUTO_TEST_SUITE_END()
