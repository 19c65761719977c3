#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <memory>

#include "solver/app/command.hpp"
#include "solver/base/error.hpp"
#include "solver/io/atomic_file.hpp"
#include "solver/io/fence_file.hpp"

namespace talus::app {
namespace {

struct ConvertOptions {
  std::string in;
  std::string out;
};

int convert(const ConvertOptions& options) {
  const FenceFormat format = fence_format(options.out);
  const scenes::Fence fence = read_fence(options.in);
  std::string text;
  try {
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
  app->footer(
      "From a deck to a scene and back every number keeps its bits. A scene in SI units, whose numbers a deck gives "
      "in\n"
      "feet, slugs and pounds, is rounded in the last place.\n"
      "Example:\n  talus convert cases/fence/sample2.DAT sample2.toml");
  return {app, [options] { return convert(*options); }};
}

}  // namespace talus::app
