#pragma once

#include <array>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "solver/base/fields.hpp"
#include "solver/base/vec.hpp"
#include "solver/io/output/run_folder.hpp"
#include "verification/record/figure.hpp"

namespace talus::app {

/// View of a scene.
enum class View {
  side,   ///< x to the right, y up: the plane of motion
  along,  ///< z to the right, y up: front view of the fence; a half fence is drawn with its mirror image
};

/// The region of the scene that a picture shows; limits in the scene's unit of length.
struct Window {
  double left{}, bottom{}, right{}, top{};
};

/// Drawing options of a frame.
struct FrameStyle {
  View view{View::side};
  Window window;
  bool numbers{false};  ///< of elements or discs
  bool grid{true};
  std::vector<int> divisions;  ///< of the grid; empty: round numbers
};

/// The frame that a figure shows.
struct ShownFrame {
  std::size_t number{};
  double time{};
  std::string abscissa{"x"};  ///< label of the axis to the right
};

/// A frame as a figure, with equal axes over the style's window and the time as title. The figure's name is the view's
/// name followed by the frame number.
[[nodiscard]] records::Figure frame_figure(const RunFolder& run, const FrameStyle& style, const ShownFrame& frame,
                                           std::vector<records::Series> series, std::vector<records::Mark> marks);

/// A series without points.
[[nodiscard]] records::Series frame_series(const std::string& label, records::Style style, records::Look look);

/// Adds a polyline to a series of shapes.
void add_polyline(records::Series& shapes, const std::vector<Vec2>& points);

/// Colour scale from 0 to the largest value, for a page; nothing if the largest value is zero.
[[nodiscard]] std::optional<records::Scale> colour_scale(const std::string& label, const std::string& unit,
                                                         double largest);

}  // namespace talus::app

namespace talus {
template <>
struct Names<app::View> {
  static constexpr std::array<std::string_view, 2> list{"side", "along"};
};
}  // namespace talus
