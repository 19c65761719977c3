#include "verification/study/runs/usage.hpp"

#include <algorithm>
#include <type_traits>
#include <variant>

#include "solver/integrate/integrator_list.hpp"
#include "solver/laws/coulomb_friction.hpp"

namespace talus::verification::problems {

void record_shape(const Shape& shape) { record_use("shape." + shape_names()[shape.index()]); }

void record_use(const Model& model) {
  if (!is_recording_use()) return;
  for (const Body& body : model.bodies)
    record_shape(body.shape);
  for (const Cable& cable : model.cables)
    std::visit([](const auto& law) { record_use(law); }, cable.law);
  for (const Contact& contact : model.contacts) {
    std::visit([](const auto& law) { record_use(law); }, contact.law);
    if (contact.friction)
      std::visit([]<class L>(const L&) { record_use("shear_law." + std::string{L::name}); }, *contact.friction);
    record_use("method." + std::string{name_of(contact.method)});
    record_pair(model.bodies[static_cast<std::size_t>(contact.a)].shape,
                model.bodies[static_cast<std::size_t>(contact.b)].shape);
  }
}

void record_use(const Integrator& integrator) { record_use("integrator." + std::string{name(integrator)}); }

void record_use(const DiscMethod& method) { record_use("integrator." + std::string{traits(method).name}); }

void record_pair(const Shape& a, const Shape& b) {
  record_shape(a);
  record_shape(b);
  const auto [first, second] = std::minmax({a.index(), b.index()});
  record_use("pair." + shape_names()[first] + "." + shape_names()[second]);
}

void record_mechanisms(const State& state) {
  for (std::size_t i = 0; i < mechanism_count; ++i) {
    if (state.work[i] != 0.0) record_use("mechanism." + std::string{name_of(static_cast<Mechanism>(i))});
  }
}

void RegimeRecorder::record() const {
  for (std::size_t c = 0; c < model_->contacts.size(); ++c) {
    const Contact& contact = model_->contacts[c];
    for (std::size_t i = 0; i < layout_.contact_instances[c]; ++i) {
      std::visit(
          [&](const auto& law) {
            using L = std::remove_cvref_t<decltype(law)>;
            record_regimes<L>(L::name, visited_[layout_.contact_slots[c].mode + i]);
          },
          contact.law);
      if (contact.friction) record_regimes<CoulombFriction>("friction", visited_[layout_.friction_slots[c].mode + i]);
    }
  }
  for (std::size_t c = 0; c < model_->cables.size(); ++c) {
    std::visit(
        [&](const auto& law) {
          using L = std::remove_cvref_t<decltype(law)>;
          record_regimes<L>(L::name, visited_[layout_.cable_slots[c].mode], 0);
        },
        model_->cables[c].law);
  }
}

}  // namespace talus::verification::problems
