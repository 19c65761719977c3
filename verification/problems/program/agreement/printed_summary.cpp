#include "verification/problems/program/agreement/printed_summary.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <sstream>

namespace talus::verification::problems::agreeing_files {
namespace {

double number(const Json& value) { return value.get<double>(); }
std::string word(const Json& value) { return value.get<std::string>(); }
double length_of(const Json& vector) { return std::hypot(number(vector[0]), number(vector[1])); }

/// The lines, from the members of summary.json.
class Lines {
 public:
  explicit Lines(const Json& summary) : summary_{summary}, units_{summary.at("units")} {}

  std::vector<std::string> all() {
    lines_.push_back(word(summary_.at("title")));
    if (summary_.contains("verdict")) {
      passages();
      forces();
    } else {
      last_contact();
    }
    quality();
    head();
    final_state();
    failures();
    ledger();
    lines_.emplace_back("run monitor");
    for (const Json& line : summary_.at("monitor"))
      lines_.push_back("  " + word(line));
    return lines_;
  }

 private:
  void add(const std::string& subject, const std::string& text) {
    lines_.push_back(fmt::format("  {:<12} {}", subject, text));
  }
  std::string with_unit(double value, const char* unit) const {
    return fmt::format("{:.4g} {}", value, word(units_.at(unit)));
  }
  std::string at(const Json& time) const { return "at t = " + with_unit(number(time), "time"); }
  std::string speed(double value) const {
    return fmt::format("{:.4g} {}/{}", value, word(units_.at("length")), word(units_.at("time")));
  }

  static std::string verdict(const Json& name) {
    static const std::map<std::string, std::string> texts{{"stopped", "stopped"},
                                                          {"undecided", "undecided at the end"},
                                                          {"passed_under", "passed under"},
                                                          {"passed_over", "passed over"},
                                                          {"broke_through", "broke through"}};
    return texts.at(word(name));
  }

  void passages() {
    add("verdict", verdict(summary_.at("verdict").at("fence")));
    for (const Json& rock : summary_.at("verdict").at("rocks")) {
      std::string text = verdict(rock.at("verdict"));
      if (number(rock.at("passed_time")) > 0.0) text += " " + at(rock.at("passed_time"));
      const bool touches = rock.at("still_touching").get<bool>();
      if (!rock.at("touched").get<bool>()) {
        text += "; it never touched the fence";
      } else {
        const double left = number(rock.at(touches ? "energy_at_end" : "energy_after"));
        const double before = number(rock.at("approach_energy"));
        text += touches ? "; still touching at the end: " : "; after its last contact ";
        text += speed(length_of(rock.at(touches ? "velocity_at_end" : "velocity_after"))) + ", ";
        text += with_unit(left, "energy") + " of " + with_unit(before, "energy");
        text += fmt::format(" ({:.1f} %)", left / before * 100.0);
        if (!touches) text += "; last contact " + at(rock.at("last_contact_time"));
        if (word(rock.at("verdict")) == "undecided") {
          text += "; it still advances at " + speed(std::abs(number(rock.at("velocity_at_end")[0]))) +
                  ": a longer run decides";
        }
      }
      add(word(rock.at("name")), text);
    }
  }

  void force(const std::string& subject, const Json& largest, const Json& closest) {
    const Json& margin = largest.at("margin");
    add(subject,
        fmt::format("{} {}, {}: {}", with_unit(number(largest.at("peak")), "force"), at(largest.at("time")),
                    word(largest.at("name")),
                    margin.is_null() ? "no limit" : fmt::format("{:.1f} % of its limit", number(margin) * 100.0)));
    if (closest.is_null() || closest.at("name") == largest.at("name")) return;
    add("", fmt::format("closest to its limit: {}, {:.1f} %", word(closest.at("name")),
                        number(closest.at("margin")) * 100.0));
  }

  void forces() {
    const Json& of = summary_.at("verdict");
    const Json& anchor = of.at("largest_anchor_force");
    add("anchor", with_unit(number(anchor.at("peak")), "force") + " " + at(anchor.at("time")));
    force("cable", of.at("largest_cable_force"), of.value("cable_closest_to_limit", Json{}));
    force("hanger", of.at("largest_hanger_force"), of.value("hanger_closest_to_limit", Json{}));
  }

  void last_contact() {
    const Json& last = summary_.at("quality").at("last_contact");
    add("last contact", fmt::format("{}, {} {}", word(last.at("name")),
                                    last.at("touching").get<bool>() ? "still touching" : "ended", at(last.at("time"))));
  }

  void quality() {
    const Json& of = summary_.at("quality");
    const auto balance = [](const Json& whose) {
      return fmt::format("energy balance within {:.2g} %", number(whose.at("energy_balance")) * 100.0);
    };
    const std::string flaw = word(of.at("flaw"));
    add("quality", flaw.empty() ? "usable; " + balance(of) : "NOT USABLE: " + flaw);
    std::string steps = word(of.at("step"));
    if (const Json count = of.value("steps_in_shortest_contact", Json{}); !count.is_null())
      steps +=
          (number(count) < 10.0 ? fmt::format("; {:.2g}", number(count)) : fmt::format("; {:.0f}", number(count))) +
          " steps in the shortest contact";
    const bool is_fence = summary_.contains("verdict");
    if (const Json last = of.value("last_contact", Json{});
        is_fence && !last.is_null() && last.at("touching").get<bool>())
      steps += fmt::format("; {} still touches at the end", word(last.at("name")));
    add("", steps);
    if (const Json through = of.value("undeclared_overlaps", Json{}); !through.is_null() && !through.empty()) {
      const std::size_t others = through.size() - 1;
      add("no contact",
          fmt::format("'{}' and '{}' passed through each other{}", word(through[0][0]), word(through[0][1]),
                      others > 0 ? fmt::format(", and {} other pairs", others) : ""));
    }
    if (const Json repeat = of.value("repeat", Json{}); !repeat.is_null()) {
      const bool same = repeat.at("verdict") == summary_.at("verdict").at("fence");
      add("sensitivity",
          fmt::format("with {:g} times the rocks' speed the verdict {}; the largest cable force changes by {:+.2g} %",
                      1.0 + number(repeat.at("change_of_speed")),
                      same ? "is unchanged" : "becomes: " + verdict(repeat.at("verdict")),
                      number(repeat.at("change_of_largest_cable_force")) * 100.0));
    }
    if (const Json repair = of.value("repair", Json{}); !repair.is_null()) {
      const std::string remains = word(repair.at("flaw")), how = word(repair.at("option")) + " was tried and ";
      add("repair", how + (remains.empty() ? "repairs it: " + verdict(repair.at("verdict")) + ", " + balance(repair)
                                           : "does not help: " + remains));
    }
  }

  void head() {
    const std::string time = word(units_.at("time"));
    add("outcome", fmt::format("{} at t = {:.10g} {}", word(summary_.at("outcome").at("kind")),
                               number(summary_.at("outcome").at("time")), time));
    add("integrator",
        fmt::format("{}, step {:.6g} {}", word(summary_.at("integrator")), number(summary_.at("step")), time));
    if (const Json reason = summary_.value("integrator_reason", Json{}); !reason.is_null() && reason != "")
      add("", "chosen, as " + word(reason));
    std::string steps = fmt::format("{}, force evaluations {}", summary_.at("steps").get<long>(),
                                    summary_.at("evaluations").get<long>());
    if (summary_.contains("events")) steps += fmt::format(", events located {}", summary_.at("events").get<long>());
    add("steps", steps);
    const Json& model = summary_.at("model");
    const auto count = [&](const char* of) { return model.at(of).get<long>(); };
    add("model",
        fmt::format("{} bodies, {} degrees of freedom, {} contacts, {} cables, {} law instances", count("bodies"),
                    count("degrees_of_freedom"), count("contacts"), count("cables"), count("law_instances")));
  }

  void final_state() {
    const std::string length = word(units_.at("length")), rate = length + "/s";
    lines_.emplace_back("final state");
    const auto row = [&](const std::vector<std::string>& cells) {
      std::string line = fmt::format("  {:<14}", cells.front());
      for (std::size_t i = 1; i < cells.size(); ++i)
        line += fmt::format("{:>14}", cells[i]);
      lines_.push_back(line);
    };
    row({"body", "x", "y", "angle", "vx", "vy", "spin"});
    row({"", length, length, "rad", rate, rate, "rad/s"});
    for (const Json& body : summary_.at("bodies")) {
      std::vector<std::string> cells{word(body.at("name"))};
      for (const Json& value : {body.at("position")[0], body.at("position")[1], body.at("angle"),
                                body.at("velocity")[0], body.at("velocity")[1], body.at("spin")})
        cells.push_back(fmt::format("{:.7g}", number(value)));
      row(cells);
    }
  }

  void failures() {
    if (summary_.at("failures").empty()) return;
    lines_.emplace_back("yielded and broke, in this order");
    for (const Json& failure : summary_.at("failures"))
      lines_.push_back(fmt::format("  t = {:<12.6g} {} {}", number(failure.at("time")), word(failure.at("part")),
                                   word(failure.at("event"))));
  }

  void ledger() {
    const Json& of = summary_.at("ledger");
    const std::string energy = word(units_.at("energy"));
    const auto amount = [&](const std::string& name, const Json& value) {
      lines_.push_back(fmt::format("  {:<28}{:>16.8g}", name, number(value)));
    };
    lines_.push_back(fmt::format("energy ledger at the end ({})", energy));
    amount("kinetic", of.at("energy").at("kinetic"));
    amount("gravity", of.at("energy").at("gravity"));
    amount("applied forces", of.at("energy").at("applied"));
    amount("stored in contacts", of.at("energy").at("contacts"));
    amount("stored in cables", of.at("energy").at("cables"));
    for (const auto& [name, value] : of.at("dissipated").items())
      amount("dissipated: " + name, value);
    const double largest = number(of.at("largest_energy_balance_error")), scale = number(of.at("energy_scale"));
    lines_.push_back(fmt::format("  {:<28}{:>16.3e}   largest {:.3e}, {:.3e} of the largest energy {:.6g}",
                                 "balance error", number(of.at("energy_balance_error")), largest, largest / scale,
                                 scale));
    const Json& momentum = of.at("momentum_balance_error");
    lines_.push_back(fmt::format("momentum balance error          ({:.3e}, {:.3e}) {}", number(momentum[0]),
                                 number(momentum[1]), word(units_.at("momentum"))));
    lines_.push_back(fmt::format("angular momentum balance error   {:.3e} {}",
                                 number(of.at("angular_momentum_balance_error")), word(units_.at("angular_momentum"))));
  }

  const Json& summary_;
  const Json& units_;
  std::vector<std::string> lines_;
};

}  // namespace

std::vector<std::string> expected_print(const Json& summary) { return Lines{summary}.all(); }

std::vector<std::string> compared_print(const std::string& printed) {
  std::vector<std::string> lines;
  std::istringstream text{printed};
  for (std::string line; std::getline(text, line);)
    if (!line.starts_with("note: ") && !line.starts_with("files: ")) lines.push_back(line);
  return lines;
}

}  // namespace talus::verification::problems::agreeing_files
