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

/// Writes the outlines and cables of a model in a state as one file of the series below.
class GeometryText {
 public:
  /// The Dynamics must outlive it.
  explicit GeometryText(const Dynamics& dynamics);

  /// The text of the file; none if a number in it is not finite.
  [[nodiscard]] std::optional<std::string> text(const Snapshot& snapshot) const;

 private:
  const Dynamics* dynamics_;
  std::vector<double> along_;                ///< place of each body along the fence [L]
  std::vector<std::vector<Vec2>> outlines_;  ///< of each body, in its own axes; closed but for a half-plane's
};

/// The geometry of a run as a series of VTK XML poly data, FOLDER/NAME_geometry/NAME_00000060.vtp, and its index
/// FOLDER/NAME.pvd, which ParaView opens. Each file holds poly lines in the scene's units: first the outlines of the
/// bodies, then the cables. Bodies and cables stand at their place z along the fence. A half-plane is drawn as far as
/// the scene reaches, a pinned body without a shape as its arm, another without a shape not at all. Cell data: `body`
/// (its number in the model, -1 for a cable), `cable` (-1 for an outline), `tension` (0 for an outline) and `slack` (1
/// for a cable without tension). Point data: `body` (-1 for a point of the world, as a cable's is where its hanger
/// broke). States are synchronised: positions at the time that the index gives.
class VtpSeries {
 public:
  /// Every `every` steps from the start on, and the last state. The Dynamics must outlive it. An index of before is
  /// removed. Errors: IoError.
  VtpSeries(const Dynamics& dynamics, std::filesystem::path folder, std::string name, long every);

  /// Writes a file if one is due and all its numbers are finite. That of a step with which the run stops gives way when
  /// it is taken on. Errors: IoError.
  void operator()(const Snapshot& snapshot, const StepInfo& info);
  /// Writes the index of the files written so far. Errors: IoError.
  void write_index() const;

  /// Names what it carries from one step to the next; one of the same run goes on from it.
  void serialize(Archive& archive);
  /// After it was put back: copies the files written so far from the folder in which they were, if that is another, but
  /// for that of the stop. Errors: IoError for one that is missing.
  void bring_files(const std::filesystem::path& from);

 private:
  struct File {
    double time{};
    long step{};
  };
  /// From the index's folder.
  std::string path(const File& file) const;
  void remove_stop();

  std::filesystem::path folder_;
  std::string name_;
  long every_;
  GeometryText geometry_;
  std::vector<File> files_;
  std::optional<File> of_stop_;  ///< of the step with which the run stopped, if none was due
};

}  // namespace talus
