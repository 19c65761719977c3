#include "solver/app/sweep/scene_numbers.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <limits>
#include <set>
#include <string_view>

#include "solver/app/sweep/sweep_result.hpp"
#include "solver/base/error.hpp"

namespace talus::app {
namespace {

/// "peak[2]": a name and an index.
struct Indexed {
  std::string_view name;
  std::size_t index{};
};

/// Nothing if it has another form.
std::optional<Indexed> indexed(std::string_view text) {
  const std::size_t open = text.rfind('[');
  if (open == std::string_view::npos || !text.ends_with(']')) return {};
  Indexed found{text.substr(0, open)};
  const char *const first = text.data() + open + 1, *const last = text.data() + text.size() - 1;
  const auto [end, error] = std::from_chars(first, last, found.index);
  if (error != std::errc{} || end != last) return {};
  return found;
}

constexpr std::string_view impact_prefix = "impact.";

/// "impact.floor[0].touch_time": the contact with its index, and the number. Nothing if it has another form, as the
/// force of a contact that is called impact.
std::optional<std::pair<Indexed, std::string_view>> impact_parts(std::string_view name) {
  const std::size_t dot = name.rfind('.');
  if (!name.starts_with(impact_prefix) || dot < impact_prefix.size()) return {};
  const auto of = indexed(name.substr(impact_prefix.size(), dot - impact_prefix.size()));
  if (!of) return {};
  return std::pair{*of, name.substr(dot + 1)};
}

}  // namespace

SceneNumbers::SceneNumbers(const SceneFile& file, const std::vector<std::string>& names) : file_{&file} {
  for (const std::string& name : names)
    add(name);
}

void SceneNumbers::add(const std::string& name) {
  if (file_->fence && name.starts_with("fence.")) return add_fence_output(name);
  if (impact_parts(name)) return add_impact(name);
  if (add_peak(name)) return;
  Quantity quantity;
  try {
    quantity = quantity_named(file_->scene.model, name);
  } catch (const InputError&) {
    for (const Contact& contact : file_->scene.model.contacts) {
      const std::string begin = fmt::format("{}{}", impact_prefix, contact.name);
      if (name == begin || name.starts_with(begin + ".") || name.starts_with(begin + "["))
        throw InputError{
            fmt::format("found \"{}\"; give an impact with its index from 0, and a number of it, e.g. "
                        "{}[0].touch_time",
                        name, begin)};
    }
    throw;
  }
  if (quantity.ledger && !file_->scene.plan.ledger)
    throw InputError{fmt::format("'{}' needs the energy balance, which the scene switches off", name)};
  outputs_.push_back({name, quantity.dimension});
  sources_.emplace_back(quantity);
}

void SceneNumbers::add_fence_output(const std::string& name) {
  std::vector<std::string> known;
  for (const scenes::FenceOutput& output : scenes::fence_outputs()) {
    if (output.name == name) {
      outputs_.push_back({name, output.dimension});
      sources_.emplace_back(output);
      return;
    }
    known.emplace_back(output.name);
  }
  throw unknown_name("number of a fence", name, known);
}

void SceneNumbers::add_impact(const std::string& name) {
  const Model& model = file_->scene.model;
  const auto [of, number] = *impact_parts(name);
  const std::optional<ContactId> contact = find_contact(model, of.name);
  if (!contact) {
    std::vector<std::string> known;
    for (const Contact& each : model.contacts)
      known.push_back(each.name);
    throw unknown_name("contact", of.name, known);
  }
  std::vector<std::string> known;
  for (const ImpactColumn& column : impact_columns()) {
    if (column.column.name == number) {
      outputs_.push_back({name, column.column.dimension});
      sources_.emplace_back(OfImpact{*contact, of.index, &column});
      return;
    }
    known.push_back(column.column.name);
  }
  throw unknown_name("number of an impact", number, known);
}

bool SceneNumbers::add_peak(const std::string& name) {
  const std::size_t dot = name.rfind('.');
  if (dot == std::string::npos) return false;
  const std::string_view reduction = std::string_view{name}.substr(dot + 1);
  if (!reduction.starts_with("peak")) return false;
  const auto of = indexed(reduction);
  if (!of || (of->name != "peak" && of->name != "peak_time")) {
    if (name.starts_with(impact_prefix)) return false;  // an impact without its index
    throw InputError{fmt::format(
        "found \"{}\"; give a local maximum with its index from 0, {}.peak[0], or its time, {}.peak_time[0]", name,
        name.substr(0, dot), name.substr(0, dot))};
  }
  const bool is_time = of->name == "peak_time";
  // As the largest value of this column, for its place and its errors.
  const Quantity quantity = quantity_named(file_->scene.model, name.substr(0, dot) + ".max");
  if (quantity.ledger && !file_->scene.plan.ledger)
    throw InputError{fmt::format("'{}' needs the energy balance, which the scene switches off", name)};
  outputs_.push_back({name, is_time ? dimension::time : quantity.dimension});
  sources_.emplace_back(OfPeak{quantity.column, of->index, is_time, {}});
  return true;
}

std::vector<std::size_t> SceneNumbers::columns() const {
  std::set<std::size_t> found;
  for (const Source& source : sources_) {
    if (const auto* const quantity = std::get_if<Quantity>(&source)) found.insert(quantity->column);
    if (const auto* const peak = std::get_if<OfPeak>(&source)) found.insert(peak->column);
  }
  return {found.begin(), found.end()};
}

scenes::FenceResults SceneNumbers::of_fence() const {
  const bool is_used = std::ranges::any_of(
      sources_, [](const Source& source) { return std::holds_alternative<scenes::FenceOutput>(source); });
  return is_used ? scenes::FenceResults::all : scenes::FenceResults::of_rocks;
}

Observer SceneNumbers::observer(const SceneRun& run) {
  std::vector<OfPeak*> peaks;
  impacts_.reset();
  for (Source& source : sources_) {
    if (auto* const peak = std::get_if<OfPeak>(&source)) {
      peak->log = {};
      peaks.push_back(peak);
    } else if (std::holds_alternative<OfImpact>(source) && !impacts_) {
      impacts_.emplace(run.dynamics());
    }
  }
  if (peaks.empty() && !impacts_) return {};
  return [this, &run, peaks = std::move(peaks)](const Snapshot& seen, const StepInfo& info) {
    if (impacts_) (*impacts_)(seen, info);
    const std::vector<double>& row = run.recorder().row();
    for (OfPeak* const peak : peaks)
      peak->log.add(row.front(), row[peak->column]);
  };
}

std::optional<double> SceneNumbers::value(const Source& source, const SceneRun& run, std::string& reason) const {
  if (const auto* const of_fence = std::get_if<scenes::FenceOutput>(&source)) return of_fence->of(*run.fence());
  if (const auto* const peak = std::get_if<OfPeak>(&source)) {
    const std::vector<Peak>& peaks = peak->log.peaks();
    if (peak->index < peaks.size()) return peak->time ? peaks[peak->index].time : peaks[peak->index].value;
    reason = fmt::format("the run has {} {}", peaks.size(), peaks.size() == 1 ? "maximum" : "maxima");
    return {};
  }
  if (const auto* const of = std::get_if<OfImpact>(&source)) {
    std::size_t number = 0;
    for (const RecordedImpact& impact : impacts_->impacts()) {
      if (impact.contact != of->contact || number++ != of->index) continue;
      const std::optional<double> found = of->column->value(impact);
      if (!found) reason = impact.ended ? "the bodies did not approach" : "the impact has not ended";
      return found;
    }
    reason = fmt::format("the contact has {} {} in the run", number, number == 1 ? "impact" : "impacts");
    return {};
  }
  const auto& quantity = std::get<Quantity>(source);
  const Extreme extreme = run.recorder().extreme(quantity.column);
  return quantity.of(extreme.minimum, extreme.maximum, run.recorder().row()[quantity.column]);
}

std::vector<double> SceneNumbers::values(const SceneRun& run, std::vector<std::string>& reasons) const {
  std::vector<double> values;
  for (std::size_t i = 0; i < sources_.size(); ++i) {
    std::string reason;
    values.push_back(value(sources_[i], run, reason).value_or(std::numeric_limits<double>::quiet_NaN()));
    if (reason.empty() && !std::isfinite(values.back())) reason = "it is not finite";
    if (!reason.empty()) reasons.push_back(no_value(outputs_[i].name, reason));
  }
  return values;
}

}  // namespace talus::app
