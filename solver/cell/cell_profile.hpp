#pragma once

#include <cstddef>
#include <vector>

#include "solver/base/archive.hpp"
#include "solver/cell/block_means.hpp"

namespace talus {

/// Means over time of velocity, temperature, spin and solid fraction in layers across a field of discs, with standard
/// errors: by leaving out one tenth of the time after the other (jackknife; Quenouille 1956).
class CellProfile {
 public:
  static constexpr std::size_t blocks = 10;

  /// Most layers: what is above them is left out.
  static constexpr std::size_t most_layers = 100000;

  /// Layers of this thickness [L] > 0 from y = 0 up, as many as discs are in; width of the field [L]. From the time
  /// `from` to `to` [T].
  CellProfile(double thickness, double width, double from, double to);

  struct Disc {
    double y{};  ///< of the centre [L]
    double vx{}, vy{};
    double radius{};  ///< [L]
    double mass{};    ///< [M]
    double spin{};    ///< counter-clockwise > 0 [1/T]
  };
  /// At the time t, for so much of it: then discs are added one by one.
  void look(double t, double weight);
  void add(const Disc& disc);

  struct Layer {
    double y{};            ///< of its middle [L]
    Estimate velocity;     ///< along x, the mean of discs by their area in the layer [L/T]
    Estimate temperature;  ///< m (<vx'^2> + <vy^2>)/2 about that mean [F L]
    Estimate spin;         ///< the mean by area, counter-clockwise > 0 [1/T]
    Estimate fraction;     ///< area of discs over the layer's
  };
  /// From the base up; layers in which no disc ever was have zeros.
  std::vector<Layer> layers() const;

  void serialize(Archive& archive);

 private:
  double thickness_, width_, from_, block_time_;
  std::size_t block_{};        ///< of the present look
  double weight_{};            ///< of it
  std::vector<double> times_;  ///< of each block
  std::vector<double> sums_;   ///< five for each block, layer by layer
};

}  // namespace talus
