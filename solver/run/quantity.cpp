#include "solver/run/quantity.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "solver/base/error.hpp"

namespace talus {
namespace {

/// "body.", "contact." or "cable." for each column of a history; empty for time and balance columns.
std::vector<std::string_view> kinds(const Model& model, const std::vector<Column>& columns) {
  std::vector<std::string_view> found{""};
  for (const Body& body : model.bodies) {
    if (body.mobility != Mobility::fixed) found.insert(found.end(), turns(body.mobility) ? 6U : 4U, "body.");
  }
  found.insert(found.end(), 2 * model.contacts.size(), "contact.");
  found.insert(found.end(), 2 * model.cables.size(), "cable.");
  found.resize(columns.size());
  return found;
}

}  // namespace

double Quantity::of(double minimum, double maximum, double last) const {
  switch (reduction) {
    case Reduction::max:
      return maximum;
    case Reduction::min:
      return minimum;
    case Reduction::abs_max:
      return std::max(std::abs(minimum), std::abs(maximum));
    case Reduction::end:
      break;
  }
  return last;
}

Quantity quantity_named(const Model& model, std::string_view name) {
  const std::size_t dot = name.rfind('.');
  if (dot == std::string_view::npos) {
    throw InputError{fmt::format(
        "found \"{}\"; it must be a column of the history and max, min, abs_max or end, e.g. top.tension.max", name)};
  }
  const std::string_view wanted = name.substr(0, dot);
  const std::vector<Column> columns = history_columns(model, true);
  const std::vector<std::string_view> kind = kinds(model, columns);
  static const std::size_t ledger_columns = history_columns({}, true).size() - history_columns({}, false).size();
  const std::size_t without_ledger = columns.size() - ledger_columns;
  std::vector<std::string> known;
  for (std::size_t i = 1; i < columns.size(); ++i) {
    const std::string& column = columns[i].name;
    // Balance errors are omitted: they measure the method and vanish with its error.
    if (column.starts_with("balance_error.")) continue;
    known.push_back(fmt::format("{}{}", kind[i], column));
    if (name == column || name == known.back())
      throw InputError{fmt::format("found \"{0}\"; it must end in .max, .min, .abs_max or .end, e.g. {0}.max", name)};
    if (wanted == column || wanted == known.back()) {
      return {std::string{name}, i, columns[i].dimension, i >= without_ledger,
              value_named<Reduction>("reduction", name.substr(dot + 1))};
    }
  }
  throw unknown_name("column", wanted, known);
}

}  // namespace talus
