#pragma once

#include <optional>
#include <string>
#include <utility>

#include "solver/model/model_builder.hpp"
#include "solver/scenes/scene.hpp"

namespace talus::verification::problems {

/// A ModelBuilder with one call for each usual kind of part, and with the scene of the finished model. What is unusual
/// is added by add(), with the names of its members.
class SceneBuilder : public ModelBuilder {
 public:
  using ModelBuilder::ModelBuilder;

  /// Adds a body that cannot move.
  BodyId add_fixed(std::string name, Shape shape, Vec2 p_WB = {}, double angle = 0.0) {
    return add(Body{
        .name = std::move(name), .mobility = Mobility::fixed, .shape = std::move(shape), .p_WB = p_WB, .angle = angle});
  }
  /// Adds a body that moves without rotation.
  BodyId add_particle(std::string name, double mass, Vec2 p_WB = {}, Shape shape = NoShape{}) {
    return add(Body{.name = std::move(name),
                    .mobility = Mobility::particle,
                    .mass = mass,
                    .shape = std::move(shape),
                    .p_WB = p_WB});
  }
  /// Adds a body that moves and rotates freely.
  BodyId add_free(std::string name, double mass, double inertia, Shape shape, Vec2 p_WB = {}, double angle = 0.0) {
    return add(Body{.name = std::move(name),
                    .mass = mass,
                    .inertia = inertia,
                    .shape = std::move(shape),
                    .p_WB = p_WB,
                    .angle = angle});
  }
  /// Adds a contact with one resultant force.
  ContactId add_contact(std::string name, BodyId a, BodyId b, ContactLaw law,
                        std::optional<FrictionLaw> friction = {}) {
    return add(
        Contact{.name = std::move(name), .a = a, .b = b, .law = std::move(law), .friction = std::move(friction)});
  }
  /// Adds a cable.
  CableId add_cable(std::string name, CableEnd a, CableEnd b, double rest_length, CableLaw law) {
    return add(Cable{.name = std::move(name), .a = a, .b = b, .rest_length = rest_length, .law = std::move(law)});
  }

  /// The finished model at rest in its reference positions. Errors: as build().
  [[nodiscard]] Scene at_rest(std::string title = {}) const {
    Scene scene{.title = std::move(title), .model = build()};
    scene.initial = rest_state(scene.model);
    return scene;
  }
};

}  // namespace talus::verification::problems
