#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "solver/base/archive.hpp"
#include "solver/dynamics/dynamics.hpp"
#include "solver/run/observer.hpp"
#include "solver/run/snapshot.hpp"

namespace talus {

/// Writes the outlines and cables of a model in one state as one file of a VtpSeries.
class GeometryText {
 public:
  /// The Dynamics must outlive it.
  explicit GeometryText(const Dynamics& dynamics);

  /// The text of the file; empty if a number in it is not finite.
  [[nodiscard]] std::optional<std::string> text(const Snapshot& snapshot) const;

 private:
  const Dynamics* dynamics_;
  std::vector<double> along_;                ///< position of each body along the fence [L]
  std::vector<std::vector<Vec2>> outlines_;  ///< of each body, in body axes; closed, except a half-plane's
};

/// The geometry of a run as a series of VTK XML poly data, FOLDER/NAME_geometry/NAME_00000060.vtp, and its index
/// FOLDER/NAME.pvd, which ParaView opens. Each file holds poly lines in the scene's units: first the outlines of the
/// bodies, then the cables. Bodies and cables are drawn at their position z along the fence. A half-plane is drawn as
/// far as the scene extends, a pinned body without a shape as its arm, other bodies without a shape not at all. Cell
/// data: `body` (its number in the model, -1 for a cable), `cable` (-1 for an outline), `tension` (0 for an outline)
/// and `slack` (1 for a cable without tension). Point data: `body` (-1 for a point of the world, such as a cable's end
/// whose hanger broke). States are synchronised: positions are those at the time that the index gives.
class VtpSeries {
 public:
  /// Writes a file every `every` steps from the start on, and the last state. The Dynamics must outlive it. An existing
  /// index is removed. Errors: IoError.
  VtpSeries(const Dynamics& dynamics, std::filesystem::path folder, std::string name, long every);

  /// Writes a file if one is due and all its numbers are finite. A file written only because the run stops is removed
  /// when the run is resumed. Errors: IoError.
  void operator()(const Snapshot& snapshot, const StepInfo& info);
  /// Writes the index of the files written so far. Errors: IoError.
  void write_index() const;

  /// Saves or restores the list of files; a series of the same run continues from it.
  void serialize(Archive& archive);
  /// Copies, after restoring, the files written so far from the folder `from`, if it is another one; the file of a stop
  /// is not copied. Removes all other files of the series. Errors: IoError for a missing file.
  void bring_files(const std::filesystem::path& from);

 private:
  struct File {
    double time{};
    long step{};
  };
  /// Path relative to the index's folder.
  std::string path(const File& file) const;
  void remove_stop();

  std::filesystem::path folder_;
  std::string name_;
  long every_;
  GeometryText geometry_;
  std::vector<File> files_;
  std::optional<File> of_stop_;  ///< of the step with which the run stopped, unless it was due
};

}  // namespace talus
