#include "solver/io/output/write_advice.hpp"

#include <cmath>
#include <nlohmann/json.hpp>
#include <utility>

namespace talus {
namespace {

nlohmann::ordered_json json_of(const RunMethod& method, double duration) {
  nlohmann::ordered_json json{{"integrator", method.integrator}};
  if (method.tolerance != 0.0) json["tolerance"] = method.tolerance;
  json["step"] = duration / static_cast<double>(method.steps);
  return json;
}

}  // namespace

nlohmann::ordered_json advice_json(const Scene& scene, const Quantity& quantity, const AdviceRules& rules,
                                   const Advice& advice) {
  const double duration = scene.plan.end - scene.initial.t;
  nlohmann::ordered_json json{{"quantity", quantity.name}, {"accuracy", rules.accuracy}};
  if (!advice.reference.other.empty())
    json["value"] = advice.reference.value * si_size(scene.model.units, quantity.dimension);
  json["growth"] = {{"start", advice.growth.fraction}, {"result", advice.growth.result}};
  json["evaluations_of_pilots"] = advice.evaluations;
  json["tried"] = nlohmann::ordered_json::array();
  for (const TriedMethod& tried : advice.tried) {
    nlohmann::ordered_json entry = tried.evaluations > 0
                                       ? json_of(tried.method, duration)
                                       : nlohmann::ordered_json{{"integrator", tried.method.integrator}};
    if (tried.evaluations > 0 && std::isfinite(tried.error)) entry["error"] = tried.error;
    if (tried.evaluations > 0) entry["evaluations"] = tried.evaluations;
    entry["verdict"] = tried.verdict.empty() ? "good" : tried.verdict;
    json["tried"].push_back(std::move(entry));
  }
  if (advice.refusal) {
    json["refusal"] = {{"kind", name_of(advice.refusal->kind)}, {"message", advice.refusal->message}};
  } else {
    json["advice"] = json_of(advice.best->method, duration);
    json["advice"]["error"] = advice.best->error;
    json["advice"]["evaluations"] = advice.best->evaluations;
  }
  json["units"] = "SI";
  return json;
}

}  // namespace talus
