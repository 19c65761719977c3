#include "solver/app/sweep/engine.hpp"

#include <fmt/format.h>

#include "solver/base/error.hpp"
#include "solver/command_line/shell_word.hpp"
#include "solver/io/file/toml_document.hpp"

namespace talus::app {
namespace {

/// A folder in a pattern of sbatch, where % begins a variable.
std::string escaped(const std::string& folder) {
  std::string text;
  for (const char letter : folder)
    text += letter == '%' ? std::string{"%%"} : std::string{letter};
  return text;
}

}  // namespace

std::string part_script(const EngineRequest& request) {
  return fmt::format(
      "#!/bin/sh\n"
      "# One of {0} parts of a sweep: the first argument, or that of the Slurm task.\n"
      "exec {1} sweep run {2} --shard \"${{1:-$SLURM_ARRAY_TASK_ID}}/{0}\" --threads 1\n",
      request.parts, single_quoted(request.program.string()), single_quoted(request.folder.string()));
}

reports::Command engine_command(Engine engine, const EngineRequest& request, const std::filesystem::path& script) {
  if (engine != Engine::parallel && !request.hosts.empty())
    throw InputError{"--hosts: only the engine 'parallel' uses it; remove it"};
  if (engine != Engine::slurm && request.waits) throw InputError{"--wait: only the engine 'slurm' uses it; remove it"};
  reports::Command command;
  if (engine == Engine::slurm) {
    command.program = "sbatch";
    command.arguments = {fmt::format("--array=1-{}", request.parts),
                         fmt::format("--job-name=talus-{}", request.folder.filename().string()), "--cpus-per-task=1",
                         "--output=" + escaped(request.folder.string()) + "/part-%a.log"};
    if (request.waits) command.arguments.emplace_back("--wait");
    command.arguments.insert(command.arguments.end(), request.options.begin(), request.options.end());
    command.arguments.push_back(script.string());
    return command;
  }
  TALUS_DEMAND(engine == Engine::parallel);
  command.program = "parallel";
  // Its default is a process for each core; hosts have their own numbers of them.
  if (request.hosts.empty()) {
    command.arguments = {"--jobs", fmt::format("{}", request.threads)};
  } else {
    try {
      static_cast<void>(read_text(request.hosts));
    } catch (const IoError& error) {
      throw IoError{fmt::format("--hosts: {}", error.what())};
    }
    command.arguments = {"--sshloginfile", request.hosts};
  }
  command.arguments.insert(command.arguments.end(), request.options.begin(), request.options.end());
  // A word that is no part of a folder's name, as {} may be.
  const std::string number = "TALUS_PART_NUMBER";
  command.arguments.insert(command.arguments.end(),
                           {"-I", number, "/bin/sh", single_quoted(script.string()), number, ":::"});
  for (std::size_t part = 1; part <= request.parts; ++part)
    command.arguments.push_back(fmt::format("{}", part));
  return command;
}

}  // namespace talus::app
