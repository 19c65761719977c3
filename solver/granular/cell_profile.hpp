#pragma once

#include <cstddef>
#include <vector>

#include "solver/base/memory.hpp"

namespace talus {

/// Means over time of velocity, temperature, spin and solid fraction in layers across a field of discs.
class CellProfile {
 public:
  /// layers: of this thickness [L] > 0 from y = 0 up; width of the field [L]. What is above the last layer is left out.
  CellProfile(std::size_t layers, double thickness, double width);

  struct Disc {
    double y{};  ///< of the centre [L]
    double vx{}, vy{};
    double radius{};  ///< [L]
    double mass{};    ///< [M]
    double spin{};    ///< counter-clockwise > 0 [1/T]
  };
  /// Adds what stands for `weight` of time: discs one by one, then the time itself.
  void add(const Disc& disc, double weight);
  void add_time(double weight) { time_ += weight; }

  struct Layer {
    double y{};            ///< of its middle [L]
    double velocity{};     ///< along x, the mean of discs by their area in the layer [L/T]
    double temperature{};  ///< m (<vx'^2> + <vy^2>)/2 about that mean [F L]
    double spin{};         ///< the mean by area, counter-clockwise > 0 [1/T]
    double fraction{};     ///< area of discs over the layer's
  };
  /// From the base up; layers in which no disc ever was have zeros.
  std::vector<Layer> layers() const;

  void remember(Memory& memory);

 private:
  double thickness_, width_;
  double time_{};
  std::vector<double> sums_;  ///< five for each layer
};

}  // namespace talus
