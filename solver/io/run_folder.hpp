#pragma once

#include <filesystem>
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

/// The files of a run that pictures are drawn from, by their names in its folder.
struct RunFiles {
  std::vector<std::string> histories;  ///< CSV; where two hold a quantity, the first one counts
  std::string geometry;                ///< index of the VTP series
  std::vector<DrawnBody> bodies;       ///< in the order of the model
  std::vector<std::string> cables;     ///< names, in the order of the model
  bool mirrored{};  ///< all off z = 0 stands for its mirror image too, as in the half model of a fence
};

/// What a run left in its folder for those who draw it.
struct RunFolder {
  std::filesystem::path folder;
  std::string title;
  UnitSystem units{si};
  RunFiles files;
};

/// Reads FOLDER/plot.json. Errors: IoError if it cannot be read; InputError if it is not one that `talus run` writes.
[[nodiscard]] RunFolder read_run_folder(const std::filesystem::path& folder);

}  // namespace talus
