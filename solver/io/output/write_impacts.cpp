#include "solver/io/output/write_impacts.hpp"

#include <fmt/format.h>

#include <utility>
#include <vector>

#include "solver/base/dimension.hpp"
#include "solver/io/output/write_history.hpp"
#include "verification/record/csv.hpp"

namespace talus {
namespace {

std::optional<double> if_ended(const RecordedImpact& impact, double value) {
  return impact.ended ? std::optional{value} : std::nullopt;
}

}  // namespace

std::span<const ImpactColumn> impact_columns() {
  using I = RecordedImpact;
  using Value = std::optional<double>;
  static const std::vector<ImpactColumn> columns{
      {{"touch_time", dimension::time}, [](const I& i) -> Value { return i.touch_time; }},
      {{"separation_time", dimension::time}, [](const I& i) { return if_ended(i, i.separation_time); }},
      {{"approach_speed", dimension::velocity}, [](const I& i) -> Value { return i.approach_speed; }},
      {{"separation_speed", dimension::velocity}, [](const I& i) { return if_ended(i, i.separation_speed); }},
      {{"restitution", dimension::number}, [](const I& i) { return i.restitution(); }},
      {{"slip_before", dimension::velocity}, [](const I& i) -> Value { return i.slip_before; }},
      {{"slip_after", dimension::velocity}, [](const I& i) { return if_ended(i, i.slip_after); }},
      {{"peak_force", dimension::force}, [](const I& i) -> Value { return i.peak_force; }},
      {{"peak_force_time", dimension::time}, [](const I& i) -> Value { return i.peak_force_time; }},
      {{"largest_overlap", dimension::length}, [](const I& i) -> Value { return i.largest_overlap; }},
      {{"normal_impulse", dimension::momentum}, [](const I& i) -> Value { return i.normal_impulse; }},
      {{"tangential_impulse", dimension::momentum}, [](const I& i) -> Value { return i.tangential_impulse; }},
      {{"impulse_x", dimension::momentum}, [](const I& i) -> Value { return i.impulse.x; }},
      {{"impulse_y", dimension::momentum}, [](const I& i) -> Value { return i.impulse.y; }}};
  return columns;
}

std::string impacts_csv(const RunRecord& record) {
  const std::span<const ImpactColumn> numbers = impact_columns();
  std::vector<std::string> names{"number", "contact", "body_a", "body_b", "multiplicity", "from_start", "ended"};
  for (const ImpactColumn& of : numbers) {
    const bool pure = of.column.dimension == dimension::number;
    names.push_back(pure ? of.column.name : csv_header(of.column, record.units));
  }
  records::CsvText text{names};
  long number = 0;
  for (const ImpactRecord& row : record.impacts.value()) {
    text.cell(fmt::format("{}", ++number));
    text.cell(row.contact), text.cell(row.body_a), text.cell(row.body_b);
    text.cell(fmt::format("{}", row.multiplicity));
    text.cell(row.impact.from_start ? "1" : "0"), text.cell(row.impact.ended ? "1" : "0");
    for (const ImpactColumn& of : numbers) {
      if (const auto value = of.value(row.impact)) {
        text.number(*value);
      } else {
        text.cell("");
      }
    }
    text.end_row();
  }
  return std::move(text).text();
}

}  // namespace talus
