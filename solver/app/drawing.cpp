#include "solver/app/drawing.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <CLI/CLI.hpp>
#include <cerrno>
#include <cstdlib>
#include <cstring>

#include "solver/base/error.hpp"
#include "solver/io/atomic_file.hpp"

extern char** environ;

namespace talus::app {
namespace {

namespace fs = std::filesystem;

fs::path find_report_tool() {
  std::error_code error;
  const fs::path self = fs::read_symlink("/proc/self/exe", error);
  std::vector<fs::path> places;
  if (!error) places.push_back(self.parent_path());
  const char* path = std::getenv("PATH");
  for (std::string_view rest = path != nullptr ? path : ""; !rest.empty();) {
    const std::size_t colon = std::min(rest.find(':'), rest.size());
    if (colon > 0) places.emplace_back(rest.substr(0, colon));
    rest.remove_prefix(std::min(colon + 1, rest.size()));
  }
  for (const fs::path& place : places) {
    if (const fs::path tool = place / "talus_report"; ::access(tool.c_str(), X_OK) == 0) return tool;
  }
  throw IoError{"talus_report draws the plots; it is neither beside talus nor in PATH"};
}

}  // namespace

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
  const std::string tool = find_report_tool().string();
  std::string words[] = {
      tool, "--plot", record.string(), "--to", target.string(), "--format", fmt::format("{}", fmt::join(formats, ","))};
  std::vector<char*> arguments;
  for (std::string& word : words)
    arguments.push_back(word.data());
  arguments.push_back(nullptr);
  pid_t child = 0;
  if (const int reason = ::posix_spawn(&child, tool.c_str(), nullptr, nullptr, arguments.data(), environ)) {
    throw IoError{fmt::format("{}: {}", tool, std::strerror(reason))};
  }
  int status = 0;
  while (::waitpid(child, &status, 0) < 0 && errno == EINTR) {
  }
  if (WIFEXITED(status)) return WEXITSTATUS(status);
  throw IoError{fmt::format("{}: ended by signal {}", tool, WTERMSIG(status))};
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
