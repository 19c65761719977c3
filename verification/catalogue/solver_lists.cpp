#include "verification/catalogue/solver_lists.hpp"

#include <string>

#include "solver/geometry/shape.hpp"
#include "solver/integrate/integrator_list.hpp"
#include "solver/laws/coulomb_friction.hpp"
#include "solver/laws/law_list.hpp"
#include "solver/laws/unilateral_spring.hpp"
#include "solver/model/contact.hpp"
#include "solver/state/state.hpp"

namespace talus::verification {

namespace {

void append(std::vector<Requirement>& all, const std::string& group, const std::vector<std::string>& names,
            const std::string& text) {
  for (const auto& name : names)
    all.push_back({group + "." + name, group, text});
}

/// Appends the regimes of a law: its modes from `first` on. An open contact (mode 0) is not a regime, but a slack cable
/// is.
template <class Law>
void append_regimes(std::vector<Requirement>& all, std::size_t first, const std::string& name,
                    const std::string& what) {
  for (std::size_t mode = first; mode < Law::modes.size(); ++mode)
    append(all, "regime", {name + "." + std::string{Law::modes[mode]}}, "mode of a " + what);
}

/// Appends the pairs of outlines that can touch: all except ground with ground and pairs with a body without outline.
void append_pairs(std::vector<Requirement>& all) {
  const std::vector<std::string> names = shape_names();
  const auto ground = [](const std::string& name) { return name == HalfPlane::name || name == Terrain::name; };
  for (std::size_t a = 0; a < names.size(); ++a) {
    for (std::size_t b = a; b < names.size(); ++b) {
      if (names[a] == NoShape::name || (ground(names[a]) && ground(names[b]))) continue;
      append(all, "pair", {names[a] + "." + names[b]}, "outlines in contact");
    }
  }
}

void append_integrators(std::vector<Requirement>& all) {
  for (const std::string& name : integrator_names()) {
    append(all, "integrator", {name}, "time integration");
    all.back().order = integrator_traits(name).order;
  }
}

}  // namespace

std::vector<Requirement> requirements_of_solver() {
  std::vector<Requirement> all;
  append(all, "law", ContactLaws::names(), "contact law");
  append(all, "law", CableLaws::names(), "cable law");
  append(all, "shear_law", FrictionLaws::names(), "friction law");
  append(all, "end_rule", names_of<EndRule>(), "how a contact with a dashpot ends");
  append(all, "method", names_of<ContactMethod>(), "how the overlap of two outlines becomes forces");
  append(all, "mechanism", names_of<Mechanism>(), "how energy leaves bodies and springs");
  append_integrators(all);
  append(all, "shape", shape_names(), "outline of a body");
  append_pairs(all);
  ContactLaws::for_each([&](auto law) { append_regimes<decltype(law)>(all, 1, std::string{law.name}, "contact law"); });
  append_regimes<CoulombFriction>(all, 1, "friction", "friction law");
  CableLaws::for_each([&](auto law) { append_regimes<decltype(law)>(all, 0, std::string{law.name}, "cable law"); });
  return all;
}

}  // namespace talus::verification
