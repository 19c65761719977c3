#include "solver/app/cell_files.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <string_view>

#include "solver/io/cell/cell_restart.hpp"
#include "solver/io/cell/write_cell_plot.hpp"
#include "solver/io/file/atomic_file.hpp"
#include "solver/io/file/vtk_text.hpp"
#include "solver/io/output/run_folder.hpp"

namespace talus::app {
namespace {

constexpr std::string_view states = "cell_states";

std::string state_name(std::size_t number) { return fmt::format("{}/cell_{:06}.vtp", states, number); }
bool names_state(std::string_view file) {
  constexpr std::string_view before = "cell_", after = ".vtp";
  if (!file.starts_with(before) || !file.ends_with(after) || file.size() < before.size() + 6 + after.size())
    return false;
  const std::string_view number = file.substr(before.size(), file.size() - before.size() - after.size());
  return number.find_first_not_of("0123456789") == std::string_view::npos;
}

/// Files besides the states.
constexpr std::array<std::string_view, 8> single{"RESTART.DAT", "PIC.DAT",  "checkpoint.json", "history.csv",
                                                 "profile.csv", "cell.pvd", "plot.json",       "summary.json"};
bool names_file(std::string_view file) { return std::find(single.begin(), single.end(), file) != single.end(); }

const std::filesystem::path& made(const std::filesystem::path& folder) {
  make_folder(folder);
  return folder;
}

}  // namespace

CellFiles::CellFiles(std::filesystem::path folder, const CellScene& scene)
    : folder_{std::move(folder)}, lock_{made(folder_)}, scene_{&scene} {
  if (scene.pictures) make_folder(folder_ / states);
}

void CellFiles::begin(bool taken_on) const {
  // First what would vouch for the rest.
  if (!taken_on) remove_checkpoint();
  std::error_code none;
  // What `talus run` left here would be taken for this cell's.
  if (!taken_on && std::filesystem::exists(folder_ / "final_state.json")) remove_run(folder_);
  const std::filesystem::path of_states = folder_ / states;
  remove_remains(folder_, names_file), remove_remains(of_states, names_state);
  std::filesystem::remove(folder_ / "summary.json", none);
  if (taken_on) return;
  // RESTART.DAT stays until it is written anew: it may be what this run goes on from.
  remove_files(folder_, [](std::string_view file) { return names_file(file) && file != "RESTART.DAT"; });
  remove_files(of_states, names_state);
  if (!scene_->pictures) std::filesystem::remove(of_states, none);  // if nothing else is in it
}

void CellFiles::write_loop(CellRun& run) {
  const Discs discs = run.discs();
  write_whole(folder_ / "RESTART.DAT", cell_restart_text(run.cell(), discs, cycles_before_ + run.steps()));
  if (scene_->pictures) {
    write_whole(folder_ / "PIC.DAT", cell_picture_text(run.cell(), discs));
    write_whole(folder_ / state_name(times_.size() - 1), cell_state_vtp(run));
  }
}

void CellFiles::write_checkpoint(const std::string& text) {
  write_whole(checkpoint(), text);
  next_checkpoint_ = Clock::now() + std::chrono::seconds{1};
}

void CellFiles::write_end(CellRun& run, const CellOutcome& outcome) {
  write_whole(folder_ / "history.csv", cell_history_csv(*scene_, run));
  write_whole(folder_ / "profile.csv", cell_profile_csv(*scene_, run));
  if (scene_->pictures) {
    std::vector<std::pair<double, std::string>> files;
    for (std::size_t k = 0; k < times_.size(); ++k)
      files.emplace_back(times_[k], state_name(k));
    write_whole(folder_ / "cell.pvd", vtk_index(files));
  }
  write_whole(folder_ / "plot.json", cell_plot_json(*scene_, run));
  write_whole(folder_ / "summary.json", cell_summary_json(*scene_, run, outcome));
}

void CellFiles::remove_checkpoint() const {
  std::error_code none;
  std::filesystem::remove(checkpoint(), none);
}

std::vector<std::string> CellFiles::names() const {
  std::vector<std::string> names;
  // A run that fails before its first LOOP leaves none of them.
  if (!times_.empty()) names.emplace_back("RESTART.DAT");
  if (!times_.empty() && scene_->pictures) names.insert(names.end(), {"PIC.DAT", std::string{states}});
  if (scene_->pictures) names.emplace_back("cell.pvd");
  names.insert(names.end(), {"history.csv", "profile.csv", "plot.json", "summary.json"});
  return names;
}

}  // namespace talus::app
