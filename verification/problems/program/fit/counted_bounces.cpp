#include "verification/problems/program/fit/counted_bounces.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "verification/problems/program/fit/fit_files.hpp"
#include "verification/problems/program/fit/fitted_ball.hpp"
#include "verification/problems/program/pictures/picture_script.hpp"
#include "verification/record/csv.hpp"
#include "verification/record/json_node.hpp"
#include "verification/reference/impacts/damped_bounce.hpp"
#include "verification/study/program/program_run.hpp"
#include "verification/study/program/sweep_results.hpp"

namespace talus::verification::problems::fitted_parameters {
namespace {

using records::Json;

constexpr double end = 0.9;
constexpr std::array heights{0.25, 0.3, 0.4};  ///< of the centre at the start

constexpr double other_height = 0.22;

/// Two balls, so that impacts of two contacts alternate.
constexpr const char* scene = R"(title = "Balls on a floor"
units = "SI"
gravity = ["0 m/s^2", "-9.81 m/s^2"]

[[body]]
name = "floor"
mobility = "fixed"
position = ["0 m", "0 m"]
shape = { kind = "half_plane" }

[[body]]
name = "ball"
mobility = "particle"
mass = "2 kg"
position = ["0 m", "0.3 m"]
shape = { kind = "circle", radius = "0.1 m" }

[[body]]
name = "other"
mobility = "particle"
mass = "2 kg"
position = ["1 m", "0.22 m"]
shape = { kind = "circle", radius = "0.1 m" }

[[contact]]
name = "strike"
between = ["other", "floor"]
law = "linear_spring_dashpot"
stiffness = "20 kN/m"
damping = "40 N s/m"
end_rule = "attractive"

[[contact]]
name = "hit"
between = ["ball", "floor"]
law = "linear_spring_dashpot"
stiffness = "20 kN/m"
damping = "40 N s/m"
end_rule = "attractive"

[run]
integrator = "exact"
step = "0.25 ms"
end = "0.9 s"
interval = "10 ms"
watch = "off"
)";

/// The first bounces of a ball that is dropped from a height.
std::vector<reference::Bounce> bounces_from(double height, double factor_of_damping = 1.0) {
  return reference::bounces({.frequency = std::sqrt(stiffness / mass),
                             .damping_ratio = factor_of_damping * damping / (2.0 * std::sqrt(stiffness * mass)),
                             .gravity = gravity,
                             .gap = height - radius,
                             .speed = 0.0,
                             .end = reference::EndRule::attractive},
                            3);
}

/// Impacts that begin before a run ends, of which the last may not have ended, and maxima in free flight.
struct Counted {
  std::size_t impacts{}, ended{}, maxima{};

  explicit Counted(const std::vector<reference::Bounce>& bounces) {
    for (const reference::Bounce& bounce : bounces) {
      impacts += bounce.start_time < end ? 1 : 0;
      ended += bounce.end_time < end ? 1 : 0;
      maxima += bounce.end_time - bounce.end_velocity / gravity < end ? 1 : 0;
    }
  }
};

/// Each number of each bounce, and of those that the run does not have none, with the reason.
void check_numbers(const Program& program, Findings& findings, Differences& differ) {
  std::string outputs;
  for (int k = 0; k < 3; ++k) {
    for (const char* const number : {"touch_time", "separation_time", "approach_speed", "separation_speed"})
      outputs += fmt::format("\"impact.hit[{}].{}\", ", k, number);
    outputs += fmt::format("\"ball.y.peak[{0}]\", \"body.ball.y.peak_time[{0}]\", ", k);
    outputs += fmt::format("\"impact.strike[{0}].touch_time\", \"other.y.peak[{0}]\", ", k);
  }
  program.write("counted.toml", scene);
  program.write("counts.toml", "base = \"counted.toml\"\noutputs = [" + outputs +
                                   "\"impact.hit[0].restitution\"]\n[[axis]]\nfield = \"body.ball.position[1]\"\n"
                                   "values = [\"0.25 m\", \"0.3 m\", \"0.4 m\"]\n");
  program.run({"sweep", "plan", "counts.toml"});
  program.run({"sweep", "run", "counts"});
  program.run({"sweep", "collect", "counts"});
  const records::Csv csv = compared_sweep(program, "counts", differ);
  const Json json = program.file("counts/results.json");
  double times = 0.0, speeds = 0.0, maxima = 0.0, restitutions = 0.0;
  std::size_t missing = 0;
  differ.compare("runs of counted bounces", csv.rows(), heights.size());
  for (std::size_t row = 0; row < csv.rows(); ++row) {
    const std::vector<reference::Bounce> bounces = bounces_from(heights[row]);
    const Counted counted{bounces};
    const auto compare = [&](double& worst, const std::string& name, const std::string& unit, bool exists,
                             double expected) {
      const std::size_t column = csv.column(fmt::format("{} [{}]", name, unit));
      if (exists) keep_worst(worst, csv.number(row, column) - expected);
      differ.compare("a number that exists: " + name, !csv.cell(row, column).empty(), exists);
      missing += exists ? 0 : 1;
    };
    for (std::size_t k = 0; k < bounces.size(); ++k) {
      const reference::Bounce& bounce = bounces[k];
      const std::string impact = fmt::format("impact.hit[{}].", k);
      compare(times, impact + "touch_time", "s", k < counted.impacts, bounce.start_time);
      compare(times, impact + "separation_time", "s", k < counted.ended, bounce.end_time);
      compare(speeds, impact + "approach_speed", "m/s", k < counted.impacts, bounce.start_speed);
      compare(speeds, impact + "separation_speed", "m/s", k < counted.ended, -bounce.end_velocity);
      compare(maxima, fmt::format("ball.y.peak[{}]", k), "m", k < counted.maxima, radius + bounce.apex_gap);
      compare(maxima, fmt::format("body.ball.y.peak_time[{}]", k), "s", k < counted.maxima,
              bounce.end_time - bounce.end_velocity / gravity);
    }
    const std::vector<reference::Bounce> others = bounces_from(other_height);
    for (std::size_t k = 0; k < others.size(); ++k) {
      compare(times, fmt::format("impact.strike[{}].touch_time", k), "s", true, others[k].start_time);
      compare(maxima, fmt::format("other.y.peak[{}]", k), "m", true, radius + others[k].apex_gap);
    }
    keep_worst(restitutions, csv.number(row, "impact.hit[0].restitution") -
                                 csv.number(row, "impact.hit[0].separation_speed [m/s]") /
                                     csv.number(row, "impact.hit[0].approach_speed [m/s]"));
    const std::string reason{csv.cell(row, "reason")};
    const auto says = [&](const std::string& text) { return reason.find(text) != std::string::npos; };
    differ.holds("reason of a number that does not exist",
                 counted.maxima == bounces.size()    ? reason.empty()
                 : counted.impacts == bounces.size() ? says("the impact has not ended") || says("maxima")
                                                     : says(fmt::format("{} impacts in the run", counted.impacts)) ||
                                                           says("the impact has not ended") || says("maxima"));
    differ.holds("a run without a number is finished", csv.cell(row, "end") == "finished");
    differ.compare("numbers of a run in results.json", json.at("runs").at(row).at("values").size(), std::size_t{25});
  }
  findings.expect("bouncing ball: each bounce: times of impacts, largest error", times, 0.0,
                  Tolerance::model(2.5e-7, "linear between two states: (g + c v/m) h^2/(8 v) with v of 1 m/s"));
  findings.expect("bouncing ball: each bounce: speeds of impacts, largest error", speeds, 0.0,
                  Tolerance::model(1e-2, "those of the states before and after, at most h (g + 2 xi omega v) away"));
  findings.expect("bouncing ball: each bounce: local maxima and their times, largest error", maxima, 0.0,
                  Tolerance::round_off(1e-11,
                                       "free flight is a parabola; round-off of 1e-16 over g h^2 = 1e-7, and "
                                       "of times over g h"));
  findings.expect("bouncing ball: each bounce: restitution less the ratio of its speeds", restitutions, 0.0,
                  Tolerance::round_off(1e-15, "one division"));
  findings.expect_between("bouncing ball: each bounce: numbers that do not exist", static_cast<double>(missing), 1.0,
                          20.0, "the run ends after two or three impacts");
}

/// A maximum that lasts: without gravity and dashpots the ball flies back from the floor with its constant speed, until
/// it hits a ceiling. Its time is the middle.
void check_lasting_maximum(const Program& program, Differences& differ) {
  constexpr double speed = 2.0, height = 0.3, ceiling = 0.6, step = 0.25e-3;
  std::string text = scene;
  for (const auto& [from, to] : {std::pair{"\"-9.81 m/s^2\"", "\"0 m/s^2\""}, {"40 N s/m", "0 N s/m"}})
    for (std::size_t at = text.find(from); at != std::string::npos; at = text.find(from, at + 1))
      text.replace(at, std::string_view{from}.size(), to);
  const std::string of_ball = "position = [\"0 m\", \"0.3 m\"]\n";
  text.insert(text.find(of_ball), fmt::format("velocity = [\"0 m/s\", \"{} m/s\"]\n", -speed));
  text.insert(text.find("[[contact]]"),
              fmt::format("[[body]]\nname = \"ceiling\"\nmobility = \"fixed\"\nposition = [\"0 m\", \"{} m\"]\n"
                          "angle = \"180 deg\"\nshape = {{ kind = \"half_plane\" }}\n[[contact]]\nname = \"top\"\n"
                          "between = [\"ball\", \"ceiling\"]\nlaw = \"linear_spring_dashpot\"\n"
                          "stiffness = \"20 kN/m\"\ndamping = \"0 N s/m\"\n\n",
                          ceiling));
  program.write("lasting.toml", text);
  program.write("lasts.toml",
                "base = \"lasting.toml\"\noutputs = [\"ball.vy.peak[0]\", \"ball.vy.peak_time[0]\"]\n"
                "[[axis]]\nfield = \"body.ball.mass\"\nvalues = [\"2 kg\"]\n");
  program.run({"sweep", "plan", "lasts.toml"});
  program.run({"sweep", "run", "lasts"});
  program.run({"sweep", "collect", "lasts"});
  const records::Csv csv = compared_sweep(program, "lasts", differ);
  const double leaves = (height - radius) / speed + std::numbers::pi * std::sqrt(mass / stiffness),
               hits = leaves + (ceiling - 2.0 * radius) / speed;
  differ.holds("a maximum that lasts", std::abs(csv.number(0, "ball.vy.peak[0] [m/s]") / speed - 1.0) < 1e-12);
  // Its first and its last state are up to a step away from these times.
  differ.holds("time of a maximum that lasts",
               std::abs(csv.number(0, "ball.vy.peak_time[0] [s]") - 0.5 * (leaves + hits)) < 0.5 * step);
}

}  // namespace

void check_counted_bounces(const Program& program, Findings& findings, Differences& differ) {
  const Setup& setup = program.setup();
  check_numbers(program, findings, differ);
  check_lasting_maximum(program, differ);

  const double late = setup.has("late_bounces") ? 1e-3 : 0.0;
  std::string data = "drop [mm],first [mm],second [cm],again [ms]\n";
  for (const double height : std::span{heights}.first(setup.coarse ? 1 : heights.size())) {
    const std::vector<reference::Bounce> bounces = bounces_from(height);
    data += fmt::format("{},{},{},{}\n", 1e3 * height, 1e3 * (radius + bounces[0].apex_gap),
                        1e2 * (radius + bounces[1].apex_gap), 1e3 * (bounces[1].start_time + late));
  }
  program.write("data.csv", data);
  // Half as many steps, for some thousand runs.
  std::string coarse = scene;
  const std::string step = "0.25 ms";
  program.write("coarse.toml", coarse.replace(coarse.find(step), step.size(), "0.5 ms"));
  program.write("counted.fit.toml", R"(title = "Counted bounces"
scene = "coarse.toml"
data = "data.csv"
[[input]]
column = "drop [mm]"
field = "body.ball.position[1]"
[[quantity]]
column = "first [mm]"
result = "ball.y.peak[0]"
uncertainty = "1 mm"
[[quantity]]
column = "second [cm]"
result = "ball.y.peak[1]"
uncertainty = "0.1 cm"
[[quantity]]
column = "again [ms]"
result = "impact.hit[1].touch_time"
uncertainty = "1 ms"
[[parameter]]
field = "contact.hit.stiffness"
range = ["15 kN/m", "30 kN/m"]
spacing = "logarithmic"
[[parameter]]
field = "contact.hit.damping"
range = ["20 N s/m", "80 N s/m"]
[bootstrap]
samples = 0
)");
  const Json fit = Json::parse(talus_output(program.folder(), {"fit", "counted.fit.toml", "--out", "drawn", "--json"},
                                            picture_options::recorded_pictures()));
  // Measured and fitted values of each quantity as drawn, in six digits, over the first column.
  const records::Csv rows = program.csv("drawn/fit.csv");
  compare_fit_files(program, "drawn", "data.csv", differ);
  for (const std::size_t quantity : {1, 2, 3}) {
    const auto picture =
        picture_options::read_picture(program.read(fmt::format("drawn/plots/quantity_{}.svg", quantity)));
    const std::vector<picture_options::Curve>& curves = picture.panels.at(0).curves;
    differ.compare("curves of a quantity", curves.size(), std::size_t{2});
    for (std::size_t curve = 0; curve < curves.size(); ++curve) {
      std::vector<picture_options::Point> points;
      for (const auto& line : curves[curve].lines)
        points.insert(points.end(), line.begin(), line.end());
      differ.compare("points of a quantity", points.size(), rows.rows());
      for (std::size_t row = 0; row < std::min(points.size(), rows.rows()); ++row) {
        const double value = rows.number(row, 1 + 3 * (quantity - 1) + curve);
        differ.holds(fmt::format("drawn values of quantity {}", quantity),
                     std::abs(points[row][0] / rows.number(row, 0) - 1.0) < 1e-5 &&
                         std::abs(points[row][1] / value - 1.0) < 1e-5);
      }
    }
  }
  double worst = 0.0;
  const auto value = [&](std::size_t i) { return fit.at("parameters").at(i).at("value").get<double>(); };
  keep_worst(worst, value(0) / (1e-3 * stiffness) - 1.0);
  keep_worst(worst, value(1) / damping - 1.0);
  findings.expect(
      "bouncing ball: each bounce: largest difference of a fitted parameter from the true one", worst, 0.0,
      Tolerance::model(5e-5,
                       "a touch at the fraction u of a step is off by (g + c v/m) h^2/(8 v) 4 u (1 - u), of 9e-7 s in "
                       "the middle; the second touches of the rows have u = 0.15, 0.91, 0.73, up to 0.78 of that. Of "
                       "a contact of 0.033 s, twice the ratio is 3.8e-5 of the stiffness; the damping, whose ratio "
                       "the apexes determine, is off by half of that"));

  // Nothing to compare with: the impact is beyond the end of the run.
  std::string none = program.read("counted.fit.toml");
  none.replace(none.find("impact.hit[1]"), 13, "impact.hit[9]");
  program.write("none.fit.toml", none);
  const ProgramEnd refused = program.end({"fit", "none.fit.toml"});
  differ.ended("a fit to an impact that no run has", refused, 2,
               "impact.hit[9].touch_time has no value: the contact has ");
}

}  // namespace talus::verification::problems::fitted_parameters
