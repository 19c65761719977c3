#include "verification/problems/program/capacity/capacity_statistics.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <functional>
#include <numbers>
#include <random>
#include <vector>

#include "solver/capacity/capacity_map.hpp"
#include "solver/capacity/proportion.hpp"
#include "verification/study/findings/expectations.hpp"

namespace talus::verification::problems::fence_capacity {
namespace {

/// The first 53 of 64 random bits, in [0, 1).
double uniform(std::mt19937_64& generator) { return std::ldexp(static_cast<double>(generator() >> 11U), -53); }

/// Probabilities of 0 to n hits, each from the one before.
std::vector<double> binomial(int n, double p) {
  std::vector<double> chances{std::pow(1.0 - p, n)};
  for (int k = 0; k < n; ++k)
    chances.push_back(chances.back() * (n - k) / (k + 1.0) * p / (1.0 - p));
  return chances;
}

/// Coverage of the score test: the chance of those numbers of hits that are at most 1.96 deviations from n p.
double score_coverage(int n, double p) {
  double sum = 0.0;
  const std::vector<double> chances = binomial(n, p);
  for (int k = 0; k <= n; ++k)
    if (std::abs(k - n * p) <= normal_975 * std::sqrt(n * p * (1.0 - p))) sum += chances[static_cast<std::size_t>(k)];
  return sum;
}

/// Least coverage of 95 % by two order statistics of a sample: tails of at most 2.5 % each.
double order_coverage(int n, double probability) {
  const std::vector<double> chances = binomial(n, probability);
  double below = 0.0, sum = 0.0;
  for (const double chance : chances) {
    // Left out at the lower end; counted up to the upper end.
    if (below + chance > 0.025 && below < 0.975) sum += chance;
    below += chance;
  }
  return sum;
}

/// As of the maps of this case, and of `talus capacity` without others.
constexpr MapRules rules{.cells = 64, .first_cells = 4, .trials = 20, .few = 4};

/// A number of trials and the chance of it together with these hits.
struct Outcome {
  int trials{}, hits{};
  double chance{};
};

/// The ends of the trials at a node that stops once all numbers of hits within 1.96 deviations are on one side of one
/// half: of 4, 8, 16 or 20 trials.
std::vector<Outcome> node_outcomes(double p) {
  std::vector<Outcome> ended;
  std::vector<double> chances{1.0};  // of the hits of a node that has not stopped
  int trials = 0;
  for (int next = static_cast<int>(rules.few); !chances.empty(); next = 2 * next) {
    const int all = std::min(next, static_cast<int>(rules.trials)), more = all - trials;
    const std::vector<double> added = binomial(more, p);
    std::vector<double> sums(static_cast<std::size_t>(all) + 1, 0.0);
    for (std::size_t before = 0; before < chances.size(); ++before)
      for (std::size_t k = 0; k < added.size(); ++k)
        sums[before + k] += chances[before] * added[k];
    const bool is_last = all == static_cast<int>(rules.trials);
    for (int hits = 0; hits <= all; ++hits) {
      double& chance = sums[static_cast<std::size_t>(hits)];
      if (!is_last && std::abs(hits - 0.5 * all) <= normal_975 * std::sqrt(0.25 * all)) continue;
      ended.push_back({all, hits, chance});
      chance = 0.0;
    }
    trials = all;
    chances = is_last ? std::vector<double>{} : sums;
  }
  return ended;
}

/// Coverage of the score test at such a node.
double node_coverage(double p) {
  double sum = 0.0;
  for (const Outcome& of : node_outcomes(p))
    if (std::abs(of.hits - of.trials * p) <= normal_975 * std::sqrt(of.trials * p * (1.0 - p))) sum += of.chance;
  return sum;
}

double line_at(double x) { return 0.75 - 0.5 * x + 0.1 * std::sin(2.0 * std::numbers::pi * x); }

/// One half on a curved line.
double line_probability(double x, double y) {
  constexpr double width = 0.02;
  return 0.5 * std::erfc((y - line_at(x)) / (std::numbers::sqrt2 * width));
}

/// Half widths of the band.
constexpr double band_below = 0.24, band_above = 0.14;

/// As of impacts that are chaotic: up to a line nearly 1, from another one on nearly 0, and between them in waves.
double band_probability(double x, double y) {
  const double low = line_at(x) - band_below, high = line_at(x) + band_above;
  if (y < low || y > high) return y < low ? 0.98 : 0.02;
  return 0.5 + 0.4 * std::cos(60.0 * (y - low) + 25.0 * x);
}

/// The same outcome of a trial for every order of trials: its number is a hash (SplitMix64, Steele et al. 2014).
bool is_hit(std::uint64_t seed, MapNode node, std::size_t trial, double probability) {
  std::uint64_t bits =
      (((seed << 16U) + static_cast<std::uint64_t>(node.i)) << 16U) + static_cast<std::uint64_t>(node.j);
  bits = (bits << 8U) + trial;
  for (int round = 0; round < 2; ++round) {
    bits += 0x9e3779b97f4a7c15U;
    bits = (bits ^ (bits >> 30U)) * 0xbf58476d1ce4e5b9U;
    bits = (bits ^ (bits >> 27U)) * 0x94d049bb133111ebU;
    bits ^= bits >> 31U;
  }
  return std::ldexp(static_cast<double>(bits >> 11U), -53) < probability;
}

/// Adds the outcomes of all trials that a map wants, with the probability of each node.
void complete(CapacityMap& map, std::uint64_t seed, const std::function<double(MapNode)>& probability) {
  for (std::vector<MapTrials> wanted = map.next(); !wanted.empty(); wanted = map.next())
    for (const MapTrials& trials : wanted)
      for (std::size_t trial = trials.first; trial < trials.last; ++trial)
        map.add(trials.node, is_hit(seed, trials.node, trial, probability(trials.node)));
}

/// A deviation of a counted fraction, in standard deviations.
double deviation(int counted, int of, double exact) {
  return (static_cast<double>(counted) / of - exact) / std::sqrt(std::max(exact * (1.0 - exact), 1e-4) / of);
}

/// Intervals at nodes, whose number of trials depends on their outcomes.
void check_nodes(Findings& findings) {
  constexpr int seeds = 1000, nodes = 4 * seeds;
  double worst = 0.0;
  std::vector<std::vector<std::string>> rows;
  // With the probability of each seed.
  const auto compare = [&](const std::string& name, const std::function<double(int)>& probability) {
    int covered = 0;
    double exact = 0.0;
    for (int seed = 0; seed < seeds; ++seed) {
      const double p = probability(seed);
      exact += node_coverage(p) / seeds;
      // One cell: all its four nodes are ends of a column.
      CapacityMap map{{.cells = 1, .first_cells = 1, .trials = rules.trials, .few = rules.few}};
      complete(map, static_cast<std::uint64_t>(seed), [&](MapNode) { return p; });
      for (const MapNode node : {MapNode{0, 0}, MapNode{1, 0}, MapNode{0, 1}, MapNode{1, 1}}) {
        const Interval interval = wilson_interval(map.hits(node), map.trials(node));
        covered += interval.low <= p && p <= interval.high ? 1 : 0;
      }
    }
    keep_worst(worst, deviation(covered, nodes, exact));
    rows.push_back({name, fmt::format("{:.3f}", static_cast<double>(covered) / nodes), fmt::format("{:.4f}", exact)});
  };
  for (const double p : {0.02, 0.1, 0.3, 0.45, 0.495})
    compare(fmt::format("{}", p), [&](int) { return p; });
  compare("0 to 1, evenly", [&](int seed) { return (seed + 0.5) / seeds; });
  findings.expect("nodes of maps: coverage over 4,000 nodes, largest deviation from the exact one", worst, 0.0,
                  Tolerance::model(4.0,
                                   "in standard deviations of 4,000 nodes: one of six is beyond with 4e-4; the exact "
                                   "one sums over all ends of the trials, 4, 8, 16 or 20"));
  findings.table({.name = "coverage_of_nodes",
                  .caption = "Coverage of the intervals of 95 % at nodes of maps, which end early if their interval is "
                             "beside one half: counted at 4,000 nodes, and exact.",
                  .columns = {"probability", "counted", "exact"},
                  .rows = rows});
}

}  // namespace

void check_coverage(Findings& findings, const Setup& setup) {
  constexpr int seeds = 1000;
  double worst = 0.0, lowest = 1.0;
  std::vector<std::vector<std::string>> rows;
  std::mt19937_64 generator{2024};
  for (const auto& [n, p] : {std::pair{4, 0.5}, std::pair{20, 0.02}, std::pair{20, 0.3}, std::pair{20, 0.9},
                             std::pair{200, 0.02}, std::pair{200, 0.5}}) {
    int covered = 0;
    for (int seed = 0; seed < seeds; ++seed) {
      std::size_t hits = 0;
      for (int trial = 0; trial < n; ++trial)
        hits += uniform(generator) < p ? 1 : 0;
      Interval interval = wilson_interval(hits, static_cast<std::size_t>(n));
      if (setup.has("normal_interval")) {
        const double share = static_cast<double>(hits) / n, half = normal_975 * std::sqrt(share * (1.0 - share) / n);
        interval = {share - half, share + half};
      }
      covered += interval.low <= p && p <= interval.high ? 1 : 0;
    }
    const double exact = score_coverage(n, p), found = covered / static_cast<double>(seeds);
    keep_worst(worst, deviation(covered, seeds, exact));
    rows.push_back(
        {fmt::format("{}", n), fmt::format("{}", p), fmt::format("{:.3f}", found), fmt::format("{:.4f}", exact)});
  }
  findings.expect("Wilson intervals: coverage over 1,000 seeds, largest deviation from the exact one", worst, 0.0,
                  Tolerance::model(4.0,
                                   "in standard deviations of 1,000 trials: one of six is beyond with 4e-4; the "
                                   "exact coverage is that of the score test, which the interval inverts"));
  findings.table({.name = "coverage",
                  .caption = "Coverage of intervals of 95 % for a probability, counted over 1,000 seeds, and exact.",
                  .columns = {"trials", "probability", "counted", "exact"},
                  .rows = rows});

  check_nodes(findings);

  // The quantile is a value of the sample, or lies between two of them.
  double between = 0.0;
  for (const int n : {4, 20, 21}) {
    std::vector<double> sample;
    for (int i = n; i > 0; --i)
      sample.push_back(i);
    for (const double probability : {0.5, 0.95})
      keep_worst(between, sample_quantile(sample, probability).value - (1.0 + probability * (n - 1.0)));
  }
  findings.expect("quantiles: of the whole numbers 1 to n, largest deviation from 1 + p (n - 1)", between, 0.0,
                  Tolerance::round_off(1e-14, "two products and a sum of at most 21"));

  double of_quantiles = 0.0;
  for (const auto& [n, probability] : {std::pair{60, 0.5}, std::pair{200, 0.95}}) {
    int covered = 0;
    for (int seed = 0; seed < seeds; ++seed) {
      std::vector<double> sample;
      for (int i = 0; i < n; ++i)
        sample.push_back(-std::log1p(-uniform(generator)));
      const Interval interval = sample_quantile(sample, probability).interval;
      const double exact = -std::log1p(-probability);
      covered += interval.low <= exact && exact <= interval.high ? 1 : 0;
    }
    const double exact = order_coverage(n, probability);
    lowest = std::min(lowest, exact);
    keep_worst(of_quantiles, deviation(covered, seeds, exact));
  }
  findings.expect("quantiles: coverage over 1,000 seeds, largest deviation from the exact one", of_quantiles, 0.0,
                  Tolerance::model(4.0,
                                   "in standard deviations of 1,000 trials; the number of values below a quantile "
                                   "is binomial"));
  findings.expect_between("quantiles: lowest exact coverage", lowest, 0.95, 0.985,
                          "each tail has at most 2.5 %, and one value more would be in it");
}

namespace {

using Probability = double (*)(double x, double y);

CapacityMap mapped(std::uint64_t seed, Probability probability, double shift) {
  CapacityMap map{rules};
  complete(map, seed, [&](MapNode node) { return probability(node.i / 64.0, node.j / 64.0 + shift); });
  return map;
}

/// Number of nodes whose state contradicts the interval of the full grid, with the same outcomes.
double contradicted(const CapacityMap& map, std::uint64_t seed, Probability probability) {
  double contradictions = 0.0;
  const std::vector<MapState> states = map.states();
  for (int j = 0; j < map.side(); ++j) {
    for (int i = 0; i < map.side(); ++i) {
      std::size_t hits = 0;
      for (std::size_t trial = 0; trial < rules.trials; ++trial)
        hits += is_hit(seed, {i, j}, trial, probability(i / 64.0, j / 64.0)) ? 1 : 0;
      const Interval of_grid = wilson_interval(hits, rules.trials);
      const MapState state = states[map.number({i, j})];
      if (state == MapState::above && of_grid.high < 0.5) contradictions += 1.0;
      if (state == MapState::below && of_grid.low > 0.5) contradictions += 1.0;
    }
  }
  return contradictions;
}

}  // namespace

void check_maps(Findings& findings, const Setup& setup) {
  double of_lines = 0.0, of_bands = 0.0, lines = 0.0, off = 0.0, far = 0.0, outside = 0.0, bare = 0.0;
  std::array<double, 2> shares{};
  const double shift = setup.has("other_line") ? 0.1 : 0.0;
  for (const std::uint64_t seed : {1U, 2U, 3U}) {
    const CapacityMap line = mapped(seed, line_probability, shift), band = mapped(seed, band_probability, shift);
    of_lines += contradicted(line, seed, line_probability), of_bands += contradicted(band, seed, band_probability);
    for (int j = 0; j < line.side(); j += rules.cells / rules.first_cells)
      for (int i = 0; i < line.side(); i += rules.cells / rules.first_cells)
        bare += line.trials({i, j}) < rules.few ? 1.0 : 0.0;
    const double full = static_cast<double>(rules.trials) * line.side() * line.side();
    keep_worst(shares[0], static_cast<double>(line.all_trials()) / full);
    keep_worst(shares[1], static_cast<double>(band.all_trials()) / full);
    const std::vector<MapState> of_line = line.states(), of_band = band.states();
    for (int i = 0; i < line.side(); ++i) {
      const MapBoundary boundary = boundary_at(line, of_line, i), wide = boundary_at(band, of_band, i);
      const double exact = line_at(i / 64.0);
      lines += 1.0;
      if (!(boundary.last_above / 64.0 <= exact && exact <= boundary.first_below / 64.0)) off += 1.0;
      // The probability is beside one half for half of a wave of 6.7 cells.
      far = std::max(
          {far, wide.last_above - 64.0 * (exact - band_below), 64.0 * (exact + band_above) - wide.first_below});
      outside = std::max(
          {outside, 64.0 * (exact - band_below) - wide.last_above, wide.first_below - 64.0 * (exact + band_above)});
    }
  }
  findings.expect("maps: corners of the first cells without the first trials", bare, 0.0,
                  Tolerance::exact("a map begins with them"));
  findings.expect("maps: nodes whose state contradicts the interval of the full grid", of_lines, 0.0,
                  Tolerance::exact("the probability passes one half within a few cells, and the grid has the same "
                                   "outcomes"));
  findings.expect_between("maps: trials over those of the full grid, largest", shares[0], 0.01, 0.1,
                          "nodes are tried along a line of some 64 cells: a tenth is allowed");
  findings.expect_between("maps: of a band: nodes whose state contradicts the interval of the full grid", of_bands,
                          -0.5, 4.5,
                          "of some 2,000 nodes; four equal outcomes of a probability of 0.2 come once in 600");
  findings.expect_between("maps: of a band: trials over those of the full grid, largest", shares[1], 0.01, 0.1,
                          "nodes are tried at both edges of the band: a tenth is allowed");
  findings.expect_between("maps: of a band: farthest end within it, in cells", far, 0.0, 5.0,
                          "the band begins and ends with at most half a wave, 3.4 cells, on the side from which it is "
                          "entered, and chance may decide a node or two");
  findings.expect_between("maps: of a band: farthest end outside of it, in cells", outside, 0.0, 2.0,
                          "the node beside the edge, which chance decides in one case of a thousand");
  findings.expect_between(
      "maps: lines on which the exact point of one half is not within the boundary, share", off / lines, 0.0, 0.15,
      "at one half a node is decided to the wrong side with 10 %, as 20 % are decided at all; of the two nodes beside "
      "the line half of that on average over their distance, and as much for the deviation of 195 lines");
}

}  // namespace talus::verification::problems::fence_capacity
