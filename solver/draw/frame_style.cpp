#include "solver/draw/frame_style.hpp"

#include <fmt/format.h>

#include <nlohmann/json.hpp>
#include <utility>

namespace talus::app {

using Json = nlohmann::ordered_json;

Json frame_figure(const RunFolder& run, const FrameStyle& style, const ShownFrame& frame, Json series, Json marks) {
  const std::string length = run.unit(dimension::length), time = run.unit(dimension::time);
  const Window& window = style.window;
  const auto axis = [&](const std::string& words, double low, double high, std::size_t which) {
    return Json{{"label", words},
                {"unit", length},
                {"min", low},
                {"max", high},
                {"divisions", style.divisions.empty() ? 0 : style.divisions[which]}};
  };
  return {{"name", fmt::format("{}{}", style.view == View::side ? "side" : "along", frame.number)},
          {"title", fmt::format("t = {:.4g}{}{}", frame.time, time.empty() ? "" : " ", time)},
          {"x", axis(frame.abscissa, window.left, window.right, 0)},
          {"y", axis("y", window.bottom, window.top, 1)},
          {"csv", frame.csv_file},
          {"grid", style.grid},
          {"equal", true},
          {"marks", std::move(marks)},
          {"series", std::move(series)}};
}

Json colour_scale(const std::string& words, const std::string& unit, double largest) {
  if (!(largest > 0.0)) return nullptr;
  return {{"label", words}, {"unit", unit}, {"min", 0.0}, {"max", largest}};
}

}  // namespace talus::app
