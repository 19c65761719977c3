#include "solver/granular/stress.hpp"

namespace talus {
namespace {

/// Calls visit(disc, mass) for the free discs.
template <class Visit>
void for_each_free(const DiscShapes& shapes, Visit&& visit) {
  for (std::size_t i = 0; i < shapes.size(); ++i) {
    if (shapes.wall[i] == DiscShapes::free && shapes.inverse_mass[i] > 0.0) visit(i, 1.0 / shapes.inverse_mass[i]);
  }
}

Vec2 relative(const Discs& discs, const MeanFlow& flow, std::size_t disc) {
  return {discs.vx[disc] - flow.at(discs.y[disc]), discs.vy[disc]};
}

}  // namespace

MeanFlow mean_flow(const DiscShapes& shapes, const Discs& discs, double shear_rate) {
  const MeanFlow sheared{0.0, shear_rate};
  double mass = 0.0, momentum = 0.0;
  for_each_free(shapes, [&](std::size_t i, double m) { mass += m, momentum += m * relative(discs, sheared, i).x; });
  return {mass > 0.0 ? momentum / mass : 0.0, shear_rate};
}

double temperature(const DiscShapes& shapes, const Discs& discs, const MeanFlow& flow) {
  double energy = 0.0, count = 0.0;
  for_each_free(shapes, [&](std::size_t i, double m) {
    const Vec2 c = relative(discs, flow, i);
    energy += 0.5 * m * dot(c, c), count += 1.0;
  });
  return count > 0.0 ? energy / count : 0.0;
}

Virial kinetic_virial(const DiscShapes& shapes, const Discs& discs, const MeanFlow& flow) {
  Virial sum;
  for_each_free(shapes, [&](std::size_t i, double m) {
    const Vec2 c = relative(discs, flow, i);
    sum.add(m * c, c);
  });
  return sum;
}

}  // namespace talus
