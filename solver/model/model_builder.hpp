#pragma once

#include <functional>
#include <set>
#include <string>

#include "solver/model/model.hpp"

namespace talus {

/// Builds a Model and checks it. All errors are InputError: "body 'rock': mass is -3; it must be > 0".
class ModelBuilder {
 public:
  explicit ModelBuilder(UnitSystem units = si) { model_.units = units; }

  /// Acceleration of free fall, world [L/T^2].
  void gravity(Vec2 acceleration) { model_.gravity = acceleration; }

  /// Selects when sleeping bodies are woken, or that none sleeps.
  void sleep(Sleep choice) { model_.sleep = choice; }

  /// Adds a body. Errors: an empty or duplicate name, a mass or inertia that is not > 0 where the mobility needs one, a
  /// shape with a size that is not > 0, a half-plane that can move, a number that is not finite.
  BodyId add(Body body);

  /// Adds a cable. Errors: as above; ends that coincide in the reference positions, both ends fixed, a rest length < 0.
  CableId add(Cable cable);

  /// Adds a contact. Errors: as above; a body against itself, two bodies that cannot move, a pair of shapes without a
  /// gap, fewer than 3 nodes on a circle.
  ContactId add(Contact contact);

  /// Adds a hanger; its cables must have been added before. Errors: as above; a body that cannot move, no cable or more
  /// than two that end there, another hanger at the same point, two cables with different laws or largest yield forces,
  /// or with dashpots that are not in proportion to their stiffnesses (as one cable they would not have a single
  /// tension).
  HangerId add(Hanger hanger);

  /// The model as added so far.
  const Model& model() const { return model_; }

  /// The finished model. Errors: InputError if it has no body.
  [[nodiscard]] Model build() const;

 private:
  Model model_;
  /// Names in use, for each kind.
  std::set<std::string, std::less<>> body_names_, cable_names_, contact_names_, hanger_names_;
};

}  // namespace talus
