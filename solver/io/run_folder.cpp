#include "solver/io/run_folder.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <nlohmann/json.hpp>

#include "solver/base/error.hpp"
#include "solver/io/toml_document.hpp"

namespace talus {

RunFolder read_run_folder(const std::filesystem::path& folder) {
  const std::filesystem::path file = folder / "plot.json";
  const std::string text = read_text(file);
  RunFolder run{folder, {}, si, {}};
  try {
    const auto json = nlohmann::json::parse(text);
    run.title = json.at("title").get<std::string>();
    run.units = unit_system(json.at("units").get<std::string>());
    run.files.histories = json.at("histories").get<std::vector<std::string>>();
    const auto& geometry = json.at("geometry");
    run.files.geometry = geometry.at("index").get<std::string>();
    for (const auto& body : geometry.at("bodies")) {
      const std::string kind = body.at("kind").get<std::string>();
      if (std::find(std::begin(body_kinds), std::end(body_kinds), kind) == std::end(body_kinds)) {
        throw InputError{fmt::format("{}: body kind '{}' is not known", file.string(), kind)};
      }
      run.files.bodies.push_back({body.at("name").get<std::string>(), body.at("number").get<int>(), kind});
    }
    run.files.cables = geometry.at("cables").get<std::vector<std::string>>();
    run.files.mirrored = geometry.at("mirrored").get<bool>();
  } catch (const nlohmann::json::exception& error) {
    throw InputError{fmt::format("{}: it is not what `talus run --out` leaves: {}", file.string(), error.what())};
  }
  return run;
}

}  // namespace talus
