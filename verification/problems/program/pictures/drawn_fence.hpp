#pragma once

#include "verification/study/program/program_options.hpp"

/// Pictures of half of a fence; part of the case `picture_options`.
namespace talus::verification::problems::picture_options {

/// Draws the deck of sample 2, whose model is half of a fence: seen along it, all parts have their mirror images, up to
/// both anchors. Columns have the width, the spacing and the numbers of the deck, and the rock, which is in front of
/// the fence, is round and in its middle.
void check_half_fence(const TemporaryFolder& folder, Differences& differ);

}  // namespace talus::verification::problems::picture_options
