#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>
#include <vector>

#include "verification/check/case.hpp"
#include "verification/problems/program/agreement/agreeing_history.hpp"
#include "verification/problems/program/agreement/expected_fence.hpp"
#include "verification/problems/program/agreement/fence_contacts.hpp"
#include "verification/problems/program/agreement/printed_sheet.hpp"
#include "verification/problems/program/agreement/printed_summary.hpp"
#include "verification/record/csv.hpp"
#include "verification/reference/impacts/restitution.hpp"
#include "verification/study/findings/expectations.hpp"
#include "verification/study/program/program_options.hpp"

namespace talus::verification::problems::agreeing_files {
namespace {

// --- The states of the geometry
// ----------------------------------------------------------------------------------------

/// Numbers of the data array NAME after the first occurrence of `section`.
std::vector<double> array_in(const std::string& text, const std::string& section, const std::string& name) {
  return data_array(text.substr(std::min(text.find("<" + section + ">"), text.size())), name);
}

/// Differences of the states of both scenes.
struct States {
  Disagreements arrays;
  WorstDifference points;
};

void check_states(const Run& run, States& states, const Setup& setup) {
  const Facts& facts = run.facts;
  double reach = 0.0;
  for (const Part& body : facts.bodies)
    reach = std::max({reach, std::abs(run.of(body, ".x", 0, body.x)), std::abs(run.of(body, ".y", 0, body.y))});
  states.arrays.check("the number of states",
                      run.states.size() == static_cast<std::size_t>(facts.steps / facts.steps_a_state) + 1);
  for (std::size_t n = 0; n < run.states.size(); ++n) {
    const std::string& text = run.states[n].text;
    std::size_t row = n * static_cast<std::size_t>(facts.steps_a_state);
    states.arrays.check("time", run.states[n].time == run.time(std::min(row, run.rows() - 1)));
    if (setup.has("state_one_late")) row = std::min(row + 1, run.rows() - 1);
    const auto expect_numbers = [&](const char* section, const char* name, const std::vector<double>& exact) {
      const std::vector<double> found = array_in(text, section, name);
      states.arrays.check(fmt::format("{} of {}", name, section), found == exact);
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
        add(run.position(facts.bodies[i], u, v, row), static_cast<double>(i));
      if (!outline.empty()) end_line(static_cast<double>(i), -1.0, 0.0, 0.0);
    }
    for (std::size_t c = 0; c < facts.cables.size(); ++c) {
      const Cable& cable = facts.cables[c];
      for (const End& end : {cable.from, cable.to})
        add(run.position(end, row), end.body);
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
    states.arrays.check("Points", found.size() == points.size());
    for (std::size_t i = 0; i < std::min(found.size(), points.size()); ++i)
      states.points.compare(fmt::format("point {} of state {}", i / 3, n), found[i], points[i], fence_span);
  }
}

// --- Documents
// --------------------------------------------------------------------------------------------------------

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

/// Compares the lines of a text one by one.
void compare_lines(const std::string& of, const std::vector<std::string>& found,
                   const std::vector<std::string>& expected, Disagreements& lines) {
  for (std::size_t i = 0; i < std::max(found.size(), expected.size()); ++i) {
    const std::string line = i < expected.size() ? expected[i] : "no line";
    lines.check(fmt::format("{}: '{}' in place of '{}'", of, i < found.size() ? found[i] : "no line", line),
                i < found.size() && found[i] == line);
  }
}

/// The printed summary: each line from the numbers of summary.json.
void check_print(const std::vector<Run>& runs, Findings& findings, const Setup& setup) {
  Disagreements lines;
  for (const Run& run : runs) {
    Json summary = run.summary;
    if (setup.has("idle_cables")) summary["ledger"]["energy"]["cables"] = 0.0;
    compare_lines(run.facts.file, compared_print(run.printed), expected_print(summary), lines);
  }
  lines.expect(findings, "printed summary: lines that differ from summary.json",
               "each number is that of summary.json, with the digits that are printed");
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

/// Force evaluations of a method that chooses its steps, as `talus check` counts them in a separate run.
long evaluations_of(const TemporaryFolder& folder, const Run& run) {
  const ProgramEnd end = run_talus(folder, {"check", run.facts.file + ".toml"});
  return printed_number(end.output, fmt::format("expected cost: {} outputs to {:.6g} s, ", run.facts.steps,
                                                run.facts.steps * run.facts.step));
}

/// A fence with steps that are too long: its quality, and what `--integrator auto` gives, which is run here.
void check_repair(const TemporaryFolder& folder, Findings& findings, const Setup& setup) {
  Facts facts = fence();
  facts.file = "coarse", facts.steps = 40, facts.step_factor = 10.0, facts.integrator = "velocity_verlet";
  replace(facts.text, "steps = 400", "steps = 40"), replace(facts.text, "step_factor = 1\n", "step_factor = 10\n");
  replace(facts.text, "print_every = 50", "print_every = 5");
  replace(facts.text, "integrator = \"auto\"", "integrator = \"velocity_verlet\"");
  if (setup.has("stiffer_layers")) replace(facts.text, "layer_overlap = \"0.5 ft\"", "layer_overlap = \"0.4999 ft\"");
  const Run run = run_of(folder, facts, {}, 7);
  Facts again = facts;
  again.file = "repaired";
  const Run repaired = run_of(folder, again, {"--integrator", "auto"});
  const double balance = relative_balance_error(run), of_repaired = relative_balance_error(repaired);
  // The contact that lasts for the fewest steps, of those that acted, in the position of the start.
  double shortest = infinite;
  for (const FenceSpring& spring : fence_springs(run)) {
    if (spring.damping == 0.0) continue;
    const double ratio = reference::damping_ratio(restitution, reference::EndRule::clamped);
    shortest = std::min(shortest, 2.0 * reference::contact_angle(ratio) *
                                      std::sqrt(spring.start_mass / spring.stiffness) / run.facts.step);
  }
  // Frequencies are those of case step_limits; here the text repeats the monitor, and `check` the limit.
  const std::string line = "  step over its linear limit";
  const std::size_t at = run.printed.find(line);
  const double ratio = at == std::string::npos ? 0.0 : std::stod(run.printed.substr(at + line.size()));
  const bool beyond = run_talus(folder, {"check", "coarse.toml"}).output.find(" - TOO LONG\n") != std::string::npos;
  const Json expected{
      {"usable", balance < 0.01},
      {"flaw", fmt::format("the energy balance is off by {:.3g} % of the largest energy", 100.0 * balance)},
      {"enforced", true},
      {"step", fmt::format("step {:.3g} times its linear limit{}", ratio,
                           beyond ? ", beyond it with all contacts closed" : "")},
      {"energy_balance", balance},
      {"steps_in_shortest_contact", shortest},
      {"last_contact", last_contact_of(run)},
      {"repair",
       {{"option", "--integrator auto"},
        {"flaw", of_repaired < 0.01 ? "" : "off"},
        {"verdict", expected_verdict(repaired)["fence"]},
        {"energy_balance", of_repaired}}}};
  ComparedDocument("summary.json of a step too long", run.summary["quality"], expected)
      .expect(findings, 1e-14, "about ten roundings of 1.1e-16 in roots and quotients");
  Disagreements lines;
  compare_lines("coarse", compared_print(run.printed), expected_print(run.summary), lines);
  lines.expect(findings, "printed summary of a step too long: lines that differ from summary.json",
               "the flaw, the run that repairs it and all numbers are those of summary.json, with the printed digits");
}

/// The page of the sheet: each line from the numbers of sheet.json, in both unit systems.
void check_page(const TemporaryFolder& folder, const Json& sheet, Findings& findings) {
  Disagreements lines;
  compare_lines("sheet.html", lines_of_page(folder.read("fence/sheet.html")), expected_page(sheet), lines);
  lines.expect(findings, "sheet.html: lines that differ from sheet.json",
               "each number is that of sheet.json in SI and US units, with the digits that are printed");
}

// --- The case
// ---------------------------------------------------------------------------------------------------------

void run(Findings& findings, const Setup& setup) {
  const auto group = findings.in("files");
  const TemporaryFolder folder;
  Facts of_fence = fence();
  Facts of_yard = yard();
  if (setup.has("faster_rock")) replace(of_fence.text, "-65 ft/s", "-65.01 ft/s");
  if (setup.has("later_yield")) replace(of_fence.text, "\"20000 lbf\"", "\"20001 lbf\"");
  if (setup.has("stiffer_rope")) replace(of_yard.text, "200 N/m", "200.001 N/m");
  if (setup.has("harder_bed")) replace(of_yard.text, "2000 N/m", "2000.001 N/m");
  if (setup.has("larger_rock")) replace(of_fence.text, "b = \"1.1 ft\"", "b = \"1.1001 ft\"");
  if (setup.has("more_elastic")) replace(of_fence.text, "restitution = 0.4\n", "restitution = 0.401\n");
  if (setup.has("rougher_fence")) replace(of_fence.text, "friction = 0.3\n", "friction = 0.3001\n");
  std::vector<Run> runs;
  runs.push_back(run_of(folder, of_yard, {"--frames", "10"}));
  const bool sheet_is_needed = setup.needs("sheet.json");
  runs.push_back(
      run_of(folder, of_fence, sheet_is_needed ? std::vector<std::string>{"--sheet"} : std::vector<std::string>{}));
  compare_histories(runs[0], runs[1], findings, setup);
  States states;
  for (const Run& one : runs) {
    findings.count(one.summary["evaluations"].get<long>());
    check_states(one, states, setup);
  }
  states.arrays.expect(findings, "geometry: arrays that differ",
                       "bodies, cables, connectivity, offsets and slack are integers; times and tensions have the "
                       "digits of the history");
  states.points.expect(findings, "geometry: points over the span, largest error", 1e-14, "twenty roundings of 1.1e-16");
  for (const Run& one : runs) {
    Json summary = expected_summary(one);
    if (one.facts.mirrored) {
      summary["evaluations"] = evaluations_of(folder, one);
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
                "1.1e-16 of 20,000 lbf, 3e-13 as a walk over a difference of at least 30 lbf; three times that");
    ComparedDocument(of + "plot.json", one.plot, expected_plot(one)).expect_members(findings);
  }
  if (sheet_is_needed) {
    const Json sheet = records::read_json(folder.path() / "fence/sheet.json");
    const double metre = setup.has("survey_foot") ? 1200.0 / 3937.0 : us.metre;
    ComparedDocument("sheet.json", sheet, expected_sheet(runs[1], sheet, metre))
        .expect(findings, 1e-14,
                "about ten roundings between feet and metres, 1.1e-16 each, and as many of positions and forces; four "
                "times that as a walk for the sums of 400 terms");
    check_page(folder, sheet, findings);
  }
  check_codes(folder, runs[1], findings);
  check_print(runs, findings, setup);
  if (setup.needs("step too long")) check_repair(folder, findings, setup);
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
                 {"losses_exchanged", "friction energy and contact damping of the yard exchanged",
                  "history.csv: each dissipated energy of the yard by the laws, largest error"},
                 {"damping_is_friction", "contact damping of the fence compared with the column of friction",
                  "history.csv: energy dissipated by dashpots of the fence, over the scale, largest error"},
                 {"forces_one_late", "contact forces of the fence compared with the next row",
                  "history.csv: contact forces of the fence by the law, over the largest, largest error"},
                 {"more_elastic", "a restitution of 0.401",
                  "history.csv: damping ratios of the contacts of the fence at their touch, largest relative error"},
                 {"rougher_fence", "a friction coefficient of 0.3001",
                  "history.csv: energy of the contact of the fence that slips, largest error"},
                 {"stiffer_layers", "layers that overlap by 0.4999 ft in the fence with long steps",
                  "summary.json of a step too long: numbers, largest error"},
                 {"larger_rock", "a rock with a half-axis of 1.1001 ft",
                  "history.csv: overlaps from positions, largest error"},
                 {"state_one_late", "states of the geometry compared with the next row",
                  "geometry: points over the span, largest error"},
                 {"idle_cables", "no energy in the cables at the end",
                  "printed summary: lines that differ from summary.json"},
                 {"survey_foot", "lengths converted by the survey foot, 1200/3937 m",
                  "sheet.json: numbers, largest error"}},
      .seconds = 3.0,
      .run = run};
}

}  // namespace talus::verification::problems::agreeing_files
