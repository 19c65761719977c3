#include "verification/problems/fence/fence_appendix_runs.hpp"

#include <algorithm>
#include <array>
#include <numbers>
#include <utility>

#include "verification/study/fence_table.hpp"

namespace talus::verification::problems {
namespace {

constexpr std::array declared{AppendixTwin{.spin = 2.0},     AppendixTwin{.spin = -2.0}, AppendixTwin{.height = 0.02},
                              AppendixTwin{.height = -0.02}, AppendixTwin{.angle = 7.5}, AppendixTwin{.angle = 15.0},
                              AppendixTwin{.angle = 22.5},   AppendixTwin{.finer = 2},   AppendixTwin{.finer = 10}};

Simulation simulation(std::string name, const scenes::Fence& fence, const Setup& setup, Findings& findings) {
  Simulation made{std::move(name), run_fence(fence, 1), {}};
  findings.count(made.run.evaluations);
  if (setup.coarse) return made;
  for (const AppendixTwin& twin : declared)
    made.twins.push_back(run_fence(shifted(fence, twin)).peaks);
  return made;
}

}  // namespace

double Simulation::low(double FenceSample::*quantity) const {
  double least = run.peaks.*quantity;
  for (const FenceSample& twin : twins)
    least = std::min(least, twin.*quantity);
  return least;
}

double Simulation::high(double FenceSample::*quantity) const {
  double largest = run.peaks.*quantity;
  for (const FenceSample& twin : twins)
    largest = std::max(largest, twin.*quantity);
  return largest;
}

scenes::Fence shifted(scenes::Fence fence, const AppendixTwin& twin) {
  for (scenes::FenceElement& rock : fence.rocks) {
    rock.spin += twin.spin;
    rock.position.y += twin.height;
    rock.angle += twin.angle * std::numbers::pi / 180.0;
  }
  fence.step_factor /= twin.finer;
  fence.steps *= twin.finer;
  return fence;
}

scenes::Fence appendix_fence(const std::string& deck, const Setup& setup) {
  scenes::Fence fence = published_fence(deck);
  if (setup.has("mass_doubled")) fence.column.density *= 2.0;
  if (setup.has("bottom_cable_left_out")) fence.connections = 1;
  if (setup.has("one_layer")) fence.layers = 1;
  return fence;
}

Simulations simulations(const Setup& setup, Findings& findings) {
  scenes::Fence one_top_only = appendix_fence("appendix_one_layer.DAT", setup);
  one_top_only.connections = 1;
  return {
      simulation("one layer", appendix_fence("appendix_one_layer.DAT", setup), setup, findings),
      simulation("two layers", appendix_fence("appendix_two_layers.DAT", setup), setup, findings),
      simulation("two layers, nine rocks", appendix_fence("appendix_nine_rocks.DAT", setup), setup, findings),
      simulation("two layers, top cable only", appendix_fence("appendix_top_cable_only.DAT", setup), setup, findings),
      simulation("one layer, top cable only", one_top_only, setup, findings)};
}

}  // namespace talus::verification::problems
