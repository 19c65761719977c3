#pragma once

#include <algorithm>
#include <array>
#include <limits>
#include <span>
#include <string_view>

#include "solver/base/fields.hpp"
#include "solver/laws/kinematics.hpp"
#include "solver/state/state.hpp"

namespace talus {

/// A cable that pulls elastically, yields at a tension that it holds while it is drawn out, and may break
/// (Mustoe & Huttelmaier 1993, section 2.4: linear elastic or perfectly elastic-plastic). With e the elongation and p
/// the plastic stretch, which is its memory:
///
///   slack     T = 0                          until e > p
///   taut      T = k (e - p)                  until e < p, or T reaches the yield force or the strength
///   yielding  T = yield, p = e - yield/k     until the cable shortens, or p reaches the rupture stretch
///   broken    T = 0                          for good
struct ElasticPlastic {
  static constexpr std::string_view name = "elastic_plastic";
  static constexpr std::array<std::string_view, 4> modes{"slack", "taut", "yielding", "broken"};
  static constexpr std::size_t memory_size = 1;
  static constexpr Mechanism dissipation = Mechanism::cable_yield;
  static constexpr Mechanism release = Mechanism::cable_break;
  enum : Mode { slack, taut, yielding, broken };

  double stiffness{};          ///< k [F/L] > 0
  double yield{unlimited};     ///< yield force [F] > 0
  double strength{unlimited};  ///< tension at which it breaks [F] > 0; above the yield force it is never reached
  double rupture{unlimited};   ///< plastic stretch at which it breaks [L] > 0

  static constexpr std::array<Field<ElasticPlastic>, 4> fields() {
    return {{{"stiffness", dimension::stiffness, &ElasticPlastic::stiffness, Range::positive,
              "axial stiffness k: tension for each unit of elongation"},
             {"yield", dimension::force, &ElasticPlastic::yield, Range::positive, "tension at which the cable yields"},
             {"strength", dimension::force, &ElasticPlastic::strength, Range::positive,
              "tension at which the cable breaks"},
             {"rupture", dimension::length, &ElasticPlastic::rupture, Range::positive,
              "plastic stretch at which the cable breaks"}}};
  }

  constexpr LawForce operator()(Kinematics x, std::span<const double> memory, Mode mode) const {
    if (mode == taut) return {stiffness * (x.extent - memory[0]), 0.0};
    // What the cable is drawn out by is lost: in this mode its stored energy does not change. Less than the yield force
    // is met only when steps are so coarse that the cable is already shortening.
    if (mode == yielding) return {0.0, std::clamp(stiffness * (x.extent - memory[0]), 0.0, yield)};
    return {};
  }

  constexpr double stored_energy(Kinematics x, std::span<const double> memory, Mode mode) const {
    if (mode == taut) return 0.5 * stiffness * (x.extent - memory[0]) * (x.extent - memory[0]);
    return mode == yielding ? 0.5 * yield * yield / stiffness : 0.0;
  }

  constexpr double guard(Kinematics x, std::span<const double> memory, Mode mode) const {
    const double elastic = x.extent - memory[0];
    if (mode == slack) return -elastic;
    if (mode == taut) return std::min(elastic, limit() - stiffness * elastic);
    if (mode == yielding) return std::min(x.extent_rate, rupture - memory[0]);
    return 1.0;
  }

  constexpr Reset reset(Kinematics x, std::span<double> memory, Mode mode) const {
    const double elastic = x.extent - memory[0];
    if (mode == yielding) return memory[0] >= rupture ? broken_with(yield * yield) : Reset{taut, 0.0};
    if (elastic < 0.0 || (elastic == 0.0 && x.extent_rate < 0.0)) return {slack, 0.0};
    const double tension = stiffness * elastic;
    if (tension < limit()) return {taut, 0.0};
    if (strength <= yield) return broken_with(tension * tension);
    draw_out(x, memory);
    return {x.extent_rate > 0.0 ? yielding : taut, 0.0};
  }

  /// While the cable yields its plastic stretch follows the elongation.
  constexpr void track(Kinematics x, std::span<double> memory, Mode mode) const {
    if (mode == yielding) draw_out(x, memory);
  }

  constexpr Tangent tangent() const { return {stiffness, 0.0}; }

  friend constexpr bool operator==(const ElasticPlastic&, const ElasticPlastic&) = default;

 private:
  static constexpr double unlimited = std::numeric_limits<double>::max();

  constexpr double limit() const { return std::min(yield, strength); }
  constexpr void draw_out(Kinematics x, std::span<double> memory) const {
    memory[0] = std::max(memory[0], x.extent - yield / stiffness);
  }
  constexpr Reset broken_with(double tension_squared) const { return {broken, 0.5 * tension_squared / stiffness}; }
};

}  // namespace talus
