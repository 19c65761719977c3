#include "solver/app/outputs/impact_output.hpp"

#include <fmt/format.h>

#include "solver/integrate/integrator_list.hpp"
#include "solver/io/file/atomic_file.hpp"
#include "solver/io/output/write_impacts.hpp"

namespace talus::app {

void ImpactOutput::report(RunRecord& record) const {
  const Model& model = scene_->model;
  record.impacts.emplace();
  for (const RecordedImpact& impact : log_.impacts()) {
    const Contact& contact = model.contacts[index(impact.contact)];
    record.impacts->push_back({contact.name, model.bodies[index(contact.a)].name, model.bodies[index(contact.b)].name,
                               contact.multiplicity, impact});
  }
  if (!chooses_steps(scene_->integrator)) return;
  record.notes.push_back(
      fmt::format("impacts.csv: the states are {:.6g} {} apart; an impact that begins and ends between two of them is "
                  "not listed, and peak values are those of the states",
                  scene_->plan.step, symbol(model.units, dimension::time)));
}

void ImpactOutput::write(const OutputSource& source) const {
  write_whole(folder_ / "impacts.csv", impacts_csv(source.record), Durability::later);
}

}  // namespace talus::app
