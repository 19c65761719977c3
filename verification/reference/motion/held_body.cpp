#include "verification/reference/motion/held_body.hpp"

#include <cmath>
#include <utility>

namespace talus::verification::reference {
namespace {

/// Relative position of the disc and one post.
struct Touch {
  Real ux, uy;   ///< from the disc's centre to the post's
  Real overlap;  ///< d
  Real arm;      ///< r - d/2
};

Touch touch(const PressedDisc& disc, const Post& post, const Triple& q) {
  const Real x = post.x - q[0], y = post.y - q[1], apart = std::hypot(x, y);
  const Real overlap = disc.radius + post.radius - apart;
  return {x / apart, y / apart, overlap, disc.radius - 0.5L * overlap};
}

}  // namespace

SmoothSystem body_on_cables(double mass, double inertia, std::vector<Tie> cables) {
  SmoothSystem system;
  for (const Tie& tie : cables)
    system.damped = system.damped || tie.damping != 0.0;
  system.slip = [](const Triple&, const Triple&) { return Memories{}; };
  system.acceleration = [=](const SmoothState& x, Real) {
    const Real c = std::cos(x.q[2]), s = std::sin(x.q[2]);
    Triple force{};
    for (const Tie& tie : cables) {
      const Real rx = c * tie.body_x - s * tie.body_y, ry = s * tie.body_x + c * tie.body_y;
      const Real lx = tie.anchor_x - x.q[0] - rx, ly = tie.anchor_y - x.q[1] - ry, length = std::hypot(lx, ly);
      const Real px = x.v[0] - x.v[2] * ry, py = x.v[1] + x.v[2] * rx;
      const Real lengthening = -(lx * px + ly * py) / length;
      const Real tension = tie.stiffness * (length - tie.rest_length) + tie.damping * lengthening;
      const Real fx = tension * lx / length, fy = tension * ly / length;
      force[0] += fx, force[1] += fy, force[2] += rx * fy - ry * fx;
    }
    return Triple{force[0] / mass, force[1] / mass, force[2] / inertia};
  };
  return system;
}

SmoothSystem pressed_disc(const PressedDisc& disc) {
  SmoothSystem system;
  system.acceleration = [disc](const SmoothState& x, Real) {
    Triple force{0.0L, -disc.weight, 0.0L};
    for (std::size_t i = 0; i < disc.posts.size(); ++i) {
      const Touch at = touch(disc, disc.posts[i], x.q);
      const Real normal = disc.normal_stiffness * at.overlap, drag = disc.slip_stiffness * x.z[i];
      force[0] += -normal * at.ux - drag * at.uy;
      force[1] += -normal * at.uy + drag * at.ux;
      force[2] += at.arm * drag;
    }
    return Triple{force[0] / disc.mass, force[1] / disc.mass, force[2] / disc.inertia};
  };
  system.slip = [disc](const Triple& q, const Triple& v) {
    Memories out{};
    for (std::size_t i = 0; i < disc.posts.size(); ++i) {
      const Touch at = touch(disc, disc.posts[i], q);
      out[i] = v[0] * at.uy - v[1] * at.ux - v[2] * at.arm;
    }
    return out;
  };
  return system;
}

Real Wave::derivative(int n, Real t) const {
  Real sum = n == 0 ? start + speed * t : n == 1 ? static_cast<Real>(speed) : 0.0L;
  for (const Swing& swing : swings) {
    Real part = swing.amplitude;
    for (int i = 0; i < n; ++i)
      part *= swing.frequency;
    const Real angle = static_cast<Real>(swing.frequency) * t + swing.phase;
    const Real turned = n % 2 == 0 ? std::sin(angle) : std::cos(angle);
    sum += n % 4 < 2 ? part * turned : -part * turned;
  }
  return sum;
}

SmoothState PrescribedMotion::at(Real t) const {
  SmoothState x;
  for (std::size_t i = 0; i < 3; ++i) {
    x.q[i] = coordinates[i].derivative(0, t);
    x.v[i] = coordinates[i].derivative(1, t);
  }
  if (memory) x.z = memory(t);
  return x;
}

Triple forcing(const SmoothSystem& springs, const PrescribedMotion& motion, Real t) {
  const Triple own = springs.acceleration(motion.at(t), t);
  Triple out{};
  for (std::size_t i = 0; i < 3; ++i)
    out[i] = motion.coordinates[i].derivative(2, t) - own[i];
  return out;
}

SmoothSystem forced(const SmoothSystem& springs, const PrescribedMotion& motion) {
  SmoothSystem system = springs;
  system.acceleration = [=](const SmoothState& x, Real t) {
    Triple out = springs.acceleration(x, t);
    const Triple extra = forcing(springs, motion, t);
    for (std::size_t i = 0; i < 3; ++i)
      out[i] += extra[i];
    return out;
  };
  return system;
}

}  // namespace talus::verification::reference
