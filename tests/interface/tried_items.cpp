#include "tests/interface/tried_items.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <sstream>

#include "verification/record/whole_file.hpp"

namespace talus::interface_audit {

namespace fs = std::filesystem;
using records::InterfaceItem;
using records::InterfaceStatus;

namespace {

using Sources = std::map<std::string, std::string>;

Sources read_sources(const fs::path& file) {
  Sources sources;
  if (!fs::exists(file)) return sources;
  std::istringstream lines{records::read_whole(file)};
  for (std::string id, source; lines >> id >> source;)
    sources[id] = source;
  return sources;
}

/// Removes what audits of other programs have left: files NAME.PROGRAM.tried and NAME.PROGRAM.cases.
void remove_others(const fs::path& results, const fs::path& file) {
  if (!fs::is_directory(results.parent_path())) return;
  std::vector<fs::path> others;
  for (const fs::directory_entry& entry : fs::directory_iterator{results.parent_path()}) {
    const fs::path& path = entry.path();
    const bool is_kept = path.extension() == ".tried" || path.extension() == ".cases";
    if (is_kept && path.filename().string().starts_with(results.filename().string() + ".") &&
        path.stem() != file.stem())
      others.push_back(path);
  }
  for (const fs::path& other : others)
    fs::remove(other);
}

}  // namespace

TriedItems::TriedItems(const fs::path& results, const std::string& program, const Sources& sources)
    : file_{results.string() + "." + program + ".tried"} {
  remove_others(results, file_);
  const fs::path of_cases = fs::path{file_}.replace_extension(".cases");
  if (fs::exists(file_)) items_ = records::read_interface(file_);
  const Sources earlier = read_sources(of_cases);
  const auto is_same = [&](const std::string& id) {
    const auto now = sources.find(id), then = earlier.find(id);
    return now != sources.end() && then != earlier.end() && now->second == then->second;
  };
  std::erase_if(items_, [&](const InterfaceItem& item) {
    return item.status == InterfaceStatus::killed ? !is_same(item.killed_by)
                                                  : !std::ranges::all_of(item.cases, is_same);
  });
  // In this order: items that do not count must be gone before their cases count as the same.
  if (items_.empty()) {
    fs::remove(file_);
  } else {
    records::write_interface(items_, file_);
  }
  std::string lines;
  for (const auto& [id, source] : sources)
    lines += fmt::format("{} {}\n", id, source);
  records::write_whole(of_cases, lines);
}

bool TriedItems::find(InterfaceItem& item) const {
  const auto found = std::ranges::find_if(
      items_, [&](const InterfaceItem& tried) { return tried.kind == item.kind && tried.name == item.name; });
  if (found == items_.end()) return false;
  const bool has_new_case = std::ranges::any_of(
      item.cases, [&](const std::string& id) { return std::ranges::find(found->cases, id) == found->cases.end(); });
  if (found->status != InterfaceStatus::killed && has_new_case) return false;
  item.status = found->status, item.killed_by = found->killed_by, item.check = found->check;
  return true;
}

void TriedItems::add(const InterfaceItem& item) {
  const std::lock_guard<std::mutex> lock{mutex_};
  std::erase_if(items_, [&](const InterfaceItem& tried) { return tried.kind == item.kind && tried.name == item.name; });
  items_.push_back(item);
  records::write_interface(items_, file_);
}

}  // namespace talus::interface_audit
