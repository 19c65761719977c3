#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace talus {

/// One quantity of a history, as written in its file.
struct SavedColumn {
  std::string name;            ///< "rock.vx", "element3.top_tension", "energy.kinetic", "time"
  std::string unit;            ///< its symbol, e.g. "ft/s"; empty if the file has none
  std::vector<double> values;  ///< one for each row

  /// The part of the name before the last dot: "rock", "element3", "energy"; empty for "time".
  std::string subject() const;
  /// The part of the name after the last dot: "vx", "top_tension", "kinetic"; "time".
  std::string quantity() const;
};

/// A history written by a run.
struct KeptHistory {
  std::filesystem::path file;
  std::vector<SavedColumn> columns;  ///< the first one is time

  /// The column with the given name; null if there is none.
  const SavedColumn* find(const std::string& name) const;
};

/// Reads a history as csv() writes it; lines that begin with # are skipped. Errors: IoError; InputError with file, line
/// and what was found.
[[nodiscard]] KeptHistory read_history(const std::filesystem::path& file);

}  // namespace talus
