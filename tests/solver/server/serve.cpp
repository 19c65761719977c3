/// The program talus_serve, as a client of UM-Bridge uses it.

#include <httplib.h>

#include <boost/test/unit_test.hpp>
#include <chrono>
#include <csignal>
#include <fstream>
#include <map>
#include <nlohmann/json.hpp>
#include <thread>
#include <utility>

#include "tests/solver/app/program.hpp"
#include "tests/solver/server/ball_sweep.hpp"

using Json = nlohmann::json;

namespace {

std::string text_of(const fs::path& file) {
  std::ifstream in{file};
  return {std::istreambuf_iterator<char>{in}, {}};
}

/// A server of the ball, and its client.
struct Server {
  Folder folder;
  StartedProgram program;
  int port{};

  explicit Server(const std::string& more = "", const std::map<std::string, std::string>& environment = {})
      : program{TALUS_SERVE,
                {write_ball_sweep(folder, more).string(), "--port", "0", "--threads", "2"},
                {.out = folder.path / "out", .err = folder.path / "err"},
                environment} {
    const std::string start = "listening on http://127.0.0.1:";
    std::string line;
    for (int i = 0; i < 500 && line.find('\n') == std::string::npos; ++i) {
      std::this_thread::sleep_for(std::chrono::milliseconds{20});
      line = text_of(folder.path / "out");
    }
    BOOST_REQUIRE(line.starts_with(start));
    BOOST_TEST(line.ends_with(", model 'forward': 2 inputs, 2 outputs\n"), line);
    port = std::stoi(line.substr(start.size()));
  }

  /// Status and body of an answer; 0 and null without one. For threads, in which the macros of Boost.Test must not be
  /// used, and from which an exception would end the test without ending the server.
  std::pair<int, Json> answer(const std::string& path, const Json& body) const {
    httplib::Client client{"127.0.0.1", port};
    const auto answer = client.Post(path, body.dump(), "application/json");
    if (!answer) return {0, nullptr};
    return {answer->status, Json::parse(answer->body)};
  }

  Json post(const std::string& path, const Json& body, int expected = 200) const {
    auto [status, json] = answer(path, body);
    BOOST_TEST(status == expected, json);
    return json;
  }
};

}  // namespace

BOOST_AUTO_TEST_SUITE(serve_tests)

BOOST_AUTO_TEST_CASE(a_client_asks_and_evaluates) {
  const Server server;
  httplib::Client client{"127.0.0.1", server.port};
  const auto info = client.Get("/Info");
  BOOST_REQUIRE(info);
  BOOST_TEST(Json::parse(info->body).at("protocolVersion") == 1.0);
  const Json of{{"name", Json::parse(info->body).at("models").at(0)}, {"config", Json::object()}};
  BOOST_TEST(server.post("/ModelInfo", of).at("support").at("Evaluate") == true);
  const auto quantities = client.Get("/Quantities");
  BOOST_REQUIRE(quantities);
  BOOST_TEST(Json::parse(quantities->body).at("inputs").size() == 2);
  BOOST_TEST(server.post("/InputSizes", of).at("inputSizes") == Json::array({2}));
  BOOST_TEST(server.post("/OutputSizes", of).at("outputSizes") == Json::array({2}));
  Json request = of;
  request["input"] = {{3.0, 100.0}};
  const Json output = server.post("/Evaluate", request).at("output");
  // The same number as by `talus sweep evaluate`, which writes 17 digits.
  const fs::path parameters = server.folder.file("params.in",
                                                 "2 variables\n3 body.ball.velocity[0]\n100 contact.hit.damping\n"
                                                 "1 functions\n1 ASV_1:ball.vx.end\n0 derivative_variables\n"
                                                 "0 analysis_components\n1 eval_id\n");
  const fs::path results = server.folder.path / "results.out";
  StartedProgram evaluate{
      TALUS_EXECUTABLE,
      {"sweep", "evaluate", (server.folder.path / "sweep.toml").string(), parameters.string(), results.string()}};
  BOOST_TEST(evaluate.exit_code() == 0);
  BOOST_TEST(std::stod(text_of(results)) == output[0][0].get<double>());
  for (const char* const feature : {"/Gradient", "/ApplyJacobian", "/ApplyHessian"})
    BOOST_TEST(server.post(feature, of, 400).at("error").at("type") == "UnsupportedFeature");
}

BOOST_AUTO_TEST_CASE(evaluations_at_a_time_are_those_one_after_the_other) {
  const Server server;
  const auto output = [&](int i) {
    return server.answer("/Evaluate", {{"name", "forward"}, {"input", {{1.0 + 0.1 * i, 10.0 * i}}}});
  };
  constexpr int count = 24;
  std::vector<std::pair<int, Json>> alone(count), together(count);
  for (int i = 0; i < count; ++i)
    alone[static_cast<std::size_t>(i)] = output(i);
  std::vector<std::thread> clients;
  for (int client = 0; client < 6; ++client) {
    clients.emplace_back([&, client] {
      for (int i = client; i < count; i += 6)
        together[static_cast<std::size_t>(i)] = output(i);
    });
  }
  for (std::thread& client : clients)
    client.join();
  BOOST_TEST((alone == together));
  for (const auto& [status, json] : alone)
    BOOST_TEST((status == 200 && json.contains("output")), json);
  BOOST_TEST((alone[0] != alone[1]));
}

BOOST_AUTO_TEST_CASE(a_signal_ends_the_server_and_its_runs) {
  // 1e9 steps: hours.
  Server server{"[[axis]]\nfield = \"run.step\"\nvalues = [\"1e-10 s\"]\n"};
  std::pair<int, Json> answer;
  std::thread client{[&] { answer = server.answer("/Evaluate", {{"name", "forward"}, {"input", {{3.0, 100.0}}}}); }};
  std::this_thread::sleep_for(std::chrono::milliseconds{300});
  server.program.send(SIGTERM);
  client.join();
  BOOST_TEST_REQUIRE(answer.first == 500);
  BOOST_TEST(answer.second.at("error").at("message") == "the server ends");
  BOOST_TEST(server.program.exit_code() == 128 + SIGTERM);
}

BOOST_AUTO_TEST_CASE(a_signal_before_connections_are_accepted_ends_the_server) {
  // Otherwise the address sanitizer refuses to start, as it is not loaded first.
  Server server{"", {{"LD_PRELOAD", TALUS_LATE_LISTENING}, {"ASAN_OPTIONS", "verify_asan_link_order=0"}}};
  server.program.send(SIGTERM);
  for (int i = 0; i < 500 && server.program.is_running(); ++i)
    std::this_thread::sleep_for(std::chrono::milliseconds{20});
  BOOST_TEST_REQUIRE(!server.program.is_running());
  BOOST_TEST(server.program.exit_code() == 128 + SIGTERM);
}

BOOST_AUTO_TEST_CASE(wrong_commands_have_messages) {
  const Server server;
  const std::string sweep = (server.folder.path / "sweep.toml").string();
  struct Wrong {
    std::vector<std::string> arguments;
    int code;
    std::string message;
  };
  const std::string texts = server.folder.file("texts.toml",
                                               "base = \"ball.toml\"\noutputs = [\"ball.vx.end\"]\n[[axis]]\n"
                                               "field = \"run.integrator\"\nvalues = [\"exact\", \"rk4\"]\n");
  const std::string fixed = server.folder.file("fixed.toml",
                                               "base = \"ball.toml\"\noutputs = [\"ball.vx.end\"]\n[[axis]]\n"
                                               "field = \"run.step\"\nvalues = [\"1e-4 s\"]\n");
  const std::vector<Wrong> all{
      {{}, 2, "talus_serve: SWEEP is required"},
      {{"none.toml"}, 4, "none.toml: No such file"},
      {{sweep, "--port", "65536"}, 2, "--port"},
      {{sweep, "--threads", "0"}, 2, "--threads"},
      {{texts}, 2, "texts.toml: axis: 'run.integrator': "},
      {{fixed}, 2, "fixed.toml: axis: all have one point; give one with a range or several values"},
      {{sweep, "--port", std::to_string(server.port)},
       4,
       "talus_serve: the address cannot be bound; give --host one of this machine and --port a free one"}};
  for (const Wrong& wrong : all) {
    const fs::path err = server.folder.path / "wrong";
    fs::remove(err);
    StartedProgram program{TALUS_SERVE, wrong.arguments, {.out = "/dev/null", .err = err}};
    BOOST_TEST(program.exit_code() == wrong.code, wrong.message);
    BOOST_TEST((text_of(err).find(wrong.message) != std::string::npos), text_of(err));
  }
}

BOOST_AUTO_TEST_SUITE_END()
