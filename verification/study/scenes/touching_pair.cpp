#include "verification/study/scenes/touching_pair.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "solver/model/model_builder.hpp"

namespace talus::verification::problems {
namespace {

bool is_ground(const Shape& shape) {
  return std::holds_alternative<HalfPlane>(shape) || std::holds_alternative<Terrain>(shape);
}

}  // namespace

Model pair_model(const TouchingPair& pair, double stiffness) {
  ModelBuilder builder{si};
  const auto body = [&](const char* name, const Shape& shape) {
    return builder.add(Body{.name = name,
                            .mobility = is_ground(shape) ? Mobility::fixed : Mobility::free,
                            .mass = 1.0,
                            .inertia = 1.0,
                            .shape = shape});
  };
  const BodyId a = body("a", pair.a), b = body("b", pair.b);
  builder.add(Contact{.name = "touch",
                      .a = a,
                      .b = b,
                      .law = LinearSpringDashpot{stiffness, 0.0, EndRule::clamped},
                      .method = pair.method,
                      .nodes = {12, 12},
                      .node_depth = pair.rule});
  return builder.build();
}

CornerLoop round_corner(const Model& model, int steps, double moments) {
  Potential potential{model};
  State state = rest_state(model);
  CornerLoop loop;
  std::vector<double> before, forces;
  std::array<double, 3> from{};
  for (int i = 0; i <= steps; ++i) {
    const double round = 2.0 * std::numbers::pi * i / steps;
    const std::array position{CornerLoop::corner.x + CornerLoop::radius * std::cos(round),
                              CornerLoop::corner.y + CornerLoop::radius * std::sin(round), 0.2 + 0.4 * std::sin(round)};
    std::copy(position.begin(), position.end(), state.q.begin());
    potential.evaluate(state);
    forces = potential.forces(state);
    forces[2] *= moments;
    for (std::size_t k = 0; k < 3 && i > 0; ++k)
      loop.work += 0.5 * (before[k] + forces[k]) * (position[k] - from[k]);
    const double stored = potential.energy(state);
    loop.energy = std::max(loop.energy, stored);
    if (i % (steps / 200) == 0) {
      loop.angle.push_back(round * 180.0 / std::numbers::pi);
      loop.stored.push_back(stored);
    }
    before = forces;
    from = position;
  }
  return loop;
}

}  // namespace talus::verification::problems
