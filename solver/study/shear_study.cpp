#include "solver/study/shear_study.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <atomic>
#include <boost/math/distributions/students_t.hpp>
#include <cmath>
#include <optional>

#include "solver/base/error.hpp"
#include "solver/cell/cell_run.hpp"
#include "solver/threads/parallel_for.hpp"

namespace talus {
namespace {

using Q = StudyQuantity;
using Numbers = std::array<double, study_quantities>;

constexpr double steps_in_contact = 20.0;
constexpr int outputs = 40;

CellPlan plan_of(const ShearCell& cell, double time) {
  CellPlan plan;
  plan.step = cell.contact_time() / steps_in_contact;
  plan.end = time, plan.every = time / outputs;
  return plan;
}

/// Performs a run of the study; empty if it failed. `stepped` receives the number of steps since the last output.
template <class Stepped>
std::optional<StudyMean::Run> run_of(const StudyPoint& point, std::uint64_t seed, double time, Stepped&& stepped) {
  const ShearCell cell = study_cell(point, seed);
  CellRun run{cell, plan_of(cell, time)};
  double order = 0.0;
  int seen = 0;
  long reported = 0;
  while (!run.finished() && run.failure().empty()) {
    run.advance();
    if (!run.due()) continue;
    stepped(run.steps() - reported);
    reported = run.steps();
    if (run.steps() * static_cast<long>(CellRun::blocks) < run.last_step() * static_cast<long>(CellRun::start_up))
      continue;
    order += sixfold_order(cell, run.start(), run.discs());
    ++seen;
  }
  if (!run.failure().empty()) return {};
  using C = CellQuantity;
  const auto mean = [&](C quantity) { return run.mean(quantity).value; };
  const auto ratio = [](double part, double whole) { return whole != 0.0 ? part / whole : 0.0; };
  Numbers of{};
  const auto set = [&](Q quantity, double value) { of[static_cast<std::size_t>(quantity)] = value; };
  const double all_shear = mean(C::shear_virial), all_normal = mean(C::normal_virial);
  const double shear = mean(C::multiple_shear_virial), normal = mean(C::multiple_normal_virial);
  set(Q::stress_ratio, ratio(mean(C::top_shear), mean(C::top_normal)));
  set(Q::depth, mean(C::depth) / cell.diameter);
  set(Q::touching, mean(C::touching));
  set(Q::multiple_fraction, ratio(mean(C::multiple), mean(C::contacts)));
  set(Q::multiple_shear_fraction, ratio(shear, all_shear));
  set(Q::multiple_stress_ratio, ratio(shear, normal));
  set(Q::binary_stress_ratio, ratio(all_shear - shear, all_normal - normal));
  set(Q::order, order / seen);
  set(Q::inertial_number,
      cell.block_speed / mean(C::depth) * cell.diameter * std::sqrt(cell.density() / cell.overburden()));
  set(Q::largest_overlap, run.largest_overlap() / cell.diameter);
  return StudyMean::Run{seed, of};
}

void average(StudyMean& point) {
  point.seeds = static_cast<int>(point.runs.size());
  if (point.runs.empty()) return;
  const auto count = static_cast<double>(point.runs.size());
  for (std::size_t k = 0; k < study_quantities; ++k) {
    double sum = 0.0, squares = 0.0;
    for (const StudyMean::Run& run : point.runs)
      sum += run.numbers[k];
    const double mean = sum / count;
    for (const StudyMean::Run& run : point.runs)
      squares += (run.numbers[k] - mean) * (run.numbers[k] - mean);
    point.mean[k] = {mean, count > 1.0 ? std::sqrt(squares / (count - 1.0) / count) : 0.0};
  }
}

/// The points of a series with at least two successful runs, up to a load, by increasing overburden.
std::vector<const StudyMean*> loads(const std::vector<StudyMean>& study, std::string_view series, double maximum) {
  std::vector<const StudyMean*> found;
  for (const StudyMean& point : study)
    if (point.point.series == series && point.seeds > 1 && point.point.overburden <= maximum) found.push_back(&point);
  if (found.size() < 2)
    throw InputError{fmt::format("study: found {} loads of the series {} that ran; it must have two at least",
                                 found.size(), series)};
  std::sort(found.begin(), found.end(),
            [](const auto* a, const auto* b) { return a->point.overburden < b->point.overburden; });
  return found;
}

/// Difference of two means over few seeds, with its significance.
struct Difference {
  double value{}, error{};
  double freedom{};  ///< degrees of freedom
  double t() const { return error > 0.0 ? value / error : 0.0; }
  double chance() const {
    if (!(error > 0.0)) return 1.0;
    const boost::math::students_t distribution{freedom};
    return 2.0 * boost::math::cdf(boost::math::complement(distribution, std::abs(t())));
  }
};
Difference difference(const StudyMean& later, const StudyMean& earlier, Q quantity) {
  const Estimate a = later.of(quantity), b = earlier.of(quantity);
  const double va = a.error * a.error, vb = b.error * b.error;
  // Welch-Satterthwaite.
  const double freedom = (va + vb) * (va + vb) / (va * va / (later.seeds - 1) + vb * vb / (earlier.seeds - 1));
  return {a.value - b.value, std::sqrt(va + vb), std::max(1.0, freedom)};
}

/// Verdict on a difference whose predicted sign is given.
Verdict verdict(std::string prediction, std::string measured, const Difference& found, double sign) {
  const Outturn outturn = !(found.chance() < 0.01)   ? Outturn::not_shown
                          : sign * found.value > 0.0 ? Outturn::holds
                                                     : Outturn::opposed;
  return {std::move(prediction), std::move(measured), found.t(), found.chance(), outturn};
}

/// Softest and hardest point of the series "stiffness" with at least two successful runs; null if there is none.
std::pair<const StudyMean*, const StudyMean*> softest_and_hardest(const std::vector<StudyMean>& study) {
  const StudyMean *soft = nullptr, *hard = nullptr;
  for (const StudyMean& point : study) {
    if (point.point.series != "stiffness" || point.seeds < 2) continue;
    if (soft == nullptr || point.point.stiffness < soft->point.stiffness) soft = &point;
    if (hard == nullptr || point.point.stiffness > hard->point.stiffness) hard = &point;
  }
  return {soft, hard};
}

std::string text_of(Estimate estimate) { return fmt::format("{:.3f} +- {:.3f}", estimate.value, estimate.error); }

Verdict falls(const std::vector<StudyMean>& study, std::string_view series, std::string prediction) {
  const auto of = loads(study, series, 32e3);
  const Estimate first = of.front()->of(Q::stress_ratio), last = of.back()->of(Q::stress_ratio);
  return verdict(
      std::move(prediction),
      fmt::format("S/N {} at {:.0f} kPa, {} at {:.0f} kPa, {}", text_of(first), of.front()->point.overburden / 1e3,
                  text_of(last), of.back()->point.overburden / 1e3, series),
      difference(*of.back(), *of.front(), Q::stress_ratio), -1.0);
}

}  // namespace

std::string_view text_of(Outturn outturn) {
  switch (outturn) {
    case Outturn::holds:
      return "holds";
    case Outturn::opposed:
      return "does not hold: the opposite does";
    default:
      return "is not shown";
  }
}

ShearCell study_cell(const StudyPoint& point, std::uint64_t seed) {
  ShearCell cell = ice_cell(point.overburden, point.speed, seed);
  auto& law = std::get<LatchingSpring>(cell.law);
  law.stiffness *= point.stiffness, law.unloading_stiffness *= point.stiffness;
  return cell;
}

std::vector<StudyPoint> shear_study_points(bool coarse) {
  std::vector<StudyPoint> points;
  const auto add = [&](std::string series, double kilopascals, double speed, double stiffness) {
    points.push_back({std::move(series), 1e3 * kilopascals, speed, stiffness});
  };
  const std::vector<double> loads = coarse ? std::vector{2.0, 32.0} : std::vector{2.0, 4.0, 8.0, 15.0, 32.0, 64.0};
  const std::vector<double> speeds =
      coarse ? std::vector{1000.0, 5000.0} : std::vector{1000.0, 2000.0, 5000.0, 10000.0, 15000.0};
  for (const double load : loads)
    add("5000 d/s", load, 5000.0, 1.0);
  for (const double load : loads)
    if (load <= 32.0) add("1000 d/s", load, 1000.0, 1.0);
  for (const double load : {2.0, 15.0, 32.0})
    for (const double speed : speeds)
      add(fmt::format("{:.0f} kPa", load), load, speed, 1.0);
  for (const double stiffness : coarse ? std::vector{1.0} : std::vector{0.25, 1.0, 4.0})
    add("stiffness", 15.0, 5000.0, stiffness);
  return points;
}

std::vector<StudyMean> shear_study(const std::vector<StudyPoint>& points, const StudyPlan& plan) {
  const auto seeds = static_cast<std::size_t>(plan.seeds);
  // A cell that occurs in several series is run once.
  std::vector<std::size_t> of_point(points.size());
  std::vector<const StudyPoint*> cells;
  for (std::size_t p = 0; p < points.size(); ++p) {
    const auto same = std::find_if(cells.begin(), cells.end(), [&](const StudyPoint* cell) {
      return cell->overburden == points[p].overburden && cell->speed == points[p].speed &&
             cell->stiffness == points[p].stiffness;
    });
    of_point[p] = static_cast<std::size_t>(same - cells.begin());
    if (same == cells.end()) cells.push_back(&points[p]);
  }
  for (const StudyPoint* point : cells) {
    const ShearCell cell = study_cell(*point, 1);
    if (const auto found = validation_errors(cell, plan_of(cell, plan.time)); !found.empty())
      throw InputError{fmt::format("{}: {}", found.front().field, found.front().message)};
  }
  std::vector<std::optional<StudyMean::Run>> runs(cells.size() * seeds);
  double all_steps = 0.0;
  for (const StudyPoint* point : cells) {
    const CellPlan cell_plan = plan_of(study_cell(*point, 1), plan.time);
    all_steps += cell_plan.end / cell_plan.step * static_cast<double>(seeds);
  }
  std::atomic<std::size_t> done{0};
  std::atomic<long> steps{0};
  parallel_for(runs.size(), plan.threads, [&](std::size_t k) {
    runs[k] = run_of(*cells[k / seeds], k % seeds + 1, plan.time, [&](long more) {
      const long taken = steps += more;
      if (plan.progress) plan.progress({done, runs.size(), std::min(static_cast<double>(taken) / all_steps, 1.0)});
    });
    ++done;
  });
  std::vector<StudyMean> study;
  for (std::size_t p = 0; p < points.size(); ++p) {
    StudyMean point{.point = points[p], .seeds = 0, .runs = {}};
    for (std::size_t s = 0; s < seeds; ++s)
      if (const auto& run = runs[of_point[p] * seeds + s]) point.runs.push_back(*run);
    average(point);
    study.push_back(std::move(point));
  }
  return study;
}

std::vector<Verdict> verdicts(const std::vector<StudyMean>& study) {
  const auto of = loads(study, "5000 d/s", 32e3);
  const StudyMean &low = *of.front(), &high = *of.back();
  std::vector<Verdict> made;
  made.push_back(
      verdict("1. The field compresses as overburden is added.",
              fmt::format("depth {} D at {:.0f} kPa, {} D at {:.0f} kPa", text_of(low.of(Q::depth)),
                          low.point.overburden / 1e3, text_of(high.of(Q::depth)), high.point.overburden / 1e3),
              difference(high, low, Q::depth), -1.0));
  made.push_back(verdict("2. Multiple contacts form as it does.",
                         fmt::format("their fraction of contact time {} and {}", text_of(low.of(Q::multiple_fraction)),
                                     text_of(high.of(Q::multiple_fraction))),
                         difference(high, low, Q::multiple_fraction), 1.0));
  // The difference between the two ratios is taken within each run, because their errors are from the same flow.
  double sum = 0.0, squares = 0.0, count = 0.0;
  for (const StudyMean* point : of) {
    for (const StudyMean::Run& run : point->runs) {
      const double apart = run.numbers[static_cast<std::size_t>(Q::multiple_stress_ratio)] -
                           run.numbers[static_cast<std::size_t>(Q::binary_stress_ratio)];
      sum += apart, squares += apart * apart, count += 1.0;
    }
  }
  const double mean = sum / count, error = std::sqrt((squares / count - mean * mean) / (count - 1.0));
  made.push_back(verdict("3. They carry a lower ratio of shear to normal stress than binary ones.",
                         fmt::format("lower by {:.4f} +- {:.4f}, mean of {:.0f} runs", -mean, error, count),
                         Difference{mean, error, count - 1.0}, -1.0));
  made.push_back(falls(study, "5000 d/s", "4. They form often enough to lower the ratio as a whole."));
  made.push_back(falls(study, "1000 d/s", "The same at a fifth of the speed."));
  if (const auto [soft, hard] = softest_and_hardest(study); soft != nullptr && soft != hard) {
    made.push_back(verdict(
        "Softer discs under the same load and drive, whose contacts are multiple more often, carry a lower ratio.",
        fmt::format("S/N {} at {:g} times the stiffness, fraction of multiple contacts {}; {} and {} at {:g} times",
                    text_of(soft->of(Q::stress_ratio)), soft->point.stiffness, text_of(soft->of(Q::multiple_fraction)),
                    text_of(hard->of(Q::stress_ratio)), text_of(hard->of(Q::multiple_fraction)), hard->point.stiffness),
        difference(*soft, *hard, Q::stress_ratio), -1.0));
  }
  return made;
}

}  // namespace talus
