#pragma once

#include <concepts>

#include "solver/laws/coulomb_friction.hpp"

namespace talus {

/// Friction of contacts between discs, for a number or a pack of numbers. Each lane gives the bits of the functions of
/// the friction law, and of the CoulombFriction that it has at an overlap, for one number. Arguments are passed by
/// reference for the reason given in contact_kernel.hpp.
///
///   stiffness_at(d, k)                 sets the stiffness k_s [F/L] at an overlap [L]
///   move_stretch(s, u, d, v, h, out)   sets stretch_after(s, u, {d, v}, h)
///   area_power(s, d, v, out)           sets area_power(s, {d, v})
template <class L>
concept HasFrictionKernel = requires(const L law, double x, double& out) {
  { law.stiffness_at(x, out) } -> std::same_as<void>;
  { law.move_stretch(x, x, x, x, x, out) } -> std::same_as<void>;
  { law.area_power(x, x, x, out) } -> std::same_as<void>;
};

/// Whether the stiffness of a friction law depends on the overlap: its memory then has the stiffness at the last
/// update.
template <class L>
inline constexpr bool has_varying_stiffness = false;
template <class L>
requires requires { L::memory_size; }
inline constexpr bool has_varying_stiffness<L> = L::memory_size > 1;

/// Whether a disc with this friction turns: it is not Frictionless.
template <class F>
inline constexpr bool turns_discs = !std::same_as<F, Frictionless>;

/// Spring and slider of contacts without tangential dashpot, for compressive normal forces: bit-identical to
/// CoulombFriction. Number is double or a SIMD pack of doubles.
template <class Number>
struct SpringSlider {
  double coefficient{};  ///< mu
  Number stiffness{};    ///< k_s of each contact [F/L]

  /// The slip since the touch [L], within the limit.
  [[gnu::always_inline]] constexpr void initial_stretch(const Number& slip, const Number& normal,
                                                        Number& stretch) const {
    const Number limit = coefficient * normal / stiffness, back = -limit;
    stretch = slip < back ? back : slip;
    stretch = limit < stretch ? limit : stretch;
  }
  /// Return mapping of the stretch, followed by the force.
  [[gnu::always_inline]] constexpr void returned_force(const Number& normal, Number& stretch, Number& force) const {
    initial_stretch(Number{stretch}, normal, stretch);
    const Number limit = coefficient * normal, back = -limit;
    force = stiffness * stretch;
    force = force < back ? back : force;
    force = limit < force ? limit : force;
  }
  /// Energy [F L] that the return mapping dissipates as it reduces `stretch` to `left`.
  [[gnu::always_inline]] constexpr void dissipated(const Number& stretch, const Number& normal, const Number& left,
                                                   Number& energy) const {
    const Number none{}, was = stretch < none ? -stretch : stretch, is = left < none ? -left : left;
    const Number slid = coefficient * normal * (was - is), let_go = 0.5 * stiffness * stretch * stretch;
    energy = normal > none ? slid : let_go;
  }
};

}  // namespace talus
