#pragma once

#include <concepts>

#include "solver/laws/law_list.hpp"

namespace talus {

/// A contact law whose modes need not be kept: while two bodies overlap, its force after its mode was brought up to
/// date is one expression of the overlap, its rate and the largest overlap since the touch; what is apart has no force
/// and no past.
///
///   settled(overlap, rate, largest, force)   for overlap > 0: the same bits as settle() and law(x, memory, mode), and
///                                            as the memory that settle() leaves (`largest`, untouched by a law
///                                            without memory). `largest` is 0 at the touch. Number is double, or a pack
///                                            of them that are worked out side by side, each as it would be alone; all
///                                            by reference, as compilers hand over wide packs in different ways.
///   needs_rate()                             whether the rate has a part in the force
///   lost(largest)                            of laws that remember: what a contact has lost so far [F L]
///   kept(overlap, rate, before, force, power, released)   of laws without memory, at an evaluation: the power of the
///                                            dissipative force [F L/T], and what settle() released [F L], from the
///                                            force now and at the last evaluation (`before`; < 0: the contact is new)
/// Mode 1 is that of a contact that is pressed.
template <class L>
concept SettledLaw = Law<L> && L::memory_size <= 1 && requires(const L law, double x, double& y) {
  { law.needs_rate() } -> std::same_as<bool>;
  law.settled(x, x, y, y);
  requires(L::memory_size == 1 ? requires { { law.lost(x) } -> std::same_as<double>; }
                               : requires { law.kept(x, x, x, x, y, y); });
};

/// The closed list of laws that discs by the thousand have.
using DiscLaws = LawList<LatchingSpring, LinearSpringDashpot>;
using DiscLaw = DiscLaws::Variant;

}  // namespace talus
