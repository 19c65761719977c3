#include "verification/problems/program/capacity/drawn_capacity.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <string>
#include <tuple>
#include <vector>

#include "verification/problems/program/agreement/printed_sheet.hpp"
#include "verification/problems/program/capacity/one_column.hpp"
#include "verification/problems/program/pictures/picture_script.hpp"

namespace talus::verification::problems::fence_capacity {

namespace {

using records::Json;

/// A unit with its size in SI.
struct Unit {
  const char* name;
  double size;
};

/// Units of tables and of pictures, for a base in SI or US units.
struct ResultUnits {
  const char* system;
  Unit length, speed, mass, force, energy, drawn_force, drawn_energy;
};

constexpr double foot = 0.3048, pound = 0.45359237, pound_force = pound * 9.80665;
constexpr std::array<ResultUnits, 2> all_units{
    {{"SI", {"m", 1.0}, {"m/s", 1.0}, {"kg", 1.0}, {"N", 1.0}, {"J", 1.0}, {"kN", 1e3}, {"kJ", 1e3}},
     {"US",
      {"ft", foot},
      {"ft/s", foot},
      {"lb", pound},
      {"lbf", pound_force},
      {"lbf ft", pound_force* foot},
      {"kip", 1e3 * pound_force},
      {"kip ft", 1e3 * pound_force* foot}}}};

/// Lines of the page of one map with expected rocks, from capacity.json.
class PrintedCapacity {
 public:
  PrintedCapacity(const Json& capacity, const ResultUnits& units)
      : all_{capacity}, first_{units}, second_{all_units[&units == all_units.data() ? 1 : 0]} {}

  std::vector<std::string> lines() {
    lines_ = {fmt::format("Rocks that the fence of {} stops: {} to {}", all_.at("base").get<std::string>(),
                          named(all_.at("mass")[0], &ResultUnits::mass), named(all_.at("mass")[1], &ResultUnits::mass)),
              fmt::format("at speeds of {} to {}", named(all_.at("speed")[0], &ResultUnits::speed),
                          named(all_.at("speed")[1], &ResultUnits::speed))};
    boxes(), boundary(), expected_rocks(), ends();
    return lines_;
  }

 private:
  using Quantity = Unit ResultUnits::*;

  static std::string digits(double value) {
    return value >= 1e4 && value < 1e7 ? fmt::format("{:.0f}", value) : fmt::format("{:.4g}", value);
  }
  std::string in_first(const Json& value, Quantity of) const {
    return value.is_null() ? "unknown" : digits(value.get<double>() / (first_.*of).size);
  }
  std::string in_second(const Json& value, Quantity of) const {
    return digits(value.get<double>() / (second_.*of).size);
  }
  std::string both(const Json& value, Quantity of) const {
    return fmt::format("{} ({})", in_first(value, of), in_second(value, of));
  }
  std::string named(const Json& value, Quantity of) const {
    return fmt::format("{} {} ({} {})", in_first(value, of), (first_.*of).name, in_second(value, of),
                       (second_.*of).name);
  }
  std::string unit_of(Quantity of) const { return (first_.*of).name; }
  std::string units_of(Quantity of) const { return fmt::format("{} ({})", (first_.*of).name, (second_.*of).name); }
  void add(const std::vector<std::string>& cells) { lines_.push_back(fmt::format("{}|", fmt::join(cells, "|"))); }

  const Json& map() const { return all_.at("maps").at(0); }
  const Json& hazard() const { return all_.at("hazard"); }
  double of_rock(const char* number, const char* part, const Unit& unit) const {
    return hazard().at("rocks").at(number).at(part).get<double>() / unit.size;
  }
  static std::string spoken(std::string name) {
    std::ranges::replace(name, '_', ' ');
    return name;
  }

  void boxes() {
    lines_.push_back("Probability of failure per impact: " +
                     digits(hazard().at("probability_of_failure").get<double>()));
    std::string expected = fmt::format("{} runs:", hazard().at("runs").get<int>());
    for (const auto& [end, count] : hazard().at("ends").items())
      if (count != 0) expected += fmt::format(" {} {},", count.get<int>(), spoken(end));
    expected.pop_back();
    double all = std::numeric_limits<double>::infinity(), none = 0.0;
    for (const Json& line : map().at("boundary")) {
      all = std::min(all, line.at("kinetic_energy")[0].get<double>());
      none = std::max(none, line.at("kinetic_energy")[1].get<double>());
    }
    std::vector<std::string> facts{
        "95 %",
        fmt::format("{} to {}", digits(hazard().at("interval")[0].get<double>()),
                    digits(hazard().at("interval")[1].get<double>())),
        "expected rocks",
        fmt::format("mass {:.4g} {}; speed {:.4g} {} (95 %), {:.4g} {} (99 %); height {:.4g} {}",
                    of_rock("mass", "value", first_.mass), first_.mass.name, of_rock("speed", "p95", first_.speed),
                    first_.speed.name, of_rock("speed", "p99", first_.speed), first_.speed.name,
                    of_rock("height", "value", first_.length), first_.length.name),
        "their runs",
        expected,
        "energy",
        fmt::format("every mass of the table is stopped up to {}; none is from {} on",
                    named(all, &ResultUnits::drawn_energy), named(none, &ResultUnits::drawn_energy))};
    if (const double factor = map().at("energy_factor").get<double>(); factor > 1.0)
      facts.insert(facts.end(), {"one energy", fmt::format("misjudges masses by a factor of up to {:.3g}", factor)});
    add(facts);
    const Json& audit = map().at("audit");
    const double full = map().at("full_grid_runs").get<double>();
    lines_.push_back(fmt::format("Audit: {} of {} runs contradict the map", audit.at("contradictions").get<int>(),
                                 audit.at("runs").get<int>()));
    add({"runs",
         fmt::format("{}, {:.3g} % of the full grid", map().at("runs").get<int>(),
                     100.0 * map().at("runs").get<double>() / full),
         "random",
         fmt::format("speed +-{:.3g} %; seed {}", 100.0 * all_.at("changes").at("speed").get<double>(),
                     all_.at("seed").get<int>()),
         "model",
         fmt::format("plane motion, {} fence, elastic, plastic or breaking cables, columns that do not break, no net",
                     all_.at("symmetry") == "full" ? "whole" : "half"),
         "interval",
         "of the runs alone: it knows nothing of errors of the model; no conformity with a standard is claimed"});
  }

  void boundary() {
    const auto range = [&](const Json& of, Quantity quantity) {
      return in_first(of[0], quantity) + " to " + in_first(of[1], quantity);
    };
    const std::string mass = units_of(&ResultUnits::mass), speed = unit_of(&ResultUnits::speed),
                      energy = unit_of(&ResultUnits::drawn_energy), force = units_of(&ResultUnits::drawn_force);
    add({"", "rock", "speed", "kinetic energy", "anchor force", "cable force", "hanger force", "energy after", "height",
         mass, speed, energy, force, force, force, units_of(&ResultUnits::drawn_energy)});
    for (const Json& line : map().at("boundary")) {
      const auto value = [&](const char* side, const char* output, const char* name, Quantity of) {
        return both(line.at(side).at("outputs").at(output).at(name).at("value"), of);
      };
      add({in_first(map().at("height"), &ResultUnits::length) + " " + unit_of(&ResultUnits::length),
           both(line.at("mass"), &ResultUnits::mass), range(line.at("speed"), &ResultUnits::speed),
           range(line.at("kinetic_energy"), &ResultUnits::drawn_energy),
           value("stopped", "fence.anchor_force", "p95", &ResultUnits::drawn_force),
           value("stopped", "fence.cable_force", "p95", &ResultUnits::drawn_force),
           value("stopped", "fence.hanger_force", "p95", &ResultUnits::drawn_force),
           value("not_stopped", "fence.exit_energy", "median", &ResultUnits::drawn_energy)});
    }
    lines_.emplace_back(
        "Stopped: with a probability above one half. Forces: 95th percentile at the first speed. Energy after: median "
        "after the last contact at the second. ");
  }

  void expected_rocks() {
    add({"", "", "", "", "", "", "unit", "median", "95th percentile", "its interval, 95 %"});
    static constexpr Unit one{"", 1.0};
    for (const auto& [name, label, of] :
         {std::tuple{"fence.anchor_force", "anchor force", &first_.drawn_force},
          {"fence.cable_force", "cable force", &first_.drawn_force},
          {"fence.hanger_force", "hanger force", &first_.drawn_force},
          {"fence.cable_margin", "cable force/limit", &one},
          {"fence.hanger_margin", "hanger force/limit", &one},
          {"fence.exit_energy", "energy after the last contact", &first_.drawn_energy}}) {
      const Json& output = hazard().at("outputs").at(name);
      if (output.is_null()) {
        add({label, "", "no limit", "no limit", ""});
        continue;
      }
      const auto number = [size = of->size](const Json& value) {
        return value.is_null() ? "unknown" : digits(value.get<double>() / size);
      };
      const Json& p95 = output.at("p95");
      add({label, of->name, number(output.at("median").at("value")), number(p95.at("value")),
           number(p95.at("interval")[0]) + " to " + number(p95.at("interval")[1])});
    }
  }

  void ends() {
    add({"", "", "", "", "", "maps", "audits", "expected rocks"});
    for (const auto& [end, count] : map().at("ends").items())
      add({spoken(end), fmt::format("{}", count.get<int>()),
           fmt::format("{}", map().at("audit").at("ends").at(end).get<int>()),
           fmt::format("{}", hazard().at("ends").at(end).get<int>())});
  }

  const Json& all_;
  const ResultUnits &first_, &second_;
  std::vector<std::string> lines_;
};

void check_page(const Program& program, const std::string& folder, const ResultUnits& units, Differences& differ) {
  const std::vector<std::string> found = agreeing_files::lines_of_page(program.read(folder + "/capacity.html"));
  const Json capacity = program.file(folder + "/capacity.json");
  const std::vector<std::string> expected = PrintedCapacity{capacity, units}.lines();
  differ.compare("lines of the page", found.size(), expected.size());
  for (std::size_t i = 0; i < std::min(found.size(), expected.size()); ++i)
    differ.compare(fmt::format("'{}' on the page", expected[i]), found[i], expected[i]);
}

void check_units(const Program& program, const ResultUnits& units, Differences& differ) {
  constexpr double spin = 30.0;
  std::string base = fence(fmt::format("spin = \"{} rad/s\"\n", spin));
  base.replace(base.find("\"SI\""), 4, fmt::format("\"{}\"", units.system));
  program.write("fence.toml", base);
  program.write("drawn.toml", question(8,
                                       "[hazard]\nmass = \"200 kg\"\nspeed = { p95 = \"7 m/s\", p99 = \"9 m/s\" }\n"
                                       "height = \"4.5 m\"\nruns = 20\n"));
  const std::string folder = fmt::format("drawn_{}", units.system);
  const std::string text = talus_output(program.folder(), {"capacity", "drawn.toml", "--out", folder, "--sheet"},
                                        picture_options::recorded_pictures());
  check_page(program, folder, units, differ);
  const Json map = Json::parse(program.read(folder + "/capacity.json")).at("maps").at(0);
  const auto quantile = [](const Json& line, const char* of, const char* output, const char* name) {
    return line.at(of).at("outputs").at(output).at(name).at("value").get<double>();
  };
  const auto median = [&](const Json& line, const char* of, const char* output) {
    return quantile(line, of, output, "median");
  };
  /// Whether a curve has the point; numbers are drawn with six digits.
  const auto has = [](const picture_options::Curve& curve, double x, double y) {
    for (const auto& line : curve.lines)
      for (const picture_options::Point& point : line)
        if (std::abs(point[0] / x - 1.0) < 1e-5 && std::abs(point[1] / y - 1.0) < 1e-5) return true;
    return false;
  };
  /// Whether the bar of a point of a curve ends at its 95th percentile, and begins at the median.
  const auto has_bar = [](const picture_options::Curve& curve, double x, double low, double high) {
    const auto near = [](double a, double b) { return std::abs(a - b) <= 1e-5 * std::abs(b); };
    std::size_t at = 0;
    for (const auto& line : curve.lines)
      for (const picture_options::Point& point : line) {
        if (at >= curve.bars.size()) return false;
        const picture_options::Point& bar = curve.bars[at++];
        if (near(point[0], x) && near(bar[0], low) && near(bar[1], high)) return true;
      }
    return false;
  };
  /// The curves of a picture in SI units.
  const auto all_curves = [&](const char* name, const Unit& x, const Unit& y) {
    std::vector<picture_options::Curve> curves;
    for (const picture_options::Panel& panel :
         picture_options::read_picture(program.read(fmt::format("{}/plots/{}_1.svg", folder, name))).panels) {
      differ.holds(fmt::format("units of {}", name), panel.x_label.ends_with(fmt::format(" [{}]", x.name)) &&
                                                         panel.y_label.ends_with(fmt::format(" [{}]", y.name)));
      curves.insert(curves.end(), panel.curves.begin(), panel.curves.end());
    }
    for (picture_options::Curve& curve : curves)
      for (auto& line : curve.lines)
        for (picture_options::Point& point : line)
          point = {point[0] * x.size, point[1] * y.size};
    for (picture_options::Curve& curve : curves)
      for (picture_options::Point& bar : curve.bars)
        bar = {bar[0] * y.size, bar[1] * y.size};
    return curves;
  };
  const auto curves = [&](const char* name, const Unit& x, const Unit& y, std::size_t count) {
    std::vector<picture_options::Curve> found = all_curves(name, x, y);
    differ.compare(fmt::format("curves of {}", name), found.size(), count);
    found.resize(count);
    return found;
  };
  const std::vector<picture_options::Curve> forces = curves("boundary_forces", units.mass, units.drawn_force, 3),
                                            energies = curves("boundary_energy", units.mass, units.drawn_energy, 2);
  // All curves of the map and of the forces, by the nodes of capacity.csv.
  const records::Csv nodes = program.csv(folder + "/capacity.csv");
  const std::vector<picture_options::Curve> of_map = all_curves("envelope", units.mass, units.speed),
                                            of_force = all_curves("cable_force", units.drawn_energy, units.drawn_force);
  const auto in_any = [&](const std::vector<picture_options::Curve>& all, double x, double y) {
    return std::ranges::any_of(all, [&](const picture_options::Curve& curve) { return has(curve, x, y); });
  };
  differ.compare("curves of the forces", of_force.size(), std::size_t{2});
  for (std::size_t row = 0; row < nodes.rows(); ++row) {
    const auto number = [&](const char* name, const Unit& unit) {
      return unit.size * nodes.number(row, fmt::format("{} [{}]", name, unit.name));
    };
    const double mass = number("mass", units.mass), speed = number("speed", units.speed),
                 energy = number("kinetic_energy", units.energy);
    differ.holds("energy of a node", std::abs(energy / (0.5 * mass * speed * speed) - 1.0) < 1e-12);
    differ.holds("height of a node", std::abs(number("height", units.length) + ground_top) < 1e-12);
    differ.holds("a drawn node", in_any(of_map, mass, speed));
    // Light and heavy rocks, up to and from the middle of the masses.
    if (of_force.size() == 2) {
      const double force = number("fence.cable_force.median", units.force);
      const picture_options::Curve& curve = of_force[mass < 450.0 ? 0 : 1];
      differ.holds("a drawn force", has(curve, energy, force));
      differ.holds("bar of a force", has_bar(curve, energy, force, number("fence.cable_force.p95", units.force)));
    }
  }
  std::size_t lines = 0;
  for (const picture_options::Curve& curve : of_map) {
    if (!curve.label.ends_with(fmt::format(" {}", units.drawn_energy.name))) continue;
    ++lines;
    const double energy = units.drawn_energy.size * std::stod(curve.label);
    for (const auto& line : curve.lines)
      for (const picture_options::Point& point : line)
        differ.holds("a line of equal energy", std::abs(0.5 * point[0] * point[1] * point[1] / energy - 1.0) < 6e-3);
  }
  // A quarter of the energy at the middle of the right side, and that energy; of four times as much there is one point.
  differ.compare("lines of equal energy", lines, std::size_t{2});
  for (const Json& line : map.at("boundary")) {
    const double mass = line.at("mass").get<double>(), high = line.at("speed").at(1).get<double>();
    differ.holds("drawn anchor force", has(forces[0], mass, median(line, "stopped", "fence.anchor_force")));
    differ.holds("drawn cable force", has(forces[1], mass, median(line, "stopped", "fence.cable_force")));
    differ.holds("drawn hanger force", has(forces[2], mass, median(line, "stopped", "fence.hanger_force")));
    differ.holds("bar of the anchor force", has_bar(forces[0], mass, median(line, "stopped", "fence.anchor_force"),
                                                    quantile(line, "stopped", "fence.anchor_force", "p95")));
    differ.holds("bar of the energy after", has_bar(energies[1], mass, median(line, "not_stopped", "fence.exit_energy"),
                                                    quantile(line, "not_stopped", "fence.exit_energy", "p95")));
    const double radius = own_radius * std::cbrt(mass / own_mass), turning = 0.4 * mass * radius * radius;
    differ.holds("drawn energy at the start",
                 has(energies[0], mass, 0.5 * (mass * high * high + turning * spin * spin)));
    differ.holds("drawn energy after", has(energies[1], mass, median(line, "not_stopped", "fence.exit_energy")));
    // The text: mass, both speeds and energies, the force at the first and the energy after the second speed.
    const auto digits = [](double value, const Unit& unit) { return fmt::format("{:.4g}", value / unit.size); };
    const auto range = [&](const char* of, const Unit& unit) {
      const Json& ends = line.at(of);
      return fmt::format("{} to {}", digits(ends.at(0).get<double>(), unit), digits(ends.at(1).get<double>(), unit));
    };
    const Json& anchor = line.at("stopped").at("outputs").at("fence.anchor_force").at("p95").at("value");
    differ.contains(
        "printed boundary", squeezed(text),
        fmt::format(" {} {} {} {} {}", digits(mass, units.mass), range("speed", units.speed),
                    range("kinetic_energy", units.drawn_energy), digits(anchor.get<double>(), units.drawn_force),
                    digits(median(line, "not_stopped", "fence.exit_energy"), units.drawn_energy)));
  }
  // Forces and energies of each node in the table have the unit of its system, and those of the boundary the values of
  // the JSON file.
  for (const auto& [output, of, side, unit] : {std::tuple{"fence.anchor_force", "stopped", 0UL, units.force},
                                               {"fence.cable_force", "stopped", 0UL, units.force},
                                               {"fence.hanger_force", "stopped", 0UL, units.force},
                                               {"fence.exit_energy", "not_stopped", 1UL, units.energy}}) {
    for (const char* const name : {"median", "p95"}) {
      const std::string head = fmt::format("{}.{} [{}]", output, name, unit.name);
      differ.compare(fmt::format("column {}", head), std::ranges::count(nodes.header(), head), 1L);
      if (std::ranges::count(nodes.header(), head) != 1) continue;
      for (const Json& line : map.at("boundary")) {
        const double mass = line.at("mass").get<double>() / units.mass.size,
                     speed = line.at("speed").at(side).get<double>() / units.speed.size;
        for (std::size_t row = 0; row < nodes.rows(); ++row) {
          if (std::abs(nodes.number(row, fmt::format("mass [{}]", units.mass.name)) / mass - 1.0) < 1e-9 &&
              std::abs(nodes.number(row, fmt::format("speed [{}]", units.speed.name)) / speed - 1.0) < 1e-9)
            differ.holds(
                fmt::format("{} of a node", output),
                std::abs(unit.size * nodes.number(row, head) / quantile(line, of, output, name) - 1.0) < 1e-12);
        }
      }
    }
  }
  differ.contains("printed height", text,
                  fmt::format("height {:.4g} {}: ", -ground_top / units.length.size, units.length.name));
  differ.contains(
      "printed units", squeezed(text),
      fmt::format("mass [{}] stopped to [{}] kinetic energy [{}] anchor force [{}] energy after [{}]", units.mass.name,
                  units.speed.name, units.drawn_energy.name, units.drawn_force.name, units.drawn_energy.name));
}

}  // namespace

void check_figures(const Program& program, Differences& differ) {
  for (const ResultUnits& units : all_units)
    check_units(program, units, differ);
}

}  // namespace talus::verification::problems::fence_capacity
