#pragma once

#include <array>
#include <string>
#include <string_view>
#include <vector>

#include "solver/base/fields.hpp"
#include "solver/base/units.hpp"
#include "solver/base/vec.hpp"
#include "solver/laws/unilateral_spring.hpp"
#include "solver/model/model.hpp"
#include "solver/run/run_plan.hpp"

namespace talus::scenes {

/// Type of a fence element; the numbers are those of the 1993 deck.
enum class ElementType { rock = 0, column = 1 };

/// Solid that, with the density, gives an element's mass and inertia; the numbers are those of the 1993 deck.
enum class ElementSolid { ellipsoid = 0, block = 1, cylinder = 2 };

/// Outline of an element in its own axes, with semi-axes a and b.
enum class ElementOutline {
  by_power,     ///< |x/a|^n + |y/b|^n = 1 with n = 2/power; power 0 means the nearly rectangular outline of 1993,
                ///< n = 20, except for ellipsoids, whose outline is then the ellipse (the rule of the 1993 deck)
  ellipse,      ///< a circle for a = b
  rectangle,    ///< with sides 2a and 2b
  superquadric  ///< |x/a|^n + |y/b|^n = 1 with n = `exponent`
};

/// One element of a fence: the ground, a rock, or the column that represents all columns (Mustoe & Huttelmaier 1993,
/// Appendix II.4).
struct FenceElement {
  ElementType type{ElementType::rock};
  ElementSolid solid{ElementSolid::ellipsoid};
  int points{2};  ///< nodes of the outline in one quadrant, including both ends: 4 (points - 1) in all
  double a{};     ///< half-length along local x [L] > 0
  double b{};     ///< half-length along local y [L] > 0
  ElementOutline outline{ElementOutline::by_power};
  double power{};              ///< 2/n, in [0, 1]; for the outline by_power
  double exponent{};           ///< n > 1; for the outline superquadric
  double density{};            ///< [M/L^3] > 0
  double bar_length{};         ///< attachment length of a column [L]; printed only, as in 1993
  Vec2 position{};             ///< centroid, world [L]
  double along{};              ///< of a rock: its position along the fence, 0 at mid-span [L]
  double angle{};              ///< [rad], counter-clockwise > 0; a column is upright at 0
  Vec2 velocity{};             ///< [L/T]
  double spin{};               ///< [rad/T], counter-clockwise > 0
  Vec2 force{};                ///< applied at the centroid, world [F]
  double moment{};             ///< applied [F L], counter-clockwise > 0
  std::array<bool, 3> held{};  ///< whether x, y and rotation are held
  Vec2 fixed_point{};          ///< local coordinates of the fixed point [L]

  static constexpr std::array<Field<FenceElement>, 8> fields() {
    using F = FenceElement;
    return {{{"a", dimension::length, &F::a, Range::positive, "half-length along local x"},
             {"b", dimension::length, &F::b, Range::positive, "half-length along local y"},
             {"power", dimension::number, &F::power, Range::fraction,
              "outline of a deck: |x/a|^n + |y/b|^n = 1, n = 2/power; 0: n = 20 (by resultants: a rectangle), of an "
              "ellipsoid n = 2"},
             {"density", dimension::density, &F::density, Range::positive, "mass density"},
             {"bar_length", dimension::length, &F::bar_length, Range::non_negative, "attachment length; only printed"},
             {"angle", dimension::angle, &F::angle, Range::any, "orientation, counter-clockwise positive"},
             {"spin", dimension::angular_velocity, &F::spin, Range::any, "counter-clockwise positive"},
             {"moment", dimension::moment, &F::moment, Range::any, "constant moment, counter-clockwise positive"}}};
  }
  static constexpr std::array<VectorField<FenceElement>, 4> vectors() {
    using F = FenceElement;
    return {{{"position", dimension::length, &F::position, "of the centroid"},
             {"velocity", dimension::velocity, &F::velocity, "of the centroid"},
             {"force", dimension::force, &F::force, "constant force at the centroid"},
             {"fixed_point", dimension::length, &F::fixed_point, "point held, in the element's own axes"}}};
  }
  static constexpr std::array<CountField<FenceElement>, 1> counts() {
    return {{{"points", &FenceElement::points, 2, 1000, "nodes of a quadrant of the outline, both ends counted"}}};
  }

  friend bool operator==(const FenceElement&, const FenceElement&) = default;
};

/// A column that differs from the others: values that replace theirs, for a longer, shorter, heavier or lighter column.
struct ChangedColumn {
  int number{1};      ///< position from the centre outwards, 1 .. half the count; in every layer and on both sides
  double a{};         ///< half-width [L] > 0
  double b{};         ///< half-height [L] > 0
  double density{};   ///< [M/L^3] > 0
  double y_top{};     ///< top joint above its centroid [L]
  double y_bottom{};  ///< bottom joint, local y [L]

  static constexpr std::array<Field<ChangedColumn>, 5> fields() {
    using F = ChangedColumn;
    return {{{"a", dimension::length, &F::a, Range::positive, "half-width"},
             {"b", dimension::length, &F::b, Range::positive, "half-height"},
             {"density", dimension::density, &F::density, Range::positive, "mass density"},
             {"y_top", dimension::length, &F::y_top, Range::any, "top joint above its centroid"},
             {"y_bottom", dimension::length, &F::y_bottom, Range::any, "bottom joint, < 0 below the centroid"}}};
  }
  static constexpr std::array<CountField<ChangedColumn>, 1> counts() {
    return {{{"number", &ChangedColumn::number, 1, 1000, "number of the column, from the centre outwards"}}};
  }

  friend bool operator==(const ChangedColumn&, const ChangedColumn&) = default;
};

/// A cable that yielded in an earlier impact.
struct StretchedCable {
  std::string cable{};  ///< its name in the scene: "top1", "bottom-2", "back_top3", ...
  double stretch{};     ///< plastic elongation [L] >= 0

  static constexpr std::array<Field<StretchedCable>, 1> fields() {
    return {{{"stretch", dimension::length, &StretchedCable::stretch, Range::non_negative, "plastic stretch"}}};
  }
  static constexpr std::array<CountField<StretchedCable>, 0> counts() { return {}; }

  friend bool operator==(const StretchedCable&, const StretchedCable&) = default;
};

/// The part of the fence that a scene models.
enum class FenceSymmetry {
  half,  ///< central column and one side, force of the central segment doubled (1993): symmetric hits only
  full,  ///< all columns
};

/// Central columns of the half model when their total count is even.
enum class EvenCentre {
  doubled,  ///< one body of double mass and inertia (1993, section 3.1)
  pair,     ///< two bodies side by side
};

/// Contact forces of a fence as a function of overlap.
enum class FenceContact {
  nodes,      ///< one force per boundary node, with the outlines and normals of 1993
  resultant,  ///< one force per pair
  smoother,   ///< one force per boundary node, with the normal of the body of smaller curvature (Appendix I of the
              ///< report)
};

/// Mass from which Eq. 21 computes the dashpot for the coefficient of restitution.
enum class FenceCalibration {
  particles,       ///< the two bodies as particles (1993, Eq. 21)
  effective_mass,  ///< effective mass at the contact point: for resultants at every impact, for nodes in the initial
                   ///< configuration
};

/// Last segment of the bottom cable, between the last column and a fixed end.
enum class BottomEnd {
  free,      ///< none: the bottom cable ends at the last column
  anchored,  ///< a segment to a fixed point below the top cable's end
};

/// Whether columns touch the ground.
enum class ColumnGround {
  none,     ///< they pass through it (1993: the listing has no stiffness for this contact)
  contact,  ///< they touch it as rocks do
};

/// Treatment of the start when a rock already touches the fence.
enum class FenceStart {
  plain,      ///< the bodies start with the given velocities
  half_kick,  ///< the contact forces of the first touch act for half a step beforehand (1993; inferred from the
              ///< listing)
};

/// Condition that ends a run before its last step.
enum class FenceEnd {
  steps,  ///< none (1993)
  exit,   ///< all rocks have passed x = exit_x
  rest,   ///< all rocks are slower than a thousandth of the fastest one's speed at the start
};

/// A point of the yield force as a function of plastic strain.
struct YieldMultiple {
  double strain{};    ///< plastic elongation divided by the rest length > 0
  double multiple{};  ///< factor of the yield force, `limit_top` or `limit_bottom`, >= 1

  friend bool operator==(const YieldMultiple&, const YieldMultiple&) = default;
};

/// Options that are not in the 1993 deck. The defaults reproduce the historical program; see current_options().
struct FenceOptions {
  FenceSymmetry symmetry{FenceSymmetry::half};
  EvenCentre even_centre{EvenCentre::doubled};
  FenceContact contact{FenceContact::nodes};
  FenceCalibration calibration{FenceCalibration::particles};
  EndRule end_rule{EndRule::attractive};
  FenceStart start{FenceStart::half_kick};
  BottomEnd bottom_end{BottomEnd::free};
  ColumnGround column_ground{ColumnGround::none};
  FenceEnd end{FenceEnd::steps};
  Sleep sleep{Sleep::exact};  ///< of columns that have not been moved; `on` gives up the smallest digits of the listing
  /// Checks that end a run or print a warning. The contacts of a fence are those of its model: columns do not touch
  /// each other. A run with the rules of 1993 must reproduce the errors of its step.
  MonitorRules watch{.missing_contacts = CheckAction::off, .quality = CheckAction::warning};
  std::string integrator{"lagged_central_difference"};
  double tolerance{};  ///< error tolerance of the integrator's step control; 0: none (1993)

  double shear_ratio{1.0};   ///< k_s/k_n of all contacts > 0; used if the coefficient of friction is > 0
  double hanger_strength{};  ///< pull at which a top joint breaks [F] >= 0; 0: never (1993)
  double strength_top{};     ///< tension at which the top cable breaks [F] >= 0; 0: never (1993)
  double strength_bottom{};  ///< tension at which the bottom cable breaks [F] >= 0; 0: never (1993)
  double hardening{};  ///< tangent modulus of a yielding cable over Young's modulus, in [0, 1); 0: perfectly plastic
                       ///< (1993)
  double rupture{};    ///< plastic strain at which a cable breaks >= 0; 0: never (1993)
  /// Yield force of both cables after (0, 1): linear between the points and constant after the last; replaces
  /// `hardening`.
  std::vector<YieldMultiple> table{};

  double exit_x{};  ///< x at which a run with `exit` ends [L]

  static constexpr std::array<Field<FenceOptions>, 8> fields() {
    using F = FenceOptions;
    return {{{"tolerance", dimension::number, &F::tolerance, Range::non_negative,
              "step control of the integrator (0: none)"},
             {"shear_ratio", dimension::number, &F::shear_ratio, Range::positive, "k_s/k_n of all contacts"},
             {"hanger_strength", dimension::force, &F::hanger_strength, Range::non_negative,
              "pull at which a top joint breaks (0: never)"},
             {"strength_top", dimension::force, &F::strength_top, Range::non_negative,
              "tension at which the top cable breaks (0: never)"},
             {"strength_bottom", dimension::force, &F::strength_bottom, Range::non_negative,
              "tension at which the bottom cable breaks (0: never)"},
             {"hardening", dimension::number, &F::hardening, Range::fraction,
              "tangent modulus of a yielding cable over Young's modulus, < 1"},
             {"rupture", dimension::number, &F::rupture, Range::non_negative,
              "plastic strain at which a cable breaks (0: never)"},
             {"exit_x", dimension::length, &F::exit_x, Range::any, "x that the rocks pass where a run ends by exit"}}};
  }
  static constexpr std::array<CountField<FenceOptions>, 0> counts() { return {}; }

  friend bool operator==(const FenceOptions&, const FenceOptions&) = default;
};

/// The options for new fences: contacts that are independent of nodes and have the same restitution at every impact, no
/// tension in contacts, two separate central columns for even counts, located events.
[[nodiscard]] FenceOptions current_options();

/// A rockfall fence with its rocks: the records of a 1993 deck (Mustoe & Huttelmaier 1993, Appendix II.4) as numbers in
/// one consistent system of units. x is horizontal, across the fence; y up; z along the fence.
struct Fence {
  std::string title{};
  UnitSystem units{us};

  double step_factor{};               ///< fact_dt: step as a multiple of that of the 1993 rule; 0 means 1
  long steps{};                       ///< niter: number of steps > 0
  long print_every{};                 ///< nprint: steps between states in the listing and the geometry file > 0
  long history_every{};               ///< nhisto: steps between records of the histories > 0
  double penetration{};               ///< f_penet: largest overlap as a fraction of the rock's radius > 0
  int gravity_sign{-1};               ///< igrav: +1 or -1, direction of gravity along y
  double gravity{};                   ///< grav: gravitational acceleration [L/T^2] >= 0
  std::vector<int> history_elements;  ///< elno: numbers of the elements whose histories are recorded
  std::vector<int> history_codes;     ///< variab: codes of the recorded quantities, 1 .. 61

  bool requests_histories() const { return !history_elements.empty() && !history_codes.empty(); }

  FenceElement ground;               ///< element 1
  std::vector<Vec2> ground_profile;  ///< uneven ground instead of its level surface: points of a line, world [L]
  std::vector<FenceElement> rocks;   ///< elements 2 .. nel - 1
  FenceElement column;               ///< element nel: represents every column
  std::vector<ChangedColumn> changed_columns;  ///< columns that differ from it

  /// Plastic elongation of cables at the start, from earlier impacts; the columns then hang lower, in equilibrium with
  /// the longer cables.
  std::vector<StretchedCable> stretched_cables;

  double span{};          ///< of the top cable, between its fixed ends [L] > 0
  double sag{};           ///< of the top cable at mid-span [L] > 0
  double spacing{};       ///< dcol: distance between neighbouring columns along the fence [L] > 0
  double young{};         ///< Young's modulus of both cables [F/L^2] > 0 (the deck: lb/in^2)
  double y_top{};         ///< top joint above a column's centroid [L]
  double y_bottom{};      ///< bottom joint, local y [L], < 0 below the centroid
  int connections{2};     ///< nocab: 2 top and bottom cable, 1 top cable only
  int columns{};          ///< ncol: columns in a layer > 0
  double restitution{};   ///< e of all contacts, in (0, 1]
  double area_top{};      ///< cross-section of the top cable [L^2] > 0 (the deck: in^2)
  double area_bottom{};   ///< cross-section of one strand of the bottom cable [L^2] > 0 (the deck: in^2)
  double friction{};      ///< coefficient of friction >= 0
  double slack{};         ///< of the bottom cable between neighbouring columns [L] >= 0
  double limit_top{};     ///< brek_top: yield force of the top cable [F] > 0
  double limit_bottom{};  ///< brek_bot: yield force of the bottom cable [F] > 0

  int layers{1};           ///< no_fence: 1 or 2
  double layer_spacing{};  ///< sp_fence: centre to centre [L] > 0 for two layers
  /// rf_overlap: largest overlap of rock and column [L]; 0: penetration times the rock's radius.
  double rock_overlap{};
  /// ff_overlap: largest overlap of columns of two layers [L]; 0: penetration times the half-width.
  double layer_overlap{};

  FenceOptions options{};

  static constexpr std::array<Field<Fence>, 19> fields() {
    using F = Fence;
    return {{{"step_factor", dimension::number, &F::step_factor, Range::non_negative,
              "fact_dt: multiple (0: one) of the step of the 1993 rule"},
             {"penetration", dimension::number, &F::penetration, Range::positive,
              "f_penet: largest overlap over the rock's radius"},
             {"gravity", dimension::acceleration, &F::gravity, Range::positive, "grav: acceleration of free fall"},
             {"span", dimension::length, &F::span, Range::positive, "of the top cable between its fixed ends"},
             {"sag", dimension::length, &F::sag, Range::positive, "of the top cable at mid-span"},
             {"spacing", dimension::length, &F::spacing, Range::positive, "dcol: distance of neighbouring columns"},
             {"young", dimension::pressure, &F::young, Range::positive, "Young's modulus of both cables"},
             {"y_top", dimension::length, &F::y_top, Range::any, "top joint above a column's centroid"},
             {"y_bottom", dimension::length, &F::y_bottom, Range::any, "y_bot: bottom joint, < 0 below the centroid"},
             {"restitution", dimension::number, &F::restitution, Range::positive_fraction, "ecoeff: of all contacts"},
             {"area_top", dimension::area, &F::area_top, Range::positive, "cross-section of the top cable"},
             {"area_bottom", dimension::area, &F::area_bottom, Range::positive,
              "area_bot: cross-section of one strand of the bottom cable"},
             {"friction", dimension::number, &F::friction, Range::non_negative, "frict: coefficient of friction"},
             {"slack", dimension::length, &F::slack, Range::non_negative, "of the bottom cable between two columns"},
             {"limit_top", dimension::force, &F::limit_top, Range::positive, "brek_top: yield force of the top cable"},
             {"limit_bottom", dimension::force, &F::limit_bottom, Range::positive,
              "brek_bot: yield force of the bottom cable"},
             {"layer_spacing", dimension::length, &F::layer_spacing, Range::non_negative,
              "sp_fence: distance of two layers, centre to centre"},
             {"rock_overlap", dimension::length, &F::rock_overlap, Range::non_negative,
              "rf_overlap: largest overlap of rock and column (0: penetration times the rock's radius)"},
             {"layer_overlap", dimension::length, &F::layer_overlap, Range::non_negative,
              "ff_overlap: largest overlap of columns of two layers (0: penetration times half width)"}}};
  }
  static constexpr std::array<CountField<Fence>, 7> counts() {
    using F = Fence;
    return {{{"steps", &F::steps, 1, 1'000'000'000, "niter: number of steps"},
             {"print_every", &F::print_every, 1, 1'000'000'000, "nprint: steps between states of the listing"},
             {"history_every", &F::history_every, 1, 1'000'000'000, "nhisto: steps between records of the histories"},
             {"gravity_sign", &F::gravity_sign, -1, 1, "igrav: direction of gravity along y, 1 or -1"},
             {"connections", &F::connections, 1, 2, "nocab: 2 top and bottom cable, 1 top cable only"},
             {"columns", &F::columns, 1, 1000, "ncol: columns in a layer"},
             {"layers", &F::layers, 1, 2, "no_fence: layers of the fence"}}};
  }

  friend bool operator==(const Fence&, const Fence&) = default;
};

}  // namespace talus::scenes

namespace talus {
template <>
struct Names<scenes::ElementType> {
  static constexpr std::array<std::string_view, 2> list{"rock", "column"};
};
template <>
struct Names<scenes::ElementSolid> {
  static constexpr std::array<std::string_view, 3> list{"ellipsoid", "block", "cylinder"};
};
template <>
struct Names<scenes::ElementOutline> {
  static constexpr std::array<std::string_view, 4> list{"by_power", "ellipse", "rectangle", "superquadric"};
};
template <>
struct Names<scenes::FenceSymmetry> {
  static constexpr std::array<std::string_view, 2> list{"half", "full"};
};
template <>
struct Names<scenes::EvenCentre> {
  static constexpr std::array<std::string_view, 2> list{"doubled", "pair"};
};
template <>
struct Names<scenes::FenceContact> {
  static constexpr std::array<std::string_view, 3> list{"nodes", "resultant", "smoother"};
};
template <>
struct Names<scenes::FenceCalibration> {
  static constexpr std::array<std::string_view, 2> list{"particles", "effective_mass"};
};
template <>
struct Names<scenes::ColumnGround> {
  static constexpr std::array<std::string_view, 2> list{"none", "contact"};
};
template <>
struct Names<scenes::FenceEnd> {
  static constexpr std::array<std::string_view, 3> list{"steps", "exit", "rest"};
};
template <>
struct Names<scenes::FenceStart> {
  static constexpr std::array<std::string_view, 2> list{"plain", "half_kick"};
};
template <>
struct Names<scenes::BottomEnd> {
  static constexpr std::array<std::string_view, 2> list{"free", "anchored"};
};
}  // namespace talus
