#include <fmt/format.h>

#include <algorithm>

#include "solver/base/error.hpp"
#include "solver/scenes/fence_summary.hpp"
#include "solver/state/state_memory.hpp"

namespace talus::scenes {
namespace {

/// Errors: InputError where the number in the checkpoint is none of a verdict.
void remember(Memory& memory, std::string_view name, Verdict& verdict) {
  constexpr long count = Names<Verdict>::list.size();
  long number = static_cast<long>(verdict);
  memory.count(name, number);
  if (number >= count) throw InputError{fmt::format("{}: found {}; it must be below {}", name, number, count)};
  verdict = static_cast<Verdict>(number);
}

void remember(Memory& memory, ForceRecord& record) {
  memory.number("peak", record.peak);
  memory.number("peak_time", record.peak_time);
  memory.vector("at_peak", record.at_peak);
  memory.vector("impulse", record.impulse);
}

void remember(Memory& memory, RockPassage& rock) {
  memory.flag("touched", rock.touched);
  memory.number("touch_time", rock.touch_time);
  memory.vector("approach_velocity", rock.approach_velocity);
  memory.number("approach_spin", rock.approach_spin);
  memory.number("approach_energy", rock.approach_energy);
  memory.flag("left", rock.left);
  memory.number("exit_time", rock.exit_time);
  memory.vector("exit_velocity", rock.exit_velocity);
  memory.number("exit_spin", rock.exit_spin);
  memory.number("exit_energy", rock.exit_energy);
  memory.flag("turned", rock.turned);
  memory.number("braking_time", rock.braking_time);
  memory.number("travel", rock.travel);
  remember(memory, "verdict", rock.verdict);
  memory.number("passed_time", rock.passed_time);
  memory.vector("end_velocity", rock.end_velocity);
  memory.number("end_energy", rock.end_energy);
  memory.number("highest", rock.highest);
  memory.number("distance", rock.distance);
}

void remember(Memory& memory, LayerRecord::Height& height) {
  memory.number("start", height.start);
  memory.number("extreme", height.extreme);
  memory.number("extreme_time", height.extreme_time);
  memory.number("end", height.end);
}

/// Each element as a part of its own, by its number.
template <class List, class Visit>
void each(Memory& memory, std::string_view name, List& list, Visit&& visit) {
  for (std::size_t i = 0; i < list.size(); ++i)
    memory.part(fmt::format("{}_{}", name, i), [&] { visit(list[i]); });
}

}  // namespace

void FenceWatch::remember(Memory& memory) {
  FenceSummary& s = summary_;
  const auto force = [&memory](Vec3& value) { memory.vector("force", value); };
  memory.flag("begun", begun_);
  memory.number("time", time_);
  memory.numbers("touch_x", touch_x_);
  memory.numbers("last_tension", last_tension_);
  memory.list("directions", directions_);
  for (std::size_t i = 0; i < crossings_.size(); ++i) {
    each(memory, fmt::format("crossing_{}", i), crossings_[i], [&](Crossing& crossing) {
      memory.flag("beyond", crossing.beyond);
      scenes::remember(memory, "how", crossing.how);
      memory.number("time", crossing.time);
    });
  }
  each(memory, "last_hanger", last_hanger_, force);
  each(memory, "last_anchor", last_anchor_, force);
  each(memory, "rock", s.rocks, [&](RockPassage& rock) { scenes::remember(memory, rock); });
  each(memory, "column", s.columns, [&](ColumnRecord& column) {
    scenes::remember(memory, column.hanger);
    memory.number("travel", column.travel);
    memory.number("travel_time", column.travel_time);
  });
  each(memory, "segment", s.segments, [&](SegmentRecord& segment) {
    memory.number("peak", segment.peak);
    memory.number("peak_time", segment.peak_time);
    memory.number("impulse", segment.impulse);
  });
  each(memory, "anchor", s.anchors, [&](AnchorRecord& anchor) { scenes::remember(memory, anchor.force); });
  each(memory, "layer", s.layers, [&](LayerRecord& layer) {
    memory.part("top", [&] { scenes::remember(memory, layer.top); });
    memory.part("bottom", [&] { scenes::remember(memory, layer.bottom); });
  });
  memory.number("travel", s.travel);
  memory.part("start", [&] { talus::remember(memory, s.start); });
  memory.part("at_travel", [&] { talus::remember(memory, s.at_travel); });
  memory.part("end", [&] { talus::remember(memory, s.end); });
  memory.part("history", [&] { history_.remember(memory); });
}

}  // namespace talus::scenes
