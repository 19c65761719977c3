#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <filesystem>
#include <limits>
#include <numbers>
#include <numeric>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

#include "verification/check/case.hpp"
#include "verification/check/case_file.hpp"
#include "verification/problems/program/files/impact_rows.hpp"
#include "verification/record/csv.hpp"
#include "verification/record/json_node.hpp"
#include "verification/record/whole_file.hpp"
#include "verification/reference/friction/oblique_impact.hpp"
#include "verification/reference/impacts/restitution.hpp"
#include "verification/study/findings/expectations.hpp"
#include "verification/study/program/program_options.hpp"
#include "verification/study/program/program_run.hpp"
#include "verification/study/program/table_units.hpp"

namespace talus::verification::problems::impact_table {
namespace {

using records::Csv;
using records::Json;
using records::Node;
using reference::EndRule;

const std::string header =
    "number,contact,body_a,body_b,multiplicity,from_start,ended,touch_time [s],separation_time [s],"
    "approach_speed [m/s],separation_speed [m/s],restitution,slip_before [m/s],slip_after [m/s],peak_force [N],"
    "peak_force_time [s],largest_overlap [m],normal_impulse [N s],tangential_impulse [N s],impulse_x [N s],"
    "impulse_y [N s]";

// --- Two bodies strike a plane -------------------------------------------------------------------------------------

constexpr double slope = 0.5;           // of the plane [rad]
constexpr double state_step = 1.03e-6;  // between observed states [s]: no fraction of a contact time
constexpr int states = 400;

/// A body that strikes the plane.
struct Striker {
  const char* name;
  reference::ObliqueImpact impact;
  EndRule end;
  double gap;              ///< at the start [m]
  double radius;           ///< [m]
  double along;            ///< position along the plane [m]
  double spin;             ///< [rad/s]
  bool is_b;               ///< the second body of its contact
  double shear_damping{};  ///< [N s/m]
};

constexpr double ball_inertia = 0.3;
const Striker ball{.name = "ball",
                   .impact = {.normal = {8e8, 1.2e4, 2.0, 2.0},
                              .tangential_stiffness = 3e8,
                              .friction = 0.3,
                              .mobility = 1.0 + 2.0 * 0.5 * 0.5 / ball_inertia,
                              .slip_rate = 4.0},
                   .end = EndRule::clamped,
                   .gap = 4e-5,
                   .radius = 0.5,
                   .along = -1.0,
                   .spin = 3.0,
                   .is_b = false};
const Striker puck{.name = "puck",
                   .impact = {.normal = {2e8, 3.5e3, 1.5, 1.5},
                              .tangential_stiffness = 1e8,
                              .friction = 0.4,
                              .mobility = 1.0,
                              .slip_rate = -0.3},
                   .end = EndRule::attractive,
                   .gap = 6e-5,
                   .radius = 0.25,
                   .along = 1.0,
                   .spin = 0.0,
                   .is_b = true};

/// Sticks from its touch, since the dashpot along the plane begins with 600 N, less than the limit of friction by the
/// normal one, 2100 N; slips only 224 us later.
const Striker sled{.name = "sled",
                   .impact = {.normal = {2e8, 3.5e3, 1.5, 1.5},
                              .tangential_stiffness = 1e8,
                              .friction = 0.4,
                              .mobility = 1.0,
                              .slip_rate = -0.3},
                   .end = EndRule::clamped,
                   .gap = 5e-5,
                   .radius = 0.25,
                   .along = 0.0,
                   .spin = 0.0,
                   .is_b = true,
                   .shear_damping = 2e3};

/// Velocity of the striker's centre along the plane at the start [m/s]: its slip rate less that of its spin.
double speed_along(const Striker& of) { return of.impact.slip_rate - of.radius * of.spin; }

std::string striker_text(const Striker& of, double damping_factor) {
  const double s = std::sin(slope), c = std::cos(slope);
  const double height = of.radius + of.gap, along = speed_along(of), fall = of.impact.normal.approach_speed;
  std::string text =
      fmt::format(R"(
[[body]]
name = "{0}"
mobility = "{1}"
mass = "{2} kg"
shape = {{ kind = "circle", radius = "{3} m" }}
position = ["{4} m", "{5} m"]
velocity = ["{6} m/s", "{7} m/s"]
)",
                  of.name, of.is_b ? "particle" : "free", of.impact.normal.effective_mass, of.radius,
                  of.along * c - height * s, of.along * s + height * c, along * c + fall * s, along * s - fall * c);
  if (!of.is_b) text += fmt::format("inertia = \"{} kg m^2\"\nspin = \"{} rad/s\"\n", ball_inertia, of.spin);
  text += fmt::format(R"(
[[contact]]
name = "{} on plane"
between = [{}]
law = "linear_spring_dashpot"
stiffness = "{} N/m"
damping = "{} N s/m"
end_rule = "{}"
friction = {}
shear_stiffness = "{} N/m"
shear_damping = "{} N s/m"
)",
                      of.name,
                      of.is_b ? fmt::format(R"("plane", "{}")", of.name) : fmt::format(R"("{}", "plane")", of.name),
                      of.impact.normal.stiffness, damping_factor * of.impact.normal.damping,
                      of.end == EndRule::clamped ? "clamped" : "attractive", of.impact.friction,
                      of.impact.tangential_stiffness, of.shear_damping);
  return text;
}

std::string plane_text(const Setup& setup, const std::vector<Striker>& strikers = {ball, puck}) {
  std::string text = "title = \"Bodies strike a plane\"\nunits = \"SI\"\n";
  for (const Striker& striker : strikers)
    text += striker_text(striker, setup.has("more_damping") ? 1.0 + 1e-7 : 1.0);
  return text + fmt::format(R"(
[[body]]
name = "plane"
mobility = "fixed"
shape = {{ kind = "half_plane" }}
position = ["0 m", "0 m"]
angle = "{} rad"

[run]
integrator = "stormer_cowell"
tolerance = 1e-13
step = "{} s"
end = "{} s"
)",
                            slope, state_step, states * state_step);
}

/// The row of a striker, from the closed form of its normal motion at the times of the states, and of its oblique
/// rebound.
struct Expected {
  std::map<std::string, double> numbers;
  reference::ImpactEvents events;
  double touch{};
};

Expected expected_row(const Striker& of) {
  const reference::Impact& normal = of.impact.normal;
  Expected expected{.numbers = {}, .events = impact_events(normal, of.end), .touch = of.gap / normal.approach_speed};
  const auto& [damping_ratio, frequency, restitution, contact_time, d1, t1, depth_at_end, f1, f2, f3] = expected.events;
  const double leave = restitution * normal.approach_speed, touch = expected.touch;
  struct Sample {
    double time{}, depth{}, force{};
  };
  // Captured by names other than theirs: clang 14 refuses to capture those of a structured binding.
  const auto sample = [&, ended = contact_time, deep = depth_at_end](int n) -> Sample {
    const double t = state_step * n, after = t - touch;
    if (after < 0.0) return {t, normal.approach_speed * after, 0.0};
    if (after > ended) return {t, deep - leave * (after - ended), 0.0};
    const reference::DepthState at = depth_at(normal, after);
    return {t, at.depth, normal.stiffness * at.depth + normal.damping * at.rate};
  };
  int first = 0;
  while (sample(first).depth <= 0.0)
    ++first;
  int last = first;
  while (sample(last + 1).depth > 0.0)
    ++last;
  const auto crossing = [&](int n) {
    const Sample a = sample(n), b = sample(n + 1);
    return a.time + a.depth / (a.depth - b.depth) * (b.time - a.time);
  };
  double impulse = 0.0, overlap = 0.0;
  Sample peak;
  for (int n = first; n <= last; ++n) {
    const Sample at = sample(n);
    impulse += state_step * at.force;
    overlap = std::max(overlap, at.depth);
    if (at.force > peak.force) peak = at;
  }
  const reference::ObliqueRebound rebound = reference::rebound(of.impact, of.end);
  const double arm_before = of.radius - 0.5 * sample(first).depth;
  expected.numbers = {{"touch_time", crossing(first - 1)},
                      {"separation_time", crossing(last)},
                      {"approach_speed", normal.approach_speed},
                      {"separation_speed", leave},
                      {"restitution", restitution},
                      // Of body b past body a along the tangent, which for both orders is against the striker's slip.
                      {"slip_before", -(speed_along(of) + of.spin * arm_before)},
                      {"slip_after", -rebound.slip_rate},
                      {"peak_force", peak.force},
                      {"peak_force_time", peak.time},
                      {"largest_overlap", overlap},
                      {"normal_impulse", impulse},
                      {"tangential_impulse", normal.effective_mass * rebound.speed_lost}};
  return expected;
}

/// Largest force of the continuous closed form less that of the states, over (w h)^2/8 of it.
double missed_force(const Striker& of, const Row& row) {
  const reference::ImpactEvents events = impact_events(of.impact.normal, of.end);
  return (events.largest_force / row["peak_force"] - 1.0) / (0.125 * std::pow(events.frequency * state_step, 2));
}

void check_striker(const Striker& of, const Row& row, Findings& findings) {
  const Expected expected = expected_row(of);
  const reference::ImpactEvents& events = expected.events;
  const reference::Impact& normal = of.impact.normal;
  const auto name = [&](const char* what) { return fmt::format("{}: {}", of.name, what); };
  const auto off = [&](const char* column) { return row[column] / expected.numbers.at(column) - 1.0; };
  double speeds = 0.0, samples = 0.0;
  for (const char* column : {"approach_speed", "separation_speed", "restitution", "slip_before"})
    keep_worst(speeds, off(column));
  for (const char* column :
       {"touch_time", "separation_time", "peak_force", "peak_force_time", "largest_overlap", "normal_impulse"})
    keep_worst(samples, off(column));
  findings.expect(name("speeds before and after, restitution, largest relative error"), speeds, 0.0,
                  Tolerance::round_off(3e-10,
                                       "the method's tolerance, 1e-13 of the largest speed for each of some hundred "
                                       "steps; positions of 1 m with an overlap of 1e-4 m lose four digits: 1e-12 of "
                                       "the force. The speeds are constant before and after the contact"));
  findings.expect(name("times, largest force and overlap, impulse of the states, largest relative error"), samples, 0.0,
                  Tolerance::round_off(1e-9,
                                       "as above; the references are the closed-form overlap and force at the times "
                                       "of the states, from which the columns are computed as their documentation "
                                       "says"));
  const double contact = events.contact_time;
  const double released =
      of.end == EndRule::clamped ? events.depth_at_end / (events.restitution * normal.approach_speed) : 0.0;
  findings.expect(name("duration of the overlap"), row["separation_time"] - row["touch_time"], contact + released,
                  Tolerance::truncation(0.25 * events.damping_ratio * events.frequency * state_step * state_step, 2.0,
                                        "each end is interpolated linearly over a step in which the acceleration is at "
                                        "most that of the dashpot, 2 xi w v: at most h^2/8 of it over v"),
                  "s");
  const double impulse = (1.0 + events.restitution) * normal.effective_mass * normal.approach_speed;
  findings.expect(name("normal impulse over the momentum change m(1 + e)v"), row["normal_impulse"] / impulse, 1.0,
                  Tolerance::truncation(0.5 * state_step * events.force_at_touch *
                                            (of.end == EndRule::attractive ? 1.0 + events.restitution : 1.0) / impulse,
                                        1.05,
                                        "the force begins with that of the dashpot, c v; the trapezoidal rule is wrong "
                                        "by at most half a step of such a jump. An attractive contact ends with "
                                        "another, c e v"));
  const double lost = expected.numbers.at("tangential_impulse");
  const double slopes = of.impact.tangential_stiffness * std::abs(of.impact.slip_rate) +
                        of.impact.friction * normal.stiffness * normal.approach_speed;
  findings.expect(name("tangential impulse over the loss of the centre's momentum"), row["tangential_impulse"] / lost,
                  1.0,
                  Tolerance::truncation(state_step * state_step / 8.0 * slopes / std::abs(lost), 1.5,
                                        "friction begins and ends at zero, with kinks where its slope changes by at "
                                        "most k_s v + mu k v_n in all: h^2/8 of each"));
  if (of.is_b) {
    findings.expect(name("slip speed after the impact"), row["slip_after"], expected.numbers.at("slip_after"),
                    Tolerance::round_off(1e-10, "a particle has no lever arm: as the speeds above"), "m/s");
  } else {
    findings.expect(name("slip speed after the impact"), row["slip_after"], expected.numbers.at("slip_after"),
                    Tolerance::model(events.largest_depth / of.radius * std::abs(of.impact.slip_rate),
                                     "the reference has the lever arm r; the contact point is half the overlap nearer "
                                     "to the centre, 1e-4 of r"),
                    "m/s");
  }
  // On body b; the normal is that from a to b, the tangent is 90 degrees further.
  const double sign = of.is_b ? 1.0 : -1.0;
  const double n_x = -sign * std::sin(slope), n_y = sign * std::cos(slope);
  const double x = row["normal_impulse"] * n_x - row["tangential_impulse"] * n_y,
               y = row["normal_impulse"] * n_y + row["tangential_impulse"] * n_x;
  findings.expect(name("world components of the impulse on body b"),
                  std::hypot(row["impulse_x"] - x, row["impulse_y"] - y) / impulse, 0.0,
                  Tolerance::round_off(1e-13, "the normal does not turn; some hundred terms of each sum"));
  const bool labels = row.contact == fmt::format("{} on plane", of.name) &&
                      row.body_a == (of.is_b ? "plane" : of.name) && row.body_b == (of.is_b ? of.name : "plane") &&
                      row["multiplicity"] == 1.0 && row["from_start"] == 0.0 && row["ended"] == 1.0;
  findings.expect_true(name("names, multiplicity and flags"), labels, "as in the scene; it ended before the run");
}

void check_plane(Findings& findings, const Setup& setup) {
  const TemporaryFolder folder;
  folder.write("scene.toml", plane_text(setup));
  const Options options{{"--impacts", {}}, {"--out", {"out"}}};
  const std::string printed = talus_output(folder, with_options({"run", "scene.toml"}, options, setup));
  if (setup.has("without_impacts")) {
    findings.expect_true("impacts.csv is written", std::filesystem::exists(folder.path() / "out/impacts.csv"),
                         "--impacts requests it");
    return;
  }
  findings.expect_true("impacts.csv is written", std::filesystem::exists(folder.path() / "out/impacts.csv"),
                       "--impacts requests it");
  const std::string text = folder.read("out/impacts.csv");
  findings.expect_true("names, units and order of the columns", text.substr(0, text.find('\n')) == header,
                       "units in brackets, as in history.csv");
  std::vector<Row> rows = rows_of(records::read_csv(folder.path() / "out/impacts.csv"));
  findings.expect("rows of two impacts", static_cast<double>(rows.size()), 2.0, Tolerance::exact("one for each body"));
  if (setup.has("rows_exchanged")) std::swap(rows.at(0), rows.at(1));
  check_striker(ball, rows.at(0), findings);
  check_striker(puck, rows.at(1), findings);
  double missed = 0.0;
  keep_worst(missed, missed_force(ball, rows.at(0))), keep_worst(missed, missed_force(puck, rows.at(1)));
  findings.expect("largest forces missed by the states, over (w h)^2/8 of them, largest", missed, 0.0,
                  Tolerance::truncation(1.0, 1.5,
                                        "the maximum of an oscillation of frequency w is at most half a step from the "
                                        "nearest state"));
  // The summary has the same numbers.
  const Json json = records::read_json(folder.path() / "out/summary.json");
  findings.count(Node{json, "summary.json"}.at("evaluations").count());
  const Node summary = Node{json, "summary.json"}.at("impacts");
  Differences differences;
  differences.compare("count", summary.at("count").count(), std::uint64_t{2});
  const std::vector<Node> largest = summary.at("largest").list();
  differences.compare("list", largest.size(), rows.size());
  const std::size_t order = rows.at(0)["peak_force"] > rows.at(1)["peak_force"] ? 0 : 1;
  for (std::size_t i = 0; i < largest.size(); ++i) {
    const Row& row = rows.at(i == 0 ? order : 1 - order);
    differences.compare("number", largest[i].at("number").number(), row["number"]);
    differences.compare("contact", largest[i].at("contact").text(), row.contact);
    for (const char* key :
         {"touch_time", "approach_speed", "restitution", "peak_force", "largest_overlap", "normal_impulse"})
      differences.compare(key, largest[i].at(key).number(), row[key]);
    const std::string line = fmt::format("{} {} {:.7g} {:.7g} {:.6g} {:.7g} {:.7g} {:.7g}", row["number"], row.contact,
                                         row["touch_time"], row["approach_speed"], row["restitution"],
                                         row["peak_force"], row["largest_overlap"], row["normal_impulse"]);
    differences.contains("line of the printed table", squeezed(printed), line);
  }
  differences.expect_none(findings, "summary: numbers that differ from the table",
                          "the summary lists the largest impacts with the numbers of the table");
}

/// The same scene in US units; its quantities name theirs.
void check_units(Findings& findings, const Setup& setup) {
  const TemporaryFolder folder;
  std::string text = plane_text(setup);
  folder.write("si.toml", text);
  replace(text, "units = \"SI\"", "units = \"US\"");
  folder.write("us.toml", text);
  for (const std::string name : {"si", "us"})
    (void)talus_output(folder, {"run", name + ".toml", "--impacts", "--out", name});
  findings.expect("columns in US units beside those in SI units, largest difference over the largest value",
                  units_error(records::read_csv(folder.path() / "us/impacts.csv"),
                              records::read_csv(folder.path() / "si/impacts.csv")),
                  0.0,
                  Tolerance::round_off(1e-9,
                                       "a run has the units of its scene: two runs with the roundings and the "
                                       "tolerance of the method as above"));
}

/// A particle that sticks to the plane by a spring and a dashpot along it: its impulse up to a state in the middle of
/// the contact, beside its momentum.
void check_shear_dashpot(Findings& findings, const Setup& setup) {
  const TemporaryFolder folder;
  folder.write("sled.toml", plane_text(setup, {sled}));
  (void)talus_output(
      folder, {"run", "sled.toml", "--impacts", "--end", fmt::format("{} s", 200.0 * state_step), "--out", "sled"});
  const Row row = rows_of(records::read_csv(folder.path() / "sled/impacts.csv")).at(0);
  const Json json = records::read_json(folder.path() / "sled/final_state.json");
  double speed = std::nan("");
  for (const Node& body : Node{json, "final_state.json"}.at("bodies").list()) {
    const std::vector<Node> velocity = body.at("velocity").list();
    if (body.at("name").text() == "sled")
      speed = velocity.at(0).number() * std::cos(slope) + velocity.at(1).number() * std::sin(slope);
  }
  // Of body b along the tangent, which points down the slope; speeds along the plane are counted up the slope.
  const double lost = sled.impact.normal.effective_mass * (speed_along(sled) - speed);
  findings.expect("tangential impulse with a tangential dashpot over the loss of momentum, middle of the contact",
                  row["tangential_impulse"] / lost, 1.0,
                  Tolerance::truncation(
                      0.5 * state_step * sled.shear_damping * std::abs(sled.impact.slip_rate) / std::abs(lost), 1.05,
                      "friction begins with the force of its dashpot, c_s v; the trapezoidal rule is wrong by at most "
                      "half a step of this jump"));
}

/// A run without the table has the same files, and an interrupted run the same table.
void check_files(Findings& findings, const Setup& setup) {
  const TemporaryFolder folder;
  folder.write("scene.toml", plane_text(setup));
  folder.write("other.toml", plane_text({.fault = "more_damping"}));
  (void)talus_output(folder, {"run", "scene.toml", "--impacts", "--out", "out"});
  (void)talus_output(folder, {"run", setup.has("another_scene") ? "other.toml" : "scene.toml", "--out", "plain"});
  Differences differences;
  differences.compare("impacts.csv", std::filesystem::exists(folder.path() / "plain/impacts.csv"), false);
  for (const char* file : {"history.csv", "final_state.json"})
    differences.compare(file, folder.read(fmt::format("out/{}", file)), folder.read(fmt::format("plain/{}", file)));
  Json with = records::read_json(folder.path() / "out/summary.json"),
       without = records::read_json(folder.path() / "plain/summary.json");
  differences.compare("impacts of summary.json", without.contains("impacts"), false);
  with.erase("impacts"), with.erase("notes"), without.erase("notes");
  differences.compare("summary.json", with, without);
  differences.expect_none(findings, "files that differ without the table",
                          "the table is computed from the observed states; it changes neither steps nor other files");
  // Interruptions in the middle of both impacts; in the last state in which the puck touches: nothing acts in the first
  // state after it, in which its impact ends; and in the last state before either touches.
  const double before = std::floor(std::min(expected_row(ball).touch, expected_row(puck).touch) / state_step);
  const double last = std::floor(expected_row(puck).numbers.at("separation_time") / state_step);
  bool same = true;
  for (const auto& [out, state, acting] :
       {std::tuple{"halves", 100.0, 2.0}, std::tuple{"ending", last, 1.0}, std::tuple{"before", before, 0.0}}) {
    (void)talus_output(folder, {"run", setup.has("another_scene_resumed") ? "other.toml" : "scene.toml", "--impacts",
                                "--out", out, "--until", fmt::format("{} s", state * state_step)});
    double act = 0.0;
    for (const Row& row : rows_of(records::read_csv(folder.path() / out / "impacts.csv")))
      act += 1.0 - row["ended"];
    (void)talus_output(folder, {"run", "--resume", out});
    same = same && act == acting && folder.read("out/impacts.csv") == folder.read(fmt::format("{}/impacts.csv", out));
  }
  findings.expect_true(
      "the same table after an interruption", same,
      "byte-identical; both contacts act at one interruption, only the puck's at another, its last, and none "
      "at one just before the first");
}

// --- A half model ---------------------------------------------------------------------------------------------------

/// The sample fence with four columns, so that the rock strikes between two of them.
std::string fence_text(const std::string& options) {
  std::string text = records::read_whole(case_file("fence/sample2.toml"));
  replace(text, "columns = 13", "columns = 4");
  replace(text, "history_elements = [2, 3, 4, 5, 6]", "history_elements = [2]");
  return text + "\n[fence.options]\n" + options;
}

void check_half_model(Findings& findings, const Setup& setup) {
  const TemporaryFolder folder;
  const auto rows = [&](const std::string& name, const std::string& options) {
    folder.write(name + ".toml", fence_text(options));
    (void)talus_output(folder, {"run", name + ".toml", "--end", "15 ms", "--integrator", "velocity_verlet", "--step",
                                "5 us", "--impacts", "--out", name});
    return rows_of(records::read_csv(folder.path() / name / "impacts.csv"));
  };
  const std::vector<Row> whole = rows("whole", "symmetry = \"full\"\n");
  const std::vector<Row> half =
      rows("half", setup.has("doubled_column") ? "symmetry = \"half\"\neven_centre = \"doubled\"\n"
                                               : "symmetry = \"half\"\neven_centre = \"pair\"\n");
  findings.expect("rows of a half model, each with its multiplicity",
                  std::accumulate(half.begin(), half.end(), 0.0,
                                  [](double sum, const Row& row) { return sum + row["multiplicity"]; }),
                  static_cast<double>(whole.size()),
                  Tolerance::exact("a row of the half model represents those of both halves"));
  double worst = half.empty() ? std::nan("") : 0.0;
  for (const Row& row : half) {
    const auto same = std::ranges::find_if(whole, [&](const Row& of) { return of.contact == row.contact; });
    for (const char* column : {"touch_time", "approach_speed", "slip_before", "peak_force", "largest_overlap",
                               "normal_impulse", "impulse_x", "impulse_y"})
      keep_worst(worst,
                 same == whole.end() ? std::nan("") : (row[column] - (*same)[column]) / (1.0 + std::abs(row[column])));
  }
  findings.expect("numbers of a half model beside those of the whole fence, largest relative error", worst, 0.0,
                  Tolerance::round_off(1e-9,
                                       "the same equations, summed in another order; 3,000 steps, in which roundings "
                                       "of 1e-16 grow with the contact's frequency"));
}

void run(Findings& findings, const Setup& setup) {
  const auto group = findings.in("table");
  if (setup.concerns({"more_damping", "rows_exchanged", "without_impacts"})) check_plane(findings, setup);
  if (setup.fault.empty()) check_units(findings, setup), check_shear_dashpot(findings, setup);
  if (setup.concerns({"another_scene", "another_scene_resumed"})) check_files(findings, setup);
  if (setup.concerns({"damped_yard"})) check_yard(findings, setup);
  if (setup.concerns({"doubled_column"})) check_half_model(findings, setup);
}

}  // namespace

Case definition() {
  return {.id = "impact_table",
          .title = "Table of impacts",
          .requirements = {{"G13", {"table"}}},
          .main_checks = {"ball: speeds before and after, restitution, largest relative error",
                          "impulses less the change of momentum, over the sum of impulses, largest"},
          .source = "Closed forms of verification/reference: restitution, oblique_impact",
          .faults = {{"more_damping", "dashpots stronger by a factor of 1 + 1e-7",
                      "ball: speeds before and after, restitution, largest relative error"},
                     {"rows_exchanged", "the row of the other body", "puck: names, multiplicity and flags"},
                     {"without_impacts", "a run without --impacts", "impacts.csv is written"},
                     {"another_scene", "files of another scene in place of those without the table",
                      "files that differ without the table"},
                     {"another_scene_resumed", "the table of another scene in place of the resumed one",
                      "the same table after an interruption"},
                     {"damped_yard", "dashpots, whose forces at the states are not those of the steps",
                      "impulses less the change of momentum, over the sum of impulses, largest"},
                     {"doubled_column", "one column of double mass in place of the two at the centre",
                      "rows of a half model, each with its multiplicity"}},
          .seconds = 1.5,
          .run = run};
}

}  // namespace talus::verification::problems::impact_table
