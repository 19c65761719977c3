/// interface_talus: takes the place of the program `talus` in the cases, with one item of its interface changed.
///
/// Environment: TALUS_INTERFACE_PROGRAM the real program; TALUS_INTERFACE_COMMANDS the commands of two names, each
/// between two ends of lines; TALUS_INTERFACE_LOG a file to which the items of this call
/// and its exit status are appended; TALUS_INTERFACE_ITEM the item to change, "rewrite" for none, with JSON files
/// written again (if it is not set nothing is changed, and the items of files are recorded).
/// Besides the items of files (interface_text.hpp) there are "option COMMAND --name" ("option talus --version" without
/// a command, "option sweep plan --out" with a command of a command), which is dropped from the command line with its
/// values, and "output COMMAND: member" of a JSON text on stdout.
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <map>
#include <regex>
#include <set>
#include <string>
#include <vector>

#include "reports/base/process.hpp"
#include "tests/interface/interface_text.hpp"
#include "verification/record/whole_file.hpp"

namespace {

namespace fs = std::filesystem;
using namespace talus;
using namespace talus::interface_audit;

std::string variable(const char* name) {
  const char* const value = std::getenv(name);
  return value == nullptr ? "" : value;
}

std::string help_of(const std::string& program, std::vector<std::string> command) {
  command.emplace_back("--help");
  return reports::run({program, command, {}, {}}).output;
}

/// The command of the arguments: none, one name, or two.
std::vector<std::string> command_of(const std::vector<std::string>& arguments) {
  if (arguments.empty() || arguments.front().starts_with("--")) return {};
  std::vector<std::string> command{arguments.front()};
  const std::string known = variable("TALUS_INTERFACE_COMMANDS");
  if (arguments.size() > 1 && known.find(fmt::format("\n{} {}\n", arguments[0], arguments[1])) != std::string::npos)
    command.push_back(arguments[1]);
  return command;
}

/// Number of values of an option among the arguments from `first` on, from the command's help: "--x TEXT",
/// "--x TEXT x 2" or "--x TEXT ..." (all up to the next option).
std::size_t values_of(const std::string& program, const std::vector<std::string>& command, const std::string& option,
                      const std::vector<std::string>& arguments, std::size_t first) {
  const std::string help = help_of(program, command);
  const std::regex line("\n  (-[a-z],)?" + option +
                        " +[A-Z]+(:[^\n]*[\\]}])?(=[^ \n]+)?( REQUIRED)?( x ([0-9]+)| \\.\\.\\.)?");
  std::smatch found;
  if (!std::regex_search(help, found, line)) return 0;
  if (found[6].matched) return std::stoul(found[6].str());
  if (!found[5].matched) return 1;
  std::size_t end = first;
  while (end < arguments.size() && !arguments[end].starts_with("--"))
    ++end;
  return end - first;
}

/// Files written by the program, before they were changed: read again by the next call in the same folder.
fs::path originals() {
  const fs::path here = fs::current_path();
  return here.parent_path() / ("originals_" + here.filename().string());
}

/// A checkpoint is read by the program alone: what is wrong in it shows in the resumed run.
bool is_output(const fs::path& file) {
  static const std::set<std::string> types{".csv", ".json", ".vtp", ".vtu"};
  return types.contains(file.extension().string()) && file.filename() != "checkpoint.json";
}

std::map<fs::path, std::string> outputs() {
  std::map<fs::path, std::string> texts;
  for (const auto& entry : fs::recursive_directory_iterator(fs::current_path())) {
    if (entry.is_regular_file() && is_output(entry.path())) texts[entry.path()] = records::read_whole(entry.path());
  }
  return texts;
}

void write(const fs::path& file, const std::string& text) { std::ofstream(file, std::ios::binary) << text; }

void restore_originals() {
  if (!fs::exists(originals())) return;
  for (const auto& entry : fs::recursive_directory_iterator(originals())) {
    const fs::path file = fs::current_path() / fs::relative(entry.path(), originals());
    if (entry.is_regular_file() && fs::exists(file)) write(file, records::read_whole(entry.path()));
  }
  fs::remove_all(originals());
}

void keep_original(const fs::path& file, const std::string& text) {
  const fs::path original = originals() / fs::relative(file, fs::current_path());
  fs::create_directories(original.parent_path());
  write(original, text);
}

}  // namespace

int main(int argc, char** argv) {
  const std::string program = variable("TALUS_INTERFACE_PROGRAM"), item = variable("TALUS_INTERFACE_ITEM");
  std::vector<std::string> arguments(argv + 1, argv + argc);
  const std::vector<std::string> parts = command_of(arguments);
  const std::string command = parts.empty() ? "talus" : fmt::format("{}", fmt::join(parts, " "));
  std::set<std::string> items;
  bool reached = false;

  std::vector<std::string> passed;
  for (std::size_t i = 0; i < arguments.size(); ++i) {
    const std::string name = arguments[i].substr(0, arguments[i].find('='));
    if (!name.starts_with("--")) {
      passed.push_back(arguments[i]);
      continue;
    }
    const std::string option = fmt::format("option {} {}", command, name);
    items.insert(option);
    if (option != item) {
      passed.push_back(arguments[i]);
      continue;
    }
    reached = true;
    if (name == arguments[i]) i += values_of(program, parts, name, arguments, i + 1);
  }

  std::vector<std::string> named = passed;
  if (std::ranges::find(passed, "--resume") != passed.end()) {  // the scene is found by the checkpoint
    for (const auto& entry : fs::directory_iterator(fs::current_path()))
      named.push_back(entry.path().filename().string());
  }
  std::map<fs::path, std::string> inputs;  // as they were
  std::set<std::string> fields;
  for (const std::string& argument : named) {
    const fs::path file = fs::current_path() / argument;
    if (!argument.ends_with(".toml") || !fs::is_regular_file(file) || inputs.contains(file)) continue;
    const std::string text = records::read_whole(file);
    if (item.empty()) fields.merge(items_of(file, text));
    // Only files of the case's folder are changed, not those of the source tree.
    if (const auto other = changed(file, text, item); other && !argument.starts_with("/")) {
      reached = true;
      inputs.emplace(file, text);
      write(file, *other);
    }
  }

  restore_originals();
  const auto before = outputs();
  reports::Finished finished = reports::run({program, passed, {}, {}});
  if (finished.status != 2) items.merge(fields);  // a refused file shows nothing about the fields that are right in it
  for (const auto& [file, text] : outputs()) {
    const auto earlier = before.find(file);
    const bool is_new = earlier == before.end() || earlier->second != text;
    if (is_new && item.empty()) items.merge(items_of(file, text));
    const auto other = item == "rewrite" ? rewritten(file, text) : changed(file, text, item);
    if (!other) continue;
    reached = reached || is_new;
    keep_original(file, text);
    write(file, *other);
  }
  for (const auto& [file, text] : inputs)
    if (fs::exists(file)) write(file, text);

  const fs::path printed = fmt::format("stdout.{}.json", fmt::join(parts, "."));  // "member *.COMMAND.json: ..."
  if (item.empty()) items.merge(items_of(printed, finished.output));
  const auto other = item == "rewrite" ? rewritten(printed, finished.output) : changed(printed, finished.output, item);
  if (other && finished.output.starts_with("{")) reached = true, finished.output = *other;

  std::string log;
  for (const std::string& each : items)
    log += each + "\n";
  log += fmt::format("exit {}\n", finished.status);
  if (reached) log += "reached\n";
  std::ofstream(variable("TALUS_INTERFACE_LOG"), std::ios::app) << log;
  std::fputs(finished.output.c_str(), stdout);
  std::fputs(finished.messages.c_str(), stderr);
  return finished.status;
}
