#include "solver/app/cell/cell_files.hpp"

#include <utility>

#include "solver/io/cell/cell_restart.hpp"
#include "solver/io/cell/write_cell_plot.hpp"
#include "solver/io/file/atomic_file.hpp"
#include "solver/io/file/vtk_text.hpp"
#include "solver/io/output/run_folder.hpp"

namespace talus::app {

CellFiles::CellFiles(std::filesystem::path folder, const CellScene& scene)
    : folder_{std::move(folder)}, scene_{&scene} {
  if (scene.pictures) make_folder(folder_ / cell_states_folder);
}

void CellFiles::write_loop(CellRun& run) {
  const Discs discs = run.discs();
  write_whole(folder_ / "RESTART.DAT", cell_restart_text(run.cell(), discs, cycles_before_ + run.steps()));
  if (scene_->pictures) {
    write_whole(folder_ / "PIC.DAT", cell_picture_text(run.cell(), discs));
    write_whole(folder_ / cell_state_name(times_.size()), cell_state_vtp(run));
  }
  times_.push_back(discs.t);
}

void CellFiles::write_end(CellRun& run) const {
  const auto write = [&](const char* name, const std::string& text) {
    write_whole(folder_ / name, text, Durability::later);
  };
  write("history.csv", cell_csv(*scene_, cell_history(*scene_, run)));
  write("profile.csv", cell_csv(*scene_, cell_profile(*scene_, run)));
  if (scene_->pictures) {
    std::vector<std::pair<double, std::string>> files;
    for (std::size_t k = 0; k < times_.size(); ++k)
      files.emplace_back(times_[k], cell_state_name(k));
    write("cell.pvd", vtk_index(files));
  }
  write("plot.json", cell_plot_json(*scene_, run));
}

std::vector<std::string> CellFiles::names() const {
  std::vector<std::string> names;
  // A run that fails before its first LOOP writes neither RESTART.DAT nor PIC.DAT and states.
  if (!times_.empty()) names.emplace_back("RESTART.DAT");
  if (!times_.empty() && scene_->pictures) names.insert(names.end(), {"PIC.DAT", std::string{cell_states_folder}});
  if (scene_->pictures) names.emplace_back("cell.pvd");
  names.insert(names.end(), {"history.csv", "profile.csv", "plot.json"});
  return names;
}

}  // namespace talus::app
