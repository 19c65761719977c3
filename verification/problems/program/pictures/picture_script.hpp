#pragma once

#include <array>
#include <map>
#include <set>
#include <string>
#include <vector>

/// Commands of gnuplot that draw a picture, as the program writes them and recorder/gnuplot records them.
namespace talus::verification::problems::picture_options {

using Point = std::array<double, 2>;

struct Curve {
  std::string name{};  ///< of its data block
  std::string label{};
  std::vector<std::vector<Point>> lines{};  ///< separated by empty rows
  std::vector<Point> bars{};                ///< lower and upper end of the bar of each point that has one, in order
};

struct Panel {
  std::string title{}, x_label{}, y_label{};
  std::vector<double> x_range{}, y_range{}, x_tics{}, y_tics{};
  bool grid = true;
  double left{};  ///< margin
  std::vector<Curve> curves{};
  std::map<std::string, Point> marks{};
};

/// The bar that explains the colours of a picture.
struct ColourBar {
  /// A rectangle: its ends, as fractions of the width of the picture, and its colour.
  struct Part {
    double left{}, right{};
    long colour{};
  };
  std::vector<Part> parts{};
  std::vector<Point> numbers{};  ///< numbers below the bar: position, as above, and value

  /// Value at a position, by the line through the first and the last number; NaN without two numbers.
  [[nodiscard]] double value_at(double position) const;
};

struct Picture {
  std::string terminal{};         ///< "svg" of "set terminal svg ..."; empty in a part of a picture
  std::set<std::string> texts{};  ///< title and label of the colour scale
  ColourBar bar{};
  std::vector<Panel> panels{};
};

/// Environment in which the program finds the recorders in place of gnuplot and pdflatex: pictures are then their
/// commands, and a page is its text.
[[nodiscard]] std::map<std::string, std::string> recorded_pictures();

/// Text between the first `before` and the next `after`; empty if there is none.
[[nodiscard]] std::string between(const std::string& text, const std::string& before, const std::string& after);

/// Reads the commands of a picture, or of one of its frames.
[[nodiscard]] Picture read_picture(const std::string& script);

/// The parts of a film's or page's commands between "set multiplot" and "unset multiplot".
[[nodiscard]] std::vector<std::string> pages(const std::string& script);

/// The commands of a picture without those of its format: dates, terminal and size.
[[nodiscard]] std::string drawn_content(const std::string& script);

}  // namespace talus::verification::problems::picture_options
