#include "verification/problems/program/agreement/printed_sheet.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <numbers>
#include <sstream>
#include <utility>

#include "verification/problems/program/agreement/agreeing_scenes.hpp"
#include "verification/study/program/program_options.hpp"

namespace talus::verification::problems::agreeing_files {
namespace {

using records::Json;

/// The lines, from the members of sheet.json.
class PageLines {
 public:
  explicit PageLines(const Json& sheet) : sheet_{sheet} {}

  std::vector<std::string> all() {
    heads();
    verdict();
    quality();
    rocks();
    hangers();
    heights();
    anchors();
    events();
    energies();
    return lines_;
  }

 private:
  using Cells = std::vector<std::string>;

  /// The two units of a quantity, with their sizes in SI.
  struct Unit {
    double us, si;
    const char *us_name, *si_name;
  };
  static constexpr double foot_ = 0.3048, pound_ = 0.45359237, kip_ = 1e3 * pound_ * 9.80665;
  static constexpr Unit length_{foot_, 1.0, "ft", "m"}, speed_{foot_, 1.0, "ft/s", "m/s"},
      mass_{pound_, 1.0, "lb", "kg"}, force_{kip_, 1e3, "kip", "kN"}, energy_{kip_ * foot_, 1e3, "kip ft", "kJ"};

  static double real(const Json& value) { return value.get<double>(); }
  static std::string text(const Json& value) { return value.get<std::string>(); }
  static double size_of(const Json& vector) {
    return std::hypot(real(vector[0]), real(vector[1]), vector.size() == 3 ? real(vector[2]) : 0.0);
  }
  static std::string digits(double value) {
    const double size = std::abs(value);
    return size >= 1e4 && size < 1e7 ? fmt::format("{:.0f}", value) : fmt::format("{:.4g}", value);
  }
  static std::string both(double value, const Unit& unit) {
    return fmt::format("{} ({})", digits(value / unit.us), digits(value / unit.si));
  }
  static std::string named(double value, const Unit& unit) {
    return fmt::format("{} {} ({} {})", digits(value / unit.us), unit.us_name, digits(value / unit.si), unit.si_name);
  }
  static std::string seconds(const Json& time) { return fmt::format("{:.4f}", real(time)); }
  static std::string at(const Json& time) { return fmt::format(" at {} s", seconds(time)); }
  static std::string tenths(double fraction) { return fmt::format("{:.1f}", 100.0 * fraction); }
  static std::string percent(double fraction) { return fmt::format("{:.3g} %", 100.0 * fraction); }
  static std::string spoken(std::string name) {
    std::ranges::replace(name, '_', ' ');
    return name == "undecided" ? "undecided at the end" : name;
  }

  void add(const Cells& cells) { lines_.push_back(fmt::format("{}|", fmt::join(cells, "|"))); }
  const Json& part(const char* of, const char* name) const { return sheet_.at(of).at(name); }

  void heads() {
    const Json& fence = sheet_.at("fence");
    const auto feet = [&](const char* of) { return real(fence.at(of)) / foot_; };
    lines_.push_back(fmt::format(
        "{} layers of {} columns (half model); span {:.4g} m ({:.4g} ft), sag {:.3g} m ({:.3g} ft), columns "
        "{:.3g} m ({:.3g} ft) apart",
        fence.at("layers").get<int>(), fence.at("columns").get<int>(), real(fence.at("span")), feet("span"),
        real(fence.at("sag")), feet("sag"), real(fence.at("spacing")), feet("spacing")));
    lines_.push_back(fmt::format("{} at {:.6g} s; {} steps of {:.4g} s, {}", text(part("run", "outcome")),
                                 real(part("run", "time")), part("run", "steps").get<int>(), real(part("run", "step")),
                                 text(part("run", "integrator"))));
  }

  std::string passage(const Json& rock) const {
    const bool left = rock.at("separated").get<bool>(), undecided = rock.at("verdict") == "undecided";
    const double energy = real(rock.at(left ? "exit_energy" : "end_energy"));
    std::string found = spoken(text(rock.at("verdict")));
    if (real(rock.at("passed_time")) > 0.0) found += at(rock.at("passed_time"));
    found += left ? "; after its last contact" + at(rock.at("exit_time")) + " " : "; still touching at the end: ";
    found += named(size_of(rock.at(left ? "exit_velocity" : "end_velocity")), speed_) + ", " + named(energy, energy_) +
             ", " + percent(energy / real(rock.at("approach_energy"))) + " of its energy";
    if (undecided) found += "; it still advances at " + named(std::abs(real(rock.at("end_velocity")[0])), speed_);
    return found;
  }

  /// The largest force of segments or hangers with the part that is closest to its limit, if that is another one.
  template <class Force>
  std::string largest(const char* parts, Force force) const {
    const Json &all = sheet_.at(parts), *maximum = &all[0], *closest = &all[0];
    for (const Json& each : all) {
      if (real(force(each).at("peak")) > real(force(*maximum).at("peak"))) maximum = &each;
      if (real(each.at("margin")) > real(closest->at("margin"))) closest = &each;
    }
    std::string found = named(real(force(*maximum).at("peak")), force_) + at(force(*maximum).at("peak_time")) + ", " +
                        text(maximum->at("name")) + ": " + percent(real(maximum->at("margin"))) + " of its limit";
    if (real(closest->at("margin")) > real(maximum->at("margin")))
      found += "; closest to its limit: " + text(closest->at("name")) + ", " + percent(real(closest->at("margin")));
    return found;
  }

  void verdict() {
    const Json &all = sheet_.at("rocks"), &worst = sheet_.at("verdict");
    lines_.push_back("Verdict: " + spoken(text(worst)));
    Cells counts, facts{"rocks"};
    for (const char* const each : {"broke_through", "passed_over", "passed_under", "undecided", "stopped"}) {
      const auto count =
          std::count_if(all.begin(), all.end(), [&](const Json& of) { return of.at("verdict") == each; });
      if (count > 0) counts.push_back(fmt::format("{} {}", count, spoken(each)));
    }
    facts.push_back(fmt::format("{}", fmt::join(counts, ", ")));
    const Json& rock = *std::find_if(all.begin(), all.end(), [&](const Json& of) { return of.at("verdict") == worst; });
    facts.insert(facts.end(), {text(rock.at("name")), passage(rock)});
    const Json* anchor = &sheet_.at("anchors")[0].at("force");
    for (const Json& of : sheet_.at("anchors"))
      if (real(of.at("force").at("peak")) > real(anchor->at("peak"))) anchor = &of.at("force");
    const std::string of_anchor = named(real(anchor->at("peak")), force_) + at(anchor->at("peak_time"));
    const std::string of_cable = largest("segments", [](const Json& of) -> const Json& { return of; });
    const std::string of_hanger = largest("columns", [](const Json& of) -> const Json& { return of.at("hanger"); });
    facts.insert(facts.end(), {"anchor force", of_anchor, "cable force", of_cable, "hanger force", of_hanger});
    add(facts);
  }

  void quality() {
    const Json &of = sheet_.at("quality"), &repeat = of.at("repeat"), &last = of.at("last_contact");
    lines_.emplace_back("Quality: usable");
    std::string steps = text(of.at("step"));
    if (of.contains("steps_in_shortest_contact"))
      steps += fmt::format("; {:.0f} in the shortest contact", real(of.at("steps_in_shortest_contact")));
    const std::string same = "the verdict is unchanged", other = "the verdict becomes: ";
    add({"energy balance", "within " + percent(real(of.at("energy_balance"))), "steps", steps, "at the end",
         last.at("touching").get<bool>() ? text(last.at("name")) + " still touches" : "nothing touches", "sensitivity",
         fmt::format("with {:g} times the speed {}; largest cable force {:+.2g} %",
                     1.0 + real(repeat.at("change_of_speed")),
                     repeat.at("verdict") == sheet_.at("verdict") ? same : other + spoken(text(repeat.at("verdict"))),
                     100.0 * real(repeat.at("change_of_largest_cable_force")))});
  }

  void rocks() {
    lines_.emplace_back(
        "|mass|before|contact|after|taken|braking|advance|rock|lb (kg)|ft/s (m/s)|kip ft (kJ)|from s|to s|ft/s (m/s)|"
        "kip ft (kJ)|%|s|ft (m)|");
    for (const Json& rock : sheet_.at("rocks"))
      add({text(rock.at("name")), both(real(rock.at("mass")), mass_),
           both(size_of(rock.at("approach_velocity")), speed_), both(real(rock.at("approach_energy")), energy_),
           seconds(rock.at("touch_time")), seconds(rock.at("exit_time")),
           both(size_of(rock.at("exit_velocity")), speed_), both(real(rock.at("exit_energy")), energy_),
           tenths(real(rock.at("energy_loss_fraction"))), seconds(rock.at("braking_time")),
           both(real(rock.at("travel")), length_)});
    lines_.emplace_back(
        "After: when the last contact with a column ends. Braking: until the rock no longer advances, at most until "
        "then.");
  }

  void hangers() {
    lines_.emplace_back(
        "|hanger|top segment|bottom segment|column|kip (kN)|at s|% limit|deg|kip s (kN s)|kip (kN)|at s|% limit|"
        "kip (kN)|at s|% limit|");
    for (const Json& column : sheet_.at("columns")) {
      const Json &hanger = column.at("hanger"), &pull = hanger.at("at_peak");
      const std::string name = text(column.at("name"));
      Cells cells{name,
                  both(real(hanger.at("peak")), force_),
                  seconds(hanger.at("peak_time")),
                  tenths(real(column.at("margin"))),
                  fmt::format("{:.0f}", std::atan2(real(pull[1]), real(pull[0])) * 180.0 / std::numbers::pi),
                  both(size_of(hanger.at("impulse")), force_)};
      for (const char* const cable : {"top", "bottom"}) {
        std::string of = name;
        replace(of, "column", cable);
        Cells more{"", "", ""};
        for (const Json& segment : sheet_.at("segments")) {
          if (segment.at("name") != of) continue;
          more = {both(real(segment.at("peak")), force_), seconds(segment.at("peak_time")),
                  tenths(real(segment.at("margin")))};
          if (real(segment.at("peak")) == 0.0) more = {"slack", "", ""};
        }
        cells.insert(cells.end(), more.begin(), more.end());
      }
      add(cells);
    }
    lines_.emplace_back(
        "Hanger: the top cable's pull on the column; deg from +x, up positive; impulse over the whole run.");
  }

  void heights() {
    lines_.emplace_back("|start|extreme|end||ft (m)|ft (m)|at s|ft (m)|");
    int layer = 0;
    for (const Json& of : sheet_.at("layers")) {
      ++layer;
      for (const auto& [key, label] :
           {std::pair{"top", "lowest top joint (minimum)"}, {"bottom", "gap below the columns (maximum)"}}) {
        const Json& height = of.at(key);
        add({fmt::format("layer {}: {}", layer, label), both(real(height.at("start")), length_),
             both(real(height.at("extreme")), length_), seconds(height.at("extreme_time")),
             both(real(height.at("end")), length_)});
      }
    }
    add({"displacement of a column along x (maximum)", "", both(real(part("fence", "travel")), length_),
         seconds(part("fence", "travel_time")), ""});
  }

  void anchors() {
    lines_.emplace_back("|peak|direction|impulse|layer, z|kip (kN)|at s|x|y|z|kip s (kN s)|");
    for (const Json& anchor : sheet_.at("anchors")) {
      const Json& force = anchor.at("force");
      Cells cells{fmt::format("{}, {:.3g} m", anchor.at("layer").get<int>(), real(anchor.at("position")[2])),
                  both(real(force.at("peak")), force_), seconds(force.at("peak_time"))};
      for (const Json& component : force.at("at_peak"))
        cells.push_back(fmt::format("{:.2f}", real(component) / real(force.at("peak"))));
      cells.push_back(both(size_of(force.at("impulse")), force_));
      add(cells);
    }
    lines_.emplace_back("The half model: the other side's are the same with -z. ");
  }

  void events() {
    constexpr std::size_t maximum = 4;
    lines_.emplace_back("|||at s|part|what|");
    const Json& all = sheet_.at("events");
    for (std::size_t i = 0; i < std::min(all.size(), maximum); ++i)
      add({fmt::format("{:.5f}", real(all[i].at("time"))), text(all[i].at("part")), text(all[i].at("event"))});
    if (all.size() > maximum) lines_.push_back(fmt::format("{} more are in sheet.json. ", all.size() - maximum));
  }

  void energies() {
    lines_.emplace_back("|||kip ft (kJ)|");
    const Json &of = sheet_.at("energy"), &start = of.at("start"), &end = of.at("end");
    const auto line = [&](const std::string& name, double energy) { add({name, both(energy, energy_)}); };
    line("kinetic energy at the start", real(start.at("kinetic")));
    line("kinetic energy at the end", real(end.at("kinetic")));
    for (const auto& [key, label] : {std::pair{"gravity", "gained in height"},
                                     {"cables", "gained in cables"},
                                     {"contacts", "gained in contacts"},
                                     {"applied", "gained in applied forces"}}) {
      const double gained = real(end.at(key)) - real(start.at(key));
      if (std::abs(gained) > 1e-9 * real(of.at("scale"))) line(label, gained);
    }
    std::map<std::string, double> losses;  // sorted by name
    for (const auto& [name, energy] : of.at("dissipated").items())
      losses[spoken(name)] = real(energy);
    for (const auto& [name, energy] : losses)
      if (energy != 0.0) line("dissipated: " + name, energy);
    line("energy balance error", real(of.at("balance_error")));
  }

  const Json& sheet_;
  std::vector<std::string> lines_;
};

}  // namespace

std::vector<std::string> expected_page(const Json& sheet) { return PageLines{sheet}.all(); }

std::vector<std::string> lines_of_page(const std::string& html) {
  constexpr std::array begins{
      "<p>", "<p class", "<div class=\"left box", "<div class=\"right box", "<div class=\"wide", "<dl>", "<tr>"};
  constexpr std::array ends_of_cells{"</td>", "</th>", "</dt>", "</dd>"};
  std::vector<std::string> lines;
  std::istringstream page{html};
  for (std::string line; std::getline(page, line);) {
    const auto begins_so = [&](const char* begin) { return line.starts_with(begin); };
    if (std::ranges::none_of(begins, begins_so)) continue;
    std::string seen;
    for (std::size_t at = 0; at < line.size(); ++at) {
      if (line[at] != '<') {
        seen += line[at];
        continue;
      }
      const std::string tag = line.substr(at, line.find('>', at) + 1 - at);
      if (std::ranges::find(ends_of_cells, tag) != ends_of_cells.end()) seen += '|';
      at += tag.size() - 1;
    }
    lines.push_back(seen);
  }
  return lines;
}

}  // namespace talus::verification::problems::agreeing_files
