#include "verification/check/figure.hpp"

#include <algorithm>
#include <cctype>
#include <cmath>
#include <stdexcept>
#include <utility>

namespace talus::verification {

namespace {

[[noreturn]] void refuse(const Figure& figure, const std::string& what) {
  throw std::invalid_argument("figure '" + figure.name + "': " + what);
}

void demand_well_formed(const Figure& figure, const Series& series) {
  const std::size_t n = series.x.size();
  if (series.label.empty()) refuse(figure, "a series needs a label");
  if (n == 0) refuse(figure, "series '" + series.label + "' has no points");
  if (series.y.size() != n) refuse(figure, "series '" + series.label + "' needs as many y as x");
  const bool bars = !series.y_low.empty() || !series.y_high.empty();
  if (bars && (series.y_low.size() != n || series.y_high.size() != n)) {
    refuse(figure, "series '" + series.label + "' needs as many bar ends as points");
  }
  if (series.values.size() != (series.style == Style::heat ? n : 0)) {
    refuse(figure, "series '" + series.label + "' needs as many values as points if it is a heat map, else none");
  }
}

bool can_be_drawn(double value, const Axis& axis) { return std::isfinite(value) && (!axis.log || value > 0.0); }

/// Removes the points that cannot be drawn and returns their number.
std::size_t prune(Series& series, const Axis& x, const Axis& y) {
  Series kept = series;
  for (auto* const numbers : {&kept.x, &kept.y, &kept.y_low, &kept.y_high, &kept.values})
    numbers->clear();
  const bool bars = !series.y_low.empty();
  for (std::size_t i = 0; i < series.x.size(); ++i) {
    bool draw = can_be_drawn(series.x[i], x) && can_be_drawn(series.y[i], y);
    if (bars) draw = draw && can_be_drawn(series.y_low[i], y) && can_be_drawn(series.y_high[i], y);
    if (!series.values.empty()) draw = draw && std::isfinite(series.values[i]);
    if (!draw) continue;
    kept.x.push_back(series.x[i]);
    kept.y.push_back(series.y[i]);
    if (!series.values.empty()) kept.values.push_back(series.values[i]);
    if (bars) {
      kept.y_low.push_back(series.y_low[i]);
      kept.y_high.push_back(series.y_high[i]);
    }
  }
  const std::size_t left_out = series.x.size() - kept.x.size();
  series = std::move(kept);
  return left_out;
}

}  // namespace

void demand_well_formed(const Figure& figure) {
  const bool plain = std::all_of(figure.name.begin(), figure.name.end(),
                                 [](unsigned char c) { return std::isalnum(c) != 0 || c == '_'; });
  if (figure.name.empty() || !plain) refuse(figure, "the name must be letters, digits and '_'");
  if (figure.title.empty() || figure.caption.empty()) refuse(figure, "a title and a caption are needed");
  if (figure.x.label.empty() || figure.y.label.empty()) refuse(figure, "both axes need a label");
  for (const auto& series : figure.series)
    demand_well_formed(figure, series);
  records::demand_sound(figure, [&](const std::string& part, const std::string& fault) {
    refuse(figure, part.empty() ? fault : part + ": " + fault);
  });
}

std::size_t not_finite(const Figure& figure) {
  std::size_t lost = 0;
  for (const auto& series : figure.series) {
    for (std::size_t i = 0; i < series.x.size(); ++i) {
      bool finite = std::isfinite(series.x[i]) && std::isfinite(series.y[i]);
      if (!series.values.empty()) finite = finite && std::isfinite(series.values[i]);
      if (!series.y_low.empty()) finite = finite && std::isfinite(series.y_low[i]) && std::isfinite(series.y_high[i]);
      if (!finite) ++lost;
    }
  }
  return lost;
}

Figure drawable(Figure figure) {
  std::size_t left_out = 0;
  for (auto& series : figure.series)
    left_out += prune(series, figure.x, figure.y);
  const auto without_points = [](const Series& series) { return series.x.empty(); };
  figure.series.erase(std::remove_if(figure.series.begin(), figure.series.end(), without_points), figure.series.end());
  if (left_out > 0) {
    figure.caption +=
        " (" + std::to_string(left_out) + " points are left out: not positive on a logarithmic axis, or not finite.)";
  }
  return figure;
}

}  // namespace talus::verification
