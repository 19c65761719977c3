#include "solver/granular/packing.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <random>
#include <vector>

#include "solver/base/error.hpp"
#include "solver/granular/disc_system.hpp"
#include "solver/granular/random_draw.hpp"
#include "solver/granular/stress.hpp"
#include "solver/integrate/euler_cromer.hpp"
#include "solver/laws/linear_spring_dashpot.hpp"

namespace talus {
namespace {

void demand(bool holds, const char* field, double found, const char* allowed) {
  if (!holds) throw InputError{fmt::format("{} of a packing: found {}; it must be {}", field, found, allowed)};
}

void check(const PackingPlan& plan) {
  demand(plan.discs > 0, "discs", static_cast<double>(plan.discs), "> 0");
  demand(plan.diameter > 0.0, "diameter", plan.diameter, "> 0");
  demand(plan.spread >= 0.0 && plan.spread <= 0.9, "spread", plan.spread, "in [0, 0.9]");
  demand(plan.mass > 0.0, "mass", plan.mass, "> 0");
  demand(plan.solid_fraction > 0.0 && plan.solid_fraction <= 0.9, "solid_fraction", plan.solid_fraction, "in (0, 0.9]");
  demand(plan.aspect > 0.0, "aspect", plan.aspect, "> 0");
}

/// The discs of a plan without positions, and their rectangle.
Packing empty(const PackingPlan& plan, std::mt19937_64& random) {
  check(plan);
  Packing packing;
  const double middle = 0.5 * plan.diameter;
  double area = 0.0;
  for (std::size_t i = 0; i < plan.discs; ++i) {
    const double size = 1.0 + plan.spread * symmetric(random);
    packing.shapes.add(size * middle, 1.0 / (plan.mass * size * size));
    area += std::numbers::pi * size * size * middle * middle;
  }
  area /= plan.solid_fraction;
  packing.width = std::sqrt(area / plan.aspect);
  // The width is a whole number of wall discs.
  if (plan.walls) packing.width = plan.diameter * std::max(1.0, std::round(packing.width / plan.diameter));
  packing.height = area / packing.width;
  const double largest = 2.0 * *std::max_element(packing.shapes.radius.begin(), packing.shapes.radius.end());
  const double smallest = plan.walls ? packing.width : std::min(packing.width, packing.height);
  if (smallest < largest) {
    throw InputError{
        fmt::format("discs: found {}, for which the rectangle is {:g} wide and {:g} high; a disc of {:g} "
                    "would touch its own image",
                    plan.discs, packing.width, packing.height, largest)};
  }
  packing.box.width = packing.width;
  if (!plan.walls) packing.box.height = packing.height;
  return packing;
}

void add_walls(const PackingPlan& plan, Packing& packing) {
  const auto row = static_cast<std::size_t>(std::lround(packing.width / plan.diameter));
  for (const double side : {-1.0, 1.0}) {
    const std::size_t wall = packing.shapes.add(DiscWall{});
    for (std::size_t i = 0; i < row; ++i) {
      packing.shapes.add(0.5 * plan.diameter, 0.0, wall);
      packing.discs.add(-0.5 * packing.width + plan.diameter * (static_cast<double>(i) + 0.5),
                        side * 0.5 * (packing.height + plan.diameter), 0.0, 0.0);
    }
  }
}

/// Discs placed so far, in a grid of cells as wide as the largest disc.
class Room {
 public:
  explicit Room(const Packing& packing)
      : packing_{packing},
        largest_{2.0 * *std::max_element(packing.shapes.radius.begin(), packing.shapes.radius.end())},
        columns_{cells(packing.width)},
        rows_{cells(packing.height)},
        cells_(static_cast<std::size_t>(columns_ * rows_)) {}

  /// Whether there is room for a disc of that radius.
  bool free(Vec2 at, double radius) const {
    const long column = cell_of(at.x, packing_.width, columns_), row = cell_of(at.y, packing_.height, rows_);
    for (long c = column - 1; c <= column + 1; ++c) {
      for (long r = row - 1; r <= row + 1; ++r) {
        for (const std::size_t other : cells_[cell(c, r)]) {
          const Vec2 d{packing_.discs.x[other] - at.x, packing_.discs.y[other] - at.y};
          const Vec2 apart = d + packing_.box.shift(packing_.box.nearest(d, 0.0), 0.0);
          const double radii = packing_.shapes.radius[other] + radius;
          if (dot(apart, apart) < radii * radii) return false;
        }
      }
    }
    return true;
  }
  void put(std::size_t disc, Vec2 at) {
    cells_[cell(cell_of(at.x, packing_.width, columns_), cell_of(at.y, packing_.height, rows_))].push_back(disc);
  }

 private:
  long cells(double length) const { return std::max(1L, static_cast<long>(std::floor(length / largest_))); }
  static long cell_of(double at, double length, long count) {
    return std::clamp(static_cast<long>(std::floor((at / length + 0.5) * static_cast<double>(count))), 0L, count - 1);
  }
  std::size_t cell(long column, long row) const {
    const long c = (column + columns_) % columns_, r = (row + rows_) % rows_;
    return static_cast<std::size_t>(r * columns_ + c);
  }

  const Packing& packing_;
  double largest_;
  long columns_, rows_;
  std::vector<std::vector<std::size_t>> cells_;
};

/// Scales the radii of a packing and places its discs at random.
void put_down(const PackingPlan& plan, double scale, Packing& packing, std::mt19937_64& random) {
  constexpr int maximum = 20000;
  for (double& radius : packing.shapes.radius)
    radius *= scale;
  Room room{packing};
  for (std::size_t i = 0; i < plan.discs; ++i) {
    const double radius = packing.shapes.radius[i];
    const double up = 0.5 * packing.height - (plan.walls ? radius : 0.0);
    for (int attempt = 0;; ++attempt) {
      if (attempt == maximum || up < 0.0) {
        throw InputError{
            fmt::format("solid_fraction of a packing: found {}; disc {} of {} has no room in {} random places, and it "
                        "must be less, or the packing grown",
                        plan.solid_fraction, i + 1, plan.discs, maximum)};
      }
      const double x = 0.5 * packing.width * symmetric(random), y = up * symmetric(random);
      if (!room.free({x, y}, radius)) continue;
      packing.discs.add(x, y, 0.0, 0.0);
      room.put(i, {x, y});
      break;
    }
  }
}

/// Duration of a contact, over the time in which a disc of the middle size moves by its diameter: the unit of time.
constexpr double contact_time = 0.01;

DiscSystem<LinearSpringDashpot> pushed(const PackingPlan& plan, const Packing& packing, double scale,
                                       double damping_ratio) {
  const double w = std::numbers::pi / contact_time, reduced_mass = 0.5 * plan.mass;
  const LinearSpringDashpot law{reduced_mass * w * w, 2.0 * damping_ratio * reduced_mass * w, EndRule::clamped};
  DiscShapes shapes = packing.shapes;
  for (std::size_t i = 0; i < plan.discs; ++i)
    shapes.radius[i] *= scale;
  return {std::move(shapes), packing.box, law, 0.2 * plan.diameter};
}

void run(DiscSystem<LinearSpringDashpot>& system, Discs& discs, int steps) {
  const EulerCromerOf<Discs> method;
  for (int n = 0; n < steps; ++n)
    method.step(system, discs, contact_time / 10.0);
}

/// Lets discs move and collide while their radii grow from `scale` to 1 times their final value, slower than the discs
/// move by the factor `slower`.
void grow_from(const PackingPlan& plan, double scale, Packing& packing) {
  constexpr double slower = 100.0;
  constexpr int stage = 50;
  const double growth = 2.0 * stage * contact_time / 10.0 / slower;
  const double temperature = plan.mass * plan.diameter * plan.diameter;
  agitate(packing, temperature, plan.seed);
  while (scale < 1.0) {
    scale = std::min(1.0, scale + growth);
    DiscSystem system = pushed(plan, packing, scale, 0.0);
    system.begin(packing.discs);
    run(system, packing.discs, stage);
    // Growth adds kinetic energy: restore the temperature.
    const double had = talus::temperature(packing.shapes, packing.discs, {});
    for (std::size_t i = 0; i < plan.discs; ++i) {
      packing.discs.vx[i] *= std::sqrt(temperature / had);
      packing.discs.vy[i] *= std::sqrt(temperature / had);
    }
  }
}

void push_apart(const PackingPlan& plan, Packing& packing) {
  constexpr double farther = 1.001;
  constexpr int stage = 200, maximum = 500;
  DiscSystem system = pushed(plan, packing, farther, 0.3);
  std::fill(packing.discs.vx.begin(), packing.discs.vx.end(), 0.0);
  std::fill(packing.discs.vy.begin(), packing.discs.vy.end(), 0.0);
  system.begin(packing.discs);
  for (int n = 0; closest(packing) < 1.0; ++n) {
    if (n == maximum) {
      throw InputError{fmt::format(
          "solid_fraction of a packing: found {}; the discs still overlap by {:.1e} of their diameter, and it must be "
          "less",
          plan.solid_fraction, 1.0 - closest(packing))};
    }
    run(system, packing.discs, stage);
  }
}

}  // namespace

Packing scatter(const PackingPlan& plan) {
  std::mt19937_64 random{plan.seed};
  Packing packing = empty(plan, random);
  put_down(plan, 1.0, packing, random);
  if (plan.walls) add_walls(plan, packing);
  return packing;
}

Packing grow(const PackingPlan& plan) {
  constexpr double first_fraction = 0.2;
  std::mt19937_64 random{plan.seed};
  Packing packing = empty(plan, random);
  const std::vector<double> radius = packing.shapes.radius;
  const double scale = std::sqrt(std::min(1.0, first_fraction / plan.solid_fraction));
  put_down(plan, scale, packing, random);
  packing.shapes.radius = radius;
  if (plan.walls) add_walls(plan, packing);
  if (scale < 1.0) {
    grow_from(plan, scale, packing);
    push_apart(plan, packing);
  }
  Discs at_rest;
  for (std::size_t i = 0; i < packing.discs.size(); ++i)
    at_rest.add(packing.discs.x[i], packing.discs.y[i], 0.0, 0.0);
  packing.discs = std::move(at_rest);
  wrap(packing.box, packing.discs);
  return packing;
}

double closest(const Packing& packing) {
  constexpr double maximum = 1.1;
  const double largest = *std::max_element(packing.shapes.radius.begin(), packing.shapes.radius.end());
  NeighbourList list{packing.box, (maximum - 1.0) * 2.0 * largest};
  Discs discs = packing.discs;
  wrap(packing.box, discs);
  list.build(packing.shapes, discs);
  double smallest = maximum;
  list.for_each_pair(discs, [&](std::size_t i, std::size_t j, std::size_t, Vec2 d, const auto&) {
    smallest = std::min(smallest, norm(d) / (packing.shapes.radius[i] + packing.shapes.radius[j]));
  });
  return smallest;
}

void agitate(Packing& packing, double temperature, std::uint64_t seed) {
  std::mt19937_64 random{seed};
  const auto drawn = [&] {
    double sum = 0.0;
    for (int k = 0; k < 12; ++k)
      sum += symmetric(random);
    return sum;
  };
  const DiscShapes& shapes = packing.shapes;
  Discs& discs = packing.discs;
  double mass = 0.0;
  Vec2 momentum;
  for (std::size_t i = 0; i < shapes.size(); ++i) {
    if (shapes.wall[i] != DiscShapes::free) continue;
    const double m = 1.0 / shapes.inverse_mass[i], part = std::sqrt(shapes.inverse_mass[i]);
    const double vx = part * drawn(), vy = part * drawn();
    discs.vx[i] = vx, discs.vy[i] = vy;
    mass += m, momentum += m * Vec2{vx, vy};
  }
  const Vec2 mean = (1.0 / mass) * momentum;
  for (std::size_t i = 0; i < shapes.size(); ++i) {
    if (shapes.wall[i] == DiscShapes::free) discs.vx[i] -= mean.x, discs.vy[i] -= mean.y;
  }
  const double had = talus::temperature(shapes, discs, {});
  if (!(had > 0.0) && temperature > 0.0) {
    throw InputError{
        fmt::format("temperature: found {}, of discs of which fewer than two are free; without momentum "
                    "a single one is at rest",
                    temperature)};
  }
  const double scale = had > 0.0 ? std::sqrt(temperature / had) : 0.0;
  for (std::size_t i = 0; i < shapes.size(); ++i) {
    if (shapes.wall[i] == DiscShapes::free) discs.vx[i] *= scale, discs.vy[i] *= scale;
  }
}

}  // namespace talus
