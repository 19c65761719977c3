#pragma once

#include "solver/app/outputs/run_output.hpp"
#include "solver/io/output/write_geometry.hpp"

namespace talus::app {

/// Number of steps between two states of the geometry: `frames` states, evenly over the run; with frames = 0 nprint
/// steps for a fence, else 100 states.
[[nodiscard]] long steps_between_states(const SceneFile& file, long frames);

/// NAME.pvd with NAME_geometry/: outlines and cables for ParaView.
class GeometryOutput {
 public:
  static constexpr std::string_view name = "geometry";
  static constexpr std::array<std::string_view, 0> fixed_files{};

  explicit GeometryOutput(const OutputRequest& request)
      : index_{request.name + ".pvd"},
        series_{request.dynamics, request.folder, request.name,
                steps_between_states(request.file, request.options.frames)} {}

  static std::optional<GeometryOutput> make(const OutputRequest& request) { return GeometryOutput{request}; }
  void operator()(const Snapshot& snapshot, const StepInfo& info) { series_(snapshot, info); }
  void write(const OutputSource&) const { series_.write_index(); }
  std::vector<std::string> files() const { return {index_}; }
  void serialize(Archive& archive) { series_.serialize(archive); }
  void bring_files(const std::filesystem::path& from) { series_.bring_files(from); }

 private:
  std::string index_;
  VtpSeries series_;
};

}  // namespace talus::app
