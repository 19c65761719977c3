#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <filesystem>
#include <memory>

#include "solver/app/command.hpp"
#include "solver/base/error.hpp"
#include "solver/io/fence_file.hpp"
#include "solver/io/file/atomic_file.hpp"
#include "solver/io/output/read_final_state.hpp"
#include "solver/scenes/fence_scene.hpp"

namespace talus::app {
namespace {

namespace fs = std::filesystem;

struct ConvertOptions {
  std::string in;
  std::string out;
  std::string after;
};

/// Adds the plastic stretch of the cables from an earlier run.
void stretch(scenes::Fence& fence, const std::string& folder) {
  for (const scenes::StretchedCable& cable : read_stretched_cables(folder, fence.units)) {
    const auto same = std::ranges::find(fence.stretched_cables, cable.cable, &scenes::StretchedCable::cable);
    if (same == fence.stretched_cables.end()) {
      fence.stretched_cables.push_back(cable);
    } else {
      same->stretch += cable.stretch;
    }
  }
  // A cable that the fence does not have is reported here, not only when the scene is run.
  static_cast<void>(scenes::fence_scene(fence));
}

int convert(const ConvertOptions& options) {
  const FenceFormat format = fence_format(options.out);
  std::error_code missing;
  if (fs::equivalent(options.in, options.out, missing)) {
    throw InputError{fmt::format(
        "OUT: found {}, which is IN; it must be another file: comments and units of IN would be lost", options.out)};
  }
  scenes::Fence fence = read_fence(options.in);
  std::string text;
  try {
    if (!options.after.empty()) stretch(fence, options.after);
    text = fence_text(fence, format);
  } catch (const InputError& error) {
    throw InputError{fmt::format("{}: {}", options.in, error.what())};
  }
  write_whole(options.out, text);
  return ok;
}

}  // namespace

Command add_convert(CLI::App& talus) {
  CLI::App* app = talus.add_subcommand("convert", "Write a fence's deck of 1993 as a scene, or its scene as a deck");
  const auto options = std::make_shared<ConvertOptions>();
  app->add_option("IN", options->in, "deck of the 1993 program FENCE (.DAT) or scene with a table [fence] (.toml)")
      ->required();
  app->add_option("OUT", options->out, "file to write, .toml or .DAT")->required();
  app->add_option("--after", options->after,
                  "folder of a run of the same fence: its plastic stretch becomes that of the cables at the start, for "
                  "the next rock");
  app->footer(
      "From a deck to a scene and back every number keeps its bits. A scene in SI units, whose numbers a deck gives "
      "in\n"
      "feet, slugs and pounds, is rounded in the last place.\n"
      "Example:\n  talus convert cases/fence/sample2.DAT sample2.toml\n"
      "  talus run fence.toml --out first && talus convert fence.toml second.toml --after first");
  return {app, [options] { return convert(*options); }};
}

}  // namespace talus::app
