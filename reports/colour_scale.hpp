/// Values as colours.
#pragma once

namespace talus::reports {

/// The range of values that colours show; values beyond it have the colour of its end.
struct ColourScale {
  double min{};
  double max{1.0};
  bool two_hues{};  ///< from dark blue over white to dark red; else yellow, orange, red to dark red, ever darker

  /// The colour 0xRRGGBB of a value, in as many steps as the 256 colours of a GIF have room for.
  [[nodiscard]] long colour(double value) const;
};

}  // namespace talus::reports
