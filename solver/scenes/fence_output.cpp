#include "solver/scenes/fence_output.hpp"

#include <array>

namespace talus::scenes {

std::span<const FenceOutput> fence_outputs() {
  static constexpr std::array<FenceOutput, 7> all{
      {{"fence.anchor_force", dimension::force,
        [](const FenceSummary& of) {
          const AnchorRecord* const anchor = of.largest_anchor();
          return anchor ? anchor->force.peak : 0.0;
        }},
       {"fence.cable_force", dimension::force,
        [](const FenceSummary& of) {
          const SegmentRecord* const segment = of.largest_segment();
          return segment ? segment->peak : 0.0;
        }},
       {"fence.hanger_force", dimension::force,
        [](const FenceSummary& of) {
          const ColumnRecord* const column = of.largest_hanger();
          return column ? column->hanger.peak : 0.0;
        }},
       {"fence.cable_margin", dimension::number,
        [](const FenceSummary& of) {
          const SegmentRecord* const segment = of.closest_segment();
          return segment ? segment->margin() : 0.0;
        }},
       {"fence.hanger_margin", dimension::number,
        [](const FenceSummary& of) {
          const ColumnRecord* const column = of.closest_hanger();
          return column ? column->margin() : 0.0;
        }},
       {"fence.travel", dimension::length, [](const FenceSummary& of) { return of.travel; }},
       {"fence.exit_energy", dimension::energy, [](const FenceSummary& of) {
          double sum = 0.0;
          for (const RockPassage& rock : of.rocks)
            sum += rock.touched ? rock.exit_energy : rock.end_energy;
          return sum;
        }}}};
  return all;
}

}  // namespace talus::scenes
