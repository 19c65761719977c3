/// Values as colours.
#pragma once

namespace talus::reports {

/// A range of values mapped to colours; values beyond it have the colour of the nearer end.
struct ColourScale {
  double min{};
  double max{1.0};
  bool two_hues{};  ///< from dark blue over white to dark red; else from yellow over orange and red to dark red,
                    ///< increasingly dark

  /// Colour 0xRRGGBB of a value, in as many steps as fit into the 256 colours of a GIF.
  [[nodiscard]] long colour(double value) const;
};

}  // namespace talus::reports
