/// Pages of figures, and films of pages, as gnuplot scripts.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "reports/gnuplot_script.hpp"
#include "reports/pictures.hpp"

namespace talus::reports {

/// A page with what drawing its panels needs.
struct PagePlot {
  Page page;  ///< without its panels
  std::vector<Plot> panels;
  std::optional<double> panel_high{};  ///< [cm]; chosen from the width if absent
  bool two_hues{};                     ///< of the scale: blue against red, else pale to dark
};

/// The plots of a page whose figures hold their points; throws as plot_of() does.
[[nodiscard]] PagePlot page_plot_of(Page page);

/// The page of a figure that has panels, whose points are read from its CSV file in `folder`. They have no key, since their titles and the caption say
/// what is drawn; lines over heat maps are black. Throws as plot_of() does.
[[nodiscard]] PagePlot panelled(const Figure& figure, const std::filesystem::path& folder);

/// The commands that draw the page as folder/stem.<format>. Where all panels have the same axes, only those at the left
/// and at the bottom are labelled.
[[nodiscard]] std::string page_script(const PagePlot& page, const Canvas& canvas, const std::string& stem);

/// The commands that draw the pages one after the other as folder/stem.gif, `delay` seconds apart.
[[nodiscard]] std::string film_script(const std::vector<PagePlot>& pages, double delay, const Canvas& canvas,
                                      const std::string& stem);

}  // namespace talus::reports
