#pragma once

#include <span>

#include "solver/laws/latching_spring.hpp"

/// The latching spring with one mistake each, as codes have been seen to make them.
namespace talus::verification::problems {

/// Forgets the largest overlap where the force falls to zero, not where the discs part: the soft line begins anew in
/// the middle of the overlap, with a force at once.
struct ForgettingLatch : LatchingSpring {
  explicit ForgettingLatch(const LatchingSpring& law) : LatchingSpring{law} {}
  constexpr Reset reset(Kinematics x, std::span<double> memory, Mode mode) const {
    const Reset next = LatchingSpring::reset(x, memory, mode);
    if (next.mode == slack) memory[0] = 0.0;
    return next;
  }
};

/// Takes the contact for ended where the force falls to zero: none comes before the discs have parted.
struct ClearedLatch : LatchingSpring {
  explicit ClearedLatch(const LatchingSpring& law) : LatchingSpring{law} {}
  constexpr Reset reset(Kinematics x, std::span<double> memory, Mode mode) const {
    if (mode == slack && x.extent > 0.0) return {slack, 0.0};
    return LatchingSpring::reset(x, memory, mode);
  }
};

/// Never forgets: discs that have parted meet again where the force left off.
struct RetentiveLatch : LatchingSpring {
  explicit RetentiveLatch(const LatchingSpring& law) : LatchingSpring{law} {}
  constexpr Reset reset(Kinematics x, std::span<double> memory, Mode mode) const {
    const double left_off = memory[0] * (1.0 - stiffness / unloading_stiffness);
    if (mode == slack && x.extent <= left_off) return {slack, 0.0};
    return LatchingSpring::reset(x, memory, mode);
  }
};

}  // namespace talus::verification::problems
