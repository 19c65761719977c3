#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace talus {

/// One quantity of a history as it stands in its file.
struct SavedColumn {
  std::string name;            ///< "rock.vx", "element3.top_tension", "energy.kinetic", "time"
  std::string unit;            ///< its symbol, e.g. "ft/s"; empty if the file has none
  std::vector<double> values;  ///< one for each row

  /// What the quantity is of: "rock", "element3", "energy"; empty for "time".
  std::string subject() const;
  /// What it is: "vx", "top_tension", "kinetic"; "time".
  std::string quantity() const;
};

/// A history that a run left.
struct KeptHistory {
  std::filesystem::path file;
  std::vector<SavedColumn> columns;  ///< the first one is time

  /// The column of that name; null if there is none.
  const SavedColumn* find(const std::string& name) const;
};

/// Reads a history as csv() writes it; lines that begin with # are passed over. Errors: IoError; InputError with file,
/// line and what was found.
[[nodiscard]] KeptHistory read_history(const std::filesystem::path& file);

}  // namespace talus
