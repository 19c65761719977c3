#pragma once

#include "solver/app/outputs/run_output.hpp"

namespace talus::app {

/// plot.json: description of the data from which pictures are drawn.
struct PlotOutput {
  static constexpr std::string_view name = "plot";
  static constexpr std::array<std::string_view, 1> fixed_files{"plot.json"};
  std::filesystem::path folder;
  const SceneFile* file;
  std::string scene_name;

  static std::optional<PlotOutput> make(const OutputRequest& request) {
    return PlotOutput{request.folder, &request.file, request.name};
  }
  void write(const OutputSource& source) const;
};

}  // namespace talus::app
