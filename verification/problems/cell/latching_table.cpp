#include "verification/problems/cell/latching_table.hpp"

#include <fmt/format.h>

#include <cmath>
#include <map>
#include <vector>

#include "verification/problems/cell/latching_meeting.hpp"

namespace talus::verification::problems {
namespace {

using reference::SteppedLatch;

constexpr double ratio = 0.49;
constexpr std::array steps_in_contact{5.0, 7.0, 10.0, 14.0, 20.0, 30.0, 40.0, 60.0, 85.0, 120.0};
constexpr std::array printed{5.0, 7.0, 10.0, 20.0, 30.0, 60.0, 120.0};

SteppedLatch latch_of(const LatchScheme& scheme, double steps) { return {ratio, latch_step(steps, ratio), scheme.map}; }

/// By scheme, then by steps in a contact.
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
      const double over = error / std::pow(latch.step / std::sqrt(ratio), 4);
      if (!(std::abs(over) <= std::abs(worst))) worst = over;
    }
  }
  findings.expect(
      "mean restitution, four methods, 5 to 120 steps in a contact: farthest from growth in full, over (w2 h)^4", worst,
      0.0,
      Tolerance::model(0.02,
                       "of fourth order are half the variance of ln e over phases, at most (z2^2/8)^2/2 = .008 z2^4, "
                       "and as much of what kinks do; z2 = .76 at five steps"));
  const auto gains = [&](std::size_t scheme, double coarse, double fine) {
    const PhasesOfLatch &fails = measured[scheme].at(coarse), &works = measured[scheme].at(fine);
    findings.expect_true(
        fmt::format("{} throws discs apart faster than they met at {} steps in a contact, not at {}",
                    latch_schemes[scheme].label, coarse, fine),
        fails.least > 1.0 && works.most < 1.0,
        fmt::format("at every phase; found e >= {:.3f} and e <= {:.3f}, and growth in full has {:.3f} and {:.3f}",
                    fails.least, works.most, reference::mean_restitution(latch_of(latch_schemes[scheme], coarse)),
                    reference::mean_restitution(latch_of(latch_schemes[scheme], fine))));
  };
  gains(0, 10.0, 20.0);
  gains(1, 5.0, 10.0);
}

/// The leapfrog does not gain on the whole; single impacts do beyond its limit of stability.
void check_limit(Findings& findings, const Setup& setup) {
  const char* method = setup.has("euler_for_verlet") ? "euler" : "velocity_verlet";
  const auto of = [&](double steps) { return phases_of(latch_of(latch_schemes[3], steps), method, findings, setup); };
  const PhasesOfLatch beyond = of(1.8), before = of(2.9);
  findings.expect_true(
      "Verlet throws some discs apart faster than they met at 1.8 steps in a contact, none at 2.9",
      beyond.most > 1.0 && before.most < 1.0,
      fmt::format("w2 h is {:.2f} and {:.2f}, the limit 2; found e from {:.2f} to {:.2f} (mean {:.2f}) "
                  "and from {:.2f} to {:.2f} (mean {:.2f})",
                  latch_step(1.8, ratio) / std::sqrt(ratio), latch_step(2.9, ratio) / std::sqrt(ratio), beyond.least,
                  beyond.most, beyond.mean, before.least, before.most, before.mean));
}

void record(const Measured& measured, Findings& findings) {
  DataFile data{
      "restitution_by_step",
      {"method", "steps_in_contact", "w1_step", "phases", "mean", "deviation", "closed_form", "growth_in_full"},
      {}};
  for (std::size_t k = 0; k < latch_schemes.size(); ++k) {
    for (const auto& [steps, seen] : measured[k]) {
      const SteppedLatch latch = latch_of(latch_schemes[k], steps);
      data.rows.push_back({latch_schemes[k].name, fmt::format("{}", steps), fmt::format("{}", latch.step),
                           fmt::format("{}", latch_phases), fmt::format("{}", seen.mean),
                           fmt::format("{}", seen.deviation), fmt::format("{}", reference::leading_restitution(latch)),
                           fmt::format("{}", reference::mean_restitution(latch))});
    }
  }
  findings.data(data);
  Table table{.name = "restitution_by_step",
              .caption =
                  "Restitution against steps in a contact, $K_1/K_2 = .49$: mean and deviation over 200 phases, "
                  "and what growth in full says. The leapfrog is Euler-Cromer and Verlet alike.",
              .columns = {"$T/h$", "Euler", "in full", "Taylor", "in full", "leapfrog"}};
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
       .caption = "Mean over 200 phases, $K_1/K_2 = .49$. Lines: the closed form. Above 1 impacts gain energy.",
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
          std::log(parting({ratio, latch.step, phase, scheme.name}, findings, setup).restitution / mean));
      line.y.push_back(std::log(reference::stepped_restitution(latch, phase) / mean));
    }
    all.push_back(points), all.push_back(line);
  }
  findings.figure({.name = "restitution_against_phase",
                   .title = "What the phase of the touch does",
                   .caption = "$\\ln e$ from its mean at 20.4 steps in a contact; lines: predicted.",
                   .x = {.label = "share of a step before the touch"},
                   .y = {.label = "ln e, from its mean"},
                   .series = all});
}

}  // namespace

void check_latching_table(Findings& findings, const Setup& setup) {
  const Measured measured = measure(findings, setup);
  check_means(measured, findings);
  check_limit(findings, setup);
  if (setup.coarse) return;
  record(measured, findings);
  draw_steps(measured, findings);
  draw_phases(findings, setup);
}

}  // namespace talus::verification::problems
