#include "verification/driver/renames.hpp"

#include <fmt/format.h>

#include <map>
#include <sstream>
#include <string_view>

#include "solver/base/error.hpp"
#include "solver/io/file/toml_document.hpp"

namespace talus::verification {

namespace {

constexpr std::string_view control_prefix = "control: ";
constexpr std::string_view arrow = " -> ";

std::string trimmed(const std::string& text) {
  constexpr const char* blanks = " \t\r";
  const auto first = text.find_first_not_of(blanks);
  return first == std::string::npos ? "" : text.substr(first, text.find_last_not_of(blanks) - first + 1);
}

bool is_control(const ItemName& name) { return name.item.starts_with(control_prefix); }

[[noreturn]] void fail(const std::string& location, const std::string& found, const char* allowed) {
  throw InputError(fmt::format("{}: found '{}'; it must be {}", location, found, allowed));
}

/// Parses an item name; no value if a part of it is empty.
std::optional<ItemName> name_from(const std::string& text) {
  const auto slash = text.find('/');
  ItemName name{trimmed(text.substr(0, slash)), ""};
  if (slash != std::string::npos) {
    name.item = trimmed(text.substr(slash + 1));
    if (name.item.empty() || name.item == trimmed(std::string(control_prefix))) return std::nullopt;
  }
  if (name.id.empty()) return std::nullopt;
  return name;
}

Renaming renaming_from(const std::string& line, const std::string& location) {
  constexpr const char* form =
      "'old_case -> new_case', 'old_case/old check -> new_case/new check', "
      "'old_case/control: old name -> new_case/control: new name', or '-' on the right for what was removed";
  const auto at = line.find(arrow);
  if (at == std::string::npos || line.find(arrow, at + 1) != std::string::npos) fail(location, line, form);
  const std::string right = trimmed(line.substr(at + arrow.size()));
  const auto before = name_from(trimmed(line.substr(0, at)));
  if (!before) fail(location, line, form);
  if (right == "-") return {*before, std::nullopt, location};
  const auto after = name_from(right);
  if (!after) fail(location, line, form);
  if (before->item.empty() != after->item.empty()) fail(location, line, "a case on both sides, or a check on both");
  if (is_control(*before) != is_control(*after)) fail(location, line, "a check on both sides, or a control on both");
  if (*before == *after) fail(location, line, "two different names");
  return {*before, after, location};
}

}  // namespace

std::string control_item(const std::string& name) { return std::string(control_prefix) + name; }

std::string text_of(const ItemName& name) { return name.item.empty() ? name.id : name.id + "/" + name.item; }

std::vector<Renaming> read_renames(const std::filesystem::path& file) {
  std::error_code none;
  if (std::filesystem::is_directory(file, none)) throw IoError(file.string() + ": is a folder; it must be a text file");
  std::istringstream in(read_text(file));
  std::vector<Renaming> all;
  std::map<ItemName, std::string> renamed, given;
  std::string line;
  for (int number = 1; std::getline(in, line); ++number) {
    const std::string text = trimmed(line);
    if (text.empty() || text.front() == '#') continue;
    Renaming renaming = renaming_from(text, fmt::format("{}:{}", file.string(), number));
    if (const auto [other, is_new] = renamed.emplace(renaming.before, renaming.location); !is_new)
      fail(renaming.location, text_of(renaming.before),
           fmt::format("renamed once; {} renames it, too", other->second).c_str());
    if (renaming.after) {
      if (const auto [other, is_new] = given.emplace(*renaming.after, renaming.location); !is_new)
        fail(renaming.location, text_of(*renaming.after),
             fmt::format("given once; {} gives it, too", other->second).c_str());
    }
    all.push_back(std::move(renaming));
  }
  return all;
}

}  // namespace talus::verification
