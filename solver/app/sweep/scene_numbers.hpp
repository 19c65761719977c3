#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "solver/app/run/scene_run.hpp"
#include "solver/io/output/write_impacts.hpp"
#include "solver/io/scene/scene_file.hpp"
#include "solver/run/impact_log.hpp"
#include "solver/run/peak_log.hpp"
#include "solver/run/quantity.hpp"
#include "solver/scenes/fence_output.hpp"

namespace talus::app {

/// A number that is read of each run, with its unit.
struct SweepOutput {
  std::string name;
  Dimension dimension{};
};

/// Numbers that are read of one run of a scene of bodies, by their names:
///   "rock.vx.end"                     a reduced column of its history, see Quantity
///   "ball.y.peak[0]", ".peak_time[0]" a local maximum of a column, the first, see PeakLog
///   "impact.floor[0].touch_time"      a number of an impact of a contact, the first, see ImpactColumn
///   "fence.anchor_force"              a number of a fence's summary, see FenceOutput
class SceneNumbers {
 public:
  /// `file` must outlive this object. Errors: InputError for a number that the scene does not have.
  SceneNumbers(const SceneFile& file, const std::vector<std::string>& names);

  const std::vector<SweepOutput>& outputs() const { return outputs_; }
  /// Columns of the history that the run must record, in ascending order; see Recorder.
  [[nodiscard]] std::vector<std::size_t> columns() const;
  /// Results that the run of a fence must collect.
  [[nodiscard]] scenes::FenceResults of_fence() const;
  /// An observer of the run that collects what the run itself does not; none if it is not needed. This object and the
  /// run must outlive it.
  [[nodiscard]] Observer observer(const SceneRun& run);
  /// The numbers of an ended run, in units of its scene. One that does not exist, as of a third impact of a run with
  /// two, is NaN, and `reasons` gets why.
  [[nodiscard]] std::vector<double> values(const SceneRun& run, std::vector<std::string>& reasons) const;

 private:
  /// A number of the impact of a contact with this index, counted over the impacts of this contact.
  struct OfImpact {
    ContactId contact{};
    std::size_t index{};
    const ImpactColumn* column{};
  };
  /// The value or time of a local maximum with this index.
  struct OfPeak {
    std::size_t column{};
    std::size_t index{};
    bool time{};
    PeakLog log;
  };
  using Source = std::variant<Quantity, scenes::FenceOutput, OfImpact, OfPeak>;

  void add(const std::string& name);
  void add_fence_output(const std::string& name);
  void add_impact(const std::string& name);
  bool add_peak(const std::string& name);
  [[nodiscard]] std::optional<double> value(const Source& source, const SceneRun& run, std::string& reason) const;

  const SceneFile* file_;
  std::vector<SweepOutput> outputs_;
  std::vector<Source> sources_;
  std::optional<ImpactLog> impacts_;
};

}  // namespace talus::app
