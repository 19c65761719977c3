#include "verification/problems/program/agreement/agreeing_history.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>
#include <utility>
#include <vector>

#include "verification/problems/program/agreement/fence_contacts.hpp"
#include "verification/problems/program/agreement/yard_energies.hpp"
#include "verification/reference/impacts/restitution.hpp"
#include "verification/study/findings/expectations.hpp"

namespace talus::verification::problems::agreeing_files {
namespace {

/// Differences over both scenes, reduced to few checks.
struct Checks {
  Disagreements heads;
  WorstDifference times, velocities, kinetic, energy, elongations, exact_tensions, tensions, overlaps, forces;
  double rate{}, rate_bound{}, tension_bound{};
  std::string rate_of;
};

void check_columns(const Run& run, Checks& checks) {
  const std::vector<std::string> names = expected_columns(run.facts);
  checks.heads.check("the number of columns", names.size() == run.history.names.size());
  for (std::size_t i = 0; i < std::min(names.size(), run.history.names.size()); ++i) {
    checks.heads.check(names[i], run.history.names[i] == names[i]);
    checks.heads.check("the unit of " + names[i], run.history.units[i] == unit_of(names[i], *run.facts.units));
  }
  for (std::size_t row = 0; row < run.rows(); ++row)
    checks.times.compare("time", run.time(row), run.facts.step * static_cast<double>(row), run.time(run.rows() - 1));
}

/// Columns of position and velocity.
const std::vector<std::pair<std::string, std::string>> coordinates{{".x", ".vx"}, {".y", ".vy"}, {".angle", ".spin"}};

/// Velocity Verlet: with x[n+1] - x[n] = h v[n] + h^2/2 a[n] and x[n] - x[n-1] = h v[n] - h^2/2 a[n], each velocity is
/// that of the positions before and after it.
void check_velocities(const Run& run, Checks& checks, const Setup& setup) {
  for (const Part& body : run.facts.bodies) {
    for (const auto& [position, velocity] : coordinates) {
      if (!run.history.has(body.name + position)) continue;
      const std::vector<double>&x = run.history.at(body.name + position), &v = run.history.at(body.name + velocity);
      double reach = 0.0;
      for (const double at : x)
        reach = std::max(reach, std::abs(at));
      const std::size_t late = setup.has("velocity_one_late") ? 1 : 0;
      for (std::size_t row = 1; row + 1 + late < run.rows(); ++row)
        checks.velocities.compare(body.name + velocity, 2.0 * run.facts.step * v[row + late], x[row + 1] - x[row - 1],
                                  reach);
    }
  }
}

/// Displacements from the velocities, by the trapezoidal rule with all rows and with every other row.
void check_rates(const Run& run, Checks& checks) {
  const std::size_t last = run.rows() - 1;
  for (const Part& body : run.facts.bodies) {
    for (const auto& [position, velocity] : coordinates) {
      if (!run.history.has(body.name + position)) continue;
      const std::vector<double>&x = run.history.at(body.name + position), &v = run.history.at(body.name + velocity);
      const auto integral = [&](std::size_t every) {
        double sum = 0.0;
        for (std::size_t row = every; row <= last; row += every)
          sum += 0.5 * (run.time(row) - run.time(row - every)) * (v[row] + v[row - every]);
        return sum;
      };
      double path = 0.0;
      for (std::size_t row = 1; row <= last; ++row)
        path += std::abs(x[row] - x[row - 1]);
      if (path == 0.0) continue;
      const double error = std::abs(x[last] - x[0] - integral(1)) / path;
      if (error > checks.rate) checks.rate = error, checks.rate_of = body.name + position;
      checks.rate_bound = std::max(checks.rate_bound, std::abs(integral(2) - integral(1)) / path);
    }
  }
}

/// Energies of motion, weight and given forces; sums of all energies and the balance error.
void check_motion_energies(const Run& run, Checks& checks) {
  const double scale = energy_scale(run), first = total(run, "energy", energies(), 0);
  const double offset = sums_of(run, 0).gravity_scale + std::abs(first);
  for (std::size_t row = 0; row < run.rows(); ++row) {
    const Sums sums = sums_of(run, row);
    const auto energy = [&](const char* name) { return run.history.at(std::string("energy.") + name)[row]; };
    checks.kinetic.compare("energy.kinetic", energy("kinetic"), sums.kinetic, scale);
    checks.kinetic.compare("energy.gravity", energy("gravity"), sums.gravity, sums.gravity_scale);
    double applied = 0.0;
    for (const Part& body : run.facts.bodies) {
      if (body.force_x != 0.0) applied -= body.force_x * (run.of(body, ".x", row, 0.0) - run.of(body, ".x", 0, 0.0));
      if (body.moment != 0.0) applied -= body.moment * run.of(body, ".angle", row, 0.0);
    }
    checks.kinetic.compare("energy.applied", energy("applied") - run.history.at("energy.applied")[0], applied, scale);
    checks.energy.compare(fmt::format("row {}", row),
                          total(run, "energy", energies(), row) - first + total(run, "dissipated", mechanisms(), row) -
                              run.history.at("balance_error.energy")[row],
                          0.0, scale + offset);
  }
}

/// Elongations from positions; tensions from elongations by the law, with the largest elongation so far. Between two
/// rows the elongation exceeds both by at most an eighth of its second difference, and after it the tension is lower by
/// as much times the stiffness.
void check_cables(const Run& run, Checks& checks) {
  for (const Cable& cable : run.facts.cables) {
    const std::vector<double>& elongation = run.history.at(cable.name + ".elongation");
    const std::vector<double>& tension = run.history.at(cable.name + ".tension");
    const double scale = std::max(*std::ranges::max_element(tension), 1e-3 * std::min(cable.yield, 1e3));
    double longest = 0.0;
    bool broken = false;
    for (std::size_t row = 0; row < run.rows(); ++row) {
      const Vector a = run.position(cable.from, row), b = run.position(cable.to, row);
      const double length = size(between(a, b)), now = elongation[row];
      checks.elongations.compare(cable.name + ".elongation", now, length - cable.rest, length);
      if (row > 0 && row + 1 < run.rows() && now * cable.stiffness > cable.yield && now >= longest) {
        const double bend = std::abs(elongation[row + 1] - 2.0 * now + elongation[row - 1]);
        checks.tension_bound = std::max(checks.tension_bound, cable.stiffness * bend / 8.0 / scale);
      }
      longest = std::max(longest, now);
      broken = broken || (cable.strength < infinite && now >= elongation_at_break(cable));
      double exact = 0.0;
      if (cable.damping > 0.0 && now > 0.0) {
        const Part& body = run.facts.bodies[static_cast<std::size_t>(cable.from.body)];
        const Vector along = between(a, b);
        const double closing =
            (run.of(body, ".vx", row, 0.0) * along[0] + run.of(body, ".vy", row, 0.0) * along[1]) / length;
        exact = std::max(0.0, cable.stiffness * now - cable.damping * closing);
      } else if (!broken && now > 0.0) {
        const double yielded = std::max(0.0, longest - cable.yield / cable.stiffness);
        exact = std::max(0.0, cable.stiffness * (now - (1.0 - cable.hardening) * yielded));
      }
      // With fixed steps a cable yields and breaks at steps, which have rows; located events are between them.
      WorstDifference& tensions = run.facts.integrator == "velocity_verlet" ? checks.exact_tensions : checks.tensions;
      tensions.compare(cable.name + ".tension", tension[row], exact, scale);
    }
  }
}

/// Overlap of two bodies by geometry; a NaN where both are boxes, or the centre of a disc is in a box.
double overlap(const Run& run, const Part& a, const Part& b, std::size_t row) {
  const Vector at = run.position(a, 0.0, 0.0, row), other = run.position(b, 0.0, 0.0, row);
  if (a.shape != Shape::circle) return std::numeric_limits<double>::quiet_NaN();
  if (b.shape == Shape::circle) return a.a + b.a - std::hypot(at[0] - other[0], at[1] - other[1]);
  if (b.shape == Shape::plane) return a.a - (at[1] - other[1]);
  const double turned = run.of(b, ".angle", row, 0.0), c = std::cos(turned), s = std::sin(turned), x = at[0] - other[0],
               y = at[1] - other[1];
  const double off_x = std::max(0.0, std::abs(c * x + s * y) - b.a),
               off_y = std::max(0.0, std::abs(c * y - s * x) - b.b);
  const double distance = std::hypot(off_x, off_y);
  return distance > 0.0 ? a.a - distance : std::numeric_limits<double>::quiet_NaN();
}

void check_overlaps(const Run& run, Checks& checks) {
  for (const std::string& contact : run.facts.contacts) {
    const std::size_t dash = contact.find('-');
    const Part &a = run.body(contact.substr(0, dash)), &b = run.body(contact.substr(dash + 1));
    const std::vector<double>& overlaps = run.history.at(contact + ".overlap");
    for (std::size_t row = 0; row < run.rows(); ++row) {
      const double exact = overlap(run, a, b, row);
      if (!std::isnan(exact)) checks.overlaps.compare(contact + ".overlap", overlaps[row], exact, 1.0);
    }
  }
}

/// Forces of the laws in the yard, from overlaps and velocities in the same row.
void check_forces(const Run& run, Checks& checks) {
  const auto column = [&](const char* name) -> const std::vector<double>& { return run.history.at(name); };
  double largest = 0.0;
  for (std::size_t row = 0; row < run.rows(); ++row) {
    const double pressed = column("low-ground.overlap")[row], latched = column("high-low.overlap")[row],
                 hertz = column("side-low.overlap")[row];
    const double linear = low_stiffness * pressed - low_damping * column("low.vy")[row];
    largest = latched > 0.0 ? std::max(largest, latched) : 0.0;
    checks.forces.compare("low-ground.force", column("low-ground.force")[row],
                          pressed > 0.0 ? std::max(0.0, linear) : 0.0, 100.0);
    checks.forces.compare("high-low.force", column("high-low.force")[row],
                          std::max(0.0, loading * largest - unloading * (largest - latched)), 100.0);
    checks.forces.compare("side-low.force", column("side-low.force")[row],
                          hertz > 0.0 ? 4.0 / 3.0 * modulus * std::sqrt(hertz_radius) * std::pow(hertz, 1.5) : 0.0,
                          100.0);
  }
}

/// Energies of the yard, each in every row.
void check_yard_energies(const Run& run, Findings& findings, const Setup& setup) {
  const YardEnergies exact = yard_energies(run);
  const double scale = energy_scale(run);
  WorstDifference stored, dissipated;
  const auto compare = [&](WorstDifference& worst, const std::string& column, const std::vector<double>& of_rows) {
    const std::vector<double>& found = run.history.at(column);
    for (std::size_t row = 0; row < run.rows(); ++row)
      worst.compare(fmt::format("{} in row {}", column, row), found[row], of_rows[row], scale);
  };
  compare(stored, "energy.contacts", exact.contacts), compare(stored, "energy.cables", exact.cables);
  for (const std::string& mechanism : mechanisms()) {
    const std::string other = mechanism == "friction" ? "contact_damping" : "friction";
    const bool exchanged = setup.has("losses_exchanged") && (mechanism == "friction" || mechanism == "contact_damping");
    compare(dissipated, "dissipated." + mechanism, exact.dissipated.at(exchanged ? other : mechanism));
  }
  stored.expect(findings, "history.csv: stored energies of the yard by the laws, largest error", 1e-14,
                "a stretch of the friction spring is the sum of at most 300 slips, each rounded by 1.1e-16 of 0.03 m");
  dissipated.expect(findings, "history.csv: each dissipated energy of the yard by the laws, largest error", 1e-13,
                    "600 summands, each rounded by 1.1e-16 of the sum; a velocity is the difference of two positions "
                    "over 0.5 ms, rounded by 4e-13 m/s, and its errors cancel from step to step");
}

/// Contact forces of the fence in every row.
void check_fence_forces(const Run& run, const std::vector<FenceSpring>& springs, Findings& findings,
                        const Setup& setup) {
  WorstDifference forces, overlaps;
  double ratio = 0.0, ratio_bound = 0.0;
  for (const std::string& contact : run.facts.contacts) {
    const std::vector<double>&found = run.history.at(contact + ".force"),
          &overlap = run.history.at(contact + ".overlap");
    const double scale = std::max(*std::ranges::max_element(found), 1.0);
    for (std::size_t row = 0; row < run.rows(); ++row) {
      double exact = 0.0, deepest = -infinite;
      for (const FenceSpring& spring : springs) {
        if (spring.contact != contact) continue;
        exact += spring.force(setup.has("forces_one_late") ? std::min(row + 1, run.rows() - 1) : row);
        deepest = std::max(deepest, spring.overlap[row]);
      }
      forces.compare(fmt::format("{}.force in row {}", contact, row), found[row], exact, scale);
      if (deepest > 0.0) overlaps.compare(contact + ".overlap", overlap[row], deepest, 1.0);
    }
  }
  const double expected = reference::damping_ratio(restitution, reference::EndRule::clamped);
  for (const FenceSpring& spring : springs) {
    keep_worst(ratio, spring.damping_ratio / expected - 1.0);
    ratio_bound = std::max(ratio_bound, spring.ratio_bound / expected);
  }
  forces.expect(findings, "history.csv: contact forces of the fence by the law, over the largest, largest error", 1e-13,
                "overlaps are differences of lengths of about 4 ft, rounded by 4e-16 ft, times 2e5 lbf/ft, and rates "
                "those of speeds of 60 ft/s, rounded by 3e-14 ft/s, times 1200 lbf s/ft, over at least 3e4 lbf");
  overlaps.expect(findings, "history.csv: overlaps of the fence by geometry, largest error", 1e-14,
                  "twenty roundings of lengths up to 5, 1.1e-16 each");
  findings.expect("history.csv: damping ratios of the contacts of the fence at their touch, largest relative error",
                  ratio, 0.0,
                  Tolerance::truncation(ratio_bound, 1.0,
                                        "by the effective mass at the touch, between two rows: the dashpot is "
                                        "proportional to its root, which changes by half as much from row to row"));
}

/// Plastic work of a cable up to each row, the integral of its yield force up to the largest elongation so far or that
/// of its break.
struct PlasticWork {
  std::vector<double> work;
  std::vector<bool> broken;
  double bound{};  ///< yield force times the elongation that may be beyond a maximum of the rows
};
PlasticWork plastic_work(const Cable& cable, const std::vector<double>& elongation) {
  PlasticWork found;
  const double start = cable.yield / cable.stiffness,
               end = cable.strength < infinite ? elongation_at_break(cable) : infinite;
  const double slope = cable.stiffness * cable.hardening / (1.0 - cable.hardening);
  double longest = 0.0;
  for (std::size_t row = 0; row < elongation.size(); ++row) {
    const double now = elongation[row];
    longest = std::max(longest, now);
    const double stretch = (1.0 - cable.hardening) * std::max(0.0, std::min(longest, end) - start);
    found.work.push_back(cable.yield * stretch + 0.5 * slope * stretch * stretch);
    found.broken.push_back(longest >= end);
    if (row == 0 || row + 1 == elongation.size() || now < longest || now <= start || longest >= end) continue;
    if (now < elongation[row - 1] || now < elongation[row + 1]) continue;
    const double bend = std::abs(elongation[row + 1] - 2.0 * now + elongation[row - 1]);
    found.bound = std::max(found.bound, (cable.yield + slope * stretch) * bend / 8.0);
  }
  return found;
}

/// Energies of the fence, each. Friction energy and that of friction springs that stick have no other source; with all
/// others they conserve the energy of the run.
void check_fence_energies(const Run& run, const std::vector<FenceSpring>& springs, Findings& findings,
                          const Setup& setup) {
  const double scale = energy_scale(run);
  WorstDifference exact, stored, conserved, damping, release;
  const std::vector<double> slipping = slipping_energy(run, springs), every = damped_energy(run, springs, 1),
                            other = damped_energy(run, springs, 2);
  const Released released = released_energy(run, springs);
  const auto energy = [&](const char* name, std::size_t row) { return run.history.at(name)[row]; };
  const double first = total(run, "energy", energies(), 0);
  const char* const damped = setup.has("damping_is_friction") ? "dissipated.friction" : "dissipated.contact_damping";
  double damping_bound = 0.0, drawn = 0.0, drawn_bound = 0.0;
  std::vector<PlasticWork> plastic;
  for (const Cable& cable : run.facts.cables) {
    plastic.push_back(plastic_work(cable, run.history.at(cable.name + ".elongation")));
    // Each cable of the half model has a mirror image.
    drawn_bound += 2.0 * plastic.back().bound / scale;
  }
  for (std::size_t row = 0; row < run.rows(); ++row) {
    double cables = 0.0, yielded = 0.0, broken = 0.0;
    for (std::size_t c = 0; c < plastic.size(); ++c) {
      const Cable& cable = run.facts.cables[c];
      const double tension = run.history.at(cable.name + ".tension")[row];
      cables += tension * tension / cable.stiffness, yielded += 2.0 * plastic[c].work[row];
      if (plastic[c].broken[row]) broken += cable.strength * cable.strength / cable.stiffness;
    }
    exact.compare(fmt::format("energy.cables in row {}", row), energy("energy.cables", row), cables, scale);
    exact.compare(fmt::format("dissipated.cable_break in row {}", row), energy("dissipated.cable_break", row), broken,
                  scale);
    for (const char* const none : {"dissipated.cable_damping", "dissipated.cable_release", "dissipated.hanger_break"})
      exact.compare(none, energy(none, row), 0.0, scale);
    keep_worst(drawn, (energy("dissipated.cable_yield", row) - yielded) / scale);
    if (!std::isnan(slipping[row]))
      stored.compare(fmt::format("energy.contacts in row {}", row), energy("energy.contacts", row), slipping[row],
                     scale);
    if (row % 2 == 0) {
      damping.compare(fmt::format("row {}", row), energy(damped, row), every[row], scale);
      damping_bound = std::max(damping_bound, std::abs(every[row] - other[row]) / scale);
    }
    release.compare(fmt::format("row {}", row), energy("dissipated.contact_release", row), released.energy[row], scale);
    conserved.compare(fmt::format("row {}", row),
                      total(run, "energy", energies(), row) + total(run, "dissipated", mechanisms(), row), first,
                      scale);
  }
  exact.expect(findings, "history.csv: energies of cables of the fence and of their breaks, largest error", 1e-14,
               "sums of ten squares of tensions, with four roundings of 1.1e-16 each; a break is located to 1e-10 of "
               "an energy of 1e-3 of the scale");
  findings.expect("history.csv: energy dissipated by yielding cables of the fence, over the scale, largest error",
                  drawn, 0.0,
                  Tolerance::truncation(drawn_bound, 1.0,
                                        "between two rows the elongation exceeds both by at most an eighth of its "
                                        "second difference, and the plastic work grows by the yield force times that"));
  stored.expect(findings, "history.csv: energy of the contact of the fence that slips, largest error", 1e-13,
                "squares of forces with the error of the check of forces, 1e-13 of them");
  findings.expect(
      "history.csv: energy dissipated by dashpots of the fence, over the scale, largest error", damping.worst(), 0.0,
      Tolerance::truncation(damping_bound, 1.0,
                            fmt::format("trapezoidal rule over the rows in which a contact acts: with every "
                                        "other row the error is four times as large. The largest is of {}",
                                        damping.item())));
  findings.expect(
      "history.csv: energy released by contacts of the fence, over the scale, largest error", release.worst(), 0.0,
      Tolerance::truncation(released.bound / scale, 1.0,
                            fmt::format("the overlap at the release is between those of the rows before and "
                                        "after it. The largest is of {}",
                                        release.item())));
  conserved.expect(findings, "history.csv: sum of all energies of the fence over the scale, largest change", 1e-9,
                   "the method's tolerance is 1e-10, relative to the largest displacement and speed; ten times that");
}

void expect_history(const Checks& checks, Findings& findings) {
  checks.heads.expect(findings, "history.csv: heads that differ",
                      "columns of bodies, contacts, cables and the energy balance, with the units of the scene");
  checks.times.expect(findings, "history.csv: times of the rows over the duration, largest error", 1e-13,
                      "n additions of the step, each rounded by 1.1e-16 of the duration");
  findings.expect(
      "history.csv: displacements of the fence from the velocities over the distance travelled, largest error",
      checks.rate, 0.0,
      Tolerance::truncation(checks.rate_bound, 1.0,
                            fmt::format("trapezoidal rule with a row for each step: with every other row "
                                        "the error is four times as large, so that both results differ by "
                                        "three times the error. The largest is of {}",
                                        checks.rate_of)));
  checks.velocities.expect(findings, "history.csv: velocities from the positions before and after, largest error",
                           1e-15,
                           "the difference of two positions, each rounded by 1.1e-16 of the largest by its additions");
  checks.exact_tensions.expect(findings, "history.csv: tensions with fixed steps from elongations, largest error",
                               5e-15,
                               "an elongation of at least 0.1 m is the difference of lengths of about 2 m: two "
                               "roundings of 2.2e-16 m");
  checks.kinetic.expect(findings, "history.csv: energies from positions and velocities, largest error", 1e-14,
                        "sums of at most eight bodies with five roundings each, 1.1e-16 of the sum of their sizes");
  checks.energy.expect(findings, "history.csv: sum of all energies less the balance error, largest error", 1e-14,
                       "fourteen summands, each rounded by 1.1e-16 of the largest");
  checks.elongations.expect(findings, "history.csv: elongations from positions over the length, largest error", 1e-13,
                            "twenty roundings of a position, 1.1e-16 each, at most three times the length");
  findings.expect("history.csv: tensions of the fence from elongations, over the largest, largest error",
                  checks.tensions.worst(), 0.0,
                  Tolerance::truncation(checks.tension_bound, 1.0,
                                        fmt::format("between two rows the elongation exceeds both by at most an eighth "
                                                    "of its second difference. The largest is of {}",
                                                    checks.tensions.item())));
  checks.overlaps.expect(findings, "history.csv: overlaps from positions, largest error", 1e-14,
                         "twenty roundings of lengths up to 5, 1.1e-16 each");
  checks.forces.expect(findings, "history.csv: contact forces from overlaps and velocities, largest error", 1e-14,
                       "ten roundings of 1.1e-16 in forces that are relative to 100 N");
}

}  // namespace

void compare_histories(const Run& yard, const Run& fence, Findings& findings, const Setup& setup) {
  Checks checks;
  for (const Run* run : {&yard, &fence})
    check_columns(*run, checks), check_motion_energies(*run, checks), check_cables(*run, checks),
        check_overlaps(*run, checks);
  check_velocities(yard, checks, setup), check_forces(yard, checks), check_rates(fence, checks);
  expect_history(checks, findings);
  check_yard_energies(yard, findings, setup);
  const std::vector<FenceSpring> springs = fence_springs(fence);
  check_fence_forces(fence, springs, findings, setup), check_fence_energies(fence, springs, findings, setup);
}

}  // namespace talus::verification::problems::agreeing_files
