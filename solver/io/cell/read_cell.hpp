#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>

#include "solver/base/units.hpp"
#include "solver/cell/cell_plan.hpp"
#include "solver/io/file/toml_document.hpp"

namespace talus {

/// A shear cell as described by its file.
struct CellScene {
  std::string title;
  std::optional<UnitSystem> units;  ///< empty if none was given: CNTRL.DAT has no units
  ShearCell cell;
  CellPlan plan;
  bool restart{};   ///< RESTRT: the discs are read from RESTART.DAT in the folder of the file
  bool pictures{};  ///< GRAPH: PIC.DAT and the series of pictures are written
};

/// Largest seed: files store it as a double, which cannot represent all whole numbers beyond it.
inline constexpr std::int64_t maximum_seed = (std::int64_t{1} << 53U) - 1;

/// Options of the command line that override the file, or supplement CNTRL.DAT, which has no fields for them.
struct CellChoices {
  std::optional<std::string> integrator{};
  std::optional<UnitSystem> units{};  ///< of CNTRL.DAT only
  std::optional<std::uint64_t> seed{};
  bool historical{};
  bool jump{};
  bool virtual_discs{};
};

/// Reads a cell from CNTRL.DAT (any file that ends in .DAT) or else from a TOML file.
///
/// CNTRL.DAT holds 15 numbers in list-directed records, in this order (Lacy 1989, "Data Input and Parameters"):
/// `RESTRT GRAPH`, `K1 K2 D M G MTOP`, `NHT NWID TWID VXT`, `STEP LOOP TIME`. The TOML file has `title`, `units`,
/// [cell] with the fields of ShearCell, its `law` (by default a latching spring) and that law's fields (`restitution`
/// may replace unloading_stiffness or damping, `overburden` may replace block_mass), `friction` with `shear_stiffness`,
/// and `seed`; and [run] with the fields of CellPlan and `pictures`.
///
/// Errors: IoError; InputError with file, line, field, what was found and what is allowed, for input that cannot be
/// read and for all validation_errors of the cell.
[[nodiscard]] CellScene read_cell(const std::filesystem::path& file, const CellChoices& choices);
/// The same from a text; `name` is the file named in errors.
[[nodiscard]] CellScene read_cell(std::string_view text, std::string_view name, const CellChoices& choices);
/// The same from a parsed TOML text.
[[nodiscard]] CellScene read_cell(const TomlValue& document, std::string_view name, const CellChoices& choices);

/// Whether a file describes a cell and not bodies: a TOML file with [cell], a file named CNTRL.DAT, or a .DAT file of
/// 15 numbers and nothing else. Errors: IoError; InputError for a text that is not TOML.
[[nodiscard]] bool describes_cell(const std::filesystem::path& file);
/// The same of the text of a file.
[[nodiscard]] bool describes_cell(std::string_view text, const std::filesystem::path& file);
/// The same of a parsed TOML text.
[[nodiscard]] bool describes_cell(const TomlValue& document);

}  // namespace talus
