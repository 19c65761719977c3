#include "tests/bench/contact_search.hpp"

#include <benchmark/benchmark.h>
#include <fmt/format.h>

#include <array>
#include <cmath>
#include <memory>
#include <random>

#include "solver/dynamics/candidates.hpp"
#include "tests/bench/timing.hpp"

namespace talus::bench {
namespace {

constexpr int searches = 4000;

/// Discs of radius 1, each with each, strewn over a square in which they fill half of the room.
struct Strewn {
  Poses poses;
  ContactSearch search;
  std::vector<char> found;
  Sweep sweep;

  Strewn(std::size_t count, bool swept) : poses(count), found(count * (count - 1) / 2) {
    std::mt19937 random{1};
    std::uniform_real_distribution<double> place{0.0, 2.5 * std::sqrt(static_cast<double>(count))};
    const Bounds disc = bounds(Circle{1.0});
    for (std::size_t a = 0; a < count; ++a) {
      const double x = place(random), y = place(random);
      poses.set(a, {{x, y}, {}, {}, 0.0});
      for (std::size_t b = 0; b < a; ++b)
        search.add({static_cast<BodyId>(b), static_cast<BodyId>(a), disc, disc, 0, 0});
    }
    search.prepare(count, swept);
  }
};

}  // namespace

void print_search_costs() {
  constexpr std::array<std::size_t, 7> counts{6, 10, 12, 16, 24, 40, 80};
  std::vector<std::unique_ptr<Strewn>> scenes;
  std::vector<Task> tasks;
  for (const std::size_t count : counts) {
    for (const bool swept : {false, true}) {
      scenes.push_back(std::make_unique<Strewn>(count, swept));
      tasks.push_back({fmt::format("{} {}", count, swept ? "swept" : "single"), [scene = scenes.back().get()] {
                         for (int i = 0; i < searches; ++i) {
                           scene->poses.x[0] += 1e-9;
                           scene->search.find(scene->poses, scene->found, scene->sweep);
                         }
                         benchmark::DoNotOptimize(scene->found);
                       }});
    }
  }
  const std::vector<Timing> timings = time_tasks(tasks, 9);
  fmt::print("\nNanoseconds a contact search (median of 9 interleaved runs of {} searches)\n", searches);
  fmt::print("{:>8} {:>8} {:>12} {:>12} {:>10}\n", "bodies", "pairs", "one by one", "swept", "ratio");
  for (std::size_t i = 0; i < counts.size(); ++i) {
    const double single = timings[2 * i].median, swept = timings[2 * i + 1].median;
    fmt::print("{:>8} {:>8} {:>12.0f} {:>12.0f} {:>9.2f}x\n", counts[i], counts[i] * (counts[i] - 1) / 2,
               1e9 * single / searches, 1e9 * swept / searches, swept / single);
  }
}

}  // namespace talus::bench
