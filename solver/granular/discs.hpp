#pragma once

#include <cstddef>
#include <vector>

namespace talus {

/// A wall: discs that stand to each other as they do. It is held, or moves at a velocity that is given to its discs;
/// one with a mass moves along y as the forces on it and its weight say.
struct DiscWall {
  double mass{};     ///< [M]; 0: no force moves it
  double gravity{};  ///< acceleration of free fall, downwards [L/T^2]; of a wall with a mass
};

/// What discs are: constants of a run. Smooth discs do not turn.
struct DiscShapes {
  static constexpr std::size_t free = 0;  ///< the wall of discs that belong to none

  std::vector<double> radius;        ///< [L] > 0
  std::vector<double> inverse_mass;  ///< [1/M]; 0: of a wall's discs
  std::vector<std::size_t> wall;     ///< free, or one more than a place among the walls
  std::vector<DiscWall> walls;

  std::size_t size() const { return radius.size(); }
  void add(double with_radius, double with_inverse_mass, std::size_t in_wall = free) {
    radius.push_back(with_radius);
    inverse_mass.push_back(with_inverse_mass);
    wall.push_back(in_wall);
  }
  /// Adds a wall without discs so far; what its discs are to say of it.
  std::size_t add(const DiscWall& another) {
    walls.push_back(another);
    return walls.size();
  }
};

/// Where discs are and how they move: numbers only, one array for each.
struct Discs {
  double t{};                  ///< time [T]
  std::vector<double> x, y;    ///< centres [L]; may lie outside a periodic box, in an image of it
  std::vector<double> vx, vy;  ///< [L/T]
  double dissipated{};         ///< energy that the contacts have kept so far [F L]

  std::size_t size() const { return x.size(); }
  void add(double at_x, double at_y, double with_vx, double with_vy) {
    x.push_back(at_x), y.push_back(at_y);
    vx.push_back(with_vx), vy.push_back(with_vy);
  }
  friend bool operator==(const Discs&, const Discs&) = default;
};

}  // namespace talus
