#pragma once

#include <filesystem>
#include <string>
#include <string_view>

#include "solver/cell/shear_cell.hpp"

namespace talus {

/// The discs of a restart file as the thesis defines it: positions and velocities, elapsed time and cycles (Lacy 1989,
/// "Data Input and Parameters"). The file has neither the block nor the history of the contacts: a run can continue
/// from it, but differs from the uninterrupted run.
struct CellRestart {
  FilledCell start;
  long cycles{};            ///< steps of the run that wrote it
  std::size_t forgotten{};  ///< contacts, including those with walls, whose largest overlap is lost
};

/// Reads RESTART.DAT: a record with elapsed time and cycles, then one record with x, y, vx, vy for each free disc (the
/// thesis does not state the order; this one is a choice of Talus). The block is placed without vertical speed at the
/// lowest height at which it overlaps no disc, and along x where its drive has moved it. Errors: IoError; InputError
/// with file, line, field, what was found and what is allowed, also for discs that overlap by more than a tenth of a
/// diameter, which does not happen in a flow of hard discs, and for records after that of the last disc.
[[nodiscard]] CellRestart read_cell_restart(const std::filesystem::path& file, const ShearCell& cell);
[[nodiscard]] CellRestart read_cell_restart(std::string_view text, std::string_view name, const ShearCell& cell);

/// Text of RESTART.DAT for these discs; each number has the fewest digits from which the same double is read.
[[nodiscard]] std::string cell_restart_text(const ShearCell& cell, const Discs& discs, long cycles);

/// Text of PIC.DAT: a line `id x y` for each disc, numbered from 1: first the free discs, then base and block. A disc
/// that crosses a border of the field has another line for its image there, with the negative of its number (Lacy 1989,
/// "Virtual Elements and Periodic Boundaries", "Output and Graphics").
[[nodiscard]] std::string cell_picture_text(const ShearCell& cell, const Discs& discs);

}  // namespace talus
