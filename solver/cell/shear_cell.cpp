#include "solver/cell/shear_cell.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <complex>
#include <limits>
#include <numbers>
#include <random>

#include "solver/base/error.hpp"
#include "solver/granular/list_skin.hpp"
#include "solver/granular/neighbour_list.hpp"
#include "solver/granular/random_draw.hpp"

namespace talus {
namespace {

using CellErrors = std::vector<CellError>;

void object(CellErrors& found, std::string_view field, double value, std::string_view allowed) {
  found.push_back({std::string{field}, fmt::format("found {}; it must be {}", value, allowed)});
}

/// Force of a contact at rest [F].
template <Law L>
double static_force(const L& law, double overlap) {
  return law(Kinematics{overlap, 0.0}, std::array<double, L::memory_size>{}, 1).total();
}

/// Stiffness of a contact by a linear law while it loads [F/L].
template <Law L>
requires HasLinearPart<L>
double loading_stiffness(const L& law) { return law.linear_part(std::array<double, L::memory_size>{}, 1).stiffness; }

/// Adds the errors of a law that is not linear: its impacts at the nominal speed must have a duration, and end. They
/// are not evaluated for dashpots so strong that the restitution would be below about 1e-6.
template <Law L>
void add_impact_errors(CellErrors& found, const L& law, const ShearCell& cell) {
  const double effective_mass = 0.5 * cell.mass, speed = cell.nominal_speed();
  if (!(speed > 0.0) || !std::isfinite(speed)) {
    object(found, "impact_speed", speed, fmt::format("> 0 for the law {}, and block_speed = 0 gives none", L::name));
    return;
  }
  constexpr auto loss = restitution_parameter<L>();
  L elastic = law;
  elastic.*loss.member = 0.0;
  const double overlap = elastic.largest_overlap(effective_mass, speed);
  const double time = elastic.contact_time(effective_mass, speed);
  const LawForce force = law(Kinematics{overlap, speed}, {}, 1);
  if (!(overlap > 0.0) || !std::isnormal(time) || !std::isnormal(force.elastic)) {
    object(found, "impact_speed", speed,
           fmt::format("such that impacts have a duration; by {} it is {:g}", L::name, time));
    return;
  }
  constexpr double strongest = 1e3;
  if (!(force.dissipative <= strongest * force.elastic)) {
    object(found, loss.name, law.*loss.member,
           fmt::format("at most {:.4g}: with it the damping force of an impact at the speed {:.4g} is {:g} times that "
                       "of the spring",
                       law.*loss.member * strongest * force.elastic / force.dissipative, speed, strongest));
  } else if (!std::isfinite(law.contact_time(effective_mass, speed))) {
    object(found, loss.name, law.*loss.member, "smaller: with this end rule overdamped contacts never separate");
  }
}

/// Adds the errors of the law's parameters.
template <Law L>
void add_errors(CellErrors& found, const L& law, const ShearCell& cell) {
  const double effective_mass = 0.5 * cell.mass;
  for (const auto& field : L::fields()) {
    if (!contains(field.range, law.*field.member)) object(found, field.name, law.*field.member, text_of(field.range));
  }
  const bool is_in_range = found.empty();
  if constexpr (HasOrders<L>) {
    for (const auto& order : L::orders()) {
      if (law.*order.larger >= law.*order.smaller) continue;
      object(found, field_name(order.larger), law.*order.larger,
             fmt::format("at least the {}, {}: {}", field_name(order.smaller), law.*order.smaller, order.why));
    }
  }
  if constexpr (HasDampingRatio<L>) {
    if (law.damping_ratio != 0.0)
      object(found, "damping_ratio", law.damping_ratio, "0: the dashpots of discs do not depend on the masses");
  }
  if constexpr (HasLinearPart<L> && HasDamping<L>) {
    const double infinite = std::numeric_limits<double>::infinity();
    if (is_in_range && effective_mass > 0.0 && law.contact_time(effective_mass, 0.0) == infinite) {
      const double critical = 2.0 * std::sqrt(loading_stiffness(law) * effective_mass);
      object(found, "damping", law.damping,
             fmt::format("< {}: with this end rule overdamped contacts never separate", critical));
    }
  }
}

/// Adds the errors of friction, which depends on the radius of the law, if it depends on one.
template <Law L, IsDiscFriction F>
void add_errors(CellErrors& found, const L& law, const F& friction) {
  if constexpr (!CanHaveFriction<L, F>) {
    found.push_back(
        {"shear_law",
         fmt::format("found {} with the law {}, which has no contact radius; it must be linear", F::name, L::name)});
  } else {
    for (const auto& field : F::fields()) {
      const double value = friction.*field.member;
      if (!contains(field.range, value)) object(found, field.name, value, text_of(field.range));
    }
    if (friction.damping != 0.0)
      object(found, "shear_damping", friction.damping, "0: contacts of discs have no tangential dashpot");
    if constexpr (HasContactRadius<F>) {
      if (friction.radius != law.radius)
        object(found, "radius", friction.radius, fmt::format("that of the law, {}", law.radius));
    }
  }
}

}  // namespace

bool ShearCell::is_linear() const {
  return std::visit([]<class L>(const L&) { return HasLinearPart<L>; }, law);
}
double ShearCell::nominal_speed() const {
  if (is_linear()) return 0.0;
  return impact_speed > 0.0 ? impact_speed : std::abs(block_speed) / (rows + 1);
}
double ShearCell::nominal_overlap() const {
  return std::visit(
      [&](const auto& of) {
        const double load = block_mass * gravity / wall_discs;
        double low = 0.0, high = diameter;
        for (int pass = 0; pass < 60; ++pass) {
          const double middle = 0.5 * (low + high);
          (static_force(of, middle) < load ? low : high) = middle;
        }
        return std::min(std::max(high, of.largest_overlap(0.5 * mass, nominal_speed())), diameter);
      },
      law);
}
double ShearCell::stiffness() const {
  return std::visit(
      [&]<class L>(const L& of) {
        if constexpr (HasLinearPart<L>) return loading_stiffness(of);
        const double overlap = nominal_overlap();
        return static_force(of, overlap) / overlap;
      },
      law);
}
double ShearCell::largest_stiffness() const {
  return std::visit(
      [&]<class L>(const L& of) {
        if constexpr (HasLinearPart<L>) return of.tangent().stiffness;
        // The difference quotient of a power is exact to the square of the relative difference.
        const double overlap = nominal_overlap(), by = 0x1p-14 * overlap;
        return (static_force(of, overlap + by) - static_force(of, overlap - by)) / (2.0 * by);
      },
      law);
}
double ShearCell::shear_stiffness() const {
  return std::visit(
      [&]<class F>(const F& of) { return of.at(has_varying_stiffness<F> ? nominal_overlap() : 0.0).stiffness; },
      *friction);
}
double ShearCell::loading_frequency() const { return std::sqrt(2.0 * stiffness() / mass); }
double ShearCell::contact_time() const {
  return std::visit([&](const auto& of) { return of.contact_time(0.5 * mass, nominal_speed()); }, law);
}
double ShearCell::restitution() const {
  return std::visit([&](const auto& of) { return of.restitution(0.5 * mass, nominal_speed()); }, law);
}
const LatchingSpring* ShearCell::law_of_1989() const {
  const auto* latching = std::get_if<LatchingSpring>(&law);
  return latching != nullptr && latching->growth == 0.0 && !friction ? latching : nullptr;
}
double ShearCell::density() const { return mass / (0.25 * std::numbers::pi * diameter * diameter * diameter); }

std::vector<CellError> validation_errors(const ShearCell& cell) {
  CellErrors found;
  const auto demand = [&](bool holds, std::string_view field, double value, std::string_view allowed) {
    if (!holds) object(found, field, value, allowed);
  };
  const auto demand_range = [&](Range range, std::string_view field, double value) {
    demand(contains(range, value), field, value, text_of(range));
  };
  std::visit([&](const auto& law) { add_errors(found, law, cell); }, cell.law);
  demand_range(Range::non_negative, "impact_speed", cell.impact_speed);
  if (cell.friction)
    std::visit([&](const auto& law, const auto& friction) { add_errors(found, law, friction); }, cell.law,
               *cell.friction);
  for (const auto& field : ShearCell::fields())
    demand_range(field.range, field.name, cell.*field.member);
  for (const auto& field : ShearCell::counts()) {
    const int value = cell.*std::get<int ShearCell::*>(field.member);
    demand(value >= field.minimum && value <= field.maximum, field.name, value,
           fmt::format("a whole number between {} and {}", field.minimum, field.maximum));
  }
  if (cell.columns > cell.wall_discs) {
    demand(false, "columns", cell.columns,
           fmt::format("at most the discs of a wall, {}: more do not fit beside each other", cell.wall_discs));
  }
  if (cell.rows > 0 && cell.columns > 0 && cell.free_discs() > ShearCell::maximum_discs) {
    demand(false, "rows", cell.rows,
           fmt::format("at most {} of {} columns: a cell has at most {} free discs",
                       ShearCell::maximum_discs / static_cast<std::size_t>(cell.columns), cell.columns,
                       ShearCell::maximum_discs));
  }
  if (found.empty()) {
    std::visit(
        [&]<class L>(const L& law) {
          if constexpr (!HasLinearPart<L>) add_impact_errors(found, law, cell);
        },
        cell.law);
  }
  // The frequency and damping ratio of a contact contain the square root of this product.
  constexpr double minimum = std::numeric_limits<double>::min();
  if (found.empty() && cell.is_linear() && !(cell.mass * cell.stiffness() >= minimum)) {
    demand(false, "stiffness", cell.stiffness(),
           fmt::format("at least {:.3g}: its product with the mass, {}, must be at least {:.3g}", minimum / cell.mass,
                       cell.mass, minimum));
  }
  return found;
}

ShearCell ice_cell(double overburden, double speed, std::uint64_t seed) {
  ShearCell cell{.law = LatchingSpring{1.7e4, 1.7e4 / 0.49, 0.0},
                 .diameter = 1e-3,
                 .mass = 7.2e-7,
                 .gravity = 9.81,
                 .block_mass = 0.0,
                 .rows = 8,
                 .columns = 10,
                 .wall_discs = 11,
                 .block_speed = 1e-3 * speed,
                 .seed = seed};
  cell.block_mass = overburden * cell.wall_discs * cell.diameter * cell.diameter / cell.gravity;
  return cell;
}

FilledCell fill(const ShearCell& cell) {
  if (const auto found = validation_errors(cell); !found.empty())
    throw InputError{fmt::format("{}: {}", found.front().field, found.front().message)};
  FilledCell filled{.shapes = {}, .discs = {}, .box = {.width = cell.width()}};
  const double radius = 0.5 * cell.diameter, left = -0.5 * cell.width();
  const double column = cell.width() / cell.columns, row = std::max(column, 1.05 * cell.diameter);
  const double top = row * (cell.rows + 1);
  std::mt19937_64 random{cell.seed};
  for (int r = 0; r < cell.rows; ++r) {
    for (int c = 0; c < cell.columns; ++c) {
      const double y = row * (r + 1);
      filled.shapes.add(radius, 1.0 / cell.mass);
      filled.discs.add(left + column * (c + 0.5), y, cell.block_speed * y / top,
                       0.01 * std::abs(cell.block_speed) * symmetric(random));
    }
  }
  const std::size_t base = filled.shapes.add(DiscWall{});
  const std::size_t block = filled.shapes.add(DiscWall{.mass = cell.block_mass, .gravity = cell.gravity});
  for (const std::size_t wall : {base, block}) {
    for (int c = 0; c < cell.wall_discs; ++c) {
      filled.shapes.add(radius, 0.0, wall);
      filled.discs.add(left + cell.diameter * (c + 0.5), wall == base ? 0.0 : top,
                       wall == base ? 0.0 : cell.block_speed, 0.0);
    }
  }
  return filled;
}

std::size_t first_block_disc(const ShearCell& cell) {
  return cell.free_discs() + static_cast<std::size_t>(cell.wall_discs);
}

double depth(const ShearCell& cell, const Discs& discs) {
  return discs.y[first_block_disc(cell)] - discs.y[cell.free_discs()] - cell.diameter;
}

double solid_fraction(const ShearCell& cell, const Discs& discs) {
  const double disc = 0.25 * std::numbers::pi * cell.diameter * cell.diameter;
  return static_cast<double>(cell.free_discs()) * disc / (cell.width() * depth(cell, discs));
}

double cell_skin(const ShearCell& cell) {
  const FilledCell start = fill(cell);
  const double best = cell.diameter * list_skin(start.discs.size(), solid_fraction(cell, start.discs));
  return std::max(0.1 * cell.diameter, std::min(best, 0.49 * cell.width() - cell.diameter));
}

double sixfold_order(const ShearCell& cell, const FilledCell& filled, const Discs& discs) {
  const double reach = 1.3 * cell.diameter;
  NeighbourList list{filled.box, reach - cell.diameter};
  Discs inside = discs;
  wrap(filled.box, inside);
  list.build(filled.shapes, inside);
  std::vector<std::complex<double>> sums(discs.size());
  std::vector<int> neighbours(discs.size());
  list.for_each_pair(inside, [&](std::size_t i, std::size_t j, std::size_t, Vec2 apart, const auto&) {
    const std::complex<double> d{apart.x, apart.y};
    const std::complex<double> square = d * d / std::norm(d), sixth = square * square * square;
    sums[i] += sixth, sums[j] += sixth;
    ++neighbours[i], ++neighbours[j];
  });
  double sum = 0.0;
  for (std::size_t i = 0; i < cell.free_discs(); ++i)
    if (neighbours[i] > 2) sum += std::abs(sums[i]) / neighbours[i];
  return sum / static_cast<double>(cell.free_discs());
}

}  // namespace talus
