#pragma once

#include <optional>
#include <vector>

#include "solver/base/archive.hpp"
#include "solver/dynamics/dynamics.hpp"
#include "solver/run/observer.hpp"
#include "solver/run/snapshot.hpp"

namespace talus {

/// An impact: an interval of time in which a contact acts, from the first observed state in which a law instance of the
/// contact is not open until the first in which all are open again. Forces and impulses are those of one contact, also
/// where it represents several (Contact::multiplicity). Bodies a and b are those of the contact, the normal points from
/// a to b, and the tangent is the normal turned counter-clockwise.
struct RecordedImpact {
  ContactId contact{};
  bool from_start{};         ///< the contact acts in the first state of the run
  bool ended{};              ///< the contact opened before the end of the run
  double touch_time{};       ///< the overlap passes zero, interpolated between two states [T]; of a contact from the
                             ///< start the time of the first state
  double separation_time{};  ///< likewise; 0 unless it ended [T]
  double approach_speed{};   ///< closing speed along the normal in the last state before the impact [L/T]; of a contact
                             ///< from the start in the first state
  double separation_speed{};  ///< opening speed in the first state after the impact; 0 unless it ended [L/T]
  double slip_before{};       ///< velocity of b past a along the tangent, in the same states [L/T]
  double slip_after{};
  double peak_force{};          ///< largest normal force of the observed states, > 0 pushes apart [F]
  double peak_force_time{};     ///< [T]
  double largest_overlap{};     ///< of the observed states [L]
  double normal_impulse{};      ///< time integral of the normal force, by the trapezoidal rule over the states [F T]
  double tangential_impulse{};  ///< of the friction force on b along the tangent [F T]
  Vec2 impulse;  ///< on b, world components; unlike the two above it allows for a normal that turns [F T]

  /// Separation speed over approach speed; none unless the impact ended and the bodies approached.
  [[nodiscard]] std::optional<double> restitution() const {
    if (!ended || !(approach_speed > 0.0)) return {};
    return separation_speed / approach_speed;
  }
};

/// Observer that records the impacts of a run, in the order in which they begin; those that begin in the same state in
/// the order of the contacts. Of a contact with several law instances (boundary nodes, ends of a side) forces are sums
/// over the instances, and speeds are those at the instance that overlaps most in the first and in the last state of
/// the impact: relative velocities, before and after, of the material points that are then at its contact point, along
/// its normal and tangent.
class ImpactLog {
 public:
  /// The Dynamics must outlive the log.
  explicit ImpactLog(const Dynamics& dynamics);

  void operator()(const Snapshot& snapshot, const StepInfo& info);

  /// Serializes the data carried from step to step; restore into a log of the same scene. Errors: InputError.
  void serialize(Archive& archive);

  const std::vector<RecordedImpact>& impacts() const { return impacts_; }

 private:
  /// Velocity of a body.
  struct Motion {
    Vec2 v;
    double w{};
  };
  /// Relative motion of two bodies at a contact point.
  struct Approach {
    double closing{};  ///< [L/T], > 0 while the bodies approach
    double slip{};     ///< of b past a [L/T]
  };
  /// The forces of a contact in one state.
  struct Forces {
    double normal{};
    double tangential{};  ///< on b
    Vec2 on_b;
  };
  /// An impact that has not ended, as of the last state.
  struct Acting {
    std::size_t impact{};    ///< in impacts_
    std::size_t instance{};  ///< the law instance that overlaps most
    Vec2 n_AB;               ///< its normal, from its body A to its body B
    Vec2 arm_A;              ///< its contact point from the centres of mass of its bodies A and B, world [L]
    Vec2 arm_B;
    Forces forces;
  };

  bool acts(const State& state, std::size_t contact) const;
  void follow(std::size_t contact, const Snapshot& snapshot);
  void locate(const Snapshot& snapshot, std::size_t contact, Acting& acting) const;
  Forces forces(const Snapshot& snapshot, std::size_t contact) const;
  void add(RecordedImpact& impact, const Forces& before, const Forces& after, double time) const;
  double crossing(std::size_t contact, double depth, double time) const;
  Approach approach(const Acting& acting, const std::vector<Motion>& motions) const;
  void serialize_impacts(Archive& archive);
  void serialize_acting(Archive& archive);

  const Dynamics* dynamics_;
  std::vector<RecordedImpact> impacts_;
  std::vector<std::optional<Acting>> acting_;  ///< one for each contact
  bool any_acting_{};
  // The last observed state.
  bool observed_{};
  double time_{};
  std::vector<Motion> motions_;  ///< one for each body
  std::vector<double> depths_;   ///< one for each contact [L]
  // Of the state being observed.
  std::vector<Motion> motions_now_;
  std::vector<double> friction_;  ///< one for each law instance [F]
};

}  // namespace talus
