#include "solver/io/output/read_history.hpp"

#include <algorithm>
#include <utility>

#include "solver/base/error.hpp"
#include "solver/io/file/quantity_table.hpp"
#include "verification/record/csv.hpp"
#include "verification/record/error.hpp"

namespace talus {

std::string SavedColumn::subject() const {
  const std::size_t dot = name.rfind('.');
  return dot == std::string::npos ? "" : name.substr(0, dot);
}

std::string SavedColumn::quantity() const {
  const std::size_t dot = name.rfind('.');
  return dot == std::string::npos ? name : name.substr(dot + 1);
}

const SavedColumn* KeptHistory::find(const std::string& name) const {
  const auto found =
      std::find_if(columns.begin(), columns.end(), [&](const SavedColumn& each) { return each.name == name; });
  return found == columns.end() ? nullptr : &*found;
}

KeptHistory read_history(const std::filesystem::path& file) {
  KeptHistory history{file, {}};
  try {
    const records::Csv csv = records::read_csv(file);
    for (std::size_t i = 0; i < csv.header().size(); ++i) {
      auto [name, unit] = name_and_unit(csv.header()[i]);
      SavedColumn& each = history.columns.emplace_back(SavedColumn{std::move(name), std::move(unit), {}});
      each.values.reserve(csv.rows());
      for (std::size_t row = 0; row < csv.rows(); ++row)
        each.values.push_back(csv.number(row, i));
    }
  } catch (const records::RecordError& error) {
    throw InputError{error.what()};
  } catch (const records::FileError& error) {
    throw IoError{error.what()};
  }
  return history;
}

}  // namespace talus
