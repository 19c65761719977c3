#include "verification/problems/program/sweeps/dakota_files.hpp"

#include <fmt/format.h>

#include <cmath>
#include <sstream>
#include <string>
#include <tuple>
#include <vector>

#include "verification/reference/impacts/restitution.hpp"

namespace talus::verification::problems::swept_scenes {
namespace {

/// A parameters file as Dakota 6.16 and newer write it: numbers in columns of 20 and more, with 16 digits.
std::string parameters(double speed, double damping, int first_active, std::string_view id = "1") {
  return fmt::format(
      "{0:>40} variables\n{1:>40.15e} contact.hit.damping\n{2:>40.15e} body.ball.velocity[0]\n{0:>40} functions\n"
      "{3:>40} ASV_1:ball.x.max\n{4:>40} ASV_2:ball.vx.end\n{0:>40} derivative_variables\n{4:>40} "
      "DVV_1:contact.hit.damping\n{0:>40} DVV_2:body.ball.velocity[0]\n{5:>40} analysis_components\n{6:>40} eval_id\n"
      "{5:>40} metadata\n",
      2, damping, speed, first_active, 1, 0, id);
}

}  // namespace

void check_dakota(const Program& program, Differences& differ) {
  const std::string axes =
      "[[axis]]\nfield = \"body.ball.velocity[0]\"\nrange = [\"1 m/s\", \"5 m/s\"]\ncount = 2\n"
      "[[axis]]\nfield = \"contact.hit.damping\"\nvalues = [\"0 N s/m\", \"400 N s/m\"]\n";
  const std::string sweep = "base = \"ball.toml\"\noutputs = [\"ball.vx.end\", \"ball.x.max\"]\n" + axes;
  program.write("dakota.toml", sweep + "[[axis]]\nfield = \"body.ball.mass\"\nvalues = [\"8 kg\"]\n");
  const auto evaluated = [&](const std::string& text, const std::string& file = "dakota.toml") {
    program.write("params.in", text);
    return program.end({"sweep", "evaluate", file, "params.in", "results.out"});
  };
  for (const double speed : {1.5, 4.0}) {
    constexpr double damping = 250.0, mass = 8.0, stiffness = 1e5;
    const reference::ImpactEvents exact =
        reference::impact_events({stiffness, damping, mass, speed}, reference::EndRule::clamped);
    differ.compare("dakota: exit status", evaluated(parameters(speed, damping, 1)).exit_code, 0);
    std::istringstream results{program.read("results.out")};
    double depth = 0.0, velocity = 0.0;
    std::string first, second;
    results >> depth >> first >> velocity >> second;
    differ.compare("dakota: labels", first + " " + second, std::string{"ball.x.max ball.vx.end"});
    differ.holds("dakota: velocity", std::abs(velocity / (-exact.restitution * speed) - 1.0) < 1e-11);
    // The extreme is that of states 1e-4 s apart; the radius is 0.1 m.
    differ.holds("dakota: overlap", std::abs((depth + 0.1) / exact.largest_depth - 1.0) < 1e-4);
    differ.compare("dakota: all digits", fmt::format("{:.17g} ball.x.max\n{:.17g} ball.vx.end\n", depth, velocity),
                   program.read("results.out"));
    static_cast<void>(evaluated(parameters(speed, damping, 0)));
    differ.compare("dakota: only active responses", fmt::format("{:.17g} ball.vx.end\n", velocity),
                   program.read("results.out"));
  }
  // A batch, whose second run Talus refuses, beside its runs alone; the first one as an older Dakota writes it, without
  // metadata. Three of them, so that two threads do not end with the last one.
  std::string first = parameters(1.5, 250.0, 1, "4:1");
  first.resize(first.rfind(fmt::format("{:>40} metadata", 0)));
  const std::vector<std::string> batch{first, parameters(2.0, -10.0, 1, "4:2"), parameters(4.0, 300.0, 0, "4:3")};
  std::string expected, together;
  for (const std::string& of : batch) {
    static_cast<void>(evaluated(of));
    expected += (expected.empty() ? "" : "#\n") + program.read("results.out");
    together += of;
  }
  const ProgramEnd ended = evaluated(together);
  differ.compare("dakota: batch", program.read("results.out"), expected);
  program.run({"sweep", "evaluate", "dakota.toml", "params.in", "one.out"}, {{"--threads", {"1"}}});
  differ.compare("dakota: batch with one thread", program.read("one.out"), expected);
  // With the ends of lines of Windows.
  std::string carried;
  for (const char c : together)
    carried += c == '\n' ? std::string{"\r\n"} : std::string{c};
  static_cast<void>(evaluated(carried));
  differ.compare("dakota: batch with carriage returns", program.read("results.out"), expected);
  differ.ended("dakota: message of a run of a batch", ended, 0, "run 2: refused: ball.toml:");

  // A run that fails is a file that says so, by which Dakota decides.
  program.write("limited.toml", sweep + "[limits]\nevaluations = 2\n");
  const ProgramEnd limited = evaluated(parameters(2.0, 10.0, 1), "limited.toml");
  differ.compare("dakota: failure", program.read("results.out"), std::string{"FAIL limited: limit of 2 evaluations\n"});
  differ.ended("dakota: message of a failure", limited, 0, "limit of 2 evaluations");
  static_cast<void>(evaluated(parameters(2.0, -10.0, 1)));
  differ.holds("dakota: refused", program.read("results.out").starts_with("FAIL refused: ball.toml:"));
  // Constraints at their limits: the same run, one that breaks a constraint none.
  program.write("constrained.toml", program.read("dakota.toml") +
                                        "[[constraint]]\nfield = \"contact.hit.damping\"\nat_least = \"10 N s/m\"\n"
                                        "[[constraint]]\nfield = \"body.ball.velocity[0]\"\nat_most = \"2 m/s\"\n");
  static_cast<void>(evaluated(parameters(2.0, 10.0, 1)));
  const std::string free = program.read("results.out");
  static_cast<void>(evaluated(parameters(2.0, 10.0, 1), "constrained.toml"));
  differ.compare("dakota: at the limits of constraints", program.read("results.out"), free);
  for (const auto& [speed, damping, constraint] : {std::tuple{2.0, 9.0, 1}, {2.1, 10.0, 2}}) {
    const ProgramEnd broken = evaluated(parameters(speed, damping, 1), "constrained.toml");
    const std::string reason = fmt::format("constraint {}: it is not satisfied", constraint);
    differ.compare("dakota: a broken constraint", program.read("results.out"), "FAIL refused: " + reason + "\n");
    differ.ended("dakota: message of a broken constraint", broken, 0, reason);
  }

  struct Wrong {
    std::string text, message;
  };
  const std::string good = parameters(2.0, 10.0, 1);
  const auto with = [&](const std::string& part, const std::string& other) {
    std::string text = good;
    return text.replace(text.find(part), part.size(), other);
  };
  const std::vector<Wrong> wrong{
      {"", "params.in:1: the file ends here"},
      {"{ DAKOTA_VARS = 2 }\n", "params.in:1: found \"{ DAKOTA_VARS = 2 }\"; it must be a value and a label"},
      {"x variables\n", "params.in:1: found \"x variables\"; it must be a number"},
      {"9999999 variables\n", "params.in:1: found \"9999999 variables\"; it must be a number, at most 100000"},
      {"2x variables\n", "params.in:1: found \"2x variables\"; it must be a number"},
      {"2 variables\n", "params.in:2: the file ends here"},
      {"1 variables\nnan contact.hit.damping\n", "params.in:2: variable 'contact.hit.damping': found nan"},
      {with("body.ball.velocity[0]", "contact.hit.damping"),
       "params.in:3: variable 'contact.hit.damping': it is the "
       "second one with this label"},
      {with("body.ball.velocity[0]", "speed"), "params.in: variable: field of an axis 'speed' is not known"},
      {"1 variables\n3 body.ball.velocity[0]\n1 functions\n1 ASV_1:ball.vx.end\n0 derivative_variables\n"
       "0 analysis_components\n1 eval_id\n",
       "params.in: variable 'contact.hit.damping': it is missing"},
      {with("0 analysis_components", "1 analysis_components"),
       "params.in:10: found 1 analysis_components; it must be 0: nothing would use them"},
      {with("0 metadata", "1 metadata"),
       "params.in:12: found 1 metadata; it must be 0: give these numbers as responses"},
      {with(" eval_id", " evaluation"), "params.in:11: found \"1 evaluation\"; it must be a number and \"eval_id\""},
      {good + "\n" + with("ASV_1:ball.x.max", "ASV_1:ball.x.min"), "params.in: response: output 'ball.x.min'"},
      {good + "\n" + good.substr(0, good.find("2 functions")), "params.in:17: the file ends here"},
      {with("ASV_1:ball.x.max", "ASV_2:ball.x.max"), "params.in:5: found \"ASV_2:ball.x.max\"; it must be ASV_1:"},
      {with("ASV_1:ball.x.max", "ASV_1:ball.x.min"), "params.in: response: output 'ball.x.min' is not known"},
      {parameters(2.0, 10.0, 3), "params.in:5: response 'ball.x.max': found the active set 3; it must be 0 or 1"}};
  program.write("results.out", "of another run");
  for (const Wrong& of : wrong) {
    const ProgramEnd end = evaluated(of.text);
    differ.ended("refusal: " + of.message, end, 2, of.message);
  }
  differ.compare("dakota: nothing is written of a wrong request", program.read("results.out"),
                 std::string{"of another run"});
  program.write("texts.toml",
                "base = \"ball.toml\"\noutputs = [\"ball.vx.end\"]\n[[axis]]\nfield = \"run.integrator\"\n"
                "values = [\"exact\", \"rk4\"]\n");
  const ProgramEnd texts = evaluated(good, "texts.toml");
  differ.ended("refusal: texts", texts, 2, "texts.toml: axis: 'run.integrator': ");
}

}  // namespace talus::verification::problems::swept_scenes
