#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>
#include <utility>
#include <vector>

#include "verification/check/case.hpp"
#include "verification/problems/program/expected_fence.hpp"
#include "verification/record/csv.hpp"
#include "verification/study/expectations.hpp"

namespace talus::verification::problems::agreeing_files {
namespace {

// --- The history and the states of the geometry -----------------------------------------------------------------------

/// Differences over both scenes, reduced to few checks.
struct Checks {
  Disagreements heads, states;
  WorstDifference times, velocities, kinetic, energy, stored, elongations, exact_tensions, tensions, overlaps, forces,
      geometry;
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

void check_energies(const Run& run, Checks& checks) {
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
      const Vector a = run.place(cable.from, row), b = run.place(cable.to, row);
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
  const Vector at = run.place(a, 0.0, 0.0, row), other = run.place(b, 0.0, 0.0, row);
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

/// Stored energies in the yard: k d^2/2, F^2/(2 K2) and 2/5 F d of contacts that push, in rows without friction, whose
/// spring stores energy, too; T^2/(2 k) and k e^2/2 of cables that pull. A part that is deformed and has no force was
/// released, and stores nothing that is counted.
void check_stored(const Run& run, Checks& checks) {
  const auto at = [&](const std::string& name, std::size_t row) { return run.history.at(name)[row]; };
  const double scale = energy_scale(run), tie = run.facts.cables[0].stiffness, of_rope = run.facts.cables[1].stiffness;
  std::size_t rows = 0;
  for (std::size_t row = 0; row < run.rows(); ++row) {
    const double pull = at("tie.tension", row), longer = at("rope.elongation", row);
    const double rope = at("rope.tension", row) > 0.0 ? 0.5 * of_rope * longer * longer : 0.0;
    if (longer <= 0.0 || at("rope.tension", row) > 0.0)
      checks.stored.compare("energy.cables", at("energy.cables", row), 0.5 * pull * pull / tie + rope, scale);
    if (at("low-ground.overlap", row) > 0.0) continue;
    const double latched = at("high-low.force", row);
    checks.stored.compare("energy.contacts", at("energy.contacts", row),
                          0.5 * latched * latched / unloading +
                              0.4 * at("side-low.force", row) * std::max(0.0, at("side-low.overlap", row)),
                          scale);
    ++rows;
  }
  checks.states.check("rows without contact on the ground", rows > 50);
}

/// Numbers of the data array NAME after the first occurrence of `section`.
std::vector<double> array_in(const std::string& text, const std::string& section, const std::string& name) {
  return data_array(text.substr(std::min(text.find("<" + section + ">"), text.size())), name);
}

void check_states(const Run& run, Checks& checks, const Setup& setup) {
  const Facts& facts = run.facts;
  double reach = 0.0;
  for (const Part& body : facts.bodies)
    reach = std::max({reach, std::abs(run.of(body, ".x", 0, body.x)), std::abs(run.of(body, ".y", 0, body.y))});
  checks.states.check("the number of states",
                      run.states.size() == static_cast<std::size_t>(facts.steps / facts.steps_a_state) + 1);
  for (std::size_t n = 0; n < run.states.size(); ++n) {
    const std::string& text = run.states[n].text;
    std::size_t row = n * static_cast<std::size_t>(facts.steps_a_state);
    checks.states.check("time", run.states[n].time == run.time(std::min(row, run.rows() - 1)));
    if (setup.has("state_one_late")) row = std::min(row + 1, run.rows() - 1);
    const auto expect_numbers = [&](const char* section, const char* name, const std::vector<double>& exact) {
      const std::vector<double> found = array_in(text, section, name);
      checks.states.check(fmt::format("{} of {}", name, section), found == exact);
    };
    std::vector<double> points, point_body, offsets, body_of, cable_of, tension, slacks, connectivity;
    const auto add = [&](const Vector& point, double body) {
      points.insert(points.end(), point.begin(), point.end()), point_body.push_back(body);
    };
    const auto end_line = [&](double body, double cable, double pull, double is_slack) {
      offsets.push_back(static_cast<double>(point_body.size())), body_of.push_back(body), cable_of.push_back(cable);
      tension.push_back(pull), slacks.push_back(is_slack);
    };
    for (std::size_t i = 0; i < facts.bodies.size(); ++i) {
      const auto outline = outline_of(facts.bodies[i], 2.0 * reach);
      for (const auto& [u, v] : outline)
        add(run.place(facts.bodies[i], u, v, row), static_cast<double>(i));
      if (!outline.empty()) end_line(static_cast<double>(i), -1.0, 0.0, 0.0);
    }
    for (std::size_t c = 0; c < facts.cables.size(); ++c) {
      const Cable& cable = facts.cables[c];
      for (const End& end : {cable.from, cable.to})
        add(run.place(end, row), end.body);
      const double pull = run.history.at(cable.name + ".tension")[row];
      end_line(-1.0, static_cast<double>(c), pull, pull == 0.0 ? 1.0 : 0.0);
    }
    for (std::size_t i = 0; i < point_body.size(); ++i)
      connectivity.push_back(static_cast<double>(i));
    expect_numbers("PointData", "body", point_body), expect_numbers("CellData", "body", body_of);
    expect_numbers("CellData", "cable", cable_of), expect_numbers("CellData", "tension", tension);
    expect_numbers("CellData", "slack", slacks), expect_numbers("Lines", "connectivity", connectivity);
    expect_numbers("Lines", "offsets", offsets);
    const std::vector<double> found = data_array(text, "Points");
    checks.states.check("Points", found.size() == points.size());
    for (std::size_t i = 0; i < std::min(found.size(), points.size()); ++i)
      checks.geometry.compare(fmt::format("point {} of state {}", i / 3, n), found[i], points[i], fence_span);
  }
}

// --- Documents --------------------------------------------------------------------------------------------------------

/// NAME.history.csv, as a document like NAME.history.json.
void check_codes(const TemporaryFolder& folder, const Run& run, Findings& findings) {
  const std::string csv = folder.read("fence/fence.history.csv");
  const Json codes = records::read_json(folder.path() / "fence/fence.history.json");
  ComparedDocument("fence.history.json", codes, expected_codes(run, csv))
      .expect(findings, 1e-14,
              "about ten roundings of 1.1e-16; kinetic energies are squares of velocities, and a force is a sum of two "
              "tensions in other directions");
  const Columns table{records::read_csv(folder.path() / "fence/fence.history.csv")};
  Disagreements different;
  different.check("the number of columns", table.names.size() == codes["columns"].size());
  for (std::size_t i = 0; i < std::min(table.names.size(), codes["columns"].size()); ++i) {
    const Json& column = codes["columns"][i];
    different.check(table.names[i], table.names[i] == column["name"].get<std::string>() &&
                                        table.units[i] == column["unit"].get<std::string>() &&
                                        table.values[i] == column["values"].get<std::vector<double>>());
  }
  different.expect(findings, "fence.history.csv: columns that differ from fence.history.json",
                   "names, units and all digits agree");
}

/// What the summary says of the repeated run: the same fence, run here with the faster rocks. Stiffness is proportional
/// to the square of speed over overlap, so that overlaps are larger by the same factor.
Json repeat_of(const TemporaryFolder& folder, const Run& run, Findings& findings) {
  Facts faster = fence();
  faster.file = "faster";
  for (const Rock& rock : rocks) {
    replace(faster.text, fmt::format("velocity = [\"{} ft/s\"", rock.speed),
            fmt::format("velocity = [\"{} ft/s\"", 1.001 * rock.speed));
    replace(faster.text, fmt::format("spin = \"{} rad/s\"", rock.spin),
            fmt::format("spin = \"{} rad/s\"", 1.001 * rock.spin));
  }
  replace(faster.text, "layer_overlap = \"0.5 ft\"", fmt::format("layer_overlap = \"{} ft\"", 1.001 * 0.5));
  replace(faster.text, "rock_overlap = \"0.6 ft\"", fmt::format("rock_overlap = \"{} ft\"", 1.001 * 0.6));
  replace(faster.text, "penetration = 0.05", fmt::format("penetration = {}", 1.001 * 0.05));
  const Run again = run_of(folder, faster, {});
  const auto peak = [](const Run& of) { return of.summary["verdict"]["largest_cable_force"]["peak"].get<double>(); };
  const double found = run.summary["quality"]["repeat"]["change_of_largest_cable_force"];
  findings.expect(
      "fence/summary.json: change of the largest cable force with faster rocks", found, peak(again) / peak(run) - 1.0,
      Tolerance::round_off(1e-9,
                           "the method's tolerance is 1e-10, relative to the largest displacement and speed, "
                           "and the speeds and overlaps given here are rounded otherwise than in the "
                           "repeated run; ten times that"));
  return {{"change_of_speed", 0.001},
          {"failure", ""},
          {"verdict", again.summary["verdict"]["fence"]},
          {"change_of_largest_cable_force", found}};
}

/// A fence with steps that are too long: the summary says so, and what `--integrator auto` gives, which is run here.
void check_repair(const TemporaryFolder& folder, Findings& findings) {
  std::string text = fence().text;
  replace(text, "steps = 400", "steps = 40"), replace(text, "step_factor = 1\n", "step_factor = 10\n");
  replace(text, "print_every = 50", "print_every = 5");
  replace(text, "integrator = \"auto\"", "integrator = \"velocity_verlet\"");
  folder.write("coarse.toml", text);
  const ProgramEnd end = run_talus(folder, {"run", "coarse.toml", "--out", "coarse"});
  (void)run_talus(folder, {"run", "coarse.toml", "--out", "repaired", "--integrator", "auto"});
  const Json summary = records::read_json(folder.path() / "coarse/summary.json"),
             repaired = records::read_json(folder.path() / "repaired/summary.json");
  const Json& ledger = summary["ledger"];
  const double balance = ledger["largest_energy_balance_error"].get<double>() / ledger["energy_scale"].get<double>();
  const std::string flaw = fmt::format("the energy balance is off by {:.3g} % of the largest energy", 100.0 * balance);
  Json expected = summary["quality"];
  expected["usable"] = false, expected["enforced"] = true, expected["energy_balance"] = balance;
  expected["flaw"] = flaw;
  expected["repair"] = {{"option", "--integrator auto"},
                        {"flaw", repaired["quality"]["flaw"]},
                        {"verdict", repaired["verdict"]["fence"]},
                        {"energy_balance", repaired["quality"]["energy_balance"]}};
  const std::string step = summary["quality"]["step"];
  if (end.output.find(" " + step + "; ") == std::string::npos) expected["step"] = "as printed";
  ComparedDocument("summary.json of a step too long", summary["quality"], expected)
      .expect(findings, 1e-15, "the same numbers divided");
  findings.expect("summary.json of a step too long: exit status", end.exit_code, 7,
                  Tolerance::exact("the results are not usable"));
}

// --- The case ---------------------------------------------------------------------------------------------------------

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
  checks.stored.expect(findings, "history.csv: stored energies from forces and overlaps, largest error", 1e-15,
                       "eight roundings of 1.1e-16 in terms that are less than the scale of the balance");
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
  checks.states.expect(findings, "geometry: arrays that differ",
                       "bodies, cables, connectivity, offsets and slack are integers; times and tensions have the "
                       "digits of the history");
  checks.geometry.expect(findings, "geometry: points over the span, largest error", 1e-14,
                         "twenty roundings of 1.1e-16");
}

void run(Findings& findings, const Setup& setup) {
  const auto group = findings.in("files");
  const TemporaryFolder folder;
  Checks checks;
  Facts of_fence = fence();
  Facts of_yard = yard();
  if (setup.has("faster_rock")) replace(of_fence.text, "-65 ft/s", "-65.01 ft/s");
  if (setup.has("later_yield")) replace(of_fence.text, "\"20000 lbf\"", "\"20001 lbf\"");
  if (setup.has("stiffer_rope")) replace(of_yard.text, "200 N/m", "200.001 N/m");
  if (setup.has("harder_bed")) replace(of_yard.text, "2000 N/m", "2000.001 N/m");
  if (setup.has("larger_rock")) replace(of_fence.text, "b = \"1.1 ft\"", "b = \"1.1001 ft\"");
  std::vector<Run> runs;
  runs.push_back(run_of(folder, of_yard, {"--frames", "10"}));
  const bool sheet_is_needed = setup.needs("sheet.json");
  runs.push_back(
      run_of(folder, of_fence, sheet_is_needed ? std::vector<std::string>{"--sheet"} : std::vector<std::string>{}));
  for (const Run& one : runs) {
    findings.count(one.summary["evaluations"].get<long>());
    check_columns(one, checks), check_energies(one, checks);
    check_cables(one, checks), check_overlaps(one, checks), check_states(one, checks, setup);
  }
  check_velocities(runs[0], checks, setup), check_forces(runs[0], checks), check_stored(runs[0], checks);
  check_rates(runs[1], checks);
  expect_history(checks, findings);
  for (const Run& one : runs) {
    Json summary = expected_summary(one);
    if (one.facts.mirrored) {
      summary["verdict"] = expected_verdict(one);
      summary["integrator_reason"] = as_printed(one.summary["integrator_reason"], "chosen, as ", one.printed);
      summary["quality"]["repeat"] = setup.needs("faster rocks") || setup.needs("summary.json: members")
                                         ? repeat_of(folder, one, findings)
                                         : one.summary["quality"]["repeat"];
      summary["events"] = printed_number(one.printed, "events located ");
    }
    const std::string of = one.facts.file + "/";
    ComparedDocument(of + "summary.json", one.summary, summary)
        .expect(findings, 1e-14,
                "numbers of the history are copied; sums have at most thirty roundings of 1.1e-16 of their summands");
    ComparedDocument(of + "final_state.json", one.state, expected_final_state(one))
        .expect(findings, 1e-12,
                "a plastic stretch is 49 times the difference of two tensions, over the stiffness: twenty roundings of "
                "1.1e-16 of 20,000 lbf, over a difference of at least 250 lbf");
    ComparedDocument(of + "plot.json", one.plot, expected_plot(one)).expect(findings, 0.0, "all numbers are integers");
  }
  if (sheet_is_needed) {
    const Json sheet = records::read_json(folder.path() / "fence/sheet.json");
    const double metre = setup.has("survey_foot") ? 1200.0 / 3937.0 : us.metre;
    ComparedDocument("sheet.json", sheet, expected_sheet(runs[1], sheet, metre))
        .expect(findings, 1e-14,
                "about ten roundings between feet and metres, 1.1e-16 each, and as many of positions and forces; four "
                "times that as a walk for the sums of 400 terms");
  }
  check_codes(folder, runs[1], findings);
  if (setup.needs("step too long")) check_repair(folder, findings);
}

}  // namespace

Case definition() {
  return {
      .id = "agreeing_files",
      .title = "Agreement of all files of a run",
      .requirements = {{"G9", {"files"}}},
      .main_checks = {"sheet.json: numbers, largest error", "fence/summary.json: numbers, largest error"},
      .source = "Textbook mechanics; Mustoe & Huttelmaier 1993 (fence)",
      .faults = {{"faster_rock", "a rock of 65.01 ft/s", "sheet.json: numbers, largest error"},
                 {"later_yield", "a cable that yields at 20,001 lbf", "fence/final_state.json: numbers, largest error"},
                 {"velocity_one_late", "velocities of the next row",
                  "history.csv: velocities from the positions before and after, largest error"},
                 {"stiffer_rope", "a rope of 200.001 N/m",
                  "history.csv: tensions with fixed steps from elongations, largest error"},
                 {"harder_bed", "a contact of 2000.001 N/m",
                  "history.csv: contact forces from overlaps and velocities, largest error"},
                 {"larger_rock", "a rock with a half-axis of 1.1001 ft",
                  "history.csv: overlaps from positions, largest error"},
                 {"state_one_late", "states of the geometry compared with the next row",
                  "geometry: points over the span, largest error"},
                 {"survey_foot", "lengths converted by the survey foot, 1200/3937 m",
                  "sheet.json: numbers, largest error"}},
      .seconds = 3.0,
      .run = run};
}

}  // namespace talus::verification::problems::agreeing_files
