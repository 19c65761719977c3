#include "verification/driver/baseline_json.hpp"

#include <nlohmann/json.hpp>

#include "verification/record/json_number.hpp"

namespace talus::verification {

namespace {

using records::json_number;
using Json = nlohmann::ordered_json;

constexpr int baseline_schema = 1;

Json to_json(const ResultsSource& source) {
  const Provenance& from = source.provenance;
  Json libraries = Json::object();
  for (const auto& [library, version] : from.libraries)
    libraries[library] = version;
  return {{"file", source.file.string()},
          {"verdict", source.holds ? "pass" : "fail"},
          {"revision", from.revision},
          {"dirty", from.dirty},
          {"date", from.date},
          {"compiler", from.compiler},
          {"flags", from.flags},
          {"build_type", from.build_type},
          {"cpu", from.cpu},
          {"os", from.os},
          {"libraries", libraries}};
}

Json to_json(const Allowance& allowance) {
  Json tolerances = Json::array();
  for (const ChangeTolerance& tolerance : allowance.tolerances)
    tolerances.push_back(
        {{"of", tolerance.name.empty() ? Json(nullptr) : Json(tolerance.name)}, {"tolerance", tolerance.value}});
  return {{"tolerances", tolerances},
          {"margin", allowance.margin ? Json(*allowance.margin) : Json(nullptr)},
          {"round_off", allowance.round_off},
          {"evaluation_growth", allowance.evaluation_growth},
          {"only", allowance.only}};
}

Json to_json(const Check& check) {
  Json json{{"measured", json_number(check.measured)},
            {"reference", json_number(check.reference)},
            {"error", json_number(check.error)},
            {"bound", check.bound},
            {"margin", json_number(check.margin)},
            {"relative", check.relative},
            {"kind", name_of(check.kind)},
            {"unit", check.unit},
            {"pass", check.pass}};
  if (!check.text_measured.empty()) json["text_measured"] = check.text_measured;
  return json;
}

Json to_json(const Control& control) {
  return {{"turns_red", control.turns_red},
          {"observed", name_of(control.observed)},
          {"unplanted", name_of(control.unplanted)},
          {"pass", control.pass()},
          {"message", control.message}};
}

Json to_json(const CaseOutcome& outcome) {
  return {{"status", name_of(outcome.status)},
          {"message", outcome.message},
          {"evaluations", outcome.evaluations},
          {"seconds", outcome.seconds}};
}

/// The common fields of all changes; the values are appended last.
template <class T>
Json head_of(const Change<T>& change) {
  Json json{{"case", change.name.id}};
  if (!change.name.item.empty()) json["name"] = change.name.item;
  if (change.renamed_from) json["renamed_from"] = text_of(*change.renamed_from);
  json["presence"] = name_of(change.presence);
  json["worse"] = Json::array();
  for (const Reason reason : change.worse)
    json["worse"].push_back(name_of(reason));
  return json;
}

template <class T>
Json with_values(Json json, const Change<T>& change) {
  json["before"] = change.before ? to_json(*change.before) : Json(nullptr);
  json["after"] = change.after ? to_json(*change.after) : Json(nullptr);
  return json;
}

Json to_json(const CheckChange& change) {
  Json json = head_of(change);
  if (change.presence == Presence::both) {
    json["value"] = name_of(change.movement);
    json["difference"] = json_number(change.difference);
    json["change_over_bound"] = json_number(change.moved);
    json["tolerance"] = change.tolerance;
    json["margin_growth"] = json_number(change.growth);
  }
  return with_values(std::move(json), change);
}

Json to_json(const ControlChange& change) { return with_values(head_of(change), change); }

Json to_json(const CaseChange& change) {
  Json json = head_of(change);
  json["checks_gone"] = change.checks_gone;
  json["controls_gone"] = change.controls_gone;
  return with_values(std::move(json), change);
}

Json to_json(const Totals::Items& items) {
  return {{"compared", items.compared},
          {"worse", items.worse},
          {"pass_to_fail", items.worsened},
          {"fail_to_pass", items.improved},
          {"gone", items.gone},
          {"removed", items.removed},
          {"new", items.added}};
}

Json to_json(const Totals& totals) {
  return {{"cases", to_json(totals.cases)},
          {"checks", to_json(totals.checks)},
          {"controls", to_json(totals.controls)},
          {"values", {{"identical", totals.identical}, {"round_off", totals.round_off}, {"changed", totals.changed}}},
          {"margins", {{"grown", totals.margins_grown}, {"shrunk", totals.margins_shrunk}}},
          {"bounds", {{"widened", totals.bounds_widened}, {"tightened", totals.bounds_tightened}}},
          {"references_changed", totals.references_changed},
          {"evaluations",
           {{"before", totals.evaluations_before},
            {"after", totals.evaluations_after},
            {"cases_with_more", totals.evaluations_grown},
            {"cases_with_fewer", totals.evaluations_shrunk}}},
          {"seconds", {{"before", totals.seconds_before}, {"after", totals.seconds_after}}}};
}

template <class T>
Json array_of(const std::vector<T>& values) {
  Json array = Json::array();
  for (const T& value : values)
    array.push_back(to_json(value));
  return array;
}

}  // namespace

std::string json_of(const Comparison& comparison) {
  const Totals totals = totals_of(comparison);
  const bool is_worse = totals.worse() > 0;
  const Json json{{"schema", baseline_schema},
                  {"verdict", is_worse                             ? "worse"
                              : comparison.renaming_errors.empty() ? "not worse"
                                                                   : "wrong renames"},
                  {"tier", name_of(comparison.after.tier)},
                  {"baseline", to_json(comparison.before)},
                  {"results", to_json(comparison.after)},
                  {"allowed", to_json(comparison.allowance)},
                  {"totals", to_json(totals)},
                  {"renaming_errors", comparison.renaming_errors},
                  {"unselected", comparison.unselected},
                  {"cases", array_of(comparison.cases)},
                  {"checks", array_of(comparison.checks)},
                  {"controls", array_of(comparison.controls)}};
  // Paths may not be UTF-8.
  return json.dump(1, ' ', false, Json::error_handler_t::replace) + "\n";
}

}  // namespace talus::verification
