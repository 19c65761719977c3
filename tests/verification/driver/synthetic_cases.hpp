#pragma once

#include <string>
#include <vector>

#include "verification/check/case.hpp"
#include "verification/check/usage.hpp"

namespace talus::verification {

/// A case that runs `run` and is well formed in all other respects.
inline Case synthetic(const std::string& id, void (*run)(Findings&, const Setup&)) {
  return {.id = id,
          .title = "Synthetic case " + id,
          .family = "founding problems",
          .requirements = {{"Eq. 14", {"value"}}},
          .main_checks = {"value"},
          .source = "none",
          .page = "A page.\n\n**Evidence.** Property. Not shown: anything else.\n",
          .faults = {{"shifted", "the measured value is shifted", "value"}},
          .tier = Tier::quick,
          .time_limit = 20.0,
          .run = run};
}

/// Measures 1 within 0.1, or 2 with the fault: green without the fault, red with it.
inline void sound(Findings& findings, const Setup& setup) {
  findings.expect("value", setup.has("shifted") ? 2.0 : 1.05, 1.0, Tolerance::model(0.1, "chosen"));
}

}  // namespace talus::verification
