/// Figures as gnuplot scripts. A script contains its numbers and reads no file except the preamble.
#pragma once

#include <filesystem>
#include <set>
#include <string>

#include "reports/figures/colour_scale.hpp"
#include "reports/figures/plot.hpp"

namespace talus::reports {

/// Default width of pictures; a Canvas may specify another.
inline constexpr double centimetres_wide = 15.0;

/// Font size: on paper as a scale of 12 points, in an SVG in pixels, of which 760 are 15 cm. (A PNG has one size.)
struct Letters {
  double paper{0.5};
  double svg{13.0};
};

/// Where and in which formats (ps, pdf, svg, png) a script draws.
struct Canvas {
  std::filesystem::path preamble;   ///< gnuplot/preamble.gp
  std::filesystem::path folder;     ///< of the pictures
  std::set<std::string> formats{};  ///< each picture is drawn once per format
  double width{centimetres_wide};   ///< [cm]
  double height{7.6};               ///< of a figure without the rows of its key [cm]
  Letters letters{};                ///< of a figure
};

/// `set xtics` (axis 'x' or 'y') for a log axis, each position listed explicitly: powers of ten if there are two or
/// more, else 1-2-5 numbers.
[[nodiscard]] std::string log_tics(char axis, const Extent& extent);

/// Commands that draw `body` (a complete `plot` command) as folder/stem.<format> in each format; height in centimetres.
[[nodiscard]] std::string drawn_in_each_format(const Canvas& canvas, const std::string& stem, const std::string& body,
                                               double height, Letters letters = {});

/// Commands that draw one plot within its margins.
struct Panel {
  std::string settings;    ///< its numbers as data blocks, axes, labels
  std::string curves;      ///< argument of `plot`
  std::size_t in_key{};    ///< number of key entries
  std::size_t key_rows{};  ///< rows of the key if it may be as wide as a picture
};

/// Number of letters in a line of that length [cm], on average.
[[nodiscard]] std::size_t letters_along(double length, const Letters& letters);

/// The parts of a plot's script; the names of its data blocks begin with `prefix`, and `scale` maps its values to
/// colours. The key may be as wide as the canvas. A title of the y axis of more than `maximum` letters has several
/// lines.
[[nodiscard]] Panel panel_of(const Plot& plot, const std::string& prefix, const ColourScale& scale,
                             const Canvas& canvas, std::size_t maximum);

/// Commands that draw the plot as folder/stem.<format>.
[[nodiscard]] std::string figure_script(const Plot& plot, const Canvas& canvas, const std::string& stem);

/// Commands that draw error/bound of all checks: one row per case, one dot per check, lines at 1 and 1/50; checks
/// without error (including exact ones) are drawn in a separate strip at the left, infinite or NaN ones at the right.
[[nodiscard]] std::string margin_script(const Results& results, const Canvas& canvas, const std::string& stem);

}  // namespace talus::reports
