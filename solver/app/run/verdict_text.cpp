#include "solver/app/run/verdict_text.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace talus::app {
namespace {

using scenes::Verdict;

std::string_view verdict_text(Verdict verdict) {
  switch (verdict) {
    case Verdict::stopped:
      return "stopped";
    case Verdict::undecided:
      return "undecided at the end";
    case Verdict::passed_under:
      return "passed under";
    case Verdict::passed_over:
      return "passed over";
    case Verdict::broke_through:
      return "broke through";
  }
  return "";
}

/// Builds the lines of one record.
class Lines {
 public:
  explicit Lines(const RunRecord& record) : record_{record} {}

  std::vector<std::string> all() {
    if (record_.fence) {
      fence();
    } else {
      last_contact();
    }
    quality();
    return lines_;
  }

 private:
  void add(std::string_view subject, const std::string& text) {
    lines_.push_back(fmt::format("{:<13}{}", subject, text));
  }
  std::string value(double number, Dimension dimension) const {
    return fmt::format("{:.4g} {}", number, symbol(record_.units, dimension));
  }
  std::string at(double time) const { return "at t = " + value(time, dimension::time); }

  void fence() {
    const scenes::FenceSummary& fence = *record_.fence;
    add("verdict", std::string{verdict_text(fence.verdict())});
    for (const scenes::RockPassage& rock : fence.rocks)
      add(rock.name, passage(rock));
    forces(fence);
  }

  std::string passage(const scenes::RockPassage& rock) const {
    std::string text{verdict_text(rock.verdict)};
    if (rock.passed_time > 0.0) text += " " + at(rock.passed_time);
    if (!rock.touched) return text + "; it never touched the fence";
    const bool over = rock.left;
    const double speed = norm(over ? rock.exit_velocity : rock.end_velocity);
    const double energy = over ? rock.exit_energy : rock.end_energy;
    text +=
        fmt::format("; {} {}, {} of {}",
                    over ? "after its last contact" : "still touching at the end:", value(speed, dimension::velocity),
                    value(energy, dimension::energy), value(rock.approach_energy, dimension::energy));
    if (rock.approach_energy > 0.0) text += fmt::format(" ({:.1f} %)", 100.0 * energy / rock.approach_energy);
    if (over) text += "; last contact " + at(rock.exit_time);
    if (rock.verdict == Verdict::undecided) {
      text += fmt::format("; it still advances at {}: a longer run decides",
                          value(std::abs(rock.end_velocity.x), dimension::velocity));
    }
    return text;
  }

  static std::string margin(double ratio) {
    return ratio > 0.0 ? fmt::format("{:.1f} % of its limit", 100.0 * ratio) : "no limit";
  }

  void forces(const scenes::FenceSummary& fence) {
    if (const auto* anchor = fence.largest_anchor())
      add("anchor", fmt::format("{} {}", value(anchor->force.peak, dimension::force), at(anchor->force.peak_time)));
    if (fence.segments.empty()) return;
    // Names of cables and columns are in the record's lists, which have the order of the fence.
    const scenes::SegmentRecord& cable = *fence.largest_segment();
    add("cable", fmt::format("{} {}, {}: {}", value(cable.peak, dimension::force), at(cable.peak_time),
                             cable_name(cable), margin(cable.margin())));
    if (const scenes::SegmentRecord& closest = *fence.closest_segment(); &closest != &cable && closest.margin() > 0.0) {
      add("", fmt::format("closest to its limit: {}, {:.1f} %", cable_name(closest), 100.0 * closest.margin()));
    }
    if (fence.columns.empty()) return;
    const scenes::ColumnRecord& hanger = *fence.largest_hanger();  // all have one limit
    add("hanger", fmt::format("{} {}, {}: {}", value(hanger.hanger.peak, dimension::force), at(hanger.hanger.peak_time),
                              record_.bodies[index(hanger.body)].name, margin(hanger.margin())));
  }

  const std::string& cable_name(const scenes::SegmentRecord& segment) const {
    return record_.cables_left[index(segment.cable)].name;
  }

  void last_contact() {
    if (record_.contacts == 0) return;
    const auto& last = record_.quality.last_contact;
    if (!last) return add("last contact", "none: nothing touched" + closest());
    add("last contact", (last->touching ? fmt::format("{}, still touching {}", last->name, at(last->time))
                                        : fmt::format("{}, ended {}", last->name, at(last->time))) +
                            untouched());
  }

  /// Text with the number of contacts that never touched; empty if there are none.
  std::string untouched() const {
    const auto count = std::ranges::count_if(record_.extremes, [](const ExtremeRecord& item) {
      return item.column.name.ends_with(".overlap") && item.extreme.maximum < 0.0;
    });
    return count == 0 ? "" : fmt::format("; {} of {} contacts never touched{}", count, record_.contacts, closest());
  }

  /// Text with the pair that came closest without touching, from the recorded overlaps (negative overlaps are gaps).
  std::string closest() const {
    const ExtremeRecord* best = nullptr;
    for (const ExtremeRecord& item : record_.extremes) {
      if (!item.column.name.ends_with(".overlap") || !std::isfinite(item.extreme.maximum)) continue;
      if (item.extreme.maximum >= 0.0) continue;
      if (!best || item.extreme.maximum > best->extreme.maximum) best = &item;
    }
    if (!best) return "";
    return fmt::format("; closest was {} with a gap of {}", best->column.name.substr(0, best->column.name.rfind('.')),
                       value(-best->extreme.maximum, dimension::length));
  }

  void quality() {
    const RunQuality& quality = record_.quality;
    std::string text = "NOT USABLE: " + quality.flaw;
    if (quality.flaw.empty()) {
      text = quality.balance ? fmt::format("usable; energy balance within {:.2g} %", 100.0 * *quality.balance)
                             : "not examined: no energy balance was kept (ledger)";
    }
    add("quality", text);
    std::string steps = quality.step;
    if (const auto in_contact = quality.contact_steps) {
      steps += *in_contact < 10.0 ? fmt::format("; {:.2g}", *in_contact) : fmt::format("; {:.0f}", *in_contact);
      steps += " steps in the shortest contact";
    }
    if (record_.fence && quality.last_contact && quality.last_contact->touching)
      steps += fmt::format("; {} still touches at the end", quality.last_contact->name);
    add("", steps);
    if (!quality.undeclared_overlaps.empty()) {
      const auto& [a, b] = quality.undeclared_overlaps.front();
      const std::size_t others = quality.undeclared_overlaps.size() - 1;
      add("no contact", fmt::format("'{}' and '{}' passed through each other{}", a, b,
                                    others > 0 ? fmt::format(", and {} other pairs", others) : ""));
    }
    if (quality.repeat) {
      add("sensitivity", repeat(*quality.repeat));
    } else if (record_.fence && quality.flaw.empty()) {
      add("sensitivity", "not examined; --sheet repeats the run with faster rocks");
    }
    if (quality.repair) add("repair", repair(*quality.repair));
  }

  std::string repeat(const RunQuality::Repeat& repeat) const {
    const std::string start = fmt::format("with {:g} times the rocks' speed ", 1.0 + repeat.change);
    if (!repeat.failure.empty()) return start + "the run fails: " + repeat.failure;
    const std::string force = fmt::format("the largest cable force changes by {:+.2g} %", 100.0 * repeat.cable_change);
    if (repeat.verdict == record_.fence->verdict()) return start + "the verdict is unchanged; " + force;
    return start + fmt::format("the verdict becomes: {}; {}", verdict_text(repeat.verdict), force);
  }

  static std::string repair(const RunQuality::Repair& repair) {
    if (!repair.flaw.empty()) return fmt::format("{} was tried and does not help: {}", repair.option, repair.flaw);
    const std::string balance =
        repair.balance ? fmt::format(", energy balance within {:.2g} %", 100.0 * *repair.balance) : "";
    return fmt::format("{} was tried and repairs it: {}{}", repair.option, verdict_text(repair.verdict), balance);
  }

  const RunRecord& record_;
  std::vector<std::string> lines_;
};

}  // namespace

std::vector<std::string> verdict_lines(const RunRecord& record) { return Lines{record}.all(); }

}  // namespace talus::app
