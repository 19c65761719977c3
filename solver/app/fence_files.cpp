#include "solver/app/fence_files.hpp"

#include "solver/io/file/atomic_file.hpp"

namespace talus::app {

FenceFiles::FenceFiles(const FenceInput& input, const RunPlan& plan, const Dynamics& dynamics,
                       const std::filesystem::path& folder, const std::string& name)
    : folder_{folder},
      name_{name},
      history_{input.fence, input.made, dynamics},
      listing_{input.fence, input.made, plan} {}

void FenceFiles::operator()(const Snapshot& snapshot, const StepInfo& info) {
  history_(snapshot, info);
  listing_(snapshot.state(), info);
}

void FenceFiles::write() const {
  write_whole(folder_ / (name_ + ".OUT"), listing_.text(), Durability::later);
  write_whole(folder_ / (name_ + ".history.csv"), history_.csv_text(), Durability::later);
  write_whole(folder_ / (name_ + ".history.json"), history_.json_text(), Durability::later);
}

void FenceFiles::remember(Memory& memory) {
  memory.part("history", [&] { history_.remember(memory); });
  memory.part("listing", [&] { listing_.remember(memory); });
}

std::vector<std::string> FenceFiles::names() const {
  return {name_ + ".OUT", name_ + ".history.csv", name_ + ".history.json"};
}

}  // namespace talus::app
