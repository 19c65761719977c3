#include "verification/reference/cables/stretched_chain.hpp"

#include <boost/math/constants/constants.hpp>
#include <stdexcept>

#include "verification/reference/mathematics/high_precision.hpp"

namespace talus::verification::reference {
namespace {

const Real50 pi = boost::math::constants::pi<Real50>();

void demand_valid(const StretchedChain& chain) {
  if (!(chain.masses >= 1 && chain.mass > 0.0 && chain.stiffness > 0.0))
    throw std::invalid_argument("StretchedChain: needs a mass at least, m > 0 and k > 0");
}

}  // namespace

std::vector<double> chain_frequencies(const StretchedChain& chain) {
  demand_valid(chain);
  std::vector<double> list;
  for (int j = 1; j <= chain.masses; ++j) {
    const Real50 angle = pi * j / (2 * (chain.masses + 1));
    list.push_back(nearest(2 * sqrt(Real50(chain.stiffness) / chain.mass) * sin(angle)));
  }
  return list;
}

std::vector<double> chain_shape(const StretchedChain& chain, int mode) {
  demand_valid(chain);
  std::vector<double> list;
  for (int i = 1; i <= chain.masses; ++i)
    list.push_back(nearest(sin(pi * i * mode / (chain.masses + 1))));
  return list;
}

double leapfrog_frequency(double frequency, double step) {
  const Real50 half = Real50(frequency) * step / 2;
  if (!(half > 0 && half <= 1)) throw std::invalid_argument("leapfrog_frequency: needs 0 < w h <= 2");
  return nearest(2 * asin(half) / step);
}

double leapfrog_growth(double frequency, double step) {
  const Real50 half = Real50(frequency) * step / 2;
  if (!(half >= 1)) throw std::invalid_argument("leapfrog_growth: needs w h >= 2");
  const Real50 root = half + sqrt((half - 1) * (half + 1));
  return nearest(root * root);
}

}  // namespace talus::verification::reference
