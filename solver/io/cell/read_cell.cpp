#include "solver/io/cell/read_cell.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <sstream>

#include "solver/base/error.hpp"
#include "solver/granular/disc_method.hpp"
#include "solver/integrate/euler.hpp"
#include "solver/io/file/fortran.hpp"
#include "solver/io/file/list_directed.hpp"
#include "solver/io/file/shown_title.hpp"
#include "solver/io/file/toml_document.hpp"
#include "solver/io/scene/read_friction.hpp"
#include "solver/io/scene/scene_parts.hpp"

namespace talus {
namespace {

void choose(CellScene& scene, const CellChoices& choices) {
  if (choices.integrator) scene.plan.integrator = *choices.integrator;
  if (choices.seed) scene.cell.seed = *choices.seed;
  if (choices.historical) scene.plan.historical = true;
  if (choices.jump) scene.plan.jump = true;
  if (choices.virtual_discs) scene.plan.images = Images::virtual_discs;
  static_cast<void>(make_disc_method(scene.plan.integrator));
}

/// The command-line option that sets a field; empty if the file sets it.
std::string_view option_of(const CellChoices& choices, std::string_view field) {
  if (field == "integrator" && choices.integrator) return "--integrator";
  if (field == "historical" && choices.historical) return "--historical";
  if (field == "images" && choices.virtual_discs) return "--virtual";
  if (field == "jump" && choices.jump) return "--jump";
  return {};
}
/// Throws the error under the name of the option that sets its field; returns if the file sets it. Errors: InputError.
void blame_option(const CellChoices& choices, const CellError& error) {
  if (const std::string_view option = option_of(choices, error.field); !option.empty())
    throw InputError{fmt::format("{}: {}", option, error.message)};
}

/// Errors of a historical run, which must be as the runs of 1989 may have been: Euler, K1/K2 = 0.45 and a step of 1e-7
/// (both numbers are from the thesis; Euler's method is inferred from them).
std::vector<CellError> historical_errors(const CellScene& scene) {
  std::vector<CellError> found;
  const LatchingSpring* const law = scene.cell.law_of_1989();
  if (!scene.plan.historical || law == nullptr) return found;
  const double ratio = law->stiffness / law->unloading_stiffness;
  if (scene.plan.integrator != Euler::name) {
    found.push_back(
        {"integrator", fmt::format("found {}; a historical run requires {}", scene.plan.integrator, Euler::name)});
  }
  if (std::abs(ratio - 0.45) > 1e-9) {
    found.push_back({"unloading_stiffness", fmt::format("found {}; a historical run has K1/K2 = 0.45: it must be {}",
                                                        law->unloading_stiffness, law->stiffness / 0.45)});
  }
  if (std::abs(scene.plan.step - 1e-7) > 1e-16)
    found.push_back({"step", fmt::format("found {}; a historical run has a step of 1e-7", scene.plan.step)});
  return found;
}

std::vector<CellError> all_errors(const CellScene& scene) {
  std::vector<CellError> found = validation_errors(scene.cell, scene.plan);
  const auto more = historical_errors(scene);
  found.insert(found.end(), more.begin(), more.end());
  return found;
}

/// Reads the records of CNTRL.DAT and stores the location of each number.
class ControlReader {
  struct Location {
    int line{};
    std::string record, name;
  };

  [[noreturn]] void fail(int line, std::string_view record, std::string_view name, std::string_view message) const {
    throw InputError{fmt::format("{}:{}: {}: {}: {}", name_, std::max(line, 1), record, name, message)};
  }

  template <class Action>
  auto placed(std::string_view name, Action&& action) {
    try {
      return action();
    } catch (const InputError& error) {
      fail(input_.line(), record_, name, error.what());
    }
  }

  std::string_view value(std::string_view name) {
    return placed(name, [&] { return input_.value(); });
  }

 public:
  ControlReader(std::string_view text, std::string_view name) : input_{text}, name_{name} {}

  void record(std::string_view names) {
    input_.start_record();
    record_ = names;
  }

  /// `field` is the name that validation_errors uses.
  double real(std::string_view name, std::string_view field) {
    const std::string_view text = value(name);
    locations_[std::string{field}] = {input_.line(), std::string{record_}, std::string{name}};
    double number = 0.0;
    if (!placed(name, [&] { return parse_fortran_real(text, number); }))
      fail(input_.line(), record_, name, found_text(text) + "; it must be a number");
    return number;
  }

  int whole(std::string_view name, std::string_view field, int minimum, int maximum) {
    const double number = real(name, field);
    if (number != std::floor(number) || number < minimum || number > maximum) {
      const std::string allowed = maximum - minimum == 1
                                      ? fmt::format("{} or {}", minimum, maximum)
                                      : fmt::format("a whole number between {} and {}", minimum, maximum);
      fail(input_.line(), record_, name, fmt::format("found {}; it must be {}", number, allowed));
    }
    return static_cast<int>(number);
  }

  [[noreturn]] void fail(const CellError& error) const {
    const auto location = locations_.find(error.field);
    if (location == locations_.end()) throw InputError{fmt::format("{}: {}: {}", name_, error.field, error.message)};
    const auto& [line, record, name] = location->second;
    fail(line, record, name, error.message);
  }

 private:
  ListDirected input_;
  std::string name_;
  std::string_view record_;
  std::map<std::string, Location> locations_;
};

template <std::size_t N>
const CountField<ShearCell>& count(const std::array<CountField<ShearCell>, N>& fields, std::string_view name) {
  for (const auto& field : fields)
    if (field.name == name) return field;
  TALUS_DEMAND(false);
}

CellScene read_control(std::string_view text, std::string_view name, const CellChoices& choices) {
  ControlReader reader{text, name};
  CellScene scene{.title = "Shear cell", .units = choices.units, .cell = {}, .plan = {}};
  ShearCell& cell = scene.cell;
  constexpr auto counts = ShearCell::counts();
  const auto whole = [&](std::string_view deck_name, std::string_view field) {
    const auto& range = count(counts, field);
    return reader.whole(deck_name, field, static_cast<int>(range.minimum), static_cast<int>(range.maximum));
  };
  reader.record("RESTRT GRAPH");
  scene.restart = reader.whole("RESTRT", "restart", 0, 1) == 1;
  scene.pictures = reader.whole("GRAPH", "pictures", 0, 1) == 1;
  reader.record("K1 K2 D M G MTOP");
  LatchingSpring law;
  law.stiffness = reader.real("K1", "stiffness");
  law.unloading_stiffness = reader.real("K2", "unloading_stiffness");
  cell.law = law;
  cell.diameter = reader.real("D", "diameter");
  cell.mass = reader.real("M", "mass");
  cell.gravity = reader.real("G", "gravity");
  cell.block_mass = reader.real("MTOP", "block_mass");
  reader.record("NHT NWID TWID VXT");
  cell.rows = whole("NHT", "rows");
  cell.columns = whole("NWID", "columns");
  cell.wall_discs = whole("TWID", "wall_discs");
  cell.block_speed = reader.real("VXT", "block_speed");
  reader.record("STEP LOOP TIME");
  scene.plan.step = reader.real("STEP", "step");
  scene.plan.every = reader.real("LOOP", "every");
  scene.plan.end = reader.real("TIME", "end");
  choose(scene, choices);
  if (const auto found = all_errors(scene); !found.empty()) {
    blame_option(choices, found.front());
    reader.fail(found.front());
  }
  return scene;
}

/// Whether the first of two keys is present; reports an error if both are, or neither.
bool has_first(SceneTable& table, std::string_view first, std::string_view second) {
  if (table.has(first) == table.has(second)) {
    const bool both = table.has(first);
    table.report(both ? second : first, both ? fmt::format("found beside {}; give one of the two", first)
                                             : fmt::format("it is missing; give {} or {}", second, first));
  }
  return table.has(first);
}

/// Restitution, a pure number in (0, 1]; 1 if it is missing, which has been reported as an error.
double read_restitution(SceneTable& table) {
  return table.has("restitution") ? table.number("restitution", Range::positive_fraction) : 1.0;
}

/// Reads the law's fields; `restitution` may replace the field that dissipates energy, and is returned.
template <class L>
std::optional<double> read_law(SceneTable& table, L& law) {
  if constexpr (HasEndRule<L>) law.end_rule = table.choice_or("end_rule", law.end_rule);
  if constexpr (HasHertzDashpot<L>) law.dashpot = table.choice_or("dashpot", law.dashpot);
  std::optional<double> restitution;
  for (const auto& field : L::fields()) {
    if (field.name == L::restitution_field.name && !has_first(table, field.name, "restitution"))
      restitution = read_restitution(table);
    else
      table.read_field(law, field);
  }
  return restitution;
}

/// Reports an error; if the file gives the value in other units than the message, the value as written comes first.
void object(const SceneTable& table, const CellError& error) {
  constexpr std::string_view found = "found ";
  const std::string written = table.written(error.field);
  const std::string_view rest = std::string_view{error.message}.substr(found.size());
  if (written.empty() || rest.starts_with(written)) return table.report(error.field, error.message);
  table.report(error.field, fmt::format("found \"{}\", in {}: {}", written, table.units().name, rest));
}

/// All keys that [cell] may have with this law.
template <class L>
std::vector<std::string> cell_keys() {
  std::vector<std::string> keys = field_names<L>();
  if constexpr (HasEndRule<L>) keys.emplace_back("end_rule");
  if constexpr (HasHertzDashpot<L>) keys.emplace_back("dashpot");
  if constexpr (!HasLinearPart<L>) keys.emplace_back("impact_speed");
  keys.emplace_back("restitution");
  const std::vector<std::string> friction = friction_keys<DiscFrictions, L>(false);
  keys.insert(keys.end(), friction.begin(), friction.end());
  keys.insert(keys.end(), {"overburden", "seed"});
  for (const auto& field : ShearCell::fields())
    keys.emplace_back(field.name);
  for (const auto& field : ShearCell::counts())
    keys.emplace_back(field.name);
  return keys;
}

/// Reads friction. The default of `shear_stiffness` is not known before the law is complete: until complete() it is 0.
void read_disc_friction(SceneTable& table, ShearCell& cell) {
  constexpr double any = 1.0;
  cell.friction = std::visit(
      [&]<class L>(const L&) { return read_friction<DiscFrictions, L>(table, any, false, false); }, cell.law);
  auto* const constant = cell.friction ? std::get_if<CoulombFriction>(&*cell.friction) : nullptr;
  if (constant != nullptr && !table.has("shear_stiffness")) constant->stiffness = 0.0;
}

/// Reads all fields of [cell]. Returns the restitution, if it is given: the law's parameter follows from it and the
/// other fields.
std::optional<double> read_cell_table(SceneTable& table, ShearCell& cell) {
  std::optional<double> restitution;
  table.guard([&] {
    const std::string law =
        table.has("law") ? table.choice("law", DiscLaws::names()) : std::string{LatchingSpring::name};
    visit_named<DiscLaw>(law, [&]<class L>(L wanted) {
      table.allow(cell_keys<L>());
      restitution = read_law(table, wanted);
      if constexpr (!HasLinearPart<L>)
        cell.impact_speed = table.quantity_or("impact_speed", dimension::velocity, 0.0, Range::positive);
      cell.law = wanted;
    });
  });
  for (const auto& field : ShearCell::fields())
    if (field.name != "block_mass") table.read_field(cell, field);
  for (const auto& field : ShearCell::counts())
    table.read_count(cell, field);
  if (has_first(table, "block_mass", "overburden")) {
    cell.block_mass = table.quantity("block_mass", dimension::mass, Range::positive);
  } else if (table.has("overburden")) {
    const double pressure = table.quantity("overburden", dimension::pressure, Range::positive);
    if (cell.gravity == 0.0) table.report("overburden", "found with gravity = 0; it requires gravity > 0");
    cell.block_mass = pressure * cell.wall_discs * cell.diameter * cell.diameter / cell.gravity;
  }
  if (table.has("seed")) {
    cell.seed = static_cast<std::uint64_t>(table.whole_between("seed", 0, maximum_seed));
  }
  read_disc_friction(table, cell);
  return restitution;
}

/// Sets what follows from several fields, each of which is valid: the parameter of the law that sets the restitution of
/// two discs, and the default of the shear stiffness. Reports the errors of a cell without impacts by which to set
/// them.
void complete(const SceneTable& table, std::optional<double> restitution, ShearCell& cell) {
  const auto has_impacts = [&] {
    if (cell.is_linear()) return true;
    ShearCell smooth = cell;
    smooth.friction.reset();
    const std::vector<CellError> found = validation_errors(smooth);
    for (const CellError& error : found)
      object(table, error);
    return found.empty();
  };
  if (!has_impacts()) return;
  if (restitution) {
    std::visit(
        [&](auto& law) {
          table.placed([&] { law.set_restitution(*restitution, 0.5 * cell.mass, cell.nominal_speed()); });
        },
        cell.law);
    if (!has_impacts()) return;
  }
  auto* const constant = cell.friction ? std::get_if<CoulombFriction>(&*cell.friction) : nullptr;
  if (constant != nullptr && constant->stiffness == 0.0) constant->stiffness = cell.stiffness();
}

bool is_deck(std::string_view name) { return name.ends_with(".DAT") || name.ends_with(".dat"); }

/// All keys that [run] of a cell may have.
std::vector<std::string> run_keys() {
  std::vector<std::string> keys = field_names<CellPlan>();
  keys.insert(keys.end(), {"integrator", "jump", "images", "historical", "pictures"});
  return keys;
}

void read_run_table(SceneTable& run, CellScene& scene) {
  run.allow(run_keys());
  if (run.has("integrator")) run.guard([&] { scene.plan.integrator = run.choice("integrator", disc_method_names()); });
  run.read_fields(scene.plan);
  scene.plan.jump = run.on_or_off("jump");
  scene.plan.images = run.choice_or("images", scene.plan.images);
  scene.plan.historical = run.on_or_off("historical");
  scene.pictures = run.on_or_off("pictures");
}

/// Reports all validation_errors of a cell and its run, which the ranges of single fields do not cover.
void check_whole(const CellScene& scene, const CellChoices& choices, const SceneTable& cell, const SceneTable& run) {
  const std::vector<CellError> found = all_errors(scene);
  if (!found.empty()) blame_option(choices, found.front());
  const std::vector<std::string> keys = run_keys();
  for (const CellError& error : found) {
    if (!option_of(choices, error.field).empty()) continue;
    object(std::ranges::find(keys, error.field) != keys.end() ? run : cell, error);
  }
}

CellScene read_toml(const TomlValue& document, std::string_view name, const CellChoices& choices) {
  SceneSource source{std::string{name}, si};
  SceneTable file{source, document, ""};
  if (choices.units) throw InputError{fmt::format("{}: a unit system is named in the file already", name)};
  source.collect();
  file.allow({"title", "units", "cell", "run"});
  file.guard([&] { source.units = unit_system(file.choice("units", unit_system_names())); });
  CellScene scene{.title = {}, .units = source.units, .cell = {}, .plan = {}};
  file.guard([&] { scene.title = shown_title(file.title(), name); });
  std::optional<SceneTable> cell, run;
  std::optional<double> restitution;
  file.guard([&] { restitution = read_cell_table(cell.emplace(file.table("cell")), scene.cell); });
  file.guard([&] { read_run_table(run.emplace(file.table("run")), scene); });
  source.check();
  source.collect();
  complete(*cell, restitution, scene.cell);
  source.check();
  choose(scene, choices);
  source.collect();
  check_whole(scene, choices, *cell, *run);
  source.check();
  return scene;
}

}  // namespace

CellScene read_cell(std::string_view text, std::string_view name, const CellChoices& choices) {
  return is_deck(name) ? read_control(text, name, choices) : read_toml(parse_toml(text, name), name, choices);
}

CellScene read_cell(const TomlValue& document, std::string_view name, const CellChoices& choices) {
  return read_toml(document, name, choices);
}

bool describes_cell(const TomlValue& document) {
  const auto& table = std::get<TomlTable>(document.data);
  return std::ranges::any_of(table, [](const TomlEntry& entry) { return entry.key == "cell"; });
}

bool describes_cell(const std::filesystem::path& file) { return describes_cell(read_text(file), file); }

bool describes_cell(std::string_view text, const std::filesystem::path& file) {
  if (!is_deck(file.string())) {
    if (text.find("cell") == std::string_view::npos) return false;  // avoids parsing a long scene twice
    return describes_cell(parse_toml(text, file.string()));
  }
  if (file.filename() == "CNTRL.DAT") return true;
  std::istringstream tokens{std::string{without_mark(text)}};
  int numbers = 0;
  for (std::string word; tokens >> word; ++numbers) {
    double number = 0.0;
    if (!parse_fortran_real(word, number)) return false;
  }
  return numbers == 15;
}

CellScene read_cell(const std::filesystem::path& file, const CellChoices& choices) {
  return read_cell(read_text(file), file.string(), choices);
}

}  // namespace talus
