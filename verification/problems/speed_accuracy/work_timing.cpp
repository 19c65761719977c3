#include "verification/problems/speed_accuracy/work_timing.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <numeric>
#include <random>
#include <stdexcept>

#include "solver/run/simulate.hpp"

namespace talus::verification::problems {
namespace {

constexpr int repetitions = 15;
/// A measurement is of so many runs that it takes at least this long: the clock's own cost is then below a thousandth.
constexpr double least_seconds = 1e-4;
constexpr double most_evaluations = 1e5;

/// One point of a curve, and its times.
struct Timed {
  const WorkCurve* curve{};
  const CurvePoint* point{};
  StepChoice steps{};
  int runs{1};
  std::vector<double> seconds{};  // of one run
};

/// One run; its first coordinate is returned so that nothing of it can be left out.
double run(const WorkScene& scene, const Dynamics& dynamics, const Timed& timed) {
  const bool by_tolerance = timed.steps == StepChoice::by_tolerance;
  const double span = scene.duration / static_cast<double>(scene.spans);
  const double steps = by_tolerance ? 1.0 : std::max(1.0, std::round(span / timed.point->setting));
  RigidBodySystem system{dynamics, false};
  State state = scene.scenes.front().initial;
  Integrator integrator = make_integrator(timed.curve->method, by_tolerance ? timed.point->setting : 0.0);
  const Outcome outcome = simulate(system, integrator, state, {span / steps, scene.duration, scene.duration, false});
  return outcome ? state.q[0] : 0.0;
}

double measured_seconds(const WorkScene& scene, const Dynamics& dynamics, const Timed& timed, double& sum) {
  const auto start = std::chrono::steady_clock::now();
  for (int i = 0; i < timed.runs; ++i)
    sum += run(scene, dynamics, timed);
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count() / timed.runs;
}

std::vector<Timed> to_be_timed(const SceneCurves& curves) {
  std::vector<Timed> found;
  for (std::size_t m = 0; m < curves.curves.size(); ++m) {
    for (const CurvePoint& point : curves.curves[m].points) {
      if (point.failed == 0 && point.evaluations <= most_evaluations)
        found.push_back({&curves.curves[m], &point, work_methods()[m].steps});
    }
  }
  return found;
}

std::string text(double number) { return fmt::format("{:.6g}", number); }

}  // namespace

std::vector<TimedPoint> timed_points(const SceneCurves& curves) {
  const WorkScene& scene = *curves.scene;
  const Dynamics dynamics{scene.scenes.front().model};
  std::vector<Timed> timed = to_be_timed(curves);
  double sum = 0.0;
  for (Timed& each : timed)
    each.runs = 1 + static_cast<int>(least_seconds / std::max(measured_seconds(scene, dynamics, each, sum), 1e-7));
  std::vector<std::size_t> order(timed.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::mt19937 random{1993};
  for (int repetition = 0; repetition < repetitions; ++repetition) {
    std::shuffle(order.begin(), order.end(), random);
    for (const std::size_t i : order)
      timed[i].seconds.push_back(measured_seconds(scene, dynamics, timed[i], sum));
  }
  if (!std::isfinite(sum)) throw std::runtime_error("a run that was timed did not come to its end");
  std::vector<TimedPoint> points;
  for (std::size_t q = 0; q < scene.quantities.size(); ++q) {
    for (Timed& each : timed) {
      std::sort(each.seconds.begin(), each.seconds.end());
      points.push_back({scene.name, scene.quantities[q], each.curve->method, each.point->rms[q],
                        1e9 * each.seconds[repetitions / 2], 1e9 * each.seconds.front(), 1e9 * each.seconds.back()});
    }
  }
  return points;
}

DataFile timing_data(const std::vector<TimedPoint>& points, const std::string& machine) {
  DataFile data{
      "work_and_time", {"scene", "quantity", "method", "error_rms", "ns_median", "ns_min", "ns_max", "machine"}, {}};
  const auto plain = [](std::string words) {
    std::replace(words.begin(), words.end(), ',', ';');
    return words;
  };
  for (const TimedPoint& point : points) {
    data.rows.push_back({plain(point.scene), plain(point.quantity), point.method, text(point.error), text(point.median),
                         text(point.fastest), text(point.slowest), plain(machine)});
  }
  return data;
}

std::vector<Figure> timing_figures(const DataFile& data, const std::string& machine) {
  std::vector<Figure> figures;
  std::string title;
  for (const auto& row : data.rows) {
    const std::string own = row[0] + ": " + row[1];
    if (own != title) {
      title = own;
      figures.push_back({.name = fmt::format("time_{}", figures.size() + 1),
                         .title = "Time, " + title,
                         .caption = fmt::format("Nanoseconds of a run against its relative error: median of {} "
                                                "interleaved, shuffled repetitions, bars from the fastest to the "
                                                "slowest. {}. Nothing is checked on times.",
                                                repetitions, machine),
                         .x = {.label = "error", .unit = "1", .log = true},
                         .y = {.label = "time of a run", .unit = "ns", .log = true}});
    }
    std::vector<Series>& series = figures.back().series;
    if (series.empty() || series.back().label != row[2]) series.push_back({.label = row[2], .style = Style::errorbars});
    series.back().x.push_back(std::stod(row[3]));
    series.back().y.push_back(std::stod(row[4]));
    series.back().y_low.push_back(std::stod(row[5]));
    series.back().y_high.push_back(std::stod(row[6]));
  }
  return figures;
}

}  // namespace talus::verification::problems
