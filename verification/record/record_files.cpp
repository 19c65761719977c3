#include "verification/record/record_files.hpp"

#include "verification/record/figure_points.hpp"
#include "verification/record/results_fields.hpp"
#include "verification/record/whole_file.hpp"

namespace talus::records {
namespace {

/// Messages of foreign exceptions may not be UTF-8: invalid bytes are replaced, so that the record is still written.
std::string dumped(const Json& json) { return json.dump(1, ' ', false, Json::error_handler_t::replace) + "\n"; }

}  // namespace

std::string text_of(const Record& record) { return dumped(json_of(record)); }

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
      read_points(figure, folder, Rows::all);
    for (DataFile& file : record.data)
      file = data_file(file.name, read_csv(folder / (file.name + ".csv")));
    return record;
  } catch (const FileError& fault) {
    throw RecordError(fault.what());  // A file that a record names is part of the record.
  }
}

std::string text_of(const Results& results) { return dumped(json_of(results)); }

Results read_results(const std::filesystem::path& file) {
  const Json document = read_json(file);
  Results results;
  read_into(Node{document, file.string() + ": results"}, results, Completeness::complete);
  return results;
}

}  // namespace talus::records
