#pragma once

#include <string>

#include "solver/run/observer.hpp"
#include "solver/run/run_plan.hpp"
#include "solver/scenes/fence_scene.hpp"

namespace talus {

/// The listing NAME.OUT of a fence's run in the layout and number format of the 1993 program (Mustoe & Huttelmaier
/// 1993, Appendix II.5.2): echo of the deck, derived masses, stiffnesses and step, then the kinematics of all elements
/// every `print_every` steps, and at the step at which a run stops before its plan's end. Numbers are in the deck's
/// units: ft, slug, lbf, s; in^2 and psi for cables.
///
/// A state is printed as the integrator stores it. The lagged and the plain central difference store, as in 1993,
/// velocities at the printed time and coordinates half a step later (proved by the rock's fall in the printed listing);
/// other methods store both at the same time. The state at t = 0 is not printed: it is unknown whether the 1993 program
/// printed it, and its report shows none. The number of blanks between columns is unknown, too.
class OutListing {
 public:
  /// `plan` is that of the run, whose step may differ from the deck's. `fence` and `made` must outlive the listing.
  OutListing(const scenes::Fence& fence, const scenes::FenceScene& made, const RunPlan& plan);

  /// Adds the state if one is due, or if the run stops with it before its plan's end; the latter is removed when the
  /// run is resumed.
  void operator()(const State& state, const StepInfo& info);

  /// Saves or restores the text; a listing of the same run continues from it.
  void serialize(Archive& archive) { archive.text("text", text_); }

  std::string text() const { return text_ + of_stop_; }

 private:
  const scenes::Fence* fence_;
  const scenes::FenceScene* made_;
  std::string text_;
  std::string of_stop_;  ///< the state with which the run stopped, unless it was due
};

}  // namespace talus
