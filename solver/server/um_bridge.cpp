#include "solver/server/um_bridge.hpp"

#include <fmt/format.h>

#include <cmath>
#include <nlohmann/json.hpp>
#include <vector>

#include "solver/base/error.hpp"
#include "verification/record/error.hpp"
#include "verification/record/json_depth.hpp"
#include "verification/record/json_fault.hpp"

namespace talus::server {
namespace {

using Json = nlohmann::ordered_json;

Answer error(int status, const char* type, const std::string& message) {
  // A message can quote bytes of a request that are not UTF-8.
  return {status,
          Json{{"error", {{"type", type}, {"message", message}}}}.dump(-1, ' ', false, Json::error_handler_t::replace)};
}

/// The answer of `of` to a request for the model.
template <class Of>
Answer answer(const std::string& body, Of&& of) {
  Json request;
  try {
    records::demand_shallow_json(body, "request");
    request = Json::parse(body);
  } catch (const records::RecordError& wrong) {
    return error(400, "InvalidInput", wrong.what());
  } catch (const nlohmann::json::exception& wrong) {
    return error(400, "InvalidInput", fmt::format("the request is not JSON: {}", records::json_fault(wrong)));
  }
  if (!request.is_object() || !request.contains("name") || !request["name"].is_string())
    return error(400, "InvalidInput", "the request has no name of a model");
  if (const auto name = request["name"].get<std::string>(); name != UmBridge::model) {
    return error(400, "ModelNotFound", fmt::format("model '{}' is not known; known: {}", name, UmBridge::model));
  }
  if (const auto config = request.find("config"); config != request.end() && !(config->is_object() && config->empty()))
    return error(400, "InvalidInput",
                 fmt::format("config: found {}; the model has no options: give {{}} or nothing", config->dump()));
  try {
    return of(request);
  } catch (const InputError& wrong) {
    return error(400, "InvalidInput", wrong.what());
  }
}

}  // namespace

Answer UmBridge::info() const { return {200, Json{{"protocolVersion", 1.0}, {"models", {model}}}.dump()}; }

Answer UmBridge::quantities() const {
  Json json{{"inputs", Json::array()}, {"outputs", Json::array()}};
  for (const app::SweepInput& input : function_->inputs())
    json["inputs"].push_back({{"field", input.field}, {"unit", input.unit}});
  for (const app::SweepOutput& output : function_->outputs())
    json["outputs"].push_back({{"name", output.name}, {"unit", function_->unit(output)}});
  return {200, json.dump()};
}

Answer UmBridge::model_info(const std::string& body) const {
  return answer(body, [&](const Json&) -> Answer {
    return {200, Json{{"support",
                       {{"Evaluate", true}, {"Gradient", false}, {"ApplyJacobian", false}, {"ApplyHessian", false}}}}
                     .dump()};
  });
}

Answer UmBridge::input_sizes(const std::string& body) const {
  return answer(body, [&](const Json&) -> Answer {
    return {200, Json{{"inputSizes", {function_->inputs().size()}}}.dump()};
  });
}

Answer UmBridge::output_sizes(const std::string& body) const {
  return answer(body, [&](const Json&) -> Answer {
    return {200, Json{{"outputSizes", {function_->outputs().size()}}}.dump()};
  });
}

Answer UmBridge::evaluate(const std::string& body, const std::function<bool()>& interrupted) const {
  return answer(body, [&](const Json& request) {
    const std::size_t size = function_->inputs().size();
    const auto invalid = [&](const std::string& found) {
      return error(400, "InvalidInput", fmt::format("input: found {}; it must be one list of {} numbers", found, size));
    };
    const auto input = request.find("input");
    if (input == request.end() || !input->is_array()) return invalid("no list of lists");
    if (input->size() != 1) return invalid(fmt::format("{} lists", input->size()));
    const Json& list = input->front();
    if (!list.is_array()) return invalid("no list of lists");
    if (list.size() != size) return invalid(fmt::format("a list of {}", list.size()));
    std::vector<double> numbers;
    for (const Json& number : list) {
      if (!number.is_number()) return invalid(number.dump());
      numbers.push_back(number.get<double>());
    }
    const app::SweepResult result = (*function_)(numbers, interrupted);
    if (result.id.empty()) return error(500, "InvalidOutput", "the server ends");
    if (const std::string failure = app::failure_of(result); !failure.empty()) {
      if (result.end == app::SweepEnd::refused) return error(400, "InvalidInput", failure);
      return error(500, "InvalidOutput", failure);
    }
    return Answer{200, Json{{"output", Json::array({result.values})}}.dump()};
  });
}

Answer UmBridge::unsupported(const std::string& feature, const std::string& body) const {
  return answer(body, [&](const Json&) { return error(400, "UnsupportedFeature", feature + " is not supported"); });
}

}  // namespace talus::server
