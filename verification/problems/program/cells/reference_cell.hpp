#pragma once

#include <array>
#include <cstddef>
#include <string>
#include <vector>

#include "verification/check/case.hpp"
#include "verification/reference/many_bodies/virtual_discs.hpp"

/// The cell of the case `cell_files`, moved by the second program, and what its files must contain.
namespace talus::verification::problems::cell_files {

using reference::VirtualDiscs;

/// Parameters of the deck, in SI units.
inline constexpr int rows = 4, columns = 5, wall_discs = 6;
inline constexpr std::size_t free_discs = rows * columns, all_discs = free_discs + 2 * wall_discs;
inline constexpr double k1 = 1.7e4, k2 = k1 / 0.49, diameter = 1e-3, mass = 7.2e-7, gravity = 9.81, block_mass = 5e-3,
                        block_speed = 5.0, width = wall_discs * diameter, half = 0.5 * width;
inline constexpr double area = width * diameter;  ///< reference area of the stresses on the walls
inline constexpr double step = 3e-7;
inline constexpr int steps_in_loop = 120, steps = 16 * steps_in_loop + 90;  // the last LOOP is incomplete
/// Contacts are sampled every half contact time (20 of these steps), layers at every eighth sample (a look).
inline constexpr int steps_in_sample = 20, samples_in_look = 8;
inline constexpr double loop = steps_in_loop * step, end = steps * step;
/// The first quarter of a run is excluded from means.
inline constexpr double start_up = 0.25 * end;
/// Elapsed time and cycles in RESTART.DAT.
inline constexpr double elapsed = 0.01234;
inline constexpr long cycles = 41000;

/// Bound of the difference between the program's motion and that of the second program.
[[nodiscard]] Tolerance of_paths();

/// The position nearest to the middle of the cell among those of a disc and its images [L].
[[nodiscard]] double wrapped(double x);

/// Initial state: free discs, base and block at the elapsed time; the block is lowered until it touches.
[[nodiscard]] VirtualDiscs start();
/// The files of 1989 with the parameters and the initial state.
[[nodiscard]] std::string control_text(const Setup& setup);
[[nodiscard]] std::string restart_text(const VirtualDiscs& discs, const Setup& setup);

/// Averaged quantities, in the order of the columns of history.csv; from `moment` on for the summary only.
enum Quantity : std::size_t {
  top_shear,
  top_normal,
  bottom_shear,
  bottom_normal,
  depth,
  solid_fraction,
  touching,
  coordination,
  moment,  ///< shear on the block times the height of its centre line above that of the base
  depth_square,
  contacts,
  multiple,  ///< contacts with a free disc that has another contact
  shear,     ///< stresses of contacts times the height of the field
  normal,
  multiple_shear,
  multiple_normal,
  kinetic,  ///< shear transported by moving discs times the height of the field
  count,
};
using Values = std::array<double, count>;

/// Weighted means.
struct Mean {
  Values sum{};
  double weight{};
  void add(const Values& values, double time) {
    weight += time;
    for (std::size_t k = 0; k < count; ++k)
      sum[k] += time * values[k];
  }
  double operator()(Quantity quantity) const { return sum[quantity] / weight; }
};

/// A disc in one sample of the layers.
struct Seen {
  double time{};    ///< of the sample, since the start [T]
  double weight{};  ///< time that the sample represents [T]
  double y{}, vx{}, vy{};
};

/// Discs and contacts at an output.
struct State {
  VirtualDiscs discs;
  std::vector<bool> multiple;  ///< of each contact
};

/// Expected contents of the files, from the reference's motion.
struct Expected {
  std::vector<Mean> loops;
  Mean steady;                                            ///< after the start-up
  std::vector<Mean> hundredths = std::vector<Mean>(100);  ///< of the run
  std::vector<Seen> seen;
  std::vector<double> weights;  ///< time represented by the looks in each tenth of the time after the start-up [T]
  std::vector<State> states;    ///< at the end of each LOOP and of the run
  double largest_overlap{}, largest_fraction{};
  double work{};  ///< work of the drive of the block [F L]
};

/// The contacts that act in a state, with their history at that time, and which of them are multiple.
[[nodiscard]] State state_of(const VirtualDiscs& discs);

/// Height of the block above the base [L].
[[nodiscard]] double height_of(const VirtualDiscs& discs);
[[nodiscard]] double fraction_of(const VirtualDiscs& discs);

/// Index of the part that contains `time`, of `parts` equal parts of `whole`.
[[nodiscard]] std::size_t part(double time, double whole, int parts);

/// The motion of all steps, sampled as the program says.
[[nodiscard]] Expected expected_of(VirtualDiscs discs, const Setup& setup);

}  // namespace talus::verification::problems::cell_files
