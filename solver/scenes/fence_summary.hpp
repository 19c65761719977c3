#pragma once

#include <array>
#include <string>
#include <vector>

#include "solver/run/history.hpp"
#include "solver/scenes/fence_element.hpp"
#include "solver/scenes/fence_scene.hpp"

namespace talus::scenes {

/// A force over a run. Components: x across the fence, y up, z along the fence.
struct ForceRecord {
  double peak{};       ///< its largest magnitude [F]
  double peak_time{};  ///< [T]
  Vec3 at_peak{};      ///< the force at that time [F]
  Vec3 impulse{};      ///< its time integral over the run, including the static force [F T]
};

/// Outcome of a rock's impact on a fence, in order of severity; for several rocks the most severe outcome counts. A
/// rock has passed a column when it is beyond the column and beyond the column's initial position.
enum class Verdict {
  stopped,        ///< it touched a column, has not passed all, and no longer advances (or only at 1 % of its speed)
  undecided,      ///< at the end of the run it still advances, or it never reached the fence
  passed_under,   ///< it passed all columns that it can touch, the last one below that column's centroid
  passed_over,    ///< as above, but above the centroid
  broke_through,  ///< it passed, and a hanger or a cable is broken
};

/// Passage of one rock. The rock touches the fence while the force law of a contact with a column is active.
struct RockPassage {
  std::string name;
  double mass{};  ///< [M]
  bool touched{};
  double touch_time{};       ///< of the first step with contact [T]
  Vec2 approach_velocity{};  ///< at the step before; the given initial velocity if it touches from the start or never
                             ///< [L/T]
  double approach_spin{};    ///< [rad/T]
  double approach_energy{};  ///< kinetic energy, translational and rotational [F L]
  bool left{};               ///< it has no contact at the last step
  double exit_time{};        ///< of the first step after its last contact; the last step's if it still touches [T]
  Vec2 exit_velocity{};      ///< at exit_time [L/T]
  double exit_spin{};        ///< [rad/T]
  double exit_energy{};      ///< [F L]
  bool turned{};             ///< its velocity along x changed sign between touch and exit
  double braking_time{};  ///< from the touch until the first step at which it no longer advances along x; if it never
                          ///< turned, until its exit [T]
  double travel{};        ///< largest advance of its centre along x, from touch to exit [L]
  Verdict verdict{Verdict::undecided};
  double passed_time{};  ///< of the first step after its final passage; 0 if it has not passed [T]
  Vec2 end_velocity{};   ///< at the last step [L/T]
  double end_energy{};   ///< kinetic energy, translational and rotational, at the last step [F L]
  double highest{};      ///< largest height of its centre above the ground [L]
  double distance{};     ///< of its centre from the plane of the fence at the last step [L]

  /// Fraction of the kinetic energy lost: (approach - exit)/approach. It includes the work of gravity in between.
  double energy_loss_fraction() const { return (approach_energy - exit_energy) / approach_energy; }
};

/// A column and its hanger (the joint with the top cable).
struct ColumnRecord {
  BodyId body{};
  int layer{};
  double limit{};        ///< pull at which the hanger breaks [F]; infinite if it cannot break
  ForceRecord hanger{};  ///< sum of the top cable's pulls on the column; z is zero because the segments balance
  double travel{};       ///< largest distance along x of its centre from its initial position [L]
  double travel_time{};  ///< [T]

  double margin() const { return hanger.peak / limit; }
};

/// A segment of a cable.
struct SegmentRecord {
  CableId cable{};
  int layer{};
  bool top{};          ///< of the top cable, otherwise of the bottom cable
  double peak{};       ///< largest tension [F]
  double peak_time{};  ///< [T]
  double impulse{};    ///< time integral of the tension [F T]
  double limit{};      ///< tension at which it yields or breaks, whichever comes first [F]
  double margin() const { return peak / limit; }
};

/// A fixed point that anchors cables, and the force on it.
struct AnchorRecord {
  std::size_t joint{};  ///< in CableForces::joints()
  int layer{};
  ForceRecord force{};  ///< force of the cables on the anchor
};

/// Heights of a layer's joints above the ground: the lowest top joint, and the highest bottom joint, below which a rock
/// may pass. Joints are points of the columns, also of a column whose hanger is broken. Height is the distance to the
/// ground.
struct LayerRecord {
  struct Height {
    double start{};
    double extreme{};  ///< minimum of the top joints, maximum of the bottom joints [L]
    double extreme_time{};
    double end{};
  };
  Height top;
  Height bottom;
};

/// Results of a fence in a run, for design.
struct FenceSummary {
  std::vector<RockPassage> rocks;
  std::vector<ColumnRecord> columns;
  std::vector<SegmentRecord> segments;
  std::vector<AnchorRecord> anchors;
  std::vector<LayerRecord> layers;
  double travel{};  ///< largest of all columns [L]
  State start;      ///< the first state
  State at_travel;  ///< the state of the largest travel

  /// The most severe verdict of all rocks.
  Verdict verdict() const;
  /// The anchor with the largest force; nullptr if there is none.
  const AnchorRecord* largest_anchor() const;
  /// The segment with the largest tension, and the one closest to its limit; nullptr if there is none.
  const SegmentRecord* largest_segment() const;
  const SegmentRecord* closest_segment() const;
  /// The same for the hangers.
  const ColumnRecord* largest_hanger() const;
  const ColumnRecord* closest_hanger() const;
};

/// The results that a FenceMonitor collects: all, or those of the rocks alone, from which the verdict follows, and the
/// heights at the start. Forces, travels and later heights are then zero.
enum class FenceResults { all, of_rocks };

/// Observer that summarises a fence's run. It uses every step; time integrals use the trapezoidal rule.
class FenceMonitor {
 public:
  /// The fence, its scene and the dynamics must outlive the monitor.
  FenceMonitor(const Fence& fence, const FenceScene& made, const Dynamics& dynamics,
               FenceResults results = FenceResults::all);

  void operator()(const Snapshot& snapshot, const StepInfo& info);
  /// Serializes the data carried from step to step; restore into a monitor of the same run.
  void serialize(Archive& archive);

  const FenceSummary& summary() const { return summary_; }
  /// Rows at output steps and at the last step: time, each rock's x, y and velocity along x, largest hanger force,
  /// largest tension of top and bottom segments. None with FenceResults::of_rocks.
  const History& history() const { return history_; }

 private:
  void list_parts();
  void list_positions();
  void add_column(const Joint& hanger, int layer);
  void begin(const State& state);
  void watch_rocks(const State& state);
  void watch_passing(std::size_t rock, const State& state);
  bool anything_broken(const State& state) const;
  void watch_columns(const State& state);
  void watch_cables(const State& state);
  void watch_anchors(const State& state);
  void watch_heights(const State& state);
  std::vector<double> row(const State& state) const;
  bool touches(std::size_t rock, const State& state) const;
  double kinetic(std::size_t rock, const State& state) const;

  const Fence* fence_;
  const FenceScene* made_;
  const Dynamics* dynamics_;
  FenceResults results_;
  const Workspace* now_{};         ///< of the state being processed
  const LawForces* forces_now_{};  ///< likewise; null with FenceResults::of_rocks
  std::vector<BodyId> rocks_;
  std::vector<std::array<Vec2, 2>> joints_;  ///< top and bottom joint of each column, in the column's axes [L]
  std::vector<std::size_t> hangers_;         ///< index of the joint of each column's hanger
  /// Modes of a contact in State::mode.
  struct Modes {
    std::size_t first{};
    std::size_t count{};
  };
  std::vector<std::vector<Modes>> touching_;  ///< for each rock, the modes of its contacts with columns
  FenceSummary summary_;
  History history_;
  double time_{};  ///< time of the previous step
  bool started_{false};
  std::vector<double> touch_x_;    ///< x of each rock at its touch
  std::vector<double> last_spin_;  ///< of each rock, at the previous step [rad/T]
  /// A rock and a column that it can touch.
  struct Crossing {
    std::size_t column{};  ///< in FenceSummary::columns
    bool beyond{};         ///< the rock has passed the column
    Verdict how{Verdict::undecided};
    double time{};  ///< [T]
  };
  std::vector<std::vector<Crossing>> crossings_;  ///< for each rock
  std::vector<double> directions_;                ///< +-1: sign of each rock's approach along x
  /// The fixed ground.
  struct Ground {
    Vec2 p_W;          ///< its origin [L]
    Vec2 up_W;         ///< normal of plane ground
    const Body* body;  ///< of ground that is not plane, otherwise null
    Pose pose;
    double height(Vec2 p) const { return body ? height_over(*body, pose, p) : dot(p - p_W, up_W); }
  };
  Ground ground_;
  /// A cable attached to an anchor.
  struct AnchoredCable {
    std::size_t cable{};
    double sign{};   ///< 1 if the anchor is at the cable's end A, else -1
    double along{};  ///< from end A to end B, along the fence [L]
  };
  std::vector<std::vector<AnchoredCable>> anchored_;  ///< for each anchor
  /// A point of a column where cables may be attached.
  struct ColumnJoint {
    std::size_t body{};
    Vec2 p;               ///< in the column's axes [L]
    std::size_t joint{};  ///< index of the cables' joint, as long as that is on the column
  };
  struct LayerJoints {
    std::vector<ColumnJoint> top, bottom;  ///< of the layer's columns
  };
  std::vector<LayerJoints> of_layer_;
  bool cabled_{true};           ///< every one of these points is a cable joint
  std::vector<double> rest_x_;  ///< initial x of each column's centre [L]
  std::vector<Vec3> last_hanger_, last_anchor_;
  std::vector<double> last_tension_;
};

}  // namespace talus::scenes

namespace talus {
template <>
struct Names<scenes::Verdict> {
  static constexpr std::array<std::string_view, 5> list{"stopped", "undecided", "passed_under", "passed_over",
                                                        "broke_through"};
};
}  // namespace talus
