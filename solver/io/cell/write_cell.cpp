#include "solver/io/cell/write_cell.hpp"

#include <fmt/format.h>

#include <array>
#include <cmath>
#include <iterator>
#include <limits>
#include <nlohmann/json.hpp>

#include "solver/io/file/vtk_text.hpp"
#include "verification/record/csv.hpp"
#include "verification/record/json_number.hpp"

namespace talus {
namespace {

using Json = nlohmann::ordered_json;
using records::json_number;
using Q = CellQuantity;

std::string unit(const CellScene& scene, Dimension dimension) {
  return scene.units ? symbol(*scene.units, dimension) : std::string{};
}

Json numbers(const CellScene& scene, const std::vector<CellNumber>& of) {
  Json json = Json::object();
  for (const CellNumber& each : of) {
    Json entry{{"value", nullptr}};
    if (!std::isnan(each.estimate.value)) entry["value"] = json_number(each.estimate.value);
    if (each.estimate.error > 0.0) entry["error"] = json_number(each.estimate.error);
    if (each.drift != 0.0) entry["drift"] = json_number(each.drift);
    if (scene.units && each.dimension != dimension::number) entry["unit"] = unit(scene, each.dimension);
    entry["meaning"] = each.meaning;
    json[each.name] = std::move(entry);
  }
  return json;
}

/// Adds the fields that a scene gives for friction; `shear_law` only where there is a choice.
void add_friction(Json& json, const ShearCell& cell) {
  const bool has_choice =
      std::visit([]<class L>(const L&) { return friction_names_of<DiscFrictions, L>().size() > 1; }, cell.law);
  std::visit(
      [&]<class F>(const F& friction) {
        if (has_choice) json["shear_law"] = std::string{F::name};
        for (const auto& field : F::fields())
          if (is_friction_field(field.name) && field.name != "shear_damping")
            json[std::string{field.name}] = friction.*field.member;
      },
      *cell.friction);
}

Json parameters(const CellScene& scene) {
  Json json = Json::object();
  const ShearCell& cell = scene.cell;
  std::visit(
      [&]<class L>(const L& law) {
        json["law"] = std::string{law.name};
        for (const auto& field : law.fields())
          json[std::string{field.name}] = law.*field.member;
        if constexpr (HasEndRule<L>) json["end_rule"] = std::string{name_of(law.end_rule)};
        if constexpr (HasHertzDashpot<L>) json["dashpot"] = std::string{name_of(law.dashpot)};
        if constexpr (!HasLinearPart<L>) json["impact_speed"] = cell.nominal_speed();
      },
      cell.law);
  if (cell.friction) add_friction(json, cell);
  for (const auto& field : ShearCell::fields())
    json[std::string{field.name}] = cell.*field.member;
  for (const auto& field : ShearCell::counts())
    json[std::string{field.name}] = cell.*std::get<int ShearCell::*>(field.member);
  json["overburden"] = cell.overburden();
  json["seed"] = cell.seed;
  json["integrator"] = scene.plan.integrator;
  for (const auto& field : CellPlan::fields())
    json[std::string{field.name}] = scene.plan.*field.member;
  json["historical"] = scene.plan.historical;
  json["jump"] = scene.plan.jump;
  json["images"] = std::string{name_of(scene.plan.images)};
  return json;
}

struct HistoryColumn {
  const char* name;
  Dimension dimension;
  Q quantity;
};
constexpr std::array cell_columns{
    HistoryColumn{"top_shear", dimension::pressure, Q::top_shear},
    HistoryColumn{"top_normal", dimension::pressure, Q::top_normal},
    HistoryColumn{"bottom_shear", dimension::pressure, Q::bottom_shear},
    HistoryColumn{"bottom_normal", dimension::pressure, Q::bottom_normal},
    HistoryColumn{"depth", dimension::length, Q::depth},
    HistoryColumn{"solid_fraction", dimension::number, Q::solid_fraction},
    HistoryColumn{"touching", dimension::number, Q::touching},
    HistoryColumn{"coordination", dimension::number, Q::coordination},
};

/// Fraction part/whole; NaN if `whole` is zero.
double quotient(double part, double whole) {
  return whole != 0.0 ? part / whole : std::numeric_limits<double>::quiet_NaN();
}
/// The same for series, which are plotted; zero if `whole` is zero.
double ratio_or_zero(double part, double whole) { return whole != 0.0 ? part / whole : 0.0; }

}  // namespace

std::string cell_header(const CellScene& scene, std::string_view name, Dimension dimension) {
  if (!scene.units || dimension == dimension::number) return std::string{name};
  return fmt::format("{} [{}]", name, unit(scene, dimension));
}

std::vector<CellNumber> cell_groups(const CellScene& scene, CellRun& run) {
  const ShearCell& cell = scene.cell;
  const double mean_depth = run.mean(Q::depth).value, now = depth(cell, run.discs());
  const bool known = mean_depth > 0.0;
  const double pressure = cell.overburden(), rate = std::abs(cell.block_speed) / (known ? mean_depth : now);
  const auto group = [](const char* name, double value, std::string_view meaning) {
    return CellNumber{name, dimension::number, {value, 0.0}, 0.0, std::string{meaning}};
  };
  const std::string_view restitution =
      std::visit([]<class L>(const L&) { return L::restitution_field.meaning; }, cell.law);
  std::vector<CellNumber> groups{group("restitution", cell.restitution(), restitution)};
  if (cell.law_of_1989() != nullptr) {
    const double stepped = stepped_restitution(make_disc_method(scene.plan.integrator), cell.restitution(),
                                               cell.loading_frequency() * scene.plan.step);
    groups.push_back(
        group("stepped_restitution", stepped, "what the integrator makes of it with this step, in closed form"));
  }
  if (cell.friction) {
    const double coefficient = std::visit([](const auto& of) { return of.coefficient; }, *cell.friction);
    groups.push_back(group("friction", coefficient, "of two discs"));
    groups.push_back(group("shear_over_normal_stiffness", cell.shear_stiffness() / cell.stiffness(), "k_s/K1"));
  }
  const std::vector<CellNumber> others{
      group("contact_steps", cell.contact_time() / scene.plan.step, "contact time over step"),
      group("stiffness_number", cell.stiffness() / (pressure * cell.diameter), "kappa = K1/(P D)"),
      group("inertial_number", rate * cell.diameter * std::sqrt(cell.density() / pressure),
            known ? "I = (VXT/H) D sqrt(rho/P) with the mean depth H"
                  : "I = (VXT/H) D sqrt(rho/P) with the depth H of now; no mean is known yet"),
      group("contact_shear", cell.contact_time() * rate, "contact time times VXT/H"),
      group("block_over_disc", cell.block_mass / cell.mass, "MTOP/M"),
      group("columns_over_wall", static_cast<double>(cell.columns) / cell.wall_discs, "NWID/TWID"),
  };
  groups.insert(groups.end(), others.begin(), others.end());
  return groups;
}

std::vector<CellNumber> cell_results(const CellRun& run) {
  std::vector<CellNumber> results;
  const auto mean = [&](const char* name, Dimension dimension, Q quantity, const char* meaning) {
    results.push_back({name, dimension, run.mean(quantity), run.drift(quantity), meaning});
  };
  const auto ratio = [&](const char* name, Q over, Q under, const char* meaning) {
    results.push_back({name, dimension::number, run.ratio(over, under), 0.0, meaning});
  };
  ratio("stress_ratio_top", Q::top_shear, Q::top_normal, "S/N on the block");
  ratio("stress_ratio_bottom", Q::bottom_shear, Q::bottom_normal, "S/N on the base");
  mean("top_shear", dimension::pressure, Q::top_shear, "S on the block");
  mean("top_normal", dimension::pressure, Q::top_normal, "N on the block");
  mean("bottom_shear", dimension::pressure, Q::bottom_shear, "S on the base");
  mean("bottom_normal", dimension::pressure, Q::bottom_normal, "N on the base");
  mean("depth", dimension::length, Q::depth, "between the walls' surfaces");
  results.push_back({"depth_deviation", dimension::length, run.estimate([](auto&& of) {
                       return std::sqrt(std::max(0.0, of(Q::depth_square) - of(Q::depth) * of(Q::depth)));
                     }),
                     0.0, "standard deviation of the depth"});
  mean("solid_fraction", dimension::number, Q::solid_fraction, "area of the free discs over that of the field");
  mean("contact_time_fraction", dimension::number, Q::touching, "fraction of time with contacts");
  ratio("multiple_fraction", Q::multiple, Q::contacts, "fraction of contact time in multiple contacts");
  mean("coordination", dimension::number, Q::coordination, "contacts of a free disc");
  ratio("multiple_shear_fraction", Q::multiple_shear_virial, Q::shear_virial,
        "M/S read as the shear of contacts that multiple ones carry");
  ratio("multiple_stress_ratio", Q::multiple_shear_virial, Q::multiple_normal_virial, "S/N of multiple contacts");
  results.push_back({"binary_stress_ratio", dimension::number, run.estimate([](auto&& of) {
                       return quotient(of(Q::shear_virial) - of(Q::multiple_shear_virial),
                                       of(Q::normal_virial) - of(Q::multiple_normal_virial));
                     }),
                     0.0, "S/N of binary contacts"});
  ratio("kinetic_shear_fraction", Q::kinetic_shear, Q::top_moment, "fraction of the shear that moving discs carry");
  results.push_back({"shear_balance", dimension::number, run.estimate([](auto&& of) {
                       return quotient(of(Q::shear_virial) + of(Q::kinetic_shear), of(Q::top_moment));
                     }),
                     0.0, "shear of contacts and moving discs over the block's; 1 in a steady flow"});
  if (run.cell().friction) {
    ratio("sliding_fraction", Q::sliding, Q::contacts, "fraction of contact time in contacts that slide");
    mean("spin", dimension::angular_velocity, Q::spin, "mean of the free discs, counter-clockwise > 0");
  }
  results.push_back({"largest_overlap",
                     dimension::number,
                     {run.largest_overlap() / run.cell().diameter, 0.0},
                     0.0,
                     "over a diameter, of the moments seen: two in a contact"});
  results.push_back({"largest_solid_fraction",
                     dimension::number,
                     {run.largest_fraction(), 0.0},
                     0.0,
                     "of the moments seen: two in a contact"});
  return results;
}

CellTable cell_history(const CellScene& scene, const CellRun& run) {
  CellTable table{{{"time", dimension::time}}, {}};
  for (const HistoryColumn& column : cell_columns)
    table.columns.push_back({column.name, column.dimension});
  table.columns.push_back({"stress_ratio", dimension::number});
  table.columns.push_back({"multiple_fraction", dimension::number});
  if (scene.cell.friction) {
    table.columns.push_back({"sliding_fraction", dimension::number});
    table.columns.push_back({"spin", dimension::angular_velocity});
  }
  std::vector<double>& numbers = table.numbers;
  for (std::size_t k = 0; k < run.intervals(); ++k) {
    if (!run.interval_seen(k)) continue;
    const auto of = [&](Q quantity) { return run.interval_mean(k, quantity); };
    const double last = run.failure().empty() ? scene.plan.end : static_cast<double>(run.steps()) * scene.plan.step;
    numbers.push_back(run.began() + std::min(static_cast<double>(k + 1) * scene.plan.every, last));
    for (const HistoryColumn& column : cell_columns)
      numbers.push_back(of(column.quantity));
    numbers.push_back(ratio_or_zero(of(Q::top_shear), of(Q::top_normal)));
    numbers.push_back(ratio_or_zero(of(Q::multiple), of(Q::contacts)));
    if (scene.cell.friction) {
      numbers.push_back(ratio_or_zero(of(Q::sliding), of(Q::contacts)));
      numbers.push_back(of(Q::spin));
    }
  }
  return table;
}

CellTable cell_profile(const CellScene& scene, const CellRun& run) {
  using Layer = CellProfile::Layer;
  CellTable table{{CellTable::Column{"y", dimension::length}}, {}};
  std::vector<Estimate Layer::*> estimates;
  const auto add = [&](const std::string& name, Dimension dimension, Estimate Layer::*of) {
    table.columns.push_back({name, dimension}), table.columns.push_back({name + "_error", dimension});
    estimates.push_back(of);
  };
  add("velocity", dimension::velocity, &Layer::velocity);
  add("temperature", dimension::energy, &Layer::temperature);
  add("solid_fraction", dimension::number, &Layer::fraction);
  if (scene.cell.friction) add("spin", dimension::angular_velocity, &Layer::spin);
  for (const Layer& layer : run.profile().layers()) {
    if (layer.fraction.value == 0.0) continue;
    table.numbers.push_back(layer.y);
    for (const auto of : estimates) {
      table.numbers.push_back((layer.*of).value);
      table.numbers.push_back((layer.*of).error);
    }
  }
  return table;
}

std::string cell_csv(const CellScene& scene, const CellTable& table) {
  std::vector<std::string> names;
  for (const CellTable::Column& column : table.columns)
    names.push_back(cell_header(scene, column.name, column.dimension));
  records::CsvText csv{names};
  for (std::size_t i = 0; i < table.numbers.size(); ++i) {
    csv.number(table.numbers[i]);
    if ((i + 1) % table.columns.size() == 0) csv.end_row();
  }
  return std::move(csv).text();
}

std::string cell_summary_json(const CellScene& scene, CellRun& run, const CellOutcome& outcome,
                              const std::string& resume) {
  const Outcome& end = outcome.outcome;
  const CellRun::Ledger ledger = run.ledger();
  Json json{{"schema", 2},
            {"title", scene.title},
            {"units", nullptr},
            {"outcome", {{"kind", name_of(end.kind)}, {"time", json_number(end.time)}}}};
  if (scene.units) json["units"] = std::string{scene.units->name};
  if (!end) json["outcome"]["message"] = end.message;
  json["warnings"] = outcome.warnings;
  json["parameters"] = parameters(scene);
  json["groups"] = numbers(scene, cell_groups(scene, run));
  json["results"] = numbers(scene, cell_results(run));
  json["energy"] = {{"kinetic", json_number(ledger.kinetic)},
                    {"potential", json_number(ledger.potential)},
                    {"stored", json_number(ledger.stored)},
                    {"input", json_number(ledger.input)},
                    {"dissipated", json_number(ledger.dissipated)},
                    {"spurious_gain", json_number(ledger.spurious_gain)},
                    {"relative_balance_error", json_number(ledger.relative_balance_error())}};
  if (scene.cell.friction) json["energy"]["friction_work"] = json_number(ledger.friction_work);
  json["counts"] = {{"discs", run.cell().free_discs()},
                    {"wall_discs", 2 * run.cell().wall_discs},
                    {"steps", run.steps()},
                    {"jumped", run.jumped()}};
  if (!resume.empty()) json["resume"] = resume;
  return json.dump(1) + "\n";
}

std::string cell_state_vtp(CellRun& run) {
  const Discs discs = run.discs();
  const ShearCell& cell = run.cell();
  PolyData data;
  std::string coordinates, ids, radii, velocities, spins, walls, forces, kinds, verts, vert_ends, lines, line_ends;
  const auto add = [](std::string& text, auto&&... values) {
    (fmt::format_to(std::back_inserter(text), "{} ", values), ...);
  };
  const auto point = [&](std::size_t disc, Vec2 at, bool image) {
    const auto number = static_cast<long>(disc) + 1;
    add(coordinates, at.x, at.y, 0);
    coordinates.back() = '\n';
    add(ids, image ? -number : number), add(radii, 0.5 * cell.diameter);
    if (cell.friction) add(spins, discs.spin[disc]);
    add(velocities, discs.vx[disc], discs.vy[disc], 0), add(walls, run.start().shapes.wall[disc]);
    return data.points++;
  };
  for (std::size_t i = 0; i < discs.size(); ++i) {
    add(verts, point(i, {discs.x[i], discs.y[i]}, false));
    add(vert_ends, ++data.verts), add(forces, 0), add(kinds, 0);
  }
  for (const CellRun::ActingContact& contact : run.acting_contacts()) {
    // The second end is the image in contact. Contacts are those of their last evaluation, which may be half a step
    // later.
    const double beyond = discs.x[contact.a] + contact.distance * contact.n_ab.x - discs.x[contact.b];
    const Vec2 b{discs.x[contact.b] + cell.width() * std::round(beyond / cell.width()), discs.y[contact.b]};
    const bool here = norm(Vec2{discs.x[contact.b], discs.y[contact.b]} - b) < 0.5 * cell.diameter;
    add(lines, contact.a, here ? static_cast<long>(contact.b) : point(contact.b, b, true));
    add(line_ends, 2 * ++data.lines), add(forces, contact.force), add(kinds, contact.multiple ? 1 : 0);
  }
  data.coordinates = coordinates;
  data.point_data = {{"Int64", "id", 1, ids},
                     {"Float64", "radius", 1, radii},
                     {"Float64", "velocity", 3, velocities},
                     {"UInt8", "wall", 1, walls}};
  if (cell.friction) data.point_data.push_back({"Float64", "spin", 1, spins});
  data.cell_data = {{"Float64", "force", 1, forces}, {"UInt8", "multiple", 1, kinds}};
  data.vert_arrays = {{"Int64", "connectivity", 1, verts}, {"Int64", "offsets", 1, vert_ends}};
  data.line_arrays = {{"Int64", "connectivity", 1, lines}, {"Int64", "offsets", 1, line_ends}};
  return vtk_text(data);
}

}  // namespace talus
