#include "tests/bench/reading.hpp"

#include <benchmark/benchmark.h>
#include <fmt/format.h>

#include "solver/io/scene/read_scene.hpp"
#include "tests/bench/timing.hpp"
#include "tests/solver/io/disc_grid.hpp"

namespace talus::bench {

void print_reading_costs() {
  constexpr int repetitions = 5;
  constexpr int counts[] = {1000, 10'000, 100'000};
  std::vector<Task> tasks;
  for (const int count : counts) {
    tasks.push_back({fmt::format("{} discs", count), [text = disc_grid(count)] {
                       const Scene scene = read_scene(text, "grid.toml");
                       benchmark::DoNotOptimize(scene.model.bodies.data());
                     }});
  }
  const std::vector<Timing> timings = time_tasks(tasks, repetitions);
  fmt::print("\nReading a scene of discs, each in contact with the next (median of {} interleaved runs)\n",
             repetitions);
  fmt::print("{:32} {:>8} {:>16}\n", "scene", "s", "us a disc");
  for (std::size_t i = 0; i < tasks.size(); ++i)
    fmt::print("{:32} {:>8.3f} {:>16.2f}\n", tasks[i].name, timings[i].median, 1e6 * timings[i].median / counts[i]);
}

}  // namespace talus::bench
