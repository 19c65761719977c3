#include "reports/sheet/sheet_verdict.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "reports/sheet/sheet_units.hpp"

namespace talus::reports {
namespace {

std::string verdict_text(std::string verdict) {
  if (verdict == "undecided") return "undecided at the end";
  std::replace(verdict.begin(), verdict.end(), '_', ' ');
  return verdict;
}

std::string colour(const std::string& verdict) {
  if (verdict == "stopped") return "green";
  return verdict == "undecided" ? "amber" : "red";
}

std::string as_per_cent(double ratio) { return fmt::format("{:.3g} %", 100.0 * ratio); }
std::string at(double time) { return fmt::format("at {:.4f} s", time); }

std::string margin(double ratio) { return ratio > 0.0 ? as_per_cent(ratio) + " of its limit" : "no limit"; }

std::string passage(const SheetRecord& record, const SheetRock& rock) {
  std::string text = verdict_text(rock.verdict);
  if (rock.passed_time > 0.0) text += " " + at(rock.passed_time);
  if (!rock.touched) return text + "; it never touched the fence";
  const double speed = size(rock.left ? rock.exit_velocity : rock.end_velocity);
  const double energy = rock.left ? rock.exit_energy : rock.end_energy;
  text += rock.left ? fmt::format("; after its last contact {} ", at(rock.exit_time)) : "; still touching at the end: ";
  text += fmt::format("{}, {}, {} of its energy", with_units(record.us_units, speed, speed_units),
                      with_units(record.us_units, energy, energy_units), as_per_cent(energy / rock.approach_energy));
  if (rock.verdict == "undecided")
    text += fmt::format("; it still advances at {}",
                        with_units(record.us_units, std::abs(rock.end_velocity[0]), speed_units));
  return text;
}

/// Number of rocks for each verdict.
std::string counts(const SheetRecord& record) {
  std::string text;
  for (const char* verdict : {"broke_through", "passed_over", "passed_under", "undecided", "stopped"}) {
    const auto count = std::ranges::count(record.rocks, verdict, &SheetRock::verdict);
    if (count > 0) text += fmt::format("{}{} {}", text.empty() ? "" : ", ", count, verdict_text(verdict));
  }
  return text;
}

/// The part that is closest to its limit, if it is not the one with the largest force.
template <class Parts>
std::string closest(const Parts& parts, const typename Parts::value_type& named) {
  const auto found = std::ranges::max_element(parts, {}, [](const auto& part) { return part.margin; });
  if (!(found->margin > named.margin)) return "";
  return fmt::format("; closest to its limit: {}, {}", found->name, as_per_cent(found->margin));
}

std::vector<SheetFact> facts(const SheetRecord& record) {
  std::vector<SheetFact> found;
  if (record.rocks.size() > 1) found.push_back({"rocks", counts(record)});
  const auto worst = std::ranges::find(record.rocks, record.verdict, &SheetRock::verdict);
  if (worst != record.rocks.end()) found.push_back({worst->name, passage(record, *worst)});
  const auto largest = [](const auto& list, const auto& value) { return std::ranges::max_element(list, {}, value); };
  if (const auto anchor = largest(record.anchors, [](const SheetAnchor& a) { return size(a.force.at_peak); });
      anchor != record.anchors.end())
    found.push_back({"anchor force",
                     with_units(record.us_units, anchor->force.peak, force_units) + " " + at(anchor->force.peak_time)});
  if (const auto cable = largest(record.segments, &SheetSegment::peak); cable != record.segments.end()) {
    found.push_back({"cable force", fmt::format("{} {}, {}: {}", with_units(record.us_units, cable->peak, force_units),
                                                at(cable->peak_time), cable->name, margin(cable->margin)) +
                                        closest(record.segments, *cable)});
  }
  if (const auto hanger = largest(record.columns, [](const SheetColumn& c) { return c.hanger.peak; });
      hanger != record.columns.end()) {
    found.push_back(
        {"hanger force", fmt::format("{} {}, {}: {}", with_units(record.us_units, hanger->hanger.peak, force_units),
                                     at(hanger->hanger.peak_time), hanger->name, margin(hanger->margin)) +
                             closest(record.columns, *hanger)});
  }
  return found;
}

std::string repeat(const SheetRecord& record, const SheetQuality::Repeat& repeat) {
  const std::string start = fmt::format("with {:g} times the speed ", 1.0 + repeat.change);
  if (!repeat.failure.empty()) return start + "the run fails: " + repeat.failure;
  const std::string verdict = repeat.verdict == record.verdict ? "the verdict is unchanged"
                                                               : "the verdict becomes: " + verdict_text(repeat.verdict);
  return start + fmt::format("{}; largest cable force {:+.2g} %", verdict, 100.0 * repeat.cable_change);
}

std::string repair(const SheetQuality::Repair& repair) {
  if (!repair.flaw.empty()) return fmt::format("{} was tried and does not help: {}", repair.option, repair.flaw);
  const std::string balance = repair.balance ? ", energy balance within " + as_per_cent(*repair.balance) : "";
  return fmt::format("{} was tried and repairs it: {}{}", repair.option, verdict_text(repair.verdict), balance);
}

std::vector<SheetFact> quality_facts(const SheetRecord& record) {
  const SheetQuality& quality = record.quality;
  std::vector<SheetFact> found;
  if (!quality.usable) found.push_back({"reason", quality.flaw});
  if (quality.repair) found.push_back({"repair", repair(*quality.repair)});
  found.push_back({"energy balance", quality.balance ? "within " + as_per_cent(*quality.balance) : "not kept"});
  found.push_back({"steps", quality.step + (quality.contact_steps ? fmt::format("; {:.0f} in the shortest contact",
                                                                                *quality.contact_steps)
                                                                  : "")});
  found.push_back({"at the end", quality.touching ? *quality.touching + " still touches" : "nothing touches"});
  found.push_back({"sensitivity", quality.repeat ? repeat(record, *quality.repeat) : "not examined"});
  return found;
}

}  // namespace

std::array<SheetBox, 2> sheet_boxes(const SheetRecord& record) {
  const bool usable = record.quality.usable;
  return {
      SheetBox{"Verdict: " + verdict_text(record.verdict), usable ? colour(record.verdict) : "red", facts(record)},
      SheetBox{usable ? "Quality: usable" : "Quality: NOT USABLE", usable ? "green" : "red", quality_facts(record)}};
}

}  // namespace talus::reports
