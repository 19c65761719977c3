#pragma once

#include <vector>

/// Oblique impact of a body on a plane by Hertz's law and friction with Mindlin's no-slip stiffness, in scaled numbers:
/// the spring is F = K d^(3/2); lengths are in L = (m v^2/K)^(2/5), times in L/v, forces in m v^2/L. With overlap X,
/// closing speed w, slip rate u, tangential force T and mobility n (1 for a particle, 1 + m r^2/I for a disc),
///
///   w' = -N,  N = X^(3/2) + g X^(1/4) w     until N falls to zero (clamped; g: Tsuji's dashpot, sqrt(5) xi)
///   u' = -n T
///   sticking      T' = k u,                 while approaching,  k = kappa sqrt(X)
///                 T' = k u + T k'/k         while separating (Thornton, Cummins & Cleary 2011: the force is rescaled
///                                           with the stiffness)
///   slipping      T = +-mu N                while the sticking T' would exceed the limit's rate
///
/// The state is the force, not the stretch of a spring as in the solver. With X = y^4 and dt = 4 y^3 ds all right sides
/// are polynomials while approaching. They are integrated in long double by Fehlberg's method of order 8; begin and end
/// of slip, the largest overlap and the end are located by bisection of a step.
namespace talus::verification::reference {

struct MindlinImpact {
  double stiffness_ratio{};  ///< kappa > 0: tangential stiffness over K sqrt(d); 6 G/(E) of Hertz and Mindlin
  double friction{};         ///< mu >= 0
  double mobility{1.0};      ///< n >= 1
  double dashpot{};          ///< g >= 0
  double slip_rate{};        ///< u at touch over v
  double shear_dashpot{};    ///< c >= 0: a contact that sticks also resists by c X^(1/4) u
};

struct MindlinRebound {
  double slip_rate{};     ///< u at the end over v
  double speed_lost{};    ///< friction impulse over m v: tangential speed loss of the centre over v
  double separation{};    ///< speed of separation over v at the end of the clamped contact
  double contact_time{};  ///< in L/v
  struct Phase {
    double begin{};  ///< after touch, in L/v
    int slips{};     ///< 0: sticks; +1, -1: direction of slip
  };
  std::vector<Phase> phases;
};

/// Errors: std::invalid_argument for numbers outside the ranges above; std::runtime_error if stick and slip alternate
/// without end, as a dashpot can make them.
[[nodiscard]] MindlinRebound rebound(const MindlinImpact& impact);

/// Largest u/v at touch for which an undamped contact sticks at first: T and mu N both grow like t^(3/2).
[[nodiscard]] double first_stick_ratio(const MindlinImpact& impact);

}  // namespace talus::verification::reference
