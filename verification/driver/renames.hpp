#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace talus::verification {

/// A case, or a check or control of a case.
struct ItemName {
  std::string id;    ///< Id of the case.
  std::string item;  ///< Name of the check, "control: NAME" for a control; empty: the case itself.

  friend auto operator<=>(const ItemName&, const ItemName&) = default;
};

/// Item name of a control.
[[nodiscard]] std::string control_item(const std::string& name);

/// "case", "case/check" or "case/control: name".
[[nodiscard]] std::string text_of(const ItemName& name);

/// One line of a file of renames.
struct Renaming {
  ItemName before;                ///< The name in the baseline.
  std::optional<ItemName> after;  ///< The present name; no value: removed on purpose.
  std::string location;           ///< "FILE:LINE", for errors.
};

/// Reads a file of renames, one per line:
///
///     # a comment
///     old_case -> new_case
///     old_case/old check name -> new_case/new check name
///     old_case/control: old name -> new_case/control: new name
///     old_case/old check name -> -
///
/// `-` marks items that were removed on purpose. IoError if the file cannot be read; InputError with file and line for
/// a line of another form, a name that two lines rename, or a new name that two lines give.
[[nodiscard]] std::vector<Renaming> read_renames(const std::filesystem::path& file);

}  // namespace talus::verification
