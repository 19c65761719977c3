#include "verification/record/case_record.hpp"

#include <algorithm>

#include "verification/record/case_fields.hpp"
#include "verification/record/figure_points.hpp"
#include "verification/record/whole_file.hpp"

namespace talus::records {
namespace {

bool is_main(const Record& record, const Check& check) {
  const auto& names = record.main_checks;
  return std::find(names.begin(), names.end(), check.name) != names.end();
}

}  // namespace

void demand_sound(const Node& node, const Record& record) {
  if (finished(record.status)) {
    static_cast<void>(node.at("title").words());
    static_cast<void>(node.at("page").words());
  }
  demand_distinct_names(node, "checks", record.checks);
  demand_distinct_names(node, "controls", record.controls);
  demand_distinct_names(node, "figures", record.figures);
  demand_distinct_names(node, "tables", record.tables);
  for (const Check& check : record.checks) {
    if (check.main != is_main(record, check)) {
      node.at("checks").complain(fmt::format("check '{}' must {}be marked as main: it is {}in main_checks", check.name,
                                             check.main ? "not " : "", check.main ? "not " : ""));
    }
  }
  if (record.status != Status::pass) return;
  if (record.checks.empty()) node.complain("passes without a check");
  if (std::any_of(record.checks.begin(), record.checks.end(), [](const Check& check) { return !check.pass; }))
    node.complain("passes with a failed check");
  if (std::any_of(record.controls.begin(), record.controls.end(), [](const Control& each) { return !each.pass(); }))
    node.complain("passes with a control that did not turn red");
}

void mark_main_checks(Record& record) {
  for (Check& check : record.checks)
    check.main = is_main(record, check);
}

std::string text_of(const Record& record) {
  // The message of a foreign exception need not be UTF-8: what is not is replaced, so that the record is still written.
  return json_of(record).dump(1, ' ', false, Json::error_handler_t::replace) + "\n";
}

void write_record(const Record& record, const std::filesystem::path& folder) {
  std::filesystem::create_directories(folder);
  for (const Figure& figure : record.figures)
    write_whole(folder / figure.csv, csv_of(figure));
  for (const DataFile& file : record.data)
    write_whole(folder / (file.name + ".csv"), csv_of(file));
  write_whole(folder / "record.json", text_of(record));
}

Record read_record(const std::filesystem::path& folder) {
  try {
    Record record;
    {
      const Json document = read_json(folder / "record.json");
      read_into(Node{document, (folder / "record.json").string() + ": record"}, record, Completeness::complete);
    }
    for (Figure& figure : record.figures)
      read_points(figure, read_csv(folder / figure.csv), Rows::all);
    for (DataFile& file : record.data)
      file = data_file(file.name, read_csv(folder / (file.name + ".csv")));
    return record;
  } catch (const FileError& fault) {
    throw RecordError(fault.what());  // A file that a record names is part of it.
  }
}

}  // namespace talus::records
