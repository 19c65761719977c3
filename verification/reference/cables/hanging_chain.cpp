#include "verification/reference/cables/hanging_chain.hpp"

#include <cmath>
#include <cstddef>
#include <stdexcept>

#include "verification/reference/mathematics/high_precision.hpp"

namespace talus::verification::reference {
namespace {

/// Pull of the first link, or any other pair of components.
struct Pair {
  Real50 x, y;
};

/// Sums over the links for the pull (H, V_0): chain end minus required end, and its Jacobian.
struct Sums {
  Pair miss;
  Real50 xx, xy, yy;
  Pair pulls;  // sum of (H, V_i)
};

Real50 length(const Pair& p) { return sqrt(p.x * p.x + p.y * p.y); }

Sums sums(const HangingChain& chain, const Real50& compliance, const Pair& pull) {
  Sums s{{Real50(-chain.span), Real50(-chain.rise)}, 0, 0, 0, {0, 0}};
  for (int i = 0; i <= chain.joints; ++i) {
    const Pair p{pull.x, pull.y + Real50(chain.weight) * i};
    const Real50 t = length(p), ratio = chain.link / t, bend = ratio / (t * t);
    s.miss.x += (ratio + compliance) * p.x;
    s.miss.y += (ratio + compliance) * p.y;
    s.xx += bend * p.y * p.y + compliance;
    s.xy -= bend * p.x * p.y;
    s.yy += bend * p.x * p.x + compliance;
    s.pulls.x += p.x;
    s.pulls.y += p.y;
  }
  return s;
}

/// Solution of J p = -right.
Pair solve(const Sums& s, const Pair& right) {
  const Real50 determinant = s.xx * s.yy - s.xy * s.xy;
  return {(s.xy * right.y - s.yy * right.x) / determinant, (s.xy * right.x - s.xx * right.y) / determinant};
}

Pair first_pull(const HangingChain& chain, const Real50& compliance) {
  const bool sound = chain.joints >= 1 && chain.weight > 0.0 && chain.span > 0.0 && compliance >= 0 &&
                     (chain.joints + 1) * chain.link > std::hypot(chain.span, chain.rise);
  if (!sound) throw std::invalid_argument("HangingChain: needs joints, weights, a span, and links that reach over it");
  Pair pull{Real50(chain.joints * chain.weight) / 2, Real50(-chain.joints * chain.weight) / 2};
  Sums now = sums(chain, compliance, pull);
  for (int iteration = 0; iteration < 200; ++iteration) {
    if (length(now.miss) < 1e-46 * chain.span) return pull;
    const Pair step = solve(now, now.miss);
    Real50 ratio = 1;
    for (;; ratio /= 2) {
      const Pair next{pull.x + ratio * step.x, pull.y + ratio * step.y};
      const Sums there = sums(chain, compliance, next);
      if (ratio > 1e-12 && !(length(there.miss) < length(now.miss))) continue;
      pull = next;
      now = there;
      break;
    }
  }
  throw std::invalid_argument("HangingChain: no balance found");
}

}  // namespace

HungChain hung_chain(const HangingChain& chain, double compliance) {
  const Pair pull = first_pull(chain, Real50(compliance));
  HungChain hung;
  Pair at{0, 0};
  for (int i = 0; i <= chain.joints; ++i) {
    const Pair p{pull.x, pull.y + Real50(chain.weight) * i};
    const Real50 t = length(p), ratio = chain.link / t + compliance;
    hung.tension.push_back(nearest(t));
    at = {at.x + ratio * p.x, at.y + ratio * p.y};
    if (i == chain.joints) break;
    hung.x.push_back(nearest(at.x));
    hung.y.push_back(nearest(at.y));
  }
  return hung;
}

HungChain softening(const HangingChain& chain) {
  const Pair pull = first_pull(chain, Real50(0));
  const Sums s = sums(chain, Real50(0), pull);
  const Pair rate = solve(s, s.pulls);
  HungChain rates;
  Pair at{0, 0};
  for (int i = 0; i <= chain.joints; ++i) {
    const Pair p{pull.x, pull.y + Real50(chain.weight) * i};
    const Real50 t = length(p), along = (p.x * rate.x + p.y * rate.y) / t;
    rates.tension.push_back(nearest(along));
    // d(l p/T + c p) = l (dp - p dT/T)/T + p at c = 0
    at.x += chain.link * (rate.x - p.x * along / t) / t + p.x;
    at.y += chain.link * (rate.y - p.y * along / t) / t + p.y;
    if (i == chain.joints) break;
    rates.x.push_back(nearest(at.x));
    rates.y.push_back(nearest(at.y));
  }
  return rates;
}

}  // namespace talus::verification::reference
