#include "solver/cell/cell_profile.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "solver/base/error.hpp"

namespace talus {
namespace {

constexpr std::size_t kept = 5;
constexpr std::size_t of_layer = CellProfile::blocks * kept;
enum Kept : std::size_t { area, momentum, mass, energy, turning };

/// Area of a disc of radius 1 below the height s over its centre.
double area_below(double s) {
  if (s <= -1.0) return 0.0;
  if (s >= 1.0) return std::numbers::pi;
  return std::acos(-s) + s * std::sqrt(1.0 - s * s);
}

}  // namespace

CellProfile::CellProfile(double thickness, double width, double from, double to)
    : thickness_{thickness},
      width_{width},
      from_{from},
      block_time_{(to - from) / static_cast<double>(blocks)},
      times_(blocks) {}

void CellProfile::look(double t, double weight) {
  block_ = static_cast<std::size_t>(std::clamp((t - from_) / block_time_, 0.0, static_cast<double>(blocks - 1)));
  weight_ = weight;
  times_[block_] += weight;
}

void CellProfile::add(const Disc& disc) {
  const double low = (disc.y - disc.radius) / thickness_, high = (disc.y + disc.radius) / thickness_;
  // A disc whose position is NaN is in no layer.
  const double first = std::max(0.0, std::floor(low)),
               last = std::min(std::ceil(high), static_cast<double>(maximum_layers));
  if (first < last && last > static_cast<double>(sums_.size() / of_layer))
    sums_.resize(static_cast<std::size_t>(last) * of_layer);
  for (double layer = first; layer < last; layer += 1.0) {
    const double part = disc.radius * disc.radius *
                        (area_below(((layer + 1.0) * thickness_ - disc.y) / disc.radius) -
                         area_below((layer * thickness_ - disc.y) / disc.radius));
    double* sums = sums_.data() + static_cast<std::size_t>(layer) * of_layer + block_ * kept;
    sums[area] += weight_ * part;
    sums[momentum] += weight_ * part * disc.mass * disc.vx;
    sums[mass] += weight_ * part * disc.mass;
    sums[energy] += weight_ * part * 0.5 * disc.mass * (disc.vx * disc.vx + disc.vy * disc.vy);
    sums[turning] += weight_ * part * disc.mass * disc.spin;
  }
}

std::vector<CellProfile::Layer> CellProfile::layers() const {
  struct Values {
    double velocity{}, temperature{}, spin{}, fraction{};
  };
  constexpr std::array members{&Values::velocity, &Values::temperature, &Values::spin, &Values::fraction};
  constexpr std::array estimates{&Layer::velocity, &Layer::temperature, &Layer::spin, &Layer::fraction};
  // Values from all blocks except one; from all blocks if without == blocks.
  const auto values = [&](std::size_t layer, std::size_t without) {
    std::array<double, kept> sums{};
    double time = 0.0;
    for (std::size_t block = 0; block < blocks; ++block) {
      if (block == without) continue;
      time += times_[block];
      for (std::size_t k = 0; k < kept; ++k)
        sums[k] += sums_[layer * of_layer + block * kept + k];
    }
    Values of;
    if (!(sums[area] > 0.0)) return of;
    of.velocity = sums[momentum] / sums[mass];
    of.temperature = (sums[energy] - 0.5 * sums[momentum] * of.velocity) / sums[area];
    of.spin = sums[turning] / sums[mass];
    of.fraction = sums[area] / (time * width_ * thickness_);
    return of;
  };
  std::vector<Layer> made;
  for (std::size_t k = 0; k < sums_.size() / of_layer; ++k) {
    Layer layer{.y = (static_cast<double>(k) + 0.5) * thickness_,
                .velocity = {},
                .temperature = {},
                .spin = {},
                .fraction = {}};
    const Values all = values(k, blocks);
    std::vector<Values> left_out;  // without each of the sampled blocks
    for (std::size_t block = 0; block < blocks; ++block) {
      if (!(times_[block] > 0.0)) continue;
      Values of = values(k, block);
      // If the omitted block contained all discs of this layer, the others give no estimate of the means.
      if (of.fraction == 0.0) of = {all.velocity, all.temperature, all.spin, 0.0};
      left_out.push_back(of);
    }
    const auto count = static_cast<double>(left_out.size());
    for (std::size_t m = 0; m < members.size(); ++m) {
      double mean = 0.0, squares = 0.0;
      for (const Values& of : left_out)
        mean += of.*members[m] / count;
      for (const Values& of : left_out)
        squares += (of.*members[m] - mean) * (of.*members[m] - mean);
      layer.*estimates[m] = {all.*members[m], count > 1.0 ? std::sqrt((count - 1.0) / count * squares) : 0.0};
    }
    made.push_back(layer);
  }
  return made;
}

void CellProfile::serialize(Archive& archive) {
  archive.numbers("times", times_);
  archive.list("sums", sums_);
  if (sums_.size() % of_layer != 0) {
    throw InputError{fmt::format("sums: found {} numbers; they must be {} for each layer", sums_.size(), of_layer)};
  }
}

}  // namespace talus
