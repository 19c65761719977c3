#include <random>

#include "solver/cell/block_means.hpp"
#include "solver/cell/cell_profile.hpp"
#include "solver/study/shear_study.hpp"
#include "verification/problems/cell/cell_runs.hpp"
#include "verification/study/toolkit.hpp"

namespace talus::verification::problems::mean_errors {
namespace {

using Q = StudyQuantity;

/// Nearly normal random numbers: sums of twelve uniform ones, less six.
class Normal {
 public:
  explicit Normal(std::uint64_t seed) : random_{seed} {}
  double operator()() {
    double sum = -6.0;
    for (int k = 0; k < 12; ++k)
      sum += static_cast<double>(random_() >> 11U) * 0x1p-53;
    return sum;
  }

 private:
  std::mt19937_64 random_;
};

/// Series x' = a x + sqrt(1 - a^2) g with normal g: variance 1, autocorrelations a^lag.
std::vector<double> series_with_memory(Normal& normal, double a, std::size_t length) {
  std::vector<double> series;
  double x = normal();
  for (std::size_t k = 0; k < length; ++k)
    series.push_back(x), x = a * x + std::sqrt(1.0 - a * a) * normal();
  return series;
}

/// Variance of the mean of such a series: (1/n^2) sum over i, j of a^|i - j|.
double variance_of_mean(double a, std::size_t length) {
  double sum = 0.0;
  for (std::size_t lag = 0; lag < length; ++lag)
    sum += (lag == 0 ? 1.0 : 2.0) * static_cast<double>(length - lag) * std::pow(a, static_cast<double>(lag));
  return sum / std::pow(static_cast<double>(length), 2);
}

/// Reported errors of the means of many series: root mean square over the exact error, and fraction of means within two
/// of their errors.
struct Coverage {
  double ratio{}, within{};
};
Coverage coverage(double a, std::size_t length, int count, bool of_ratio) {
  Normal normal{static_cast<std::uint64_t>(1000.0 * a) + (of_ratio ? 1U : 0U)};
  constexpr double small = 0.2;  // deviation of the two series of a ratio from 1
  double squares = 0.0, within = 0.0;
  for (int n = 0; n < count; ++n) {
    const std::vector<double> x = series_with_memory(normal, a, length), y = series_with_memory(normal, a, length);
    BlockMeans means{2, static_cast<double>(length), length};
    for (std::size_t k = 0; k < length; ++k) {
      const std::array values{of_ratio ? 1.0 + small * x[k] : x[k], 1.0 + small * y[k]};
      means.add(static_cast<double>(k) + 0.5, 1.0, values);
    }
    const Estimate found = of_ratio ? means.ratio(0, 1, 0) : means.estimate(0, 0);
    squares += found.error * found.error;
    if (std::abs(found.value - (of_ratio ? 1.0 : 0.0)) < 2.0 * found.error) within += 1.0;
  }
  const double exact = variance_of_mean(a, length) * (of_ratio ? 2.0 * small * small : 1.0);
  return {std::sqrt(squares / count / exact), within / count};
}

void expect_coverage(Findings& findings, const Setup& setup) {
  constexpr std::size_t length = 200;
  constexpr int count = 60;
  Table table{
      .name = "coverage",
      .caption =
          "Reported standard errors of means over 200 successive values with the autocorrelation a^lag, and of ratios "
          "of two such means: root mean square over the exact error, and fraction of means within two standard errors.",
      .columns = {"a", "quantity", "error over exact error", "within two errors"}};
  for (const bool of_ratio : {false, true}) {
    for (const double a : {0.0, 0.5, 0.8}) {
      const std::string name = fmt::format("{}, a = {}", of_ratio ? "ratio" : "mean", a);
      if (!setup.needs(name)) continue;
      Coverage found = coverage(a, length, count, of_ratio);
      // The error for independent neighbours is smaller by sqrt((1 - a)/(1 + a)).
      if (setup.has("neighbours_independent")) found.ratio *= std::sqrt((1.0 - a) / (1.0 + a));
      findings.expect_between(
          {"errors", "reported standard error over the exact one, " + name}, found.ratio, 0.8, 1.12,
          "blocks of finite length reduce the variance by the fraction (correlation length)/(block length), here about "
          "0.05 to 0.3; the rest is the scatter of 60 series; an error that treats successive values as independent is "
          "0.58 (a = 0.5) and 0.33 (a = 0.8) of the exact one");
      findings.expect_between("fraction of means within two standard errors, " + name, found.within, 0.8, 1.0,
                              "0.954 for normally distributed means with the exact error, 0.89 with 0.8 of it; three "
                              "standard deviations over 60 series are 0.12");
      table.rows.push_back(
          cells("{} | {} | {:.3f} | {:.2f}", a, of_ratio ? "ratio" : "mean", found.ratio, found.within));
    }
  }
  if (!setup.coarse) findings.table(table);
}

/// Six-fold order of the free discs: the mean of |sum exp(6 i angle)|/n over the n discs within 1.3 diameters, zero for
/// fewer than three; over all pairs of discs.
double order_of(const ShearCell& cell, const Discs& discs) {
  double sum = 0.0;
  for (std::size_t i = 0; i < cell.free_discs(); ++i) {
    double c = 0.0, s = 0.0, near = 0.0;
    for (std::size_t j = 0; j < discs.size(); ++j) {
      const double x = std::remainder(discs.x[j] - discs.x[i], cell.width()), y = discs.y[j] - discs.y[i];
      if (j == i || std::hypot(x, y) > 1.3 * cell.diameter) continue;
      const double angle = 6.0 * std::atan2(y, x);
      c += std::cos(angle), s += std::sin(angle), near += 1.0;
    }
    if (near > 2.0) sum += std::hypot(c, s) / near;
  }
  return sum / static_cast<double>(cell.free_discs());
}

/// Two loads of the study with three seeds each, compared with cells that are run one by one.
void expect_study(Findings& findings, const Setup& setup) {
  const std::vector<StudyPoint> points{{"5000 d/s", 2e3, 5000.0, 1.0}, {"5000 d/s", 32e3, 5000.0, 1.0}};
  const StudyPlan plan{.time = 0.003, .seeds = 3};
  const std::vector<StudyMean> study = talus::shear_study(points, plan);
  double numbers = 0.0, orders = 0.0, means = 0.0, errors = 0.0;
  for (const StudyMean& point : study) {
    std::vector<double> depths;
    for (std::uint64_t seed = 1; seed <= 3; ++seed) {
      const ShearCell cell = study_cell(point.point, setup.has("one_seed") ? 1 : seed);
      CellRun run{cell, cell_plan(cell, plan.time, 20.0, 40)};
      double sum = 0.0, outputs = 0.0;
      run_to_end(run, [&](CellRun& at) {
        if (4 * at.steps() >= at.last_step()) sum += order_of(cell, at.discs()), outputs += 1.0;
      });
      findings.count(run.evaluations());
      depths.push_back(run.mean(CellQuantity::depth).value / cell.diameter);
      const auto& recorded = point.runs.at(seed - 1);
      keep_worst(numbers, recorded.numbers[static_cast<std::size_t>(Q::depth)] - depths.back());
      keep_worst(numbers, static_cast<double>(recorded.seed) - static_cast<double>(seed));
      keep_worst(numbers, recorded.numbers[static_cast<std::size_t>(Q::largest_overlap)] -
                              run.largest_overlap() / cell.diameter);
      keep_worst(orders, recorded.numbers[static_cast<std::size_t>(Q::order)] - sum / outputs);
    }
    const double mean = (depths[0] + depths[1] + depths[2]) / 3.0;
    keep_worst(means, point.of(Q::depth).value - mean);
    // s/sqrt(n), with s^2 half the mean square of all differences.
    double differences = 0.0;
    for (const auto& [i, j] : {std::pair{0U, 1U}, std::pair{0U, 2U}, std::pair{1U, 2U}})
      differences += (depths[i] - depths[j]) * (depths[i] - depths[j]);
    keep_worst(errors, point.of(Q::depth).error / std::sqrt(differences / 18.0) - 1.0);
  }
  findings.expect_exact(
      {"study_runs", "study: depth, largest overlap and seed of each run, largest difference from separate runs"},
      numbers, 0.0, "the same cell and the same steps");
  findings.expect_round_off("study: six-fold order of each run after the start-up, largest error", orders, 0.0, 1e-14,
                            "angles of six times up to pi, each rounded to 1.8e-15; means over 80 discs, and over the "
                            "last 31 of 40 outputs");
  findings.expect_round_off("study: mean depths over seeds, largest error", means, 0.0, 1e-14,
                            "sums of three depths of about ten diameters");
  findings.expect_round_off(
      "study: standard errors over seeds, largest relative error", errors, 0.0, 1e-12,
      "depths of ten diameters differ by some thousandths, so that 12 digits of their differences remain");
}

/// Study point with these numbers for its seeds, and their mean and standard error.
StudyMean made_point(const std::string& series, double load,
                     const std::vector<std::array<double, study_quantities>>& numbers) {
  StudyMean point{.point = {series, load, 5000.0, 1.0}, .seeds = static_cast<int>(numbers.size()), .runs = {}};
  const auto count = static_cast<double>(numbers.size());
  for (std::size_t s = 0; s < numbers.size(); ++s)
    point.runs.push_back({s + 1, numbers[s]});
  for (std::size_t k = 0; k < study_quantities; ++k) {
    double mean = 0.0, squares = 0.0;
    for (const auto& of : numbers)
      mean += of[k] / count;
    for (const auto& of : numbers)
      squares += (of[k] - mean) * (of[k] - mean);
    point.mean[k] = {mean, std::sqrt(squares / (count - 1.0) / count)};
  }
  return point;
}

/// Probability of a larger t of either sign with 4 or 5 degrees of freedom: Student's distribution, integrated.
double chance(double t, int freedom) {
  const double angle = std::atan(std::abs(t) / std::sqrt(static_cast<double>(freedom)));
  const double s = std::sin(angle), c = std::cos(angle);
  if (freedom == 4) return 1.0 - s * (1.0 + 0.5 * c * c);
  return 1.0 - 2.0 / std::numbers::pi * (angle + s * c * (1.0 + 2.0 / 3.0 * c * c));
}

/// Verdicts on synthetic numbers: two loads with three seeds each. The numbers have equal scatter, so that Welch's
/// degrees of freedom are 4, and those of the differences between the two ratios are 5.
void expect_verdicts(Findings& findings, const Setup& setup) {
  const std::array scatter{-0.02, -0.01, 0.03};
  std::vector<StudyMean> study;
  std::vector<double> apart;
  for (const auto& [series, slow] : {std::pair{"5000 d/s", 0.0}, std::pair{"1000 d/s", 1.0}}) {
    for (const auto& [load, high] : {std::pair{2e3, 0.0}, std::pair{32e3, 1.0}}) {
      std::vector<std::array<double, study_quantities>> numbers;
      for (std::size_t seed = 0; seed < scatter.size(); ++seed) {
        std::array<double, study_quantities> of{};
        const auto set = [&](Q quantity, double value) { of[static_cast<std::size_t>(quantity)] = value; };
        const double off = scatter[seed];
        set(Q::depth, 9.0 + off - 0.1 * high);
        set(Q::multiple_fraction, 0.7 + off + 0.2 * high);
        set(Q::multiple_stress_ratio, 0.25 + 0.5 * off), set(Q::binary_stress_ratio, 0.24 + 2.0 * off * (high - 0.4));
        set(Q::stress_ratio, 0.26 + off + (slow > 0.0 ? -0.08 * high : 0.02 * high));
        numbers.push_back(of);
        if (slow == 0.0) apart.push_back(0.01 + 0.5 * off - 2.0 * off * (high - 0.4));
      }
      study.push_back(made_point(series, load, numbers));
    }
  }
  const std::vector<Verdict> found = verdicts(study);
  double squares = 0.0, mean = 0.0, sum = 0.0;
  for (const double off : scatter)
    squares += off * off;
  const double error = std::sqrt(2.0 * squares / 6.0);  // of a difference of two means of three
  for (const double each : apart)
    mean += each / 6.0;
  for (const double each : apart)
    sum += (each - mean) * (each - mean);
  const std::vector<std::pair<double, int>> exact{
      {-0.1 / error, 4}, {0.2 / error, 4}, {mean / std::sqrt(sum / 30.0), 5}, {0.02 / error, 4}, {-0.08 / error, 4}};
  double significance = 0.0, chances = 0.0, outturns = 0.0;
  const std::array sign{-1.0, 1.0, -1.0, -1.0, -1.0};
  for (std::size_t k = 0; k < exact.size(); ++k) {
    const auto [t, freedom] = exact[k];
    const double p = chance(t, setup.has("one_freedom_more") && freedom == 4 ? 5 : freedom);
    keep_worst(significance, found.at(k).significance / t - 1.0);
    keep_worst(chances, found[k].chance - p);
    const Outturn outturn = !(p < 0.01) ? Outturn::not_shown : sign[k] * t > 0.0 ? Outturn::holds : Outturn::opposed;
    outturns += found[k].outturn == outturn ? 0.0 : 1.0;
  }
  findings.expect_round_off("verdicts: Student's t, largest relative error", significance, 0.0, 1e-13,
                            "differences of numbers up to 9, of which 13 digits remain");
  findings.expect_round_off({"probabilities", "verdicts: probabilities, largest error"}, chances, 0.0, 3e-14,
                            "Student's distribution with 4 and 5 degrees of freedom in closed form: some twenty "
                            "roundings of numbers up to one, and a quarter of the relative error of t, 1e-13, at most");
  findings.expect_exact("verdicts that disagree with t and its probability", outturns, 0.0,
                        "each verdict follows from both");
}

/// Points with two and with three seeds: only the mean of two scatters, so that the difference has one degree of
/// freedom, and Student's distribution is Cauchy's.
void expect_unequal_seeds(Findings& findings) {
  std::vector<StudyMean> study;
  const auto add = [&](const char* series, double load, const std::vector<double>& depths) {
    std::vector<std::array<double, study_quantities>> numbers(depths.size());
    for (std::size_t seed = 0; seed < depths.size(); ++seed)
      numbers[seed][static_cast<std::size_t>(Q::depth)] = depths[seed];
    study.push_back(made_point(series, load, numbers));
  };
  constexpr double apart = 0.5, scatter = 0.1;
  for (const char* const series : {"5000 d/s", "1000 d/s"})
    add(series, 2e3, {9.0 - scatter, 9.0 + scatter}), add(series, 32e3, {9.0 - apart, 9.0 - apart, 9.0 - apart});
  const Verdict found = verdicts(study).at(0);
  // The standard error of the mean of two is half their distance.
  const double t = -apart / scatter;
  findings.expect_round_off("verdict on points with two and three seeds: Student's t", found.significance, t, 1e-13,
                            "differences of numbers of 9, of which 14 digits remain");
  findings.expect_round_off("verdict on points with two and three seeds: probability", found.chance,
                            1.0 - 2.0 / std::numbers::pi * std::atan(-t), 3e-14,
                            "one degree of freedom in closed form, as for four and five");
}

/// A quantity that has no value in draws without one of the blocks, and is the mean of the others elsewhere. With one
/// block of n at zero and half of the others at 1, half at -1, the mean of a draw that has that block K times has the
/// variance (n - K)/n^2; K is binomial with mean 1, and draws count if K > 0. The signs are Legendre symbols of the
/// prime n (1 for squares), whose neighbours are uncorrelated.
void expect_undefined_draws(Findings& findings) {
  constexpr std::size_t blocks = 41;
  std::vector<double> signs(blocks, -1.0);
  signs[0] = 0.0;
  for (std::size_t k = 1; k < blocks; ++k)
    signs[k * k % blocks] = 1.0;
  BlockMeans means{2, static_cast<double>(blocks), blocks};
  for (std::size_t k = 0; k < blocks; ++k) {
    const std::array values{signs[k], k == 0 ? 1.0 : 0.0};
    means.add(static_cast<double>(k) + 0.5, 1.0, values);
  }
  const Estimate found = means.estimate(0, [](const BlockMeans::Means& mean) {
    return mean(1) > 0.0 ? mean(0) : std::numeric_limits<double>::quiet_NaN();
  });
  constexpr double n = blocks;
  const double defined = 1.0 - std::pow(1.0 - 1.0 / n, n);
  const double variance = (n - 1.0 / defined) / (n * n) * n / (n - 1.0);
  findings.expect(
      "error of a mean that a third of the draws do not have, over the exact one", found.error / std::sqrt(variance),
      1.0,
      Tolerance::model(0.13,
                       "three standard deviations of the scatter of some 250 normal numbers, 1/sqrt(500); with the "
                       "draws without a value it would be smaller by a fifth"));
}

/// A layer that one block of time alone has seen: without it nothing is known of the layer, so that it does not add to
/// the error. The layer below has discs with the velocities 1 and 2 in turn.
void expect_rare_layers(Findings& findings) {
  constexpr std::size_t blocks = CellProfile::blocks;
  CellProfile profile{1.0, 1.0, 0.0, static_cast<double>(blocks)};
  const auto disc = [](double y, double speed) {
    return CellProfile::Disc{.y = y, .vx = speed, .vy = 0.0, .radius = 0.25, .mass = 1.0, .spin = 0.0};
  };
  for (std::size_t k = 0; k < blocks; ++k) {
    profile.look(static_cast<double>(k) + 0.5, 1.0);
    profile.add(disc(0.5, k % 2 == 0 ? 1.0 : 2.0));
    if (k == 3) profile.add(disc(1.5, 5.0));
  }
  const auto layers = profile.layers();
  const bool two = layers.size() == 2;
  findings.expect_true("layers of a profile, of which one is seen in a single block", two, "two heights");
  if (!two) return;
  findings.expect_round_off("velocity of a layer seen in a single block", layers[1].velocity.value, 5.0, 1e-14,
                            "the disc's own", "m/s");
  findings.expect_round_off("error of the velocity of a layer seen in a single block", layers[1].velocity.error, 0.0,
                            1e-14, "no other block gives another value", "m/s");
  // Jackknife of ten values of 1 and 2: the standard error of their mean, 0.5 sqrt(1/9).
  findings.expect_round_off("error of the velocity of a layer seen in all blocks", layers[0].velocity.error, 0.5 / 3.0,
                            1e-14, "ten values of deviation 0.5: 0.5/sqrt(10 - 1)", "m/s");
}

void run(Findings& findings, const Setup& setup) {
  expect_coverage(findings, setup);
  expect_undefined_draws(findings);
  if (setup.needs("layer")) expect_rare_layers(findings);
  if (setup.needs("verdict")) expect_unequal_seeds(findings);
  if (setup.needs("study: ")) expect_study(findings, setup);
  if (setup.needs("verdicts")) expect_verdicts(findings, setup);
}

}  // namespace

Case definition() {
  return {.id = "mean_errors",
          .title = "Standard errors of time averages",
          .family = "the shear cell",
          .requirements = {{"F8", {"errors"}}},
          .main_checks = {"reported standard error over the exact one, mean, a = 0.8",
                          "reported standard error over the exact one, ratio, a = 0.8",
                          "study: standard errors over seeds, largest relative error", "probabilities"},
          .source = "Student's distribution and series with exponential memory in closed form; Welch 1947",
          .faults = {{"neighbours_independent", "errors computed as for independent successive values",
                      "reported standard error over the exact one, mean, a = 0.8"},
                     {"one_seed", "all cells with one seed instead of three", "study_runs"},
                     {"one_freedom_more", "five degrees of freedom instead of four", "probabilities"}},
          .run = run};
}

}  // namespace talus::verification::problems::mean_errors
