#include "tests/bench/timing.hpp"

#include <benchmark/benchmark.h>

#include <algorithm>
#include <map>

namespace talus::bench {
namespace {

/// Stores the time of every repetition and prints nothing.
class Collector : public benchmark::BenchmarkReporter {
 public:
  bool ReportContext(const Context&) override { return true; }
  void ReportRuns(const std::vector<Run>& runs) override {
    for (const Run& run : runs) {
      if (run.run_type == Run::RT_Iteration) seconds_[run.run_name.function_name].push_back(run.GetAdjustedRealTime());
    }
  }

  Timing timing(const std::string& name) const {
    std::vector<double> sorted = seconds_.at(name);
    std::sort(sorted.begin(), sorted.end());
    return {sorted[sorted.size() / 2], sorted.front(), sorted.back()};
  }

 private:
  std::map<std::string, std::vector<double>> seconds_;
};

}  // namespace

std::vector<Timing> time_tasks(const std::vector<Task>& tasks, int repetitions) {
  std::vector<std::string> arguments{"talus_bench", "--benchmark_enable_random_interleaving=true",
                                     "--benchmark_min_time=0.01"};
  std::vector<char*> argv;
  for (std::string& argument : arguments)
    argv.push_back(argument.data());
  int argc = static_cast<int>(argv.size());
  benchmark::Initialize(&argc, argv.data());
  for (const Task& task : tasks) {
    benchmark::RegisterBenchmark(task.name.c_str(),
                                 [&task](benchmark::State& state) {
                                   for (auto _ : state)
                                     task.work();
                                 })
        ->Repetitions(repetitions)
        ->Unit(benchmark::kSecond);
  }
  Collector collector;
  benchmark::RunSpecifiedBenchmarks(&collector);
  benchmark::ClearRegisteredBenchmarks();
  std::vector<Timing> found;
  for (const Task& task : tasks)
    found.push_back(collector.timing(task.name));
  return found;
}

}  // namespace talus::bench
