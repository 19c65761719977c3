/// Contacts of a fence, with stiffness and dashpot from the allowed overlap.

#include <cmath>

#include "solver/laws/restitution.hpp"
#include "solver/scenes/fence_maker.hpp"

namespace talus::scenes {
namespace {

double reduced_mass(double a, double b) { return a * b / (a + b); }

}  // namespace

/// k = factor m v^2/overlap^2: the spring that absorbs the energy of m at the impact speed within the overlap, with the
/// factors of 1993; c by Eq. 21 with the same mass or with the effective mass of the contact. `allowed` is the field
/// that gives the overlap.
FenceContactLaw FenceMaker::contact_law(double mass, double factor, double overlap, double damped_mass,
                                        double Fence::*allowed) const {
  const double stiffness = factor * mass * speed_ * speed_ / (overlap * overlap);
  if (!(stiffness > 0.0 && std::isfinite(stiffness))) {
    // Where no overlap is given, it follows from the penetration.
    if (fence_.*allowed == 0.0) allowed = &Fence::penetration;
    throw FenceError{
        {0, std::string{field_name(allowed)},
         fmt::format("found {}; the contact stiffness of a mass of {:.6g} that stops from {:.6g} within {:.6g} is {}; "
                     "it must be > 0 and finite",
                     fence_.*allowed, mass, speed_, overlap, stiffness)}};
  }
  return {stiffness, damping(damping_ratio(fence_.restitution, fence_.options.end_rule), stiffness, damped_mass)};
}

Contact FenceMaker::contact(std::string name, BodyId a, BodyId b, FenceContactLaw law) const {
  Contact made{.name = std::move(name), .a = a, .b = b};
  const FenceOptions& options = fence_.options;
  LinearSpringDashpot spring{law.stiffness, law.damping, options.end_rule};
  const bool at_impact =
      options.calibration == FenceCalibration::effective_mass && options.contact == FenceContact::resultant;
  if (at_impact) {
    spring.damping = 0.0;
    spring.damping_ratio = damping_ratio(fence_.restitution, options.end_rule);
  }
  made.law = spring;
  if (fence_.friction > 0.0) {
    CoulombFriction friction{fence_.friction, options.shear_ratio * law.stiffness};
    friction.follows_normal = at_impact;
    made.friction = friction;
  }
  if (fence_.options.contact != FenceContact::resultant) made.method = ContactMethod::nodes;
  return made;
}

/// Mass for the dashpot between rock and column. For the effective mass, the rock hits along its centre line and the
/// column, which hangs freely during the impact, is hit at the height of the rock.
double FenceMaker::damped_mass(std::size_t rock, const Column& column) const {
  if (fence_.options.calibration == FenceCalibration::particles) return reduced_mass(rock_masses_[rock], column.mass);
  const double arm = fence_.rocks[rock].position.y - column.height;
  return effective_mass(ContactSide{rock_masses_[rock], {}, 0.0, false},
                        ContactSide{column.mass, column.inertia, arm, false});
}

void FenceMaker::add_rock_contacts(std::size_t i) {
  const FenceElement& rock = fence_.rocks[i];
  const std::string name = fence_.rocks.size() == 1 ? "rock" : fmt::format("rock{}", i + 1);
  const double overlap = fence_.rock_overlap > 0.0 ? fence_.rock_overlap : fence_.penetration * rock.a;
  bool first = i == 0;
  for (std::size_t layer = 0; layer < layers_.size(); ++layer) {
    for (const Column& column : layers_[layer]) {
      if (!meets(rock, column)) continue;
      const FenceContactLaw law = contact_law(reduced_mass(rock_masses_[i], column.mass), 1.0, overlap,
                                              damped_mass(i, column), &Fence::rock_overlap);
      Contact made = contact(fmt::format("{}-{}column{}", name, prefix(static_cast<int>(layer) + 1), column.number),
                             rocks_[i], column.body, law);
      made.nodes = {node_count(rock), node_count(fence_.column)};
      made.node_depth = node_depth(NodeDepth::side_face);
      made.multiplicity = column.multiplicity;
      builder_.add(made);
      if (first) made_.rock_column = law;
      first = false;
    }
  }
  // Factor 2 instead of 1, fitted to the only printed value.
  const FenceContactLaw on_ground = contact_law(rock_masses_[i], 2.0, fence_.penetration * rock.a, rock_masses_[i]);
  Contact made = contact(name + "-ground", rocks_[i], ground_, on_ground);
  made.nodes = {node_count(rock), 3};
  builder_.add(made);
  if (i == 0) made_.rock_ground = on_ground;
}

void FenceMaker::add_rock_pairs() {
  for (std::size_t i = 0; i < fence_.rocks.size(); ++i) {
    for (std::size_t j = i + 1; j < fence_.rocks.size(); ++j) {
      const FenceElement& one = fence_.rocks[i];
      const FenceElement& other = fence_.rocks[j];
      // Rocks side by side along the fence cannot touch.
      if (one.along != other.along && std::abs(one.along - other.along) >= one.a + other.a) continue;
      const double overlap =
          fence_.rock_overlap > 0.0 ? fence_.rock_overlap : fence_.penetration * std::min(one.a, other.a);
      const double mass = reduced_mass(rock_masses_[i], rock_masses_[j]);
      Contact made = contact(fmt::format("rock{}-rock{}", i + 1, j + 1), rocks_[i], rocks_[j],
                             contact_law(mass, 1.0, overlap, mass, &Fence::rock_overlap));
      made.nodes = {node_count(one), node_count(other)};
      made.node_depth = node_depth(NodeDepth::nearest);
      builder_.add(made);
    }
  }
}

void FenceMaker::add_column_pairs() {
  const double overlap = fence_.layer_overlap > 0.0 ? fence_.layer_overlap : fence_.penetration * fence_.column.a;
  bool first = true;
  for (std::size_t c = 0; c < layers_[0].size(); ++c) {
    const Column& front = layers_[0][c];
    if (!front.struck) continue;
    const double mass = 0.5 * front.mass;
    const FenceContactLaw law = contact_law(mass, 1.0, overlap, mass, &Fence::layer_overlap);
    Contact made = contact(fmt::format("column{0}-back_column{0}", front.number), front.body, layers_[1][c].body, law);
    made.nodes = {node_count(fence_.column), node_count(fence_.column)};
    made.node_depth = node_depth(NodeDepth::centroid_ray);
    made.multiplicity = front.multiplicity;
    builder_.add(made);
    if (first) made_.column_column = law;
    first = false;
  }
}

/// Stiffness as for rocks on the ground; the allowed overlap is a fraction of the half-width.
void FenceMaker::add_columns_on_ground() {
  for (std::size_t layer = 0; layer < layers_.size(); ++layer) {
    for (const Column& column : layers_[layer]) {
      const FenceContactLaw law = contact_law(column.mass, 2.0, fence_.penetration * fence_.column.a, column.mass);
      Contact made = contact(fmt::format("{}column{}-ground", prefix(static_cast<int>(layer) + 1), column.number),
                             column.body, ground_, law);
      made.nodes = {node_count(fence_.column), 3};
      made.multiplicity = column.multiplicity;
      builder_.add(made);
    }
  }
}

void FenceMaker::add_contacts() {
  for (std::size_t i = 0; i < fence_.rocks.size(); ++i)
    add_rock_contacts(i);
  add_rock_pairs();
  if (fence_.layers == 2) add_column_pairs();
  if (fence_.options.column_ground == ColumnGround::contact) add_columns_on_ground();
}

}  // namespace talus::scenes
