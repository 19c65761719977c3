#include "verification/study/program/program_run.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cstdlib>
#include <iterator>
#include <sstream>
#include <stdexcept>
#include <system_error>

#include "reports/base/process.hpp"
#include "verification/record/whole_file.hpp"

namespace talus::verification::problems {

TemporaryFolder::TemporaryFolder() {
  // Absolute: the program runs in it, with other names of files in it as its arguments.
  std::string name = (std::filesystem::absolute(std::filesystem::temp_directory_path()) / "talus_case_XXXXXX").string();
  if (!::mkdtemp(name.data()))
    throw std::filesystem::filesystem_error{"temporary folder", name, std::error_code{errno, std::generic_category()}};
  path_ = name;
}

TemporaryFolder::~TemporaryFolder() {
  std::error_code ignored;
  std::filesystem::remove_all(path_, ignored);
}

void TemporaryFolder::write(const std::string& name, const std::string& text) const {
  records::write_whole(path_ / name, text, records::Durability::later);
}

std::string TemporaryFolder::read(const std::string& name) const { return records::read_whole(path_ / name); }

ProgramEnd run_talus(const TemporaryFolder& folder, const std::vector<std::string>& arguments,
                     const Environment& environment) {
  const char* const other = std::getenv("TALUS_PROGRAM");
  const reports::Finished end = reports::run({.program = other != nullptr ? other : TALUS_PROGRAM,
                                              .arguments = arguments,
                                              .folder = folder.path(),
                                              .environment = environment});
  return {.exit_code = end.status, .output = end.output, .messages = end.messages};
}

ProgramEnd run_vtkhdf(const TemporaryFolder& folder, const std::vector<std::string>& arguments) {
  const reports::Finished end =
      reports::run({.program = TALUS_VTKHDF, .arguments = arguments, .folder = folder.path(), .environment = {}});
  return {.exit_code = end.status, .output = end.output, .messages = end.messages};
}

std::string talus_output(const TemporaryFolder& folder, const std::vector<std::string>& arguments,
                         const Environment& environment) {
  const ProgramEnd end = run_talus(folder, arguments, environment);
  if (end.exit_code != 0) {
    throw std::runtime_error{
        fmt::format("talus {} ended with {}: {}", fmt::join(arguments, " "), end.exit_code, end.messages)};
  }
  return end.output;
}

std::vector<GeometryState> geometry_states(const TemporaryFolder& folder, const std::string& out,
                                           const std::string& name) {
  const std::string index = folder.read(out + "/" + name + ".pvd");
  std::vector<GeometryState> states;
  for (std::size_t at = index.find("<DataSet"); at != std::string::npos; at = index.find("<DataSet", at + 1)) {
    const auto attribute = [&](const std::string& key) {
      const std::size_t from = index.find(key + "=\"", at) + key.size() + 2;
      return index.substr(from, index.find('"', from) - from);
    };
    states.push_back({std::stod(attribute("timestep")), folder.read(out + "/" + attribute("file"))});
  }
  return states;
}

std::vector<double> data_array(const std::string& text, const std::string& name) {
  const std::size_t head = text.find(fmt::format("Name=\"{}\"", name));
  if (head == std::string::npos) return {};
  const std::size_t from = text.find('>', head) + 1;
  std::istringstream numbers{text.substr(from, text.find('<', from) - from)};
  return {std::istream_iterator<double>{numbers}, {}};
}

std::vector<double> column(const records::Csv& table, const std::string& name) {
  const auto found =
      std::ranges::find_if(table.header(), [&](const std::string& head) { return head.starts_with(name + " ["); });
  const std::size_t at = table.column(found == table.header().end() ? name : *found);
  std::vector<double> values(table.rows());
  for (std::size_t row = 0; row < values.size(); ++row)
    values[row] = table.number(row, at);
  return values;
}

}  // namespace talus::verification::problems
