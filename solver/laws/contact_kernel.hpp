#pragma once

#include "solver/laws/law.hpp"

namespace talus {

/// The kernel of a contact law evaluates its force without explicit modes. While two bodies are within the law's reach,
/// the force after the mode update is a single expression of the overlap, its rate and the largest overlap since the
/// contact began; outside the reach the force is zero and the contact has no history.
///
///   force(overlap, rate, largest, out)   for overlap > -reach(law): `out` is the force [F], bit-identical to
///                                        update_mode() followed by law(x, memory, mode); `largest` [L] becomes the
///                                        memory after update_mode(). `largest` is 0 when the contact begins; a law
///                                        without memory does not change it
///   needs_rate()                         whether the force depends on the rate
///   hysteresis_loss(largest)             laws with memory only: energy dissipated by the contact so far [F L]
///   dissipated_power(overlap, rate, before, force, power, released)
///                                        laws without memory only: the power of the dissipative force [F L/T] and the
///                                        energy that update_mode() releases [F L], from the force at this evaluation
///                                        and at the previous one (`before`; < 0: the contact is new, 0: the bodies
///                                        overlapped without force)
///
/// Number is double or a SIMD pack of doubles; each lane gives the bits of the scalar evaluation. Arguments are passed
/// by reference because compilers differ in how they pass wide packs by value. A test compares the kernel of each law
/// of DiscLaws with its modes, bit by bit.
///
/// The kernel of a OneSided law is that of a spring and a dashpot in parallel,
///
///   F = k overlap + c rate,   if clamped: only while this is positive, else 0,
///
/// with constant coefficients (OneSidedKernel) or coefficients that depend on the overlap (SecantKernel).

/// The force of this spring and dashpot [F]; the coefficients are numbers or packs.
template <class Number, class Coefficient>
[[gnu::always_inline]] constexpr void one_sided_force(const Coefficient& stiffness, const Coefficient& damping,
                                                      bool clamped, const Number& overlap, const Number& rate,
                                                      Number& out) {
  out = stiffness * overlap + damping * rate;
  if (clamped) out = out > Number{} ? out : Number{};
}
/// Its dissipated power [F L/T] and released energy [F L]. `stored`: energy of the spring at this overlap [F L], which
/// a clamped contact releases while it does not act.
template <class Number, class Coefficient>
[[gnu::always_inline]] constexpr void one_sided_power(const Coefficient& damping, const Number& stored, bool clamped,
                                                      const Number& rate, const Number& before, const Number& force,
                                                      Number& power, Number& released) {
  power = damping * rate * rate, released = Number{};
  if (!clamped) return;
  const Number none{}, let_go = before == none ? none : stored, taken_back = before == none ? -stored : none;
  power = force > none ? power : none;
  released = force > none ? taken_back : let_go;
}

/// Kernel of a one-sided law with constant coefficients.
struct OneSidedKernel {
  double stiffness{};  ///< k [F/L]
  double damping{};    ///< c [F T/L]
  bool clamped{};

  constexpr bool needs_rate() const { return damping != 0.0; }
  template <class Number>
  [[gnu::always_inline]] constexpr void force(const Number& overlap, const Number& rate, Number&, Number& out) const {
    one_sided_force(stiffness, damping, clamped, overlap, rate, out);
  }
  template <class Number>
  [[gnu::always_inline]] constexpr void dissipated_power(const Number& overlap, const Number& rate,
                                                         const Number& before, const Number& force, Number& power,
                                                         Number& released) const {
    const Number stored = 0.5 * stiffness * overlap * overlap;
    one_sided_power(damping, stored, clamped, rate, before, force, power, released);
  }
};

/// Kernel of a one-sided law whose coefficients depend on the overlap.
template <HasSecant L>
struct SecantKernel {
  L law;

  constexpr bool needs_rate() const { return law.tangent().damping != 0.0; }
  template <class Number>
  [[gnu::always_inline]] constexpr void force(const Number& overlap, const Number& rate, Number&, Number& out) const {
    Number stiffness, damping;
    law.secant(overlap, stiffness, damping);
    one_sided_force(stiffness, damping, law.is_clamped(), overlap, rate, out);
  }
  template <class Number>
  [[gnu::always_inline]] constexpr void dissipated_power(const Number& overlap, const Number& rate,
                                                         const Number& before, const Number& force, Number& power,
                                                         Number& released) const {
    Number stiffness, damping;
    law.secant(overlap, stiffness, damping);
    const Number stored = law.secant_energy_ratio() * (0.5 * stiffness * overlap * overlap);
    one_sided_power(damping, stored, law.is_clamped(), rate, before, force, power, released);
  }
};

template <class L>
concept HasContactKernel = IsKernel<L> || OneSided<L>;

/// The kernel of a law: the law itself if it implements the kernel functions, else derived from its slopes.
template <Law L>
requires HasContactKernel<L>
constexpr auto contact_kernel(const L& law) {
  if constexpr (IsKernel<L>) {
    return law;
  } else if constexpr (HasSecant<L>) {
    return SecantKernel<L>{law};
  } else {
    const Tangent slopes = law.linear_part({}, 1);
    return OneSidedKernel{slopes.stiffness, slopes.damping, law.is_clamped()};
  }
}

}  // namespace talus
