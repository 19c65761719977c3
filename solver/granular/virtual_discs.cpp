#include "solver/granular/virtual_discs.hpp"

#include <algorithm>
#include <cmath>

namespace talus {

void VirtualDiscs::build(const DiscShapes& shapes, const Discs& discs) {
  first_.assign(1, 0), second_.clear();
  for (std::size_t i = 0; i < shapes.size(); ++i) {
    for (std::size_t j = i + 1; j < shapes.size(); ++j)
      if (shapes.inverse_mass[i] > 0.0 || shapes.inverse_mass[j] > 0.0)
        second_.push_back(static_cast<std::uint32_t>(j));
    first_.push_back(static_cast<std::uint32_t>(second_.size()));
  }
  image_.resize(second_.size());
  find_nearest(discs);
}

bool VirtualDiscs::holds(const Discs& discs) {
  const double half = 0.5 * box().width;
  if (!std::all_of(discs.x.begin(), discs.x.end(), [&](double x) { return x >= -half && x < half; })) return false;
  find_nearest(discs);
  return true;
}

void VirtualDiscs::serialize(Archive& archive, const DiscShapes& shapes) {
  if (archive.is_loading()) x_.resize(shapes.size());
  archive.numbers("x", x_);
  if (!archive.is_loading()) return;
  Discs then;
  then.x = x_;
  build(shapes, then);
}

void VirtualDiscs::find_nearest(const Discs& discs) {
  x_ = discs.x;
  constexpr std::uint8_t here = images / 2, left = here - 1, right = here + 1;
  for (std::size_t i = 0; i < this->discs(); ++i) {
    const double own = x_[i], own_virtual = own - box().width;
    for (std::size_t pair = begin(i); pair < end(i); ++pair) {
      const double other = x_[second(pair)], other_virtual = other - box().width;
      const double real = std::abs(other - own);
      const double by_other = std::abs(other_virtual - own), by_own = std::abs(other - own_virtual);
      image_[pair] = real <= std::min(by_other, by_own) ? here : by_other < by_own ? left : right;
    }
  }
}

}  // namespace talus
