#pragma once

#include <cmath>
#include <vector>

#include "solver/dynamics/rigid_body_system.hpp"
#include "solver/scenes/bouncing_disc.hpp"
#include "verification/study/runs/usage.hpp"

namespace talus::verification::problems {

/// A disc of radius 1 pressed step by step on a plane with a latching spring of K1 = 64, K2 = 256, initially 1/16
/// apart: at each position the force is obtained from the acceleration. All numbers are multiples of powers of two, so
/// that sums and products are exact.
class PressedDisc {
 public:
  /// `forgets`: a fault, the spring is reset wherever it has no force.
  explicit PressedDisc(bool forgets)
      : scene_{scenes::bouncing_disc(
            {.radius = 1.0, .gap = 0.0625, .contact = ContactLaw{LatchingSpring{64.0, 256.0, 0.0}}})},
        dynamics_{scene_.model},
        system_{dynamics_},
        state_{scene_.initial},
        forgets_{forgets} {
    record_use(scene_.model);
    state_.v = {0.0, 0.0};
    look();
  }

  /// Moves the disc from its present overlap to another.
  void press(double to) {
    constexpr double step = 0x1p-10;
    const double direction = to > path_.back() ? 1.0 : -1.0;
    state_.v[1] = -direction;
    for (long count = std::lround(std::abs(to - path_.back()) / step); count > 0; --count) {
      system_.drift(state_, step);
      const double before = forces_.back();
      look();
      work_ += 0.5 * (before + forces_.back()) * direction * step;
    }
  }

  /// Resets the history of the spring, as if the surfaces had separated.
  void forget() {
    state_.mode[0] = LatchingSpring::open;
    state_.z[0] = 0.0;
    look();
  }

  const std::vector<double>& path() const { return path_; }
  const std::vector<double>& forces() const { return forces_; }
  double work() const { return work_; }  ///< input so far

 private:
  void look() {
    Rates rates{state_};
    system_.evaluate(state_, rates);
    if (forgets_ && state_.mode[0] == LatchingSpring::slack) {
      state_.mode[0] = LatchingSpring::open;
      state_.z[0] = 0.0;
    }
    path_.push_back(1.0 - state_.q[1]);
    forces_.push_back(rates.v[1]);
  }

  Scene scene_;
  Dynamics dynamics_;
  RigidBodySystem system_;
  State state_;
  bool forgets_;
  std::vector<double> path_, forces_;
  double work_{};
};

}  // namespace talus::verification::problems
