#include "verification/reference/integration/stepped_swing.hpp"

#include <stdexcept>

#include "verification/reference/mathematics/high_precision.hpp"

namespace talus::verification::reference {
namespace {

/// x, v, and a third variable of the method: the velocity of the previous step, or the acceleration.
using Vector = std::array<Real50, 3>;
using Matrix = std::array<Vector, 3>;  // columns

Vector operator*(const Matrix& matrix, const Vector& vector) {
  Vector product{};
  for (std::size_t column = 0; column < 3; ++column) {
    for (std::size_t row = 0; row < 3; ++row)
      product[row] += matrix[column][row] * vector[column];
  }
  return product;
}

Matrix operator*(const Matrix& a, const Matrix& b) { return {a * b[0], a * b[1], a * b[2]}; }

Vector stepped(SwingMethod method, const Real50& c, const Real50& h, const Vector& now) {
  const auto& [x, v, carried] = now;
  switch (method) {
    case SwingMethod::euler_cromer:
    case SwingMethod::central_difference: {
      const Real50 next = v + h * (-x - c * v);
      return {x + h * next, next, 0};
    }
    case SwingMethod::lagged_central_difference: {
      const Real50 next = v + h * (-x - c * carried);
      return {x + h * next, next, v};
    }
    case SwingMethod::velocity_verlet: {
      const Real50 half = v + h / 2 * carried;
      const Real50 position = x + h * half;
      const Real50 acceleration = -position - c * half;
      return {position, half + h / 2 * acceleration, acceleration};
    }
    case SwingMethod::runge_kutta:
      break;
  }
  // On a linear equation: the first five terms of the exponential of h times its matrix.
  Vector sum = now, term = now;
  for (int k = 1; k <= 4; ++k) {
    term = {h / k * term[1], h / k * (-term[0] - c * term[1]), 0};
    for (std::size_t i = 0; i < 2; ++i)
      sum[i] += term[i];
  }
  return sum;
}

Real50 unrounded(const SteppedSwing& swing) {
  const Real50 c{swing.damping}, h{swing.step};
  Matrix power;
  for (std::size_t i = 0; i < 3; ++i) {
    Vector unit{};
    unit[i] = 1;
    power[i] = stepped(swing.method, c, h, unit);
  }
  // At rest at 1: the half step by which a staggered method starts has no effect.
  Vector end{1, 0, swing.method == SwingMethod::velocity_verlet ? -1 : 0};
  for (std::int64_t left = swing.steps; left > 0; left /= 2) {
    if (left % 2 == 1) end = power * end;
    power = power * power;
  }
  const bool staggered = swing.method == SwingMethod::central_difference ||  //
                         swing.method == SwingMethod::lagged_central_difference;
  return staggered ? end[0] - h / 2 * end[1] : end[0];
}

Real50 whole(const Parts& position) { return Real50{position[0]} + position[1] + position[2]; }

}  // namespace

double unrounded_position(const SteppedSwing& swing) { return nearest(unrounded(swing)); }

std::vector<double> rounding_errors(const SteppedSwing& swing, const std::vector<Parts>& positions) {
  const Real50 exact = unrounded(swing);
  std::vector<double> errors;
  for (const Parts& position : positions)
    errors.push_back(nearest(whole(position) - exact));
  return errors;
}

double whole_error(const SteppedSwing& swing, const Parts& position) {
  if (swing.damping != 0.0) throw std::invalid_argument("whole_error: x = cos t only where nothing damps");
  return nearest(whole(position) - cos(Real50{swing.step} * swing.steps));
}

}  // namespace talus::verification::reference
