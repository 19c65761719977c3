/// The items that audits have tried so far, kept beside their results: an audit of all of them takes hours.
#pragma once

#include <filesystem>
#include <map>
#include <mutex>
#include <string>
#include <vector>

#include "verification/record/interface.hpp"

namespace talus::interface_audit {

/// Outcomes that still count. One is that of a program; a detected item counts as long as the case that detected it is
/// the same, another one as long as all cases that use it are, and no other case does.
class TriedItems {
 public:
  /// Reads what earlier audits of the same `program`, a text of letters and digits, have left beside `results`, and
  /// removes what audits of other programs have. `sources`: of each case a text that changes with it, without blanks.
  /// Throws records::FileError and RecordError.
  TriedItems(const std::filesystem::path& results, const std::string& program,
             const std::map<std::string, std::string>& sources);

  /// Gives the item, of which `cases` are known, its outcome if that counts; false if not.
  [[nodiscard]] bool find(records::InterfaceItem& item) const;
  /// Keeps the outcome of an item; thread-safe. Throws records::FileError.
  void add(const records::InterfaceItem& item);

 private:
  std::filesystem::path file_;
  std::vector<records::InterfaceItem> items_;
  std::mutex mutex_;
};

}  // namespace talus::interface_audit
