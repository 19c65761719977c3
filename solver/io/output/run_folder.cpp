#include "solver/io/output/run_folder.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <functional>
#include <set>

#include "solver/base/error.hpp"
#include "solver/io/file/atomic_file.hpp"
#include "solver/io/file/json_text.hpp"
#include "solver/io/file/shown_title.hpp"
#include "verification/record/json_fault.hpp"
#include "verification/record/json_node.hpp"

namespace talus {
namespace {

void read_bodies(const records::Node& geometry, const std::filesystem::path& file, RunFiles& files) {
  for (const records::Node& body : geometry.at("bodies").list()) {
    const std::string kind = body.at("kind").text();
    if (std::find(std::begin(body_kinds), std::end(body_kinds), kind) == std::end(body_kinds)) {
      const std::vector<std::string> known{std::begin(body_kinds), std::end(body_kinds)};
      throw InputError{
          fmt::format("{}: geometry: {}", file.string(), unknown_name("kind of a body", kind, known).what())};
    }
    files.bodies.push_back({body.at("name").text(), body.at("number").integer(), kind});
  }
  files.cables = geometry.at("cables").texts();
  files.mirrored = geometry.at("mirrored").flag();
}

/// The name of a file of the run.
std::string file_of_run(const records::Node& name) {
  if (!is_inside_folder(name.text())) name.refuse("a file in the folder of the run, by a path without \"..\"");
  return name.text();
}

InputError not_of_a_run(const std::filesystem::path& file, std::string_view reason) {
  return InputError{fmt::format("{}: it is not a file written by `talus run --out` or `talus cell --out`: {}",
                                file.string(), reason)};
}

UnitSystem known_units(const std::string& name, const std::filesystem::path& file) {
  try {
    return unit_system(name);
  } catch (const InputError& error) {
    throw InputError{fmt::format("{}: units: {}", file.string(), error.what())};
  }
}

nlohmann::ordered_json geometry_json(const RunFiles& files) {
  if (files.period) return {{"index", files.geometry}, {"period", *files.period}};
  auto bodies = nlohmann::ordered_json::array();
  for (const DrawnBody& body : files.bodies)
    bodies.push_back({{"name", body.name}, {"number", body.number}, {"kind", body.kind}});
  return {{"index", files.geometry}, {"bodies", bodies}, {"cables", files.cables}, {"mirrored", files.mirrored}};
}

}  // namespace

std::string RunFolder::unit(Dimension dimension) const { return units ? symbol(*units, dimension) : std::string{}; }

nlohmann::ordered_json run_folder_json(const std::string& title, const std::optional<UnitSystem>& units,
                                       const RunFiles& files) {
  nlohmann::ordered_json json{{"schema", 1}, {"title", title}, {"units", nullptr}};
  if (units) json["units"] = units->name;
  json["histories"] = files.histories;
  json["geometry"] = geometry_json(files);
  return json;
}

void demand_run_folder(const std::filesystem::path& folder) {
  demand_folder_with(folder, "plot.json", "a folder that `talus run --out` or `talus cell --out` wrote");
}

RunFolder read_run_folder(const std::filesystem::path& folder) {
  demand_run_folder(folder);
  const std::filesystem::path file = folder / "plot.json";
  const std::string text = read_json_text(file);
  RunFolder run{folder, {}, si, {}};
  try {
    const auto json = records::Json::parse(text);
    const records::Node plot{json, "plot"};
    run.title = shown_title(plot.at("title").text(), folder);
    run.units.reset();
    if (!plot.is_null("units")) run.units = known_units(plot.at("units").text(), file);
    for (const records::Node& history : plot.at("histories").list())
      run.files.histories.push_back(file_of_run(history));
    const records::Node geometry = plot.at("geometry");
    if (const records::Node index = geometry.at("index"); !index.text().empty())
      run.files.geometry = file_of_run(index);
    if (!geometry.has("period")) {
      read_bodies(geometry, file, run.files);
      return run;
    }
    run.files.period = geometry.at("period").number();
    if (!(*run.files.period > 0.0)) {
      throw InputError{fmt::format("{}: period: found {}; it must be > 0", file.string(), *run.files.period)};
    }
  } catch (const records::RecordError& error) {
    throw not_of_a_run(file, error.what());
  } catch (const records::Json::exception& error) {
    throw not_of_a_run(file, records::json_fault(error));
  }
  return run;
}

namespace {

/// Files with fixed names of all runs and cells, without the outputs of runs. RESTART.DAT is not among them.
constexpr std::array<std::string_view, 7> single{"history.csv", "summary.json", "plot.json", "checkpoint.json",
                                                 "profile.csv", "cell.pvd",     "PIC.DAT"};

/// Whether a name consists of `before`, at least `digits` digits, and ".vtp".
bool names_vtp(std::string_view file, std::string_view before, std::size_t digits) {
  constexpr std::string_view after = ".vtp";
  if (!file.starts_with(before) || !file.ends_with(after) || file.size() < before.size() + digits + after.size())
    return false;
  const std::string_view number = file.substr(before.size(), file.size() - before.size() - after.size());
  return number.find_first_not_of("0123456789") == std::string_view::npos;
}

bool names_state(std::string_view file) { return names_vtp(file, "cell_", 6); }

bool ends_with_any(std::string_view name, std::initializer_list<std::string_view> ends) {
  return std::any_of(ends.begin(), ends.end(), [&](std::string_view end) { return name.ends_with(end); });
}

constexpr std::string_view geometry_ending = "_geometry";

/// The stems with which runs named their geometry, listing and histories: the stem in the record, and those of the
/// folders of geometry, which a killed run leaves without a record.
std::set<std::string> stems_of(const std::filesystem::path& folder) {
  std::set<std::string> stems;
  std::error_code none;
  try {
    if (std::filesystem::exists(folder / "plot.json", none))
      stems.insert(std::filesystem::path{read_run_folder(folder).files.geometry}.stem().string());
  } catch (const std::exception&) {  // the record of another program
  }
  using Entries = std::filesystem::directory_iterator;
  for (const std::filesystem::directory_entry& entry : Entries{folder, none}) {
    const std::string name = entry.path().filename().string();
    if (!entry.is_directory(none) || !name.ends_with(geometry_ending)) continue;
    const std::string stem = name.substr(0, name.size() - geometry_ending.size());
    // A folder with such a name that no run wrote contains no such file.
    if (std::any_of(Entries{entry.path(), none}, Entries{},
                    [&](const auto& file) { return names_geometry(file.path().filename().string(), stem); }))
      stems.insert(stem);
  }
  stems.erase("");
  return stems;
}

bool all_names(std::string_view) { return true; }

}  // namespace

bool names_geometry(std::string_view file, const std::string& stem) { return names_vtp(file, stem + "_", 8); }

std::string cell_state_name(std::size_t index) { return fmt::format("{}/cell_{:06}.vtp", cell_states_folder, index); }

void remove_unfinished(const std::filesystem::path& folder) {
  std::error_code none;
  std::filesystem::remove(folder / "summary.json", none);
  remove_remains(folder, all_names);
  remove_remains(folder / cell_states_folder, all_names);
}

void remove_run(const std::filesystem::path& folder, const std::vector<std::string_view>& outputs) {
  const std::set<std::string> stems = stems_of(folder);
  std::error_code none;
  // First the files that indicate that the others are valid.
  std::filesystem::remove(folder / "checkpoint.json", none);
  remove_unfinished(folder);
  // Removes the folder, too, if it is then empty.
  const auto remove_from = [&](const std::filesystem::path& inner, const std::function<bool(std::string_view)>& of) {
    remove_files(inner, of);
    std::filesystem::remove(inner, none);
  };
  remove_from(folder / cell_states_folder, names_state);
  if (!stems.empty()) {
    remove_from(folder / "plots", [](std::string_view name) {
      return ends_with_any(name, {".svg", ".pdf", ".ps", ".eps", ".png", ".gif", ".html"});
    });
  }
  for (const std::string& stem : stems) {
    const std::filesystem::path geometry = folder / (stem + std::string{geometry_ending});
    remove_remains(geometry, all_names);
    remove_from(geometry, [&](std::string_view name) { return names_geometry(name, stem); });
  }
  remove_files(folder, [&](std::string_view name) {
    if (std::ranges::find(single, name) != single.end() || std::ranges::find(outputs, name) != outputs.end())
      return true;
    return std::any_of(stems.begin(), stems.end(), [&](const std::string& stem) {
      if (!name.starts_with(stem)) return false;
      const std::string_view ending = name.substr(stem.size());
      return ending == ".pvd" || ending == ".OUT" || ending == ".history.csv" || ending == ".history.json";
    });
  });
}

}  // namespace talus
