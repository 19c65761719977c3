#pragma once

#include <array>
#include <cstddef>

#include "solver/dynamics/contact_arrays.hpp"
#include "solver/dynamics/effective_mass.hpp"
#include "solver/dynamics/workspace.hpp"

namespace talus {

/// A contact whose dashpot follows from the effective mass, as its impact begins.
struct StartingImpact {
  const ContactGroup* group{};
  std::size_t instance{};  ///< of its gap
  double closing{};        ///< u, the closing speed [L/T]
  double mass{};           ///< effective mass p/u, p the impulse that stops it [M]
  bool coupled{};          ///< solved for with the others
};

/// The impacts that begin at one time.
struct StartingImpacts {
  static constexpr std::size_t most = 12;  ///< of more, each is treated as if it were alone
  std::array<StartingImpact, most> each{};
  std::size_t count{};
};

/// Effective mass of an impact that begins alone [M]; 0 where nothing can move along its normal.
[[nodiscard]] double single_mass(const PointMobility& mobility, const Workspace& work, const StartingImpact& impact);

/// Sets the effective masses of impacts that begin together and so stop each other: A p = u, with A the mobilities
/// between them. An impact that the others stop has the mass of a single impact, and so has each if A is singular.
void find_masses(const PointMobility& mobility, const Workspace& work, StartingImpacts& impacts);

}  // namespace talus
