#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <span>
#include <string_view>
#include <vector>

#include "solver/base/fields.hpp"
#include "solver/laws/kinematics.hpp"
#include "solver/state/state.hpp"

namespace talus {

/// Elastic-plastic cable: linear elastic, yields at the yield force, and may break (Mustoe & Huttelmaier 1993, section
/// 2.4: linear elastic or perfectly elastic-plastic; hardening is not in the report). e is the elongation, p the
/// plastic stretch, which is the law's memory, and Y(p) the yield force:
///
///   slack     T = 0                   until e > p
///   taut      T = k (e - p)           until e < p, or T reaches Y(p) or the strength
///   yielding  T = Y(p) = k (e - p)    until the cable shortens, p reaches the rupture stretch, or T the strength
///   broken    T = 0                   permanently
struct ElasticPlastic {
  static constexpr std::string_view name = "elastic_plastic";
  static constexpr std::array<std::string_view, 4> modes{"slack", "taut", "yielding", "broken"};
  static constexpr std::size_t memory_size = 1;
  static constexpr Mechanism dissipation = Mechanism::cable_yield;
  static constexpr Mechanism release = Mechanism::cable_break;
  enum : Mode { slack, taut, yielding, broken };

  static constexpr bool acts(Mode mode) { return mode == taut || mode == yielding; }
  static constexpr bool memory_follows(Mode mode) { return mode == yielding; }
  static constexpr bool yields(Mode mode) { return mode == yielding; }
  static constexpr bool is_broken(Mode mode) { return mode == broken; }

  double stiffness{};          ///< k [F/L] > 0
  double yield{unlimited};     ///< yield force [F] > 0
  double hardening{};          ///< slope of Y(p) beyond the last point of the table [F/L] >= 0
  double strength{unlimited};  ///< tension at which the cable breaks [F] > 0; without hardening, a yield force below
                               ///< the strength is never exceeded
  double rupture{unlimited};   ///< plastic stretch at which the cable breaks [L] > 0
  std::vector<YieldPoint> table{};  ///< points of Y(p) after (0, yield), interpolated linearly; stretches and forces
                                    ///< increase from point to point

  static constexpr std::array<Field<ElasticPlastic>, 5> fields() {
    return {{{"stiffness", dimension::stiffness, &ElasticPlastic::stiffness, Range::positive,
              "axial stiffness k: tension for each unit of elongation"},
             {"yield", dimension::force, &ElasticPlastic::yield, Range::positive, "tension at which the cable yields"},
             {"hardening", dimension::stiffness, &ElasticPlastic::hardening, Range::non_negative,
              "growth of the yield force with the plastic stretch"},
             {"strength", dimension::force, &ElasticPlastic::strength, Range::positive,
              "tension at which the cable breaks"},
             {"rupture", dimension::length, &ElasticPlastic::rupture, Range::positive,
              "plastic stretch at which the cable breaks"}}};
  }

  constexpr LawForce operator()(Kinematics x, std::span<const double> memory, Mode mode) const {
    if (mode == taut) return {stiffness * (x.deformation - memory[0]), 0.0};
    if (mode != yielding) return {};
    // The plastic work is dissipated; only hardening increases the stored energy. The clamp acts only if a coarse step
    // ends when the cable is already shortening: then the tension is below the yield force.
    const Piece at = drawn_piece(x.deformation);
    const double tension = std::clamp(stiffness * (x.deformation - memory[0]), 0.0, backbone(at, x.deformation));
    const double elastic = at.slope / (stiffness + at.slope);
    return {elastic * tension, (1.0 - elastic) * tension};
  }

  constexpr double stored_energy(Kinematics x, std::span<const double> memory, Mode mode) const {
    if (mode == taut) return 0.5 * stiffness * (x.deformation - memory[0]) * (x.deformation - memory[0]);
    if (mode != yielding) return 0.0;
    const double tension = backbone(drawn_piece(x.deformation), x.deformation);
    return 0.5 * tension * tension / stiffness;
  }

  constexpr double guard(Kinematics x, std::span<const double> memory, Mode mode) const {
    const double elastic = x.deformation - memory[0];
    if (mode == slack) return -elastic;
    if (mode == taut) return std::min(elastic, limit(memory[0]) / stiffness - elastic);
    if (mode == yielding) {
      // The memory is not updated within a step, so the plastic stretch follows from the elongation. The smaller of the
      // relative distances to rupture and strength multiplies the rate: all ends of the mode then have one unit, and
      // the guard passes through zero at each of them.
      const double stretch = stretch_at(x, memory);
      const double left = std::min(1.0 - stretch / rupture, 1.0 - yield_force(stretch) / strength);
      return left * (left > 0.0 ? x.deformation_rate : std::abs(x.deformation_rate));
    }
    return 1.0;
  }

  constexpr Reset reset(Kinematics x, std::span<double> memory, Mode mode) const {
    const double elastic = x.deformation - memory[0];
    if (mode == yielding) {
      const double tension = yield_force(memory[0]);
      return memory[0] >= rupture || tension >= strength ? broken_with(tension) : Reset{taut, 0.0};
    }
    if (elastic < 0.0 || (elastic == 0.0 && x.deformation_rate < 0.0)) return {slack, 0.0};
    const double tension = stiffness * elastic;
    if (tension < limit(memory[0])) return {taut, 0.0};
    if (strength <= yield_force(memory[0])) return broken_with(tension);
    draw_out(x, memory);
    if (memory[0] >= rupture) return broken_with(yield_force(memory[0]));
    return {x.deformation_rate > 0.0 ? yielding : taut, 0.0};
  }

  /// Updates the plastic stretch, which follows the elongation while the cable yields.
  constexpr void track(Kinematics x, std::span<double> memory, Mode mode) const {
    if (mode == yielding) draw_out(x, memory);
  }

  constexpr Tangent tangent() const { return {stiffness, 0.0}; }

  constexpr LinearBranch linear_branch(std::span<const double> memory, Mode mode) const {
    constexpr double infinity = std::numeric_limits<double>::infinity();
    if (mode == slack) return {.natural = memory[0], .low = -infinity, .high = memory[0]};
    // The range ends 1e-12 (relative) before the limit, so that rounding cannot extend it beyond the guard's zero.
    if (mode == taut)
      return {.stiffness = stiffness,
              .natural = memory[0],
              .low = memory[0],
              .high = memory[0] + (1.0 - 1e-12) * (limit(memory[0]) / stiffness) - 1e-12 * std::abs(memory[0])};
    if (mode == broken) return {.low = -infinity, .high = infinity};
    return {};
  }

  /// Elongation at which a cable with this memory becomes slack [L].
  constexpr double natural_elongation(std::span<const double> memory) const { return memory[0]; }

  /// The law of this cable after a plastic stretch [L]: memory is measured from there, and the caller must increase the
  /// slack length by the same amount. If the stretch reaches the rupture stretch, the result's `rupture` is <= 0.
  ElasticPlastic drawn_before(double stretch) const {
    ElasticPlastic rest = *this;
    rest.yield = yield_force(stretch);
    std::erase_if(rest.table, [stretch](const YieldPoint& point) { return point.stretch <= stretch; });
    for (YieldPoint& point : rest.table)
      point.stretch -= stretch;
    // Interpolation within a segment may round to above the segment's end.
    if (!rest.table.empty()) rest.yield = std::min(rest.yield, rest.table.front().force);
    rest.rupture -= stretch;
    return rest;
  }

  /// The largest yield force [F]; infinite with a hardening slope > 0.
  constexpr double largest_yield() const {
    if (hardening > 0.0) return std::numeric_limits<double>::infinity();
    return table.empty() ? yield : table.back().force;
  }

  friend bool operator==(const ElasticPlastic&, const ElasticPlastic&) = default;

 private:
  static constexpr double unlimited = std::numeric_limits<double>::max();

  constexpr double limit(double stretch) const { return std::min(yield_force(stretch), strength); }
  /// A linear segment of Y(p), which begins at a plastic stretch.
  struct Piece {
    double stretch{};  ///< [L]
    double force{};    ///< Y there [F]
    double slope{};    ///< [F/L]
  };
  /// The first segment for whose end point `reaches(end)` holds, else the last segment.
  template <class Reaches>
  constexpr Piece piece(Reaches&& reaches) const {
    Piece now{0.0, yield, hardening};
    for (const YieldPoint& end : table) {
      now.slope = (end.force - now.force) / (end.stretch - now.stretch);
      if (reaches(end)) return now;
      now = {end.stretch, end.force, hardening};
    }
    return now;
  }
  /// Yield force Y(p) [F].
  constexpr double yield_force(double stretch) const {
    if (table.empty() && hardening == 0.0) return yield;
    const Piece at = piece([&](const YieldPoint& end) { return stretch <= end.stretch; });
    return at.force + at.slope * (stretch - at.stretch);
  }
  /// The segment on which k (e - p) = Y(p).
  constexpr Piece drawn_piece(double elongation) const {
    return piece([&](const YieldPoint& end) { return elongation <= end.stretch + end.force / stiffness; });
  }
  /// Plastic stretch p that solves k (e - p) = Y(p) [L].
  constexpr double drawn(Piece at, double elongation) const {
    if (at.slope == 0.0) return elongation - at.force / stiffness;
    return at.stretch + (stiffness * (elongation - at.stretch) - at.force) / (stiffness + at.slope);
  }
  /// Tension while the cable yields at this elongation [F].
  constexpr double backbone(Piece at, double elongation) const {
    return at.slope == 0.0 ? at.force : at.force + at.slope * (drawn(at, elongation) - at.stretch);
  }
  /// Plastic stretch of a cable with this memory after yielding up to this elongation [L].
  constexpr double stretch_at(Kinematics x, std::span<const double> memory) const {
    return std::max(memory[0], drawn(drawn_piece(x.deformation), x.deformation));
  }
  constexpr void draw_out(Kinematics x, std::span<double> memory) const { memory[0] = stretch_at(x, memory); }
  constexpr Reset broken_with(double tension) const { return {broken, 0.5 * tension * tension / stiffness}; }
};

}  // namespace talus
