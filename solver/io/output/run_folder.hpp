#pragma once

#include <filesystem>
#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "solver/base/units.hpp"

namespace talus {

/// A body as pictures name it.
struct DrawnBody {
  std::string name;
  int number{};      ///< of the element (a fence: by the numbering of 1993) > 0; 0 if it has none of its own
  std::string kind;  ///< one of body_kinds
};

/// Kinds of bodies that pictures tell apart.
inline constexpr std::string_view body_kinds[] = {"ground", "rock", "column", "body"};

/// The files of a run that pictures are drawn from, by their names in its folder. Its states are either of bodies and
/// cables or of discs.
struct RunFiles {
  std::vector<std::string> histories;  ///< CSV; where two hold a quantity, the first one counts
  std::string geometry;                ///< index of the VTP series; empty if the run left none
  std::vector<DrawnBody> bodies;       ///< in the order of the model
  std::vector<std::string> cables;     ///< names, in the order of the model
  bool mirrored{};                 ///< all off z = 0 stands for its mirror image too, as in the half model of a fence
  std::optional<double> period{};  ///< of discs: after how far along x their field repeats itself [L] > 0
};

/// What a run left in its folder for those who draw it.
struct RunFolder {
  std::filesystem::path folder;
  std::string title;
  std::optional<UnitSystem> units{si};  ///< none: the run named no system
  RunFiles files;

  /// Symbol of the unit of a dimension; empty where the run named no system.
  std::string unit(Dimension dimension) const;
};

/// The part of plot.json that read_run_folder reads.
[[nodiscard]] nlohmann::ordered_json run_folder_json(const std::string& title, const std::optional<UnitSystem>& units,
                                                     const RunFiles& files);

/// Reads FOLDER/plot.json. Errors: IoError if it cannot be read; InputError if it is not one that `talus run` or
/// `talus cell` writes.
[[nodiscard]] RunFolder read_run_folder(const std::filesystem::path& folder);

/// Removes what an earlier run of a scene or cell left in a folder: its records, sheet, histories, listing, geometry,
/// the pictures made of it, and unfinished files; but RESTART.DAT, from which another cell may start. Files of other
/// names stay, and files that cannot be removed.
void remove_run(const std::filesystem::path& folder);

/// For a run that is resumed in its folder: removes summary.json, which would say that all files are there, and the
/// temporary files of a program that was killed.
void remove_unfinished(const std::filesystem::path& folder);

/// The folder of a cell's states and a state in it, by its place in the series: "cell_states/cell_000003.vtp".
inline constexpr std::string_view cell_states_folder = "cell_states";
[[nodiscard]] std::string cell_state_name(std::size_t place);

}  // namespace talus
