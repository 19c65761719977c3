#include "solver/draw/drawing.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <charconv>
#include <cstdio>
#include <stdexcept>
#include <thread>
#include <utility>

#include "reports/base/error.hpp"
#include "reports/report.hpp"
#include "solver/base/error.hpp"
#include "solver/draw/disc_drawing.hpp"
#include "solver/io/file/atomic_file.hpp"
#include "solver/io/file/quantity_text.hpp"
#include "verification/record/utf8.hpp"

namespace talus::app {
namespace fs = std::filesystem;

void add_format_option(CLI::App& app, PictureOptions& options) {
  app.add_option("--format", options.formats,
                 fmt::format("formats, from {}; default the last three", fmt::join(reports::picture_formats, ", ")))
      ->delimiter(',')
      ->check(CLI::IsMember(reports::picture_formats));
}

void add_picture_options(CLI::App& app, PictureOptions& options) {
  app.add_option("--out", options.folder, "folder for the pictures; default plots/ in that of the (first) run");
  app.add_option("--name", options.name, "name of the picture's file, without its extension");
  app.add_option("--title", options.title, "title; default that of the run");
}

void add_colour_option(CLI::App& app, PictureOptions& options) {
  app.add_option("--colour", options.colour,
                 "what colours discs: speed, or force, the sum of a disc's contact forces; default speed")
      ->check(CLI::IsMember(names_of<DiscColour>()));
}

double option_time(const std::string& option, const std::string& text, const RunFolder& run, bool positive) {
  if (run.units) return option_quantity(option, text, dimension::time, *run.units, positive);
  double value = 0.0;
  const auto [end, failure] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (failure != std::errc{} || end != text.data() + text.size()) {
    throw InputError{fmt::format("{}: found \"{}\"; it must be a bare number: the run named no units", option, text)};
  }
  if (positive && !(value > 0.0)) throw InputError{fmt::format("{}: found \"{}\"; it must be > 0", option, text)};
  return value;
}

namespace {

reports::ToolPaths workplace() {
  return {reports::find_resources(), std::max(1U, std::thread::hardware_concurrency())};
}

/// Calls work() and converts the errors of reports/ into those of the solver.
template <class Work>
auto with_own_errors(Work&& work) {
  try {
    return work();
  } catch (const reports::RecordError& error) {
    throw InputError{error.what()};
  } catch (const reports::FileError& error) {
    throw IoError{error.what()};
  } catch (const reports::OutputError& error) {
    throw IoError{error.what()};
  } catch (const fs::filesystem_error& error) {
    throw IoError{error.what()};
  }
}

/// Writes to stderr after flushing stdout, because both streams may go to one file.
void print_warnings(const std::string& warnings) {
  std::fflush(stdout);
  std::fputs(records::shown_lines(warnings).c_str(), stderr);
}

/// Throws an error that lists the pictures or pages that could not be made, if any.
void throw_unmade(const reports::Made& made) {
  if (!made.unmade.empty()) throw IoError{made.unmade.substr(0, made.unmade.size() - 1)};
}

}  // namespace

void draw(DrawingRequest request) {
  for (const std::string& note : request.notes)
    fmt::print("{}\n", records::shown_lines(note));
  std::fflush(stdout);  // the notes are visible while the pictures are drawn
  demand_writable_folder(request.target);
  const reports::Made made = with_own_errors([&] {
    return reports::make_pictures(std::move(request.pictures), request.target,
                                  {request.formats.begin(), request.formats.end()}, workplace());
  });
  print_warnings(made.warnings);
  for (const fs::path& file : made.files)
    if (request.lists_files) fmt::print("{}\n", file.string());
  throw_unmade(made);
}

void remove_figures(const fs::path& folder, const std::vector<std::string>& beginnings) {
  if (!fs::is_directory(folder)) return;
  with_own_errors([&] {
    std::vector<fs::path> found;
    for (const fs::directory_entry& entry : fs::directory_iterator{folder}) {
      const std::string name = entry.path().filename().string(), format = entry.path().extension().string();
      const bool is_figure = format == ".svg" || format == ".pdf";
      if (is_figure && std::ranges::any_of(beginnings, [&](const std::string& of) { return name.starts_with(of); }))
        found.push_back(entry.path());
    }
    for (const fs::path& figure : found)
      fs::remove(figure);
  });
}

void draw_sheet(const fs::path& file) {
  try {
    const reports::Made made = with_own_errors([&] { return reports::make_sheet(file.parent_path(), workplace()); });
    print_warnings(made.warnings);
    throw_unmade(made);
  } catch (const std::runtime_error& error) {
    throw IoError{fmt::format("{}: the sheet is not complete; talus_report --sheet makes it from this file: {}",
                              file.string(), error.what())};
  }
}

void find_sheet_tools() {
  with_own_errors([] {
    static_cast<void>(reports::find_resources());
    reports::demand_sheet_tools();
  });
}

}  // namespace talus::app
