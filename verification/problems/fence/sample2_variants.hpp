#pragma once

#include <string>
#include <vector>

#include "verification/check/table.hpp"
#include "verification/problems/fence/sample2_run.hpp"

/// The rules by which the historical fence is run, each with what is known of it and a plain alternative.
namespace talus::verification::problems {

/// How a rule of 1993 is known.
enum class Mark {
  proved,    ///< matches every printed digit, or a closed form
  inferred,  ///< clearly the best of several variants tried
  fitted,    ///< chosen to match the printed numbers
  unknown,   ///< nothing in the report tells
};

struct Sample2Rule {
  std::string rule;
  Mark mark{};
  std::string source;       ///< where the report says it, or what it follows from
  std::string alternative;  ///< what stands in its place in the run compared
  Sample2Change change{};
};
[[nodiscard]] std::vector<Sample2Rule> sample2_rules();

/// Each rule with the deviations from the printed states when its alternative is run; first the rules as they are.
/// `evaluations` takes the force evaluations spent.
[[nodiscard]] Table rules_table(long& evaluations);

}  // namespace talus::verification::problems
