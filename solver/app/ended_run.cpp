#include "solver/app/ended_run.hpp"

#include <fmt/format.h>

#include <nlohmann/json.hpp>

#include "solver/app/command.hpp"
#include "solver/app/run_order.hpp"
#include "solver/base/error.hpp"
#include "solver/io/file/toml_document.hpp"

namespace talus::app {

namespace fs = std::filesystem;

std::optional<EndedRun> ended_run(const fs::path& folder) {
  std::error_code none;
  if (fs::exists(folder / checkpoint_name, none)) return {};
  try {
    EndedRun run{.summary = read_text(folder / "summary.json"), .failure = {}};
    const auto outcome = nlohmann::json::parse(run.summary).at("outcome");
    const auto kind = outcome.at("kind").get<std::string>();
    if (kind == "diverged") run.failure = outcome.at("words").get<std::string>();
    if (kind == "diverged" || kind == "finished") return run;
  } catch (const IoError&) {
    // No summary: no run ended here, and that its checkpoint is missing is said where it is read.
  } catch (const nlohmann::json::exception&) {
    // The same for a file of another program.
  }
  return {};
}

int report_ended_run(const fs::path& folder, const EndedRun& run, bool json) {
  if (json) fmt::print("{}", run.summary);
  if (!run.failure.empty()) {
    print_failure(fmt::format("{}: the run diverged and cannot be resumed: {}", folder.string(), run.failure));
    return diverged;
  }
  if (!json) fmt::print("{}: the run is finished; there is nothing to resume\n", folder.string());
  return ok;
}

}  // namespace talus::app
