/// The two things this floor makes: the verification report, and the pictures of a run.
#pragma once

#include <filesystem>
#include <set>
#include <string>
#include <vector>

namespace talus::reports {

/// How reports are made, apart from what is in them.
struct Workplace {
  std::filesystem::path resources;  ///< holds templates/, gnuplot/ and pandoc/
  unsigned jobs{1};                 ///< processes at a time
};

/// Where templates/, gnuplot/ and pandoc/ are: share/talus beside the folder of the executable when installed, else
/// the source tree it was built from. Throws OutputError when neither holds them.
[[nodiscard]] std::filesystem::path find_resources();

/// Makes report/verification.md, .html, .pdf and report/figures/ from verify/results.json and the CSV files in
/// verify/<id>/. All appear together at the end, or none. Returns the warnings of the tools. Throws RecordError
/// when a record is wrong, OutputError when a file or tool is.
///
/// A figure that cannot be drawn is an error, except in a case that broke off (error, timeout, missing): there the
/// page says why.
std::string make_report(const std::filesystem::path& verify, const std::filesystem::path& report,
                        const Workplace& workplace);

/// Draws what run/plot.json asks for into `target`: figures and pages in each of the formats (ps, pdf, svg, png), films
/// as GIF, players as HTML. Returns the files' paths. Throws as make_report() does.
std::vector<std::filesystem::path> make_plots(const std::filesystem::path& run, const std::filesystem::path& target,
                                              const std::set<std::string>& formats, const Workplace& workplace);

/// Makes run/sheet.pdf and run/sheet.html, one page each, from run/sheet.json; returns the files' paths. Throws as
/// make_report() does.
std::vector<std::filesystem::path> make_sheet(const std::filesystem::path& run, const Workplace& workplace);

}  // namespace talus::reports
