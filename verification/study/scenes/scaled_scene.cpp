#include "verification/study/scenes/scaled_scene.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <variant>

#include "solver/model/layout.hpp"

namespace talus::verification::problems {
namespace {

double whole_power(double base, int exponent) {
  double product = 1.0;
  for (int i = 0; i < std::abs(exponent); ++i)
    product *= base;
  return exponent < 0 ? 1.0 / product : product;
}

/// Scales numbers in place; numbers that mean "never" are unchanged.
class Scaler {
 public:
  explicit Scaler(const UnitScale& scale) : scale_{scale} {}

  void operator()(double& value, Dimension d) const {
    if (std::abs(value) < std::numeric_limits<double>::max()) value *= scale_.of(d);
  }
  void operator()(Vec2& value, Dimension d) const { value = scale_.of(d) * value; }
  void operator()(Vec3& value, Dimension d) const { value = scale_.of(d) * value; }

  template <class T>
  void fields(T& owner) const {
    for (const auto& field : T::fields())
      (*this)(owner.*field.member, field.dimension);
    if constexpr (requires { T::vectors(); }) {
      for (const auto& field : T::vectors())
        (*this)(owner.*field.member, field.dimension);
    }
    if constexpr (requires { owner.table.front().stretch; }) {
      for (auto& point : owner.table) {
        (*this)(point.stretch, dimension::length);
        (*this)(point.force, dimension::force);
      }
    }
    if constexpr (requires { owner.points.front().x; }) {
      for (Vec2& point : owner.points)
        (*this)(point, dimension::length);
    }
  }
  template <class... T>
  void fields(std::variant<T...>& owner) const {
    std::visit([this](auto& value) { this->fields(value); }, owner);
  }

 private:
  UnitScale scale_;
};

/// Collects all numbers of a model, without scaling.
std::vector<double> numbers(const Model& model) {
  std::vector<double> all{model.gravity.x, model.gravity.y};
  const auto add = [&all](auto... value) { (all.push_back(value), ...); };
  const auto add_fields = [&](const auto& variant) {
    std::visit(
        [&]<class T>(const T& owner) {
          for (const auto& field : T::fields())
            add(owner.*field.member);
        },
        variant);
  };
  for (const Body& body : model.bodies) {
    add(body.mass, body.inertia, body.angle, body.moment, body.p_WB.x, body.p_WB.y, body.p_BPin.x, body.p_BPin.y,
        body.force.x, body.force.y);
    add_fields(body.shape);
  }
  for (const Cable& cable : model.cables) {
    add(cable.a.p.x, cable.a.p.y, cable.a.p.z, cable.b.p.x, cable.b.p.y, cable.b.p.z, cable.rest_length);
    add_fields(cable.law);
  }
  for (const Contact& contact : model.contacts) {
    add_fields(contact.law);
    if (contact.friction) add_fields(*contact.friction);
  }
  for (const Hanger& hanger : model.hangers)
    add(hanger.p.x, hanger.p.y, hanger.p.z, hanger.strength);
  return all;
}

template <class List>
int differing(const List& one, const List& other) {
  if (one.size() != other.size()) return static_cast<int>(std::max(one.size(), other.size()));
  int count = 0;
  for (std::size_t i = 0; i < one.size(); ++i)
    count += one[i] == other[i] ? 0 : 1;
  return count;
}

}  // namespace

double UnitScale::of(Dimension d) const {
  return whole_power(mass, d.mass) * whole_power(length, d.length) * whole_power(time, d.time);
}

Model scaled(Model model, const UnitScale& scale) {
  const Scaler scaler{scale};
  scaler(model.gravity, dimension::acceleration);
  for (Body& body : model.bodies) {
    scaler.fields(body);
    scaler.fields(body.shape);
    scaler(body.p_WB, dimension::length);
    scaler(body.p_BPin, dimension::length);
    scaler(body.force, dimension::force);
  }
  for (Cable& cable : model.cables) {
    scaler(cable.a.p, dimension::length);
    scaler(cable.b.p, dimension::length);
    scaler(cable.rest_length, dimension::length);
    scaler.fields(cable.law);
  }
  for (Contact& contact : model.contacts) {
    scaler.fields(contact.law);
    if (contact.friction) scaler.fields(*contact.friction);
  }
  for (Hanger& hanger : model.hangers) {
    scaler(hanger.p, dimension::length);
    scaler(hanger.strength, dimension::force);
  }
  return model;
}

State scaled(const Model& model, State state, const UnitScale& scale) {
  const Scaler scaler{scale};
  const Layout layout{model};
  scaler(state.t, dimension::time);
  for (std::size_t i = 0; i < state.q.size(); ++i) {
    const bool turns = layout.coordinates[i].axis == talus::Axis::angle;
    scaler(state.q[i], turns ? dimension::angle : dimension::length);
    scaler(state.v[i], turns ? dimension::angular_velocity : dimension::velocity);
  }
  for (double& stretch : state.z)
    scaler(stretch, dimension::length);
  for (double& work : state.work)
    scaler(work, dimension::energy);
  scaler(state.impulse[0], dimension::momentum);
  scaler(state.impulse[1], dimension::momentum);
  scaler(state.impulse[2], dimension::angular_momentum);
  return state;
}

scenes::Fence scaled(scenes::Fence fence, const UnitScale& scale) {
  const Scaler scaler{scale};
  scaler.fields(fence);
  scaler.fields(fence.options);
  scaler.fields(fence.ground);
  scaler.fields(fence.column);
  for (auto& rock : fence.rocks) {
    scaler.fields(rock);
    scaler(rock.along, dimension::length);
  }
  for (auto& column : fence.changed_columns)
    scaler.fields(column);
  for (auto& cable : fence.stretched_cables)
    scaler.fields(cable);
  for (Vec2& point : fence.ground_profile)
    scaler(point, dimension::length);
  return fence;
}

int differing_numbers(const State& one, const State& other) {
  return differing(std::vector{one.t}, std::vector{other.t}) + differing(one.q, other.q) + differing(one.v, other.v) +
         differing(one.z, other.z) + differing(one.mode, other.mode) + differing(one.work, other.work) +
         differing(one.impulse, other.impulse);
}

int differing_numbers(const Model& one, const Model& other) { return differing(numbers(one), numbers(other)); }

}  // namespace talus::verification::problems
