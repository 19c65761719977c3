#include "solver/app/sweep/sweep_result.hpp"

#include <fmt/format.h>

#include <limits>
#include <nlohmann/json.hpp>

#include "solver/base/error.hpp"
#include "verification/record/json_fault.hpp"
#include "verification/record/json_node.hpp"

namespace talus::app {
namespace {

using Json = nlohmann::ordered_json;

}  // namespace

std::string no_value(std::string_view output, std::string_view reason) {
  return fmt::format("{} has no value: {}", output, reason);
}

std::string result_line(const SweepResult& result, std::string_view sweep) {
  Json json{{"id", result.id}, {"sweep", sweep}, {"end", name_of(result.end)}};
  if (!result.reason.empty()) json["reason"] = result.reason;
  json["time"] = result.time;
  json["evaluations"] = result.evaluations;
  if (!result.verdict.empty()) json["verdict"] = result.verdict;
  json["values"] = result.values;  // a number that is not finite becomes null
  return json.dump(-1, ' ', false, Json::error_handler_t::replace);
}

SweepResult result_of_line(const std::string& line, std::string_view sweep) {
  const auto refused = [](std::string_view reason) {
    return InputError{fmt::format("not a result; remove this line and run the sweep again: {}", reason)};
  };
  try {
    const Json json = Json::parse(line);
    const records::Node node{json, "result"};
    if (node.at("sweep").text() != sweep)
      throw InputError{"the result is of another base, or has other outputs or limits; remove it, or plan that sweep"};
    SweepResult result;
    result.id = node.at("id").text();
    result.end = value_named<SweepEnd>("end", node.at("end").text());
    if (node.has("reason")) result.reason = node.at("reason").text();
    result.time = node.at("time").number();
    result.evaluations = static_cast<long>(node.at("evaluations").count());
    if (node.has("verdict")) result.verdict = node.at("verdict").text();
    for (const records::Node& value : node.at("values").list())
      result.values.push_back(value.json().is_null() ? std::numeric_limits<double>::quiet_NaN() : value.number());
    return result;
  } catch (const records::RecordError& error) {
    throw refused(error.what());
  } catch (const Json::exception& error) {
    throw refused(records::json_fault(error));
  }
}

}  // namespace talus::app
