#pragma once

#include <concepts>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "solver/base/archive.hpp"
#include "solver/dynamics/dynamics.hpp"
#include "solver/io/output/run_record.hpp"
#include "solver/io/scene/scene_file.hpp"
#include "solver/run/observer.hpp"
#include "solver/run/snapshot.hpp"
#include "solver/scenes/fence_summary.hpp"

namespace talus::app {

/// The run whose output it is. What it refers to outlives the output.
struct OutputRequest {
  const SceneFile& file;
  const Dynamics& dynamics;
  std::filesystem::path folder;  ///< that receives the files
  std::string name;              ///< of the scene's file, without folder and extension: names files
  long frames{};                 ///< states of the geometry, evenly over the run; 0: the output's own number
  bool sheet{};                  ///< the engineer's sheet is wanted
};

/// The run when its files are written.
struct OutputSource {
  const RunRecord& record;
  const Snapshot& end;                  ///< of its last step
  const scenes::FenceMonitor* fence{};  ///< of a fence, else null
};

/// A kind of file that a run leaves in its folder. A new one is a type in a file of this folder, and its name in the
/// list of run_outputs.hpp; it is then written, named in the summary, and carried over checkpoints.
///   T::name                    of its part of a checkpoint
///   T::make(request)           the output; none if the run has no such files. Errors: InputError for what the scene
///                              asks of it and it cannot give; IoError
///   output.write(source)       writes its files when the run has ended or is left. Errors: IoError
///   output.files()             their names in the folder, for the summary
/// Optional:
///   output(snapshot, info)     sees the start and every step
///   output.remember(memory)    names what it carries from one step to the next
///   output.bring_files(from)   after that was put back: brings what was written to the folder where the run stood
///   output.left_out()          what was asked for and does not exist, as notes of the summary
template <class T>
concept RunOutput = requires(T& output, const T& fixed, const OutputRequest& request, const OutputSource& source) {
  { T::name } -> std::convertible_to<std::string_view>;
  { T::make(request) } -> std::same_as<std::optional<T>>;
  fixed.write(source);
  { fixed.files() } -> std::same_as<std::vector<std::string>>;
};

template <class T>
concept StepwiseOutput = requires(T& output, const Snapshot& snapshot, const StepInfo& info) {
  output(snapshot, info);
};
template <class T>
concept LastingOutput = requires(T& output, Archive& archive) {
  output.serialize(archive);
};
template <class T>
concept BroughtOutput = requires(T& output, const std::filesystem::path& from) {
  output.bring_files(from);
};
template <class T>
concept PartialOutput = requires(const T& output) {
  { output.left_out() } -> std::convertible_to<std::vector<std::string>>;
};

/// An observer that remembers something else would lose it at a checkpoint.
template <class T>
concept CompleteOutput = RunOutput<T> &&(!StepwiseOutput<T> || LastingOutput<T>);

}  // namespace talus::app
