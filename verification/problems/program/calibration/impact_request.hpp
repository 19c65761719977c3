#pragma once

#include <cstddef>
#include <random>
#include <string>
#include <utility>
#include <vector>

#include "verification/reference/impacts/end_rule.hpp"
#include "verification/study/program/program_options.hpp"

/// Requests to `talus calibrate` and their exact results; part of the case `calibrated_laws`.
namespace talus::verification::problems::calibrated_laws {

/// How body 2 of a pair moves.
enum class Lever {
  none,    ///< it is hit centrally
  offset,  ///< free and hit off centre
  pin,     ///< on a fixed pin beside the line of impact
};

/// The impact of a pair; SI units.
struct ImpactRequest {
  std::string law;
  bool constant{};  ///< the dashpot of hertz
  reference::EndRule rule{};
  double restitution{}, speed{};
  std::vector<double> masses;
  Lever lever{};
  double inertia_ratio{};       ///< of a lever: inertia over mass of body 2 and arm^2
  double stiffness{};           ///< or modulus
  double radius{}, exponent{};  ///< or reference overlap

  [[nodiscard]] bool is_hertz() const { return law == "hertz"; }
  [[nodiscard]] bool is_hunt_crossley() const { return law == "hunt_crossley"; }
  [[nodiscard]] bool varies() const { return constant || is_hunt_crossley(); }
  [[nodiscard]] double effective_mass() const;
  /// Arm of a lever [m], 1e5 times the length of the impact: it hardly changes while the body turns.
  [[nodiscard]] double arm() const { return 1e5 * length(); }
  [[nodiscard]] double inertia() const { return inertia_ratio * masses.back() * arm() * arm(); }
  /// K of the force K x^n, and n.
  [[nodiscard]] std::pair<double, double> spring() const;
  /// Length (m v^2/K)^(1/(n + 1)) of the impact [m].
  [[nodiscard]] double length() const;
  /// Name of the parameter that sets the restitution.
  [[nodiscard]] std::string parameter() const { return is_hunt_crossley() ? "hysteresis" : "damping"; }
};

/// Requests from a fixed seed. The numbers of a standard engine are the same everywhere; those of its distributions are
/// not, so that the bits are scaled here.
class ImpactDraw {
 public:
  double between(double low, double high);
  double decades(double low, double high);
  /// Request of the law with that number, modulo the number of laws.
  ImpactRequest request(std::size_t number);

 private:
  std::mt19937_64 engine_{20261126};
};

/// The same request with a lever for two of three pairs of free bodies.
[[nodiscard]] ImpactRequest with_lever(ImpactRequest request, std::size_t number);

[[nodiscard]] std::string name_of(reference::EndRule rule);

/// The options of the law: its name, parameters and choices.
[[nodiscard]] Options law_options(const ImpactRequest& request);
/// The options of a request without its restitution.
[[nodiscard]] Options options_of(const ImpactRequest& request, double bound);

/// The dashpot for a restitution, contact time and largest overlap, by the references.
struct ExactImpact {
  double damping{}, time{}, overlap{};
};
[[nodiscard]] ExactImpact exact_of(const ImpactRequest& request);

/// Contact time without a dashpot, by the references [s].
[[nodiscard]] double undamped_time(const ImpactRequest& request);

/// Restitution of the pair with another dashpot, by the references; 0 if the contact does not end.
[[nodiscard]] double restitution_with(const ImpactRequest& request, double damping);

/// Velocity of body 2 less that of body 1 [m/s] along the line of impact, after a run of `talus` of a scene of both
/// with these further options. Body 2 turns about a point `arm` [m] below this line.
[[nodiscard]] double separation_of_run(const Program& program, const std::string& file, double arm,
                                       Options options = {});

/// Restitution of a run of `talus` of two bodies, or of one and a wall, with these lines of the contact.
[[nodiscard]] double restitution_of_run(const Program& program, const ImpactRequest& request, const std::string& lines,
                                        double step, const ExactImpact& exact);

}  // namespace talus::verification::problems::calibrated_laws
