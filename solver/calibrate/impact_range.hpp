#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <vector>

#include "solver/integrate/integrator_list.hpp"
#include "solver/laws/law_list.hpp"

namespace talus {

/// Two bodies that meet: the law of their contact, their effective mass along its normal, and their speed of approach.
struct ImpactingPair {
  ContactLaw law;
  double effective_mass{};  ///< [M]
  double speed{};           ///< [L/T]
};

/// The parameter by which the law of a pair dissipates, `damping` [F T/L] or `hysteresis` [T/L], that gives its impact
/// the restitution e in (0, 1]. Errors: InputError for a law without such a parameter, or e outside its range.
[[nodiscard]] double exact_dissipation(const ImpactingPair& pair, double e);

/// Restitution of a pair with that parameter >= 0; 0 if its contact does not end. Errors: InputError for a law without
/// closed-form impacts (laws/law.hpp).
[[nodiscard]] double restitution_with(const ImpactingPair& pair, double dissipation);

/// Largest deviation max |e_i - e| over the pairs when all have the same parameter. At least one pair.
[[nodiscard]] double largest_deviation(std::span<const ImpactingPair> pairs, double dissipation, double e);

/// The parameter c that all pairs can share with the smallest largest deviation from e (minimax): it minimizes
///
///   D(c) = max |e_i(c) - e| = max(U(c) - e, e - L(c)),     U = max e_i,   L = min e_i   over the pairs.
///
/// Each e_i decreases with c, hence U and L do: U - e decreases, e - L increases, and D is smallest where they are
/// equal, at the root of U(c) + L(c) = 2 e. With c_i the parameter that is exact for pair i, all e_i >= e at the
/// smallest c_i and all e_i <= e at the largest one, so that the root lies between them; it is located by TOMS 748
/// (Alefeld et al. 1995) to about 1e-15 of c. Where contacts that do not end are unavoidable (L = 0), all larger c have
/// the same D = e. `exact`: exact_dissipation() of each pair. The pairs, at least one, have the same law, end rule and
/// dashpot, for which e_i depends on c/c_i alone: U is that of the pair with the largest c_i, L that with the smallest.
[[nodiscard]] double minimax_dissipation(std::span<const ImpactingPair> pairs, std::span<const double> exact, double e);

/// A step for all impacts of a range.
struct RangeStep {
  double step{};           ///< [T]
  double largest_error{};  ///< of the restitution, against the closed form
  std::size_t pair{};      ///< index of the pair that requires it
};

/// Finds a step at which the error of e of all impacts that end is below `bound` when all pairs have the same
/// parameter, for all phases at which surfaces meet and part; none if no contact ends. Pairs are judged in the order of
/// their contact times, from the shortest one on, by CommonStep. A pair is not simulated if
/// one has been accurate that has nearly the same restitution and no more steps in its contact, or a lower restitution
/// and half as many steps: the impacts of a law, in units of their contact time, depend on the restitution alone, and
/// errors of e fall with the damping, or vary by less than 2 where e is below 0.6. The pairs
/// have the same law, end rule and dashpot. Errors: as accurate_step().
[[nodiscard]] std::optional<RangeStep> advise_range_step(std::span<const ImpactingPair> pairs, double dissipation,
                                                         double bound, const Integrator& integrator);

/// Two equal spheres that meet centrally.
struct EqualSpheres {
  double radius{};   ///< r of each [L]
  double density{};  ///< rho [M/L^3]

  double effective_mass() const;    ///< half the mass 4/3 pi rho r^3 of each [M]
  double effective_radius() const;  ///< R of Hertz's law, 1/R = 1/r + 1/r [L]
};

/// `count` >= 2 numbers from `first` to `last`, both > 0, each the same multiple of the one before.
[[nodiscard]] std::vector<double> log_spaced(double first, double last, int count);

}  // namespace talus
