#include "solver/app/scene_files.hpp"

#include <algorithm>

#include "solver/base/error.hpp"

namespace talus::app {
namespace {

std::optional<FenceFiles> fence_files(const SceneFile& file, const Dynamics& dynamics,
                                      const std::filesystem::path& folder, const std::filesystem::path& scene) {
  if (!file.fence) return {};
  try {
    return std::optional<FenceFiles>{std::in_place, *file.fence, file.scene.plan,
                                     dynamics,      folder,      scene.stem().string()};
  } catch (const InputError& error) {
    throw InputError{scene.string() + ": " + error.what()};
  }
}

}  // namespace

long steps_between_states(const SceneFile& file, long frames) {
  constexpr long usual_frames = 100;
  if (frames == 0 && file.fence) return file.fence->fence.print_every;
  return std::max(1L, step_count(file.scene.plan) / (frames == 0 ? usual_frames : frames));
}

SceneFiles::SceneFiles(const SceneFile& file, const Dynamics& dynamics, const std::filesystem::path& folder,
                       const std::filesystem::path& scene, long frames)
    : file_{&file},
      name_{scene.stem().string()},
      of_fence_{fence_files(file, dynamics, folder, scene)},
      geometry_{dynamics, folder, name_, steps_between_states(file, frames)} {}

void SceneFiles::operator()(const Snapshot& snapshot, const StepInfo& info) {
  if (of_fence_) (*of_fence_)(snapshot, info);
  geometry_(snapshot, info);
}

void SceneFiles::write() const {
  if (of_fence_) of_fence_->write();
  geometry_.write_index();
}

void SceneFiles::remember(Memory& memory) {
  if (of_fence_) memory.part("fence", [&] { of_fence_->remember(memory); });
  memory.part("geometry", [&] { geometry_.remember(memory); });
}

std::vector<std::string> SceneFiles::names() const {
  std::vector<std::string> names;
  if (of_fence_) names = of_fence_->names();
  names.push_back(name_ + ".pvd");
  return names;
}

std::vector<std::string> SceneFiles::left_out() const {
  if (of_fence_) return of_fence_->left_out();
  return {};
}

RunFiles SceneFiles::drawn_from() const {
  RunFiles files;
  if (of_fence_) files.histories.push_back(name_ + ".history.csv");
  files.histories.emplace_back("history.csv");
  files.geometry = name_ + ".pvd";
  files.bodies = drawn_bodies();
  for (const Cable& cable : file_->scene.model.cables)
    files.cables.push_back(cable.name);
  files.mirrored = of_fence_ && file_->fence->fence.options.symmetry == scenes::FenceSymmetry::half;
  return files;
}

/// Bodies of a fence bear the numbers of their elements; of the half that has none, none.
std::vector<DrawnBody> SceneFiles::drawn_bodies() const {
  std::vector<DrawnBody> bodies;
  for (const Body& body : file_->scene.model.bodies) {
    const bool ground = body.mobility == Mobility::fixed;
    bodies.push_back({body.name, of_fence_ ? 0 : static_cast<int>(bodies.size()) + 1,
                      ground      ? "ground"
                      : of_fence_ ? "column"
                                  : "body"});
  }
  if (!of_fence_) return bodies;
  int number = 0;
  for (const scenes::FenceMember& member : file_->fence->made.members) {
    ++number;
    if (!member.body) continue;
    DrawnBody& body = bodies[index(*member.body)];
    body.number = number;
    if (number > 1 && member.layer == 0) body.kind = "rock";
  }
  return bodies;
}

}  // namespace talus::app
