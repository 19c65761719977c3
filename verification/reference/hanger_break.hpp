#pragma once

/// A mass B between an anchor and a mass C, all on one line, held by two elastic cables that share a hanger on B. C is
/// thrown away from the anchor; the hanger breaks when the cables' pulls differ by its strength, and the two go on as
/// one between anchor and C.
///
/// With the displacements b, c from the place where both cables are just taut, T1 = k1 b, T2 = k2 (c - b):
///   m_B b'' = T2 - T1,   m_C c'' = -T2
/// is solved by its two modes. When T2 - T1 = F the massless point between the cables slides into balance: one tension
/// k c with 1/k = 1/k1 + 1/k2, and F^2/(2 (k1 + k2)) is lost. B flies on, C swings with sqrt(k/m_C).
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

/// While the hanger holds and both cables are taut.
[[nodiscard]] PairState held_pair(const HungPair& pair, double t);

/// Pull on the hanger, T2 - T1 [F].
[[nodiscard]] double hanger_load(const HungPair& pair, const PairState& state);

/// The first largest load and its time; the cables are still taut then (std::logic_error otherwise).
struct LoadPeak {
  double load{};  ///< [F]
  double time{};  ///< [T]
};
[[nodiscard]] LoadPeak first_load_peak(const HungPair& pair);

/// What a hanger of this strength, below the first peak, does (std::invalid_argument otherwise).
struct HangerBreak {
  double time{};  ///< of the break [T]
  PairState at_break;
  double lost{};              ///< [F L]
  double merged_stiffness{};  ///< [F/L]
  double slack_time{};        ///< when the one cable goes slack [T]
  double exit_speed_c{};      ///< of C then, back towards the anchor [L/T] > 0
};
[[nodiscard]] HangerBreak break_hanger(const HungPair& pair, double strength);

/// From the break until the one cable is slack.
[[nodiscard]] PairState parted_pair(const HungPair& pair, const HangerBreak& broken, double t);

}  // namespace talus::verification::reference
