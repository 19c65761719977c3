#include <fmt/format.h>
#include <fmt/ranges.h>

#include <CLI/CLI.hpp>
#include <memory>

#include "solver/app/command.hpp"
#include "solver/command_line/completion.hpp"
#include "solver/io/scene/scene_template.hpp"

namespace talus::app {

Command add_new(CLI::App& talus) {
  struct Options {
    std::string kind;
    std::string units{si.name};
  };
  CLI::App* app = talus.add_subcommand("new", "Print a commented scene file of a kind, as a start for a new one");
  const auto options = std::make_shared<Options>();
  const std::vector<std::string> kinds = template_kinds();
  offer(app->add_option("KIND", options->kind, fmt::format("{}", fmt::join(kinds, ", ")))->required(), kinds);
  offer(app->add_option("--units", options->units, "unit system of its quantities, SI or US")->capture_default_str(),
        unit_system_names());
  app->footer(
      "Example:\n  talus new fence > my.toml && talus run my.toml --out out\n"
      "The file runs as it is; its comments say what each field means.");
  return {app, [options] {
            fmt::print("{}", scene_template(options->kind, unit_system(options->units)));
            return ok;
          }};
}

}  // namespace talus::app
