#pragma once

#include <cstddef>
#include <vector>

namespace talus {

/// What discs are: constants of a run. Smooth discs do not turn; those with friction do.
struct DiscShapes {
  std::vector<double> radius;        ///< [L] > 0
  std::vector<double> inverse_mass;  ///< [1/M]; 0: the disc is held or driven, and takes no force
  std::vector<std::size_t> group;    ///< of which the forces are summed: 0 for free discs, walls have their own

  std::size_t size() const { return radius.size(); }
  void add(double r, double one_over_m, std::size_t of_group = 0) {
    radius.push_back(r);
    inverse_mass.push_back(one_over_m);
    group.push_back(of_group);
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
