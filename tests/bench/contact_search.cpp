#include "tests/bench/contact_search.hpp"

#include <benchmark/benchmark.h>
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <memory>
#include <random>

#include "solver/dynamics/candidates.hpp"
#include "tests/bench/timing.hpp"

namespace talus::bench {
namespace {

constexpr int searches = 4000;

/// Discs of radius 1, every pair a candidate, scattered over a square of twice their total area.
struct Strewn {
  Poses poses;
  ContactSearch search;
  std::vector<char> found;
  Sweep sweep;

  explicit Strewn(std::size_t count) : poses(count), found(count * (count - 1) / 2) {
    std::mt19937 random{1};
    std::uniform_real_distribution<double> coordinate{0.0, 2.5 * std::sqrt(static_cast<double>(count))};
    const Bounds disc = bounds(Circle{1.0});
    for (std::size_t a = 0; a < count; ++a) {
      const double x = coordinate(random), y = coordinate(random);
      poses.set(a, {{x, y}, {}, {}, 0.0});
      for (std::size_t b = 0; b < a; ++b)
        search.add({static_cast<BodyId>(b), static_cast<BodyId>(a), disc, disc, 0, 0});
    }
    search.prepare(count);
  }
};

}  // namespace

void print_search_costs() {
  constexpr std::array<std::size_t, 7> counts{3, 6, 10, 16, 24, 40, 80};
  std::vector<std::unique_ptr<Strewn>> scenes;
  std::vector<Task> tasks;
  for (const std::size_t count : counts) {
    scenes.push_back(std::make_unique<Strewn>(count));
    Strewn& scene = *scenes.back();
    tasks.push_back({fmt::format("{} each", count), [&scene] {
                       for (int i = 0; i < searches; ++i) {
                         scene.poses.x[0] += 1e-9;
                         for (std::size_t p = 0; p < scene.found.size(); ++p) {
                           const Candidate& pair = scene.search.pairs()[p];
                           scene.found[p] = !out_of_reach(pair, scene.poses[index(pair.a)], scene.poses[index(pair.b)]);
                         }
                         benchmark::DoNotOptimize(scene.found.data());
                       }
                     }});
    // A body that moves back and forth by more than the skin causes a new list at each search; one that creeps does
    // not.
    for (const double displacement : {0.5, 1e-9}) {
      tasks.push_back({fmt::format("{} {}", count, displacement), [&scene, displacement] {
                         for (int i = 0; i < searches; ++i) {
                           scene.poses.x[0] += i % 2 == 0 ? displacement : -displacement;
                           std::fill(scene.found.begin(), scene.found.end(), char{0});
                           scene.search.find(scene.poses, scene.found, scene.sweep);
                         }
                         benchmark::DoNotOptimize(scene.found.data());
                       }});
    }
  }
  const std::vector<Timing> timings = time_tasks(tasks, 9);
  fmt::print("\nNanoseconds a contact search (median of 9 interleaved runs of {} searches)\n", searches);
  fmt::print("{:>8} {:>8} {:>12} {:>12} {:>12}\n", "bodies", "pairs", "each pair", "listed again", "list kept");
  for (std::size_t i = 0; i < counts.size(); ++i) {
    fmt::print("{:>8} {:>8}", counts[i], counts[i] * (counts[i] - 1) / 2);
    for (std::size_t j = 0; j < 3; ++j)
      fmt::print(" {:>12.0f}", 1e9 * timings[3 * i + j].median / searches);
    fmt::print("\n");
  }
}

}  // namespace talus::bench
