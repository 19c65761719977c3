#include "verification/reference/many_bodies/latching_chain.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <utility>

#include "verification/reference/mathematics/trajectory.hpp"

namespace talus::verification::reference {
namespace {

enum class Branch { open, loading, unloading, slack };

/// History of one contact: its branch and its largest overlap.
struct Latch {
  Branch branch{Branch::open};
  long double largest{};  ///< M
};

/// The chain, advanced from branch change to branch change. Coordinates: displacements from t = 0, then velocities.
class MovingChain {
 public:
  explicit MovingChain(const LatchingChain& chain) : chain_{chain}, discs_{chain.velocity.size()} {
    bool sound = chain.loading > 0.0 && chain.unloading >= chain.loading && chain.mass > 0.0 && discs_ > 1 &&
                 chain.gap.size() + 1 == discs_;
    for (const double gap : chain.gap)
      sound = sound && gap >= 0.0;
    if (!sound) throw std::invalid_argument("latching_chain: needs 0 < K1 <= K2, m > 0, discs > 1, gaps >= 0");
    y_.resize(2 * discs_);
    std::copy(chain.velocity.begin(), chain.velocity.end(), y_.begin() + static_cast<std::ptrdiff_t>(discs_));
    for (const double gap : chain.gap)
      latches_.push_back({gap == 0.0 ? Branch::loading : Branch::open, 0.0L});
    found_.largest.resize(latches_.size());
  }

  /// Advances to `limit`, or to the time at which all forces have ended.
  void advance(long double limit) {
    while (time_ < limit && !ended()) {
      std::vector<Guard> guards;
      std::vector<std::pair<std::size_t, Branch>> follows;
      watch(guards, follows);
      Trajectory piece([this](const Coordinates& y, Coordinates& rates) { rate(y, rates); }, y_, time_, longest_step());
      const auto change = piece.advance_until(guards, limit);
      y_ = piece.coordinates(), time_ = piece.time();
      if (!change) return;
      begin(follows[*change].first, follows[*change].second);
    }
  }

  /// True if no contact has a force and no disc is faster than the next.
  bool ended() const {
    for (std::size_t c = 0; c < latches_.size(); ++c) {
      const Branch branch = latches_[c].branch;
      if (branch == Branch::loading || branch == Branch::unloading || overlap_rate(c, y_) > 0.0L) return false;
    }
    return true;
  }

  double velocity(std::size_t disc) const { return static_cast<double>(y_[discs_ + disc]); }
  long double time() const { return time_; }

  ChainRebound rebound() {
    for (std::size_t c = 0; c < latches_.size(); ++c)
      forget(c);
    for (std::size_t i = 0; i < discs_; ++i)
      found_.velocity.push_back(velocity(i));
    found_.end_time = static_cast<double>(time_);
    found_.kept = static_cast<double>(kept_);
    return found_;
  }

 private:
  long double overlap(std::size_t c, const Coordinates& y) const { return y[c] - y[c + 1] - chain_.gap[c]; }
  long double overlap_rate(std::size_t c, const Coordinates& y) const { return y[discs_ + c] - y[discs_ + c + 1]; }
  /// K1/K2; residual() is d0.
  long double ratio() const { return static_cast<long double>(chain_.loading) / chain_.unloading; }
  long double residual(const Latch& latch) const { return latch.largest * (1.0L - ratio()); }

  /// One thirtieth of the time per radian of oscillation of the stiffest contact of two discs.
  long double longest_step() const { return std::sqrt(chain_.mass / (2.0L * chain_.unloading)) / 30.0L; }

  long double force(std::size_t c, const Coordinates& y) const {
    const Latch& latch = latches_[c];
    if (latch.branch == Branch::loading) return chain_.loading * overlap(c, y);
    if (latch.branch == Branch::unloading) return chain_.unloading * (overlap(c, y) - residual(latch));
    return 0.0L;
  }

  void rate(const Coordinates& y, Coordinates& rates) const {
    for (std::size_t i = 0; i < discs_; ++i) {
      rates[i] = y[discs_ + i];
      const long double from_left = i > 0 ? force(i - 1, y) : 0.0L;
      const long double from_right = i + 1 < discs_ ? force(i, y) : 0.0L;
      rates[discs_ + i] = (from_left - from_right) / chain_.mass;
    }
  }

  /// Guards that end each contact's branch, with the branch that follows.
  void watch(std::vector<Guard>& guards, std::vector<std::pair<std::size_t, Branch>>& follows) const {
    for (std::size_t c = 0; c < latches_.size(); ++c) {
      const auto ends = [&](Guard guard, Branch next) {
        guards.push_back(std::move(guard));
        follows.emplace_back(c, next);
      };
      const auto beyond = [this, c](long double from) {
        return [this, c, from](const Coordinates& y) { return overlap(c, y) - from; };
      };
      const auto below = [this, c](long double to) {
        return [this, c, to](const Coordinates& y) { return to - overlap(c, y); };
      };
      const Latch& latch = latches_[c];
      switch (latch.branch) {
        case Branch::open:
          ends(below(0.0L), Branch::loading);
          break;
        case Branch::loading:
          ends([this, c](const Coordinates& y) { return overlap_rate(c, y); }, Branch::unloading);
          break;
        case Branch::unloading:
          ends(below(latch.largest), Branch::loading);
          ends(beyond(residual(latch)), Branch::slack);
          break;
        case Branch::slack:
          ends(below(residual(latch)), Branch::unloading);
          ends(beyond(0.0L), Branch::open);
          break;
      }
    }
  }

  void begin(std::size_t c, Branch next) {
    Latch& latch = latches_[c];
    const Branch before = latch.branch;
    if (before == Branch::loading) latch.largest = overlap(c, y_);
    if (next == Branch::open) forget(c);
    if (before == Branch::slack && next == Branch::unloading) ++found_.reloads, ++found_.reloads_from_slack;
    if (before == Branch::unloading && next == Branch::loading) ++found_.reloads;
    latch.branch = next;
  }

  /// Accumulates the energy dissipated by a contact and resets its largest overlap.
  void forget(std::size_t c) {
    const long double largest = latches_[c].largest;
    kept_ += 0.5L * chain_.loading * largest * largest * (1.0L - ratio());
    found_.largest[c] = std::max(found_.largest[c], static_cast<double>(largest));
    latches_[c].largest = 0.0L;
  }

  LatchingChain chain_;
  std::size_t discs_;
  Coordinates y_;
  long double time_{};
  std::vector<Latch> latches_;
  ChainRebound found_;
  long double kept_{};
};

}  // namespace

LatchingChain struck_chain(std::size_t count, double ratio, double mass, double loading, double speed) {
  LatchingChain chain{loading, loading / ratio, mass, std::vector<double>(count), std::vector<double>(count - 1)};
  chain.velocity.front() = speed;
  return chain;
}

ChainRebound chain_rebound(const LatchingChain& chain) {
  MovingChain moving{chain};
  // The time until discs without forces meet is not bounded; the duration of a segment with forces is.
  moving.advance(std::numeric_limits<long double>::max());
  return moving.rebound();
}

std::vector<std::vector<double>> chain_velocities(const LatchingChain& chain, std::span<const double> times) {
  MovingChain moving{chain};
  std::vector<std::vector<double>> found;
  for (const double time : times) {
    moving.advance(time);
    std::vector<double> now;
    for (std::size_t i = 0; i < chain.velocity.size(); ++i)
      now.push_back(moving.velocity(i));
    found.push_back(now);
  }
  return found;
}

}  // namespace talus::verification::reference
