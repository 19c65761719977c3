#pragma once

#include <filesystem>
#include <string>
#include <string_view>

#include "solver/base/archive.hpp"

namespace talus {

/// A run that stands between two steps, as a file. With the scene's file it is all that is needed to resume the run.
///
/// The file is JSON, one member a line, in this order:
///   schema                            version of this description: 2
///   talus                             version of the program; another may not give the same bits and is refused
///   scene_file, scene_fnv1a           where the scene is, and its hash: of a changed scene the run is not resumed
///   integrator, tolerance, step, end  what the run was asked for, options of the command line included; times in the
///                                     scene's units
///   steps                             steps done
///   memory                            numbers (a list in the fewest digits that give the same double back; what is
///                                     not finite as "nan", "inf", "-inf") and texts, by name: see Archive
///   fnv1a                             hash of all above, to notice damage
struct Checkpoint {
  std::string scene_file;
  std::string scene_fnv1a;
  std::string integrator;
  double tolerance{};
  double step{};
  double end{};
  long steps{};  ///< steps done
  ArchiveItems memory;
};

/// FNV-1a of a text, 64 bits, in hexadecimal digits: against accidents, not against malice.
[[nodiscard]] std::string fnv1a(std::string_view text);

/// A checkpoint as text; `program` is the program's version.
[[nodiscard]] std::string checkpoint_text(const Checkpoint& checkpoint, std::string_view program);

/// Reads a checkpoint. Errors: IoError; InputError naming file, field, what was found and what is allowed, for a file
/// that is damaged, cut short, or of another version of the description or the program.
[[nodiscard]] Checkpoint read_checkpoint(const std::filesystem::path& file, std::string_view program);

}  // namespace talus
