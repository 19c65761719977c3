#pragma once

#include <map>
#include <string>
#include <vector>

#include "verification/check/case.hpp"
#include "verification/record/csv.hpp"

/// Rows of the table of impacts, and its balance of momentum; part of the case `impact_table`.
namespace talus::verification::problems::impact_table {

/// A row of impacts.csv; numbers of empty cells are NaN.
struct Row {
  std::string contact, body_a, body_b;
  std::map<std::string, double> numbers;

  double operator[](const std::string& name) const { return numbers.at(name); }
};

/// The rows of a table.
[[nodiscard]] std::vector<Row> rows_of(const records::Csv& table);

/// Compares impulses with changes of momentum, and the rows of bodies that hop, rest and land flat with closed forms.
void check_yard(Findings& findings, const Setup& setup);

}  // namespace talus::verification::problems::impact_table
