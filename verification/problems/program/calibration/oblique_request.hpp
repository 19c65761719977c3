#pragma once

#include <string>
#include <vector>

#include "verification/problems/program/calibration/impact_request.hpp"

/// Requests to `talus calibrate` for oblique impacts and their results by the references; part of the case
/// `oblique_calibrations`.
namespace talus::verification::problems::oblique_calibrations {

using calibrated_laws::ImpactDraw;
using reference::EndRule;

/// An oblique impact of two round bodies, or of one and a plane; SI units. Body 2 is the last one.
struct ObliqueRequest {
  bool mindlin{};  ///< hertz and mindlin, else linear springs
  EndRule rule{};
  double restitution{};
  std::vector<double> masses, radii;
  bool discs{};
  double speed{}, angle{};  ///< [m/s], from the normal [rad]
  double stiffness{};       ///< normal stiffness, or modulus
  double friction{};
  double shear_stiffness{};  ///< or shear modulus
  double shear_damping{};
  std::string sought;  ///< parameter of the friction to be found

  [[nodiscard]] double effective_mass() const;
  [[nodiscard]] double effective_radius() const;
  /// 1 + m r^2/I, the same for any number of bodies of one shape.
  [[nodiscard]] double mobility() const { return discs ? 3.0 : 3.5; }
  [[nodiscard]] double approach_speed() const;
  [[nodiscard]] double slip_speed() const;
  [[nodiscard]] std::string stiffness_name() const { return mindlin ? "shear_modulus" : "shear_stiffness"; }
  /// The parameter of that name.
  [[nodiscard]] double parameter(const std::string& name) const;
  [[nodiscard]] ObliqueRequest with(const std::string& name, double value) const;
};

/// Results of the references, without the effect of the overlap on the arm of friction.
struct ExactRebound {
  double restitution{}, tangential{}, rotational{};
  double angle{};          ///< [rad]
  double spin{};           ///< of body 2 [rad/s]
  double sticking{};       ///< fraction of the contact time
  double contact_time{};   ///< [s]
  double overlap{};        ///< the largest one [m]
  double undamped_time{};  ///< [s]
  double damping{};        ///< dashpot of the normal law
};
[[nodiscard]] ExactRebound exact_of(const ObliqueRequest& request);

/// A request with overlaps of `depth` times the effective radius, approximately; its number chooses laws and the
/// parameter that is sought. The tangential restitution depends on this parameter.
[[nodiscard]] ObliqueRequest drawn_request(ImpactDraw& draw, std::size_t number, double depth);

/// The options of a request without the names of `absent`.
[[nodiscard]] Options options_of(const ObliqueRequest& request, const std::vector<std::string>& absent);

/// Velocities after a run of `talus` of a scene with these lines of the contact.
struct RunRebound {
  double restitution{}, tangential{};
  double spin{};  ///< of body 2 [rad/s], counter-clockwise > 0, where it moves right above body 1
};
[[nodiscard]] RunRebound run_rebound(const Program& program, const ObliqueRequest& request, const std::string& lines,
                                     double step, double contact_time);

}  // namespace talus::verification::problems::oblique_calibrations
