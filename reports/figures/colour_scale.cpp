#include "reports/figures/colour_scale.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <span>

namespace talus::reports {
namespace {

struct Stop {
  double position;
  std::array<double, 3> colour;  ///< red, green, blue, 0 to 255
};
constexpr std::array<Stop, 4> one_hue{
    {{0.0, {254.0, 196.0, 79.0}}, {0.35, {254.0, 127.0, 45.0}}, {0.7, {215.0, 25.0, 28.0}}, {1.0, {103.0, 0.0, 31.0}}}};
// Blue and red, which are distinguishable with any colour vision deficiency.
constexpr std::array<Stop, 5> two_hues_apart{{{0.0, {5.0, 48.0, 97.0}},
                                              {0.25, {84.0, 151.0, 196.0}},
                                              {0.5, {247.0, 247.0, 247.0}},
                                              {0.75, {220.0, 125.0, 97.0}},
                                              {1.0, {103.0, 0.0, 31.0}}}};
constexpr double steps = 48.0;

}  // namespace

long ColourScale::colour(double value) const {
  const std::span<const Stop> stops = two_hues ? std::span<const Stop>{two_hues_apart} : one_hue;
  const double at = std::round(std::clamp((value - min) / (max - min), 0.0, 1.0) * steps) / steps;
  std::size_t upper = 1;
  while (upper + 1 < stops.size() && stops[upper].position < at)
    ++upper;
  const Stop& low = stops[upper - 1];
  const Stop& high = stops[upper];
  const double part = (at - low.position) / (high.position - low.position);
  long colour = 0;
  for (std::size_t i = 0; i < 3; ++i)
    colour = 256 * colour + std::lround(low.colour[i] + part * (high.colour[i] - low.colour[i]));
  return colour;
}

}  // namespace talus::reports
