/// The items that an audit has tried so far, kept beside its results: an audit takes more than an hour.
#pragma once

#include <filesystem>
#include <mutex>
#include <string>
#include <vector>

#include "verification/record/interface.hpp"

namespace talus::interface_audit {

class TriedItems {
 public:
  /// Reads what a stopped audit of the same `subject`, a text of letters and digits that names programs and cases, has
  /// left beside `results`, and removes what audits of others have. Throws records::FileError and RecordError.
  TriedItems(const std::filesystem::path& results, const std::string& subject);

  /// Gives the item its outcome if it was tried; false if not.
  [[nodiscard]] bool find(records::InterfaceItem& item) const;
  /// Keeps the outcome of an item; thread-safe. Throws records::FileError.
  void add(const records::InterfaceItem& item);
  /// Removes the file, at the end of an audit.
  void remove() const;

 private:
  std::filesystem::path file_;
  std::vector<records::InterfaceItem> items_;
  std::mutex mutex_;
};

}  // namespace talus::interface_audit
