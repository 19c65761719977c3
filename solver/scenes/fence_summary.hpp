#pragma once

#include <array>
#include <string>
#include <vector>

#include "solver/run/history.hpp"
#include "solver/scenes/fence_element.hpp"
#include "solver/scenes/fence_scene.hpp"

namespace talus::scenes {

/// A force over a run. Components: x across the fence, y up, z along it.
struct ForceRecord {
  double peak{};       ///< its largest size [F]
  double peak_time{};  ///< [T]
  Vec3 at_peak{};      ///< the force then [F]
  Vec3 impulse{};      ///< its time integral over the run, what it is at rest included [F T]
};

/// What a fence did with a rock, the more serious the later; of a fence with several rocks the most serious one counts.
/// A rock has passed a column when it is beyond the column and beyond the column's position at the start.
enum class Verdict {
  stopped,        ///< it touched a column, has not passed all, and no longer advances (or only at 1 % of its speed)
  undecided,      ///< at the end of the run it still advances, or never reached the fence
  passed_under,   ///< it passed all columns that it can touch, the last one below the column's centroid
  passed_over,    ///< the same above it
  broke_through,  ///< it passed with a hanger or a cable broken
};

/// How a rock passed. It touches the fence while the law of a contact with a column acts.
struct RockPassage {
  std::string name;
  double mass{};  ///< [M]
  bool touched{};
  double touch_time{};       ///< of the first step at which it touches [T]
  Vec2 approach_velocity{};  ///< of the step before; as given, if it touches from the start or never [L/T]
  double approach_spin{};    ///< [rad/T]
  double approach_energy{};  ///< kinetic, of translation and rotation [F L]
  bool left{};               ///< it no longer touches at the last step
  double exit_time{};        ///< of the first step after its last touch; the last step's if it still touches [T]
  Vec2 exit_velocity{};      ///< then [L/T]
  double exit_spin{};        ///< [rad/T]
  double exit_energy{};      ///< [F L]
  bool turned{};             ///< between touch and exit its velocity along x changed sign
  double braking_time{};  ///< from the touch until the first step after which it no longer goes on along x; if it never
                          ///< turned, until its exit [T]
  double travel{};        ///< largest advance of its centre along x, from the touch to its exit [L]
  Verdict verdict{Verdict::undecided};
  double passed_time{};  ///< of the first step after which it has passed for good; 0 if it has not [T]
  Vec2 end_velocity{};   ///< at the last step [L/T]
  double end_energy{};   ///< kinetic, of translation and rotation, at the last step [F L]
  double highest{};      ///< largest height of its centre over the ground [L]
  double distance{};     ///< of its centre from the fence's plane at the last step [L]

  /// Share of the kinetic energy that it no longer has: (approach - exit)/approach. Work of gravity between the two is
  /// part of it.
  double energy_taken() const { return (approach_energy - exit_energy) / approach_energy; }
};

/// A column and its hanger, the joint of the top cable.
struct ColumnRecord {
  BodyId body{};
  int layer{};
  double limit{};        ///< pull at which the hanger breaks [F]; infinite where it cannot
  ForceRecord hanger{};  ///< sum of the top cable's pulls on the column; no z, which the segments balance
  double travel{};       ///< largest distance along x of its centre from its place at the start [L]
  double travel_time{};  ///< [T]

  double margin() const { return hanger.peak / limit; }
};

/// A segment of a cable.
struct SegmentRecord {
  CableId cable{};
  int layer{};
  bool top{};          ///< of the top cable, or else of the bottom cable
  double peak{};       ///< largest tension [F]
  double peak_time{};  ///< [T]
  double impulse{};    ///< time integral of the tension [F T]
  double limit{};      ///< tension at which it yields or breaks, whichever comes first [F]
  double margin() const { return peak / limit; }
};

/// A point of the world that holds cables, and the force on it.
struct AnchorRecord {
  std::size_t joint{};  ///< in CableForces::joints()
  int layer{};
  ForceRecord force{};  ///< of the cables on the anchor
};

/// Heights over the ground of a layer: of the lowest top joint, and of the highest bottom joint, below which a rock may
/// pass. Joints are points of the columns: of one that has lost its hanger too. Height is the distance to the ground.
struct LayerRecord {
  struct Height {
    double start{};
    double extreme{};  ///< least of the top, largest of the bottom [L]
    double extreme_time{};
    double end{};
  };
  Height top;
  Height bottom;
};

/// What a fence did in a run, as an engineer asks.
struct FenceSummary {
  std::vector<RockPassage> rocks;
  std::vector<ColumnRecord> columns;
  std::vector<SegmentRecord> segments;
  std::vector<AnchorRecord> anchors;
  std::vector<LayerRecord> layers;
  double travel{};  ///< largest of all columns' [L]
  State start;      ///< the first state
  State at_travel;  ///< the state of the largest travel

  /// Of the rock with which the fence did worst.
  Verdict verdict() const;
  /// The largest force on an anchor; nullptr where there is none.
  const AnchorRecord* largest_anchor() const;
  /// The largest tension, and the cable closest to its limit; nullptr where there is none.
  const SegmentRecord* largest_segment() const;
  const SegmentRecord* closest_segment() const;
  /// The same of the hangers.
  const ColumnRecord* largest_hanger() const;
  const ColumnRecord* closest_hanger() const;
};

/// Watches a fence's run and sums it up. Every step counts; integrals are trapezoids between steps.
class FenceMonitor {
 public:
  /// All arguments must outlive it.
  FenceMonitor(const Fence& fence, const FenceScene& made, const Dynamics& dynamics);

  void operator()(const Snapshot& snapshot, const StepInfo& info);
  /// Names what it carries from one step to the next; one of the same run goes on from it.
  void serialize(Archive& archive);

  const FenceSummary& summary() const { return summary_; }
  /// When a row is due, and at the last step: time, each rock's x, y and velocity along x, largest hanger force,
  /// largest tension of top and bottom segments.
  const History& history() const { return history_; }

 private:
  void list_parts();
  void list_places();
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
  const Workspace* now_{};  ///< of the state that is looked at
  const LawForces* forces_now_{};
  std::vector<BodyId> rocks_;
  std::vector<std::array<Vec2, 2>> joints_;  ///< top and bottom joint of each column, in its axes [L]
  std::vector<std::size_t> hangers_;         ///< joint of each column's hanger
  /// Modes of a contact.
  struct Modes {
    std::size_t first{};
    std::size_t count{};
  };
  std::vector<std::vector<Modes>> touching_;  ///< of each rock's contacts with columns
  FenceSummary summary_;
  History history_;
  double time_{};  ///< of the step before
  bool begun_{false};
  std::vector<double> touch_x_;    ///< of each rock at its touch
  std::vector<double> last_spin_;  ///< of each rock, at the step before [rad/T]
  /// A rock and a column that it can touch.
  struct Crossing {
    std::size_t column{};  ///< in FenceSummary::columns
    bool beyond{};         ///< the rock has passed it
    Verdict how{Verdict::undecided};
    double time{};  ///< [T]
  };
  std::vector<std::vector<Crossing>> crossings_;  ///< of each rock
  std::vector<double> directions_;                ///< +-1: along x, in which each rock comes
  /// The ground, which stands still.
  struct Ground {
    Vec2 p_W;          ///< its origin [L]
    Vec2 up_W;         ///< normal of a plane one
    const Body* body;  ///< of one that is not plane, else null
    Pose pose;
    double height(Vec2 p) const { return body ? height_over(*body, pose, p) : dot(p - p_W, up_W); }
  };
  Ground ground_;
  /// A cable that ends at an anchor.
  struct AnchoredCable {
    std::size_t cable{};
    double way{};    ///< 1 if the anchor is at its end A, else -1
    double along{};  ///< from end A to end B, along the fence [L]
  };
  std::vector<std::vector<AnchoredCable>> anchored_;  ///< of each anchor
  /// A point of a column at which cables may end.
  struct ColumnJoint {
    std::size_t body{};
    Vec2 p;               ///< in the column's axes [L]
    std::size_t joint{};  ///< of the cables, while it is on the column
  };
  struct LayerJoints {
    std::vector<ColumnJoint> top, bottom;  ///< of the layer's columns
  };
  std::vector<LayerJoints> of_layer_;
  bool cabled_{true};           ///< cables end at all of them
  std::vector<double> rest_x_;  ///< of each column's centre [L]
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
