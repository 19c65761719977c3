#pragma once

#include <filesystem>
#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "solver/base/units.hpp"

namespace talus {

/// Name and kind of a body for pictures.
struct DrawnBody {
  std::string name;
  int number{};      ///< of the element (in a fence: by the numbering of 1993) > 0; 0 if it has none
  std::string kind;  ///< one of body_kinds
};

/// Kinds of bodies that pictures distinguish.
inline constexpr std::string_view body_kinds[] = {"ground", "rock", "column", "body"};

/// The files of a run from which pictures are drawn, by their names in its folder. The states are either those of
/// bodies and cables or those of discs.
struct RunFiles {
  std::vector<std::string> histories;  ///< CSV; if two contain a quantity, the first one is used
  std::string geometry;                ///< index of the VTP series; empty if the run wrote none
  std::vector<DrawnBody> bodies;       ///< in the order of the model
  std::vector<std::string> cables;     ///< names, in the order of the model
  bool mirrored{};                     ///< all parts off z = 0 have a mirror image, as in the half model of a fence
  std::optional<double> period{};      ///< of discs: period of their field along x [L] > 0
};

/// Data in the folder of a run from which its pictures are drawn.
struct RunFolder {
  std::filesystem::path folder;
  std::string title;
  std::optional<UnitSystem> units{si};  ///< empty: the run has no unit system
  RunFiles files;

  /// Symbol of the unit of a dimension; empty if the run has no unit system.
  std::string unit(Dimension dimension) const;
};

/// The part of plot.json that read_run_folder reads.
[[nodiscard]] nlohmann::ordered_json run_folder_json(const std::string& title, const std::optional<UnitSystem>& units,
                                                     const RunFiles& files);

/// Checks that a folder contains the files of a run. Errors: IoError that says what was found in its place.
void demand_run_folder(const std::filesystem::path& folder);

/// Reads FOLDER/plot.json. Errors: IoError if it cannot be read; InputError if it is not one that `talus run` or
/// `talus cell` writes.
[[nodiscard]] RunFolder read_run_folder(const std::filesystem::path& folder);

/// Whether a run called `stem` gives files of its geometry such names: STEM_00000012.vtp.
[[nodiscard]] bool names_geometry(std::string_view file, const std::string& stem);

/// Removes the files that an earlier run of a scene or cell left in a folder: records, sheet, histories, listing,
/// geometry, the pictures made from it, and unfinished files; except RESTART.DAT, from which another cell may start.
/// `outputs`: names of files of runs that do not depend on the scene. Files with other names remain, as do files that
/// cannot be removed.
void remove_run(const std::filesystem::path& folder, const std::vector<std::string_view>& outputs);

/// Removes, for a run that is resumed in its folder, summary.json, which would indicate that all files are complete,
/// and the temporary files of a program that was killed.
void remove_unfinished(const std::filesystem::path& folder);

/// The folder of a cell's states, and the path of a state by its index in the series: "cell_states/cell_000003.vtp".
inline constexpr std::string_view cell_states_folder = "cell_states";
[[nodiscard]] std::string cell_state_name(std::size_t index);

}  // namespace talus
