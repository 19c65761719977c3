#pragma once

#include <string>
#include <vector>

#include "solver/dynamics/dynamics.hpp"

namespace talus {

/// Two bodies of a contact that overlap at the start.
struct StartOverlap {
  ContactId contact{};
  double overlap{};  ///< [L] > 0; for contacts by nodes that of the outlines, whether or not a node is inside
  double ratio{};    ///< to half the minimum width of the smaller body
};

/// Overlap ratio up to which an overlap at the start is plausible: bodies at rest under gravity, and rocks that touch
/// in a deck of 1993, have less.
inline constexpr double plausible_overlap = 0.01;

/// All contacts whose bodies overlap in a state by more than round-off, largest ratio first.
[[nodiscard]] std::vector<StartOverlap> start_overlaps(const Dynamics& dynamics, const State& state);

/// "contact 'impact' overlaps by 0.012 m at the start, 2.4 % of half the width of its smaller body".
[[nodiscard]] std::string overlap_text(const StartOverlap& overlap, const Model& model);

/// Warning of a run about overlaps that are not plausible, with the largest of them; empty if there are none.
[[nodiscard]] std::string overlap_warning(const std::vector<StartOverlap>& overlaps, const Model& model);

}  // namespace talus
