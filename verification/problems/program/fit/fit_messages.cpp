#include "verification/problems/program/fit/fit_messages.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "verification/problems/program/fit/fit_files.hpp"
#include "verification/problems/program/fit/fitted_ball.hpp"
#include "verification/problems/program/pictures/picture_script.hpp"
#include "verification/record/csv.hpp"
#include "verification/reference/impacts/restitution.hpp"
#include "verification/study/findings/expectations.hpp"
#include "verification/study/program/program_run.hpp"

namespace talus::verification::problems::fitted_parameters {

using records::Json;

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
  compare_fit_files(program, "both", "data.csv", differ);
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
  for (const auto& [range, end] :
       {std::pair{"[\"60 N s/m\", \"200 N s/m\"]", 60.0}, {"[\"1 N s/m\", \"30 N s/m\"]", 30.0}}) {
    program.write("bound.toml", std::string{heading} + of_speed + parameter("contact.hit.damping", range) + few);
    const ProgramEnd bound = message("bound.toml");
    differ.holds("value at a bound", bound.messages.find("contact.hit.damping is at a bound") != std::string::npos &&
                                         number_after(squeezed(bound.output), "contact.hit.damping [N s/m]") == end);
  }
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
  compare_fit_files(program, "once", "many.csv", differ), compare_fit_files(program, "twice", "many.csv", differ);
  const records::Csv fitted = program.csv("twice/fit.csv");
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
  program.run({"fit", "units.toml"}, {{"--out", {"units"}}, {"--no-plots", {}}});
  compare_fit_files(program, "units", "units.csv", differ);
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

}  // namespace talus::verification::problems::fitted_parameters
