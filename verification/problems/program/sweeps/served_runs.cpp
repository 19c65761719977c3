#include "verification/problems/program/sweeps/served_runs.hpp"

#include <cmath>
#include <cstddef>
#include <string>
#include <vector>

#include "verification/problems/program/sweeps/ball_sweep.hpp"
#include "verification/record/json_node.hpp"
#include "verification/reference/impacts/restitution.hpp"
#include "verification/study/program/program_server.hpp"

namespace talus::verification::problems::swept_scenes {

using records::Json;

void check_server(const Program& program, Differences& differ) {
  program.write("served.toml", "base = \"ball.toml\"\noutputs = [\"ball.vx.end\", \"ball.x.max\"]\n" +
                                   axis("body.ball.velocity[0]", "range = [\"1 m/s\", \"5 m/s\"]\ncount = 2") +
                                   axis("contact.hit.damping", "values = [\"0 N s/m\", \"400 N s/m\"]") +
                                   axis("run.step", "values = [\"0.1 ms\", \"0.001 ms\"]") +
                                   axis("body.ball.mass", "values = [\"8 kg\"]") +
                                   "[[constraint]]\nfield = \"body.ball.velocity[0]\"\nat_most = \"4 m/s\"\n"
                                   "[limits]\nevaluations = 20000\n");
  ProgramServer server{program.folder(), "served.toml"};
  const Json model{{"name", "forward"}, {"config", Json::object()}};
  differ.compare("server: inputs", server.post("/InputSizes", model).body, Json{{"inputSizes", {3}}});
  differ.compare("server: outputs", server.post("/OutputSizes", model).body, Json{{"outputSizes", {2}}});
  const ServerAnswer quantities = server.get("/Quantities");
  differ.compare(
      "server: quantities", quantities.body,
      Json{{"inputs",
            {{{"field", "body.ball.velocity[0]"}, {"unit", "m/s"}},
             {{"field", "contact.hit.damping"}, {"unit", "N s/m"}},
             {{"field", "run.step"}, {"unit", "ms"}}}},
           {"outputs", {{{"name", "ball.vx.end"}, {"unit", "m/s"}}, {{"name", "ball.x.max"}, {"unit", "m"}}}}});
  const auto evaluated = [&](double speed, double damping, double milliseconds) {
    Json request = model;
    request["input"] = Json::array({Json::array({speed, damping, milliseconds})});
    return server.post("/Evaluate", request);
  };
  for (const double speed : {1.5, 4.0}) {
    constexpr double damping = 250.0, mass = 8.0, stiffness = 1e5;
    const reference::ImpactEvents exact =
        reference::impact_events({stiffness, damping, mass, speed}, reference::EndRule::clamped);
    const ServerAnswer answer = evaluated(speed, damping, 0.1);
    differ.compare("server: status of a run", answer.status, 200);
    if (answer.status != 200) continue;
    const auto output = answer.body.at("output").at(0).get<std::vector<double>>();
    differ.holds("server: velocity", std::abs(output.at(0) / (-exact.restitution * speed) - 1.0) < 1e-11);
    // The extreme is that of states 1e-4 s apart.
    differ.holds("server: overlap", std::abs((output.at(1) + radius) / exact.largest_depth - 1.0) < 1e-4);
  }
  struct Failing {
    double speed, damping, milliseconds;
    int status;
    std::string type, message;
  };
  const std::vector<Failing> runs{{2.0, -10.0, 0.1, 400, "InvalidInput", "refused: ball.toml:"},
                                  {4.1, 10.0, 0.1, 400, "InvalidInput", "refused: constraint 1: it is not satisfied"},
                                  {2.0, 10.0, 1e-3, 500, "InvalidOutput", "limited: limit of 20000 evaluations"}};
  for (const auto& [speed, damping, milliseconds, status, type, message] : runs) {
    const ServerAnswer answer = evaluated(speed, damping, milliseconds);
    differ.compare("server: status: " + message, answer.status, status);
    differ.compare("server: error: " + message, answer.body.value("/error/type"_json_pointer, ""), type);
    differ.holds("server: message: " + message,
                 answer.body.value("/error/message"_json_pointer, "").starts_with(message));
  }
  // The model has one input (/InputSizes): a request without a list, or with two, has no answer.
  for (const std::size_t lists : {std::size_t{0}, std::size_t{2}}) {
    Json request = model;
    request["input"] = Json(lists, Json::array({2.0, 10.0, 0.1}));
    const ServerAnswer answer = server.post("/Evaluate", request);
    const std::string item = std::to_string(lists) + " lists";
    differ.compare("server: status of " + item, answer.status, 400);
    differ.compare("server: error of " + item, answer.body.value("/error/type"_json_pointer, ""),
                   std::string{"InvalidInput"});
    differ.holds("server: message of " + item,
                 answer.body.value("/error/message"_json_pointer, "").starts_with("input: found " + item));
  }
  // Likewise for lists with too few or too many numbers.
  for (const std::size_t numbers : {std::size_t{2}, std::size_t{4}}) {
    Json request = model;
    request["input"] = Json::array({Json(numbers, 2.0)});
    const ServerAnswer answer = server.post("/Evaluate", request);
    const std::string item = "a list of " + std::to_string(numbers);
    differ.compare("server: status of " + item, answer.status, 400);
    differ.compare("server: message of " + item, answer.body.value("/error/message"_json_pointer, ""),
                   "input: found " + item + "; it must be one list of 3 numbers");
  }
}

}  // namespace talus::verification::problems::swept_scenes
