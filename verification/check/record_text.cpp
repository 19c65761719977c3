// The JSON text of a record, schema 1.
#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

#include "verification/check/figure_data.hpp"
#include "verification/check/record.hpp"

namespace talus::verification {

namespace {

using Json = nlohmann::ordered_json;

constexpr int schema = 1;

// ----------------------------------------------------------------------------------------------------------

/// JSON has no NaN and no infinity: they become words, which no reader takes for a number.
Json number(double value) {
  if (std::isnan(value)) return "nan";
  if (std::isinf(value)) return value > 0.0 ? "inf" : "-inf";
  return value;
}

Json to_json(const Trace& trace) {
  return {{"id", trace.requirement}, {"checks", trace.checks}, {"unmatched", trace.unmatched}};
}

Json to_json(const Check& check) {
  Json json{{"name", check.name},
            {"unit", check.unit},
            {"measured", number(check.measured)},
            {"reference", number(check.reference)},
            {"error", number(check.error)},
            {"bound", number(check.bound)},
            {"margin", number(check.margin)},
            {"relative", check.relative},
            {"kind", name_of(check.kind)},
            {"why", check.why},
            {"pass", check.pass},
            {"slack", check.slack}};
  if (check.order) json["order"] = true;
  if (!check.text_measured.empty()) json["text_measured"] = check.text_measured;
  if (!check.message.empty()) json["message"] = check.message;
  return json;
}

Json to_json(const Control& control) {
  Json json{{"name", control.name},
            {"what", control.what},
            {"turns_red", control.turns_red},
            {"expected", "red"},
            {"observed", name_of(control.observed)},
            {"unplanted", name_of(control.unplanted)},
            {"measured", nullptr},
            {"reference", nullptr},
            {"error", nullptr},
            {"bound", nullptr},
            {"pass", control.pass()},
            {"message", control.message}};
  if (control.observed != Colour::missing) {
    json["measured"] = number(control.measured);
    json["reference"] = number(control.reference);
    json["error"] = number(control.error);
    json["bound"] = number(control.bound);
  }
  return json;
}

Json to_json(const Axis& axis) {
  Json json{{"label", axis.label}, {"unit", axis.unit}, {"log", axis.log}};
  if (axis.min) json["min"] = number(*axis.min);
  if (axis.max) json["max"] = number(*axis.max);
  return json;
}

Json to_json(const Figure& figure) {
  Json json{{"name", figure.name},     {"title", figure.title},   {"caption", figure.caption},
            {"x", to_json(figure.x)},  {"y", to_json(figure.y)},  {"csv", figure.name + ".csv"},
            {"series", Json::array()}, {"slopes", Json::array()}, {"lines", Json::array()}};
  const auto keys = series_keys(figure);
  for (std::size_t i = 0; i < keys.size(); ++i) {
    const Series& series = figure.series[i];
    Json entry{{"label", series.label}, {"x", "x"}, {"y", "y"}, {"style", name_of(series.style)}, {"where", keys[i]}};
    if (!series.y_low.empty()) {
      entry["y_low"] = "y_low";
      entry["y_high"] = "y_high";
    }
    if (!series.values.empty()) entry["value"] = "value";
    if (!figure.panels.empty()) entry["panel"] = series.panel;
    json["series"].push_back(std::move(entry));
  }
  for (const auto& slope : figure.slopes) {
    json["slopes"].push_back(
        {{"order", number(slope.order)}, {"x", number(slope.x)}, {"y", number(slope.y)}, {"label", slope.label}});
  }
  for (const auto& line : figure.lines) {
    json["lines"].push_back({{"axis", std::string(1, line.axis)}, {"at", number(line.at)}, {"label", line.label}});
  }
  if (!figure.panels.empty()) {
    json["panels"] = figure.panels;
    json["columns"] = figure.columns;
  }
  if (figure.scale) {
    const Scale& scale = *figure.scale;
    json["scale"] = {
        {"label", scale.label}, {"unit", scale.unit}, {"min", number(scale.min)}, {"max", number(scale.max)}};
  }
  return json;
}

Json to_json(const Table& table) {
  return {{"name", table.name}, {"caption", table.caption}, {"columns", table.columns}, {"rows", table.rows}};
}

template <class T>
Json array_of(const std::vector<T>& values) {
  Json array = Json::array();
  for (const auto& value : values)
    array.push_back(to_json(value));
  return array;
}

}  // namespace

std::string text_of(const Record& record) {
  Json requirements = Json::array();
  for (const auto& trace : record.requirements)
    requirements.push_back(trace.requirement);
  Json checks = array_of(record.checks);
  for (auto& check : checks) {
    const auto& names = record.main_checks;
    if (std::find(names.begin(), names.end(), check.at("name").get<std::string>()) != names.end()) check["main"] = true;
  }
  Json data = Json::array();
  for (const DataFile& file : record.data)
    data.push_back(file.name);
  const Json json{{"schema", schema},
                  {"id", record.id},
                  {"title", record.title},
                  {"family", record.family},
                  {"requirements", requirements},
                  {"traces", array_of(record.requirements)},
                  {"main_checks", record.main_checks},
                  {"source", record.source},
                  {"page", record.page},
                  {"tier", name_of(record.tier)},
                  {"status", name_of(record.status)},
                  {"message", record.message},
                  {"seconds", number(record.seconds)},
                  {"evaluations", record.evaluations},
                  {"checks", checks},
                  {"controls", array_of(record.controls)},
                  {"figures", array_of(record.figures)},
                  {"tables", array_of(record.tables)},
                  {"data", data},
                  {"notes", record.notes}};
  // Words of a foreign exception need not be UTF-8: what is not is replaced, so that the record is still written.
  return json.dump(1, ' ', false, Json::error_handler_t::replace) + "\n";
}

}  // namespace talus::verification
