#pragma once

#include <array>

#include "solver/geometry/superquadric.hpp"
#include "verification/check/case.hpp"

/// Parts of the case `superellipse`.
namespace talus::verification::problems {

/// Half axes of the shapes, those of the columns of 1993 [L].
inline constexpr std::array superellipse_half_axes{1.25, 4.0};

/// The shape as the solver is told it, with the setup's fault in it.
[[nodiscard]] Superquadric superellipse_told(double n, const Setup& setup);

/// Overlaps and distances of pairs of outlines, against brute force.
void check_pairs(Findings& findings, const Setup& setup);

/// Pairs that the contact search leaves out, against brute force; scenes with and without the search.
void check_search(Findings& findings, const Setup& setup);
void check_scenes(Findings& findings, const Setup& setup);

}  // namespace talus::verification::problems
