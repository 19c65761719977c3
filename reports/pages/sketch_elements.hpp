#pragma once

#include <cstddef>
#include <set>
#include <string>
#include <vector>

/// What a sketch is made of: strokes and labels, and the elements that they draw.
namespace talus::reports {

/// Position on paper [cm], y upwards.
struct SketchPoint {
  double x{}, y{};
};

/// A line through points, or the outline of a filled shape.
struct Stroke {
  std::vector<SketchPoint> points;
  std::string fill{};    ///< colour; empty if not filled
  std::string colour{};  ///< of the line; empty if there is none
  double width{1.0};     ///< of the line, relative to gnuplot's standard width
  bool dashed{};
};

/// A label, written as gnuplot_text() accepts.
struct SketchLabel {
  enum class Side { centre, left, right };  ///< part of the label that is at the position
  std::string text;
  SketchPoint at;
  Side side{};
  bool boxed{};  ///< on a white ground
  std::string colour{};
};

/// A sketch in the order of drawing; labels are above all strokes.
struct Sketch {
  std::vector<Stroke> strokes;
  std::vector<SketchLabel> labels;
  SketchPoint low, high;  ///< limits, with a margin
};

inline SketchPoint operator+(SketchPoint a, SketchPoint b) { return {a.x + b.x, a.y + b.y}; }
inline SketchPoint operator-(SketchPoint a, SketchPoint b) { return {a.x - b.x, a.y - b.y}; }

/// A line of the sketch, split into its parts. Lengths are on paper.
struct SketchElement {
  std::string keyword;
  std::vector<double> numbers;
  std::set<std::string> flags;
  std::vector<std::string> labels;

  [[nodiscard]] SketchPoint point(std::size_t i) const { return {numbers[i], numbers[i + 1]}; }
  [[nodiscard]] std::vector<SketchPoint> points() const {
    std::vector<SketchPoint> all;
    for (std::size_t i = 0; i + 1 < numbers.size(); i += 2)
      all.push_back(point(i));
    return all;
  }
  [[nodiscard]] double number_or(std::size_t i, double substitute) const {
    return i < numbers.size() ? numbers[i] : substitute;
  }
  [[nodiscard]] std::string label() const { return labels.empty() ? "" : labels.front(); }
  [[nodiscard]] bool has(const char* flag) const { return flags.contains(flag); }
};

/// Adds elements to a sketch, one function for each kind.
class SketchDrawer {
 public:
  explicit SketchDrawer(Sketch& sketch) : sketch_{sketch} {}

  void body(const SketchElement& e);
  void ground(const SketchElement& e);
  void anchor(const SketchElement& e);
  void pin(const SketchElement& e);
  void dot(const SketchElement& e);
  void centre(const SketchElement& e);
  void line(const SketchElement& e);
  void spring(const SketchElement& e);
  void dashpot(const SketchElement& e);
  void arrow(const SketchElement& e);
  void turn(const SketchElement& e);
  void dimension(const SketchElement& e);
  void axes(const SketchElement& e);
  void text(const SketchElement& e);

 private:
  static constexpr const char* ink = "#222222";

  void stroke(Stroke&& stroke);
  void include(SketchPoint point);
  void disc(SketchPoint centre, double radius, const char* fill, const char* colour, double width);
  void head(SketchPoint tip, SketchPoint along, const char* colour, double size);
  void label(const std::string& text, SketchPoint at, SketchLabel::Side side, bool boxed = false,
             const char* colour = ink);
  /// The element's label beside the middle of a line, `distance` from it.
  void label_beside(const SketchElement& e, const std::vector<SketchPoint>& points, double distance = 0.22);

  Sketch& sketch_;
};

}  // namespace talus::reports
