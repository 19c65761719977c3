#pragma once

#include <string>

#include "verification/study/program/program_options.hpp"

/// A fence whose capacity has a closed form, and questions about it; part of the case `fence_capacity`.
namespace talus::verification::problems::fence_capacity {

/// A cable with a column in its middle, and a rock against it. Both move along x alone.
inline constexpr double half_span = 5.0, area = 1e-4, young = 1e11, strength = 1e5, column_mass = 1.0, own_mass = 200.0,
                        own_radius = 0.3, own_x = 0.51, ground_top = -4.5;

inline constexpr const char* guided = "held = [\"y\", \"rotation\"]\n";

/// The fence. `of_rock`: further fields of the rock; `more`: of [fence.options]. The step is only the interval between
/// samples: cables that turn select a method which chooses its steps. A rock that is stopped turns back within 0.35 s.
[[nodiscard]] std::string fence(const std::string& of_rock, const std::string& more = "");

/// Kinetic energy with which the cable breaks: that of both halves at their strength [J].
[[nodiscard]] double breaking_energy(const Setup& setup);

/// A map of its capacity with this number of cells on a side. `more`: further fields before its tables.
[[nodiscard]] std::string question(int cells, const std::string& more);

}  // namespace talus::verification::problems::fence_capacity
