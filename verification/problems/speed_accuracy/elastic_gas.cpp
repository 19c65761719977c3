#include "verification/problems/speed_accuracy/elastic_gas.hpp"

#include <fmt/format.h>

#include <cmath>
#include <numbers>
#include <vector>

#include "solver/model/model_builder.hpp"
#include "verification/study/scene_run.hpp"

namespace talus::verification::problems {
namespace {

/// Numbers evenly spread over (0, 1), the same everywhere (a multiplicative congruence, Lehmer's).
class Draw {
 public:
  explicit Draw(std::uint64_t seed) : state_{seed * 2654435761u % modulus + 1} {
    for (int i = 0; i < 20; ++i)
      (void)(*this)();
  }
  double operator()() {
    state_ = state_ * 48271u % modulus;
    return static_cast<double>(state_) / static_cast<double>(modulus);
  }

 private:
  static constexpr std::uint64_t modulus = 2147483647u;
  std::uint64_t state_;
};

constexpr double half_box = 11.0, speed = 4e-3;  // radius 1, mass 1, w = 1

/// Springs of k = 1/2 between discs, whose effective mass is 1/2, and of 1 against walls: w = 1 everywhere.
Scene gas(std::uint64_t seed) {
  ModelBuilder builder;
  Draw draw{seed};
  std::vector<BodyId> discs, walls;
  for (int i = 0; i < gas_discs; ++i) {
    const double column = i % 5, row = i / 5;
    const Vec2 place{4.2 * (column - 2.0) + draw() - 0.5, 4.2 * (row - 2.0) + draw() - 0.5};
    discs.push_back(builder.add({.name = fmt::format("disc{}", i),
                                 .mobility = Mobility::particle,
                                 .mass = 1.0,
                                 .shape = Circle{1.0},
                                 .p_WB = place}));
  }
  const Vec2 places[] = {{0.0, -half_box}, {half_box, 0.0}, {0.0, half_box}, {-half_box, 0.0}};
  for (int i = 0; i < 4; ++i) {
    walls.push_back(builder.add({.name = fmt::format("wall{}", i),
                                 .mobility = Mobility::fixed,
                                 .shape = HalfPlane{},
                                 .p_WB = places[i],
                                 .angle = 0.5 * std::numbers::pi * i}));
  }
  const LinearSpringDashpot soft{0.5, 0.0, EndRule::clamped}, hard{1.0, 0.0, EndRule::clamped};
  for (std::size_t i = 0; i < discs.size(); ++i) {
    for (std::size_t j = i + 1; j < discs.size(); ++j)
      builder.add(Contact{.name = fmt::format("pair{}_{}", i, j), .a = discs[i], .b = discs[j], .law = soft});
    for (std::size_t j = 0; j < walls.size(); ++j)
      builder.add(Contact{.name = fmt::format("wall{}_{}", i, j), .a = discs[i], .b = walls[j], .law = hard});
  }
  Scene scene{.title = "Gas in a box", .model = builder.build()};
  scene.initial = rest_state(scene.model);
  for (const BodyId disc : discs) {
    const double angle = 2.0 * std::numbers::pi * draw(), size = speed * std::sqrt(-2.0 * std::log(draw()));
    set_velocity(scene.model, scene.initial, disc, {size * std::cos(angle), size * std::sin(angle)}, 0.0);
  }
  return scene;
}

}  // namespace

GasRun run_gas(double eta, std::uint64_t seed, long collisions, const Setup& setup) {
  const Scene scene = gas(seed);
  std::vector<Mode> before(scene.initial.mode.size(), 0);
  GasRun gas;
  double first = 0.0, last = 0.0;
  // Contacts have one law instance each, whose mode is 0 while open.
  const Until enough = [&](const State& seen) {
    bool open = true;
    for (std::size_t i = 0; i < before.size(); ++i) {
      if (seen.mode[i] != 0) open = false;
      if (seen.mode[i] != 0 && before[i] == 0) ++gas.collisions;
    }
    before = seen.mode;
    if (!open) return false;
    last = 0.0;
    for (const double v : seen.v)
      last += 0.5 * v * v;
    if (first == 0.0) first = last;
    return gas.collisions >= collisions;
  };
  const char* method = setup.has("gas_by_rk4") ? "rk4" : "velocity_verlet";
  run_scene(scene, make_integrator(method), {eta, 2e7 * eta, eta, false}, nullptr, {}, enough);
  gas.ln_heating = gas.collisions >= collisions ? std::log(last / first) : std::nan("");
  return gas;
}

}  // namespace talus::verification::problems
