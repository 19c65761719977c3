#pragma once

/// Kinetic theory of a gas of equal smooth hard discs with restitution e, in closed form. Temperature is energy: T = m
/// <c^2>/2 per disc, c relative to the mean flow. With n discs per area, a Gaussian distribution and uncorrelated discs
/// whose density at contact is chi times n (Enskog):
///   2 sqrt(pi) n d chi sqrt(T/m)                      collisions of a disc per time,
///   (1 - e^2) T                                       energy lost in each collision, shared by two discs,
///   dT/dt = -2 T/tau,  1/tau = (sqrt(pi)/2) (1 - e^2) chi n d sqrt(T/m)      from which follows
///   T = T0/(1 + t/tau0)^2                             (Haff 1983),
///   p = n T [1 + (1 + e) phi chi].
/// tests/verification/reference/many_bodies/gas_of_discs.cpp confirms each line by sums over directions and speeds.
namespace talus::verification::reference {

struct GasOfDiscs {
  double solid_fraction{};  ///< phi in (0, 0.7)
  double restitution{1.0};  ///< e in (0, 1]
  double diameter{1.0};     ///< d [L] > 0
  double mass{1.0};         ///< m [M] > 0
};

/// Radial distribution at contact, chi = (1 - 7 phi/16)/(1 - phi)^2 (Henderson 1975).
[[nodiscard]] double contact_density(double solid_fraction);
/// Number density n = 4 phi/(pi d^2) [1/L^2].
[[nodiscard]] double number_density(const GasOfDiscs& gas);
/// Collision rate of one disc [1/T].
[[nodiscard]] double collision_rate(const GasOfDiscs& gas, double temperature);
/// Cooling rate 1/tau [1/T].
[[nodiscard]] double cooling_rate(const GasOfDiscs& gas, double temperature);
/// Temperature T a time t after it was `first` [F L].
[[nodiscard]] double haff_temperature(const GasOfDiscs& gas, double first, double t);
/// Pressure [F/L].
[[nodiscard]] double pressure(const GasOfDiscs& gas, double temperature);

/// Hard discs equivalent to discs with springs of that stiffness [F/L] at this temperature: the same number, with a
/// diameter reduced by int exp(-k x^2/(2 T)) dx over the overlaps x (Barker & Henderson 1967), sqrt(pi T/(2 k)).
[[nodiscard]] GasOfDiscs hardened(const GasOfDiscs& gas, double temperature, double stiffness);

/// Gas in uniform shear du/dy = `rate` with heating and cooling in balance.
struct SteadyShear {
  double temperature{};  ///< [F L]
  double shear{};        ///< -P_xy [F/L]
  double pressure{};     ///< (P_xx + P_yy)/2 [F/L]
  double difference{};   ///< P_xx - P_yy [F/L]
  double loss{};         ///< energy lost per area and time [F/(L T)]; shear times rate
  double friction() const { return shear / pressure; }
};

/// Viscosity of elastic discs by Enskog's theory, first Sonine approximation [M/T]:
///   eta = eta0 (1/chi + 2 phi + (1 + 8/pi) phi^2 chi),  eta0 = sqrt(m T/pi)/(2 d),
/// as given by Jenkins & Richman 1985 for nearly elastic discs.
[[nodiscard]] double elastic_viscosity(const GasOfDiscs& gas, double temperature);
/// Shear flow with that viscosity, eta rate^2 = 2 n T/tau: the limit e -> 1, in which normal stresses are equal.
[[nodiscard]] SteadyShear newtonian_shear(const GasOfDiscs& gas, double rate);

/// Shear flow from Enskog's equation, closed by a Gaussian distribution whose variances differ with direction (the
/// closure of Jenkins & Richman 1988), without a limit of small shear or small loss. With K = <c c>, and the closing
/// speed q of discs in contact along k, Gaussian of mean -rate d k_x k_y and variance 2 k.K.k:
///   dK/dt + A K + K A^T = n chi d int dk <q H(q) D(c c)>,    A_xy = rate, H Heaviside's step,
///   D(c c) = -(1+e)/2 q (k c + c k) + (1+e)^2/4 q^2 k k,     <c|q> = K.k (q - <q>)/(2 k.K.k),
///   P = n m K + (1+e)/4 m n^2 chi d^2 int dk k k <q^2 H(q)>,
/// integrated in time until it is steady, to 1e-12.
[[nodiscard]] SteadyShear gaussian_shear(const GasOfDiscs& gas, double rate);

}  // namespace talus::verification::reference
