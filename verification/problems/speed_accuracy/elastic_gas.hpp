#pragma once

#include <cstdint>

#include "verification/check/case.hpp"

namespace talus::verification::problems {

/// A gas of undamped discs in a box, run by velocity Verlet with w h = eta for its contacts, all of the same w.
struct GasRun {
  double ln_heating{};  ///< of the energy, from the first to the last moment without a contact
  long collisions{};    ///< of discs with discs and with walls
};

/// Discs in that gas.
inline constexpr int gas_discs = 24;

/// Runs discs from random places and velocities until so many collisions have happened; the same seed, the same bits.
/// Fault `gas_by_rk4`: another method.
[[nodiscard]] GasRun run_gas(double eta, std::uint64_t seed, long collisions, const Setup& setup);

}  // namespace talus::verification::problems
