#pragma once

#include <filesystem>
#include <string>
#include <string_view>

#include "solver/cell/shear_cell.hpp"

namespace talus {

/// Discs as the thesis's restart holds them: positions and velocities, elapsed time and cycles (Lacy 1989, "Data Input
/// and Parameters"). It has neither the block nor what contacts remember, so that a run goes on from it, but not as it
/// would have gone on.
struct CellRestart {
  FilledCell start;
  long cycles{};            ///< steps of the run that left it
  std::size_t forgotten{};  ///< contacts, those with walls too, whose largest overlap is not known any more
};

/// Reads RESTART.DAT: elapsed time and cycles on the first record, then x, y, vx, vy of each free disc on one of its
/// own (the thesis does not tell the order: it is ours). The block is set down without speed where it first touches a
/// disc, and along x where its drive has brought it. Errors: IoError; InputError with file, line, field, what was found
/// and what is allowed: also for discs that overlap by more than a tenth of a diameter, as no flow of hard discs leaves
/// them, and for records behind the last disc's.
[[nodiscard]] CellRestart read_cell_restart(const std::filesystem::path& file, const ShearCell& cell);
[[nodiscard]] CellRestart read_cell_restart(std::string_view text, std::string_view name, const ShearCell& cell);

/// RESTART.DAT of these discs; every number in the fewest digits that give the same double back.
[[nodiscard]] std::string cell_restart_text(const ShearCell& cell, const Discs& discs, long cycles);

/// PIC.DAT: a line `id x y` for each disc that is within the field or touches it, the free ones first, then base and
/// block, from 1; the image of a disc across the border has the negative of its number (Lacy 1989, "Virtual Elements
/// and Periodic Boundaries", "Output and Graphics").
[[nodiscard]] std::string cell_picture_text(const ShearCell& cell, const Discs& discs);

}  // namespace talus
