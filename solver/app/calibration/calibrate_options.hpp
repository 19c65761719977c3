#pragma once

#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "solver/draw/drawing.hpp"

namespace talus::app {

/// Options of `talus calibrate`.
struct CalibrateOptions {
  std::string scene;
  std::string contact;
  std::optional<double> restitution;
  std::string law{"linear_spring_dashpot"};
  std::vector<std::string> masses;
  /// Of the laws, by their names in scenes; empty: not given.
  std::map<std::string, std::string> parameters{{"stiffness", ""},         {"modulus", ""},  {"radius", ""},
                                                {"reference_overlap", ""}, {"exponent", ""}, {"damping", ""},
                                                {"hysteresis", ""}};
  std::string end_rule{"clamped"};      ///< default as in scenes
  std::string dashpot{"tsuji"};         ///< default as in scenes
  std::optional<double> poisson_ratio;  ///< of the material of both bodies
  std::vector<std::string> pivot;
  std::vector<std::string> offset;
  std::string speed{"1 m/s"};
  std::string step;
  double bound{1e-3};
  std::string integrator{"velocity_verlet"};
  std::string angle;                        ///< of an oblique impact, from the normal
  std::vector<std::string> angles;          ///< of several: first, last, count
  std::vector<std::string> spheres, discs;  ///< radii of body 1 and body 2, or of body 2
  std::optional<double> tangential_restitution;
  std::string shear_law{"linear"};              ///< default as in scenes
  std::map<std::string, std::string> friction;  ///< parameters of the friction law, by their names in scenes
  std::vector<std::string> speeds;              ///< of a range of pairs: first, last, count
  std::vector<std::string> radii;               ///< of equal spheres: first, last, count
  std::string density;                          ///< of these spheres
  std::string pairs;                            ///< CSV file
  PictureOptions picture;                       ///< its folder receives the table and its drawing
  std::string written_scene;                    ///< file for a scene of the impact
  std::string units{"SI"};
  bool json{false};
  std::vector<std::string> own_to_impact;   ///< given options that a scene replaces
  std::vector<std::string> own_to_range;    ///< given options of a range of pairs
  std::vector<std::string> own_to_oblique;  ///< given options of oblique impacts
};

/// Whether the options give an oblique impact: --angle or --angles.
[[nodiscard]] inline bool gives_oblique(const CalibrateOptions& options) {
  return !options.angle.empty() || !options.angles.empty();
}

/// The restitution of --restitution. Errors: InputError if it is missing.
[[nodiscard]] double demanded_restitution(const CalibrateOptions& options);

/// Errors: InputError if --masses is missing.
void demand_masses(const CalibrateOptions& options);

/// The option of a law's parameter: "--reference-overlap" for reference_overlap.
[[nodiscard]] std::string option_name(std::string_view field);

}  // namespace talus::app
