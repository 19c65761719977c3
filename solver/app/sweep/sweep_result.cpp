#include "solver/app/sweep/sweep_result.hpp"

#include <fmt/format.h>

#include <limits>
#include <nlohmann/json.hpp>

#include "solver/base/error.hpp"
#include "verification/record/json_fault.hpp"

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
  try {
    const Json json = Json::parse(line);
    if (json.at("sweep").get<std::string>() != sweep)
      throw InputError{"the result is of another base, or has other outputs or limits; remove it, or plan that sweep"};
    SweepResult result;
    result.id = json.at("id").get<std::string>();
    result.end = value_named<SweepEnd>("end", json.at("end").get<std::string>());
    result.reason = json.value("reason", "");
    result.time = json.at("time").get<double>();
    result.evaluations = json.at("evaluations").get<long>();
    result.verdict = json.value("verdict", "");
    for (const Json& value : json.at("values"))
      result.values.push_back(value.is_null() ? std::numeric_limits<double>::quiet_NaN() : value.get<double>());
    return result;
  } catch (const nlohmann::json::exception& error) {
    throw InputError{
        fmt::format("not a result; remove this line and run the sweep again: {}", records::json_fault(error))};
  }
}

}  // namespace talus::app
