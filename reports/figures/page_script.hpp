/// Pages of figures, and animations of pages, as gnuplot scripts.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "reports/figures/gnuplot_script.hpp"
#include "reports/figures/pictures.hpp"

namespace talus::reports {

/// A page with the data needed to draw its panels.
struct PagePlot {
  Page page;  ///< without its panels
  std::vector<Plot> panels;
  std::optional<double> panel_high{};  ///< [cm]; chosen from the width if absent
  bool two_hues{};                     ///< colour scale from blue to red, else from pale to dark
};

/// The plots of a page whose figures contain their points; throws as plot_of() does.
[[nodiscard]] PagePlot page_plot_of(Page page);

/// The page of a figure with panels, whose points are read from its CSV file in `folder`. The panels have no key,
/// because their titles and the caption explain them; lines over heat maps are black. Throws as plot_of() does.
[[nodiscard]] PagePlot panelled(const Figure& figure, const std::filesystem::path& folder);

/// Commands that draw the page as folder/stem.<format>. If all panels have the same axes, only those at the left and at
/// the bottom are labelled.
[[nodiscard]] std::string page_script(const PagePlot& page, const Canvas& canvas, const std::string& stem);

/// Commands that draw the pages as frames of folder/stem.gif, `delay` seconds apart.
[[nodiscard]] std::string film_script(const std::vector<PagePlot>& pages, double delay, const Canvas& canvas,
                                      const std::string& stem);

}  // namespace talus::reports
