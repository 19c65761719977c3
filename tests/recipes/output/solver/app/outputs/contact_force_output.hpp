#pragma once

#include "solver/app/outputs/run_output.hpp"
#include "solver/io/file/atomic_file.hpp"
#include "solver/io/output/write_history.hpp"
#include "verification/record/csv.hpp"

namespace talus::app {

/// contact_forces.csv: overlap and normal force of each contact at the end of a run, one row for each, for scenes with
/// contacts that are no fences.
struct ContactForceOutput {
  static constexpr std::string_view name = "contact_forces";
  static constexpr std::array<std::string_view, 1> fixed_files{"contact_forces.csv"};
  std::filesystem::path folder;
  const Model* model;

  static std::optional<ContactForceOutput> make(const OutputRequest& request) {
    if (request.file.fence || request.dynamics.model().contacts.empty()) return std::nullopt;
    return ContactForceOutput{request.folder, &request.dynamics.model()};
  }
  void write(const OutputSource& source) const {
    const UnitSystem& units = source.record.units;
    records::CsvText text{{"contact", "body_a", "body_b", csv_header({"overlap", dimension::length}, units),
                           csv_header({"normal_force", dimension::force}, units)}};
    for (std::size_t i = 0; i < model->contacts.size(); ++i) {
      const Contact& contact = model->contacts[i];
      text.cell(contact.name);
      text.cell(model->bodies[index(contact.a)].name), text.cell(model->bodies[index(contact.b)].name);
      text.number(source.end.depths()[i]), text.number(source.end.forces().contacts[i]);
      text.end_row();
    }
    write_whole(folder / fixed_files[0], std::move(text).text(), Durability::later);
  }
};

}  // namespace talus::app
