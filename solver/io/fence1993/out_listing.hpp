#pragma once

#include <string>

#include "solver/run/observer.hpp"
#include "solver/run/run_plan.hpp"
#include "solver/scenes/fence_scene.hpp"

namespace talus {

/// The listing NAME.OUT of a fence's run in the layout and number format of the 1993 program (Mustoe & Huttelmaier
/// 1993, Appendix II.5.2): echo of the deck, derived masses, stiffnesses and step, then the kinematics of all elements
/// every `print_every` steps, and where a run stops before its plan's end. Numbers are in the deck's units: ft, slug,
/// lbf, s; in^2 and psi for cables.
///
/// A state is printed as the integrator holds it. With the lagged and the plain central difference that is, as in
/// 1993, velocities at the time printed and coordinates half a step later (proved by the rock's fall in the printed
/// listing); other methods hold both at the same time. The state at t = 0 is not printed: whether the program printed
/// it is not known, and its report shows none. The number of blanks between columns is not known either.
class OutListing {
 public:
  /// `plan` is that of the run, whose step may not be the deck's. Fence and members must outlive the listing.
  OutListing(const scenes::Fence& fence, const scenes::FenceScene& made, const RunPlan& plan);

  /// Adds the state if one is due, or if the run stops with it before its plan's end; the latter gives way when the run
  /// is taken on.
  void operator()(const State& state, const StepInfo& info);

  /// Names what it carries from one step to the next; one of the same run goes on from it.
  void serialize(Archive& archive) { archive.text("text", text_); }

  std::string text() const { return text_ + of_stop_; }

 private:
  const scenes::Fence* fence_;
  const scenes::FenceScene* made_;
  std::string text_;
  std::string of_stop_;  ///< the state with which the run stopped, if none was due
};

}  // namespace talus
