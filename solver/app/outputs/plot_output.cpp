#include "solver/app/outputs/plot_output.hpp"

#include "solver/io/file/atomic_file.hpp"
#include "solver/io/output/write_plot.hpp"

namespace talus::app {
namespace {

/// Bodies as drawn. Bodies of a fence have the numbers of their elements; the half without elements has no numbers (0).
std::vector<DrawnBody> drawn_bodies(const SceneFile& file) {
  std::vector<DrawnBody> bodies;
  for (const Body& body : file.scene.model.bodies) {
    const bool ground = body.mobility == Mobility::fixed;
    bodies.push_back({body.name, file.fence ? 0 : static_cast<int>(bodies.size()) + 1,
                      ground       ? "ground"
                      : file.fence ? "column"
                                   : "body"});
  }
  if (!file.fence) return bodies;
  int number = 0;
  for (const scenes::FenceMember& member : file.fence->made.members) {
    ++number;
    if (!member.body) continue;
    DrawnBody& body = bodies[index(*member.body)];
    body.number = number;
    if (number > 1 && member.layer == 0) body.kind = "rock";
  }
  return bodies;
}

RunFiles drawn_from(const SceneFile& file, const std::string& name) {
  RunFiles files;
  if (file.fence && file.fence->fence.requests_histories()) files.histories.push_back(name + ".history.csv");
  files.histories.emplace_back("history.csv");
  files.geometry = name + ".pvd";
  files.bodies = drawn_bodies(file);
  for (const Cable& cable : file.scene.model.cables)
    files.cables.push_back(cable.name);
  files.mirrored = file.fence && file.fence->fence.options.symmetry == scenes::FenceSymmetry::half;
  return files;
}

}  // namespace

void PlotOutput::write(const OutputSource& source) const {
  write_whole(folder / "plot.json", plot_json(source.record, "history.csv", drawn_from(*file, scene_name)),
              Durability::later);
}

}  // namespace talus::app
