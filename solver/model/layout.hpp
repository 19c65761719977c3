#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "solver/geometry/pose.hpp"
#include "solver/model/model.hpp"
#include "solver/state/state.hpp"

namespace talus {

/// Quantity that a generalised coordinate measures.
enum class Axis { x, y, angle };

/// One generalised coordinate of the scene: q[i] is this quantity of this body.
struct Coordinate {
  BodyId body{};
  Axis axis{};
};

/// Indices of a law instance (point contact, cable or friction) in State::mode and State::z.
struct Slot {
  std::size_t mode{};
  std::size_t memory{};
};

/// Position of all quantities of a Model in a State: coordinates body by body; one slot for each law instance (the
/// contact instances in order, then the cables, then the friction of contacts that have it), for each hanger, and for
/// each body that may sleep.
struct Layout {
  explicit Layout(const Model& model);

  std::vector<Coordinate> coordinates;         ///< of q and v
  std::vector<std::size_t> first;              ///< first coordinate of each body; the number of coordinates at the end
  std::vector<Slot> contact_slots;             ///< first slot of each contact; its instances are consecutive
  std::vector<std::size_t> contact_instances;  ///< number of law instances of each contact
  std::vector<Slot> cable_slots;               ///< slot of each cable
  std::vector<Slot> friction_slots;            ///< first friction slot of each contact, if it has friction
  std::size_t first_hanger{};                  ///< first mode slot of the hangers: 0 intact, 1 broken
  std::vector<BodyId> sleepers;                ///< bodies that may sleep in this model, in order
  std::size_t first_sleeper{};                 ///< first mode slot of the sleepers: 0 asleep, 1 awake
  std::size_t mode_count{};
  std::size_t memory_count{};
};

/// The state in which all bodies rest at their reference positions, all laws in mode 0 and all memory zero.
[[nodiscard]] State rest_state(const Model& model);

/// Sets the velocity of a body's centre of mass [L/T] and its angular velocity [rad/T]; wakes it if it sleeps.
/// Errors: InputError if the body cannot move that way.
void set_velocity(const Model& model, State& state, BodyId body, Vec2 v_WB, double w_WB);
/// The same with a given layout of the model: the time of a call does not grow with the number of bodies.
void set_velocity(const Model& model, const Layout& layout, State& state, BodyId body, Vec2 v_WB, double w_WB);

/// Pose of one body in a state.
[[nodiscard]] Pose pose(const Model& model, const State& state, BodyId body);

/// Angle of a body [rad], counter-clockwise > 0, not reduced to one turn.
[[nodiscard]] double angle(const Model& model, const State& state, BodyId body);

/// The same with a given layout of the model: the time of a call does not grow with the number of bodies.
[[nodiscard]] Pose pose(const Model& model, const Layout& layout, const State& state, BodyId body);
[[nodiscard]] double angle(const Model& model, const Layout& layout, const State& state, BodyId body);

/// Name of a coordinate: "rock.x", "column.angle", ...
[[nodiscard]] std::string name(const Model& model, const Coordinate& coordinate);

}  // namespace talus
