#include "solver/cell/cell_plan.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <cmath>

#include "solver/granular/disc_method.hpp"

namespace talus {
namespace {

constexpr double maximum_outputs = 1e5, maximum_steps = 1e15;
/// Largest w h of a pair: w2 on unloading, or at the nominal overlap of a law that is not linear; w_s of a pair that
/// sticks. In a triangular array of discs the stiffest motion is sqrt(3) times as fast as that of a pair (w^2 = 6 K/m),
/// and a leapfrog is stable below 2.
constexpr double largest_phase = 1.0;

/// Whether the steps of a method leave the restitution unchanged.
bool is_leapfrog(const DiscMethod& method) { return traits(method).amplitude_growth_rate == 0.0; }

/// Names of the leapfrog methods.
std::vector<std::string> leapfrogs() {
  std::vector<std::string> names = disc_method_names();
  std::erase_if(names, [](const std::string& name) { return !is_leapfrog(make_disc_method(name)); });
  return names;
}

}  // namespace

std::vector<CellError> validation_errors(const ShearCell& cell, const CellPlan& plan) {
  std::vector<CellError> found = validation_errors(cell);
  for (const auto& field : CellPlan::fields()) {
    if (!contains(field.range, plan.*field.member)) {
      found.push_back(
          {std::string{field.name}, fmt::format("found {}; it must be {}", plan.*field.member, text_of(field.range))});
    }
  }
  if (!found.empty()) return found;
  if (plan.step > plan.every) {
    found.push_back(
        {"step", fmt::format("found {}; it must be at most the time between outputs, {}", plan.step, plan.every)});
  }
  if (plan.every > plan.end) {
    found.push_back(
        {"every", fmt::format("found {}; it must be at most the time that the run takes, {}", plan.every, plan.end)});
  }
  if (plan.end > maximum_steps * plan.step) {
    found.push_back({"step", fmt::format("found {}; it must be at least {}: a run has at most {:g} steps", plan.step,
                                         plan.end / maximum_steps, maximum_steps)});
  }
  if (plan.outputs() > maximum_outputs) {
    found.push_back({"every", fmt::format("found {}; it must be at least {}: a run has at most {:g} outputs",
                                          plan.every, plan.end / maximum_outputs, maximum_outputs)});
  }
  constexpr std::string_view law_of_1989 = "latching springs that do not grow stiffer, without friction";
  if (plan.images == Images::virtual_discs) {
    const std::size_t discs = cell.free_discs() + 2 * static_cast<std::size_t>(cell.wall_discs);
    if (plan.jump) found.push_back({"jump", "found on; it requires images = \"nearest\", not virtual discs"});
    if (discs > CellPlan::maximum_virtual) {
      found.push_back({"images", fmt::format("found virtual with {} discs, of which all pairs are tried at each step; "
                                             "with more than {} it must be nearest",
                                             discs, CellPlan::maximum_virtual)});
    }
  }
  if (plan.historical && cell.law_of_1989() == nullptr)
    found.push_back({"historical", fmt::format("found on; a historical run is of {}", law_of_1989)});
  const DiscMethod method = make_disc_method(plan.integrator);
  if (!is_leapfrog(method) && cell.law_of_1989() == nullptr) {
    found.push_back({"integrator", fmt::format("found {}; its error of the restitution is known only for {}; "
                                               "with other laws it must be a leapfrog: {}",
                                               plan.integrator, law_of_1989, fmt::join(leapfrogs(), ", "))});
    return found;
  }
  const double steps = cell.contact_time() / plan.step;
  if (is_leapfrog(method) && steps < 10.0) {
    found.push_back(
        {"step", fmt::format("found {}; a contact lasts {:.4g}, and {} needs 10 steps of it: at most {:.4g}", plan.step,
                             cell.contact_time(), plan.integrator, cell.contact_time() / 10.0)});
  }
  if (cell.largest_stiffness() > cell.stiffness() && is_leapfrog(method)) {
    const double unloading_frequency = std::sqrt(2.0 * cell.largest_stiffness() / cell.mass);
    if (unloading_frequency * plan.step > largest_phase) {
      const std::string why =
          cell.is_linear() ? "contacts open so stiffly"
                           : fmt::format("at an overlap of {:.4g} contacts are so stiff", cell.nominal_overlap());
      found.push_back({"step", fmt::format("found {}; {} that {} needs a step of at most {:.4g}, 1/w2 = sqrt(M/(2 K2))",
                                           plan.step, why, plan.integrator, largest_phase / unloading_frequency)});
    }
  }
  if (cell.friction && is_leapfrog(method)) {
    // Two solid discs of radius r that stick: the slip rate changes by (2/m + 2 r^2/I) T = 6 T/m.
    const double sticking_frequency = std::sqrt(6.0 * cell.shear_stiffness() / cell.mass);
    if (sticking_frequency * plan.step > largest_phase) {
      found.push_back({"step", fmt::format("found {}; contacts that stick are so stiff along their surface that {} "
                                           "needs a step of at most {:.4g}, 1/w_s = sqrt(M/(6 k_s))",
                                           plan.step, plan.integrator, largest_phase / sticking_frequency)});
    }
  }
  const double stepped = stepped_restitution(method, cell.restitution(), cell.loading_frequency() * plan.step);
  if (!plan.historical && std::abs(stepped - cell.restitution()) > 0.05) {
    found.push_back(
        {"step",
         fmt::format("found {}; with it {} changes a restitution of {:.4g} to {:.4g}; outside a historical run it "
                     "may change by at most 0.05: take a smaller step, or a leapfrog",
                     plan.step, plan.integrator, cell.restitution(), stepped)});
  }
  return found;
}

}  // namespace talus
