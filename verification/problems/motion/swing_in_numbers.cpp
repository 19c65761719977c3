#include "verification/problems/motion/swing_in_numbers.hpp"

#include <boost/multiprecision/cpp_bin_float.hpp>

#include <stdexcept>

#include "solver/integrate/central_difference.hpp"
#include "solver/integrate/euler_cromer.hpp"
#include "solver/integrate/lagged_central_difference.hpp"
#include "solver/integrate/rk4.hpp"
#include "solver/integrate/velocity_verlet.hpp"
#include "verification/problems/motion/swinging_body.hpp"

namespace talus::verification::problems {
namespace {

using Quadruple = boost::multiprecision::cpp_bin_float_quad;
using reference::SteppedSwing;
using reference::SwingMethod;

/// Each part is what a double keeps of the rest.
template <class Scalar>
reference::Parts parts(Scalar number) {
  reference::Parts made{};
  for (double& part : made) {
    part = static_cast<double>(number);
    number -= static_cast<Scalar>(part);
  }
  return made;
}

template <class Scalar, class Force>
SwingRun swung(auto method, const SteppedSwing& swing) {
  SwingingBody<Scalar, Force> body{static_cast<Scalar>(swing.damping)};
  StateOf<Scalar> state;
  state.q = {Scalar{1}};
  state.v = {Scalar{0}};
  const Scalar h = static_cast<Scalar>(swing.step);
  method.start(body, state, h);
  for (std::int64_t i = 0; i < swing.steps; ++i)
    method.step(body, state, h);
  const StateOf<Scalar> end = method.synchronized(body, state, h);
  return {parts(end.q[0]), static_cast<std::uint64_t>(body.evaluations())};
}

template <class Scalar, class Force>
SwingRun swung(const SteppedSwing& swing) {
  switch (swing.method) {
    case SwingMethod::euler_cromer:
      return swung<Scalar, Force>(EulerCromerOf<StateOf<Scalar>>{}, swing);
    case SwingMethod::central_difference:
      return swung<Scalar, Force>(CentralDifferenceOf<StateOf<Scalar>>{}, swing);
    case SwingMethod::lagged_central_difference:
      return swung<Scalar, Force>(LaggedCentralDifferenceOf<StateOf<Scalar>>{}, swing);
    case SwingMethod::velocity_verlet:
      return swung<Scalar, Force>(VelocityVerletOf<StateOf<Scalar>>{}, swing);
    default:
      return swung<Scalar, Force>(RungeKutta4Of<StateOf<Scalar>>{}, swing);
  }
}

template <class Scalar>
SwingRun swung(const SteppedSwing& swing, Forces forces) {
  if (forces == Forces::in_float) return swung<Scalar, float>(swing);
  if (forces == Forces::in_double) return swung<Scalar, double>(swing);
  return swung<Scalar, Scalar>(swing);
}

}  // namespace

SwingRun swing_in_numbers(const SteppedSwing& swing, int bits, Forces forces) {
  switch (bits) {
    case 24:
      return swung<float, float>(swing);
    case 53:
      return swung<double>(swing, forces);
    case 64:
      return swung<long double>(swing, forces);
    case 113:
      return swung<Quadruple>(swing, forces);
    default:
      throw std::invalid_argument("swing_in_numbers: numbers have 24, 53, 64 or 113 bits");
  }
}

}  // namespace talus::verification::problems
