#include "solver/app/drawing.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <unistd.h>

#include <CLI/CLI.hpp>
#include <cerrno>
#include <cstdlib>
#include <cstring>

#include "solver/app/report_tool.hpp"
#include "solver/base/error.hpp"
#include "solver/io/atomic_file.hpp"

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

int DrawingRecord::draw(const std::vector<std::string>& formats) const { return app::draw(folder_, target_, formats); }

}  // namespace talus::app
