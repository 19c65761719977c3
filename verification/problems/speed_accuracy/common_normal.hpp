#pragma once

#include "solver/geometry/pose.hpp"
#include "solver/geometry/superquadric.hpp"

/// How superquadrics in contact are often treated: the point between them where both outlines' functions are equal and
/// their gradients opposite, by Newton's method. A counter-example: the solver asks for nearest points.
namespace talus::verification::problems {

/// Whether plain Newton steps on f_A(X) = f_B(X), grad f_A + mu^2 grad f_B = 0 in X and mu converge within a hundred,
/// from the middle of the centres, with the radial function f = (|x/a|^n + |y/b|^n)^(1/n).
[[nodiscard]] bool newton_converges(const Superquadric& a, const Pose& A, const Superquadric& b, const Pose& B);

}  // namespace talus::verification::problems
