/// Entry points of this library: the verification report, and pictures and sheet of a run.
#pragma once

#include <filesystem>
#include <set>
#include <string>
#include <vector>

#include "reports/figures/pictures.hpp"

namespace talus::reports {

/// Resources and settings for making reports.
struct ToolPaths {
  std::filesystem::path resources;  ///< contains templates/, gnuplot/ and pandoc/
  unsigned jobs{1};                 ///< maximum number of processes at a time
  std::filesystem::path audits{};   ///< folder of recorded audits; empty: those of the reported run alone
};

/// Folder that contains templates/, gnuplot/ and pandoc/: share/talus beside the executable's folder when installed,
/// else the source tree of the build. Throws OutputError when neither contains them.
[[nodiscard]] std::filesystem::path find_resources();

/// Files that were made, the warnings of the tools, and a line for each tool that is missing or failed and for which
/// files could not be made.
struct Made {
  std::vector<std::filesystem::path> files;
  std::string warnings;
  std::string unmade;
};

/// Makes the volumes report/verification and report/verification-details, each as .md and .pdf, the site
/// report/html/index.html with a page for each case, report/figures/ and report/data/ (the points of the figures), from
/// verify/results.json, the CSV files in verify/<id>/ and audits (see records::read_audits()). All appear together at
/// the end, or none. What needs a tool that is missing or fails is left out, and an earlier one removed: pictures
/// without gnuplot (text and tables then say so), HTML and PDF without pandoc, PDF without pdflatex. Throws RecordError
/// when a record is wrong, OutputError when a folder is, FileError.
///
/// A figure that cannot be drawn is an error, except in an interrupted case (error, timeout, missing): then the page
/// gives the reason.
Made make_report(const std::filesystem::path& verify, const std::filesystem::path& report, const ToolPaths& tools);

/// Writes rounding.json: verify/results.json compared with verify/rounding/MODE/results.json, for the modes upward,
/// downward and toward_zero. Throws RecordError and FileError.
void write_rounding_audit(const std::filesystem::path& verify, const std::filesystem::path& file);

/// Draws into `target`: figures and pages in each of the formats (ps, pdf, svg, png), animations as GIF, players as
/// HTML. Players need no tool: without gnuplot only they are made. Throws RecordError as demand_sound() and plot_of()
/// do, OutputError if a tool fails and nothing is made, FileError if a file cannot be written.
Made make_pictures(Pictures pictures, const std::filesystem::path& target, const std::set<std::string>& formats,
                   const ToolPaths& tools);

/// Draws the figures described by run/plot.json, with the points of the CSV files beside it; otherwise as
/// make_pictures().
Made make_plots(const std::filesystem::path& run, const std::filesystem::path& target,
                const std::set<std::string>& formats, const ToolPaths& tools);

/// Makes sheet.pdf and sheet.html, one page each, from sheet.json in the folder of a run; without gnuplot both have no
/// pictures, without pdflatex only the HTML is made. In a folder of `talus capacity` it makes capacity.pdf and
/// capacity.html, from capacity.json and the figures in plots/. Throws as make_report() does.
Made make_sheet(const std::filesystem::path& folder, const ToolPaths& tools);

/// Draws the sketches of pages of cases (see sketch.hpp) as target/NAME-sketch-1.<format> ... from each NAME.md, for
/// the authors of pages. Throws RecordError with the file's name as page_sketches() does, and when a file has no
/// sketch, OutputError if gnuplot fails, FileError.
Made make_sketches(const std::vector<std::filesystem::path>& files, const std::filesystem::path& target,
                   const std::set<std::string>& formats, const ToolPaths& tools);

/// Makes target/NAME.html from each NAME.md, the first as index.html, with contents and search on every page; `title`,
/// empty for that of the first page, is in the titles of all. Headings are found by the search. Throws RecordError when
/// a file does not begin with a heading, OutputError when pandoc is missing or fails, FileError.
Made make_pages(const std::vector<std::filesystem::path>& files, const std::string& title,
                const std::filesystem::path& target, const ToolPaths& tools);

/// Throws OutputError unless the programs that make_sheet() starts are in PATH.
void demand_sheet_tools();

}  // namespace talus::reports
