#include "verification/problems/cell/latching_meeting.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "solver/laws/latching_spring.hpp"
#include "verification/problems/cell/disc_row.hpp"

namespace talus::verification::problems {
namespace {

/// Time, depth and force at the ends of steps, to the first without force.
struct Course {
  std::vector<double> time, depth, force;

  void add(double t, double d, double f) {
    if (!force.empty() && force.back() == 0.0) return;
    time.push_back(t), depth.push_back(d), force.push_back(f);
  }

  void summarize(double step, Parting& found) const {
    if (depth.size() < 4) return;
    // Force against depth is a straight line on the way out, whose zero is the residual depth.
    const std::size_t last = depth.size() - 1;
    const double slope = (force[last - 1] - force[last - 2]) / (depth[last - 1] - depth[last - 2]);
    found.residual = depth[last - 1] - force[last - 1] / slope;
    found.contact_time = time[last - 1] + step * (depth[last - 1] - found.residual) / (depth[last - 1] - depth[last]);
    found.largest = *std::max_element(depth.begin(), depth.end());
  }
};

}  // namespace

Parting parting(const Meeting& meeting, Findings& findings, const Setup& setup) {
  const double told = setup.has("ratio_for_root") ? std::sqrt(meeting.ratio) : meeting.ratio;
  const double before = setup.has("gap_not_scaled") ? 0.5 : meeting.speed;
  FilledRow row = fill({.radius = meeting.radius,
                        .velocity = {0.5 * meeting.speed, -0.5 * meeting.speed},
                        .gap = {meeting.phase * meeting.step * before}});
  if (setup.has("one_disc_heavier")) row.shapes.inverse_mass[0] /= 1.01;
  DiscSystem system{row.shapes, {}, LatchingSpring{0.5, 0.5 / told, 0.0}, meeting.radius};
  Course course;
  const auto watch = [&](const auto& seen) {
    seen.for_each_contact(row.discs, [&](const auto& contact) {
      course.add(row.discs.t - meeting.phase * meeting.step, contact.depth, contact.force);
    });
  };
  Parting found{NAN, NAN, NAN, NAN};
  const auto most = static_cast<long>(40.0 / meeting.step + 2.0 * before / meeting.speed) + 1000;
  const bool over = run_row(system, row, make_disc_method(meeting.method), meeting.step, most, watch);
  findings.count(static_cast<std::uint64_t>(system.evaluations()));
  if (!over) return found;
  found.restitution = (row.discs.vx[1] - row.discs.vx[0]) / meeting.speed;
  course.summarize(meeting.step, found);
  return found;
}

double latch_phase(int i) { return (i + 0.5) / latch_phases; }

double latch_step(double steps_in_contact, double ratio) {
  return 0.5 * std::numbers::pi * (1.0 + std::sqrt(ratio)) / steps_in_contact;
}

PhasesOfLatch phases_of(const reference::SteppedLatch& latch, const char* method, Findings& findings,
                        const Setup& setup) {
  const double exact = reference::mean_restitution(latch);
  PhasesOfLatch found{.least = INFINITY, .most = -INFINITY};
  double squares = 0.0;
  for (int i = 0; i < latch_phases; ++i) {
    const double phase = latch_phase(i);
    const double e = parting({latch.ratio, latch.step, phase, method}, findings, setup).restitution;
    const double here = reference::stepped_restitution(latch, phase);
    found.mean += e / latch_phases, squares += e * e / latch_phases;
    found.least = std::min(found.least, e), found.most = std::max(found.most, e);
    found.found.add(std::log(e / exact)), found.predicted.add(std::log(here / exact));
    const double beyond = std::abs(std::log(e / here));
    if (!(beyond <= found.beyond)) found.beyond = beyond;
  }
  found.deviation = std::sqrt(std::max(0.0, squares - found.mean * found.mean));
  return found;
}

}  // namespace talus::verification::problems
