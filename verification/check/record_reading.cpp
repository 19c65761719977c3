// Strict reading of records, schema 1: what does not fit is refused with file and field.
#include <cmath>
#include <fstream>
#include <limits>
#include <new>
#include <nlohmann/json.hpp>
#include <system_error>

#include "verification/check/figure_data.hpp"
#include "verification/check/record.hpp"

namespace talus::verification {

namespace {

using Json = nlohmann::ordered_json;

constexpr int schema = 1;

// ----------------------------------------------------------------------------------------------------------

/// The inverse of `number`; null, true, and any other word are refused.
double number(const Json& json, const char* field) {
  const Json& value = json.at(field);
  if (value.is_number()) return value.get<double>();
  if (value == "nan") return std::numeric_limits<double>::quiet_NaN();
  if (value == "inf") return std::numeric_limits<double>::infinity();
  if (value == "-inf") return -std::numeric_limits<double>::infinity();
  throw RecordError(std::string("field '") + field + "' is not a number");
}

double finite(const Json& json, const char* field) {
  const double value = number(json, field);
  if (!std::isfinite(value)) throw RecordError(std::string("field '") + field + "' is not finite");
  return value;
}

bool same(double a, double b) { return a == b || (std::isnan(a) && std::isnan(b)); }

/// What a check says of itself must follow from its numbers.
void demand_consistent(const Check& check) {
  const bool holds = std::isfinite(check.measured) && std::isfinite(check.reference) && std::isfinite(check.error) &&
                     std::isfinite(check.bound) && check.error <= check.bound;
  if (check.pass != holds)
    throw RecordError("check '" + check.name + "': its verdict does not follow from its numbers");
  double error = std::abs(check.measured - check.reference);
  if (check.relative) error /= std::abs(check.reference);
  if (holds && !same(error, check.error)) {
    throw RecordError("check '" + check.name + "': its error does not follow from its numbers");
  }
}

Check check_from(const Json& json) {
  Check check;
  check.name = json.at("name").get<std::string>();
  check.unit = json.at("unit").get<std::string>();
  check.measured = number(json, "measured");
  check.reference = number(json, "reference");
  check.error = number(json, "error");
  check.bound = finite(json, "bound");
  check.margin = number(json, "margin");
  check.relative = json.at("relative").get<bool>();
  check.kind = kind_named(json.at("kind").get<std::string>());
  check.why = json.at("why").get<std::string>();
  check.pass = json.at("pass").get<bool>();
  check.slack = json.at("slack").get<bool>();
  check.order = json.value("order", false);
  check.text_measured = json.value("text_measured", "");
  check.message = json.value("message", "");
  demand_consistent(check);
  return check;
}

Control control_from(const Json& json) {
  Control control;
  control.name = json.at("name").get<std::string>();
  control.what = json.at("what").get<std::string>();
  control.turns_red = json.at("turns_red").get<std::string>();
  control.observed = colour_named(json.at("observed").get<std::string>());
  control.unplanted = colour_named(json.at("unplanted").get<std::string>());
  control.message = json.at("message").get<std::string>();
  if (control.observed != Colour::missing) {
    control.measured = number(json, "measured");
    control.reference = number(json, "reference");
    control.error = number(json, "error");
    control.bound = number(json, "bound");
  }
  if (json.at("pass").get<bool>() != control.pass()) {
    throw RecordError("control '" + control.name + "': its verdict does not follow from its colours");
  }
  return control;
}

Axis axis_from(const Json& json) {
  Axis axis{
      json.at("label").get<std::string>(), json.at("unit").get<std::string>(), json.at("log").get<bool>(), {}, {}};
  if (json.contains("min")) axis.min = finite(json, "min");
  if (json.contains("max")) axis.max = finite(json, "max");
  return axis;
}

std::string contents(const std::filesystem::path& file) {
  std::ifstream in(file, std::ios::binary);
  if (!in) throw RecordError(file.string() + ": is missing");
  // Not through a stream buffer, which takes the end of memory for the end of the file.
  std::error_code none;
  const auto size = std::filesystem::file_size(file, none);
  std::string text(none ? 0 : static_cast<std::size_t>(size), '\0');
  in.read(text.data(), static_cast<std::streamsize>(text.size()));
  text.resize(static_cast<std::size_t>(in.gcount()));
  if (text.empty()) throw RecordError(file.string() + ": is empty");
  return text;
}

Figure figure_from(const Json& json, const std::filesystem::path& folder) {
  Figure figure{json.at("name").get<std::string>(),
                json.at("title").get<std::string>(),
                json.at("caption").get<std::string>(),
                axis_from(json.at("x")),
                axis_from(json.at("y")),
                {},
                {},
                {}};
  std::vector<std::string> keys;
  for (const auto& entry : json.at("series")) {
    figure.series.push_back(
        {entry.at("label").get<std::string>(), {}, {}, style_named(entry.at("style").get<std::string>()), {}, {}});
    figure.series.back().panel = entry.value("panel", 0);
    keys.push_back(entry.at("where").get<std::string>());
  }
  for (const auto& slope : json.at("slopes")) {
    figure.slopes.push_back(
        {finite(slope, "order"), finite(slope, "x"), finite(slope, "y"), slope.at("label").get<std::string>()});
  }
  for (const auto& line : json.at("lines")) {
    figure.lines.push_back(
        {line.at("axis").get<std::string>().at(0), finite(line, "at"), line.at("label").get<std::string>()});
  }
  if (json.contains("panels")) {
    figure.panels = json.at("panels").get<std::vector<std::string>>();
    figure.columns = json.at("columns").get<int>();
  }
  if (json.contains("scale")) {
    const Json& scale = json.at("scale");
    figure.scale = {scale.at("label").get<std::string>(), finite(scale, "min"), finite(scale, "max"),
                    scale.at("unit").get<std::string>()};
  }
  const auto file = folder / json.at("csv").get<std::string>();
  try {
    read_points(contents(file), keys, figure);
  } catch (const std::invalid_argument& fault) {
    throw RecordError(file.string() + ": " + fault.what());
  }
  // The columns y_low, y_high and value are filled for every series of the file; only some of them have bars or values.
  for (std::size_t i = 0; i < keys.size(); ++i) {
    if (!json.at("series").at(i).contains("value")) figure.series[i].values.clear();
    if (json.at("series").at(i).contains("y_low")) continue;
    figure.series[i].y_low.clear();
    figure.series[i].y_high.clear();
  }
  return figure;
}

Record record_from(const Json& json, const std::filesystem::path& folder) {
  if (json.at("schema") != schema) throw RecordError("schema " + json.at("schema").dump() + " is not known; known: 1");
  Record record;
  record.id = json.at("id").get<std::string>();
  record.title = json.at("title").get<std::string>();
  record.family = json.at("family").get<std::string>();
  for (const auto& trace : json.at("traces")) {
    record.requirements.push_back({trace.at("id").get<std::string>(),
                                   trace.at("checks").get<std::vector<std::string>>(),
                                   trace.at("unmatched").get<std::string>()});
  }
  record.main_checks = json.at("main_checks").get<std::vector<std::string>>();
  record.source = json.at("source").get<std::string>();
  record.page = json.at("page").get<std::string>();
  record.tier = tier_named(json.at("tier").get<std::string>());
  record.status = status_named(json.at("status").get<std::string>());
  record.message = json.at("message").get<std::string>();
  record.seconds = finite(json, "seconds");
  record.evaluations = json.at("evaluations").get<std::uint64_t>();
  for (const auto& check : json.at("checks"))
    record.checks.push_back(check_from(check));
  for (const auto& control : json.at("controls"))
    record.controls.push_back(control_from(control));
  for (const auto& figure : json.at("figures"))
    record.figures.push_back(figure_from(figure, folder));
  for (const auto& table : json.at("tables")) {
    record.tables.push_back({table.at("name").get<std::string>(), table.at("caption").get<std::string>(),
                             table.at("columns").get<std::vector<std::string>>(),
                             table.at("rows").get<std::vector<std::vector<std::string>>>()});
  }
  for (const auto& name : json.at("data")) {
    const auto file = folder / (name.get<std::string>() + ".csv");
    record.data.push_back(data_file(name.get<std::string>(), contents(file)));
  }
  record.notes = json.at("notes").get<std::vector<std::string>>();
  return record;
}

}  // namespace

Record read_record(const std::filesystem::path& folder) {
  const auto file = folder / "record.json";
  const std::string text = contents(file);
  try {
    return record_from(Json::parse(text), folder);
  } catch (const nlohmann::json::parse_error& fault) {
    throw RecordError(file.string() + ": truncated or not JSON: " + fault.what());
  } catch (const std::bad_alloc&) {
    throw;  // The record is not at fault.
  } catch (const std::exception& fault) {
    throw RecordError(file.string() + ": " + fault.what());
  }
}

}  // namespace talus::verification
