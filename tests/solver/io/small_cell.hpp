#pragma once

#include "solver/cell/cell_run.hpp"

namespace talus {

/// Three rows of four discs between walls of five, compressed within a few contact times.
inline const ShearCell small_cell{.law = LatchingSpring{1e4, 2e4, 0.0},
                                  .diameter = 1.0,
                                  .mass = 1.0,
                                  .gravity = 9.81,
                                  .block_mass = 50.0,
                                  .rows = 3,
                                  .columns = 4,
                                  .wall_discs = 5,
                                  .block_speed = 2.0,
                                  .seed = 4};

/// The cell at its start, with a plan of this many steps, twenty per contact time.
inline CellRun small_cell_run(double steps) {
  const double step = small_cell.contact_time() / 20.0;
  return {small_cell, {.step = step, .every = steps * step, .end = steps * step}};
}

}  // namespace talus
