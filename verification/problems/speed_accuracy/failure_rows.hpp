#pragma once

#include <string>

#include "verification/check/case.hpp"

/// Rows of the case `failure_catalogue`. Each measures one failure of discrete-element codes where it occurs, by more
/// than an amount derived beforehand, and where it does not occur.
namespace talus::verification::problems {

/// Measured text of a row of the table: where the failure occurs, and where it does not.
struct FailureFound {
  std::string fails;
  std::string holds;
};

// Impacts and integration (failure_impacts.cpp, failure_steps.cpp).
[[nodiscard]] FailureFound check_one_sided_gain(Findings& findings, const Setup& setup);
[[nodiscard]] FailureFound check_heating(Findings& findings, const Setup& setup);
[[nodiscard]] FailureFound check_pull_at_end(Findings& findings, const Setup& setup);
[[nodiscard]] FailureFound check_clamped_restitution(Findings& findings, const Setup& setup);
[[nodiscard]] FailureFound check_hardly_a_rebound(Findings& findings, const Setup& setup);
[[nodiscard]] FailureFound check_many_rebounds(Findings& findings, const Setup& setup);
[[nodiscard]] FailureFound check_jump_at_touch(Findings& findings, const Setup& setup);
[[nodiscard]] FailureFound check_snatch(Findings& findings, const Setup& setup);
[[nodiscard]] FailureFound check_changed_step(Findings& findings, const Setup& setup);
[[nodiscard]] FailureFound check_overflow(Findings& findings, const Setup& setup);

// Shapes (failure_passing.cpp, failure_shapes.cpp).
[[nodiscard]] FailureFound check_long_step(Findings& findings, const Setup& setup);
[[nodiscard]] FailureFound check_deep_overlap(Findings& findings, const Setup& setup);
[[nodiscard]] FailureFound check_crossed_bars(Findings& findings, const Setup& setup);
[[nodiscard]] FailureFound check_corner_normal(Findings& findings, const Setup& setup);
[[nodiscard]] FailureFound check_common_normal(Findings& findings, const Setup& setup);
[[nodiscard]] FailureFound check_high_powers(Findings& findings, const Setup& setup);

// Contact history (failure_histories.cpp).
[[nodiscard]] FailureFound check_turned_history(Findings& findings, const Setup& setup);
[[nodiscard]] FailureFound check_creep(Findings& findings, const Setup& setup);
[[nodiscard]] FailureFound check_latch_reload(Findings& findings, const Setup& setup);
[[nodiscard]] FailureFound check_order_of_sums(Findings& findings, const Setup& setup);

}  // namespace talus::verification::problems
