#include "solver/stability/step_advice.hpp"

#include <fmt/format.h>

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "solver/base/error.hpp"
#include "solver/integrate/integrator_list.hpp"
#include "solver/stability/contact_range.hpp"

namespace talus {
namespace {

/// Names and contact laws of all springs in the order of springs(): contact instances, then cables, then friction.
struct SpringLabel {
  std::string name;
  const ContactLaw* law{};  ///< of a contact; null for cables and friction
};
std::vector<SpringLabel> spring_labels(const Dynamics& dynamics) {
  std::vector<SpringLabel> labels;
  for (std::size_t c = 0; c < dynamics.model().contacts.size(); ++c) {
    const std::size_t instances = dynamics.layout().contact_instances[c];
    const Contact& contact = dynamics.model().contacts[c];
    for (std::size_t i = 0; i < instances; ++i) {
      labels.push_back({instances == 1 ? contact.name : fmt::format("{}#{}", contact.name, i + 1), &contact.law});
    }
  }
  for (const Cable& cable : dynamics.model().cables)
    labels.push_back({cable.name, nullptr});
  for (std::size_t c = 0; c < dynamics.model().contacts.size(); ++c) {
    const Contact& contact = dynamics.model().contacts[c];
    if (contact.friction)
      labels.insert(labels.end(), dynamics.layout().contact_instances[c], {contact.name + " friction", nullptr});
  }
  return labels;
}

/// Duration of an impact on this spring [T]; for a cable half its period. Infinite for a spring that no motion
/// stretches (a cable that runs straight across its bodies' path): it has no frequency.
double duration(const SpringLabel& label, const Spring& spring) {
  if (!std::isfinite(spring.effective_mass)) return std::numeric_limits<double>::infinity();
  if (label.law) return contact_time(*label.law, spring.effective_mass);
  return std::numbers::pi * std::sqrt(spring.effective_mass / spring.stiffness);
}

}  // namespace

std::vector<NaturalMode> natural_modes(const Dynamics& dynamics, const std::vector<Spring>& springs) {
  std::vector<NaturalMode> modes;
  const auto n = static_cast<Eigen::Index>(dynamics.inertias().size());
  if (n == 0 || springs.empty()) return modes;
  Eigen::MatrixXd stiffness = Eigen::MatrixXd::Zero(n, n);
  // Without a dashpot no shape is needed; the frequencies have the same bits.
  const bool damped = std::ranges::any_of(springs, [](const Spring& spring) { return spring.damping != 0.0; });
  Eigen::MatrixXd damping = damped ? Eigen::MatrixXd::Zero(n, n) : Eigen::MatrixXd{};
  Eigen::VectorXd g(n);
  std::vector<Eigen::Index> touched;
  for (const Spring& spring : springs) {
    // Scaled by 1/sqrt(inertia), g turns K and C into the symmetric matrices of mass-normalised coordinates.
    touched.clear();
    for (Eigen::Index i = 0; i < n; ++i) {
      const auto coordinate = static_cast<std::size_t>(i);
      if (spring.gradient[coordinate] == 0.0) continue;
      g[i] = spring.gradient[coordinate] / std::sqrt(dynamics.inertias()[coordinate]);
      touched.push_back(i);
    }
    for (const Eigen::Index i : touched) {
      for (const Eigen::Index j : touched) {
        stiffness(i, j) += spring.stiffness * g[i] * g[j];
        if (damped) damping(i, j) += spring.damping * g[i] * g[j];
      }
    }
  }
  const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> solved{
      stiffness, damped ? Eigen::ComputeEigenvectors : Eigen::EigenvaluesOnly};
  const double negligible = 1e-12 * std::max(0.0, solved.eigenvalues()[n - 1]);
  for (Eigen::Index i = 0; i < n; ++i) {
    if (solved.eigenvalues()[i] <= negligible) continue;  // no spring is stretched
    const double frequency = std::sqrt(solved.eigenvalues()[i]);
    modes.push_back({frequency, 0.0});
    if (!damped) continue;
    const Eigen::VectorXd shape = solved.eigenvectors().col(i);
    modes.back().damping_ratio = shape.dot(damping * shape) / (2.0 * frequency);
  }
  return modes;
}

StepAdvice advise_step(const Dynamics& dynamics, const State& state) {
  StepAdvice advice;
  advice.shortest_contact = std::numeric_limits<double>::infinity();
  const std::vector<SpringLabel> labels = spring_labels(dynamics);
  std::vector<Spring> found = springs(dynamics, state);
  advice.modes = natural_modes(dynamics, found);
  for (std::size_t s = 0; s < found.size(); ++s) {
    Spring& spring = found[s];
    const bool contact = labels[s].law != nullptr;
    const double frequency = std::sqrt(spring.stiffness / spring.effective_mass);
    const double ratio = spring.damping / (2.0 * std::sqrt(spring.stiffness * spring.effective_mass));
    const double time = duration(labels[s], spring);
    if (contact) advice.shortest_contact = std::min(advice.shortest_contact, time);
    advice.springs.push_back({labels[s].name, contact, std::move(spring), frequency, ratio, time});
  }
  return advice;
}

std::optional<StepLimit> step_limit(const std::vector<NaturalMode>& modes, std::string_view integrator) {
  std::optional<StepLimit> first;
  const auto limit = integrator_traits(integrator).linear_limit;
  if (!limit) return first;
  for (const NaturalMode& mode : modes) {
    const double product = limit(mode.damping_ratio), step = product / mode.frequency;
    if (!first || step < first->step) first = StepLimit{mode, product, step};
  }
  return first;
}

std::optional<StepVerdict> step_verdict(const Scene& scene, const StepAdvice& advice) {
  if (chooses_steps(scene.integrator)) return std::nullopt;
  const auto limit = step_limit(advice.modes, name(scene.integrator));
  if (!limit) return std::nullopt;
  const double product = scene.plan.step * limit->mode.frequency;
  const bool is_beyond = product > limit->product;
  return StepVerdict{
      is_beyond,
      fmt::format("h omega = {:.4g} {} {:.4g}, the linear limit of {} for the mode of {:.4g} rad a unit of time, xi "
                  "{:.3g}",
                  product, is_beyond ? ">" : "<", limit->product, name(scene.integrator), limit->mode.frequency,
                  limit->mode.damping_ratio)};
}

std::string output_warning(const Scene& scene, const Dynamics& dynamics) {
  constexpr double fewest_outputs = 2.0;  // of a half sine they miss up to 1 - cos(pi/4) of the maximum
  if (!chooses_steps(scene.integrator) || scene.initial.q.size() > maximum_watched_coordinates) return "";
  const StepAdvice advice = advise_step(dynamics, scene.initial);
  if (!(advice.shortest_contact < fewest_outputs * scene.plan.step)) return "";
  const auto shortest = std::ranges::min_element(advice.springs, {}, [](const SpringAdvice& of) {
    return of.contact ? of.contact_time : std::numeric_limits<double>::infinity();
  });
  return fmt::format(
      "contact '{}' lasts about {:.3g}, {:.2g} steps of the scene: {} takes shorter ones itself, but largest overlaps "
      "and forces are those at the steps of the scene, and may be too small; a step of {:.3g} gives it 20",
      shortest->name, shortest->contact_time, shortest->contact_time / scene.plan.step, name(scene.integrator),
      shortest->contact_time / 20.0);
}

double automatic_step(const Scene& scene) {
  const Dynamics dynamics{scene.model};
  const StepAdvice advice = advise_step(dynamics, scene.initial);
  double step = advice.shortest_contact / 200.0;
  if (const auto limit = step_limit(advice.modes, name(scene.integrator))) step = std::min(step, limit->step / 20.0);
  if (step == 0.0) {
    throw InputError{
        fmt::format("step: found \"auto\"; {} grows at any step, since this scene vibrates without a dashpot; choose "
                    "another method",
                    name(scene.integrator))};
  }
  if (std::isfinite(step)) return step;
  throw InputError{fmt::format(
      "step: found \"auto\"; no contact limits the steps of this scene and {} has no limit in closed form; give one",
      name(scene.integrator))};
}

double output_step(const Scene& scene) {
  constexpr double rows = 1000.0, maximum_per_row = 1000.0;
  constexpr double outputs_per_contact = 20.0;      // the peak of half a sine is missed by at most (pi/40)^2/2
  constexpr std::size_t maximum_coordinates = 150;  // the springs of a scene cost n^2
  double shortest = std::numeric_limits<double>::infinity();
  if (scene.initial.q.size() <= maximum_coordinates) {
    const Dynamics dynamics{scene.model};
    for (const SpringAdvice& spring : advise_step(dynamics, scene.initial).springs)
      shortest = std::min(shortest, spring.contact_time);
  }
  const double wanted = shortest > 0.0 ? std::ceil(outputs_per_contact * scene.plan.end / (rows * shortest)) : 1.0;
  return scene.plan.end / (rows * std::clamp(wanted, 1.0, maximum_per_row));
}

}  // namespace talus
