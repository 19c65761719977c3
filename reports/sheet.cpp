#include <fmt/format.h>

#include <functional>

#include "reports/base/error.hpp"
#include "reports/base/file.hpp"
#include "reports/base/process.hpp"
#include "reports/figures/drawing.hpp"
#include "reports/report.hpp"
#include "reports/sheet/capacity_page.hpp"
#include "reports/sheet/sheet_drawing.hpp"
#include "reports/sheet/sheet_page.hpp"
#include "reports/sheet/sheet_tables.hpp"
#include "reports/sheet/sheet_verdict.hpp"
#include "reports/text/document.hpp"
#include "verification/record/whole_file.hpp"

namespace talus::reports {
namespace fs = std::filesystem;
namespace {

SheetPage page_of(const SheetRecord& record) {
  SheetPage page;
  page.title = record.title;
  page.lines = {fmt::format("{} layer{} of {} columns{}; span {:.4g} m ({:.4g} ft), sag {:.3g} m ({:.3g} ft), columns "
                            "{:.3g} m ({:.3g} ft) apart",
                            record.layers, record.layers == 1 ? "" : "s", record.columns_of_layer,
                            record.half_model ? " (half model)" : "", record.span, record.span / 0.3048, record.sag,
                            record.sag / 0.3048, record.spacing, record.spacing / 0.3048),
                fmt::format("{} at {:.6g} s; {} steps of {:.4g} s, {}", record.outcome, record.end, record.steps,
                            record.step, record.integrator)};
  page.boxes = sheet_boxes(record);
  page.tables = fence_tables(record);
  page.is_unusable = !record.quality.usable;
  return page;
}

/// Makes `name`.pdf and `name`.html in a folder; without pdflatex the HTML alone. `draw` makes the pictures in a
/// staging folder and returns them; if it throws OutputError, the page has no pictures. Throws FileError, OutputError.
Made make_page(const fs::path& folder, const std::string& name, const SheetPage& page,
               const std::function<SheetPictures(const fs::path&, Made&)>& draw, const ToolPaths& tools) {
  const StagingFolder staging(folder);
  Made made;
  const auto attempt = [&](auto&& make) {
    try {
      make();
      return true;
    } catch (const OutputError& wrong) {
      made.unmade += fmt::format("{}\n", wrong.what());
      return false;
    }
  };
  SheetPictures pictures;
  attempt([&] { pictures = draw(staging.folder(), made); });
  const fs::path templates = tools.resources / "templates";
  records::write_whole(staging.folder() / (name + ".html"), sheet_html(page, pictures, templates));
  const std::string latex = sheet_latex(page, pictures, templates);
  records::write_whole(staging.folder() / (name + ".tex"),
                       printable(latex, records::read_whole(tools.resources / "pandoc" / "header.tex")));
  const bool has_pdf = attempt([&] {
    make_pdf({.folder = staging.folder(),
              .stem = name,
              .title = page.title,
              .resources = tools.resources,
              .epoch = 0,
              .has_contents = false});
  });
  fs::remove(folder / (name + ".pdf"));  // an earlier one, in case this one could not be made
  for (const char* const format : {".html", ".pdf"}) {
    if (!has_pdf && std::string{format} == ".pdf") continue;
    staging.publish(name + format);
    made.files.push_back(folder / (name + format));
  }
  return made;
}

Made make_fence_sheet(const fs::path& run, const ToolPaths& tools) {
  const SheetRecord record = read_sheet(run / "sheet.json");
  const auto draw_fence = [&](const fs::path& folder, Made& made) {
    const auto drawing = [&](SheetMedium medium, const char* format, const char* stem) {
      const Canvas canvas{tools.resources / "gnuplot" / "preamble.gp", folder, {format}};
      return Drawing{"the sheet", sheet_script(record, canvas, stem, medium)};
    };
    made.warnings = draw({drawing(SheetMedium::paper, "pdf", "drawing"), drawing(SheetMedium::screen, "svg", "drawing"),
                          drawing(SheetMedium::phone, "svg", "phone")},
                         folder, tools.jobs);
    // A run has no date: the same numbers give the same bytes.
    date_picture(folder / "drawing.pdf", 0);
    return SheetPictures{.latex = "\\includegraphics[width=\\linewidth]{drawing.pdf}",
                         .html = records::read_whole(folder / "drawing.svg"),
                         .phone_html = records::read_whole(folder / "phone.svg")};
  };
  return make_page(run, "sheet", page_of(record), draw_fence, tools);
}

Made make_capacity_sheet(const fs::path& folder, const ToolPaths& tools) {
  const CapacityRecord record = read_capacity_record(folder / "capacity.json");
  return make_page(
      folder, "capacity", capacity_page(record),
      [&](const fs::path& staging, Made&) { return capacity_pictures(record, folder / "plots", staging); }, tools);
}

}  // namespace

void demand_sheet_tools() {
  for (const char* tool : {"gnuplot", "pdflatex"})
    demand_program(tool);
}

Made make_sheet(const fs::path& folder, const ToolPaths& tools) {
  const bool is_run = fs::exists(folder / "sheet.json") || !fs::exists(folder / "capacity.json");
  return is_run ? make_fence_sheet(folder, tools) : make_capacity_sheet(folder, tools);
}

}  // namespace talus::reports
