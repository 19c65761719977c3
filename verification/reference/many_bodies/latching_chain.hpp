#pragma once

#include <span>
#include <vector>

/// Equal discs on a line with latching springs between neighbours (Walton & Braun, J. Rheology 30 (1986) 949).
///
/// With d the overlap of two neighbours and M its maximum since they touched, a contact is on one of four branches:
///
///   open       F = 0                       until d = 0, then loading with M = 0
///   loading    F = K1 d                    until d' = 0, then unloading with M = d
///   unloading  F = K1 M - K2 (M - d)       until d = M, then loading; or F = 0 at d0 = M (1 - K1/K2), then slack
///   slack      F = 0                       until d = d0, then unloading; or d = 0, then open: M is reset
///
/// Between changes of branch the motion is that of linear springs. It is integrated with a tight tolerance (Trajectory:
/// odeint in long double) from change to change; each change is located to round-off, and the next branch follows from
/// the table. Energy: a contact that loaded up to M and has separated has dissipated K1 M^2 (1 - K1/K2)/2, regardless
/// of its history in between.
namespace talus::verification::reference {

struct LatchingChain {
  double loading{};              ///< K1 [F/L] > 0
  double unloading{};            ///< K2 [F/L] >= K1
  double mass{};                 ///< m of each disc [M] > 0
  std::vector<double> velocity;  ///< of the discs from left to right at t = 0 [L/T]; at least two
  std::vector<double> gap;       ///< between neighbours at t = 0 [L] >= 0; one fewer
};

/// `count` discs from left to right, all in contact, the first thrown against the others, which are at rest.
[[nodiscard]] LatchingChain struck_chain(std::size_t count, double ratio, double mass, double loading, double speed);

/// Outcome when no force remains and no further contact will occur.
struct ChainRebound {
  std::vector<double> velocity;  ///< final velocities of the discs [L/T]
  std::vector<double> largest;   ///< largest overlap of each contact [L]
  double kept{};                 ///< energy dissipated by all contacts [F L]
  double end_time{};             ///< when the last force vanished [T]
  int reloads{};                 ///< number of times a contact was loaded again before separation
  int reloads_from_slack{};      ///< number of these in which its force had been zero
};

/// Rebound of the chain. std::invalid_argument outside the ranges above.
[[nodiscard]] ChainRebound chain_rebound(const LatchingChain& chain);

/// Velocities of the discs at ascending times >= 0, one vector for each time.
[[nodiscard]] std::vector<std::vector<double>> chain_velocities(const LatchingChain& chain,
                                                                std::span<const double> times);

}  // namespace talus::verification::reference
