#pragma once

#include <array>
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

/// Options of a run that concern its output files.
struct OutputOptions {
  long frames{};   ///< states of the geometry, evenly over the run; 0: the output's default
  bool sheet{};    ///< the engineer's sheet is requested
  bool impacts{};  ///< the table of impacts is requested
};

/// The run for which an output is made. The objects it refers to must outlive the output.
struct OutputRequest {
  const SceneFile& file;
  const Dynamics& dynamics;
  std::filesystem::path folder;  ///< folder that receives the files
  std::string name;              ///< name of the scene's file without folder and extension, for file names
  OutputOptions options{};
};

/// The run at the time its files are written.
struct OutputSource {
  const RunRecord& record;
  const Snapshot& end;                  ///< of the last step
  const scenes::FenceMonitor* fence{};  ///< null unless the scene is a fence
};

/// A kind of output files of a run. To add one, define a type in a file of this folder and add it to the list in
/// run_outputs.hpp; it is then written, listed in the summary, and saved in checkpoints.
///   T::name                    name of its part of a checkpoint
///   T::make(request)           the output; nothing if the run has no such files. Errors: InputError for requests of
///                              the scene that it cannot fulfil; IoError
///   output.write(source)       writes its files when the run has ended or is interrupted. Errors: IoError
///   T::fixed_files             names of its files that do not contain the scene's name, an array: another run into the
///                              folder removes them
/// Optional:
///   output.files()             names of its files in the folder, for the summary, unless they are fixed_files
///   output(snapshot, info)     called at the start and after every step
///   output.serialize(archive)  saves or restores its state between two steps
///   output.bring_files(from)   called after restoring: copies the files written so far from the folder of the
///                              interrupted run
///   output.report(record)      adds results and notes to the record of the run; called before write()
template <class T>
concept RunOutput = requires(T& output, const T& fixed, const OutputRequest& request, const OutputSource& source) {
  { T::name } -> std::convertible_to<std::string_view>;
  { T::make(request) } -> std::same_as<std::optional<T>>;
  {std::vector<std::string_view>{T::fixed_files.begin(), T::fixed_files.end()}};
  fixed.write(source);
};

template <class T>
concept StepwiseOutput = requires(T& output, const Snapshot& snapshot, const StepInfo& info) {
  output(snapshot, info);
};
template <class T>
concept NamesFiles = requires(const T& output) {
  { output.files() } -> std::same_as<std::vector<std::string>>;
};
template <class T>
concept SerializableOutput = requires(T& output, Archive& archive) {
  output.serialize(archive);
};
template <class T>
concept ResumableOutput = requires(T& output, const std::filesystem::path& from) {
  output.bring_files(from);
};
template <class T>
concept ReportingOutput = requires(const T& output, RunRecord& record) {
  output.report(record);
};

/// An output that observes steps must also serialize its state, otherwise it would be lost at a checkpoint; one without
/// fixed names must name its files.
template <class T>
concept CompleteOutput = RunOutput<T> &&
    (!StepwiseOutput<T> || SerializableOutput<T>)&&(NamesFiles<T> || !T::fixed_files.empty());

}  // namespace talus::app
