#include <array>

#include "verification/problems/speed_accuracy/failure_rows.hpp"

namespace talus::verification::problems::failure_catalogue {
namespace {

/// A row of the table: the failure, the function that measures it, the case with its details, and the fault that
/// removes the failure (or its absence).
struct Failure {
  const char* name;
  FailureFound (*check)(Findings&, const Setup&);
  const char* depth;
  const char* fault;
  const char* planted;
  const char* turns_red;
};

constexpr std::array failures{
    Failure{"one-sided gain", check_one_sided_gain, "energy_gain", "smaller_step", "w h = 1.2",
            "one-sided gain: largest gain of speed at w h = 1.6, far below the limit 2"},
    Failure{"heating", check_heating, "energy_gain", "slight_dashpot", "a dashpot of damping ratio 0.001",
            "heating: mean of ln e over 128 phases at w h = 0.7"},
    Failure{"attraction at the end", check_pull_at_end, "restitution", "never_pulls", "the clamped rule for both",
            "pull_at_end/attractive"},
    Failure{"clamped restitution", check_clamped_restitution, "restitution", "solved_for_clamping",
            "the dashpot solved for the clamped rule", "clamped_restitution/eq_21"},
    Failure{"e to 0", check_hardly_a_rebound, "stability_maps", "half_the_step", "half the step",
            "e to zero: ln growth per step at w h = 0.3, dashpot for e = 0.01"},
    Failure{"e to 1", check_many_rebounds, "energy_gain", "leaky_box", "a dashpot of damping ratio 0.00001",
            "e to one: largest magnitude of ln v in all bounces in a box, velocity_verlet"},
    Failure{"jump at touch", check_jump_at_touch, "restitution", "located", "steps cut at the touch",
            "jump at touch: rms error of e at 50 steps, xi = 0.2, steps not cut"},
    Failure{"snatched cable", check_snatch, "slack_taut_slack", "no_dashpot", "a cable without a dashpot",
            "snatched cable: minimum of k x + c v while stretched without tension, over c e v0"},
    Failure{"change of step", check_changed_step, "", "step_kept", "constant step", "change_of_step"},
    Failure{"overflow", check_overflow, "", "soft_spring", "a stiffness and speed of 1",
            "overflow: end of the run because no step is short enough, stormer_cowell"},
    Failure{"tunnelling by step", check_long_step, "", "not_watched", "monitor off", "long_step/refused"},
    Failure{"tunnelling by overlap", check_deep_overlap, "", "not_watched_either", "monitor off", "deep_overlap/ended"},
    Failure{"vertex-free overlap", check_crossed_bars, "", "one_resultant", "one resultant instead of nodes",
            "crossed_bars/crossing"},
    Failure{"corner normal", check_corner_normal, "energy_slope", "off_the_diagonal", "a position beside the diagonal",
            "corner_normal/jump"},
    Failure{"common normal", check_common_normal, "nearest_points", "ellipses", "ellipses instead of n = 50",
            "common normal: fraction of pairs without a solution, radial Newton, n = 50"},
    Failure{"high powers", check_high_powers, "nearest_points", "exponent_50", "n = 50 instead of 1000",
            "high powers: positions, of six, with F or its gradient infinite or zero, n = 1000"},
    Failure{"history not turned", check_turned_history, "turning_pair", "spring_turned_along",
            "a stretch that rotates with the pair",
            "turned history: largest error of a friction force stored in world axes, over the force"},
    Failure{"creep", check_creep, "friction", "slope_too_steep", "a slope 1 % steeper than the angle of friction",
            "creep"},
    Failure{"latch reload", check_latch_reload, "latching_spring", "retained", "a history that is retained",
            "latch_reload/lost"},
    Failure{"order of sums", check_order_of_sums, "frame_invariance", "same_order", "the same order twice",
            "order of sums: acceleration by eight contacts, reversed minus listed order, over rounding"}};

/// Computes all rows; with a fault, only the row that it affects.
void run(Findings& findings, const Setup& setup) {
  Table table{
      .name = "failures",
      .caption = "Each failure: measured values where it occurs and where it does not, and the case with details.",
      .columns = {"failure", "where it occurs", "where it does not", "case"}};
  for (const Failure& failure : failures) {
    if (!setup.fault.empty() && !setup.has(failure.fault)) continue;
    const FailureFound found = failure.check(findings, setup);
    table.rows.push_back({failure.name, found.fails, found.holds, failure.depth[0] ? failure.depth : "here"});
  }
  if (!setup.coarse) findings.table(table);
}

std::vector<Fault> faults() {
  std::vector<Fault> all;
  for (const Failure& failure : failures)
    all.push_back({failure.fault, failure.planted, failure.turns_red});
  return all;
}

}  // namespace

Case definition() {
  return {.id = "failure_catalogue",
          .title = "Failure catalogue: both sides of each threshold",
          .family = "speed and accuracy",
          .requirements = {{"method.nodes", {"crossed_bars"}},
                           {"method.resultant", {"crossed_bars/plus_by_resultant"}},
                           {"pair.rectangle.rectangle", {"crossed_bars", "corner_normal"}},
                           {"pair.circle.circle", {"long_step", "deep_overlap"}},
                           {"law.latching_spring", {"latch_reload"}},
                           {"end_rule.attractive", {"pull_at_end"}},
                           {"end_rule.clamped", {"pull_at_end", "clamped_restitution"}}},
          .main_checks = {"crossed_bars/plus_overlap", "long_step/refused", "long_step/passages", "change_of_step",
                          "creep"},
          .source = "Mustoe & Huttelmaier 1993; Cundall & Strack 1979; Walton & Braun 1986; Schwager & Poeschel 2007",
          .faults = faults(),
          .full_seconds = 5.0,
          .run = run};
}

}  // namespace talus::verification::problems::failure_catalogue
