#pragma once

#include <array>
#include <filesystem>
#include <string>
#include <utility>
#include <vector>

#include "verification/record/names.hpp"

/// interface.json: changes of single options, fields, columns and members of the program's interface, and the cases
/// that detected them.
namespace talus::records {

enum class InterfaceStatus {
  killed,     ///< a case failed
  survived,   ///< cases use it, and all passed with it changed
  refused,    ///< the program refuses what was changed
  unchanged,  ///< it has no value that could be changed where cases use it, for example a list without elements
  unused,     ///< no case uses it
};

template <>
struct Names<InterfaceStatus> {
  static constexpr std::array<std::pair<InterfaceStatus, const char*>, 5> values{
      {{InterfaceStatus::killed, "killed"},
       {InterfaceStatus::survived, "survived"},
       {InterfaceStatus::refused, "refused"},
       {InterfaceStatus::unchanged, "unchanged"},
       {InterfaceStatus::unused, "unused"}}};
};

/// An option, a field of a scene, a column, a member of a JSON file or an array of a state.
struct InterfaceItem {
  std::string kind{};                ///< "option", "field", "column", "member", "array"
  std::string name{};                ///< unique within its kind
  std::vector<std::string> cases{};  ///< that use it
  InterfaceStatus status{};
  std::string killed_by{};  ///< the first case that failed
  std::string check{};      ///< its first failed check, or the error that ended it
};

/// Writes interface.json. Throws FileError.
void write_interface(const std::vector<InterfaceItem>& items, const std::filesystem::path& file);

/// Reads interface.json. Throws FileError, and RecordError if it violates the schema.
[[nodiscard]] std::vector<InterfaceItem> read_interface(const std::filesystem::path& file);

}  // namespace talus::records
