#include <map>

#include "solver/calibrate/latching_calibration.hpp"
#include "solver/granular/disc_method.hpp"
#include "verification/problems/cell/disc_row.hpp"
#include "verification/reference/impacts/latching_impact.hpp"
#include "verification/reference/integration/stepped_latch.hpp"
#include "verification/study/impacts/plane_impact.hpp"
#include "verification/study/toolkit.hpp"

namespace talus::verification::problems::latching_restitution {
namespace {

struct Meeting {
  double ratio{};  ///< K1/K2
  double step{};   ///< [T]
  double phase{};  ///< fraction of a step before touch
  const char* method{"velocity_verlet"};
  double speed{1.0};   ///< of approach [L/T]
  double radius{8.0};  ///< [L]
};

struct Parting {
  double restitution{};   ///< NaN if the discs do not separate
  double contact_time{};  ///< until the force vanishes [T]; for methods whose modes are those at the end of a step
  double largest{};       ///< largest overlap [L]
  double residual{};      ///< overlap at which the force vanishes [L]
};

constexpr int latch_phases = 200;

/// Statistics of the restitution e over the phases.
struct PhasesOfLatch {
  double mean{}, deviation{};       ///< of e
  double minimum{}, maximum{};      ///< of e
  PhaseError found{}, predicted{};  ///< deviation of ln e from the predicted mean
  double beyond{};                  ///< largest difference of ln e from the prediction for the same impact
};

/// Time, overlap and force at the ends of steps, up to the first step without force.
struct Course {
  std::vector<double> time, depth, force;

  void add(double t, double d, double f) {
    if (!force.empty() && force.back() == 0.0) return;
    time.push_back(t), depth.push_back(d), force.push_back(f);
  }

  void summarize(double step, Parting& found) const {
    if (depth.size() < 4) return;
    // During unloading the force is linear in the overlap; its zero is the residual overlap.
    const std::size_t last = depth.size() - 1;
    const double slope = (force[last - 1] - force[last - 2]) / (depth[last - 1] - depth[last - 2]);
    found.residual = depth[last - 1] - force[last - 1] / slope;
    found.contact_time = time[last - 1] + step * (depth[last - 1] - found.residual) / (depth[last - 1] - depth[last]);
    found.largest = *std::max_element(depth.begin(), depth.end());
  }
};

Parting parting(const Meeting& meeting, Findings& findings, const Setup& setup) {
  const double given = setup.has("ratio_for_root") ? std::sqrt(meeting.ratio) : meeting.ratio;
  const double before = setup.has("gap_not_scaled") ? 0.5 : meeting.speed;
  FilledRow row = fill({.radius = meeting.radius,
                        .velocity = {0.5 * meeting.speed, -0.5 * meeting.speed},
                        .gap = {meeting.phase * meeting.step * before}});
  if (setup.has("one_disc_heavier")) row.shapes.inverse_mass[0] /= 1.01;
  DiscSystem system{row.shapes, {}, LatchingSpring{0.5, 0.5 / given, 0.0}, meeting.radius};
  Course course;
  const auto watch = [&](const auto& seen) {
    seen.for_each_contact(row.discs, [&](const auto& contact) {
      course.add(row.discs.t - meeting.phase * meeting.step, contact.depth, contact.force);
    });
  };
  Parting found{NAN, NAN, NAN, NAN};
  const auto maximum = static_cast<long>(40.0 / meeting.step + 2.0 * before / meeting.speed) + 1000;
  const bool over = run_row(system, row, make_disc_method(meeting.method), meeting.step, maximum, watch);
  findings.count(system.evaluations());
  if (!over) return found;
  found.restitution = (row.discs.vx[1] - row.discs.vx[0]) / meeting.speed;
  course.summarize(meeting.step, found);
  return found;
}

/// Phase i of `latch_phases`, evenly spread over a step.
double latch_phase(int i) { return (i + 0.5) / latch_phases; }

/// w1 h for a number of steps in a contact.
double latch_step(double steps_in_contact, double ratio) {
  return 0.5 * std::numbers::pi * (1.0 + std::sqrt(ratio)) / steps_in_contact;
}

PhasesOfLatch phases_of(const reference::SteppedLatch& latch, const char* method, Findings& findings,
                        const Setup& setup) {
  const double exact = reference::mean_restitution(latch);
  PhasesOfLatch found{.minimum = INFINITY, .maximum = -INFINITY};
  double squares = 0.0;
  for (int i = 0; i < latch_phases; ++i) {
    const double phase = latch_phase(i);
    const double e = parting({latch.ratio, latch.step, phase, method}, findings, setup).restitution;
    const double here = reference::stepped_restitution(latch, phase);
    found.mean += e / latch_phases, squares += e * e / latch_phases;
    found.minimum = std::min(found.minimum, e), found.maximum = std::max(found.maximum, e);
    found.found.add(std::log(e / exact)), found.predicted.add(std::log(here / exact));
    const double beyond = std::abs(std::log(e / here));
    keep_worst(found.beyond, beyond);
  }
  found.deviation = std::sqrt(std::max(0.0, squares - found.mean * found.mean));
  return found;
}

struct LatchScheme {
  const char* name;
  const char* label;
  reference::StepMap map;
};
constexpr std::array latch_schemes{LatchScheme{"euler", "Euler", reference::StepMap::euler},
                                   LatchScheme{"taylor", "Taylor", reference::StepMap::taylor},
                                   LatchScheme{"euler_cromer", "Euler-Cromer", reference::StepMap::leapfrog},
                                   LatchScheme{"velocity_verlet", "Verlet", reference::StepMap::leapfrog}};

using reference::SteppedLatch;

constexpr double shown_ratio = 0.49;
constexpr std::array steps_in_contact{5.0, 7.0, 10.0, 14.0, 20.0, 30.0, 40.0, 60.0, 85.0, 120.0};
constexpr std::array printed{5.0, 7.0, 10.0, 20.0, 30.0, 60.0, 120.0};

SteppedLatch latch_of(const LatchScheme& scheme, double steps) {
  return {shown_ratio, latch_step(steps, shown_ratio), scheme.map};
}

/// Statistics by scheme, then by steps in a contact.
using Measured = std::array<std::map<double, PhasesOfLatch>, latch_schemes.size()>;

Measured measure(Findings& findings, const Setup& setup) {
  Measured measured;
  for (std::size_t k = 0; k < latch_schemes.size(); ++k) {
    const bool fault = setup.has("verlet_for_euler") ? k == 0 : setup.has("verlet_for_taylor") && k == 1;
    const char* method = fault ? "velocity_verlet" : latch_schemes[k].name;
    for (const double steps : steps_in_contact)
      measured[k][steps] = phases_of(latch_of(latch_schemes[k], steps), method, findings, setup);
  }
  return measured;
}

void check_means(const Measured& measured, Findings& findings) {
  double worst = 0.0;
  for (std::size_t k = 0; k < latch_schemes.size(); ++k) {
    for (const auto& [steps, seen] : measured[k]) {
      const SteppedLatch latch = latch_of(latch_schemes[k], steps);
      const double error = seen.mean / reference::mean_restitution(latch) - 1.0;
      const double over = error / std::pow(latch.step / std::sqrt(shown_ratio), 4);
      keep_worst(worst, over);
    }
  }
  findings.expect_model(
      {"mean_by_four",
       "mean restitution by four methods, 5 to 120 steps in a contact: largest relative error over (w2 h)^4"},
      worst, 0.0, 0.02,
      "the prediction neglects the fourth order: half the variance of ln e over the phases, at most (z2^2/8)^2/2 = "
      "0.008 z2^4, and as much from the kinks of the force; z2 = 0.76 at five steps");
  const auto gains = [&](std::size_t scheme, double coarse, double fine) {
    const PhasesOfLatch &fails = measured[scheme].at(coarse), &works = measured[scheme].at(fine);
    findings.expect_true(
        {"gains_of_speed", fmt::format("{}: restitution above 1 at {} steps in a contact, below 1 at {}",
                                       latch_schemes[scheme].label, coarse, fine)},
        fails.minimum > 1.0 && works.maximum < 1.0,
        fmt::format(
            "at every phase; measured e >= {:.3f} and e <= {:.3f}; the full growth formula gives {:.3f} and {:.3f}",
            fails.minimum, works.maximum, reference::mean_restitution(latch_of(latch_schemes[scheme], coarse)),
            reference::mean_restitution(latch_of(latch_schemes[scheme], fine))));
  };
  gains(0, 10.0, 20.0);
  gains(1, 5.0, 10.0);
}

/// The leapfrog gains no energy in the mean; single impacts do beyond its stability limit.
void check_limit(Findings& findings, const Setup& setup) {
  const char* method = setup.has("euler_for_verlet") ? "euler" : "velocity_verlet";
  const auto of = [&](double steps) { return phases_of(latch_of(latch_schemes[3], steps), method, findings, setup); };
  const PhasesOfLatch beyond = of(1.8), before = of(2.9);
  findings.expect_true(
      {"stability_limit", "Verlet: restitution above 1 at some phases with 1.8 steps in a contact, at none with 2.9"},
      beyond.maximum > 1.0 && before.maximum < 1.0,
      fmt::format("w2 h is {:.2f} and {:.2f}, the stability limit 2; measured e from {:.2f} to {:.2f} (mean {:.2f}) "
                  "and from {:.2f} to {:.2f} (mean {:.2f})",
                  latch_step(1.8, shown_ratio) / std::sqrt(shown_ratio),
                  latch_step(2.9, shown_ratio) / std::sqrt(shown_ratio), beyond.minimum, beyond.maximum, beyond.mean,
                  before.minimum, before.maximum, before.mean));
}

void record(const Measured& measured, Findings& findings) {
  DataFile data{
      "restitution_by_step",
      {"method", "steps_in_contact", "w1_step", "phases", "mean", "deviation", "closed_form", "growth_in_full"},
      {}};
  for (std::size_t k = 0; k < latch_schemes.size(); ++k) {
    for (const auto& [steps, seen] : measured[k]) {
      const SteppedLatch latch = latch_of(latch_schemes[k], steps);
      data.rows.push_back(cells("{} | {} | {} | {} | {} | {} | {} | {}", latch_schemes[k].name, steps, latch.step,
                                latch_phases, seen.mean, seen.deviation, reference::leading_restitution(latch),
                                reference::mean_restitution(latch)));
    }
  }
  findings.data(data);
  Table table{
      .name = "restitution_by_step",
      .caption =
          "Restitution against steps in a contact, $K_1/K_2 = 0.49$: mean and standard deviation over 200 phases, and "
          "prediction of the full growth formula. Leapfrog: Euler-Cromer and Verlet, which are the same map.",
      .columns = {"$T/h$", "Euler", "predicted", "Taylor", "predicted", "leapfrog"}};
  for (const double steps : printed) {
    const auto cell = [&](std::size_t k) {
      const PhasesOfLatch& seen = measured[k].at(steps);
      return fmt::format("{:.4f} ± {:.4f}", seen.mean, seen.deviation);
    };
    const auto full = [&](std::size_t k) {
      return fmt::format("{:.4f}", reference::mean_restitution(latch_of(latch_schemes[k], steps)));
    };
    table.rows.push_back({fmt::format("{}", steps), cell(0), full(0), cell(1), full(1), cell(3)});
  }
  findings.table(table);
}

void draw_steps(const Measured& measured, Findings& findings) {
  std::vector<Series> all;
  for (std::size_t k = 0; k < latch_schemes.size(); ++k) {
    Series points{latch_schemes[k].label, {}, {}, k == 3 ? Style::crosses : Style::points};
    for (const auto& [steps, seen] : measured[k])
      points.add(steps, seen.mean);
    all.push_back(points);
  }
  for (const std::size_t k : {0UL, 1UL, 3UL}) {
    Series line{k == 3 ? "c = 0" : k == 0 ? "c = 1/4" : "c = 1/8", {}, {}, Style::lines};
    for (double steps = 5.0; steps < 121.0; steps *= 1.05)
      line.add(steps, reference::leading_restitution(latch_of(latch_schemes[k], steps)));
    all.push_back(line);
  }
  findings.figure(
      {.name = "restitution_against_step",
       .title = "Restitution against the step",
       .caption = "Mean over 200 phases, $K_1/K_2 = 0.49$. Lines: closed form. Above 1 impacts gain energy.",
       .x = {.label = "steps in a contact", .log = true, .min = 4.5, .max = 130.0},
       .y = {.label = "restitution", .min = 0.6, .max = 2.0},
       .series = all,
       .lines = {{'y', 1.0, "no loss"}}});
}

void draw_phases(Findings& findings, const Setup& setup) {
  constexpr double steps = 20.0 + 0.382;
  std::vector<Series> all;
  for (const std::size_t k : {0UL, 1UL, 3UL}) {
    const LatchScheme& scheme = latch_schemes[k];
    const SteppedLatch latch = latch_of(scheme, steps);
    const double mean = reference::mean_restitution(latch);
    Series points{k == 3 ? "leapfrog" : scheme.label, {}, {}, Style::points};
    Series line{fmt::format("{}, predicted", points.label), {}, {}, Style::lines};
    for (int i = 2; i < latch_phases; i += 5) {
      const double phase = latch_phase(i);
      points.x.push_back(phase), line.x.push_back(phase);
      points.y.push_back(
          std::log(parting({shown_ratio, latch.step, phase, scheme.name}, findings, setup).restitution / mean));
      line.y.push_back(std::log(reference::stepped_restitution(latch, phase) / mean));
    }
    all.push_back(points), all.push_back(line);
  }
  findings.figure({.name = "restitution_against_phase",
                   .title = "Effect of the phase of first contact on the restitution",
                   .caption = "Deviation of $\\ln e$ from its mean at 20.4 steps in a contact; lines: predicted.",
                   .x = {.label = "fraction of a step before first contact"},
                   .y = {.label = "deviation of ln e from its mean"},
                   .series = all});
}

/// Mean and deviation over the phases at 5 to 120 steps in a contact; steps at which methods gain energy; effect of the
/// phase.
void check_latching_table(Findings& findings, const Setup& setup) {
  const Measured measured = measure(findings, setup);
  check_means(measured, findings);
  check_limit(findings, setup);
  if (setup.coarse) return;
  record(measured, findings);
  draw_steps(measured, findings);
  draw_phases(findings, setup);
}

using reference::StepMap;

constexpr std::array ratios{0.25, 0.49, 0.81};
/// Steps in a contact. Not a whole number, because then the errors of touch and end would cancel.
constexpr double production = 60.0 + 0.382;

void check_verlet(Findings& findings, const Setup& setup) {
  double rms = 0.0, largest = 0.0, predicted_rms = 0.0, predicted = 0.0, over = 1.0;
  for (const double ratio : ratios) {
    const SteppedLatch latch{ratio, latch_step(production, ratio), StepMap::leapfrog};
    const PhasesOfLatch s = phases_of(latch, "velocity_verlet", findings, setup);
    const double e = std::sqrt(ratio);
    keep_worst(rms, e * s.found.rms()), keep_worst(largest, e * s.found.max());
    keep_worst(predicted_rms, e * s.predicted.rms()), keep_worst(predicted, e * s.predicted.max());
    over = worst_ratio(over, s.found.rms() / s.predicted.rms());
  }
  findings.expect_truncation(
      {"rms_error", "restitution by Verlet at 60 steps in a contact, rms error, largest of three ratios"}, rms, 0.0,
      predicted_rms, 3e-4 / predicted_rms, "3e-4 is required; the prediction for each impact gives two thirds of that");
  findings.expect_truncation(
      {"largest_error", "restitution by Verlet at 60 steps in a contact, largest error of 600 impacts"}, largest, 0.0,
      predicted, 1.1,
      "as predicted for each impact; 10 % is allowed for the difference between errors of e and of ln e, and for the "
      "fourth order");
  findings.expect_model(
      {"rms_over_predicted", "restitution by Verlet, rms error over its prediction, worst of three ratios"}, over, 1.0,
      0.005, "the prediction is of third order; (w2 h)^2 is at most 0.006");
}

/// Growth for w1 h <= 0.045 and K1/K2 >= 0.25.
void check_growth(Findings& findings, const Setup& setup) {
  for (const LatchScheme& scheme : {latch_schemes[0], latch_schemes[1]}) {
    const bool euler = scheme.map == StepMap::euler;
    const char* method = setup.has("methods_exchanged") ? (euler ? "taylor" : "euler") : scheme.name;
    double worst = 0.0, predicted = 0.0, beyond = 0.0, stated = 0.0;
    for (const double ratio : ratios) {
      for (const double step : {0.0113, 0.0271, 0.045}) {
        const SteppedLatch latch{ratio, step, scheme.map};
        const PhasesOfLatch s = phases_of(latch, method, findings, setup);
        const double form = reference::leading_restitution(latch);
        keep_worst(stated, stepped_restitution(make_disc_method(scheme.name), std::sqrt(ratio), step) / form - 1.0);
        keep_worst(worst, std::abs(s.mean - form));
        keep_worst(predicted, std::abs(reference::mean_restitution(latch) - form));
        keep_worst(beyond, s.beyond / std::pow(step / std::sqrt(ratio), 4));
      }
    }
    findings.expect_truncation(
        {fmt::format("mean_restitution/{}", scheme.label),
         fmt::format("mean restitution by {} against the closed form, w1 h <= 0.045, largest of nine errors",
                     scheme.label)},
        worst, 0.0, predicted, 1.2,
        euler ? "3e-4 is required; the closed form neglects the third order of growth"
              : "3e-4 is required; the closed form neglects (z2^2 - z1^2)/16");
    findings.expect_round_off(
        fmt::format("restitution by {} by which a step of a cell is judged, against the closed form", scheme.label),
        stated, 0.0, 1e-14, "an exponential and half a dozen operations");
    findings.expect_truncation(
        {"each_impact", fmt::format("ln e of each impact by {}: largest of 1800 errors over (w2 h)^4", scheme.label)},
        beyond, 0.0, euler ? 0.12 : 0.05, 1.2,
        "the prediction neglects the fourth order; the constant is measured on the map itself, against which the "
        "reference is tested");
  }
}

/// K1/K2 at which a restitution is 0.7, by bisection.
template <class Restitution>
double ratio_for_seven_tenths(const SteppedLatch& latch, Restitution&& restitution) {
  double low = 0.3, high = 0.7;
  for (int i = 0; i < 60; ++i) {
    const double middle = 0.5 * (low + high);
    (restitution(SteppedLatch{middle, latch.step, latch.map}) < 0.7 ? low : high) = middle;
  }
  return low;
}

/// SNOFLO's ratio 0.45, and the ratios that `talus calibrate` finds for a restitution of 0.7.
void check_history(Findings& findings, const Setup& setup) {
  for (const LatchScheme& scheme : {latch_schemes[0], latch_schemes[1]}) {
    const bool euler = scheme.map == StepMap::euler;
    const SteppedLatch latch{setup.has("ratio_of_exact_steps") ? 0.49 : 0.45, euler ? 0.02177 : 0.0434, scheme.map};
    const PhasesOfLatch s = phases_of(latch, scheme.name, findings, setup);
    findings.expect_model({fmt::format("snoflo/{}", scheme.label),
                           fmt::format("restitution with K1/K2 = 0.45 by {} at w1 h = {}", scheme.label, latch.step)},
                          s.mean, 0.7, euler ? 7e-6 : 3.5e-5,
                          "5e-4 is required; half a unit of the last digit of w1 h, times c pi (1 + w2/w1) e");
    const double step = setup.has("step_of_another_contact") ? 1.01 * latch.step : latch.step;
    const SteppedContact contact{1.0, 1.0, step, make_disc_method(scheme.name)};
    findings.expect_round_off(fmt::format("K1/K2 for a restitution of 0.7 by {}, calibrated by formula", scheme.label),
                              ratio_by_formula(contact, 0.7),
                              ratio_for_seven_tenths(latch, reference::leading_restitution), 2e-15,
                              "Lambert function against bisection: about ten roundings of 0.45, of 5.6e-17 at most, "
                              "and an exponential each, and twice that");
    findings.expect_truncation(
        fmt::format("K1/K2 for a restitution of 0.7 by {}, calibrated by simulation", scheme.label),
        ratio_by_simulation(contact, 0.7), ratio_for_seven_tenths(latch, reference::mean_restitution),
        0.0125 * std::pow(latch.step / std::sqrt(0.45), 4) * 0.9, 2.0,
        "the prediction neglects the fourth order of the mean restitution, the fraction 0.0125 (w2 h)^4 of e and twice "
        "that of the ratio");
  }
}

void check_times(Findings& findings, const Setup& setup) {
  double time = 0.0, largest = 0.0, residual = 0.0, of_time = 0.0, of_depth = 0.0;
  for (const double ratio : ratios) {
    const auto exact = reference::latching_events({0.5, 0.5 / ratio, 0.0, 0.5, 1.0});
    const double z1 = latch_step(production, ratio), z2 = z1 / std::sqrt(ratio);
    for (int i = 0; i < latch_phases; ++i) {
      const Parting seen = parting({ratio, z1, latch_phase(i)}, findings, setup);
      keep_worst(time, std::abs(seen.contact_time / exact.contact_time - 1.0));
      keep_worst(largest, std::abs(seen.largest / exact.largest_depth - 1.0));
      keep_worst(residual, std::abs(seen.residual / exact.residual_depth - 1.0));
    }
    keep_worst(of_time, z1 * z2 / 24.0), keep_worst(of_depth, 0.125 * z1 * z1);
  }
  const auto expect = [&](const std::string& what, double error, double predicted, const char* why) {
    findings.expect_truncation(
        {"at_60_steps/" + what, what + " at 60 steps in a contact, largest relative error of 600 impacts"}, error, 0.0,
        predicted, 1.2, why);
  };
  expect("contact time", time, of_time, "1e-3 is required; the leapfrog's period is shorter by the fraction z1 z2/24");
  expect("largest overlap", largest, of_depth,
         "1e-3 is required; z1^2/2 times the difference of two values of u (1 - u) <= 1/4");
  expect("residual overlap", residual, of_depth, "a fixed fraction of the largest overlap");
}

/// The initial gap is proportional to the speed, so that the phase does not change.
void check_speeds(Findings& findings, const Setup& setup) {
  const double step = latch_step(production, 0.49);
  const auto restitution = [&](double speed) {
    return parting({.ratio = 0.49, .step = step, .phase = 0.3, .speed = speed, .radius = 1.0}, findings, setup)
        .restitution;
  };
  const double fastest = restitution(0.5);
  double change = 0.0;
  for (const double speed : {5e-2, 5e-3, 5e-4, 5e-5})
    keep_worst(change, std::abs(restitution(speed) - fastest));
  findings.expect_round_off({"speeds", "restitution over four decades of speed, largest change"}, change, 0.0, 1e-10,
                            "positions near 2 are rounded by 6.4e-17 rms, 1.3e-12 of the smallest overlap of 5e-5, at "
                            "each of 60 steps; a sum of these errors changes e by w2^2 T sqrt(60/3) times 1.3e-12, "
                            "w2^2 T = 5.5: 3e-11, and three times that for the worst of four speeds");
}

void run(Findings& findings, const Setup& setup) {
  check_verlet(findings, setup);
  check_growth(findings, setup);
  check_history(findings, setup);
  check_times(findings, setup);
  check_speeds(findings, setup);
  check_latching_table(findings, setup);
}

}  // namespace

Case definition() {
  return {.id = "latching_restitution",
          .title = "Restitution of latching contacts, four integrators",
          .family = "the shear cell",
          .requirements = {{"B14",
                            {"mean_restitution", "each_impact", "mean_by_four", "gains_of_speed", "stability_limit"}},
                           {"B11",
                            {"rms_error", "largest_error", "rms_over_predicted", "at_60_steps/contact time",
                             "at_60_steps/residual overlap", "speeds"}},
                           {"law.latching_spring",
                            {"rms_error", "largest_error", "rms_over_predicted", "at_60_steps/residual overlap"}},
                           {"regime.latching_spring.loading", {"at_60_steps/largest overlap"}},
                           {"regime.latching_spring.unloading", {"at_60_steps/contact time"}},
                           {"regime.latching_spring.slack", {"at_60_steps/residual overlap"}},
                           {"integrator.euler", {"mean_restitution/Euler"}},
                           {"integrator.taylor", {"mean_restitution/Taylor"}},
                           {"integrator.euler_cromer", {"mean_by_four"}},
                           {"integrator.velocity_verlet", {"rms_error", "largest_error", "rms_over_predicted"}}},
          .main_checks = {"rms_error", "mean_restitution/Euler", "mean_restitution/Taylor", "snoflo/Euler", "speeds",
                          "at_60_steps/contact time"},
          .source = "Walton & Braun 1986; Lacy 1989",
          .faults = {{"ratio_for_root", "K1/K2 = e instead of e^2", "rms_error"},
                     {"methods_exchanged", "Euler and Taylor methods exchanged", "mean_restitution/Taylor"},
                     {"ratio_of_exact_steps", "K1/K2 = 0.49, as for short steps", "snoflo/Euler"},
                     {"step_of_another_contact", "calibration for a step that is 1 % longer",
                      "K1/K2 for a restitution of 0.7 by Taylor, calibrated by simulation"},
                     {"one_disc_heavier", "one disc 1 % heavier", "at_60_steps/contact time"},
                     {"gap_not_scaled", "initial gap of the fastest pair at all speeds", "speeds"},
                     {"verlet_for_euler", "Verlet method in place of Euler",
                      "Euler: restitution above 1 at 10 steps in a contact, below 1 at 20"},
                     {"euler_for_verlet", "Euler method in place of Verlet", "stability_limit"},
                     {"verlet_for_taylor", "Verlet method in place of Taylor",
                      "Taylor: restitution above 1 at 5 steps in a contact, below 1 at 10"}},
          .run = run};
}

}  // namespace talus::verification::problems::latching_restitution
