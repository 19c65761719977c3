#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <random>
#include <string>
#include <vector>

#include "verification/check/case.hpp"
#include "verification/check/case_file.hpp"
#include "verification/problems/program/fit/counted_bounces.hpp"
#include "verification/problems/program/fit/fit_files.hpp"
#include "verification/problems/program/fit/fit_messages.hpp"
#include "verification/problems/program/fit/fit_statistics.hpp"
#include "verification/problems/program/fit/fitted_ball.hpp"
#include "verification/problems/program/pictures/picture_script.hpp"
#include "verification/record/csv.hpp"
#include "verification/record/json_node.hpp"
#include "verification/record/whole_file.hpp"
#include "verification/reference/impacts/damped_bounce.hpp"
#include "verification/study/findings/expectations.hpp"
#include "verification/study/findings/sample_quantile.hpp"
#include "verification/study/program/program_options.hpp"
#include "verification/study/program/program_run.hpp"

namespace talus::verification::problems::fitted_parameters {
namespace {

using records::Json;

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
  const int every = setup.coarse ? 3 : 1;
  for (int i = every; i <= 18; i += every)
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

/// Compares the printed fit of noisy heights with its JSON output.
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

  if (setup.coarse) return;  // a control of the exact heights, which has fewer of them
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
  differ.compare("seed of the samples", noisy.at("bootstrap").at("seed").get<int>(), 4);
  differ.compare("title", noisy.at("title").get<std::string>(), std::string{"Ball"});
  const double correlation = noisy.at("correlation").at(0).at(1).get<double>();
  differ.compare("correlations are symmetric", noisy.at("correlation").at(1).at(0).get<double>(), correlation);
  differ.compare("correlation with itself", noisy.at("correlation").at(1).at(1).get<double>(), 1.0);
  differ.compare("degrees of freedom", noisy.at("degrees_of_freedom").get<double>(), 16.0);
  // As values: the audit of the interface writes files of JSON again, with other spaces.
  differ.holds("file of the fit", program.file("noisy/fit.json") == noisy);
  check_printed(talus_output(program.folder(), {"fit", "noisy.toml", "--threads", "1", "--out", "alone"},
                             picture_options::recorded_pictures()),
                noisy, differ);
  differ.compare("one thread", program.read("alone/fit.json"), program.read("noisy/fit.json"));

  // The files: rows and the sum of squares of their differences; samples and their percentiles.
  compare_fit_files(program, "noisy", "data.csv", differ);
  const records::Csv rows = program.csv("noisy/fit.csv"), data = program.csv("data.csv"),
                     samples = program.csv("noisy/bootstrap.csv");
  double sum = 0.0, errors = 0.0;
  for (std::size_t row = 0; row < rows.rows(); ++row) {
    differ.compare("measured value of a row", rows.number(row, "height, measured [mm]"), data.number(row, 1));
    sum += std::pow(rows.number(row, "height, difference [mm]"), 2);
  }
  keep_worst(errors, sum / noisy.at("sum_of_squares").get<double>() - 1.0);
  differ.compare("samples", samples.rows(), std::size_t{60});
  for (std::size_t i = 0; i < 2; ++i) {
    std::vector<double> values;
    for (std::size_t row = 0; row < samples.rows(); ++row)
      values.push_back(samples.number(row, i));
    std::ranges::sort(values);
    for (const std::size_t end : {std::size_t{0}, std::size_t{1}}) {
      const double quantile = sample_quantile(values, end == 0 ? level : 1.0 - level);
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

/// Rows of unequal friction mu_i, with a_i = (1 + e) |vy|/vx: the friction of each sample is one of the possible
/// sums(n_i a_i^2 mu_i)/sums(n_i a_i^2) of four rows that are drawn n_i times; each row is divided by its speed.
void check_divided_samples(const Program& program, Differences& differ) {
  constexpr double e = 0.9;
  constexpr std::array vx{3.0, 4.0, 2.0, 5.0}, vy{-1.0, -1.5, -1.0, -1.0}, friction{0.08, 0.11, 0.1, 0.14};
  std::string data = "vx [m/s],vy [m/s],ratio\n";
  std::array<double, 4> products{}, squares{};
  for (std::size_t row = 0; row < 4; ++row) {
    const double a = (1.0 + e) * -vy[row] / vx[row];
    products[row] = a * a * friction[row], squares[row] = a * a;
    data += fmt::format("{},{},{}\n", vx[row], vy[row], 1.0 - friction[row] * a);
  }
  const std::vector<double> possible = ratios_of_samples(products, squares);
  program.write("data.csv", data);
  (void)program.json({"fit", "friction.toml"}, {{"--out", {"divided"}}, {"--no-plots", {}}, {"--json", {}}});
  compare_fit_files(program, "divided", "data.csv", differ);
  const records::Csv samples = program.csv("divided/bootstrap.csv");
  for (std::size_t row = 0; row < samples.rows(); ++row) {
    double nearest = 1.0;
    for (const double value : possible)
      keep_smallest(nearest, std::abs(samples.number(row, 0) / value - 1.0));
    // Restitution of a step of 1/600 of the contact.
    differ.holds("friction of a sample whose rows have their divisors", nearest < 2e-3);
  }
  differ.compare("samples of rows with divisors", samples.rows(), std::size_t{40});
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
  // Rows drawn again and again have the same friction.
  for (const Json& end : found(fit, 0).at("interval"))
    differ.holds("rows of samples", std::abs(end.get<double>() / found(fit, 0).at("value").get<double>() - 1.0) < 2e-3);
  findings.expect("sliding sphere: fitted friction over that of the closed form, deviation from 1",
                  found(fit, 0).at("value").get<double>() / 0.1 - 1.0, 0.0,
                  Tolerance::model(2e-3, "restitution of a step of 1/600 of the contact"));
  if (program.setup().coarse) return;
  check_divided_samples(program, differ);
  program.write("data.csv", data);
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
