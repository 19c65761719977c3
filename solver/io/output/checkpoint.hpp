#pragma once

#include <filesystem>
#include <string>
#include <string_view>

#include "solver/base/archive.hpp"

namespace talus {

/// State of a run between two steps, as stored in a file. Together with the scene's file it suffices to resume the run.
///
/// The file is JSON, one member a line, in this order:
///   schema                            version of this description: 4
///   talus                             version of the program; another may not give the same bits and is rejected
///   scene_file, scene_fnv1a           path of the scene's file and its hash: the run of a changed scene is not resumed
///   integrator, tolerance, step, end  as requested for the run, including options of the command line; times in the
///                                     scene's units
///   steps                             steps done
///   memory                            lists of numbers (with the fewest digits from which the same double is read;
///                                     "nan", "inf", "-inf" if not finite) and texts, by name: see Archive
///   fnv1a                             hash of everything above, to detect damage
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

/// FNV-1a hash of a text, 64 bits, in hexadecimal digits: detects accidental changes, not malicious ones.
[[nodiscard]] std::string fnv1a(std::string_view text);

/// Text of a checkpoint file; `program` is the program's version.
[[nodiscard]] std::string checkpoint_text(const Checkpoint& checkpoint, std::string_view program);

/// Reads a checkpoint. Errors: IoError; InputError naming file, field, what was found and what is allowed, for a file
/// that is damaged, truncated, or of another version of the format or the program.
[[nodiscard]] Checkpoint read_checkpoint(const std::filesystem::path& file, std::string_view program);

}  // namespace talus
