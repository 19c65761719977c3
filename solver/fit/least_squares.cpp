#include "solver/fit/least_squares.hpp"

#include <fmt/format.h>
#include <nlopt.h>

#include <Eigen/Dense>
#include <algorithm>
#include <boost/math/distributions/normal.hpp>
#include <boost/math/distributions/students_t.hpp>
#include <cmath>
#include <exception>
#include <memory>
#include <numeric>
#include <random>
#include <utility>

#include "solver/base/error.hpp"

namespace talus {
namespace {

using Vector = Eigen::VectorXd;
using Matrix = Eigen::MatrixXd;

/// The problem in coordinates from 0 to 1.
class UnitProblem {
 public:
  UnitProblem(const std::vector<FitParameter>& parameters, const FitModel& model, std::size_t rows)
      : parameters_{&parameters}, model_{&model}, all_(rows) {
    std::iota(all_.begin(), all_.end(), std::size_t{0});
  }

  std::size_t size() const { return parameters_->size(); }
  const std::vector<std::size_t>& all_rows() const { return all_; }
  std::size_t evaluations() const { return evaluations_; }

  double coordinate(std::size_t i) const {
    const FitParameter& p = (*parameters_)[i];
    return p.spacing == Spacing::logarithmic ? std::log(p.start / p.lower) / std::log(p.upper / p.lower)
                                             : (p.start - p.lower) / (p.upper - p.lower);
  }
  std::vector<double> values(const Vector& u) const {
    std::vector<double> found(size());
    for (std::size_t i = 0; i < size(); ++i) {
      const FitParameter& p = (*parameters_)[i];
      const double at = std::clamp(u[static_cast<Eigen::Index>(i)], 0.0, 1.0);
      // The ends themselves, without rounding.
      if (at == 0.0 || at == 1.0) {
        found[i] = at == 0.0 ? p.lower : p.upper;
      } else {
        found[i] = p.spacing == Spacing::logarithmic ? p.lower * std::pow(p.upper / p.lower, at)
                                                     : std::lerp(p.lower, p.upper, at);
      }
    }
    return found;
  }
  /// Change of a value over that of its coordinate.
  double slope(std::size_t i, double value) const {
    const FitParameter& p = (*parameters_)[i];
    return p.spacing == Spacing::logarithmic ? value * std::log(p.upper / p.lower) : p.upper - p.lower;
  }

  Vector deviations(const Vector& u, const std::vector<std::size_t>& rows) {
    evaluations_ += rows.size();
    const std::vector<double> found = (*model_)(values(u), rows);
    return Eigen::Map<const Vector>(found.data(), static_cast<Eigen::Index>(found.size()));
  }

 private:
  const std::vector<FitParameter>* parameters_;
  const FitModel* model_;
  std::vector<std::size_t> all_;
  std::size_t evaluations_{};
};

/// Larger than every sum of a model that has results, and finite, so that a search continues.
constexpr double no_result = 1e100;

double sum_of(const Vector& deviations) {
  const double sum = deviations.squaredNorm();
  return std::isfinite(sum) ? sum : no_result;
}

Vector clamped(const Vector& u) { return u.cwiseMax(0.0).cwiseMin(1.0); }

/// Derivatives of the deviations by differences of the width `widths[i]`, one-sided at a bound.
Matrix jacobian(UnitProblem& problem, const Vector& u, const Vector& at, const Vector& widths) {
  Matrix found(at.size(), u.size());
  for (Eigen::Index i = 0; i < u.size(); ++i) {
    Vector below = u, above = u;
    below[i] = std::max(0.0, u[i] - widths[i]);
    above[i] = std::min(1.0, u[i] + widths[i]);
    const Vector low = below[i] == u[i] ? at : problem.deviations(below, problem.all_rows());
    const Vector high = above[i] == u[i] ? at : problem.deviations(above, problem.all_rows());
    found.col(i) = (high - low) / (above[i] - below[i]);
  }
  return found;
}

/// The step of Gauss and Newton, without the coordinates that it would carry through a bound.
Vector gauss_newton(const Matrix& jacobian, const Vector& deviations, const Vector& u) {
  std::vector<Eigen::Index> moving(static_cast<std::size_t>(u.size()));
  std::iota(moving.begin(), moving.end(), Eigen::Index{0});
  Vector step = Vector::Zero(u.size());
  while (!moving.empty()) {
    Matrix part(jacobian.rows(), static_cast<Eigen::Index>(moving.size()));
    for (std::size_t k = 0; k < moving.size(); ++k)
      part.col(static_cast<Eigen::Index>(k)) = jacobian.col(moving[k]);
    const Vector found = part.colPivHouseholderQr().solve(-deviations);
    step.setZero();
    for (std::size_t k = 0; k < moving.size(); ++k)
      step[moving[k]] = found[static_cast<Eigen::Index>(k)];
    const auto leaves = [&](Eigen::Index i) {
      return (u[i] == 0.0 && step[i] < 0.0) || (u[i] == 1.0 && step[i] > 0.0);
    };
    if (std::erase_if(moving, leaves) == 0) break;
  }
  return moving.empty() ? Vector::Zero(u.size()) : step;
}

/// Rows of data with the number of times that each counts.
struct Sample {
  std::vector<std::size_t> rows;
  std::vector<double> counts;
};

/// The deviations of a sample, or their derivatives, each times the root of its count.
Matrix weighted(Matrix of_sample, const Sample& sample) {
  const Eigen::Index width = of_sample.rows() / static_cast<Eigen::Index>(sample.rows.size());
  for (std::size_t k = 0; k < sample.rows.size(); ++k)
    of_sample.middleRows(static_cast<Eigen::Index>(k) * width, width) *= std::sqrt(sample.counts[k]);
  return of_sample;
}

/// The part of a sample in the deviations of all `rows`, or in their derivatives.
Matrix part_of(const Matrix& all, std::size_t rows, const Sample& sample) {
  const Eigen::Index width = all.rows() / static_cast<Eigen::Index>(rows);
  Matrix found(static_cast<Eigen::Index>(sample.rows.size()) * width, all.cols());
  for (std::size_t k = 0; k < sample.rows.size(); ++k)
    found.middleRows(static_cast<Eigen::Index>(k) * width, width) =
        all.middleRows(static_cast<Eigen::Index>(sample.rows[k]) * width, width);
  return found;
}

/// The search as NLopt calls it. An exception must not leave its C code: it ends the search and is kept.
struct Objective {
  UnitProblem* problem{};
  const Sample* sample{};
  nlopt_opt search{};
  std::exception_ptr error{};

  static double value(unsigned count, const double* at, double* /*gradient*/, void* data) {
    auto& of = *static_cast<Objective*>(data);
    try {
      const Vector u = Eigen::Map<const Vector>(at, static_cast<Eigen::Index>(count));
      return sum_of(weighted(of.problem->deviations(u, of.sample->rows), *of.sample));
    } catch (...) {
      of.error = std::current_exception();
      nlopt_force_stop(of.search);
      return no_result;
    }
  }
};

struct Searched {
  Vector u;
  double sum{};
  bool is_limited{};  ///< it ended at its limit of evaluations
};

/// A search of NLopt within the unit cube. `configure` sets when it ends, besides a number of evaluations.
template <class Configure>
Searched searched(UnitProblem& problem, const Sample& sample, nlopt_algorithm algorithm, Vector start, int evaluations,
                  Configure&& configure) {
  const std::unique_ptr<nlopt_opt_s, decltype(&nlopt_destroy)> search{
      nlopt_create(algorithm, static_cast<unsigned>(problem.size())), &nlopt_destroy};
  Objective objective{&problem, &sample, search.get()};
  nlopt_set_min_objective(search.get(), &Objective::value, &objective);
  nlopt_set_lower_bounds1(search.get(), 0.0);
  nlopt_set_upper_bounds1(search.get(), 1.0);
  nlopt_set_maxeval(search.get(), evaluations);
  configure(search.get());
  Searched found{std::move(start)};
  const nlopt_result end = nlopt_optimize(search.get(), found.u.data(), &found.sum);
  if (objective.error) std::rethrow_exception(objective.error);
  TALUS_DEMAND(end != NLOPT_INVALID_ARGS && end != NLOPT_OUT_OF_MEMORY);
  found.u = clamped(found.u), found.is_limited = end == NLOPT_MAXEVAL_REACHED;
  return found;
}

Searched local_search(UnitProblem& problem, const Sample& sample, const Vector& start, const FitRules& rules) {
  return searched(problem, sample, NLOPT_LN_SBPLX, start, rules.maximum_searches, [](nlopt_opt search) {
    nlopt_set_initial_step1(search, 0.1);
    nlopt_set_xtol_abs1(search, 1e-6);
    nlopt_set_ftol_rel(search, 1e-10);
  });
}

/// The end of a local search from the best point that a search of the whole range finds, or from the start if that is
/// better.
Vector best_search(UnitProblem& problem, const Sample& all, const FitRules& rules) {
  Vector start(static_cast<Eigen::Index>(problem.size()));
  for (std::size_t i = 0; i < problem.size(); ++i)
    start[static_cast<Eigen::Index>(i)] = problem.coordinate(i);
  const double start_sum = sum_of(problem.deviations(start, problem.all_rows()));
  const int evaluations = rules.global_searches * static_cast<int>(problem.size());
  const Searched best = searched(problem, all, NLOPT_GN_DIRECT_L, start, evaluations, [](nlopt_opt) {});
  if (std::min(best.sum, start_sum) >= no_result)
    throw InputError{"no values of the parameters were found with which all rows have a result; give other ranges"};
  return local_search(problem, all, start_sum < best.sum ? start : best.u, rules).u;
}

/// Standard errors in coordinates, and the correlation.
struct Spread {
  Vector errors;
  Matrix correlation;
};

Spread spread_of(const Matrix& jacobian, double variance) {
  const Eigen::Index count = jacobian.cols();
  // Directions of which the deviations do not depend have an error that exceeds every range.
  const Eigen::JacobiSVD<Matrix> parts{jacobian, Eigen::ComputeThinV};
  const Vector& singular = parts.singularValues();
  Matrix covariance = Matrix::Zero(count, count);
  for (Eigen::Index k = 0; k < singular.size(); ++k) {
    const bool has_effect = singular[k] > 1e-12 * singular[0];
    const double deviation = has_effect ? std::min(1e3, std::sqrt(variance) / singular[k]) : 1e3;
    covariance += deviation * deviation * parts.matrixV().col(k) * parts.matrixV().col(k).transpose();
  }
  Spread spread{covariance.diagonal().cwiseSqrt(), Matrix::Identity(count, count)};
  for (Eigen::Index i = 0; i < count; ++i)
    for (Eigen::Index j = 0; j < count; ++j)
      if (i != j && spread.errors[i] > 0.0 && spread.errors[j] > 0.0)
        spread.correlation(i, j) = covariance(i, j) / (spread.errors[i] * spread.errors[j]);
  return spread;
}

/// A sample of as many rows, drawn with replacement.
Sample drawn_sample(std::mt19937_64& generator, std::size_t rows) {
  std::vector<double> counts(rows);
  for (std::size_t i = 0; i < rows; ++i)  // standard distributions differ between libraries
    ++counts[static_cast<std::size_t>(static_cast<double>(generator() >> 11U) * 0x1p-53 * static_cast<double>(rows))];
  Sample sample;
  for (std::size_t row = 0; row < rows; ++row) {
    if (counts[row] == 0.0) continue;
    sample.rows.push_back(row);
    sample.counts.push_back(counts[row]);
  }
  return sample;
}

/// The fit of a sample: steps with the derivatives of the whole fit, and a search if they do not converge. `at_start`:
/// the deviations of all rows where the whole fit ends.
std::pair<Vector, bool> sample_fit(UnitProblem& problem, const Vector& start, const Vector& at_start,
                                   const Matrix& slopes, const Vector& errors, const Sample& sample,
                                   const FitRules& rules) {
  const Matrix of_sample = weighted(part_of(slopes, rules.rows, sample), sample);
  Vector u = start, deviations = weighted(part_of(at_start, rules.rows, sample), sample);
  constexpr int maximum_steps = 12;
  for (int step = 0; step < maximum_steps; ++step) {
    if (step > 0) deviations = weighted(problem.deviations(u, sample.rows), sample);
    if (!deviations.allFinite()) break;
    const Vector next = clamped(u + gauss_newton(of_sample, deviations, u));
    const double change = (next - u).cwiseQuotient(errors.cwiseMax(1e-12)).cwiseAbs().maxCoeff();
    u = next;
    if (change < 0.02) return {u, false};
  }
  const Searched end = local_search(problem, sample, start, rules);
  return {end.u, end.is_limited};
}

/// Cumulative probability of the lower end of an interval of 95 %, widened for few rows (Hesterberg 2015, section 5).
double lower_probability(const FitRules& rules, std::size_t parameters) {
  const double rows = static_cast<double>(rules.rows), freedom = rows - static_cast<double>(parameters);
  if (freedom < 1.0) return 0.0;
  const double t = boost::math::quantile(boost::math::students_t{freedom}, 0.975);
  return boost::math::cdf(boost::math::normal{}, -std::sqrt(rows / freedom) * t);
}

}  // namespace

double Fit::degrees_of_freedom() const {
  return static_cast<double>(deviations.size()) - static_cast<double>(values.size());
}

Fit fit(const std::vector<FitParameter>& parameters, const FitModel& model, const FitRules& rules, bool is_absolute) {
  UnitProblem problem{parameters, model, rules.rows};
  const Sample all{problem.all_rows(), std::vector<double>(rules.rows, 1.0)};
  Vector u = best_search(problem, all, rules);
  Vector deviations = problem.deviations(u, problem.all_rows());
  if (deviations.size() <= u.size()) {
    throw InputError{fmt::format("{} measured values for {} parameters; there must be more values than parameters",
                                 deviations.size(), u.size())};
  }
  const auto variance = [&] {
    return is_absolute ? 1.0 : deviations.squaredNorm() / static_cast<double>(deviations.size() - u.size());
  };
  // Differences as wide as the values are uncertain: those of rounding and of the phase of steps are small then.
  const auto slopes_of = [&](const Vector& widths) {
    Matrix found = jacobian(problem, u, deviations, widths);
    if (!found.allFinite())
      throw InputError{"runs with slightly different parameters have no result; give other ranges"};
    return found;
  };
  const auto widths_of = [](const Spread& spread) -> Vector {
    return (0.3 * spread.errors).cwiseMax(1e-4).cwiseMin(0.02);
  };
  Matrix slopes = slopes_of(Vector::Constant(u.size(), 1e-3));
  Spread spread = spread_of(slopes, variance());
  Fit found;
  constexpr int maximum_steps = 6;
  for (int step = 0; step < maximum_steps; ++step) {
    slopes = slopes_of(widths_of(spread));
    spread = spread_of(slopes, variance());
    const Vector next = clamped(u + gauss_newton(slopes, deviations, u));
    const double change = (next - u).cwiseQuotient(spread.errors.cwiseMax(1e-12)).cwiseAbs().maxCoeff();
    found.converged = change < 0.01 || (next - u).cwiseAbs().maxCoeff() < 1e-7;
    const Vector changed = problem.deviations(next, problem.all_rows());
    if (!(sum_of(changed) < sum_of(deviations))) break;
    u = next, deviations = changed;
    if (change < 1e-4) break;
  }

  found.values = problem.values(u);
  found.deviations.assign(deviations.data(), deviations.data() + deviations.size());
  found.sum = deviations.squaredNorm();
  for (std::size_t i = 0; i < parameters.size(); ++i) {
    const auto at = static_cast<Eigen::Index>(i);
    found.errors.push_back(spread.errors[at] * problem.slope(i, found.values[i]));
    found.at_bound.push_back(u[at] == 0.0 || u[at] == 1.0);
    found.undetermined.push_back(spread.errors[at] > 0.5);
    const Vector row = spread.correlation.row(at);
    found.correlation.emplace_back(row.data(), row.data() + row.size());
  }
  std::mt19937_64 generator{static_cast<std::uint64_t>(rules.seed)};
  for (std::size_t sample = 0; sample < rules.samples; ++sample) {
    const auto [of, is_limited] =
        sample_fit(problem, u, deviations, slopes, spread.errors, drawn_sample(generator, rules.rows), rules);
    found.samples.push_back(problem.values(of));
    found.unconverged += is_limited ? 1 : 0;
  }
  found.tail = lower_probability(rules, parameters.size());
  for (std::size_t i = 0; i < parameters.size() && rules.samples > 0; ++i) {
    std::vector<double> values;
    for (const std::vector<double>& sample : found.samples)
      values.push_back(sample[i]);
    std::ranges::sort(values);
    const auto at = [&](double probability) {
      const double rank = probability * static_cast<double>(values.size() - 1);
      const auto below = static_cast<std::size_t>(rank);
      return std::lerp(values[below], values[std::min(below + 1, values.size() - 1)], rank - std::floor(rank));
    };
    found.intervals.push_back({at(found.tail), at(1.0 - found.tail)});
  }
  found.evaluations = problem.evaluations();
  return found;
}

}  // namespace talus
