#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <string_view>

#include "solver/base/fields.hpp"
#include "solver/base/pack.hpp"
#include "solver/laws/coulomb_friction.hpp"
#include "solver/laws/kinematics.hpp"

namespace talus {

/// Friction of two spheres in Hertzian contact, with the no-slip stiffness of Mindlin (1949) at the present contact
/// radius a = sqrt(R d), for an overlap d, rescaled as by Thornton, Cummins & Cleary 2011:
///
///   sticking   k_s = 8 G a,   ds/dt = u - s max(dk_s/dt, 0)/k_s,   F = k_s s + c_s (d/R)^(1/4) u
///   slipping, open            as CoulombFriction, with this k_s
///
/// While the bodies approach, the force grows by k_s u: new contact area carries no force yet. While they separate, it
/// shrinks with k_s at a constant stretch: the area that is lost takes its force along. If ds/dt were
/// u - s (dk_s/dt)/k_s while separating too, the force would stay while its stiffness falls, and a closed loop of
/// loading, slip to s, unloading, slip back and loading would create the energy (k_1 - k_2) s^2/2.
///
/// The energy k_s s^2/2 is stored. Its rate is k_s s u - |dk_s/dt| s^2/2: a change of the contact area dissipates
/// energy in both directions.
///
/// The stretch follows from the slip since touch: with constant speeds k_s ~ t^(1/2), and s is two thirds of the slip.
/// Since friction limits |s| to mu N/k_s ~ d, the rate of s is finite where k_s vanishes.
struct Mindlin {
  static constexpr std::string_view name = "mindlin";
  static constexpr std::size_t memory_size = 2;  ///< stretch [L], and k_s at the last update of the modes [F/L]
  static constexpr double onset = 2.0 / 3.0;     ///< stretch at the first evaluation over the slip since touch
  static constexpr std::string_view stiffness_rule = "8 G times the contact radius";

  double coefficient{};  ///< mu >= 0
  double modulus{};      ///< G [F/L^2] > 0: 1/G = (2 - nu_1)/G_1 + (2 - nu_2)/G_2
  double radius{};       ///< R [L] > 0: 1/R = 1/R_1 + 1/R_2
  double damping{};      ///< c_s [F T/L] >= 0: dashpot of sticking friction at an overlap equal to R

  static constexpr std::array<Field<Mindlin>, 4> fields() {
    return {
        {{"friction", dimension::number, &Mindlin::coefficient, Range::non_negative, "coefficient of Coulomb friction"},
         {"shear_modulus", dimension::pressure, &Mindlin::modulus, Range::positive,
          "effective shear modulus, 1/G the sum of (2 - nu)/G of both bodies"},
         {"radius", dimension::length, &Mindlin::radius, Range::positive,
          "effective radius, 1/R the sum of both bodies' curvatures"},
         {"shear_damping", dimension::damping, &Mindlin::damping, Range::non_negative,
          "tangential dashpot of friction that sticks, at an overlap equal to the radius"}}};
  }

  double stiffness(double overlap) const {
    double k{};
    stiffness_at(overlap, k);
    return k;
  }
  /// Spring, dashpot and slider at an overlap [L].
  CoulombFriction at(double overlap) const {
    return {coefficient, stiffness(overlap),
            damping == 0.0 ? 0.0 : damping * std::sqrt(std::sqrt(std::max(overlap, 0.0) / radius))};
  }
  /// The same at an overlap of 0.1 R, beyond which Hertz's theory is not valid.
  CoulombFriction stiffest() const { return at(0.1 * radius); }
  /// ds/dt [L/T] at a slip rate u [L/T].
  double stretch_rate(double stretch, double slip_rate, Kinematics x) const {
    if (!(x.deformation > 0.0 && x.deformation_rate > 0.0)) return slip_rate;
    return slip_rate - stretch * x.deformation_rate / (2.0 * x.deformation);
  }
  double stretch_after(double stretch, double slip_rate, Kinematics x, double h) const {
    double after{};
    move_stretch(stretch, slip_rate, x.deformation, x.deformation_rate, h, after);
    return after;
  }
  double area_power(double stretch, Kinematics x) const {
    double power{};
    area_power(stretch, x.deformation, x.deformation_rate, power);
    return power;
  }

  // The same for a number or a pack of numbers, see HasFrictionKernel.
  template <class Number>
  [[gnu::always_inline]] void stiffness_at(const Number& overlap, Number& k) const {
    const Number none{};
    k = radius * (overlap > none ? overlap : none);
    square_root(k);
    k = 8.0 * modulus * k;
  }
  /// Stretch after the time h of constant slip and closing speeds [L], exact; overlap and its rate: at the middle of
  /// this time. While approaching s sqrt(d) has the rate u sqrt(d), and
  ///   s_1 = s_0 sqrt(d_0/d_1) + 2/3 u h (d_1 + sqrt(d_0 d_1) + d_0)/(d_1 + sqrt(d_0 d_1)).
  template <class Number>
  [[gnu::always_inline]] void move_stretch(const Number& stretch, const Number& slip_rate, const Number& overlap,
                                           const Number& rate, double h, Number& moved) const {
    const Number none{}, half = 0.5 * h * rate, begin = overlap - half, after = overlap + half;
    const Number before = begin > none ? begin : none;
    Number root = before * after, ratio = before / after;
    square_root(root), square_root(ratio);
    const Number grown = stretch * ratio + 2.0 / 3.0 * h * slip_rate * (1.0 + before / (after + root));
    const Number kept = stretch + h * slip_rate;
    moved = rate > none ? grown : kept;
    moved = after > none ? moved : kept;
  }
  /// Power dissipated by the change of the contact area [F L/T].
  template <class Number>
  [[gnu::always_inline]] void area_power(const Number& stretch, const Number& overlap, const Number& rate,
                                         Number& power) const {
    const Number none{};
    Number k;
    stiffness_at(overlap, k);
    power = k * stretch * stretch * (rate < none ? -rate : rate) / (4.0 * overlap);
    power = overlap > none ? power : none;
  }

  friend constexpr bool operator==(const Mindlin&, const Mindlin&) = default;
};

}  // namespace talus
