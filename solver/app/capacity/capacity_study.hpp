#pragma once

#include <algorithm>
#include <array>
#include <functional>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include "solver/app/capacity/capacity_file.hpp"
#include "solver/app/capacity/rock_runs.hpp"
#include "solver/app/sweep/sweep_base.hpp"
#include "solver/app/sweep/sweep_folder.hpp"
#include "solver/base/fields.hpp"
#include "solver/capacity/capacity_map.hpp"
#include "solver/scenes/fence_summary.hpp"

namespace talus::app {

/// How the run of a rock ended: as the fence's verdict, or without a result that can be used.
enum class RockEnd { stopped, undecided, passed_under, passed_over, broke_through, failed };

/// Numbers that are read of each run, as outputs of a sweep.
inline constexpr std::array<std::string_view, 6> capacity_outputs{"fence.anchor_force",  "fence.cable_force",
                                                                  "fence.hanger_force",  "fence.cable_margin",
                                                                  "fence.hanger_margin", "fence.exit_energy"};

/// One run of a rock.
struct RockTrial {
  Rock rock;  ///< without the small changes
  RockEnd end{};
  std::string reason;           ///< of a failed run
  std::vector<double> outputs;  ///< in SI units, in the order of capacity_outputs; empty if there are none
};

/// Trials of rocks that count together.
struct RockTrials {
  std::vector<RockTrial> trials;

  [[nodiscard]] std::array<std::size_t, 6> ends() const;  ///< number of trials by RockEnd
  [[nodiscard]] std::size_t stopped() const { return ends()[static_cast<std::size_t>(RockEnd::stopped)]; }
  /// Whether there are trials, and all failed: they say nothing about the fence.
  [[nodiscard]] bool all_failed() const;
  /// Values of an output in those trials that did not fail.
  [[nodiscard]] std::vector<double> values(std::size_t output) const;
};

/// The map of rocks of one height, spin and position. Its outcome is that the rock is stopped: undecided and failed
/// runs count as not stopped.
struct RockMap {
  Rock rock;  ///< its height, spin and position; its mass and speed have no meaning
  CapacityMap map;
  std::vector<RockTrials> nodes;  ///< by the number of the node (mass changes first)
  std::vector<MapState> states;   ///< likewise
  RockTrials audit;               ///< at nodes without any that are not open
  std::size_t contradicted{};     ///< number of these that ended otherwise than the state says
};

/// All runs that a capacity file asks for. Results are kept in the folder at once; a study that was ended at any time
/// continues with the runs that it lacks.
class CapacityStudy {
 public:
  /// Writes the folder's description. Errors: InputError if it has results of another base; IoError.
  CapacityStudy(const CapacityFile& file, const SweepFolder& folder, const SweepBase& base, const RockRuns& rocks,
                unsigned threads);

  /// Executes everything. `interrupted` ends it; `progress` gets the number of runs done. Returns whether all were
  /// executed.
  [[nodiscard]] bool run(const std::function<bool()>& interrupted, const std::function<void(std::size_t)>& progress);

  const CapacityFile& file() const { return *file_; }
  /// Units of the base.
  const UnitSystem& units() const { return rocks_->units(); }
  const std::vector<RockMap>& maps() const { return maps_; }
  const RockTrials& hazard() const { return hazard_; }
  /// The rock at a node.
  [[nodiscard]] Rock rock_at(const RockMap& map, MapNode node) const;
  /// Translational and rotational kinetic energy of a rock at its start [J].
  [[nodiscard]] double start_energy(const Rock& rock) const { return rocks_->start_energy(rock); }
  /// Every run that was requested, once.
  const std::vector<SweptRun>& runs() const { return runs_; }

 private:
  /// A rock to be run, with the purpose of its random numbers.
  struct Request {
    Rock rock;
    std::vector<std::uint32_t> purpose;
  };
  /// Trials of these rocks, in their order; nothing if it was interrupted.
  std::optional<std::vector<RockTrial>> executed(const std::vector<Request>& requests);
  bool run_map(RockMap& map);
  bool audit(RockMap& map);
  bool run_hazard();

  const CapacityFile* file_;
  const SweepFolder* folder_;
  const SweepBase* base_;
  const RockRuns* rocks_;
  unsigned threads_;
  std::function<bool()> interrupted_;
  std::function<void(std::size_t)> progress_;
  std::map<std::string, SweepResult> known_;
  std::vector<RockMap> maps_;
  RockTrials hazard_;
  std::vector<SweptRun> runs_;
  std::set<std::string> ids_;  ///< of these
};

}  // namespace talus::app

namespace talus {
template <>
struct Names<app::RockEnd> {
  /// The verdicts, then `failed`.
  static constexpr auto list = [] {
    std::array<std::string_view, Names<scenes::Verdict>::list.size() + 1> names{};
    std::ranges::copy(Names<scenes::Verdict>::list, names.begin());
    names.back() = "failed";
    return names;
  }();
};
}  // namespace talus
