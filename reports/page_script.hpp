/// Pages of figures, and films of pages, as gnuplot scripts.
#pragma once

#include <string>
#include <vector>

#include "reports/gnuplot_script.hpp"
#include "reports/run_plots.hpp"

namespace talus::reports {

/// A page with the numbers of its panels read.
struct PagePlot {
  Page page;
  std::vector<Plot> panels;
};

/// The page of a figure that has panels. They have no key, since their titles and the caption say what is drawn; lines
/// over heat maps are black.
[[nodiscard]] Page panelled(const Figure& figure);

/// Reads the numbers of a page; throws as plot_of() does.
[[nodiscard]] PagePlot page_plot_of(const Page& page, const std::filesystem::path& folder);

/// The commands that draw the page as folder/stem.<format>. Where all panels have the same axes, only those at the left
/// and at the bottom are labelled.
[[nodiscard]] std::string page_script(const PagePlot& page, const Canvas& canvas, const std::string& stem);

/// The commands that draw the pages one after the other as folder/stem.gif, `delay` seconds apart.
[[nodiscard]] std::string film_script(const std::vector<PagePlot>& pages, double delay, const Canvas& canvas,
                                      const std::string& stem);

}  // namespace talus::reports
