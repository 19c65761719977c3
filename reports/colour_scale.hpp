/// Values as colours.
#pragma once

namespace talus::reports {

/// The colour 0xRRGGBB of a place on a scale, 0 its pale and 1 its dark end, beyond them as at the end: yellow, orange,
/// red to dark red, ever darker for every eye. In as many steps as the 256 colours of a GIF have room for. With two
/// hues from dark blue over white to dark red.
[[nodiscard]] long scale_colour(double place, bool two_hues = false);

}  // namespace talus::reports
