#pragma once

#include "solver/laws/law.hpp"

namespace talus {

/// The kernel of a contact law: its force without its modes. While two bodies are within the law's reach, the force
/// after its mode was updated is one expression of the overlap, its rate and the largest overlap since the contact
/// began; beyond, there is no force and no past.
///
///   force(overlap, rate, largest, out)   for overlap > -reach(law): the force [F], with the bits of update_mode() and
///                                        law(x, memory, mode), and as `largest` the memory that update_mode() leaves.
///                                        `largest` [L] is 0 where the contact begins; a law without memory leaves it
///   needs_rate()                         whether the rate has a part in the force
///   hysteresis_loss(largest)             of laws with memory: what the contact has lost so far [F L]
///   dissipated_power(overlap, rate, before, force, power, released)
///                                        of laws without memory, at an evaluation: the power of the dissipative force
///                                        [F L/T] and what update_mode() releases [F L], from the force now and at the
///                                        evaluation before (< 0: the contact is new, 0: it was there without pushing)
///
/// Number is double, or a pack of them that are evaluated side by side, each as it would be alone. They are passed by
/// reference because compilers pass wide packs in different ways. A test compares the kernel of each law of DiscLaws
/// with its modes, bit by bit.
///
/// This one is the kernel of every OneSided law: a spring and a dashpot side by side,
///
///   F = k overlap + c rate,   clamped: as long as that is positive.
struct OneSidedKernel {
  double stiffness{};  ///< k [F/L]
  double damping{};    ///< c [F T/L]
  bool clamped{};

  constexpr bool needs_rate() const { return damping != 0.0; }
  template <class Number>
  [[gnu::always_inline]] constexpr void force(const Number& overlap, const Number& rate, Number&, Number& out) const {
    out = stiffness * overlap + damping * rate;
    if (clamped) out = out > Number{} ? out : Number{};
  }
  template <class Number>
  [[gnu::always_inline]] constexpr void dissipated_power(const Number& overlap, const Number& rate,
                                                         const Number& before, const Number& force, Number& power,
                                                         Number& released) const {
    power = damping * rate * rate, released = Number{};
    if (!clamped) return;
    const Number none{}, energy = 0.5 * stiffness * overlap * overlap;
    const Number let_go = before == none ? none : energy, taken_back = before == none ? -energy : none;
    power = force > none ? power : none;
    released = force > none ? taken_back : let_go;
  }
};

template <class L>
concept HasContactKernel = IsKernel<L> || OneSided<L>;

/// The kernel of a law: the law itself, if it has one written by hand, else derived from its slopes.
template <Law L>
requires HasContactKernel<L>
constexpr auto contact_kernel(const L& law) {
  if constexpr (IsKernel<L>) {
    return law;
  } else {
    const Tangent slopes = law.linear_part({}, 1);
    return OneSidedKernel{slopes.stiffness, slopes.damping, law.is_clamped()};
  }
}

}  // namespace talus
