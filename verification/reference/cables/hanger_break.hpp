#pragma once

/// A mass B between an anchor and a mass C, all on one line, held by two elastic cables that share a hanger on B. C is
/// thrown away from the anchor. The hanger breaks when the difference of the cable tensions reaches its strength, after
/// which the two cables act as one between anchor and C.
///
/// With the displacements b, c from the position where both cables are just taut, T1 = k1 b, T2 = k2 (c - b):
///   m_B b'' = T2 - T1,   m_C c'' = -T2
/// is solved by its two modes. When T2 - T1 = F the massless point between the cables slides into equilibrium: one
/// tension k c with 1/k = 1/k1 + 1/k2, and F^2/(2 (k1 + k2)) is lost. B flies on freely, C oscillates with sqrt(k/m_C).
namespace talus::verification::reference {

struct HungPair {
  double mass_b{}, mass_c{};            ///< [M] > 0
  double stiffness_1{}, stiffness_2{};  ///< anchor to B, B to C [F/L] > 0
  double speed{};                       ///< of C at the start [L/T] > 0
};

struct PairState {
  double b{}, c{};              ///< [L]
  double speed_b{}, speed_c{};  ///< [L/T]
};

/// State while the hanger holds and both cables are taut.
[[nodiscard]] PairState held_pair(const HungPair& pair, double t);

/// Load on the hanger, T2 - T1 [F].
[[nodiscard]] double hanger_load(const HungPair& pair, const PairState& state);

/// First maximum of the load and its time; the cables are still taut then (std::logic_error otherwise).
struct LoadPeak {
  double load{};  ///< [F]
  double time{};  ///< [T]
};
[[nodiscard]] LoadPeak first_load_peak(const HungPair& pair);

/// Break of a hanger with this strength, which must be below the first peak (std::invalid_argument otherwise).
struct HangerBreak {
  double time{};  ///< of the break [T]
  PairState at_break;
  double lost{};              ///< [F L]
  double merged_stiffness{};  ///< [F/L]
  double slack_time{};        ///< when the merged cable goes slack [T]
  double exit_speed_c{};      ///< speed of C at that time, back towards the anchor [L/T] > 0
};
[[nodiscard]] HangerBreak break_hanger(const HungPair& pair, double strength);

/// State from the break until the merged cable is slack.
[[nodiscard]] PairState parted_pair(const HungPair& pair, const HangerBreak& broken, double t);

}  // namespace talus::verification::reference
