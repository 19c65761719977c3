/// Disc-steps a second of Talus beside LAMMPS, from the same start, in turn within one run: `make bench-discs`.
#include <fmt/format.h>

#include <algorithm>
#include <cstdlib>
#include <ctime>
#include <filesystem>
#include <fstream>
#include <functional>
#include <random>
#include <string>
#include <vector>

#include "solver/granular/disc_system.hpp"
#include "solver/granular/fast_disc_system.hpp"
#include "solver/granular/shear_cell.hpp"
#include "solver/io/lammps.hpp"
#include "tests/bench/disc_gas.hpp"

namespace {

using namespace talus;
using namespace talus::bench;
namespace fs = std::filesystem;

constexpr double plain_skin = 0.3, fast_skin = 0.5;

/// Of the processor, so that other programs on the machine do not count.
double seconds_of(const std::function<void()>& work) {
  const std::clock_t start = std::clock();
  work();
  return static_cast<double>(std::clock() - start) / CLOCKS_PER_SEC;
}

double median(std::vector<double> times) {
  std::sort(times.begin(), times.end());
  return times.empty() ? 0.0 : times[times.size() / 2];
}

/// LAMMPS in a folder of its own.
class Lammps {
 public:
  Lammps() : there_{std::system("command -v lmp > /dev/null 2>&1") == 0} {
    folder_ = fs::temp_directory_path() / fmt::format("talus_bench_discs_{}", std::random_device{}());
  }
  ~Lammps() {
    std::error_code ignored;
    fs::remove_all(folder_, ignored);
  }
  Lammps(const Lammps&) = delete;
  Lammps& operator=(const Lammps&) = delete;

  bool there() const { return there_; }
  /// Seconds of the processor in its loop over all steps, as it says itself: without reading and setting up.
  double seconds(const LammpsScene& scene, const LammpsRun& run) const {
    export_lammps(folder_, scene, run);
    const std::string command = fmt::format("cd '{}' && lmp -in in.discs > screen.txt 2>&1", folder_.string());
    if (std::system(command.c_str()) != 0) return 0.0;
    std::ifstream log{folder_ / "log.lammps"};
    double seconds = 0.0;
    for (std::string line; std::getline(log, line);) {
      if (line.rfind("Loop time of ", 0) == 0) seconds = std::stod(line.substr(13));
      if (line.find("% CPU use") != std::string::npos) seconds *= 0.01 * std::stod(line);
    }
    return seconds;
  }

 private:
  bool there_;
  fs::path folder_;
};

std::string words(const LammpsRun& run) {
  return fmt::format("{}, newton {}, skin {:.2f}", run.style == LammpsRun::Style::granular ? "granular" : "gran/hooke",
                     run.newton ? "on" : "off", run.skin);
}

/// The fastest of its styles, of newton on and off, and of several skins.
LammpsRun best_run(const Lammps& lammps, const LammpsScene& scene, long steps) {
  LammpsRun best{.step = gas_step, .steps = steps, .skin = 0.3, .style = LammpsRun::Style::gran_hooke, .forces = false};
  double least = lammps.seconds(scene, best);
  const auto attempt = [&](LammpsRun run) {
    const double seconds = lammps.seconds(scene, run);
    if (seconds < least) best = run, least = seconds;
  };
  for (const double skin : {0.05, 0.1, 0.15, 0.2, 0.5, 0.7}) {
    LammpsRun run = best;
    run.skin = skin;
    attempt(run);
  }
  LammpsRun run = best;
  run.newton = false;
  attempt(run);
  run = best;
  run.style = LammpsRun::Style::granular;
  attempt(run);
  return best;
}

struct Size {
  std::size_t columns, rows;
  double solid_fraction;
};

/// Nanoseconds a disc-step of each, in turn.
void print_gas(const Lammps& lammps, const Size& size, LammpsRun& best) {
  DiscGas gas = lattice(size.columns, size.rows, size.solid_fraction);
  const std::size_t discs = gas.discs.size();
  {
    FastDiscSystem mixing{gas.shapes, gas.box, elastic, fast_skin};
    mixing.begin(gas.discs);
    mixing.advance(gas.discs, gas_step, 1000);
  }
  const LammpsScene scene{gas.shapes, gas.discs, gas.box, elastic};
  const bool large = discs > 200000;
  const auto steps_for = [&](double disc_steps) {
    return std::max(200L, std::lround(disc_steps / static_cast<double>(discs)));
  };
  if (lammps.there() && !large) best = best_run(lammps, scene, steps_for(2e7));
  best.steps = steps_for(3e7);

  DiscSystem plain{gas.shapes, gas.box, elastic, plain_skin};
  FastDiscSystem linear{gas.shapes, gas.box, elastic, fast_skin};
  FastDiscSystem latching{gas.shapes, gas.box, remembering, fast_skin};
  Discs plain_discs = gas.discs, linear_discs = gas.discs, latching_discs = gas.discs;
  plain.begin(plain_discs), linear.begin(linear_discs), latching.begin(latching_discs);
  const long plain_steps = steps_for(2e7), fast_steps = steps_for(large ? 4e8 : 1e8);  // several lists
  const auto ns = [&](double seconds, long steps) {
    return 1e9 * seconds / static_cast<double>(steps) / static_cast<double>(discs);
  };
  std::vector<double> theirs, ours, fast, memory;
  for (int round = 0; round < (large ? 3 : 5); ++round) {
    if (lammps.there()) theirs.push_back(ns(lammps.seconds(scene, best), best.steps));
    fast.push_back(ns(seconds_of([&] { linear.advance(linear_discs, gas_step, fast_steps); }), fast_steps));
    memory.push_back(ns(seconds_of([&] { latching.advance(latching_discs, gas_step, fast_steps); }), fast_steps));
    ours.push_back(ns(seconds_of([&] {
                        for (long n = 0; n < plain_steps; ++n)
                          plain.kick(plain_discs, gas_step), plain.drift(plain_discs, gas_step);
                      }),
                      plain_steps));
  }
  const auto ratio = [&](std::vector<double> to) {
    for (std::size_t round = 0; round < to.size(); ++round)
      to[round] /= fast[round];
    return median(to);
  };
  const double l = median(theirs), f = median(fast);
  fmt::print("{:>9} {:>5.2f} {:>9.1f} {:>9.1f} {:>9.2f} {:>9.2f} {:>12.3g} {:>12.3g} {:>9.1f} {:>9.1f} {:>9.2f}   {}\n",
             discs, size.solid_fraction, l, median(ours), f, median(memory), l > 0.0 ? 1e9 / l : 0.0, 1e9 / f,
             ratio(theirs), ratio(ours), ratio(memory), lammps.there() ? words(best) : "");
  std::fflush(stdout);
}

void print_gases() {
  const Lammps lammps;
  if (!lammps.there()) fmt::print("LAMMPS is not installed (Debian: apt-get install lammps); Talus alone:\n");
  fmt::print(
      "Equal discs without friction in a periodic box, elastic, step t_c/20, one core, double precision; each line in "
      "turn, medians,\nof ratios also. ns of the processor a disc-step. LAMMPS at the fastest of its styles, newton on "
      "and off and seven skins (neither "
      "style has "
      "an -sf opt variant);\nit steps spheres in three dimensions, of which it also sums the torques. The gas is a "
      "crystal: "
      "a lattice after 50 contact times.\nplain: DiscSystem, which also keeps the account of work. fast: "
      "FastDiscSystem with the "
      "same bits. latching: with memory, the same motion.\n\n");
  fmt::print("{:>9} {:>5} {:>9} {:>9} {:>9} {:>9} {:>12} {:>12} {:>9} {:>9} {:>9}\n", "discs", "phi", "LAMMPS", "plain",
             "fast", "latching", "LAMMPS 1/s", "fast 1/s", "LAMMPS/f", "plain/f", "latch/f");
  for (const double solid_fraction : {0.75, 0.84, 0.90}) {
    LammpsRun best;
    for (const auto& [columns, rows] :
         {std::pair<std::size_t, std::size_t>{25, 40}, {100, 100}, {250, 400}, {1000, 1000}}) {
      if (solid_fraction == 0.90 && columns != 100) continue;
      print_gas(lammps, {columns, rows, solid_fraction}, best);
    }
  }
}

void print_cell() {
  const ShearCell cell = ice_cell(8e3, 5e3);
  const FilledCell filled = fill(cell);
  const double h = cell.contact_time() / 20.0;
  constexpr long steps = 50000;
  DiscSystem plain{filled.shapes, filled.box, cell.law, 0.3 * cell.diameter};
  FastDiscSystem fast{filled.shapes, filled.box, cell.law, 0.9 * cell.diameter};
  Discs plain_discs = filled.discs, fast_discs = filled.discs;
  plain.begin(plain_discs), fast.begin(fast_discs);
  std::vector<double> one, other, single;
  for (int round = 0; round < 15; ++round) {
    const auto us = [&](const std::function<void()>& work) { return 1e6 * seconds_of(work) / steps; };
    one.push_back(us([&] {
      for (long n = 0; n < steps; ++n)
        plain.kick(plain_discs, h), plain.drift(plain_discs, h);
    }));
    other.push_back(us([&] { fast.advance(fast_discs, h, steps); }));
    single.push_back(us([&] {
      for (long n = 0; n < steps; ++n)
        fast.advance(fast_discs, h, 1);
    }));
  }
  fmt::print(
      "\nShear cell of 80 discs and 22 of walls, microseconds a step, median and least: plain {:.3f} ({:.3f}), fast "
      "{:.3f} "
      "({:.3f}), fast asked step by step {:.3f} ({:.3f})\n",
      median(one), *std::min_element(one.begin(), one.end()), median(other),
      *std::min_element(other.begin(), other.end()), median(single), *std::min_element(single.begin(), single.end()));
  fmt::print("  of {} steps {} made the list, {} the near list\n", fast.evaluations(), fast.builds(), fast.prunings());
}

}  // namespace

int main(int argc, char** argv) {
  print_cell();
  if (argc < 2 || std::string{argv[1]} != "--cell") print_gases();
}
