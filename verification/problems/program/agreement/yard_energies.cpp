#include "verification/problems/program/agreement/yard_energies.hpp"

#include <algorithm>
#include <cmath>

namespace talus::verification::problems::agreeing_files {
namespace {

/// Velocity of a body: of its centre and its angle.
struct Motion {
  double x{}, y{}, angle{};
};

/// The motion of a body in a row: as written, or of the half step before it, with which the laws are evaluated.
Motion written(const Run& run, const Part& body, std::size_t row) {
  return {run.of(body, ".vx", row, 0.0), run.of(body, ".vy", row, 0.0), run.of(body, ".spin", row, 0.0)};
}
Motion evaluated(const Run& run, const Part& body, std::size_t row) {
  if (row == 0) return written(run, body, 0);
  const auto mean = [&](const char* quantity) {
    return (run.of(body, quantity, row, 0.0) - run.of(body, quantity, row - 1, 0.0)) / run.facts.step;
  };
  return {mean(".x"), mean(".y"), mean(".angle")};
}

/// Dissipated energy of one mechanism: its power in the present row, and the sum so far.
class Loss {
 public:
  explicit Loss(double step) : step_{step} {}
  /// Ends a row, in which `power` acts and `released` is lost at once.
  void end_row(double power, double released) {
    if (!sum_.empty()) total_ += 0.5 * step_ * (before_ + power);
    total_ += released, before_ = power;
    sum_.push_back(total_);
  }
  [[nodiscard]] double total() const { return total_; }
  [[nodiscard]] const std::vector<double>& sum() const { return sum_; }

 private:
  double step_, before_{}, total_{};
  std::vector<double> sum_;
};

/// A spring and a dashpot that act while they push (or pull) together; where they stop before the deformation ends, the
/// energy of the spring is released.
class OneSided {
 public:
  OneSided(double stiffness, double damping, double step)
      : k_{stiffness}, c_{damping}, damped_{step}, released_{step} {}
  void end_row(double deformation, double rate) {
    const bool acts = deformation > 0.0 && k_ * deformation + c_ * rate > 0.0;
    const double stored = 0.5 * k_ * deformation * deformation;
    const bool is_released = deformation > 0.0 && !acts;
    damped_.end_row(acts ? c_ * rate * rate : 0.0, 0.0);
    released_.end_row(0.0, is_released && acted_ ? stored : acts && was_released_ ? -stored : 0.0);
    acted_ = acts, was_released_ = is_released;
  }
  [[nodiscard]] const std::vector<double>& damped() const { return damped_.sum(); }
  [[nodiscard]] const std::vector<double>& released() const { return released_.sum(); }

 private:
  double k_, c_;
  Loss damped_, released_;
  bool acted_{}, was_released_{};
};

/// Friction of the disc "low" on the ground: a spring of the normal stiffness, with the retardation time of the normal
/// dashpot, and a slider.
class GroundFriction {
 public:
  explicit GroundFriction(double step) : loss_{step} {}

  /// Slip and pressure in a row.
  struct Contact {
    double slip_rate{}, normal{};
    [[nodiscard]] bool presses() const { return normal > 0.0; }
    [[nodiscard]] double limit() const { return yard_friction * normal / low_stiffness; }
    [[nodiscard]] double viscous() const { return presses() ? low_damping / low_stiffness * slip_rate : 0.0; }
  };

  /// `slipped`: slip of the step before the row; `since_touch`: estimate of the slip since the touch, for a contact
  /// that has begun in this step. `seen`: the contact with the velocities written in the row.
  void end_row(const Contact& now, double slipped, double since_touch, const Contact& seen) {
    if (pressed_) stretch_ += slipped;
    if (now.presses() && !pressed_) stretch_ = std::clamp(since_touch, -now.limit(), now.limit());
    const Limited limited = limit(now, pressed_ || now.presses());
    stretch_ = limited.stretch;
    sticks_ = now.presses() && !limited.slips;
    // While it sticks, the dashpot dissipates what its force takes.
    const double force = std::clamp(stretch_ + now.viscous(), -now.limit(), now.limit());
    loss_.end_row(sticks_ ? low_stiffness * (force - stretch_) * now.slip_rate : 0.0, limited.lost);
    // The row shows the state whose slider is limited once more, at the written velocities.
    const Limited shown = limit(seen, now.presses() || seen.presses());
    stored_.push_back(energy(shown.stretch)), dissipated_.push_back(loss_.total() + shown.lost);
    pressed_ = now.presses();
  }
  [[nodiscard]] const std::vector<double>& stored() const { return stored_; }
  [[nodiscard]] const std::vector<double>& dissipated() const { return dissipated_; }

 private:
  static double energy(double stretch) { return 0.5 * low_stiffness * stretch * stretch; }
  struct Limited {
    double stretch{}, lost{};
    bool slips{};
  };
  /// The slider moves until spring and dashpot carry mu N; a spring that the dashpot helps over the limit jumps to it.
  [[nodiscard]] Limited limit(const Contact& at, bool acts) const {
    if (!acts) return {};
    if (!at.presses()) return {0.0, energy(stretch_), false};
    const double loaded = stretch_ + at.viscous();
    if (std::abs(loaded) <= at.limit()) return {stretch_, 0.0, false};
    const double end = std::copysign(at.limit(), loaded);
    const bool beyond = !sticks_ && (loaded > 0.0 ? stretch_ > end : stretch_ < end);
    return {end,
            beyond ? yard_friction * at.normal * (std::abs(stretch_) - at.limit()) : energy(stretch_) - energy(end),
            true};
  }

  Loss loss_;
  double stretch_{};
  bool pressed_{}, sticks_{};
  std::vector<double> stored_, dissipated_;
};

}  // namespace

YardEnergies yard_energies(const Run& run) {
  const double h = run.facts.step;
  const Part &low = run.body("low"), &high = run.body("high"), &side = run.body("side"), &beam = run.body("beam");
  const Cable &tie = run.facts.cables[0], &rope = run.facts.cables[1];
  const auto at = [&](const Part& body, const char* quantity, std::size_t row) {
    return run.of(body, quantity, row, 0.0);
  };
  OneSided bed{low_stiffness, low_damping, h}, pull{rope.stiffness, rope.damping, h};
  GroundFriction rubbing{h};
  Loss latching{h}, yielding{h};
  YardEnergies found;
  double largest = 0.0, longest = 0.0;
  for (std::size_t row = 0; row < run.rows(); ++row) {
    const Motion of_low = evaluated(run, low, row), of_high = evaluated(run, high, row), shown = written(run, low, row);
    // On the ground; the contact point is in the middle of the overlap.
    const double depth = low_radius - at(low, ".y", row), before = low_radius - at(low, ".y", row > 0 ? row - 1 : 0);
    const auto slip_rate = [&](const Motion& motion, double overlap) {
      return motion.x + motion.angle * (low_radius - 0.5 * overlap);
    };
    const auto contact = [&](const Motion& motion) {
      const double force = depth > 0.0 ? low_stiffness * depth - low_damping * motion.y : 0.0;
      return GroundFriction::Contact{slip_rate(motion, depth), std::max(0.0, force)};
    };
    const GroundFriction::Contact now = contact(of_low), seen = contact(shown);
    const double approach = -of_low.y;
    bed.end_row(depth, approach);
    rubbing.end_row(now, h * slip_rate(of_low, 0.5 * (depth + before)),
                    approach > 0.0 ? now.slip_rate * depth / approach : 0.0, seen);
    // The latching spring dissipates (1 - K1/K2) K1 d while it is pressed further than before.
    const Vector apart = between(run.position(high, 0.0, 0.0, row), run.position(low, 0.0, 0.0, row));
    const double distance = size(apart), latched = high_radius + low_radius - distance;
    const double closing = -((of_low.x - of_high.x) * apart[0] + (of_low.y - of_high.y) * apart[1]) / distance;
    const bool further = latched > largest;
    largest = latched > 0.0 ? std::max(largest, latched) : 0.0;
    latching.end_row(further ? loading * latched * (1.0 - loading / unloading) * closing : 0.0, 0.0);
    // The cables; the tie is vertical.
    const Vector along = between(run.position(rope.from, row), run.position(rope.to, row));
    const double length = size(along), longer = length - rope.rest;
    pull.end_row(longer, -(of_high.x * along[0] + of_high.y * along[1]) / length);
    const double drawn = tie.to.y - at(beam, ".y", row) - tie.rest, rate = -evaluated(run, beam, row).y;
    const bool yields = drawn * tie.stiffness >= tie.yield && drawn >= longest && rate > 0.0;
    longest = std::max(longest, drawn);
    yielding.end_row(yields ? tie.yield * rate : 0.0, 0.0);

    const double hertz_depth =
        low_radius + side_radius - size(between(run.position(side, 0.0, 0.0, row), run.position(low, 0.0, 0.0, row)));
    const double hertz = 8.0 / 15.0 * modulus * std::sqrt(hertz_radius) * std::pow(std::max(0.0, hertz_depth), 2.5);
    const double back = std::max(0.0, loading * largest - unloading * (largest - latched));
    found.contacts.push_back((seen.presses() ? 0.5 * low_stiffness * depth * depth : 0.0) + rubbing.stored().back() +
                             0.5 * back * back / unloading + hertz);
    const double plastic = std::max(0.0, longest - tie.yield / tie.stiffness), elastic = std::max(0.0, drawn - plastic);
    const Motion seen_high = written(run, high, row);
    const double lengthening = -(seen_high.x * along[0] + seen_high.y * along[1]) / length;
    const bool pulls = longer > 0.0 && rope.stiffness * longer + rope.damping * lengthening > 0.0;
    found.cables.push_back(0.5 * tie.stiffness * elastic * elastic +
                           (pulls ? 0.5 * rope.stiffness * longer * longer : 0.0));
  }
  for (const std::string& mechanism : mechanisms())
    found.dissipated[mechanism] = std::vector<double>(run.rows(), 0.0);
  for (std::size_t row = 0; row < run.rows(); ++row)
    found.dissipated["contact_damping"][row] = bed.damped()[row] + latching.sum()[row];
  found.dissipated["contact_release"] = bed.released();
  found.dissipated["cable_damping"] = pull.damped(), found.dissipated["cable_release"] = pull.released();
  found.dissipated["cable_yield"] = yielding.sum(), found.dissipated["friction"] = rubbing.dissipated();
  return found;
}

}  // namespace talus::verification::problems::agreeing_files
