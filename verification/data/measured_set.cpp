#include "verification/data/measured_set.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <system_error>

#include "solver/base/error.hpp"
#include "solver/io/file/quantity_table.hpp"
#include "solver/io/read_scene_file.hpp"
#include "verification/catalogue/catalogue_table.hpp"
#include "verification/data/run_results.hpp"
#include "verification/data/scene_field.hpp"
#include "verification/record/csv.hpp"
#include "verification/record/error.hpp"

namespace talus::verification {

namespace {

namespace fs = std::filesystem;

constexpr std::string_view ending = ".measured.toml";

RowNumbers column(const records::Csv& data, const CatalogueTable& table, std::string_view key,
                  const std::string& heading) {
  const auto& known = data.header();
  const auto found = std::find(known.begin(), known.end(), heading);
  if (found == known.end())
    table.fail(key, unknown_name(fmt::format("column of {}", data.file().string()), heading, known).what());
  RowNumbers numbers;
  try {
    for (std::size_t row = 0; row < data.rows(); ++row)
      numbers.push_back(data.number(row, static_cast<std::size_t>(found - known.begin())));
  } catch (const records::RecordError& wrong) {
    throw InputError{wrong.what()};
  }
  return numbers;
}

/// Uncertainties: one number for all rows, or the heading of a column.
RowNumbers uncertainty(const records::Csv& data, const CatalogueTable& table) {
  constexpr const char* key = "uncertainty";
  if (table.is_text(key)) return column(data, table, key, table.text(key));
  return RowNumbers(data.rows(), table.number(key));
}

MeasuredInput read_input(const CatalogueTable& table, const records::Csv& data, const std::string& scene) {
  MeasuredInput input{
      .column = table.text("column"), .unit = {}, .field = table.text("field"), .values = {}, .uncertainty = {}};
  input.unit = unit_of_heading(input.column);
  input.values = column(data, table, "column", input.column);
  input.uncertainty = table.has("uncertainty") ? uncertainty(data, table) : RowNumbers(data.rows(), 0.0);
  for (const double each : input.uncertainty) {
    if (each < 0.0) table.fail("uncertainty", fmt::format("found {:g}; it must be >= 0", each));
  }
  try {
    static_cast<void>(with_field(scene, input.field, "0.0"));
  } catch (const InputError& wrong) {
    table.fail("field", wrong.what());
  }
  return input;
}

MeasuredQuantity read_quantity(const CatalogueTable& table, const records::Csv& data) {
  MeasuredQuantity quantity{.name = table.text("name"),
                            .column = table.text("column"),
                            .unit = {},
                            .result = table.text("result"),
                            .values = {},
                            .uncertainty = uncertainty(data, table)};
  quantity.unit = unit_of_heading(quantity.column);
  quantity.values = column(data, table, "column", quantity.column);
  quantity.at = table.location_of("result");
  for (const double each : quantity.uncertainty) {
    if (!(each > 0.0)) table.fail("uncertainty", fmt::format("found {:g}; it must be > 0", each));
  }
  if (!table.has("model_error")) return quantity;
  quantity.model_error = table.number("model_error");
  if (quantity.model_error < 0.0)
    table.fail("model_error", fmt::format("found {:g}; it must be >= 0", quantity.model_error));
  return quantity;
}

MeasuredControl read_control(const CatalogueTable& table, const MeasuredSet& set) {
  MeasuredControl control{table.text("name"), table.text("what"), table.text("field"), table.literal("value"),
                          table.text("turns_red")};
  std::vector<std::string> names;
  for (const MeasuredQuantity& quantity : set.quantities)
    names.push_back(quantity.name);
  if (std::find(names.begin(), names.end(), control.turns_red) == names.end())
    table.fail("turns_red", unknown_name("quantity", control.turns_red, names).what());
  for (const MeasuredInput& input : set.inputs) {
    if (input.field == control.field)
      table.fail("field", fmt::format("found '{}', which the column '{}' sets; give another field", control.field,
                                      input.column));
  }
  try {
    static_cast<void>(with_field(set.scene, control.field, control.value));
  } catch (const InputError& wrong) {
    table.fail("field", wrong.what());
  }
  return control;
}

/// The CSV file; errors as those of the other files.
records::Csv read_data(const fs::path& file) {
  try {
    return records::read_csv(file);
  } catch (const records::RecordError& wrong) {
    throw InputError{wrong.what()};
  } catch (const records::FileError& wrong) {
    throw IoError{wrong.what()};
  }
}

}  // namespace

MeasuredSet read_measured_set(const fs::path& file) {
  const CatalogueTable table{
      file,
      {"title", "source", "what", "conclusion", "not_shown", "scene", "data", "axis", "input", "quantity", "control"}};
  MeasuredSet set;
  set.file = file;
  const std::string name = file.filename().string();
  set.id = name.substr(0, name.size() - std::min(name.size(), ending.size()));
  set.title = table.text("title");
  set.source = table.text("source");
  set.what = table.text("what");
  set.conclusion = table.text_or_empty("conclusion");
  set.not_shown = table.text("not_shown");
  if (set.not_shown.back() != '.') set.not_shown += '.';
  const fs::path scene = file.parent_path() / table.text("scene");
  try {
    set.scene = read_text(scene);
    static_cast<void>(parse_toml(set.scene, scene.string()));  // a deck of 1993 has no fields to set
    set.integrator = read_scene_file(scene).scene.integrator;
  } catch (const std::runtime_error& wrong) {
    table.fail("scene", wrong.what());
  }
  const records::Csv data = read_data(file.parent_path() / table.text("data"));
  set.rows = data.rows();
  if (set.rows < 2) table.fail("data", fmt::format("found {} rows; there must be at least two", set.rows));
  for (const CatalogueTable& each : table.tables("input", "input", "column", {"column", "field", "uncertainty"}))
    set.inputs.push_back(read_input(each, data, set.scene));
  if (set.inputs.empty()) table.fail("input", "found an empty array; at least one condition must differ");
  const std::string axis = table.has("axis") ? table.text("axis") : set.inputs.front().column;
  set.axis = {name_and_unit(axis).first, unit_of_heading(axis),
              column(data, table, table.has("axis") ? "axis" : "input", axis)};
  for (const CatalogueTable& each :
       table.tables("quantity", "quantity", "name", {"name", "column", "result", "uncertainty", "model_error"})) {
    set.quantities.push_back(read_quantity(each, data));
    for (std::size_t i = 0; i + 1 < set.quantities.size(); ++i) {
      if (set.quantities[i].name == set.quantities.back().name)
        each.fail("name", fmt::format("found \"{}\" twice; give each name once", set.quantities.back().name));
    }
  }
  if (set.quantities.empty()) table.fail("quantity", "found an empty array; at least one must be compared");
  if (!table.has("control"))
    table.fail("quantity",
               "a [[control]] is missing; give at least one: a comparison that no wrong scene fails shows nothing");
  for (const CatalogueTable& each :
       table.tables("control", "control", "name", {"name", "what", "field", "value", "turns_red"}))
    set.controls.push_back(read_control(each, set));
  return set;
}

std::vector<fs::path> measured_files(const fs::path& folder) {
  std::error_code failure;
  std::vector<fs::path> files;
  for (fs::directory_iterator entry{folder, failure}, end; !failure && entry != end; entry.increment(failure)) {
    if (entry->path().filename().string().ends_with(ending)) files.push_back(entry->path());
  }
  if (failure) throw IoError{fmt::format("{}: {}", folder.string(), failure.message())};
  if (files.empty())
    throw InputError{fmt::format("{}: found no file NAME{}; it must have at least one", folder.string(), ending)};
  std::sort(files.begin(), files.end());
  return files;
}

}  // namespace talus::verification
