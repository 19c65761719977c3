#include "solver/draw/drawn_states.hpp"

#include <fmt/format.h>

#include "solver/base/error.hpp"
#include "solver/base/progress.hpp"

namespace talus::app {

std::vector<GeometryFile> state_files(const RunFolder& run) {
  if (run.files.geometry.empty()) {
    throw InputError{fmt::format(
        "{}: the run wrote no states; set GRAPH = 1 in CNTRL.DAT or pictures = \"on\" in [run] to write them",
        run.folder.string())};
  }
  return read_geometry_index(run.folder / run.files.geometry);
}

DrawnStates read_states(const RunFolder& run, const std::vector<GeometryFile>& files, const std::string& colour) {
  const ElapsedTime elapsed{"reading the states"};
  if (run.files.period) return read_disc_frames(run, files, find_named<DiscColour>(colour).value_or(DiscColour::speed));
  if (!colour.empty()) {
    throw InputError{fmt::format("--colour: found \"{}\"; {} holds bodies and cables, and only discs are coloured so",
                                 colour, run.folder.string())};
  }
  return read_frames(run, files);
}

}  // namespace talus::app
