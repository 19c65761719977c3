#pragma once

#include <span>
#include <vector>

#include "verification/reference/impacts/restitution.hpp"

/// Impact with a latching spring (Walton & Braun, J. Rheology 30 (1986) 949), in closed form.
///
/// With the overlap d and its maximum M since touch, F = K1 d while d = M grows, F = K2 (d - d0) during unloading,
/// d0 = M (1 - K1/K2), K2 = K + S K1 M; F >= 0. With w1 = sqrt(K1/m), w2 = sqrt(K2/m):
/// - Loading is a quarter period: d = (v/w1) sin(w1 t), M = v/w1 at t = pi/(2 w1).
/// - So K2 = K + S K1 v/w1, and F = K1 M there on both branches. Unloading is a quarter period of d - d0 from K1 M/K2
///   to 0: d - d0 = (K1 M/K2) cos(w2 (t - pi/(2 w1))), which ends at t = pi/(2 w1) + pi/(2 w2) with the overlap d0.
/// - The speed there is (K1 M/K2) w2 = v w1/w2: e = w1/w2 = sqrt(K1/K2). (The energy recovered is F^2/(2 K2) of the
///   input F^2/(2 K1).) With K = K1: e = 1/sqrt(1 + S v/w1).
namespace talus::verification::reference {

struct LatchingImpact {
  double loading{};         ///< K1 [F/L] > 0
  double unloading{};       ///< K [F/L] >= K1
  double growth{};          ///< S [1/L] >= 0
  double effective_mass{};  ///< m [M] > 0
  double approach_speed{};  ///< v [L/T] > 0
};

struct LatchingEvents {
  double loading_frequency{};    ///< w1 [rad/T]
  double unloading_frequency{};  ///< w2 [rad/T]
  double restitution{};          ///< e
  double turn_time{};            ///< time of the largest overlap, from touch [T]
  double contact_time{};         ///< until the force falls to zero [T]
  double largest_depth{};        ///< largest overlap M [L]
  double residual_depth{};       ///< overlap d0, where the force falls to zero [L]
};

/// Events of the impact. std::invalid_argument outside the ranges above.
[[nodiscard]] LatchingEvents latching_events(const LatchingImpact& impact);

/// Overlap and its rate at time t >= 0 after touch; after the contact time, motion at the exit speed.
[[nodiscard]] DepthState latching_depth_at(const LatchingImpact& impact, double t);

/// Force at each overlap of a path, from its history alone: M is the largest overlap since the path was last at or
/// below zero, F = max(0, min(K1 d, K2 (d - d0))). Mass and speed are not used. The path must contain its turning
/// points.
[[nodiscard]] std::vector<double> latching_forces(const LatchingImpact& law, std::span<const double> path);

}  // namespace talus::verification::reference
