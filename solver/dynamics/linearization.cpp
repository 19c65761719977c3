/// Linearization of a scene about a state: springs and dashpots that act, with respect to the coordinates.

#include <array>
#include <cmath>

#include "solver/dynamics/dynamics.hpp"
#include "solver/dynamics/point_gradient.hpp"

namespace talus {
namespace {

/// A force along one line between two bodies: derivatives of its deformation with respect to the coordinates, and
/// accelerations of the coordinates for a unit force.
class Line {
 public:
  Line(const Dynamics& dynamics, const Workspace& work) : dynamics_{dynamics}, work_{work} {}

  /// Adds a body: motion of its point at p_WP along `direction` increases the deformation, and `weight` times the force
  /// acts on it in the opposite direction.
  void add(BodyId body, Vec2 p_WP, Vec2 direction, double weight) {
    for_each_gradient(dynamics_, work_, body, p_WP, direction, [&](std::size_t coordinate, double gradient) {
      if (gradient != 0.0)
        parts_[count_++] = {coordinate, gradient, weight * gradient / dynamics_.inertias()[coordinate]};
    });
  }

  /// Adds the terms of a force [F] along this line that grows with the deformation of `along` and its rate.
  void respond(const Line& along, double stiffness, double damping, LinearSegment& out) const {
    for (std::size_t i = 0; i < count_; ++i) {
      for (std::size_t j = 0; j < along.count_; ++j) {
        const double each = parts_[i].response * along.parts_[j].gradient;
        out.terms.push_back({parts_[i].coordinate, along.parts_[j].coordinate, each * stiffness, each * damping});
      }
    }
  }
  /// Adds a force along this line that depends on a stretch in the memory.
  void pull(std::size_t memory, double stiffness, LinearSegment& out) const {
    for (std::size_t i = 0; i < count_; ++i)
      out.pulls.push_back({parts_[i].coordinate, memory, parts_[i].response * stiffness});
  }
  /// Adds a memory whose rate is the rate of the deformation.
  void follow(std::size_t memory, LinearSegment& out) const {
    for (std::size_t j = 0; j < count_; ++j)
      out.memory.push_back({memory, parts_[j].coordinate, parts_[j].gradient});
  }

 private:
  struct Part {
    std::size_t coordinate{};
    double gradient{};
    double response{};  ///< acceleration against the gradient for a unit of force
  };
  const Dynamics& dynamics_;
  const Workspace& work_;
  std::array<Part, 6> parts_{};
  std::size_t count_{};
};

}  // namespace

void Dynamics::linearization(const State& state, const Workspace& work, LinearSegment& out) const {
  out.terms.clear();
  out.memory.clear();
  out.pulls.clear();
  contacts_.for_each_acting(state, work, [&](const ContactForces::ActingContact& contact) {
    Line normal{*this, work};
    normal.add(contact.a, contact.p_WC, contact.n_AB, contact.symmetry_weight_a);
    normal.add(contact.b, contact.p_WC, -contact.n_AB, contact.symmetry_weight_b);
    normal.respond(normal, contact.slopes.stiffness, contact.slopes.damping, out);
    if (!contact.friction) return;
    const Vec2 across{-contact.n_AB.y, contact.n_AB.x};
    Line tangential{*this, work};
    tangential.add(contact.b, contact.p_WC, across, contact.symmetry_weight_b);
    tangential.add(contact.a, contact.p_WC, -across, contact.symmetry_weight_a);
    tangential.follow(contact.friction->memory, out);
    if (contact.friction->mode == CoulombFriction::sticking) {
      tangential.respond(tangential, contact.friction->stiffness, contact.friction->dashpot, out);
      tangential.pull(contact.friction->memory, contact.friction->stiffness, out);
    } else {
      const double sign = contact.friction->mode == CoulombFriction::slipping_forward ? 1.0 : -1.0;
      const double mu = sign * contact.friction->coefficient;
      tangential.respond(normal, mu * contact.slopes.stiffness, mu * contact.slopes.damping, out);
    }
  });
  cables_.for_each_taut(state, work, [&](const CableForces::TautCable& cable) {
    Line line{*this, work};
    const auto add = [&](const Joint& joint, std::size_t j, Vec2 direction, double weight) {
      if (joint.on_body) line.add(joint.body, work.joints.p_WP(j), direction, weight);
    };
    const CableForces::Ends ends = cables_.ends()[cable.index];
    const Vec2 pull = work.paths.pull(cable.index);
    add(cables_.joints()[ends.a], ends.a, -pull, cable.symmetry_weight_a);
    add(cables_.joints()[ends.b], ends.b, pull, cable.symmetry_weight_b);
    line.respond(line, cable.slopes.stiffness, cable.slopes.damping, out);
  });
}

}  // namespace talus
