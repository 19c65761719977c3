#include "verification/problems/program/agreement/fence_contacts.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <limits>
#include <numeric>

namespace talus::verification::problems::agreeing_files {
namespace {

/// Two outlines in a row: their overlap, the point and the normal from the first to the second.
struct Touch {
  double overlap{};
  Vector point{}, normal{};
};

/// A vector in the axes of a body, in the world.
Vector direction(const Run& run, const Part& body, double u, double v, std::size_t row) {
  const double turned = run.of(body, ".angle", row, 0.0), c = std::cos(turned), s = std::sin(turned);
  return {c * u - s * v, s * u + c * v, 0.0};
}
double dot(const Vector& a, const Vector& b) { return a[0] * b[0] + a[1] * b[1]; }

Touch of_rocks(const Run& run, const Part& a, const Part& b, std::size_t row) {
  const Vector from = run.position(a, 0.0, 0.0, row), along = between(from, run.position(b, 0.0, 0.0, row));
  const double distance = size(along), overlap = a.a + b.a - distance, reach = a.a - 0.5 * overlap;
  const Vector normal{along[0] / distance, along[1] / distance, 0.0};
  return {overlap, {from[0] + reach * normal[0], from[1] + reach * normal[1], 0.0}, normal};
}

/// The rocks are in front of the columns, whose x-axes point towards them.
Touch of_face(const Run& run, const Part& rock, const Part& column, std::size_t row) {
  const Vector at = run.position(rock, 0.0, 0.0, row), x = direction(run, column, 1.0, 0.0, row);
  const double overlap = rock.a - (dot(between(run.position(column, 0.0, 0.0, row), at), x) - column.a),
               reach = rock.a - 0.5 * overlap;
  return {overlap, {at[0] - reach * x[0], at[1] - reach * x[1], 0.0}, {-x[0], -x[1], 0.0}};
}

/// The upper (1) or lower (-1) ends of the faces of two columns, of which `back` is behind `front`.
Touch of_ends(const Run& run, const Part& front, const Part& back, double end, std::size_t row) {
  const Vector corner = run.position(front, -front.a, end * front.b, row),
               other = run.position(back, back.a, end * back.b, row), of_front = direction(run, front, 0.0, end, row),
               of_back = direction(run, back, 0.0, end, row), apart = between(corner, other);
  // The corner nearer to the middle is below the face of the other column.
  const bool other_is_nearer = dot(apart, of_front) + dot(apart, of_back) <= 0.0;
  const Vector normal = direction(run, other_is_nearer ? front : back, -1.0, 0.0, row);
  return {-dot(apart, normal), other_is_nearer ? other : corner, normal};
}

/// Velocity of the first body relative to the second at a point.
Vector relative_velocity(const Run& run, const Part& a, const Part& b, const Vector& point, std::size_t row) {
  const auto at = [&](const Part& body) {
    const Vector arm = between(run.position(body, 0.0, 0.0, row), point);
    const double spin = run.of(body, ".spin", row, 0.0);
    return Vector{run.of(body, ".vx", row, 0.0) - spin * arm[1], run.of(body, ".vy", row, 0.0) + spin * arm[0], 0.0};
  };
  return between(at(b), at(a));
}

double effective_mass(const Run& run, const Part& a, const Part& b, const Touch& touch, std::size_t row) {
  double inverse = 0.0;
  for (const Part* body : {&a, &b}) {
    const Vector arm = between(run.position(*body, 0.0, 0.0, row), touch.point);
    const double turning = arm[0] * touch.normal[1] - arm[1] * touch.normal[0];
    inverse += 1.0 / body->mass + turning * turning / body->inertia;
  }
  return 1.0 / inverse;
}

using Geometry = std::function<Touch(std::size_t row)>;

FenceSpring spring_of(const Run& run, const Part& a, const Part& b, double overlap, const Geometry& touch) {
  FenceSpring spring;
  spring.contact = a.name + "-" + b.name;
  const double speed = std::abs(rocks.front().speed) / overlap;
  spring.stiffness = a.mass * b.mass / (a.mass + b.mass) * speed * speed;
  for (std::size_t row = 0; row < run.rows(); ++row) {
    const Touch now = touch(row);
    spring.overlap.push_back(now.overlap);
    spring.rate.push_back(dot(relative_velocity(run, a, b, now.point, row), now.normal));
  }
  spring.start_mass = effective_mass(run, a, b, touch(0), 0);
  return spring;
}

std::size_t touch_row(const FenceSpring& spring) {
  const auto found = std::ranges::find_if(spring.overlap, [](double overlap) { return overlap >= 0.0; });
  return static_cast<std::size_t>(found - spring.overlap.begin());
}

/// Where between two rows a number passes through zero, as a fraction of the interval.
double zero_between(double first, double last) { return first / (first - last); }

}  // namespace

std::vector<FenceSpring> fence_springs(const Run& run) {
  struct Pair {
    const Part &a, &b;
    double overlap;
    Geometry touch;
  };
  const Part &rock1 = run.body("rock1"), &rock2 = run.body("rock2"), &front = run.body("column1"),
             &back = run.body("back_column1");
  std::vector<Pair> pairs;
  for (const Part* rock : {&rock1, &rock2})
    pairs.push_back({*rock, front, rock_overlap,
                     [&run, rock, &front](std::size_t row) { return of_face(run, *rock, front, row); }});
  pairs.push_back({rock1, rock2, rock_overlap, [&](std::size_t row) { return of_rocks(run, rock1, rock2, row); }});
  for (const double end : {-1.0, 1.0})
    pairs.push_back({front, back, layer_overlap,
                     [&run, &front, &back, end](std::size_t row) { return of_ends(run, front, back, end, row); }});
  std::vector<FenceSpring> springs;
  for (const Pair& pair : pairs)
    springs.push_back(spring_of(run, pair.a, pair.b, pair.overlap, pair.touch));
  // Of two springs of one contact, the first to touch acts alone in its first row.
  std::vector<std::size_t> order(springs.size());
  std::iota(order.begin(), order.end(), 0U);
  std::ranges::sort(order, {}, [&](std::size_t i) { return touch_row(springs[i]); });
  for (const std::size_t i : order) {
    FenceSpring& spring = springs[i];
    const Pair& pair = pairs[i];
    const std::size_t row = touch_row(spring);
    if (row == run.rows()) continue;
    double force = run.history.at(spring.contact + ".force")[row];
    for (const FenceSpring& other : springs)
      if (&other != &spring && other.contact == spring.contact) force -= other.force(row);
    spring.damping = (force - spring.stiffness * spring.overlap[row]) / spring.rate[row];
    const auto mass_in = [&](std::size_t of) { return effective_mass(run, pair.a, pair.b, pair.touch(of), of); };
    double mass = mass_in(row), change = 0.0;
    if (row > 0) {
      const double before = mass_in(row - 1), part = zero_between(spring.overlap[row - 1], spring.overlap[row]);
      change = std::abs(mass - before) / mass, mass = before + part * (mass - before);
    }
    spring.damping_ratio = spring.damping / (2.0 * std::sqrt(spring.stiffness * mass));
    spring.ratio_bound = 0.5 * change * spring.damping_ratio;
  }
  return springs;
}

std::vector<double> damped_energy(const Run& run, const std::vector<FenceSpring>& springs, std::size_t every) {
  std::vector<double> sum(run.rows(), 0.0);
  for (std::size_t row = 1; row < run.rows(); ++row) {
    sum[row] = sum[row - 1];
    if (row % every != 0) continue;
    const std::size_t before = row - every;
    for (const FenceSpring& spring : springs) {
      const bool acted = spring.acts(before), acts = spring.acts(row);
      if (!acted && !acts) continue;
      double from = 0.0, to = 1.0;
      if (acted != acts) {
        const bool touches = acts && spring.overlap[before] < 0.0;
        const double end = touches ? zero_between(spring.overlap[before], spring.overlap[row])
                                   : zero_between(spring.sum(before), spring.sum(row));
        (acts ? from : to) = end;
      }
      const auto power = [&](double part) {
        const double rate = spring.rate[before] + part * (spring.rate[row] - spring.rate[before]);
        return spring.damping * rate * rate;
      };
      sum[row] += 0.5 * (to - from) * (run.time(row) - run.time(before)) * (power(from) + power(to));
    }
  }
  return sum;
}

Released released_energy(const Run& run, const std::vector<FenceSpring>& springs) {
  Released released{.energy = std::vector<double>(run.rows(), 0.0)};
  for (std::size_t row = 1; row < run.rows(); ++row) {
    released.energy[row] = released.energy[row - 1];
    for (const FenceSpring& spring : springs) {
      if (!spring.acts(row - 1) || spring.acts(row) || spring.overlap[row] <= 0.0) continue;
      const double before = spring.overlap[row - 1], part = zero_between(spring.sum(row - 1), spring.sum(row)),
                   overlap = before + part * (spring.overlap[row] - before);
      released.energy[row] += 0.5 * spring.stiffness * overlap * overlap;
      released.bound =
          std::max(released.bound,
                   0.5 * spring.stiffness * std::abs(before * before - spring.overlap[row] * spring.overlap[row]));
    }
  }
  return released;
}

std::vector<double> slipping_energy(const Run& run, const std::vector<FenceSpring>& springs) {
  const FenceSpring& spring = springs.front();
  const Part &rock = run.body("rock1"), &column = run.body("column1");
  std::vector<double> energy(run.rows(), std::numeric_limits<double>::quiet_NaN());
  double slipped = 0.0, before = 0.0;
  bool slips = false;
  for (std::size_t row = 0; row < run.rows(); ++row) {
    const Touch touch = of_face(run, rock, column, row);
    const Vector along{-touch.normal[1], touch.normal[0], 0.0};
    const double slip_rate = dot(relative_velocity(run, rock, column, touch.point, row), along);
    const bool alone = std::ranges::none_of(
        springs, [&](const FenceSpring& other) { return &other != &spring && other.overlap[row] >= 0.0; });
    if (!alone || slip_rate * before < 0.0) break;
    if (row > 0) slipped += 0.5 * (run.time(row) - run.time(row - 1)) * (before + slip_rate);
    before = slip_rate;
    const double limit = fence_friction * spring.force(row), stretch = limit / spring.stiffness;
    slips = slips || spring.stiffness * std::abs(slipped) + spring.damping * std::abs(slip_rate) > limit;
    if (slips) energy[row] = spring.stored(row) + 0.5 * spring.stiffness * stretch * stretch;
  }
  return energy;
}

}  // namespace talus::verification::problems::agreeing_files
