#pragma once

#include <string>
#include <vector>

#include "verification/problems/program/pictures/picture_script.hpp"
#include "verification/study/program/program_run.hpp"

/// Colours of discs in pictures of a cell beside the numbers of its states.
namespace talus::verification::problems::picture_options {

/// What colours a disc.
enum class DiscValue { speed, force };

/// A cell in one state: positions of its discs and images, and the values that colour them.
struct DiscState {
  struct Disc {
    int number{};  ///< of an image: that of its disc, negative
    double x{}, y{};
    bool wall{};
    double value{};  ///< speed [L/T], or sum of the forces of its contacts [F]
  };
  double time{};
  std::vector<Disc> discs;
};
/// From the states for ParaView.
[[nodiscard]] std::vector<DiscState> disc_states(const std::vector<GeometryState>& states, DiscValue value);

/// The states that a picture shows: those nearest to the times in the titles of its panels.
[[nodiscard]] std::vector<DiscState> shown_states(const Picture& picture, const std::vector<DiscState>& states);

/// Comparison of one picture.
struct ColourErrors {
  int discs{};       ///< free discs that were compared
  double value{};    ///< largest error of a value as read from the colour scale, over the largest value
  double largest{};  ///< relative error of the value at the end of the scale
};
/// Reads the colour of each disc at the bar of the picture, as a user does. `states`: those for whose largest value the
/// scale is made, of one picture or of all frames of a film. `period`: of the cell along x [L]. A disc that is drawn
/// where there is none, or in a colour that is not on the bar, gives NaN.
[[nodiscard]] ColourErrors colour_errors(const Picture& picture, const std::vector<DiscState>& states, double period);

/// Largest force of a contact in all states for ParaView [F].
[[nodiscard]] double largest_force(const std::vector<GeometryState>& states);

/// Whether all panels have a mark for each disc in their window, with the disc's number at its centre, and no other
/// marks. `period`: of the cell along x [L].
[[nodiscard]] bool marks_are_numbers(const Picture& picture, const std::vector<DiscState>& states, double period);

/// Bars of contacts in a picture and their edges: all that has four corners.
struct Bars {
  int count{};
  double longest{};  ///< between the middles of their short sides [L]
  double widest{};   ///< length of a short side [L]
};
[[nodiscard]] Bars contact_bars(const Picture& picture);

}  // namespace talus::verification::problems::picture_options
