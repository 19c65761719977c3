#include "verification/problems/speed_accuracy/work_curves.hpp"

#include "solver/dynamics/closed_form.hpp"
#include "verification/study/toolkit.hpp"

namespace talus::verification::problems {
namespace {

constexpr double coarsest_tolerance = 1e-2, finest_tolerance = 0.99e-13;

/// Accumulates the root mean squares of the runs of a point.
class PointSum {
 public:
  PointSum(std::size_t quantities, int runs) : runs_{runs} {
    point_.rms.assign(quantities, 0.0);
    point_.max.assign(quantities, 0.0);
  }

  void add(const WorkRun& run, double setting) {
    point_.setting += setting / runs_;
    point_.evaluations += run.evaluations / runs_;
    bool failed = false;
    for (std::size_t q = 0; q < run.errors.size(); ++q) {
      point_.rms[q] += run.errors[q] * run.errors[q] / runs_;
      keep_worst(point_.max[q], run.errors[q]);
      failed = failed || !(run.errors[q] <= 1.0);
    }
    if (failed) ++point_.failed;
  }

  CurvePoint whole() const {
    CurvePoint point = point_;
    for (double& square : point.rms)
      square = std::sqrt(square);
    return point;
  }

 private:
  CurvePoint point_;
  int runs_;
};

/// True if the runs of a point have settings spread up to that of the next point, because they do not differ in phase.
bool spread(const WorkScene& scene) { return scene.runs > 1 && scene.scenes.size() == 1; }

/// Position of the run between its point (0) and the next (1).
double part(const WorkScene& scene, int run) { return spread(scene) ? static_cast<double>(run) / scene.runs : 0.0; }

CurvePoint by_length(const WorkScene& scene, const std::string& method, double steps, Findings& findings) {
  PointSum sum{scene.quantities.size(), scene.runs};
  for (int run = 0; run < scene.runs; ++run) {
    const long own = std::lround(steps * std::exp2(part(scene, run)));
    sum.add(scene.measure(make_integrator(method), own, run, findings),
            scene.duration / static_cast<double>(scene.spans * own));
  }
  return sum.whole();
}

CurvePoint by_tolerance(const WorkScene& scene, const std::string& method, double tolerance, Findings& findings) {
  PointSum sum{scene.quantities.size(), scene.runs};
  for (int run = 0; run < scene.runs; ++run) {
    const double own = tolerance * std::pow(scene.tolerance_ratio, part(scene, run));
    sum.add(scene.measure(make_integrator(method, own), 1, run, findings), own);
  }
  return sum.whole();
}

bool at_floor(const WorkScene& scene, const CurvePoint& point) {
  for (const double error : point.rms) {
    if (!(error < 10.0 * scene.floor)) return false;
  }
  return true;
}

}  // namespace

WorkCurve work_curve(const WorkScene& scene, const std::string& method, Findings& findings) {
  WorkCurve curve{method, {}};
  const bool closed_form = needs_closed_form(method), by_steps = !has_step_control(method);
  if (closed_form && obstacle_to_closed_form(scene.scenes.front().model)) return curve;
  double steps = 1.0, tolerance = coarsest_tolerance;
  double cost = 0.0;
  while (cost <= scene.budget && tolerance * (spread(scene) ? scene.tolerance_ratio : 1.0) >= finest_tolerance) {
    curve.points.push_back(by_steps ? by_length(scene, method, steps, findings)
                                    : by_tolerance(scene, method, tolerance, findings));
    const CurvePoint& last = curve.points.back();
    if (closed_form || at_floor(scene, last)) break;
    steps *= 2.0;
    if (!by_steps) tolerance *= scene.tolerance_ratio;
    cost = (by_steps ? 2.0 : 1.0) * last.evaluations * scene.runs;
  }
  return curve;
}

double cost_of(const WorkCurve& curve, std::size_t quantity, double error) {
  std::optional<std::size_t> first;
  for (std::size_t i = curve.points.size(); i-- > 0;) {
    if (curve.points[i].failed > 0 || !(curve.points[i].rms[quantity] <= error)) break;
    first = i;
  }
  if (!first) return std::numeric_limits<double>::infinity();
  const CurvePoint& reached = curve.points[*first];
  if (*first == 0 || curve.points[*first - 1].failed > 0) return reached.evaluations;
  const CurvePoint& before = curve.points[*first - 1];
  const double fraction =
      std::log(before.rms[quantity] / error) / std::log(before.rms[quantity] / reached.rms[quantity]);
  return before.evaluations * std::pow(reached.evaluations / before.evaluations, fraction);
}

Convergence between_errors(const WorkCurve& curve, std::size_t quantity, double minimum, double maximum) {
  Convergence found;
  for (const CurvePoint& point : curve.points) {
    const double error = point.rms[quantity];
    if (point.failed == 0 && error >= minimum && error <= maximum) found.add(1.0 / point.evaluations, error);
  }
  return found;
}

}  // namespace talus::verification::problems
