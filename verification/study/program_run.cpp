#include "verification/study/program_run.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <cstdlib>
#include <fstream>
#include <sstream>
#include <stdexcept>
#include <system_error>

#include "reports/process.hpp"

namespace talus::verification::problems {

TemporaryFolder::TemporaryFolder() {
  std::string name = (std::filesystem::temp_directory_path() / "talus_case_XXXXXX").string();
  if (!::mkdtemp(name.data()))
    throw std::filesystem::filesystem_error{"temporary folder", name, std::error_code{errno, std::generic_category()}};
  path_ = name;
}

TemporaryFolder::~TemporaryFolder() {
  std::error_code ignored;
  std::filesystem::remove_all(path_, ignored);
}

void TemporaryFolder::write(const std::string& name, const std::string& text) const {
  std::ofstream file{path_ / name, std::ios::binary};
  file << text;
  if (!file.flush()) throw std::runtime_error{fmt::format("{}: cannot be written", (path_ / name).string())};
}

std::string TemporaryFolder::read(const std::string& name) const {
  std::ifstream file{path_ / name, std::ios::binary};
  std::ostringstream text;
  if (!(file && text << file.rdbuf()))
    throw std::runtime_error{fmt::format("{}: cannot be read", (path_ / name).string())};
  return text.str();
}

ProgramEnd run_talus(const TemporaryFolder& folder, const std::vector<std::string>& arguments) {
  const reports::Finished end =
      reports::run({.program = TALUS_PROGRAM, .arguments = arguments, .folder = folder.path(), .environment = {}});
  return {.exit_code = end.status, .output = end.output, .messages = end.messages};
}

std::string talus_output(const TemporaryFolder& folder, const std::vector<std::string>& arguments) {
  const ProgramEnd end = run_talus(folder, arguments);
  if (end.exit_code != 0) {
    throw std::runtime_error{
        fmt::format("talus {} ended with {}: {}", fmt::join(arguments, " "), end.exit_code, end.messages)};
  }
  return end.output;
}

}  // namespace talus::verification::problems
