#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <string>
#include <vector>

#include "verification/check/case.hpp"
#include "verification/check/case_file.hpp"
#include "verification/problems/program/fit/counted_bounces.hpp"
#include "verification/problems/program/fit/fit_statistics.hpp"
#include "verification/problems/program/pictures/picture_script.hpp"
#include "verification/record/csv.hpp"
#include "verification/record/json_node.hpp"
#include "verification/record/whole_file.hpp"
#include "verification/reference/impacts/damped_bounce.hpp"
#include "verification/reference/impacts/restitution.hpp"
#include "verification/study/findings/expectations.hpp"
#include "verification/study/program/program_options.hpp"
#include "verification/study/program/program_run.hpp"

namespace talus::verification::problems::fitted_parameters {
namespace {

using records::Json;

constexpr double mass = 2.0, radius = 0.1, stiffness = 2e4, damping = 40.0, gravity = 9.81, drop = 0.2;

/// A ball that falls on a floor, or hits it at once without weight.
std::string ball(const std::string& more_of_contact, bool falls) {
  return fmt::format(
      R"(title = "Ball on a floor"
units = "SI"
gravity = ["0 m/s^2", "{} m/s^2"]

[[body]]
name = "floor"
mobility = "fixed"
position = ["0 m", "0 m"]
shape = {{ kind = "half_plane" }}

[[body]]
name = "ball"
mobility = "{}"
mass = "{} kg"
{}position = ["0 m", "{} m"]
velocity = ["0 m/s", "{} m/s"]
shape = {{ kind = "circle", radius = "{} m" }}

[[contact]]
name = "hit"
between = ["ball", "floor"]
law = "linear_spring_dashpot"
stiffness = "{} N/m"
damping = "10 N s/m"
end_rule = "attractive"
{}
[run]
{}
end = "0.1 s"
interval = "10 ms"
watch = "off"
)",
      falls ? -gravity : 0.0, more_of_contact.empty() ? "particle" : "free", mass,
      more_of_contact.empty() ? "" : fmt::format("inertia = \"{} kg m^2\"\n", 0.4 * mass * radius * radius),
      falls ? radius + drop : radius, falls ? 0.0 : -1.0, radius, stiffness, more_of_contact,
      more_of_contact.empty() ? "integrator = \"exact\"\nstep = \"10 ms\""
                              : "integrator = \"velocity_verlet\"\nstep = \"0.05 ms\"");
}

std::string parameter(const std::string& field, const std::string& range, const std::string& more = "") {
  return fmt::format("[[parameter]]\nfield = \"{}\"\nrange = {}\n{}", field, range, more);
}

constexpr const char* heading = "title = \"Ball\"\nscene = \"ball.toml\"\ndata = \"data.csv\"\n";
constexpr const char* of_height =
    "[[input]]\ncolumn = \"time [s]\"\nfield = \"run.end\"\n[[quantity]]\nname = \"height\"\ncolumn = \"y [mm]\"\n"
    "result = \"ball.y.end\"\n";
constexpr const char* of_speed =
    "[[input]]\ncolumn = \"vy [m/s]\"\nfield = \"body.ball.velocity[1]\"\n[[quantity]]\ncolumn = \"rebound [m/s]\"\n"
    "result = \"ball.vy.end\"\n";

/// Heights of a ball that bounces, with noise of this standard deviation.
std::string heights(const Setup& setup, double noise) {
  reference::DampedBounce bounce{.frequency = std::sqrt(stiffness / mass),
                                 .damping_ratio = damping / (2.0 * std::sqrt(stiffness * mass)),
                                 .gravity = gravity,
                                 .gap = drop,
                                 .speed = 0.0,
                                 .end = reference::EndRule::attractive};
  if (setup.has("more_damping")) bounce.damping_ratio *= 1.02;
  std::vector<double> times;
  for (int i = 1; i <= 18; ++i)
    times.push_back(0.05 * i);
  const std::vector<reference::BounceState> states = reference::bounce_states(bounce, times);
  std::mt19937_64 generator{7};
  std::string text = "time [s],y [mm]\n";
  for (std::size_t i = 0; i < times.size(); ++i) {
    // Sum of twelve uniform numbers: nearly normal, with the variance 1.
    double sum = -6.0;
    for (int k = 0; k < 12; ++k)
      sum += std::ldexp(static_cast<double>(generator() >> 11U), -53);
    text += fmt::format("{},{}\n", times[i], 1e3 * (radius + states[i].gap + noise * sum));
  }
  return text;
}

const Json& found(const Json& fit, std::size_t parameter) { return fit.at("parameters").at(parameter); }

/// The picture of the heights: measured values with bars of 1 mm to both sides, and fitted ones.
void check_bars(const std::string& script, const records::Csv& rows, Differences& differ) {
  const auto picture = picture_options::read_picture(script);
  const auto& curves = picture.panels.at(0).curves;
  const auto points_of = [](const picture_options::Curve& curve) {
    std::vector<picture_options::Point> points;
    for (const auto& line : curve.lines)
      points.insert(points.end(), line.begin(), line.end());
    return points;
  };
  const auto measured = points_of(curves.at(0)), fitted = points_of(curves.at(1));
  differ.compare("measured values that are drawn", measured.size(), rows.rows());
  differ.compare("bars that are drawn", curves[0].bars.size(), rows.rows());
  differ.compare("fitted values that are drawn", fitted.size(), rows.rows());
  for (std::size_t row = 0; row < rows.rows() && row < std::min(measured.size(), fitted.size()); ++row) {
    // Six digits of some 300 mm.
    const auto near = [&](double drawn, const char* head, double by) {
      differ.holds(fmt::format("drawn: {} {:+g}", head, by), std::abs(drawn - rows.number(row, head) - by) < 1e-3);
    };
    near(measured[row][1], "height, measured [mm]", 0.0), near(fitted[row][1], "height, fitted [mm]", 0.0);
    if (row >= curves[0].bars.size()) continue;
    near(curves[0].bars[row][0], "height, measured [mm]", -1.0),
        near(curves[0].bars[row][1], "height, measured [mm]", 1.0);
  }
}

/// What is printed of the fit of noisy heights, beside its JSON.
void check_printed(const std::string& printed, const Json& fit, Differences& differ) {
  const std::string text = squeezed(printed);
  differ.contains("printed counts", text,
                  fmt::format("2 parameters fitted to 18 values of 18 rows, {} runs\n", fit.at("runs").get<long>()));
  for (const Json& of : fit.at("parameters")) {
    const auto field = of.at("field").get<std::string>(), unit = of.at("unit").get<std::string>();
    const auto value = of.at("value").get<double>();
    differ.contains("printed parameter", text,
                    fmt::format("\n {} [{}] {:.5g} {:.3g} {:.4g} to {:.4g}\n", field, unit, value,
                                of.at("standard_error").get<double>(), of.at("interval").at(0).get<double>(),
                                of.at("interval").at(1).get<double>()));
    differ.contains("printed line of the scene", text, fmt::format("\n {} = \"{} {}\"\n", field, value, unit));
  }
  differ.contains("printed root mean square", text,
                  fmt::format("root mean square of the deviations: {:.3g} uncertainties\n",
                              std::sqrt(fit.at("sum_of_squares").get<double>() / 18.0)));
}

/// Stiffness and damping of a bouncing ball from its heights, beside those of the closed form.
void check_bounce(const Program& program, Findings& findings, Differences& differ) {
  const Setup& setup = program.setup();
  const std::string both =
      parameter("contact.hit.stiffness", "[\"5 kN/m\", \"100 kN/m\"]", "spacing = \"logarithmic\"\n") +
      parameter("contact.hit.damping", "[\"1 N s/m\", \"200 N s/m\"]", "start = \"100 N s/m\"\n");
  program.write("ball.toml", ball("", true));
  program.write("data.csv", heights(setup, 0.0));
  program.write("exact.toml",
                std::string{heading} + of_height + "uncertainty = \"1 mm\"\n" + both + "[bootstrap]\nsamples = 0\n");
  const Json exact = program.json({"fit", "exact.toml"}, {{"--json", {}}});
  findings.expect(
      "bouncing ball: stiffness fitted to exact heights over that of the closed form, deviation from 1",
      found(exact, 0).at("value").get<double>() / (1e-3 * stiffness) - 1.0, 0.0,
      Tolerance::round_off(
          1e-9, "runs without error of integration; steps of Gauss and Newton to 1e-4 of a standard error, squared"));
  findings.expect("bouncing ball: damping fitted to exact heights over that of the closed form, deviation from 1",
                  found(exact, 1).at("value").get<double>() / damping - 1.0, 0.0,
                  Tolerance::round_off(1e-9, "the same"));
  differ.holds("no interval without samples", found(exact, 0).at("interval").is_null());
  differ.compare("no warning", exact.at("warnings").size(), std::size_t{0});
  differ.compare("unit of the range", found(exact, 0).at("unit").get<std::string>(), std::string{"kN/m"});

  if (!setup.needs("noisy") && !setup.needs("files")) return;  // a control of the exact heights
  // With noise of the given uncertainty.
  const double noise = 1e-3;
  program.write("data.csv", heights(setup, noise));
  program.write("noisy.toml", std::string{heading} + of_height + "uncertainty = \"1 mm\"\n" + both +
                                  "[bootstrap]\nsamples = 60\nseed = 4\n");
  const Json noisy = program.json({"fit", "noisy.toml"}, {{"--json", {}}, {"--out", {"noisy"}}, {"--threads", {"2"}}});
  const std::array truth{1e-3 * stiffness, damping};
  double deviation = 0.0;
  for (std::size_t i = 0; i < truth.size(); ++i)
    keep_worst(deviation, (found(noisy, i).at("value").get<double>() - truth[i]) /
                              found(noisy, i).at("standard_error").get<double>());
  findings.expect("bouncing ball: values of noisy heights less the true ones over their standard error, largest",
                  deviation, 0.0, Tolerance::model(3.5, "normal deviations of two parameters"));
  // Ends of an interval for 18 rows and two parameters: Student's 97.5 % with 16 degrees of freedom is 2.1199.
  const double level = 0.5 * std::erfc(std::sqrt(18.0 / 16.0) * 2.1199052992 / std::sqrt(2.0));
  const double spread = noisy.at("sum_of_squares").get<double>() / noisy.at("degrees_of_freedom").get<double>();
  findings.expect_between("bouncing ball: variance of the deviations over that of the noise", spread, 0.25, 2.2,
                          "chi-squared with 16 degrees of freedom: 99.9 %");
  differ.compare("title", noisy.at("title").get<std::string>(), std::string{"Ball"});
  const double correlation = noisy.at("correlation").at(0).at(1).get<double>();
  differ.compare("correlations are symmetric", noisy.at("correlation").at(1).at(0).get<double>(), correlation);
  differ.compare("correlation with itself", noisy.at("correlation").at(1).at(1).get<double>(), 1.0);
  differ.compare("degrees of freedom", noisy.at("degrees_of_freedom").get<double>(), 16.0);
  differ.holds("file of the fit", program.read("noisy/fit.json") == noisy.dump(2) + "\n");
  check_printed(talus_output(program.folder(), {"fit", "noisy.toml", "--threads", "1", "--out", "alone"},
                             picture_options::recorded_pictures()),
                noisy, differ);
  differ.compare("one thread", program.read("alone/fit.json"), program.read("noisy/fit.json"));

  // The files: rows, differences and their sum of squares; samples and their percentiles.
  const records::Csv rows = program.csv("noisy/fit.csv"), data = program.csv("data.csv"),
                     samples = program.csv("noisy/bootstrap.csv");
  double sum = 0.0, errors = 0.0;
  differ.compare("rows", rows.rows(), data.rows());
  for (std::size_t row = 0; row < rows.rows(); ++row) {
    const auto number = [&](const char* head) { return rows.number(row, head); };
    differ.holds("input of a row", number("time [s]") == data.number(row, 0));
    differ.holds("measured value of a row", number("height, measured [mm]") == data.number(row, 1));
    keep_worst(errors,
               number("height, fitted [mm]") - number("height, measured [mm]") - number("height, difference [mm]"));
    sum += std::pow(number("height, difference [mm]"), 2);
  }
  keep_worst(errors, sum / noisy.at("sum_of_squares").get<double>() - 1.0);
  keep_worst(errors, noisy.at("quantities").at(0).at("root_mean_square").get<double>() / std::sqrt(sum / 18.0) - 1.0);
  differ.compare("samples", samples.rows(), std::size_t{60});
  for (std::size_t i = 0; i < 2; ++i) {
    std::vector<double> values;
    for (std::size_t row = 0; row < samples.rows(); ++row)
      values.push_back(samples.number(row, i));
    std::ranges::sort(values);
    for (const std::size_t end : {std::size_t{0}, std::size_t{1}}) {
      const double rank = (end == 0 ? level : 1.0 - level) * static_cast<double>(values.size() - 1);
      const auto below = static_cast<std::size_t>(rank);
      const double quantile =
          std::lerp(values[below], values[std::min(below + 1, values.size() - 1)], rank - static_cast<double>(below));
      keep_worst(errors, found(noisy, i).at("interval").at(end).get<double>() / quantile - 1.0);
    }
  }
  findings.expect("files of a fit: differences, sums and percentiles, largest error", errors, 0.0,
                  Tolerance::round_off(1e-9, "differences of numbers of 300 that agree to 1 %, sums of 18"));
  double sums[5] = {};
  for (std::size_t row = 0; row < samples.rows(); ++row) {
    const double x = samples.number(row, 0) / truth[0] - 1.0, y = samples.number(row, 1) / truth[1] - 1.0;
    sums[0] += x, sums[1] += y, sums[2] += x * x, sums[3] += y * y, sums[4] += x * y;
  }
  const double of_samples = (sums[4] - sums[0] * sums[1] / 60.0) /
                            std::sqrt((sums[2] - sums[0] * sums[0] / 60.0) * (sums[3] - sums[1] * sums[1] / 60.0));
  findings.expect("bouncing ball: correlation of the parameters less that of the samples", correlation - of_samples,
                  0.0, Tolerance::model(0.4, "60 samples give a correlation to 0.13, 18 rows to 0.25"));
  check_bars(program.read("alone/plots/quantity_1.svg"), rows, differ);
  for (const char* const figure : {"quantity_1.svg", "parameters_1.pdf"})
    differ.holds("figure", program.has(fmt::format("noisy/plots/{}", figure)));

  records::Series measured{.label = "with noise", .style = records::Style::points},
      fitted{.label = "fitted", .style = records::Style::lines};
  for (std::size_t row = 0; row < rows.rows(); ++row) {
    measured.add(rows.number(row, 0), rows.number(row, 1));
    fitted.add(rows.number(row, 0), rows.number(row, 2));
  }
  findings.figure({.name = "heights",
                   .title = "A ball that bounces",
                   .caption =
                       "Heights by the closed form with noise of 1 mm, and of runs with the fitted stiffness and "
                       "damping.",
                   .x = {.label = "time", .unit = "s"},
                   .y = {.label = "height of the centre", .unit = "mm"},
                   .series = {measured, fitted}});
}

/// Friction from tangential restitution where a sphere slides throughout: 1 - mu (1 + e) |vy|/vx.
void check_friction(const Program& program, Findings& findings, Differences& differ) {
  const double friction = program.setup().has("more_friction") ? 0.105 : 0.1, e = 0.9;
  std::string scene = ball(fmt::format("friction = 0.3\nshear_stiffness = \"{} N/m\"\n", stiffness), false);
  scene.replace(scene.find("damping = \"10 N s/m\""), 20, "restitution = 0.9");
  program.write("ball.toml", scene);
  std::string data = "vx [m/s],vy [m/s],ratio\n";
  for (const auto& [vx, vy] : {std::pair{3.0, -1.0}, std::pair{4.0, -1.5}, std::pair{2.0, -1.0}, std::pair{5.0, -1.0}})
    data += fmt::format("{},{},{}\n", vx, vy, 1.0 + friction * (1.0 + e) * vy / vx);
  program.write("data.csv", data);
  program.write("friction.toml",
                std::string{heading} +
                    "[[input]]\ncolumn = \"vx [m/s]\"\nfield = \"body.ball.velocity[0]\"\n[[input]]\ncolumn = \"vy "
                    "[m/s]\"\nfield = \"body.ball.velocity[1]\"\n[[quantity]]\ncolumn = \"ratio\"\nresult = "
                    "\"ball.vx.end\"\ndivided_by = \"vx [m/s]\"\n" +
                    parameter("contact.hit.friction", "[0.0, 1.0]") + "[bootstrap]\nsamples = 40\n");
  const Json fit = program.json({"fit", "friction.toml"}, {{"--json", {}}});
  // Rows drawn again and again have the same friction, each with its own divisor.
  for (const Json& end : found(fit, 0).at("interval"))
    differ.holds("rows and divisors of samples",
                 std::abs(end.get<double>() / found(fit, 0).at("value").get<double>() - 1.0) < 2e-3);
  findings.expect("sliding sphere: fitted friction over that of the closed form, deviation from 1",
                  found(fit, 0).at("value").get<double>() / 0.1 - 1.0, 0.0,
                  Tolerance::model(2e-3, "restitution of a step of 1/600 of the contact"));
  if (program.setup().coarse) return;
  // The search on a logarithmic scale starts at the geometric mean of its ends, here a restitution of 1, the largest
  // that a scene may have.
  std::string of_restitution = program.read("friction.toml");
  of_restitution.replace(of_restitution.find("[[parameter]]"), std::string::npos,
                         parameter("contact.hit.restitution", "[0.01, 100.0]", "spacing = \"logarithmic\"\n") +
                             "[bootstrap]\nsamples = 0\n");
  program.write("restitution.toml", of_restitution);
  differ.compare("start at the geometric mean", program.end({"fit", "restitution.toml"}).messages.find("found 50"),
                 std::string::npos);
  // The divisor in another unit than the result.
  data = "vx [m/s],vx [mm/s],vy [m/s],ratio\n";
  for (const auto& [vx, vy] : {std::pair{3.0, -1.0}, std::pair{4.0, -1.5}, std::pair{2.0, -1.0}, std::pair{5.0, -1.0}})
    data += fmt::format("{},{},{},{}\n", vx, 1e3 * vx, vy, 1.0 + friction * (1.0 + e) * vy / vx);
  program.write("data.csv", data);
  std::string of_millimetres = program.read("friction.toml");
  of_millimetres.replace(of_millimetres.find("divided_by = \"vx [m/s]\""), 23, "divided_by = \"vx [mm/s]\"");
  of_millimetres.replace(of_millimetres.find("samples = 40"), 12, "samples = 0");
  program.write("friction.toml", of_millimetres);
  differ.holds("a divisor in another unit",
               std::abs(found(program.json({"fit", "friction.toml"}, {{"--json", {}}}), 0).at("value").get<double>() /
                            found(fit, 0).at("value").get<double>() -
                        1.0) < 1e-9);
}

/// What a fit must say: parameters that cannot be distinguished, one at its bound, a wrong model, text and fields.
void check_warnings(const Program& program, Differences& differ) {
  program.write("ball.toml", ball("", false));
  // Restitution depends on c/sqrt(k) alone.
  const double e =
      reference::restitution(damping / (2.0 * std::sqrt(stiffness * mass)), reference::EndRule::attractive);
  std::string data = "vy [m/s],rebound [m/s]\n";
  for (const double speed : {0.5, 1.0, 1.5, 2.0, 3.0, 4.0})
    data += fmt::format("{},{}\n", -speed, e * speed * (1.0 + 0.001 * std::sin(20.0 * speed)));
  program.write("data.csv", data);
  const std::string of_damping = parameter("contact.hit.damping", "[\"1 N s/m\", \"200 N s/m\"]");
  const std::string few = "[bootstrap]\nsamples = 40\n";
  program.write("both.toml", std::string{heading} + of_speed + of_damping +
                                 parameter("contact.hit.stiffness", "[\"5 kN/m\", \"100 kN/m\"]") + few);
  const auto message = [&](const std::string& name) { return program.end({"fit", name}); };
  const ProgramEnd both = message("both.toml");
  const std::string named =
      talus_output(program.folder(), {"fit", "both.toml", "--out", "both"}, picture_options::recorded_pictures());
  differ.contains("names of files", named, "\nboth/fit.json\nboth/fit.csv\nboth/bootstrap.csv\nboth/plots/");
  const records::Csv drawn = program.csv("both/bootstrap.csv");
  const auto picture = picture_options::read_picture(program.read("both/plots/parameters_1.svg"));
  std::vector<picture_options::Point> points;
  for (const auto& line : picture.panels.at(0).curves.at(0).lines)
    points.insert(points.end(), line.begin(), line.end());
  differ.compare("samples that are drawn", points.size(), drawn.rows());
  for (std::size_t row = 0; row < drawn.rows() && row < points.size(); ++row)
    for (const std::size_t i : {std::size_t{0}, std::size_t{1}})
      differ.holds("a sample that is drawn", std::abs(points[row][i] / drawn.number(row, i) - 1.0) < 1e-5);
  const Json of_both = program.file("both/fit.json");
  const auto& best = picture.panels.at(0).curves.at(1).lines;
  differ.holds("one point for the fit", best.size() == 1 && best[0].size() == 1);
  for (const std::size_t i : {std::size_t{0}, std::size_t{1}})
    differ.holds("the fit that is drawn",
                 std::abs(best.at(0).at(0)[i] / found(of_both, i).at("value").get<double>() - 1.0) < 1e-5);
  differ.holds(
      "parameters that cannot be distinguished",
      both.exit_code == 0 &&
          both.messages.find(
              "contact.hit.damping and contact.hit.stiffness cannot be distinguished by these data: correlation") !=
              std::string::npos);
  // It depends on the product of stiffness and mass, too: one grows as the other falls.
  std::string lighter = ball("", false);
  program.write("ball.toml", lighter.replace(lighter.find("\"10 N s/m\""), 10, "\"40 N s/m\""));
  program.write("product.toml", std::string{heading} + of_speed +
                                    parameter("contact.hit.stiffness", "[\"5 kN/m\", \"100 kN/m\"]") +
                                    parameter("body.ball.mass", "[\"1 kg\", \"8 kg\"]") + "[bootstrap]\nsamples = 0\n");
  const std::string product = message("product.toml").messages;
  differ.contains("parameters of a product", product,
                  "contact.hit.stiffness and body.ball.mass cannot be distinguished by these data: correlation -1.0");
  program.write("ball.toml", ball("", false));
  program.write("alone.toml", std::string{heading} + of_speed + of_damping + "[bootstrap]\nsamples = 0\n");
  const ProgramEnd alone = message("alone.toml");
  const double value = number_after(squeezed(alone.output), "contact.hit.damping [N s/m]");
  differ.holds("damping of a restitution", std::abs(value / damping - 1.0) < 0.01);
  differ.compare("no warning", alone.messages, std::string{});
  differ.contains("line for the scene", alone.output, "in the scene:\n  contact.hit.damping = \"");
  differ.contains("columns without intervals", squeezed(alone.output), "parameter value standard error\n");
  differ.contains("columns", squeezed(both.output), "parameter value standard error 95 %, bootstrap\n");
  program.write("bound.toml", std::string{heading} + of_speed +
                                  parameter("contact.hit.damping", "[\"60 N s/m\", \"200 N s/m\"]") + few);
  const ProgramEnd bound = message("bound.toml");
  differ.holds("value at a bound", bound.messages.find("contact.hit.damping is at a bound") != std::string::npos &&
                                       number_after(squeezed(bound.output), "contact.hit.damping [N s/m]") == 60.0);
  std::string certain = of_speed;
  program.write("certain.toml", std::string{heading} + of_speed + "uncertainty = \"1e-5 m/s\"\n" + of_damping + few);
  differ.contains("a model that does not describe the data", message("certain.toml").messages,
                  "it does not describe them, or the search has missed the best values");
  // Two rows that are d above and below the model have one degree of freedom: a standard deviation of sqrt(2) d.
  constexpr double apart = 0.01;
  program.write("pair.csv",
                fmt::format("vy [m/s],rebound [m/s]\n-1,{}\n-1,{}\n", e * (1.0 - apart), e * (1.0 + apart)));
  for (const double scatter : {1.98, 2.02}) {
    std::string of_pair = std::string{heading} + of_speed +
                          fmt::format("uncertainty = \"{} m/s\"\n", std::sqrt(2.0) * e * apart / scatter) + of_damping +
                          "[bootstrap]\nsamples = 0\n";
    program.write("pair.toml", of_pair.replace(of_pair.find("data.csv"), 8, "pair.csv"));
    const std::string warned = message("pair.toml").messages;
    differ.holds("a warning from two uncertainties on",
                 scatter < 2.0 ? warned.empty()
                               : warned.find("the standard deviation of the data from the model is 2.02 "
                                             "uncertainties: ") != std::string::npos);
  }
  // Enough rows and samples: nothing to warn of. Without an uncertainty the size of the deviations says nothing.
  std::string many = "vy [m/s],rebound [mm/s]\n";
  for (int i = 1; i <= 18; ++i)
    many += fmt::format("{},{}\n", -0.2 * i, 1e3 * e * 0.2 * i + 5.0 * std::sin(20.0 * i));
  program.write("many.csv", many);
  std::string of_many = std::string{heading} + of_speed + of_damping + "[bootstrap]\nsamples = 80\n";
  of_many.replace(of_many.find("data.csv"), 8, "many.csv");
  of_many.replace(of_many.find("rebound [m/s]"), 13, "rebound [mm/s]");
  program.write("many.toml", of_many);
  differ.compare("enough rows and samples", message("many.toml").messages, std::string{});
  differ.holds("too few samples",
               both.messages.find("intervals are the whole range of the samples: 6 rows and 40 samples are too few") !=
                   std::string::npos);
  // A quantity that is measured twice determines no more: the same samples.
  const std::string certainty = "uncertainty = \"5 mm/s\"\n";
  of_many.insert(of_many.find("[[parameter]]"), certainty);
  program.write("once.toml", of_many);
  of_many.insert(of_many.find("[[parameter]]"),
                 "[[quantity]]\nname = \"again\"\ncolumn = \"rebound [mm/s]\"\nresult = \"ball.vy.end\"\n" + certainty);
  program.write("twice.toml", of_many);
  talus_output(program.folder(), {"fit", "once.toml", "--out", "once"}, picture_options::recorded_pictures());
  talus_output(program.folder(), {"fit", "twice.toml", "--out", "twice"}, picture_options::recorded_pictures());
  const records::Csv once = program.csv("once/bootstrap.csv"), twice = program.csv("twice/bootstrap.csv");
  double moved = 0.0;
  differ.compare("samples of two quantities", twice.rows(), once.rows());
  for (std::size_t row = 0; row < once.rows(); ++row)
    keep_worst(moved, twice.number(row, 0) / once.number(row, 0) - 1.0);
  differ.holds("samples of a quantity that is measured twice", std::abs(moved) < 1e-3);
  const records::Csv fitted = program.csv("twice/fit.csv");
  differ.compare("rows of two quantities", fitted.rows(), std::size_t{18});
  for (std::size_t row = 0; row < fitted.rows(); ++row)
    for (const char* const of : {"measured", "fitted", "difference"})
      differ.compare(fmt::format("{} of a quantity that is measured twice", of),
                     fitted.number(row, fmt::format("again, {} [mm/s]", of)),
                     fitted.number(row, fmt::format("rebound, {} [mm/s]", of)));
  // Each of two quantities in different units has its own measured values and deviations.
  std::string in_metres = "vy [m/s],rebound [m/s],rebound [mm/s]\n", of_units = of_many;
  for (const double speed : {0.5, 1.0, 1.5, 2.0})
    in_metres += fmt::format("{},{},{}\n", -speed, 0.99 * e * speed, 1020.0 * e * speed);
  program.write("units.csv", in_metres);
  of_units.replace(of_units.find("many.csv"), 8, "units.csv");
  of_units.replace(of_units.find("rebound [mm/s]"), 14, "rebound [m/s]");
  of_units.replace(of_units.find("5 mm/s"), 6, "5e-3 m/s");
  program.write("units.toml", of_units);
  const Json units = program.json({"fit", "units.toml"}, {{"--json", {}}, {"--out", {"units"}}});
  const records::Csv in_units = program.csv("units/fit.csv");
  for (std::size_t k = 0; k < 2; ++k) {
    double sum = 0.0;
    for (const double difference : column(in_units, k == 0 ? "rebound, difference" : "again, difference"))
      sum += difference * difference;
    differ.holds("root mean square of a quantity in its unit",
                 std::abs(units.at("quantities").at(k).at("root_mean_square").get<double>() / std::sqrt(sum / 4.0) -
                          1.0) < 1e-9);
  }
  // The rebound does not depend on the position along the floor.
  program.write("free.toml", std::string{heading} + of_speed + of_damping +
                                 parameter("body.ball.position[0]", "[\"-1 m\", \"1 m\"]") + few);
  const ProgramEnd undetermined = program.end({"fit", "free.toml"}, {{"--json", {}}});
  differ.contains("a parameter that the data do not determine", undetermined.messages,
                  "body.ball.position[0] is not determined by these data");
  const Json free = Json::parse(undetermined.output);
  differ.holds("interval of one of two parameters that is not determined",
               found(free, 1).at("interval").is_null() && !found(free, 0).at("interval").is_null());
  program.write("limited.toml", std::string{heading} + of_speed + of_damping + few + "[limits]\nevaluations = 10\n");
  const ProgramEnd limited = message("limited.toml");
  differ.ended("runs without a result", limited, 2,
               "no values of the parameters were found with which all rows have a result; give other "
               "ranges; last failure: row 1: limit of 10 evaluations");
}

/// A scene in US units, whose results are in ft: the data and parameters keep their units.
void check_us_scene(const Program& program, Differences& differ) {
  std::string scene = ball("", true);
  program.write("ball.toml", scene.replace(scene.find("\"SI\""), 4, "\"US\""));
  program.write("data.csv", heights(program.setup(), 0.0));
  program.write("feet.toml", std::string{heading} + of_height +
                                 parameter("contact.hit.damping", "[\"1 N s/m\", \"200 N s/m\"]") +
                                 "[bootstrap]\nsamples = 0\n");
  const Json fit = program.json({"fit", "feet.toml"}, {{"--json", {}}});
  // As of the scene in SI units: steps of Gauss and Newton to 1e-4 of a standard error, squared.
  differ.holds("damping of a scene in US units",
               std::abs(found(fit, 0).at("value").get<double>() / damping - 1.0) < 1e-9);
}

/// A deck of 1993 as scene, in US units: the speed of its rock, by the results of `talus run` in SI units.
void check_deck(const Program& program, Differences& differ) {
  std::string deck = records::read_whole(case_file("fence/table_2.DAT"));
  deck.replace(deck.find("0.03418558 100000"), 17, "0.17 200");
  constexpr double speed = -60.0, foot = 0.3048;
  std::string data = "spin [rad/s],v [m/s]\n";
  for (const char* const spin : {"0.0", "10.0", "20.0"}) {
    std::string measured = deck;
    measured.replace(measured.find("-65.0 0.0 34.0"), 14, fmt::format("-60.0 0.0 {}", spin));
    program.write("fence.DAT", measured);
    const Json summary = program.json({"run", "fence.DAT"}, {{"--json", {}}});
    for (const Json& extreme : summary.at("extremes"))
      if (extreme.at("name").get<std::string>() == "rock.vx")
        data += fmt::format("{},{}\n", spin, foot * extreme.at("minimum").get<double>());
  }
  program.write("fence.DAT", deck);
  program.write("speeds.csv", data);
  program.write("deck.toml",
                "scene = \"fence.DAT\"\ndata = \"speeds.csv\"\n[[input]]\ncolumn = \"spin [rad/s]\"\n"
                "field = \"fence.rock[0].spin\"\n[[quantity]]\ncolumn = \"v [m/s]\"\nresult = \"rock.vx.min\"\n" +
                    parameter("fence.rock[0].velocity[0]", "[\"-75 ft/s\", \"-50 ft/s\"]") +
                    "[bootstrap]\nsamples = 0\n");
  const Json fit = program.json({"fit", "deck.toml"}, {{"--json", {}}});
  differ.holds("speed of a deck's rock", std::abs(found(fit, 0).at("value").get<double>() / speed - 1.0) < 1e-9);
}

void check_refusals(const Program& program, Differences& differ) {
  program.write("ball.toml", ball("", false));
  program.write("data.csv", "vy [m/s],rebound [m/s],zero [m/s],odd [furlong]\n-1,0.5,0,1\n-2,1,1,1\n-3,1.5,1,1\n");
  program.write("empty.csv", "vy [m/s],rebound [m/s]\n");
  program.write("few.csv", "vy [m/s],rebound [m/s]\n-1,0.5\n");
  program.write("twice.csv", "vy [m/s],rebound [m/s],vy [m/s]\n-1,0.5,1\n-2,1,1\n");
  const std::string input = "[[input]]\ncolumn = \"vy [m/s]\"\nfield = \"body.ball.velocity[1]\"\n",
                    quantity = "[[quantity]]\ncolumn = \"rebound [m/s]\"\nresult = \"ball.vy.end\"\n",
                    of_damping = parameter("contact.hit.damping", "[\"1 N s/m\", \"200 N s/m\"]"),
                    of_same = parameter("contact[0].damping", "[\"1 N s/m\", \"200 N s/m\"]"),
                    good = std::string{heading} + input + quantity;
  struct Wrong {
    std::string text, message;
    int exit_code{2};
  };
  const auto with_range = [&](const std::string& range, const std::string& more = "") {
    return good + parameter("contact.hit.damping", range, more);
  };
  const std::vector<Wrong> wrong{
      {"scene = ", "wrong.toml:1: not TOML"},
      {"scene = \"ball.toml\"\n", "data: it is missing"},
      {"scene = \"none.toml\"\ndata = \"data.csv\"\n" + input + quantity + of_damping, "none.toml: No such file", 4},
      {"scene = \"ball.toml\"\ndata = \"none.csv\"\n" + input + quantity + of_damping, "none.csv", 4},
      {"scene = \"ball.toml\"\ndata = \"empty.csv\"\n" + quantity + of_damping, "found no line below the header"},
      {std::string{heading} + input + of_damping, "quantity: it is missing"},
      {good, "parameter: it is missing"},
      {good + of_damping + "[fit]\nx = 1\n", "fit: "},
      {std::string{heading} + "[[input]]\ncolumn = \"v [m/s]\"\nfield = \"run.end\"\n" + quantity + of_damping,
       "found \"v [m/s]\"; it must be a column of data.csv: \"vy [m/s]\", \"rebound [m/s]\""},
      {std::string{heading} + "[[input]]\ncolumn = \"vy [m/s]\"\nfield = \"body.bell.mass\"\n" + quantity + of_damping,
       "wrong.toml:4: input 1: field: "},
      {std::string{heading} + input + "[[quantity]]\ncolumn = \"rebound [m/s]\"\nresult = \"ball.vz.end\"\n" +
           of_damping,
       "quantity 1: result: "},
      {std::string{heading} + input + "[[quantity]]\ncolumn = \"rebound [m/s]\"\nresult = \"ball.y.end\"\n" +
           of_damping,
       "ball.y.end is in m, the column \"rebound [m/s]\" in m/s; give the column in the unit of the result"},
      {std::string{heading} + input + "[[quantity]]\ncolumn = \"odd [furlong]\"\nresult = \"ball.y.end\"\n" +
           of_damping,
       "quantity 1: column: 'furlong' is not a unit"},
      {good + "divided_by = \"zero [m/s]\"\n" + of_damping,
       "found 0 in \"zero [m/s]\"; results cannot be divided by it"},
      {good + "uncertainty = \"1 mm/s\"\n" + of_damping,
       "uncertainty: found \"1 mm/s\"; it must be > 0, in the unit of the column, m/s"},
      {good + "uncertainty = \"0 m/s\"\n" + of_damping, "it must be > 0, in the unit of the column, m/s"},
      {good + quantity + of_damping, "several quantities need an uncertainty each"},
      {good + quantity + of_damping, "found two called \"rebound\"; give them different names"},
      {good + "uncertainty = \"1 m/s\"\n" + quantity + of_damping, "some have an uncertainty, others not"},
      {with_range("[\"2 N s/m\", \"1 N s/m\"]"), "the first must be less than the second"},
      {with_range("[\"1 N s/m\", 2.0]"), "both ends must have the same unit"},
      {with_range("[\"1 N s/m\"]"), "it must be two bounds"},
      {with_range("[\"0 N s/m\", \"1 N s/m\"]", "spacing = \"logarithmic\"\n"),
       "with spacing = \"logarithmic\" both ends must be > 0"},
      {with_range("[\"1 N s/m\", \"2 N s/m\"]", "start = \"3 N s/m\"\n"),
       "start: found \"3 N s/m\"; it must be within"},
      {with_range("[\"1 N s/m\", \"2 N s/m\"]", "spacing = \"cubic\"\n"), "cubic"},
      {with_range("[\"1 kg\", \"2 kg\"]"), "parameter 1: range: its middle, \"1.5 kg\": ball.toml:"},
      {with_range("[2, 60]"), "parameter 1: range: its middle, 31: ball.toml:"},
      {with_range("[2, 60]", "start = 5\n"), "parameter 1: start, 5: ball.toml:"},
      {good + of_damping + of_damping,
       "'contact.hit.damping' and 'contact.hit.damping' are the same field; remove one"},
      {good + of_damping + of_same, "parameter 2: field: 'contact.hit.damping' and 'contact[0].damping' are the same"},
      {good + of_damping + "[bootstrap]\nsamples = -1\n", "samples: found -1"},
      {good + of_damping + "[bootstrap]\nsamples = 5\n", "samples: found 5; it must be 0, or at least 40"},
      {good + of_damping + "[bootstrap]\nsample = 40\n", "bootstrap: sample"},
      {good + "[[parameter]]\nfield = \"contact.hit.damping\"\n", "parameter 1: range: it must be two bounds"},
      {"quantity = []\n" + std::string{heading} + input + of_damping, "quantity: it is missing"},
      {"parameter = []\n" + good, "parameter: it is missing"},
      {"scene = \"ball.toml\"\ndata = \"twice.csv\"\n" + input + quantity + of_damping,
       "found \"vy [m/s]\", which twice.csv has twice; give columns different headings"},
      {"scene = \"ball.toml\"\ndata = \"few.csv\"\n" + input + quantity + of_damping,
       "parameter: found 1 for 1 measured values; there must be more values than parameters"},
      {good + of_damping + "[limits]\ntime = \"1 s\"\n", "limits: time: results would depend on the machine"}};
  for (const Wrong& of : wrong) {
    program.write("wrong.toml", of.text);
    const ProgramEnd end = program.end({"fit", "wrong.toml"}, {{"--out", {"wrong"}}});
    differ.ended("refusal: " + of.message, end, of.exit_code, of.message);
  }
  differ.compare("nothing is written of a wrong fit", program.has("wrong"), false);
}

void run(Findings& findings, const Setup& setup) {
  const auto group = findings.in("fit");
  const Program program{setup};
  Differences differ;
  if (setup.needs("bootstrap: fraction")) check_coverage(findings, setup);
  if (setup.needs("search") || setup.needs("bootstrap: samples")) check_search(findings);
  if (setup.needs("exact heights") || setup.needs("files") || setup.needs("outputs"))
    check_bounce(program, findings, differ);
  if (setup.needs("sliding")) check_friction(program, findings, differ);
  if (setup.needs("each bounce")) check_counted_bounces(program, findings, differ);
  if (setup.needs("outputs that differ")) {
    check_warnings(program, differ);
    check_us_scene(program, differ);
    check_deck(program, differ);
    check_refusals(program, differ);
  }
  differ.expect_none(findings, "outputs that differ from the request", "numbers, texts, files and refusals");
}

}  // namespace

Case definition() {
  const std::string of_damping =
                        "bouncing ball: damping fitted to exact heights over that of the closed form, deviation from 1",
                    counted = "bouncing ball: each bounce: largest difference of a fitted parameter from the true one",
                    friction = "sliding sphere: fitted friction over that of the closed form, deviation from 1",
                    coverage = "bootstrap: fraction of intervals with the true value, largest deviation from 95 %";
  return {.id = "fitted_parameters",
          .title = "Parameters fitted to measurements",
          .requirements = {{"G17", {"fit"}}},
          .main_checks = {of_damping, counted, friction, coverage, "outputs that differ from the request"},
          .source = "Efron 1979",
          .faults = {{"more_damping", "heights of a ball with 1.02 times the damping", of_damping},
                     {"late_bounces", "times of impacts that are 1 ms late", counted},
                     {"more_friction", "restitution with 1.05 times the friction", friction},
                     {"half_interval", "intervals of half the width", coverage}},
          .seconds = 18.0,
          .run = run};
}

}  // namespace talus::verification::problems::fitted_parameters
