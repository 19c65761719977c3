#include "solver/app/sweep/sweep_base.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <utility>

#include "solver/app/sweep/sweep_runs.hpp"
#include "solver/base/error.hpp"
#include "solver/io/cell/read_cell.hpp"
#include "solver/io/fence1993/read_deck.hpp"
#include "solver/io/fence_file.hpp"
#include "solver/io/scene/write_fence.hpp"

namespace talus::app {
namespace {

std::variant<SweptScene, SweptCell> swept(TomlValue document, std::string name) {
  if (describes_cell(document)) return SweptCell{std::move(document), std::move(name)};
  return SweptScene{std::move(document), std::move(name)};
}

}  // namespace

SweepBase::SweepBase(TomlValue document, std::string name) : swept_{swept(std::move(document), std::move(name))} {}

void SweepBase::choose(std::vector<std::string> outputs, std::string_view where) {
  const auto fault_of = [&](std::vector<std::string> chosen) -> std::string {
    try {
      std::visit([&](auto& of) { of.choose(std::move(chosen)); }, swept_);
    } catch (const InputError& error) {
      return fmt::format("{}: {}", where, error.what());
    }
    return {};
  };
  const std::string fault = fault_of(outputs);
  if (fault.empty()) return;
  // All that are wrong, at once.
  std::vector<std::string> faults;
  for (const std::string& output : outputs)
    if (const std::string alone = fault_of({output}); !alone.empty()) faults.push_back(alone);
  throw InputError{faults.empty() ? fault : fmt::format("{}", fmt::join(faults, "\n"))};
}

const TomlValue& SweepBase::document() const {
  return std::visit([](const auto& of) -> const TomlValue& { return of.document(); }, swept_);
}

const std::vector<SweepOutput>& SweepBase::outputs() const {
  return std::visit([](const auto& of) -> const std::vector<SweepOutput>& { return of.outputs(); }, swept_);
}

const UnitSystem& SweepBase::units() const {
  return std::visit([](const auto& of) -> const UnitSystem& { return of.units(); }, swept_);
}

bool SweepBase::is_fence() const {
  const auto* const scene = std::get_if<SweptScene>(&swept_);
  return scene != nullptr && scene->is_fence();
}

void SweepBase::check_axes(const SweepFile& sweep, const SweptRun& run) const {
  for (std::size_t i = 0; i < sweep.axes.size(); ++i) {
    const SweepAxis& axis = sweep.axes[i];
    SweptRun of_axis;
    for (const auto& parameter : run.parameters)
      if (std::ranges::find(axis.fields, parameter.first) != axis.fields.end()) of_axis.parameters.push_back(parameter);
    try {
      check_fields(document(), of_axis);
    } catch (const InputError& error) {
      throw InputError{fmt::format("{}: {}", sweep.axis_location(i), error.what())};
    }
    if (!axis.continuous || !axis.continuous->whole) continue;
    const std::string& field = axis.fields.front();
    SweptRun changed = run;
    for (auto& [name, value] : changed.parameters)
      if (name == field) value.data = axis.continuous->quantiles.front().second + 0.5;
    try {
      static_cast<void>(end(changed));
    } catch (const InputError&) {
      continue;  // as of a field of whole numbers
    }
    throw InputError{
        fmt::format("{}: range: found whole numbers for '{}', which takes others, too; write them with decimals, "
                    "e.g. [0.0, 1.0], or give `values`",
                    sweep.axis_location(i), field)};
  }
  of_file(sweep.file, [&] { check_fields(document(), run); });
}

double SweepBase::end(const SweptRun& run) const {
  return std::visit([&](const auto& of) { return of.end(run); }, swept_);
}

std::optional<std::size_t> SweepBase::refused_parameter(const SweptRun& run, std::string_view reason) const {
  for (std::size_t i = 0; i < run.parameters.size(); ++i) {
    try {
      static_cast<void>(end({{}, {run.parameters[i]}}));
    } catch (const InputError& alone) {
      if (alone.what() == reason) return i;
    }
  }
  return {};
}

SweepResult SweepBase::result(const SweptRun& run, const SweepLimits& limits,
                              const std::function<bool()>& interrupted) const {
  return std::visit([&](const auto& of) { return of.result(run, limits, interrupted); }, swept_);
}

std::string base_text(const std::filesystem::path& file, std::string_view where) {
  try {
    if (!is_deck(file)) return read_text(file);
    if (describes_cell(file)) {
      throw InputError{file.string() +
                       ": CNTRL.DAT has no units; write the cell as a scene file with [cell] (talus new cell)"};
    }
    return write_fence(read_deck(file));
  } catch (const IoError& error) {
    if (where.empty()) throw;
    throw IoError{fmt::format("{}: {}", where, error.what())};
  }
}

}  // namespace talus::app
