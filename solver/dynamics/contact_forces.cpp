#include "solver/dynamics/contact_forces.hpp"

#include <utility>
#include <variant>

#include "solver/base/error.hpp"
#include "solver/dynamics/law_modes.hpp"

namespace talus {
namespace {

/// Calls visit(array) for each array of each law in the tuple: the one dispatch an evaluation makes.
template <class Laws, class Visit>
void for_each_array(Laws& laws, Visit&& visit) {
  std::apply([&](auto&... law) { (std::apply([&](auto&... array) { (visit(array), ...); }, law.arrays), ...); }, laws);
}

Kinematics kinematics(const Workspace& work, std::size_t instance) {
  return {work.gaps[instance].depth, work.rates[instance]};
}

/// Calls visit(law, slot) for each law instance.
template <class Laws, class Visit>
void for_each_instance(const Laws& laws, Visit&& visit) {
  for_each_array(laws, [&](const auto& array) {
    for (std::size_t i = 0; i < array.laws.size(); ++i)
      visit(array.laws[i], array.slots[i]);
  });
}

/// Fills the arrays of one law from the model, contact by contact.
template <class L>
class Compiler {
 public:
  Compiler(const Model& model, ContactArrays<L>& arrays, std::vector<ContactForces::Pair>& pairs)
      : model_{model}, arrays_{arrays}, pairs_{pairs} {}

  void add(const Contact& contact, const L& law, Slot first) {
    const Shape& a = model_.bodies[index(contact.a)].shape;
    const Shape& b = model_.bodies[index(contact.b)].shape;
    next_ = first;
    if (contact.method == ContactMethod::resultant) return add_resultant(contact.a, a, contact.b, b, law);
    for (const Vec2 node : boundary_nodes(a, contact.nodes))
      add_ball({node, 0.0}, contact.a, contact.b, b, law);
    for (const Vec2 node : boundary_nodes(b, contact.nodes))
      add_ball({node, 0.0}, contact.b, contact.a, a, law);
  }

 private:
  template <class ShapeA, class ShapeB>
  void add(BodyId id_a, const ShapeA& a, BodyId id_b, const ShapeB& b, const L& law) {
    auto& array = std::get<typename ContactArrays<L>::template Array<ShapeA, ShapeB>>(arrays_.arrays);
    array.geometry.push_back({id_a, id_b, a, b});
    array.laws.push_back(law);
    array.slots.push_back(next_);
    pairs_[next_.mode] = {id_a, id_b};
    next_ = {next_.mode + 1, next_.memory + L::memory_size};
  }

  void add_ball(const Ball& ball, BodyId id_a, BodyId id_b, const Shape& b, const L& law) {
    std::visit(
        [&](const auto& target) {
          if constexpr (std::is_same_v<std::decay_t<decltype(target)>, NoShape>) {
            TALUS_DEMAND(false);
          } else {
            add(id_a, ball, id_b, target, law);
          }
        },
        b);
  }

  void add_resultant(BodyId id_a, const Shape& a, BodyId id_b, const Shape& b, const L& law) {
    if (const auto* circle = std::get_if<Circle>(&a)) return add_ball({{}, circle->radius}, id_a, id_b, b, law);
    if (const auto* circle = std::get_if<Circle>(&b)) return add_ball({{}, circle->radius}, id_b, id_a, a, law);
    if (std::holds_alternative<HalfPlane>(a)) return add_resultant(id_b, b, id_a, a, law);
    const auto& box = std::get<Rectangle>(a);
    if (const auto* plane = std::get_if<HalfPlane>(&b)) return add(id_a, box, id_b, *plane, law);
    add(id_a, box, id_b, std::get<Rectangle>(b), law);
  }

  const Model& model_;
  ContactArrays<L>& arrays_;
  std::vector<ContactForces::Pair>& pairs_;
  Slot next_;
};

}  // namespace

ContactForces::ContactForces(const Model& model, const Layout& layout) {
  std::size_t count = 0;
  for (const std::size_t instances : layout.contact_instances)
    count += instances;
  pairs_.resize(count);
  tangents_.resize(count);
  for (std::size_t c = 0; c < model.contacts.size(); ++c) {
    std::visit(
        [&](const auto& law) {
          using L = std::decay_t<decltype(law)>;
          Compiler<L>{model, std::get<ContactArrays<L>>(laws_), pairs_}.add(model.contacts[c], law,
                                                                            layout.contact_slots[c]);
          for (std::size_t i = 0; i < layout.contact_instances[c]; ++i) {
            tangents_[layout.contact_slots[c].mode + i] = law.tangent();
          }
        },
        model.contacts[c].law);
  }
}

void ContactForces::update(Workspace& work) const {
  for_each_array(laws_, [&](const auto& array) {
    for (std::size_t i = 0; i < array.laws.size(); ++i) {
      const auto& contact = array.geometry[i];
      const Pose& A = work.poses[index(contact.a)];
      const Pose& B = work.poses[index(contact.b)];
      const std::size_t instance = array.slots[i].mode;
      work.gaps[instance] = gap(contact.shape_a, A, contact.shape_b, B);
      work.rates[instance] = depth_rate(work.gaps[instance], A, B);
    }
  });
}

void ContactForces::settle(State& state, const Workspace& work) const {
  for_each_instance(laws_, [&](const auto& law, Slot slot) {
    settle_mode(law, slot, kinematics(work, slot.mode), state, Mechanism::contact_release);
  });
}

void ContactForces::add(const State& state, Workspace& work, Rates* out) const {
  for_each_instance(laws_, [&]<class L>(const L& law, Slot slot) {
    const Mode mode = state.mode[slot.mode];
    if (mode == 0) return;
    const Kinematics x = kinematics(work, slot.mode);
    const LawForce force = law(x, memory<L>(state, slot), mode);
    const Gap& gap = work.gaps[slot.mode];
    const Pair pair = pairs_[slot.mode];
    const Vec2 on_b = force.total() * gap.n_AB;
    add_force(work.wrenches[index(pair.b)], work.poses[index(pair.b)].p_WB, gap.p_WC, on_b);
    add_force(work.wrenches[index(pair.a)], work.poses[index(pair.a)].p_WB, gap.p_WC, -on_b);
    if (out) out->work[static_cast<std::size_t>(Mechanism::contact_damping)] += force.dissipative * x.extent_rate;
  });
}

void ContactForces::guards(const State& state, const Workspace& work, std::span<double> out) const {
  for_each_instance(laws_, [&]<class L>(const L& law, Slot slot) {
    out[slot.mode] = law.guard(kinematics(work, slot.mode), memory<L>(state, slot), state.mode[slot.mode]);
  });
}

double ContactForces::stored_energy(const State& state, const Workspace& work) const {
  double sum = 0.0;
  for_each_instance(laws_, [&]<class L>(const L& law, Slot slot) {
    sum += law.stored_energy(kinematics(work, slot.mode), memory<L>(state, slot), state.mode[slot.mode]);
  });
  return sum;
}

void ContactForces::forces(const State& state, const Workspace& work, std::span<double> out) const {
  for_each_instance(laws_, [&]<class L>(const L& law, Slot slot) {
    out[slot.mode] = law(kinematics(work, slot.mode), memory<L>(state, slot), state.mode[slot.mode]).total();
  });
}

}  // namespace talus
