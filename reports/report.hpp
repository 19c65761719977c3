/// What this floor makes: the verification report, and pictures and sheet of a run.
#pragma once

#include <filesystem>
#include <set>
#include <string>
#include <vector>

#include "reports/pictures.hpp"

namespace talus::reports {

/// How reports are made, apart from what is in them.
struct ToolPaths {
  std::filesystem::path resources;  ///< holds templates/, gnuplot/ and pandoc/
  unsigned jobs{1};                 ///< processes at a time
};

/// Where templates/, gnuplot/ and pandoc/ are: share/talus beside the folder of the executable when installed, else
/// the source tree it was built from. Throws OutputError when neither holds them.
[[nodiscard]] std::filesystem::path find_resources();

/// Files that were made, the warnings of the tools that made them, and a line for each tool that is missing or failed,
/// without which the other files were not made.
struct Made {
  std::vector<std::filesystem::path> files;
  std::string warnings;
  std::string unmade;
};

/// Makes the volumes report/verification and report/verification-details, each as .md and .pdf, the site
/// report/html/index.html with a page for each case, and report/figures/, from verify/results.json and the CSV files in
/// verify/<id>/. All appear together at the end, or none. What needs a tool that is missing or fails is left out, and an
/// earlier one removed: pictures without gnuplot (text and tables then say so), HTML and PDF without pandoc, PDF
/// without pdflatex. Throws RecordError when a record is wrong, OutputError when a folder is, FileError.
///
/// A figure that cannot be drawn is an error, except in a case that broke off (error, timeout, missing): there the
/// page says why.
Made make_report(const std::filesystem::path& verify, const std::filesystem::path& report, const ToolPaths& tools);

/// Draws into `target`: figures and pages in each of the formats (ps, pdf, svg, png), films as GIF, players as HTML.
/// Players need no tool: without gnuplot they are made alone. Throws RecordError as demand_sound() and plot_of() do,
/// OutputError when a tool fails and nothing is made, FileError when a file cannot be written.
Made make_pictures(Pictures pictures, const std::filesystem::path& target, const std::set<std::string>& formats,
                   const ToolPaths& tools);

/// Draws the figures that run/plot.json describes, with the points of the CSV files beside it; else as make_pictures().
Made make_plots(const std::filesystem::path& run, const std::filesystem::path& target,
                const std::set<std::string>& formats, const ToolPaths& tools);

/// Makes run/sheet.pdf and run/sheet.html, one page each, from run/sheet.json; without gnuplot both without pictures,
/// without pdflatex the HTML alone. Throws as make_report() does.
Made make_sheet(const std::filesystem::path& run, const ToolPaths& tools);

/// Makes target/NAME.html from each NAME.md, the first as index.html, with contents and search on every page; `title`,
/// empty for that of the first page, is in the titles of all. Headings are found by the search. Throws RecordError when
/// a file does not begin with a heading, OutputError when pandoc is missing or fails, FileError.
Made make_pages(const std::vector<std::filesystem::path>& files, const std::string& title,
                const std::filesystem::path& target, const ToolPaths& tools);

/// Throws OutputError unless the programs that make_sheet() starts are in PATH.
void demand_sheet_tools();

}  // namespace talus::reports
