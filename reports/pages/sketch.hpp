/// Sketches of problems in one style: bodies, supports, cables, arrows and dimensions, one element per line, in a
/// page's Markdown as a code block that begins with ```sketch and an alternative text.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "reports/figures/gnuplot_script.hpp"
#include "reports/pages/sketch_elements.hpp"

namespace talus::reports {

/// Reads a sketch. Each line is a keyword, its numbers [cm; degrees, counter-clockwise], flags, and a label in double
/// quotes; empty lines and lines that begin with # are skipped. Keywords, with brackets around what may be omitted:
///
///   unit CM                                 length on paper of one unit of all that follows; 1 without it
///   disc X Y RADIUS                         a body; label at its centre
///   box X Y WIDTH HEIGHT [ANGLE]            a body, given by its centre
///   superellipse X Y A B EXPONENT [ANGLE]   a body, given by its centre, half axes and exponent
///   polygon X Y X Y X Y ...                 a body
///   ground X Y X Y ...                      a fixed surface; hatched to the right of its direction
///   anchor X Y [ANGLE]                      a fixed support in the direction ANGLE from the point (90: above it)
///   pin X Y                                 a hinge
///   centre X Y                              a centre of mass; label to its right
///   dot X Y                                 a particle or point; label to its right
///   cable X Y X Y ...                       a cable
///   spring X Y X Y, dashpot X Y X Y         elements of a contact or coupling
///   line X Y X Y ...                        a thin line
///   curve X Y X Y ...                       a smooth line through the points
///   velocity X Y DX DY, force X Y DX DY     an arrow from X, Y; label beyond its tip
///   turn X Y RADIUS FROM TO                 an arrow around X, Y; label beside its middle
///   dimension X Y X Y                       a length between two points; label in its middle
///   axes X Y LENGTH "x" "y"                 axes of coordinates
///   text X Y "label"                        a label, centred or with the flag left or right
///
/// Flags of bodies: held (a fixed body), ghost (another position of a body: dashed, not filled); of lines, curves and
/// cables: dashed; of cables, springs, dashpots, lines, curves and dimensions: below (the label is to the right of the
/// direction instead of to the left).
/// Throws RecordError with the line's number, what was found and what is allowed; also for a sketch without elements
/// and for one wider than a page's text or higher than half a page.
[[nodiscard]] Sketch read_sketch(const std::string& text);

/// Commands that draw the sketch as folder/stem.<format>, one unit as one centimetre.
[[nodiscard]] std::string sketch_script(const Sketch& sketch, const Canvas& canvas, const std::string& stem);

/// A sketch in a page.
struct PageSketch {
  std::size_t begin{}, end{};  ///< its code block within the page's text
  std::string title;           ///< alternative text
  Sketch drawing;
};

/// The sketches of a page. Throws RecordError if one cannot be read, has no alternative text, or does not end.
[[nodiscard]] std::vector<PageSketch> page_sketches(const std::string& page);

/// File stem of the picture of a case's sketch, counted from 0.
[[nodiscard]] std::string sketch_stem(const std::string& case_id, std::size_t index);

/// The page with each sketch replaced by its picture in figures/. Throws as page_sketches() does.
[[nodiscard]] std::string with_sketch_pictures(const std::string& page, const std::string& case_id);

}  // namespace talus::reports
