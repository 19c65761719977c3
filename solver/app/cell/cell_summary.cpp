#include "solver/app/cell/cell_summary.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "solver/app/outputs/output_size.hpp"

namespace talus::app {
namespace {

std::string with_unit(const CellScene& scene, double value, Dimension dimension) {
  if (std::isnan(value)) return "-";
  if (!scene.units || dimension == dimension::number) return fmt::format("{:.4g}", value);
  return fmt::format("{:.4g} {}", value, symbol(*scene.units, dimension));
}

std::string line(const CellScene& scene, const CellNumber& number) {
  std::string value = with_unit(scene, number.estimate.value, number.dimension);
  if (number.estimate.error > 0.0) value += fmt::format(" +- {:.2g}", number.estimate.error);
  const std::string drift =
      std::abs(number.drift) > 3.0
          ? fmt::format("; not steady: the later half is {:+.1f} standard errors off the earlier", number.drift)
          : "";
  return fmt::format("  {:24} {:28} {}{}\n", number.name, value, number.meaning, drift);
}

std::string law_text(const CellScene& scene, const ShearCell& cell) {
  std::string value{std::visit([](const auto& of) { return of.name; }, cell.law)};
  if (cell.friction) {
    std::visit(
        [&]<class F>(const F& of) {
          value += fmt::format(", friction {}{}", of.coefficient,
                               has_varying_stiffness<F> ? fmt::format(" by {}", F::name) : std::string{});
        },
        *cell.friction);
  }
  if (!cell.is_linear())
    value += fmt::format("; impacts are stated at {}", with_unit(scene, cell.nominal_speed(), dimension::velocity));
  return value;
}

}  // namespace

std::string cell_summary(const CellScene& scene, CellRun& run, const CellOutcome& outcome) {
  std::string text = scene.title + "\n";
  const auto add = [&](const char* name, const std::string& value) {
    text += fmt::format("  {:24} {}\n", name, value);
  };
  const Outcome& end = outcome.outcome;
  add("outcome", fmt::format("{} at t = {}{}", name_of(end.kind), with_unit(scene, end.time, dimension::time),
                             end ? "" : ": " + end.message));
  add("integrator",
      fmt::format("{}, step {}", scene.plan.integrator, with_unit(scene, scene.plan.step, dimension::time)));
  add("law", law_text(scene, run.cell()));
  add("steps", run.jumped() == 0 ? fmt::format("{}", run.steps())
                                 : fmt::format("{}, of which {} passed at once", run.steps(), run.jumped()));
  add("discs", fmt::format("{} free, {} in each wall; seed {}", run.cell().free_discs(), run.cell().wall_discs,
                           run.cell().seed));
  add("overburden", with_unit(scene, run.cell().overburden(), dimension::pressure));
  text += "groups\n";
  for (const CellNumber& group : cell_groups(scene, run))
    text += line(scene, group);
  if (run.mean(CellQuantity::depth).value > 0.0) {
    text += fmt::format("means after the first {} % of the time, with standard errors\n",
                        100 * CellRun::start_up / CellRun::blocks);
    for (const CellNumber& result : cell_results(run))
      text += line(scene, result);
  } else {
    text += fmt::format("no means yet: the first {} % of the time are the start-up\n",
                        100 * CellRun::start_up / CellRun::blocks);
  }
  const CellRun::Ledger ledger = run.ledger();
  text += "energy\n";
  const auto energy = [&](const char* name, double value, const char* meaning) {
    text += line(scene, {name, dimension::energy, {value, 0.0}, 0.0, meaning});
  };
  energy("input", ledger.input, "work of what drives the block");
  energy("dissipated", ledger.dissipated, "by contacts");
  if (scene.cell.friction) energy("friction_work", ledger.friction_work, "of it by friction");
  energy("kinetic", ledger.kinetic, "");
  energy("stored", ledger.stored, "in contacts");
  add("balance error", fmt::format("{:.2g} of the work", ledger.relative_balance_error()));
  return text;
}

std::vector<std::string> cell_warnings(const CellScene& scene, CellRun& run) {
  std::vector<std::string> warnings;
  const double overlap = run.largest_overlap() / scene.cell.diameter;
  if (overlap > CellRun::deepest || run.largest_fraction() > CellRun::fullest) {
    warnings.push_back(
        fmt::format("the largest overlap is {:.3g} diameters, the largest solid fraction {:.4g}; beyond {} and {} "
                    "discs do not behave as hard ones: stiffer contacts, or less speed or load",
                    overlap, run.largest_fraction(), CellRun::deepest, CellRun::fullest));
  }
  const CellRun::Ledger ledger = run.ledger();
  const double balance_error = ledger.relative_balance_error();
  if (!scene.plan.historical && run.failure().empty() && ledger.work() > ledger.held() &&
      std::abs(balance_error) > CellRun::maximum_balance_error) {
    warnings.push_back(
        fmt::format("{:.2g} of the work is unaccounted for, more than {}: the step is too long, or the integrator "
                    "adds or takes energy",
                    balance_error, CellRun::maximum_balance_error));
  }
  return warnings;
}

std::string cell_check(const CellScene& scene) {
  CellRun run{scene.cell, scene.plan};
  const ShearCell& cell = scene.cell;
  std::string text = scene.title + "\n";
  const auto add = [&](const char* name, const std::string& value) {
    text += fmt::format("  {:24} {}\n", name, value);
  };
  add("discs", fmt::format("{} free in {} rows, {} in each wall; seed {}", cell.free_discs(), cell.rows,
                           cell.wall_discs, cell.seed));
  add("overburden", with_unit(scene, cell.overburden(), dimension::pressure));
  add("law", law_text(scene, cell));
  add("contact time", with_unit(scene, cell.contact_time(), dimension::time));
  add("step", fmt::format("{} with {}", with_unit(scene, scene.plan.step, dimension::time), scene.plan.integrator));
  add("expected cost", fmt::format("{} steps and force evaluations to {}; {} outputs", run.last_step(),
                                   with_unit(scene, scene.plan.end, dimension::time), scene.plan.outputs()));
  if (scene.restart) add("start", "RESTART.DAT beside the file, which is not inspected here");
  // Evaluated before expected_output(), which advances the run.
  const std::vector<CellNumber> groups = cell_groups(scene, run);
  add("expected output of --out", output_size_text(expected_output(scene, run)));
  text += "groups\n";
  for (const CellNumber& group : groups)
    text += line(scene, group);
  return text;
}

}  // namespace talus::app
