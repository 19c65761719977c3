/// Figures as gnuplot scripts. A script holds its numbers and reads no other file than the preamble.
#pragma once

#include <filesystem>
#include <set>
#include <string>

#include "reports/colour_scale.hpp"
#include "reports/plot.hpp"

namespace talus::reports {

/// Width of all pictures but those of a canvas that says otherwise.
inline constexpr double centimetres_wide = 15.0;

/// Size of the letters: on paper as a scale of 12 points, in an SVG in pixels, of which 760 are 15 cm. (A PNG has one
/// size.)
struct Letters {
  double paper{0.5};
  double svg{13.0};
};

/// Where and in which formats (ps, pdf, svg, png) a script draws.
struct Canvas {
  std::filesystem::path preamble;   ///< gnuplot/preamble.gp
  std::filesystem::path folder;     ///< of the pictures
  std::set<std::string> formats{};  ///< each picture is drawn once for each
  double width{centimetres_wide};   ///< [cm]
  double height{7.6};               ///< of a figure without the rows of its key [cm]
  Letters letters{};                ///< of a figure
};

/// `set xtics` (axis 'x' or 'y') for a log axis, each place written out: powers of ten where there are two or more,
/// else 1-2-5 numbers.
[[nodiscard]] std::string log_tics(char axis, const Extent& extent);

/// The commands that draw `body` (a complete `plot` command) as folder/stem.<format> in each format;
/// height is in centimetres.
[[nodiscard]] std::string drawn_in_each_format(const Canvas& canvas, const std::string& stem, const std::string& body,
                                               double height, Letters letters = {});

/// What draws one plot between its margins.
struct Panel {
  std::string settings;    ///< its numbers as data blocks, axes, labels
  std::string curves;      ///< what `plot` is given
  std::size_t in_key{};    ///< entries of the key
  std::size_t key_rows{};  ///< rows of the key where it may be as wide as a picture
};

/// The parts of a plot's script; the names of its data blocks begin with `prefix`, and `scale` colours its values. The
/// key may be as wide as the canvas.
[[nodiscard]] Panel panel_of(const Plot& plot, const std::string& prefix, const ColourScale& scale,
                             const Canvas& canvas);

/// The commands that draw the plot as folder/stem.<format>.
[[nodiscard]] std::string figure_script(const Plot& plot, const Canvas& canvas, const std::string& stem);

/// The commands that draw error/bound of all checks: a row a case, a dot a check, lines at 1 and 1/50; checks without
/// error (exact ones among them) stand in a strip of their own at the left, infinite or NaN ones at the right.
[[nodiscard]] std::string margin_script(const Results& results, const Canvas& canvas, const std::string& stem);

}  // namespace talus::reports
