#include "solver/app/run/run_summary.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>
#include <span>

#include "solver/app/run/verdict_text.hpp"

namespace talus::app {
namespace {

/// Text builder that appends lines.
class Page {
 public:
  template <class... Values>
  void line(fmt::format_string<Values...> pattern, Values&&... values) {
    fmt::format_to(std::back_inserter(text_), pattern, std::forward<Values>(values)...);
    text_ += '\n';
  }
  const std::string& text() const { return text_; }

 private:
  std::string text_;
};

void head(Page& page, const RunRecord& record) {
  const std::string time = symbol(record.units, dimension::time);
  page.line("{}", record.title);
  for (const std::string& line : verdict_lines(record))
    page.line("  {}", line);
  if (record.outcome) {
    const bool finished = record.outcome.kind == Outcome::Kind::finished;
    page.line("  outcome      {} at t = {:.10g} {}", finished ? "finished" : "stopped", record.outcome.time, time);
  } else {
    // The reason is in the line of the quality.
    page.line("  outcome      diverged at t = {:.10g} {}", record.outcome.time, time);
  }
  page.line("  integrator   {}, step {:.6g} {}", record.integrator, record.plan.step, time);
  if (!record.integrator_reason.empty()) page.line("               chosen, as {}", record.integrator_reason);
  const std::string events = record.events ? fmt::format(", events located {}", *record.events) : "";
  page.line("  steps        {}, force evaluations {}{}", record.steps, record.evaluations, events);
  page.line("  model        {} bodies, {} degrees of freedom, {} contacts, {} cables, {} law instances",
            record.bodies.size(), record.coordinates, record.contacts, record.cables, record.laws);
}

/// Printed only for runs that were long enough to be sampled.
void step_parts(Page& page, const StepParts::Found& parts) {
  if (parts.looks == 0) return;
  page.line(
      "  of these     {} pairs: {:.1f} within reach, {:.1f} touching; cables: {:.1f} awake, {:.1f} taut; {} values "
      "kept "
      "by laws (mean of {} looks)",
      parts.pairs, parts.near, parts.touching, parts.awake, parts.taut, parts.memory, parts.looks);
  const StepParts::Times& t = parts.times;
  page.line(
      "  a step       {:.0f} ns: contacts {:.0f}, cables {:.0f}, bodies {:.0f}, integration and watch {:.0f}, "
      "observers {:.0f}",
      t.step, t.contacts, t.cables, t.bodies, t.integration, t.observers);
}

/// Prints all bodies, or without `all` at most the first 20.
void final_state(Page& page, const RunRecord& record, bool all) {
  const UnitSystem& units = record.units;
  const std::string length = symbol(units, dimension::length);
  const std::string speed = symbol(units, dimension::velocity);
  page.line("final state");
  page.line("  {:<14}{:>14}{:>14}{:>14}{:>14}{:>14}{:>14}", "body", "x", "y", "angle", "vx", "vy", "spin");
  page.line("  {:<14}{:>14}{:>14}{:>14}{:>14}{:>14}{:>14}", "", length, length, "rad", speed, speed,
            symbol(units, dimension::angular_velocity));
  constexpr std::size_t maximum = 20;
  const std::size_t shown = all ? record.bodies.size() : std::min(maximum, record.bodies.size());
  for (const BodyState& body : std::span{record.bodies}.first(shown)) {
    page.line("  {:<14}{:>14.7g}{:>14.7g}{:>14.7g}{:>14.7g}{:>14.7g}{:>14.7g}", body.name, body.p.x, body.p.y,
              body.angle, body.v.x, body.v.y, body.spin);
  }
  if (shown < record.bodies.size()) page.line("  {} more: --all, or final_state.json", record.bodies.size() - shown);
}

void failures(Page& page, const RunRecord& record) {
  if (record.failures.empty()) return;
  page.line("yielded and broke, in this order");
  for (const Failure& failure : record.failures)
    page.line("  t = {:<12.6g} {} {}", failure.time, failure.part, failure.what);
}

/// Printed only if the table of impacts was requested.
void impacts(Page& page, const RunRecord& record) {
  if (!record.impacts) return;
  const std::vector<ImpactRecord>& all = *record.impacts;
  if (all.empty()) return page.line("impacts: none");
  const std::vector<std::size_t> largest = largest_impacts(all, impacts_of_summary);
  page.line("impacts: {}, of these the largest (all in impacts.csv)", all.size());
  page.line("  {:<8}{:<20}{:>14}{:>14}{:>14}{:>14}{:>14}{:>14}", "number", "contact", "touch", "approach",
            "restitution", "peak force", "overlap", "impulse");
  const UnitSystem& units = record.units;
  page.line("  {:<8}{:<20}{:>14}{:>14}{:>14}{:>14}{:>14}{:>14}", "", "", symbol(units, dimension::time),
            symbol(units, dimension::velocity), "", symbol(units, dimension::force), symbol(units, dimension::length),
            symbol(units, dimension::momentum));
  for (const std::size_t i : largest) {
    const RecordedImpact& impact = all[i].impact;
    const auto restitution = impact.restitution();
    page.line("  {:<8}{:<20}{:>14.7g}{:>14.7g}{:>14}{:>14.7g}{:>14.7g}{:>14.7g}", i + 1, all[i].contact,
              impact.touch_time, impact.approach_speed, restitution ? fmt::format("{:.6g}", *restitution) : "-",
              impact.peak_force, impact.largest_overlap, impact.normal_impulse);
  }
}

void extremes(Page& page, const RunRecord& record) {
  page.line("extremes over all steps");
  page.line("  {:<28}{:>14}{:>12}{:>16}{:>12}  unit", "quantity", "minimum", "at t", "maximum", "at t");
  for (const ExtremeRecord& item : record.extremes) {
    if (item.column.name.rfind("balance_error.", 0) == 0) continue;  // printed with the energy ledger below
    if (item.extreme.minimum == 0.0 && item.extreme.maximum == 0.0) continue;
    page.line("  {:<28}{:>14.7g}{:>12.6g}{:>16.7g}{:>12.6g}  {}", item.column.name, item.extreme.minimum,
              item.extreme.minimum_time, item.extreme.maximum, item.extreme.maximum_time,
              symbol(record.units, item.column.dimension));
  }
}

void ledger(Page& page, const RunRecord& record) {
  if (!record.plan.ledger) return page.line("ledger: off; no energies and balance errors were recorded");
  const Accounts& accounts = record.accounts;
  const Energies& energies = accounts.energies;
  const std::string energy = symbol(record.units, dimension::energy);
  page.line("energy ledger at the end ({})", energy);
  page.line("  {:<28}{:>16.8g}", "kinetic", energies.kinetic);
  page.line("  {:<28}{:>16.8g}", "gravity", energies.gravity);
  page.line("  {:<28}{:>16.8g}", "applied forces", energies.applied);
  page.line("  {:<28}{:>16.8g}", "stored in contacts", energies.contacts);
  page.line("  {:<28}{:>16.8g}", "stored in cables", energies.cables);
  for (std::size_t i = 0; i < mechanism_count; ++i) {
    page.line("  {:<28}{:>16.8g}", fmt::format("dissipated: {}", name_of(static_cast<Mechanism>(i))),
              accounts.dissipated[i]);
  }
  const double scale = record.energy_scale;
  page.line("  {:<28}{:>16.3e}   largest {:.3e}, {:.3e} of the largest energy {:.6g}", "balance error",
            accounts.energy_balance_error, record.largest_energy_balance_error,
            scale > 0.0 ? record.largest_energy_balance_error / scale : 0.0, scale);
  page.line("momentum balance error          ({:.3e}, {:.3e}) {}", accounts.momentum_balance_error.x,
            accounts.momentum_balance_error.y, symbol(record.units, dimension::momentum));
  page.line("angular momentum balance error   {:.3e} {}", accounts.angular_momentum_balance_error,
            symbol(record.units, dimension::angular_momentum));
}

}  // namespace

std::string run_summary(const RunRecord& record, const StepParts::Found& parts, bool all) {
  Page page;
  head(page, record);
  if (all) step_parts(page, parts);
  final_state(page, record, all);
  failures(page, record);
  impacts(page, record);
  if (all) extremes(page, record);
  ledger(page, record);
  if (!record.watched.empty()) page.line("run monitor");
  for (const std::string& seen : record.watched)
    page.line("  {}", seen);
  for (const std::string& note : record.notes)
    page.line("note: {}", note);
  return page.text();
}

}  // namespace talus::app
