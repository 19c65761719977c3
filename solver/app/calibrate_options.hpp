#pragma once

#include <string>
#include <vector>

namespace talus::app {

/// What `talus calibrate` was told.
struct CalibrateOptions {
  std::string scene;
  std::string contact;
  double restitution{};
  std::string law{"linear_spring_dashpot"};
  std::vector<std::string> masses;
  std::string stiffness;
  std::string end_rule{"clamped"};  ///< that of scenes
  std::vector<std::string> pivot;
  std::vector<std::string> offset;
  std::string speed{"1 m/s"};
  std::string step;
  double bound{1e-3};
  std::string integrator{"velocity_verlet"};
  std::string units{"SI"};
  bool json{false};
  std::vector<std::string> own_to_impact;  ///< options given that mean nothing beside a scene
};

/// Inertia at the contact point [kg]: --masses, of which --pivot or --offset changes the last.
/// Errors: InputError naming the option.
[[nodiscard]] double effective_mass_of(const CalibrateOptions& options);

}  // namespace talus::app
