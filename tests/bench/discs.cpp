/// Disc-steps per second of Talus and LAMMPS from the same start, interleaved within one run: `make bench-discs`.
/// Arguments select tables: --cell, --one, --friction, --two; without any, all are printed. --quick omits a million
/// discs.
/// --skins: cost of neighbour lists by their reach.
#include <fmt/format.h>
#include <malloc.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <cstdio>
#include <ctime>
#include <functional>
#include <limits>
#include <string>
#include <utility>
#include <vector>

#include "solver/cell/cell_run.hpp"
#include "solver/cell/shear_cell.hpp"
#include "solver/granular/disc_system.hpp"
#include "solver/granular/fast_disc_system.hpp"
#include "solver/granular/list_skin.hpp"
#include "tests/bench/bare_cell.hpp"
#include "tests/bench/disc_gas.hpp"
#include "tests/bench/lammps_program.hpp"

namespace {

using namespace talus;
using namespace talus::bench;

constexpr double plain_skin = 0.3;

/// Processor time, so that other programs on the machine do not count.
double seconds_of(const std::function<void()>& work) {
  const std::clock_t start = std::clock();
  work();
  return static_cast<double>(std::clock() - start) / CLOCKS_PER_SEC;
}

/// Wall-clock time, for several threads.
double clock_seconds_of(const std::function<void()>& work) {
  const auto start = std::chrono::steady_clock::now();
  work();
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

double median(std::vector<double> times) {
  std::sort(times.begin(), times.end());
  return times.empty() ? 0.0 : times[times.size() / 2];
}

/// Median of the ratios of the rounds.
double median_ratio(std::vector<double> over, const std::vector<double>& under) {
  for (std::size_t round = 0; round < over.size(); ++round)
    over[round] /= under[round];
  return median(over);
}

std::string text_of(const LammpsRun& run) {
  return fmt::format("{}, newton {}, skin {:.2f}", run.style == LammpsRun::Style::granular ? "granular" : "gran/hooke",
                     run.newton ? "on" : "off", run.skin);
}

struct Size {
  std::size_t columns, rows;
  double solid_fraction;
  std::size_t discs() const { return columns * rows; }
  bool large() const { return discs() > 200000; }
  long steps(double disc_steps) const { return std::max(200L, std::lround(disc_steps / static_cast<double>(discs()))); }
  /// Nanoseconds per disc-step.
  double ns(double seconds, long steps) const {
    return 1e9 * seconds / static_cast<double>(steps) / static_cast<double>(discs());
  }
  double skin() const { return list_skin(discs(), solid_fraction); }
  int rounds() const { return large() ? 3 : 5; }
};

std::vector<Size> sizes(double solid_fraction, bool quick) {
  std::vector<Size> all{{25, 40, solid_fraction}, {100, 100, solid_fraction}, {250, 400, solid_fraction}};
  if (!quick) all.push_back({1000, 1000, solid_fraction});
  return all;
}

/// The gas after mixing.
DiscGas mixed(const Size& size) {
  DiscGas gas = lattice(size.columns, size.rows, size.solid_fraction);
  FastDiscSystem mixing{gas.shapes, gas.box, elastic, size.skin()};
  mixing.begin(gas.discs);
  mixing.advance(gas.discs, gas_step, 1000);
  return gas;
}

/// Standard output of a command.
std::string answer(const std::string& command) {
  std::string text;
  if (FILE* const pipe = ::popen(command.c_str(), "r")) {
    for (int c = std::fgetc(pipe); c != EOF; c = std::fgetc(pipe))
      text.push_back(static_cast<char>(c));
    ::pclose(pipe);
  }
  return text;
}

/// Nanoseconds of the portable build over those of this build, interleaved; reports a difference in bits.
std::string portable_ratio(const Size& size) {
  std::vector<double> theirs, ours;
  const long steps = size.steps(3e7);
  for (int round = 0; round < 3; ++round) {
    const std::string said = answer(
        fmt::format("'{}' {} {} {} {}", TALUS_PORTABLE_DISCS, size.columns, size.rows, size.solid_fraction, steps));
    const GasRun run = run_gas(size.columns, size.rows, size.solid_fraction, steps);
    const std::size_t space = said.find(' ');
    if (space == std::string::npos) return "none";
    if (std::stoull(said.substr(space)) != run.bits) return "BITS";
    theirs.push_back(std::stod(said)), ours.push_back(run.nanoseconds);
  }
  return fmt::format("{:.2f}", median_ratio(theirs, ours));
}

/// Memory that is allocated at present.
double bytes_taken() {
  const auto taken = ::mallinfo2();
  return static_cast<double>(taken.uordblks + taken.hblkhd);
}

/// Bytes per disc of a system and its discs after lists have been rebuilt; runs in a separate process.
template <class L, class F>
double bytes_of(const Size& size, const L& law, const F& friction) {
  const double before = bytes_taken();
  DiscGas gas = lattice(size.columns, size.rows, size.solid_fraction);
  FastDiscSystem system{std::exchange(gas.shapes, {}), gas.box, law, size.skin(), friction};
  system.begin(gas.discs);
  system.advance(gas.discs, gas_step, 600);
  return (bytes_taken() - before) / static_cast<double>(size.discs());
}

int print_bytes(char** arguments) {
  const Size size{std::stoul(arguments[0]), std::stoul(arguments[1]), std::stod(arguments[2])};
  const std::string which = arguments[3];
  fmt::print("{}\n", which == "linear"     ? bytes_of(size, elastic, Frictionless{})
                     : which == "latching" ? bytes_of(size, remembering, Frictionless{})
                                           : bytes_of(size, elastic, rough));
  return 0;
}

double bytes(const std::string& self, const Size& size, const char* which) {
  const std::string said =
      answer(fmt::format("'{}' --bytes {} {} {} {}", self, size.columns, size.rows, size.solid_fraction, which));
  return said.empty() ? 0.0 : std::stod(said);
}

void print_gas(const LammpsProgram& lammps, const Size& size, LammpsRun& best, const std::string& self) {
  const DiscGas gas = mixed(size);
  const LammpsScene scene{gas.shapes, gas.discs, gas.box, elastic};
  if (lammps.there() && !size.large()) best = lammps.best_run(scene, gas_step, size.steps(2e7));
  best.steps = size.steps(3e7);

  DiscSystem plain{gas.shapes, gas.box, elastic, plain_skin};
  FastDiscSystem linear{gas.shapes, gas.box, elastic, size.skin()};
  FastDiscSystem latching{gas.shapes, gas.box, remembering, size.skin()};
  Discs plain_discs = gas.discs, linear_discs = gas.discs, latching_discs = gas.discs;
  plain.begin(plain_discs), linear.begin(linear_discs), latching.begin(latching_discs);
  const long plain_steps = size.steps(2e7), fast_steps = size.steps(size.large() ? 4e8 : 1e8);  // several lists
  std::vector<double> theirs, ours, fast, memory;
  for (int round = 0; round < size.rounds(); ++round) {
    if (lammps.there()) theirs.push_back(size.ns(lammps.seconds(scene, best), best.steps));
    fast.push_back(size.ns(seconds_of([&] { linear.advance(linear_discs, gas_step, fast_steps); }), fast_steps));
    memory.push_back(size.ns(seconds_of([&] { latching.advance(latching_discs, gas_step, fast_steps); }), fast_steps));
    ours.push_back(size.ns(seconds_of([&] {
                             for (long n = 0; n < plain_steps; ++n)
                               plain.kick(plain_discs, gas_step), plain.drift(plain_discs, gas_step);
                           }),
                           plain_steps));
  }
  const double l = median(theirs), f = median(fast);
  fmt::print(
      "{:>9} {:>5.2f} {:>8.1f} {:>8.1f} {:>8.2f} {:>8.2f} {:>11.3g} {:>11.3g} {:>8.1f} {:>8.1f} {:>8.2f} {:>8} "
      "{:>6.0f} "
      "{:>6.0f}   {}\n",
      size.discs(), size.solid_fraction, l, median(ours), f, median(memory), l > 0.0 ? 1e9 / l : 0.0, 1e9 / f,
      median_ratio(theirs, fast), median_ratio(ours, fast), median_ratio(memory, fast), portable_ratio(size),
      bytes(self, size, "linear"), bytes(self, size, "latching"), lammps.there() ? text_of(best) : "");
  std::fflush(stdout);
}

void print_gases(const LammpsProgram& lammps, bool quick, const std::string& self) {
  fmt::print(
      "\nEqual discs without friction in a periodic box, elastic, step t_c/20, one core, double precision; each line "
      "in "
      "turn, medians,\nof ratios also. ns of the processor a disc-step. LAMMPS at the fastest of its styles, newton on "
      "and off and seven skins (neither\nstyle has an -sf opt variant); it steps spheres in three dimensions, of which "
      "it "
      "also sums the torques. The gas is a crystal:\na lattice after 50 contact times. plain: DiscSystem, one pair "
      "after "
      "the other. fast: FastDiscSystem with the same bits.\nlatching: with memory, the same motion. portable: fast "
      "without "
      "AVX, the same bits. bytes a disc: fast, and latching.\n\n");
  fmt::print("{:>9} {:>5} {:>8} {:>8} {:>8} {:>8} {:>11} {:>11} {:>8} {:>8} {:>8} {:>8} {:>6} {:>6}\n", "discs", "phi",
             "LAMMPS", "plain", "fast", "latching", "LAMMPS 1/s", "fast 1/s", "LAMMPS/f", "plain/f", "latch/f",
             "port./f", "bytes", "latch");
  for (const double solid_fraction : {0.75, 0.84, 0.90}) {
    LammpsRun best;
    for (const Size& size : sizes(solid_fraction, quick)) {
      if (solid_fraction < 0.9 || size.columns == 100) print_gas(lammps, size, best, self);
    }
  }
}

/// Friction dissipates energy, so each round restarts.
void print_rough_gases(const LammpsProgram& lammps, bool quick) {
  fmt::print(
      "\nThe same discs with friction 0.5 (k_s = 0.7 k) and spin; LAMMPS with its history of stretch, spheres that "
      "turn "
      "as "
      "discs.\nEach round begins with the same state, which cools.\n\n{:>9} {:>5} {:>8} {:>8} {:>8} {:>8} {:>8}\n",
      "discs", "phi", "LAMMPS", "plain", "fast", "LAMMPS/f", "plain/f");
  for (const double solid_fraction : {0.75, 0.84}) {
    LammpsRun best;
    for (const Size& size : sizes(solid_fraction, quick)) {
      const DiscGas gas = mixed(size);
      const LammpsScene scene{gas.shapes, gas.discs, gas.box, elastic, rough};
      if (lammps.there() && !size.large()) best = lammps.best_run(scene, gas_step, size.steps(1e7));
      const long steps = best.steps = size.steps(2e7), plain_steps = size.steps(1e7);
      std::vector<double> theirs, plain, fast;
      for (int round = 0; round < size.rounds(); ++round) {
        if (lammps.there()) theirs.push_back(size.ns(lammps.seconds(scene, best), steps));
        Discs discs = gas.discs;
        FastDiscSystem system{gas.shapes, gas.box, elastic, size.skin(), rough};
        system.begin(discs);
        fast.push_back(size.ns(seconds_of([&] { system.advance(discs, gas_step, steps); }), steps));
        discs = gas.discs;
        DiscSystem twin{gas.shapes, gas.box, elastic, plain_skin, rough};
        twin.begin(discs);
        plain.push_back(size.ns(seconds_of([&] {
                                  for (long n = 0; n < plain_steps; ++n)
                                    twin.kick(discs, gas_step), twin.drift(discs, gas_step);
                                }),
                                plain_steps));
      }
      fmt::print("{:>9} {:>5.2f} {:>8.1f} {:>8.1f} {:>8.2f} {:>8.1f} {:>8.1f}   {}\n", size.discs(),
                 size.solid_fraction, median(theirs), median(plain), median(fast), median_ratio(theirs, fast),
                 median_ratio(plain, fast), lammps.there() ? text_of(best) : "");
      std::fflush(stdout);
    }
  }
}

void print_two_cores(const LammpsProgram& lammps, bool quick) {
  fmt::print(
      "\nThe first gas on two cores, ns of the clock a disc-step: LAMMPS by MPI, fast by two threads with the bits of "
      "one.\none/two: how much faster two are than one.\n\n{:>9} {:>5} {:>8} {:>8} {:>8} {:>8} {:>8} {:>8}\n",
      "discs", "phi", "LAMMPS", "one/two", "fast", "one/two", "latch", "LAMMPS/f");
  for (const double solid_fraction : {0.75, 0.84}) {
    LammpsRun best;
    for (const Size& size : sizes(solid_fraction, quick)) {
      const DiscGas gas = mixed(size);
      const LammpsScene scene{gas.shapes, gas.discs, gas.box, elastic};
      if (lammps.has_mpi() && !size.large()) best = lammps.best_run(scene, gas_step, size.steps(1e7));
      best.steps = size.steps(3e7);
      FastDiscSystem one{gas.shapes, gas.box, elastic, size.skin()};
      FastDiscSystem two{gas.shapes, gas.box, elastic, size.skin(), Frictionless{}, 2};
      FastDiscSystem memory{gas.shapes, gas.box, remembering, size.skin(), Frictionless{}, 2};
      Discs of_one = gas.discs, of_two = gas.discs, of_memory = gas.discs;
      one.begin(of_one), two.begin(of_two), memory.begin(of_memory);
      const long steps = size.steps(size.large() ? 2e8 : 1e8);
      std::vector<double> their_one, their_two, alone, together, latching;
      for (int round = 0; round < size.rounds(); ++round) {
        if (lammps.has_mpi()) {
          their_one.push_back(size.ns(lammps.seconds(scene, best), best.steps));
          their_two.push_back(size.ns(lammps.seconds(scene, best, 2), best.steps));
        }
        const auto time = [&](auto& system, Discs& discs) {
          return size.ns(clock_seconds_of([&] { system.advance(discs, gas_step, steps); }), steps);
        };
        alone.push_back(time(one, of_one)), together.push_back(time(two, of_two));
        latching.push_back(time(memory, of_memory));
      }
      fmt::print("{:>9} {:>5.2f} {:>8.1f} {:>8.2f} {:>8.2f} {:>8.2f} {:>8.2f} {:>8.1f}   {}\n", size.discs(),
                 size.solid_fraction, median(their_two), median_ratio(their_one, their_two), median(together),
                 median_ratio(alone, together), median(latching), median_ratio(their_two, together),
                 of_one == of_two ? "the same bits" : "OTHER BITS");
      std::fflush(stdout);
    }
  }
}

/// Prints the measurements from which list_skin() is tabulated.
void print_skins() {
  constexpr std::array skins{0.1, 0.2, 0.3, 0.4, 0.5, 0.7, 1.0};
  fmt::print("\nns a disc-step of fast by the skin over a diameter, least of three\n\n{:>9} {:>5}", "discs", "phi");
  for (const double skin : skins)
    fmt::print(" {:>7.1f}", skin);
  fmt::print("    best\n");
  for (const double solid_fraction : {0.3, 0.5, 0.75, 0.84, 0.9}) {
    for (const auto& [columns, rows] :
         {std::pair<std::size_t, std::size_t>{10, 10}, {25, 40}, {100, 100}, {250, 400}}) {
      const Size size{columns, rows, solid_fraction};
      const DiscGas gas = mixed(size);
      fmt::print("{:>9} {:>5.2f}", size.discs(), solid_fraction);
      double smallest = std::numeric_limits<double>::infinity(), best = 0.0;
      for (const double skin : skins) {
        double ns = std::numeric_limits<double>::infinity();
        FastDiscSystem system{gas.shapes, gas.box, elastic, skin};
        Discs discs = gas.discs;
        system.begin(discs);
        const long steps = size.steps(3e7);
        for (int round = 0; round < 3; ++round)
          ns = std::min(ns, size.ns(seconds_of([&] { system.advance(discs, gas_step, steps); }), steps));
        if (ns < smallest) smallest = ns, best = skin;
        fmt::print(" {:>7.2f}", ns);
        std::fflush(stdout);
      }
      fmt::print(" {:>7.1f}\n", best);
    }
  }
}

/// True if the discs have the same positions and velocities.
bool same(const Discs& a, const Discs& b) { return a.x == b.x && a.y == b.y && a.vx == b.vx && a.vy == b.vy; }

void print_cell() {
  constexpr long steps = 50000;
  std::vector<double> plain_us, fast_us, bare_us;
  long evaluations = 0, builds = 0, prunings = 0;
  bool same_bits = true;
  // The number of contacts changes during a run, and from one run to another.
  for (std::uint64_t seed = 1; seed <= 8; ++seed) {
    const ShearCell cell = ice_cell(8e3, 5e3, seed);
    const auto law = std::get<LatchingSpring>(cell.law);
    const FilledCell filled = fill(cell);
    const double h = cell.contact_time() / 20.0, skin = cell_skin(cell);
    DiscSystem plain{filled.shapes, filled.box, law, skin};
    FastDiscSystem fast{filled.shapes, filled.box, law, skin};
    BareCell bare{cell, filled, skin};
    Discs plain_discs = filled.discs, fast_discs = filled.discs, bare_discs = filled.discs;
    plain.begin(plain_discs), fast.begin(fast_discs), bare.begin(bare_discs);
    for (int round = 0; round < 5; ++round) {
      const auto us = [&](const std::function<void()>& work) { return 1e6 * seconds_of(work) / steps; };
      const double slow = us([&] {
        for (long n = 0; n < steps; ++n)
          plain.kick(plain_discs, h), plain.drift(plain_discs, h);
      });
      const double quick = us([&] { fast.advance(fast_discs, h, steps); });
      const double alone = us([&] { bare.advance(bare_discs, h, steps); });
      if (round > 0) plain_us.push_back(slow), fast_us.push_back(quick), bare_us.push_back(alone);
    }
    same_bits = same_bits && same(plain_discs, fast_discs) && same(plain_discs, bare_discs);
    evaluations += fast.evaluations(), builds += fast.builds(), prunings += fast.prunings();
  }
  const auto time_text = [](const std::vector<double>& times) {
    return fmt::format("{:.3f} ({:.3f})", median(times), *std::min_element(times.begin(), times.end()));
  };
  fmt::print(
      "Shear cell of 80 discs and 22 of walls at 8 kPa and 5000 d/s, eight seeds, microseconds a step, median and "
      "least: plain {}, fast {}, a loop for this cell alone {}; {}.\n  Of {} steps {} made the list, {} the near "
      "list.\n",
      time_text(plain_us), time_text(fast_us), time_text(bare_us), same_bits ? "the same bits" : "BITS DIFFER",
      evaluations, builds, prunings);
}

/// Prints the gain from skipping time intervals in which no discs can touch.
void print_jumps() {
  struct Of {
    int columns, rows;
    double stiffer;
  };
  for (const Of& of : {Of{10, 8, 1.0}, Of{4, 4, 1.0}, Of{4, 4, 100.0}, Of{4, 4, 1e4}}) {
    std::vector<double> stepped, jumped;
    double fraction = 0.0;
    for (std::uint64_t seed = 1; seed <= 5; ++seed) {
      ShearCell cell = ice_cell(8e3, 5e3, seed);
      cell.law = LatchingSpring{1.7e4 * of.stiffer, 1.7e4 * of.stiffer / 0.49, 0.0};
      cell.block_mass *= (of.columns + 1.0) / cell.wall_discs;
      cell.columns = of.columns, cell.rows = of.rows, cell.wall_discs = of.columns + 1;
      CellPlan plan;
      plan.step = cell.contact_time() / 20.0, plan.end = 2e5 * plan.step, plan.every = plan.end;
      for (const bool jump : {false, true}) {
        plan.jump = jump;
        CellRun run{cell, plan};
        (jump ? jumped : stepped).push_back(seconds_of([&] {
          while (!run.finished())
            run.advance();
        }));
        fraction += static_cast<double>(run.jumped()) / static_cast<double>(run.last_step()) / 5.0;
      }
    }
    fmt::print(
        "Shear cell of {} discs, {:g} times as stiff, with jumps over {:.0f} % of its steps: {:.2f} times as fast.\n",
        of.columns * of.rows, of.stiffer, 100.0 * fraction, median_ratio(stepped, jumped));
  }
}

}  // namespace

int main(int argc, char** argv) {
  if (argc == 6 && std::string{argv[1]} == "--bytes") return print_bytes(argv + 2);
  const std::vector<std::string> requested(argv + 1, argv + argc);
  const auto named = [&](const char* name) {
    return std::find(requested.begin(), requested.end(), name) != requested.end();
  };
  const bool quick = named("--quick"), all = requested.size() == (quick ? 1 : 0);
  const LammpsProgram lammps;
  if (!lammps.there()) fmt::print("LAMMPS is not installed (Debian: apt-get install lammps); Talus alone.\n");
  if (named("--skins")) print_skins();
  if (all || named("--cell")) print_cell(), print_jumps();
  if (all || named("--one")) print_gases(lammps, quick, argv[0]);
  if (all || named("--friction")) print_rough_gases(lammps, quick);
  if (all || named("--two")) print_two_cores(lammps, quick);
}
