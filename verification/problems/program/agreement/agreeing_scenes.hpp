#pragma once

#include <array>
#include <limits>
#include <string>
#include <vector>

/// The scenes of the case `agreeing_files`: their texts, and what they say.
namespace talus::verification::problems::agreeing_files {

inline constexpr double infinite = std::numeric_limits<double>::infinity();

/// Units of a scene's results: symbols, and the units of length, force and mass in SI.
struct Units {
  std::string system, length, mass, force, energy, momentum, angular_momentum;
  double metre{}, newton{};
  double kilogram() const { return newton / metre; }
  double joule() const { return newton * metre; }
};
inline const Units si{"SI", "m", "kg", "N", "N m", "N s", "N m s", 1.0, 1.0};
/// International foot and avoirdupois pound, exact by definition (1959), and standard gravity.
inline const Units us{"US", "ft", "slug", "lbf", "lbf ft", "lbf s", "lbf ft s", 0.3048, 0.45359237 * 9.80665};

enum class Shape { none, circle, box, plane };

struct Part {
  std::string name, kind{"body"};
  bool moves{true}, turns{true};
  double mass{}, inertia{};
  Shape shape{};
  double a{}, b{};           ///< half-axes of the shape
  double x{}, y{}, angle{};  ///< where a column of the history does not give them
  double along{};            ///< position along the fence
  int layer{}, number{};
  double multiplicity{1.0};  ///< 2 for a body with a mirror image
  double force_x{}, moment{};
};

/// An end of a cable: a point in the axes of a body, or of the world (body < 0).
struct End {
  int body{-1};
  double x{}, y{}, along{};
};

struct Cable {
  std::string name;
  End from, to;
  double stiffness{}, damping{}, yield{infinite}, strength{infinite}, hardening{};  ///< of the tangent, over k
  double rest{};
  int layer{};
  bool top{};
};

/// What the text of a scene says, in its units.
struct Facts {
  std::string file, title, text, integrator, integrator_step{};
  const Units* units{};
  double gravity{}, step{};  ///< a step of zero: from a rule of fences
  double step_factor{1.0};   ///< multiplies the step of that rule
  int steps{}, steps_a_state{};
  int degrees_of_freedom{};
  int law_instances{};  ///< laws with a mode: springs of contacts, their friction, cables, hangers, columns that sleep
  std::vector<Part> bodies{};
  std::vector<Cable> cables{};
  std::vector<std::string> contacts{};
  std::vector<std::string> hangers{};
  bool mirrored{};
};

/// Three discs on the ground with contacts of three laws, and two cables, in SI. Numbers of the laws:
inline constexpr double low_radius = 0.5, high_radius = 0.4, side_radius = 0.3;
inline constexpr double low_stiffness = 2000.0, low_damping = 8.0, loading = 3000.0, unloading = 5000.0,
                        modulus = 60000.0, hertz_radius = 0.2, yard_friction = 0.4;

[[nodiscard]] Facts yard();

/// Numbers of the fence, in feet and pounds; areas in square inches, Young's modulus in pounds per square inch.
inline constexpr double fence_span = 30.0, sag = 3.0, spacing = 2.5, layer_spacing = 2.6, y_top = 6.67, y_bottom = -4.0,
                        slack = 0.02, young = 20e6, area_top = 1.076, area_bottom = 0.25, limit_top = 20000.0,
                        limit_bottom = 3000.0, strength_top = 23500.0, hanger_strength = 15000.0, hardening = 0.02,
                        ground_top = -4.5, restitution = 0.4, fence_friction = 0.3, layer_overlap = 0.5,
                        rock_overlap = 0.6;
inline constexpr int columns_of_half = 3;

struct Rock {
  double radius, x, y, speed, spin;
};
inline constexpr std::array<Rock, 2> rocks{{{1.201, 2.451, -1.3, -65.0, 34.0}, {1.1, 2.55, 1.3, -50.0, -20.0}}};
inline constexpr double rock_density = 5.13, column_a = 1.25, column_b = 4.0, column_density = 0.76;

/// A fence of two layers with a yielding top cable that breaks, and two rocks, in feet and pounds. A top cable has the
/// largest tension, a bottom cable the largest ratio to its yield force. Stiffness, rest length and step, which follow
/// from other numbers, are zero.
[[nodiscard]] Facts fence();

}  // namespace talus::verification::problems::agreeing_files
