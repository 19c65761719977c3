#pragma once

#include <array>

#include "solver/geometry/superquadric.hpp"
#include "verification/check/case.hpp"

/// Parts of the case `superellipse`.
namespace talus::verification::problems {

/// Half axes of the shapes, those of the columns of 1993 [L].
inline constexpr std::array superellipse_half_axes{1.25, 4.0};

/// The shape passed to the solver, including the setup's fault.
[[nodiscard]] Superquadric superellipse_of(double n, const Setup& setup);

/// Compares overlaps and distances of pairs of outlines with brute force.
void check_pairs(Findings& findings, const Setup& setup);

/// Compares the pairs that the contact search omits with brute force, and scenes with and without the search.
void check_search(Findings& findings, const Setup& setup);
void check_scenes(Findings& findings, const Setup& setup);

}  // namespace talus::verification::problems
