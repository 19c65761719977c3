#pragma once

#include <string>
#include <vector>

#include "solver/scenes/scene.hpp"
#include "verification/check/findings.hpp"

/// Scenes of which case `advice` asks how to integrate them.
namespace talus::verification::problems {

/// What is asked of one scene.
struct Question {
  const char* name;
  Scene scene;
  const char* quantity;
  double accuracy{};
  std::vector<std::string> among;  ///< integrators to choose from; empty: all
  double truth{};                  ///< the quantity
  double doubt{};                  ///< of the truth itself, relative
};

/// Those that were run while the rules of the advice were made: a bob of mass 1 that falls .8 and is caught by its
/// cable (k 500, g 9.81, five seconds), and a disc that meets a plane obliquely, with friction (case `friction`).
[[nodiscard]] Question caught_bob(double accuracy, std::vector<std::string> among);
[[nodiscard]] Question oblique_impact(double accuracy, std::vector<std::string> among);

/// Those that were run first when the rules stood: a ball by Hertz's law (4/3 E sqrt(R) = 1, m = 1, v = 1), a latching
/// spring (K1 = 1, K2 = 4), and the rock of Table 3's fence to .05 s, of which the truth is that of the central
/// difference at 4e-7 and 2e-7 s, extrapolated; `findings` counts what those take.
[[nodiscard]] Question hertz_impact(double accuracy);
[[nodiscard]] Question latched_impact(double accuracy, std::vector<std::string> among);
[[nodiscard]] Question fence_impact(double accuracy, Findings& findings);

/// Five discs in a square box of width 4, without friction or loss, to a time. Nobody knows where they are then.
[[nodiscard]] Question gas(double end, double accuracy);

}  // namespace talus::verification::problems
