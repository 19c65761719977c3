#include "tests/interface/tried_items.hpp"

#include <algorithm>

namespace talus::interface_audit {

namespace fs = std::filesystem;

TriedItems::TriedItems(const fs::path& results, const std::string& subject)
    : file_{results.string() + "." + subject + ".part"} {
  if (fs::exists(file_)) items_ = records::read_interface(file_);
  if (!fs::is_directory(results.parent_path())) return;
  std::vector<fs::path> others;
  for (const fs::directory_entry& entry : fs::directory_iterator{results.parent_path()}) {
    const std::string name = entry.path().filename();
    if (name.starts_with(results.filename().string() + ".") && name.ends_with(".part") && entry.path() != file_)
      others.push_back(entry.path());
  }
  for (const fs::path& other : others)
    fs::remove(other);
}

bool TriedItems::find(records::InterfaceItem& item) const {
  const auto found = std::ranges::find_if(
      items_, [&](const records::InterfaceItem& tried) { return tried.kind == item.kind && tried.name == item.name; });
  if (found == items_.end()) return false;
  item = *found;
  return true;
}

void TriedItems::add(const records::InterfaceItem& item) {
  const std::lock_guard<std::mutex> lock{mutex_};
  items_.push_back(item);
  records::write_interface(items_, file_);
}

void TriedItems::remove() const { fs::remove(file_); }

}  // namespace talus::interface_audit
