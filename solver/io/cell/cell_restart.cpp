#include "solver/io/cell/cell_restart.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <vector>

#include "solver/base/error.hpp"
#include "solver/cell/cell_run.hpp"
#include "solver/granular/neighbour_list.hpp"
#include "solver/io/file/fortran.hpp"
#include "solver/io/file/list_directed.hpp"
#include "solver/io/file/toml_document.hpp"

namespace talus {
namespace {

constexpr double maximum_cycles = 1e15;
constexpr double largest_coordinate = 1e6;  ///< of a position [widths]: beyond it a double has too few digits

/// Position along x mapped into the field, [-width/2, width/2).
double in_field(double x, double width) { return x - width * std::floor(x / width + 0.5); }

/// Distance along x, with sign, between nearest images.
double across(double dx, double width) { return dx - width * std::round(dx / width); }

/// Lowest height of the block's centre line at which none of its discs overlaps a free disc [L].
double block_height(const ShearCell& cell, const Discs& discs) {
  double height = discs.y[cell.free_discs()] + cell.diameter;
  for (std::size_t i = 0; i < cell.free_discs(); ++i) {
    for (std::size_t j = first_block_disc(cell); j < discs.size(); ++j) {
      const double dx = across(discs.x[j] - discs.x[i], cell.width());
      if (std::abs(dx) < cell.diameter)
        height = std::max(height, discs.y[i] + std::sqrt(cell.diameter * cell.diameter - dx * dx));
    }
  }
  return height;
}

/// Calls visit(first, second, overlap) for each pair of discs that overlap; overlap > 0 [L].
template <class Visit>
void for_each_overlap(const ShearCell& cell, const FilledCell& filled, Visit&& visit) {
  NeighbourList list{filled.box, 0.3 * cell.diameter};
  Discs discs = filled.discs;
  wrap(filled.box, discs);
  list.build(filled.shapes, discs);
  list.for_each_pair(discs, [&](std::size_t a, std::size_t b, std::size_t, Vec2 d, const auto&) {
    if (const double overlap = cell.diameter - norm(d); overlap > 0.0) visit(a, b, overlap);
  });
}

/// Name of a disc in messages.
std::string disc_text(const ShearCell& cell, std::size_t disc) {
  return disc < cell.free_discs()        ? fmt::format("disc {}", disc + 1)
         : disc < first_block_disc(cell) ? "the base"
                                         : "the block";
}

}  // namespace

CellRestart read_cell_restart(std::string_view text, std::string_view name, const ShearCell& cell) {
  CellRestart restart{.start = fill(cell)};
  ListDirected input{text};
  const auto real = [&](const std::string& field) {
    const auto fail = [&](std::string_view message) {
      throw InputError{fmt::format("{}:{}: {}: {}", name, std::max(input.line(), 1), field, message)};
    };
    double number = 0.0;
    try {
      const std::string_view value = input.value();
      if (!parse_fortran_real(value, number)) throw InputError{found_text(value) + "; it must be a number"};
    } catch (const InputError& error) {
      fail(error.what());
    }
    return number;
  };
  Discs& discs = restart.start.discs;
  input.start_record();
  discs.t = real("elapsed time");
  if (discs.t < 0.0)
    throw InputError{fmt::format("{}:{}: elapsed time: found {}; it must be >= 0", name, input.line(), discs.t)};
  const double cycles = real("cycles");
  if (cycles < 0.0 || cycles > maximum_cycles || cycles != std::floor(cycles)) {
    throw InputError{fmt::format("{}:{}: cycles: found {}; it must be a whole number between 0 and {:g}", name,
                                 input.line(), cycles, maximum_cycles)};
  }
  restart.cycles = static_cast<long>(cycles);
  std::vector<int> lines;
  for (std::size_t i = 0; i < cell.free_discs(); ++i) {
    input.start_record();
    const auto of = [&](const char* part) { return fmt::format("disc {}: {}", i + 1, part); };
    discs.x[i] = real(of("x")), discs.y[i] = real(of("y"));
    if (std::abs(discs.x[i]) > largest_coordinate * cell.width()) {
      throw InputError{fmt::format("{}:{}: {}: found {}; it must be within {:g} widths of the field", name,
                                   input.line(), of("x"), discs.x[i], largest_coordinate)};
    }
    discs.vx[i] = real(of("vx")), discs.vy[i] = real(of("vy"));
    lines.push_back(input.line());
    if (discs.y[i] <= discs.y[cell.free_discs()]) {
      throw InputError{fmt::format("{}:{}: {}: found {}; it must be above the base's centre line, 0", name,
                                   input.line(), of("y"), discs.y[i])};
    }
  }
  if (const int more = input.next_line(); more != 0) {
    throw InputError{
        fmt::format("{}:{}: found an additional record; it must contain the {} free discs of the cell, one per record",
                    name, more, cell.free_discs())};
  }
  for (std::size_t j = first_block_disc(cell); j < discs.size(); ++j)
    discs.x[j] = in_field(discs.x[j] + cell.block_speed * discs.t, cell.width());
  const double height = block_height(cell, discs);
  std::fill(discs.y.begin() + static_cast<std::ptrdiff_t>(first_block_disc(cell)), discs.y.end(), height);
  for_each_overlap(cell, restart.start, [&](std::size_t a, std::size_t b, double overlap) {
    if (overlap > CellRun::deepest * cell.diameter) {
      // The error is reported at the later record of the pair; discs of a wall have no record.
      const std::size_t disc = b < cell.free_discs() ? b : a;
      throw InputError{fmt::format("{}:{}: disc {}: found it {:.4g} diameters inside {}; it must be at most {}", name,
                                   lines[disc], disc + 1, overlap / cell.diameter, disc_text(cell, disc == b ? a : b),
                                   CellRun::deepest)};
    }
    ++restart.forgotten;
  });
  return restart;
}

CellRestart read_cell_restart(const std::filesystem::path& file, const ShearCell& cell) {
  return read_cell_restart(read_text(file), file.string(), cell);
}

std::string cell_restart_text(const ShearCell& cell, const Discs& discs, long cycles) {
  std::string text = fmt::format("{} {}\n", discs.t, cycles);
  for (std::size_t i = 0; i < cell.free_discs(); ++i)
    fmt::format_to(std::back_inserter(text), "{} {} {} {}\n", discs.x[i], discs.y[i], discs.vx[i], discs.vy[i]);
  return text;
}

std::string cell_picture_text(const ShearCell& cell, const Discs& discs) {
  std::string text;
  const double half = 0.5 * cell.width(), radius = 0.5 * cell.diameter;
  for (std::size_t i = 0; i < discs.size(); ++i) {
    const double x = in_field(discs.x[i], cell.width());
    const auto number = static_cast<long>(i) + 1;
    fmt::format_to(std::back_inserter(text), "{} {} {}\n", number, x, discs.y[i]);
    if (x + radius > half)
      fmt::format_to(std::back_inserter(text), "{} {} {}\n", -number, x - cell.width(), discs.y[i]);
    if (x - radius < -half)
      fmt::format_to(std::back_inserter(text), "{} {} {}\n", -number, x + cell.width(), discs.y[i]);
  }
  return text;
}

}  // namespace talus
