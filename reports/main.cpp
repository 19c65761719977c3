/// talus_report: reads records and writes Markdown, HTML, PDF and pictures.

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <CLI/CLI.hpp>
#include <cstdio>
#include <thread>

#include "reports/base/error.hpp"
#include "reports/numbers.hpp"
#include "reports/report.hpp"
#include "solver/command_line/usage_error.hpp"
#include "verification/record/utf8.hpp"

namespace {

struct Options {
  std::string verify;
  std::string report;
  std::string audits;
  std::string rounding;
  std::string plot;
  std::string to;
  std::string sheet;
  std::vector<std::string> site;
  std::vector<std::string> sketches;
  std::string title;
  bool check{};
  std::vector<std::string> formats{talus::reports::default_formats()};
  unsigned jobs{std::max(1U, std::thread::hardware_concurrency())};
};

void describe(CLI::App& app, Options& options) {
  app.description(
      "Writes verification.pdf, verification-details.pdf, both as .md, and html/index.html from the records of a "
      "verification run,\n"
      "or the pictures of one run (--plot), a site from Markdown (--site), or the sketches of pages (--sketches). Exit "
      "codes: 0 written, 1 a number of the report is not in the records (--check), 2 wrong usage or "
      "record, 4 a file or tool failed\n"
      "or a tool is missing; what can be made without it is there.");
  app.add_option("verify", options.verify, "folder with results.json and the cases' folders (build/verify)");
  app.add_option("report", options.report, "folder to write the report to (build/report)");
  app.add_option("--audits", options.audits,
                 "folder of recorded audits (verification/audits), for those that VERIFY does not have")
      ->check(CLI::ExistingDirectory);
  app.add_option("--rounding", options.rounding,
                 "write rounding.json: VERIFY compared with VERIFY/rounding/{upward,downward,toward_zero}");
  app.add_flag("--check", options.check,
               "do not write the report, but check the one in REPORT: each of its numbers must be in VERIFY");
  app.add_option("--plot", options.plot, "a run's folder: draw the figures of its plot.json");
  app.add_option("--to", options.to, "folder for the pictures, sketches or site; of --plot default its plots/");
  app.add_option("--sheet", options.sheet,
                 "folder of a fence's run or capacity: make sheet.pdf and sheet.html, or capacity.pdf and .html");
  app.add_option("--site", options.site, "Markdown files, the first page first: make a site of linked pages in --to");
  app.add_option("--sketches", options.sketches, "pages of cases (Markdown): draw their sketches in --to");
  app.add_option("--title", options.title, "title of the site; default the first page's");
  app.add_option("--format", options.formats,
                 fmt::format("formats of --plot and --sketches, from {}; default the last three",
                             fmt::join(talus::reports::picture_formats, ", ")))
      ->delimiter(',')
      ->check(CLI::IsMember(talus::reports::picture_formats));
  app.add_option("--jobs", options.jobs, "processes at a time; default the number of cores")
      ->check(talus::whole_between(1, 1024));
}

/// Writes to stderr after flushing stdout: both streams may go to one file.
void print_errors(const std::string& message) {
  std::fflush(stdout);
  std::fputs(message.c_str(), stderr);  // if stderr cannot be written, only the message is lost
}

/// Prints the files and the parts that could not be made; returns the exit status.
int print(const talus::reports::Made& made) {
  print_errors(made.warnings);
  for (const auto& file : made.files)
    fmt::print("{}\n", file.string());
  if (made.unmade.empty()) return 0;
  print_errors("talus_report: " + made.unmade);
  return 4;
}

/// Prints the numbers of the report that are not in the records; returns the exit status.
int check(const Options& options, const talus::reports::ToolPaths& tools) {
  const std::vector<std::string> wrong =
      talus::reports::unfounded_numbers(options.verify, options.report, tools.resources / "templates", tools.audits);
  if (wrong.empty()) return 0;
  std::string message = "talus_report: numbers of the report that are not in the records:\n";
  for (const std::string& number : wrong)
    message += fmt::format("  {}\n", number);
  print_errors(message);
  return 1;
}

int work(const Options& options) {
  const talus::reports::ToolPaths tools{talus::reports::find_resources(), options.jobs, options.audits};
  if (options.check) return check(options, tools);
  if (!options.rounding.empty()) {
    talus::reports::write_rounding_audit(options.verify, options.rounding);
    return 0;
  }
  const std::set<std::string> formats(options.formats.begin(), options.formats.end());
  if (!options.plot.empty()) {
    const std::filesystem::path run = options.plot;
    const std::filesystem::path target = options.to.empty() ? run / "plots" : std::filesystem::path{options.to};
    return print(talus::reports::make_plots(run, target, formats, tools));
  }
  if (!options.site.empty()) {
    const std::vector<std::filesystem::path> pages(options.site.begin(), options.site.end());
    return print(talus::reports::make_pages(pages, options.title, options.to, tools));
  }
  if (!options.sketches.empty()) {
    const std::vector<std::filesystem::path> pages(options.sketches.begin(), options.sketches.end());
    return print(talus::reports::make_sketches(pages, options.to, formats, tools));
  }
  if (!options.sheet.empty()) return print(talus::reports::make_sheet(options.sheet, tools));
  return print(talus::reports::make_report(options.verify, options.report, tools));
}

}  // namespace

int main(int argc, char** argv) {
  CLI::App app{"", "talus_report"};
  Options options;
  describe(app, options);
  talus::refuse_empty_values(app);
  try {
    app.parse(argc, argv);
    const bool rounding = !options.rounding.empty();
    const int jobs = (!options.verify.empty() && !options.report.empty()) + rounding + !options.plot.empty() +
                     !options.sheet.empty() + !options.site.empty() + !options.sketches.empty();
    if (jobs != 1 || options.verify.empty() != (options.report.empty() && !rounding)) {
      throw CLI::ValidationError(
          "give either two folders, VERIFY and REPORT, or VERIFY --rounding FILE, --plot DIR, --sheet DIR, "
          "--site FILES --to DIR, or --sketches FILES --to DIR");
    }
    if (options.check && options.report.empty()) throw CLI::ValidationError("--check requires VERIFY and REPORT");
    if (!options.audits.empty() && options.report.empty())
      throw CLI::ValidationError("--audits requires VERIFY and REPORT");
    if (!(options.site.empty() && options.sketches.empty()) && options.to.empty())
      throw CLI::ValidationError("--site and --sketches require --to (the folder that receives what is made)");
  } catch (const CLI::ParseError& wrong) {
    return talus::exit_of_parse(app, wrong);
  }
  try {
    return work(options);
  } catch (const talus::reports::RecordError& wrong) {
    print_errors(fmt::format("talus_report: {}\n", talus::records::shown_lines(wrong.what())));
    return 2;
  } catch (const std::exception& wrong) {
    print_errors(fmt::format("talus_report: {}\n", talus::records::shown_lines(wrong.what())));
    return 4;
  }
}
