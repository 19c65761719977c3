#pragma once

#include <functional>
#include <vector>

#include "verification/reference/motion/smooth_motion.hpp"

/// Bodies held by springs that never separate or go slack, and motions prescribed to them.
namespace talus::verification::reference {

/// A taut cable from a point of the body to a point of the world.
struct Tie {
  double body_x{}, body_y{};      ///< in the body frame, from the centre of mass
  double anchor_x{}, anchor_y{};  ///< in the world frame
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

/// A disc pressed against one or two fixed discs, from which it never separates and on which it never slips.
struct PressedDisc {
  double radius{}, mass{}, inertia{};
  double normal_stiffness{}, slip_stiffness{};
  double weight{};  ///< force along -y
  std::vector<Post> posts;
};

/// With u the unit vector from the disc's centre to the post's, d the overlap, t = u turned by a quarter
/// counter-clockwise:
///   slip of the post past the disc  z' = -(v.t + w (r - d/2))
///   force on the disc               -k_n d u + k_s z t,  at (r - d/2) u.
[[nodiscard]] SmoothSystem pressed_disc(const PressedDisc& disc);

/// Sum of sinusoids and a uniform motion.
struct Wave {
  struct Swing {
    double amplitude{}, frequency{}, phase{};
  };
  double start{}, speed{};
  std::vector<Swing> swings;

  /// n-th derivative of start + speed t + sum of amplitude sin(frequency t + phase).
  [[nodiscard]] Real derivative(int n, Real t) const;
};

/// A motion prescribed to a body, with its history variables z known in closed form.
struct PrescribedMotion {
  std::array<Wave, 3> coordinates;
  std::function<Memories(Real t)> memory;

  [[nodiscard]] SmoothState at(Real t) const;
};

/// Acceleration that must be added to that of the springs so that the body moves as prescribed.
[[nodiscard]] Triple forcing(const SmoothSystem& springs, const PrescribedMotion& motion, Real t);

/// The springs together with that forcing.
[[nodiscard]] SmoothSystem forced(const SmoothSystem& springs, const PrescribedMotion& motion);

}  // namespace talus::verification::reference
