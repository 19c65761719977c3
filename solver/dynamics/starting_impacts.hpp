#pragma once

#include <array>
#include <cstddef>

#include "solver/dynamics/contact_arrays.hpp"
#include "solver/dynamics/effective_mass.hpp"
#include "solver/dynamics/workspace.hpp"

namespace talus {

/// A contact at the beginning of its impact, whose dashpot depends on the effective mass.
struct StartingImpact {
  const ContactGroup* group{};
  std::size_t instance{};  ///< index of its gap
  double closing{};        ///< u, the closing speed [L/T]
  double mass{};           ///< effective mass p/u, p the impulse that stops it [M]
  bool coupled{};          ///< solved for with the others
};

/// Impacts that begin at the same time.
struct StartingImpacts {
  static constexpr std::size_t capacity = 12;  ///< if there are more, each is treated as if it were alone
  std::array<StartingImpact, capacity> each{};
  std::size_t count{};
};

/// Effective mass of an impact that begins alone [M]; 0 where nothing can move along its normal.
[[nodiscard]] double single_mass(const PointMobility& mobility, const Workspace& work, const StartingImpact& impact);

/// Sets the effective masses of impacts that begin together and so stop each other: A p = u, with A the mobilities
/// between them. An impact that is stopped by the others has the mass of a single impact; if A is singular, each has.
void find_masses(const PointMobility& mobility, const Workspace& work, StartingImpacts& impacts);

}  // namespace talus
