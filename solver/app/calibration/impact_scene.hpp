#pragma once

#include <string>

#include "solver/app/calibration/calibrate_options.hpp"
#include "solver/base/units.hpp"
#include "solver/laws/law_list.hpp"

namespace talus::app {

/// What a scene of an impact requires besides the bodies of the options; SI units.
struct ImpactSceneRequest {
  ContactLaw law;
  double speed{};            ///< of approach
  double restitution{};      ///< at that speed
  double largest_overlap{};  ///< the bodies are large beside it
  double contact_time{};
  double step{};
};

/// Text of a scene (TOML, in these units) in which the bodies of the options meet at the speed of approach and part
/// again: a moving body 1 hits body 2 at rest, or body 2 hits a body 1 that is fixed. The line of impact is y = 0; the
/// centre or pin of a body 2 with --offset or --pivot is its arm below it. Errors: InputError naming the option.
[[nodiscard]] std::string impact_scene(const CalibrateOptions& options, const ImpactSceneRequest& request,
                                       const UnitSystem& units);

}  // namespace talus::app
