#include "verification/study/scenes/turned_pair.hpp"

#include "solver/model/model_builder.hpp"

namespace talus::verification::problems::turned_pair {

Model model() {
  ModelBuilder builder;
  const BodyId a = builder.add(Body{.name = "a", .mass = 1.0, .inertia = 0.5, .shape = Circle{radius_a}});
  const BodyId b =
      builder.add(Body{.name = "b", .mass = 1.0, .inertia = 0.125, .shape = Circle{radius_b}, .p_WB = {distance, 0.0}});
  builder.add(Contact{.name = "touch",
                      .a = a,
                      .b = b,
                      .law = LinearSpringDashpot{normal_stiffness, 0.0},
                      .friction = CoulombFriction{10.0, slip_stiffness}});
  return builder.build();
}

void set_pair(State& state, double angle, double turn, bool b_spins) {
  constexpr Vec2 from_pivot_a{-0.3, 0.7};
  const auto centre = [&](Vec2 p, double at) {
    return Vec2{p.x * std::cos(at) - p.y * std::sin(at), p.x * std::sin(at) + p.y * std::cos(at)};
  };
  for (std::size_t body = 0; body < 2; ++body) {
    const Vec2 p = from_pivot_a + Vec2{body == 0 ? 0.0 : distance, 0.0};
    const Vec2 now = centre(p, angle), next = centre(p, angle + turn);
    const double spin = body == 1 && !b_spins ? 0.0 : 1.0;
    const std::size_t i = 3 * body;
    state.q[i] = now.x, state.q[i + 1] = now.y, state.q[i + 2] = spin * angle;
    state.v[i] = next.x - now.x, state.v[i + 1] = next.y - now.y, state.v[i + 2] = spin * turn;
  }
}

}  // namespace talus::verification::problems::turned_pair
