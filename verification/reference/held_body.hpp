#pragma once

#include <functional>
#include <vector>

#include "verification/reference/smooth_motion.hpp"

/// Bodies held by springs that never let go, and motions prescribed to them.
namespace talus::verification::reference {

/// A taut cable from a point of the body to a point of the world.
struct Tie {
  double body_x{}, body_y{};      ///< in the body's own directions, from its centre of mass
  double anchor_x{}, anchor_y{};  ///< in the world
  double rest_length{};
  double stiffness{};
  double damping{};
};

/// A body on taut cables: each pulls with k (l - l0) + c dl/dt along its line.
[[nodiscard]] SmoothSystem body_on_cables(double mass, double inertia, std::vector<Tie> cables);

/// A fixed disc.
struct Post {
  double x{}, y{}, radius{};
};

/// A disc pressed on one or two fixed ones, which it never leaves and on which it never slips.
struct PressedDisc {
  double radius{}, mass{}, inertia{};
  double normal_stiffness{}, slip_stiffness{};
  double weight{};  ///< force along -y
  std::vector<Post> posts;
};

/// With u from the disc's centre to the post's, d the overlap, t = u turned by a quarter counter-clockwise:
///   slip of the post past the disc  z' = -(v.t + w (r - d/2));   force on the disc  -k_n d u + k_s z t,  at (r - d/2)
///   u.
[[nodiscard]] SmoothSystem pressed_disc(const PressedDisc& disc);

/// A sum of swings, and of a steady motion.
struct Wave {
  struct Swing {
    double amplitude{}, frequency{}, phase{};
  };
  double start{}, speed{};
  std::vector<Swing> swings;

  /// The n-th derivative of start + speed t + sum of amplitude sin(frequency t + phase).
  [[nodiscard]] Real derivative(int n, Real t) const;
};

/// A motion prescribed to a body, its memory known in closed form.
struct PrescribedMotion {
  std::array<Wave, 3> coordinates;
  std::function<Memories(Real t)> memory;

  [[nodiscard]] SmoothState at(Real t) const;
};

/// Acceleration that must be added to those of the springs for the body to move as prescribed.
[[nodiscard]] Triple forcing(const SmoothSystem& springs, const PrescribedMotion& motion, Real t);

/// The springs with that forcing.
[[nodiscard]] SmoothSystem forced(const SmoothSystem& springs, const PrescribedMotion& motion);

}  // namespace talus::verification::reference
