#include "verification/problems/fence/watched_summary.hpp"

#include "verification/study/toolkit.hpp"

namespace talus::verification::problems {
namespace {

/// All values of a summary, as a list of numbers.
class Numbers {
 public:
  explicit Numbers(const scenes::FenceSummary& summary) {
    for (const scenes::RockPassage& rock : summary.rocks) {
      add({rock.touched ? 1.0 : 0.0, rock.touch_time, rock.approach_velocity.x, rock.approach_velocity.y,
           rock.approach_spin, rock.approach_energy});
      add({rock.left ? 1.0 : 0.0, rock.exit_time, rock.exit_velocity.x, rock.exit_velocity.y, rock.exit_spin,
           rock.exit_energy, rock.turned ? 1.0 : 0.0, rock.braking_time, rock.travel});
      add({static_cast<double>(rock.verdict), rock.passed_time, rock.end_velocity.x, rock.end_velocity.y,
           rock.end_energy, rock.highest, rock.distance});
    }
    for (const scenes::ColumnRecord& column : summary.columns)
      add(column.hanger), add({column.travel, column.travel_time});
    for (const scenes::SegmentRecord& segment : summary.segments)
      add({segment.peak, segment.peak_time, segment.impulse});
    for (const scenes::AnchorRecord& anchor : summary.anchors)
      add(anchor.force);
    for (const scenes::LayerRecord& layer : summary.layers)
      for (const auto& height : {layer.top, layer.bottom})
        add({height.start, height.extreme, height.extreme_time, height.end});
    add({summary.travel, summary.start.t, summary.at_travel.t});
    for (const State* const state : {&summary.start, &summary.at_travel}) {
      all.insert(all.end(), state->q.begin(), state->q.end());
      all.insert(all.end(), state->v.begin(), state->v.end());
      all.insert(all.end(), state->mode.begin(), state->mode.end());
    }
  }

  std::vector<double> all;

 private:
  void add(std::initializer_list<double> numbers) { all.insert(all.end(), numbers); }
  void add(const scenes::ForceRecord& force) {
    add({force.peak, force.peak_time, force.at_peak.x, force.at_peak.y, force.at_peak.z, force.impulse.x,
         force.impulse.y, force.impulse.z});
  }
};

double differences(const std::vector<double>& a, const std::vector<double>& b) {
  double count = a.size() == b.size() ? 0.0 : 1.0;
  for (std::size_t i = 0; i < std::min(a.size(), b.size()); ++i)
    count += a[i] == b[i] ? 0.0 : 1.0;
  return count;
}

}  // namespace

WatchedSummary::WatchedSummary(const scenes::Fence& fence, const scenes::FenceScene& made, const Dynamics& dynamics,
                               double stop)
    : fence_{&fence},
      model_{&made.scene.model},
      watch_{fence, made, dynamics},
      resumed_{fence, made, dynamics},
      stop_{stop} {}

void WatchedSummary::operator()(const Snapshot& seen, const StepInfo& info) {
  watch_(seen, info);
  take_heights(seen);
  if (info.due) {
    double top = 0.0, bottom = 0.0;
    for (std::size_t c = 0; c < model_->cables.size(); ++c) {
      double& largest = model_->cables[c].name.starts_with("top") ? top : bottom;
      largest = std::max(largest, seen.forces().tensions[c]);
    }
    const std::vector<double>& row = watch_.history().rows.back();
    keep_worst(tension_error_, row[row.size() - 2] - top), keep_worst(tension_error_, row.back() - bottom);
    keep_worst(hanger_error_, row[row.size() - 3] - largest_hanger(seen));
  }
  if (!saved_.empty()) return resumed_(seen, info);
  if (seen.state().t < stop_) return;
  Archive saving;
  watch_.serialize(saving), saved_ = saving.items();
  Archive loading{saved_};
  resumed_.serialize(loading);
  at_resume_ = differences(Numbers{summary()}.all, Numbers{resumed()}.all);
}

/// Largest pull of the top cable on a column, at the joint above the column's centre.
double WatchedSummary::largest_hanger(const Snapshot& seen) const {
  const std::vector<Joint>& joints = seen.dynamics().cables().joints();
  const Workspace& pulled = seen.pulls();
  double largest = 0.0;
  for (std::size_t j = 0; j < joints.size(); ++j) {
    const bool broken = !pulled.topology.broken.empty() && pulled.topology.broken[j];
    if (joints[j].on_body && joints[j].p.y > 0.0 && !broken) largest = std::max(largest, norm(pulled.joints.force(j)));
  }
  return largest;
}

/// Records the heights of the lowest top joint, the highest bottom joint and the rock above the plane of the ground.
void WatchedSummary::take_heights(const Snapshot& seen) {
  const scenes::FenceElement& ground = fence_->ground;
  const Vec2 up{-std::sin(ground.angle), std::cos(ground.angle)};
  // A profile is level in this case.
  const std::vector<Vec2>& profile = fence_->ground_profile;
  const auto over_ground = [&](Vec2 p) {
    return profile.empty() ? dot(p - ground.position, up) - ground.b : p.y - profile.front().y;
  };
  double top = std::numeric_limits<double>::infinity(), bottom = -top;
  for (std::size_t i = 0; i < model_->bodies.size(); ++i) {
    const std::string& name = model_->bodies[i].name;
    if (!name.starts_with("column")) continue;
    double y_top = fence_->y_top, y_bottom = fence_->y_bottom;
    for (const scenes::ChangedColumn& changed : fence_->changed_columns) {
      if (name.ends_with(std::to_string(changed.number))) y_top = changed.y_top, y_bottom = changed.y_bottom;
    }
    const Pose at = pose(*model_, seen.state(), static_cast<BodyId>(i));
    const auto height = [&](double y) { return over_ground(at.p_WB + y * Vec2{-at.R_WB.sine, at.R_WB.cosine}); };
    top = std::min(top, height(y_top)), bottom = std::max(bottom, height(y_bottom));
  }
  scenes::LayerRecord::Height &lowest = heights_.top, &highest = heights_.bottom;
  const double time = seen.state().t;
  if (!started_) lowest.start = top, highest.start = bottom;
  if (!started_ || top < lowest.extreme) lowest.extreme = top, lowest.extreme_time = time;
  if (!started_ || bottom > highest.extreme) highest.extreme = bottom, highest.extreme_time = time;
  lowest.end = top, highest.end = bottom;
  const Vec2 rock = pose(*model_, seen.state(), *find_body(*model_, summary().rocks[0].name)).p_WB;
  rock_height_ = started_ ? std::max(rock_height_, over_ground(rock)) : over_ground(rock);
  rock_distance_ = std::abs(rock.x - fence_->column.position.x);
  started_ = true;
}

double WatchedSummary::resumed_differences() const {
  if (saved_.empty()) return std::nan("");
  double count = at_resume_ + differences(Numbers{summary()}.all, Numbers{resumed()}.all);
  const auto &rows = watch_.history().rows, &later = resumed_.history().rows;
  count += rows.size() == later.size() ? 0.0 : 1.0;
  for (std::size_t i = 0; i < std::min(rows.size(), later.size()); ++i)
    count += differences(rows[i], later[i]);
  return count;
}

double WatchedSummary::height_error() const {
  double worst = 0.0;
  const scenes::LayerRecord& found = summary().layers.at(0);
  keep_worst(worst, summary().rocks[0].highest - rock_height_);
  keep_worst(worst, summary().rocks[0].distance - rock_distance_);
  for (const auto& [is, exact] : {std::pair{&found.top, &heights_.top}, {&found.bottom, &heights_.bottom}})
    for (const auto member : {&scenes::LayerRecord::Height::start, &scenes::LayerRecord::Height::extreme,
                              &scenes::LayerRecord::Height::extreme_time, &scenes::LayerRecord::Height::end})
      keep_worst(worst, is->*member - exact->*member);
  return worst;
}

}  // namespace talus::verification::problems
