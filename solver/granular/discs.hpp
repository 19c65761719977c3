#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <numeric>
#include <vector>

#include "solver/base/archive.hpp"
#include "solver/state/state.hpp"

namespace talus {

/// A wall: discs with fixed relative positions. It is held, or moves at the velocity that its discs are given; a wall
/// with a mass moves along y under its contact forces and its weight.
struct DiscWall {
  double mass{};     ///< [M]; 0: forces do not move it
  double gravity{};  ///< acceleration of free fall, downwards [L/T^2]; only for a wall with a mass
};

/// Properties of discs that are constant in a run.
struct DiscShapes {
  static constexpr std::size_t free = 0;  ///< wall number of discs that belong to no wall

  std::vector<double> radius;        ///< [L] > 0
  std::vector<double> inverse_mass;  ///< [1/M]; 0 for discs of walls
  std::vector<std::uint32_t> wall;   ///< wall number: free, or 1 + index in `walls`
  std::vector<DiscWall> walls;

  std::size_t size() const { return radius.size(); }
  void add(double with_radius, double with_inverse_mass, std::size_t in_wall = free) {
    radius.push_back(with_radius);
    inverse_mass.push_back(with_inverse_mass);
    wall.push_back(static_cast<std::uint32_t>(in_wall));
  }
  /// Adds a wall that has no discs yet; returns the wall number of its discs.
  std::size_t add(const DiscWall& another) {
    walls.push_back(another);
    return walls.size();
  }
};

struct DiscRates;

/// Positions and velocities of discs: numbers only, one array for each. Contact memory is stored with the pairs
/// (DiscSystem).
struct Discs {
  using Number = double;
  using Rates = DiscRates;

  double t{};                                  ///< time [T]
  double shear_displacement{};                 ///< boundary shear displacement of the box above over this one [L]
  std::vector<double> x, y;                    ///< centres [L]; may lie outside a periodic box, in an image of it
  std::vector<double> vx, vy;                  ///< [L/T]
  std::vector<double> spin;                    ///< counter-clockwise > 0 [1/T]; empty if discs do not turn
  std::array<double, mechanism_count> work{};  ///< energy dissipated by the contacts so far, by mechanism [F L]

  std::size_t size() const { return x.size(); }
  void add(double at_x, double at_y, double with_vx, double with_vy) {
    x.push_back(at_x), y.push_back(at_y);
    vx.push_back(with_vx), vy.push_back(with_vy);
  }
  /// Energy dissipated by all mechanisms [F L].
  double dissipated() const { return std::accumulate(work.begin(), work.end(), 0.0); }
  friend bool operator==(const Discs&, const Discs&) = default;
};

/// Accelerations of discs [L/T^2, 1/T^2], and the powers dissipated by their contacts [F L/T].
struct DiscRates {
  std::vector<double> vx, vy, spin;
  std::array<double, mechanism_count> work{};

  explicit DiscRates(const Discs& like) : vx(like.size()), vy(like.size()), spin(like.spin.size()) {}
  DiscRates() = default;
};

/// Advances velocities and work by h times their rates.
void kick_velocities(Discs& discs, const DiscRates& rates, double h);

/// The discs, moved with their velocities over h. sliding: velocity of the box above [L/T].
[[nodiscard]] inline Discs drifted(Discs discs, double sliding, double h) {
  for (std::size_t i = 0; i < discs.size(); ++i)
    discs.x[i] += h * discs.vx[i], discs.y[i] += h * discs.vy[i];
  discs.shear_displacement += h * sliding;
  return discs;
}

/// Serializes a state or rates; when loading, their arrays must already have the right sizes.
inline void serialize(Archive& archive, Discs& discs) {
  archive.number("t", discs.t);
  archive.number("boundary_shear_displacement", discs.shear_displacement);
  archive.numbers("x", discs.x), archive.numbers("y", discs.y);
  archive.numbers("vx", discs.vx), archive.numbers("vy", discs.vy);
  archive.numbers("spin", discs.spin);
  archive.numbers("work", discs.work);
}
inline void serialize(Archive& archive, DiscRates& rates) {
  archive.numbers("vx", rates.vx), archive.numbers("vy", rates.vy);
  archive.numbers("spin", rates.spin);
  archive.numbers("work", rates.work);
}

}  // namespace talus
