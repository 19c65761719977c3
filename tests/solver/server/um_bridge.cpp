/// Answers by the protocol of UM-Bridge.

#include "solver/server/um_bridge.hpp"

#include <fmt/format.h>

#include <boost/test/unit_test.hpp>
#include <nlohmann/json.hpp>

#include "tests/solver/server/ball_sweep.hpp"

using Json = nlohmann::json;
using talus::app::SweepFunction;
using talus::server::Answer;
using talus::server::UmBridge;

namespace {

const auto never = [] { return false; };

struct Served {
  Folder folder;
  SweepFunction function;
  UmBridge bridge{function};

  explicit Served(const std::string& more = "") : function{write_ball_sweep(folder, more)} {}
};

/// Type and message of an error, whose status is checked.
Json error_of(const Answer& answer, int status) {
  BOOST_TEST(answer.status == status, answer.body);
  return Json::parse(answer.body).at("error");
}

bool holds(const Json& error, const std::string& type, const std::string& part) {
  return error.at("type") == type && error.at("message").get<std::string>().find(part) != std::string::npos;
}

}  // namespace

BOOST_AUTO_TEST_SUITE(um_bridge_tests)

BOOST_AUTO_TEST_CASE(the_model_has_one_vector_of_inputs_and_one_of_outputs) {
  const Served served;
  BOOST_TEST(Json::parse(served.bridge.info().body) == Json::parse(R"({"protocolVersion":1.0,"models":["forward"]})"));
  const std::string request = R"({"name":"forward","config":{}})";
  BOOST_TEST(served.bridge.input_sizes(request).body == R"({"inputSizes":[2]})");
  BOOST_TEST(served.bridge.output_sizes(request).body == R"({"outputSizes":[2]})");
  // Nothing else: the conformity tests of the protocol allow no other members.
  BOOST_TEST(
      Json::parse(served.bridge.model_info(request).body) ==
      Json::parse(R"({"support":{"Evaluate":true,"Gradient":false,"ApplyJacobian":false,"ApplyHessian":false}})"));
  const Json quantities = Json::parse(served.bridge.quantities().body);
  BOOST_TEST(quantities.at("inputs") == Json::parse(R"([{"field":"body.ball.velocity[0]","unit":"m/s"},
                                                         {"field":"contact.hit.damping","unit":"N s/m"}])"));
  BOOST_TEST(quantities.at("outputs") ==
             Json::parse(R"([{"name":"ball.vx.end","unit":"m/s"},{"name":"ball.x.max","unit":"m"}])"));
}

BOOST_AUTO_TEST_CASE(an_evaluation_is_the_run_with_these_fields) {
  const Served served;
  // Without damping the ball leaves as fast as it came; its overlap is v sqrt(m/k) with the mass of the sweep, 2 kg.
  const Answer answer = served.bridge.evaluate(R"({"name":"forward","input":[[3.5,0]],"config":{}})", never);
  BOOST_TEST(answer.status == 200, answer.body);
  const Json output = Json::parse(answer.body).at("output");
  BOOST_TEST(output.size() == 1);
  BOOST_TEST(output[0][0].get<double>() == -3.5, boost::test_tools::tolerance(1e-11));
  BOOST_TEST(output[0][1].get<double>() + 0.1 == 3.5 * std::sqrt(2.0 / 1e5), boost::test_tools::tolerance(1e-3));
}

BOOST_AUTO_TEST_CASE(wrong_requests_are_answered_by_errors) {
  const Served served{"[[constraint]]\nfield = \"body.ball.velocity[0]\"\nat_most = \"4.5 m/s\"\n"};
  const auto evaluated = [&](const std::string& body, int status) {
    return error_of(served.bridge.evaluate(body, never), status);
  };
  BOOST_TEST(holds(evaluated("no", 400), "InvalidInput", "the request is not JSON"));
  BOOST_TEST(holds(evaluated(std::string(1000, '['), 400), "InvalidInput", "nested"));
  BOOST_TEST(holds(evaluated("{\"name\": \"\xff\xfe\"}", 400), "InvalidInput", "the request is not JSON"));
  BOOST_TEST(holds(evaluated(R"({"name":"forward","input":[[1e999,0]]})", 400), "InvalidInput", "not JSON"));
  BOOST_TEST(holds(evaluated("3", 400), "InvalidInput", "no name of a model"));
  BOOST_TEST(holds(evaluated(R"({"name":3})", 400), "InvalidInput", "no name of a model"));
  BOOST_TEST(holds(evaluated(R"({"name":"backward"})", 400), "ModelNotFound", "known: forward"));
  BOOST_TEST(holds(error_of(served.bridge.model_info(R"({"name":"backward"})"), 400), "ModelNotFound", "forward"));
  BOOST_TEST(holds(evaluated(R"({"name":"forward"})", 400), "InvalidInput", "found no list of lists"));
  BOOST_TEST(holds(evaluated(R"({"name":"forward","input":[3,0]})", 400), "InvalidInput", "found 2 lists"));
  BOOST_TEST(holds(evaluated(R"({"name":"forward","input":[3]})", 400), "InvalidInput", "found no list of lists"));
  BOOST_TEST(holds(evaluated(R"({"name":"forward","input":[[3]]})", 400), "InvalidInput",
                   "found a list of 1; it must be one list of 2 numbers"));
  BOOST_TEST(holds(evaluated(R"({"name":"forward","input":[[3,null]]})", 400), "InvalidInput", "found null"));
  BOOST_TEST(holds(evaluated(R"({"name":"forward","input":[[3,-1]]})", 400), "InvalidInput", "damping"));
  BOOST_TEST(holds(evaluated(R"({"name":"forward","input":[[4.6,0]]})", 400), "InvalidInput", "constraint 1"));
  const auto configured = [&](const char* config) {
    return evaluated(fmt::format(R"({{"name":"forward","input":[[3,0]],"config":{}}})", config), 400);
  };
  BOOST_TEST(
      holds(configured(R"({"step":0.001})"), "InvalidInput", "config: found {\"step\":0.001}; the model has no"));
  BOOST_TEST(holds(configured("3"), "InvalidInput", "config: found 3"));
  const auto unsupported = [&](const std::string& body) {
    return error_of(served.bridge.unsupported("Gradient", body), 400);
  };
  BOOST_TEST(holds(unsupported(R"({"name":"forward"})"), "UnsupportedFeature", "Gradient"));
  BOOST_TEST(holds(unsupported(R"({"name":"backward"})"), "ModelNotFound", "forward"));
}

BOOST_AUTO_TEST_CASE(runs_that_fail_are_answered_by_errors) {
  const Served served{"[limits]\nevaluations = 2\n"};
  const std::string request = R"({"name":"forward","input":[[3,0]]})";
  BOOST_TEST(holds(error_of(served.bridge.evaluate(request, never), 500), "InvalidOutput", "limit of 2 evaluations"));
  const Served other;
  BOOST_TEST(holds(error_of(other.bridge.evaluate(request, [] { return true; }), 500), "InvalidOutput", "server ends"));
}

BOOST_AUTO_TEST_SUITE_END()
