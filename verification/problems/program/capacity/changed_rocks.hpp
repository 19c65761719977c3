#pragma once

#include "verification/study/program/program_options.hpp"

/// Rocks of the runs of a map: sizes, positions and changes; part of the case `fence_capacity`.
namespace talus::verification::problems::fence_capacity {

/// Tilted elongated rocks of other sizes: they start as far in front of that of the base as they reach further, a
/// larger one in its bounding box, a smaller one as an ellipse.
void check_tilted_rocks(const Program& program, Differences& differ);

/// A rock that is higher, turned and spun within the requested changes; text, figures and exit status.
void check_changes(const Program& program, Differences& differ);

/// Spins, and positions along the fence in the full model: a map for each combination, expected rocks between two ends.
void check_positions(const Program& program, Differences& differ);

/// Bases in US units: a deck, and a scene that gives the density, on an inclined ground, with a rock beside mid-span.
void check_us_base(const Program& program, Differences& differ);

}  // namespace talus::verification::problems::fence_capacity
