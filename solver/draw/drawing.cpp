#include "solver/draw/drawing.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <unistd.h>

#include <CLI/CLI.hpp>
#include <cerrno>
#include <charconv>
#include <cstdlib>
#include <cstring>

#include "solver/base/error.hpp"
#include "solver/draw/report_tool.hpp"
#include "solver/io/file/atomic_file.hpp"
#include "solver/io/file/quantity_text.hpp"

namespace talus::app {
namespace fs = std::filesystem;

void add_format_option(CLI::App& app, PictureOptions& options) {
  app.add_option("--format", options.formats, "formats, from ps, pdf, svg, png; default the last three")
      ->delimiter(',')
      ->check(CLI::IsMember({"ps", "pdf", "svg", "png"}));
}

void add_picture_options(CLI::App& app, PictureOptions& options) {
  app.add_option("--out", options.folder, "folder for the pictures; default plots/ in that of the (first) run");
  app.add_option("--name", options.name, "name of the picture's file, without its extension");
  app.add_option("--title", options.title, "title; default that of the run");
}

void add_colour_option(CLI::App& app, PictureOptions& options) {
  app.add_option("--colour", options.colour,
                 "what colours discs: speed, or force, the sum of a disc's contact forces; default speed")
      ->check(CLI::IsMember({"speed", "force"}));
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

int draw(const fs::path& record, const fs::path& target, const std::vector<std::string>& formats) {
  return run_report_tool(
      {"--plot", record.string(), "--to", target.string(), "--format", fmt::format("{}", fmt::join(formats, ","))});
}

DrawingRecord::DrawingRecord(fs::path target) : target_{std::move(target)} {
  make_folder(target_);
  std::string name = (target_ / ".record.XXXXXX").string();
  if (::mkdtemp(name.data()) == nullptr) {
    throw IoError{fmt::format("{}: {}", target_.string(), std::strerror(errno))};
  }
  folder_ = name;
}

DrawingRecord::~DrawingRecord() {
  std::error_code none;
  fs::remove_all(folder_, none);
}

void DrawingRecord::add(const std::string& name, std::string_view text) const { write_whole(folder_ / name, text); }

void DrawingRecord::link(const std::string& name, const fs::path& file) const {
  std::error_code error;
  fs::create_symlink(fs::absolute(file), folder_ / name, error);
  if (error) throw IoError{fmt::format("{}: {}", (folder_ / name).string(), error.message())};
}

int DrawingRecord::draw(const records::Plots& plots, const std::vector<std::string>& formats) const {
  add("plot.json", text_of(plots));
  return app::draw(folder_, target_, formats);
}

}  // namespace talus::app
