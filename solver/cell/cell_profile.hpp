#pragma once

#include <cstddef>
#include <vector>

#include "solver/base/archive.hpp"
#include "solver/cell/block_means.hpp"

namespace talus {

/// Time averages of velocity, temperature, spin and solid fraction in layers across a field of discs, with standard
/// errors from a jackknife over ten blocks of time (Quenouille 1956).
class CellProfile {
 public:
  static constexpr std::size_t blocks = 10;

  /// Maximum number of layers: discs above them are ignored.
  static constexpr std::size_t maximum_layers = 100000;

  /// Layers of this thickness [L] > 0 from y = 0 up, as many as contain discs; width of the field [L]. Averages are
  /// over the time from `from` to `to` [T].
  CellProfile(double thickness, double width, double from, double to);

  struct Disc {
    double y{};  ///< of the centre [L]
    double vx{}, vy{};
    double radius{};  ///< [L]
    double mass{};    ///< [M]
    double spin{};    ///< counter-clockwise > 0 [1/T]
  };
  /// Begins a sample at the time t that represents `weight` of time [T]; its discs are then added one by one.
  void look(double t, double weight);
  void add(const Disc& disc);

  struct Layer {
    double y{};            ///< of the layer's middle [L]
    Estimate velocity;     ///< along x: mean of discs, weighted by mass and area in the layer [L/T]
    Estimate temperature;  ///< m (<vx'^2> + <vy^2>)/2 about that mean [F L]
    Estimate spin;         ///< mean with the same weights, counter-clockwise > 0 [1/T]
    Estimate fraction;     ///< area of discs over the layer's
  };
  /// Layers from the base up; all values are zero in layers that never contained a disc.
  std::vector<Layer> layers() const;

  void serialize(Archive& archive);

 private:
  double thickness_, width_, from_, block_time_;
  std::size_t block_{};        ///< of the present sample
  double weight_{};            ///< of the present sample [T]
  std::vector<double> times_;  ///< sampled time of each block [T]
  std::vector<double> sums_;   ///< five for each block, layer by layer
};

}  // namespace talus
