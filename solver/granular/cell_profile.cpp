#include "solver/granular/cell_profile.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace talus {
namespace {

constexpr std::size_t kept = 5;
enum Kept : std::size_t { area, momentum, mass, energy, turning };

/// Area of a disc of radius 1 below the height s over its centre.
double area_below(double s) {
  if (s <= -1.0) return 0.0;
  if (s >= 1.0) return std::numbers::pi;
  return std::acos(-s) + s * std::sqrt(1.0 - s * s);
}

}  // namespace

CellProfile::CellProfile(std::size_t layers, double thickness, double width)
    : thickness_{thickness}, width_{width}, sums_(layers * kept) {}

void CellProfile::add(const Disc& disc, double weight) {
  const double low = (disc.y - disc.radius) / thickness_, high = (disc.y + disc.radius) / thickness_;
  const auto layers = static_cast<double>(sums_.size() / kept);
  const double first = std::clamp(std::floor(low), 0.0, layers), last = std::clamp(std::ceil(high), 0.0, layers);
  for (double layer = first; layer < last; layer += 1.0) {
    const double part = disc.radius * disc.radius *
                        (area_below(((layer + 1.0) * thickness_ - disc.y) / disc.radius) -
                         area_below((layer * thickness_ - disc.y) / disc.radius));
    double* sums = sums_.data() + static_cast<std::size_t>(layer) * kept;
    sums[area] += weight * part;
    sums[momentum] += weight * part * disc.mass * disc.vx;
    sums[mass] += weight * part * disc.mass;
    sums[energy] += weight * part * 0.5 * disc.mass * (disc.vx * disc.vx + disc.vy * disc.vy);
    sums[turning] += weight * part * disc.mass * disc.spin;
  }
}

std::vector<CellProfile::Layer> CellProfile::layers() const {
  std::vector<Layer> made;
  for (std::size_t k = 0; k < sums_.size() / kept; ++k) {
    const double* sums = sums_.data() + k * kept;
    Layer layer{.y = (static_cast<double>(k) + 0.5) * thickness_};
    if (sums[area] > 0.0) {
      layer.velocity = sums[momentum] / sums[mass];
      layer.temperature = (sums[energy] - 0.5 * sums[momentum] * layer.velocity) / sums[area];
      layer.spin = sums[turning] / sums[mass];
      layer.fraction = sums[area] / (time_ * width_ * thickness_);
    }
    made.push_back(layer);
  }
  return made;
}

void CellProfile::remember(Memory& memory) {
  memory.number("time", time_);
  memory.numbers("sums", sums_);
}

}  // namespace talus
