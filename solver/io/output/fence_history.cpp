#include "solver/io/output/fence_history.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

#include "solver/base/error.hpp"
#include "solver/io/output/write_history.hpp"

namespace talus {
namespace {

/// Rejects the codes that have no history, all in one error.
void demand_histories(const std::vector<int>& numbers) {
  std::vector<std::string> refused;
  for (const int number : numbers) {
    const FenceCode& code = fence_codes().at(static_cast<std::size_t>(number - 1));
    if (!code.refusal.empty()) refused.push_back(fmt::format("{} ({}): {}", number, code.title, code.refusal));
  }
  if (refused.empty()) return;
  throw InputError{fmt::format("history_codes (variab): found {}; allowed are 3 .. 25, 33 .. 38 and 46 .. 60",
                               fmt::join(refused, "; "))};
}

}  // namespace

FenceHistory::FenceHistory(const scenes::Fence& fence, const scenes::FenceScene& made, const Dynamics& dynamics)
    : fence_{&fence}, made_{&made}, dynamics_{&dynamics} {
  demand_histories(fence.history_codes);
  history_.columns = {{"time", dimension::time}};
  for (const int number : fence.history_elements)
    choose(number);
}

void FenceHistory::choose(int number) {
  std::vector<std::pair<std::string_view, std::vector<int>>> validation_errors;
  for (const int which : fence_->history_codes) {
    const FenceCode& code = fence_codes()[static_cast<std::size_t>(which - 1)];
    const std::string_view why = refusal_reason(number, code);
    if (why.empty()) {
      series_.push_back({number, &code});
      history_.columns.push_back({fmt::format("element{}.{}", number, code.name), code.dimension});
      continue;
    }
    if (validation_errors.empty() || validation_errors.back().first != why) validation_errors.push_back({why, {}});
    validation_errors.back().second.push_back(which);
  }
  for (const auto& [why, codes] : validation_errors) {
    skipped_.push_back(fmt::format("element {}: {} {} skipped: {}", number, codes.size() == 1 ? "code" : "codes",
                                   fmt::join(codes, ", "), why));
  }
}

/// Reason why an element has no such quantity; empty if it has.
std::string_view FenceHistory::refusal_reason(int number, const FenceCode& code) const {
  const scenes::FenceMember& member = made_->members[static_cast<std::size_t>(number - 1)];
  if (!member.body) return "it is a fixed end of the top cable, not a body";
  switch (code.needs) {
    case Needs::body:
      return "";
    case Needs::column:
      return member.layer > 0 ? "" : "it is not a column";
    case Needs::moving:
      return dynamics_->model().bodies[index(*member.body)].mobility == Mobility::free ? "" : "a motion of it is held";
    case Needs::top:
      return member.top ? "" : "no cable begins at it";
    case Needs::bottom:
      return member.bottom ? "" : member.layer > 0 ? "no bottom cable begins at it" : "no cable begins at it";
  }
  return "";
}

const scenes::FenceElement& FenceHistory::element(int number) const {
  const auto rock = static_cast<std::size_t>(number - 2);
  if (number == 1) return fence_->ground;
  return rock < fence_->rocks.size() ? fence_->rocks[rock] : fence_->column;
}

void FenceHistory::operator()(const Snapshot& snapshot, const StepInfo& info) {
  history_.proceed();
  const bool due = info.step % fence_->history_every == 0;
  if (!due && !info.last) return;
  const State& state = snapshot.state();
  const Workspace& work = snapshot.loads();
  std::vector<double> row{state.t};
  for (const Series& series : series_) {
    row.push_back(series.code->value({*dynamics_, state, work, snapshot.forces(), element(series.element),
                                      made_->members[static_cast<std::size_t>(series.element - 1)]}));
  }
  const bool finite = std::all_of(row.begin(), row.end(), [](double value) { return std::isfinite(value); });
  if (finite) history_.add(std::move(row), due || !info.stop);
}

std::string FenceHistory::csv_text() const {
  std::string text;
  for (const std::string& message : skipped_)
    text += fmt::format("# {}\n", message);
  return text + csv(history_, fence_->units);
}

std::string FenceHistory::json_text() const {
  using Json = nlohmann::ordered_json;
  const auto values = [&](std::size_t column) {
    Json list = Json::array();
    for (const std::vector<double>& row : history_.rows)
      list.push_back(row[column]);
    return list;
  };
  Json columns = Json::array();
  columns.push_back({{"name", "time"}, {"unit", symbol(fence_->units, dimension::time)}, {"values", values(0)}});
  for (std::size_t i = 0; i < series_.size(); ++i) {
    const FenceCode& code = *series_[i].code;
    columns.push_back({{"name", history_.columns[i + 1].name},
                       {"element", series_[i].element},
                       {"code", code.number},
                       {"title", code.title},
                       {"unit", symbol(fence_->units, code.dimension)},
                       {"values", values(i + 1)}});
  }
  const Json file{{"schema", 1},
                  {"title", fence_->title},
                  {"units", fence_->units.name},
                  {"skipped", skipped_},
                  {"columns", std::move(columns)}};
  return file.dump(1) + "\n";
}

}  // namespace talus
