#include "verification/problems/touching_pair.hpp"

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

}  // namespace talus::verification::problems
