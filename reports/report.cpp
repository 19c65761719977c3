#include "reports/report.hpp"

#include <fmt/format.h>

#include <functional>

#include "reports/document.hpp"
#include "reports/drawing.hpp"
#include "reports/error.hpp"
#include "reports/file.hpp"
#include "reports/gnuplot_script.hpp"
#include "reports/mutants_page.hpp"
#include "reports/page_script.hpp"
#include "reports/pages.hpp"
#include "reports/process.hpp"
#include "reports/progress.hpp"
#include "solver/threads/parallel_for.hpp"
#include "verification/record/whole_file.hpp"

namespace talus::reports {
namespace fs = std::filesystem;
namespace {

/// Calls the tasks side by side, on up to `jobs` threads. Errors: what the first in the list that threw has thrown.
void in_parallel(const std::vector<std::function<void()>>& tasks, unsigned jobs) {
  parallel_for(tasks.size(), jobs, [&](std::size_t i) { tasks[i](); });
}

bool broke_off(const Record& record) { return !finished(record.status); }

/// One script for each case, one for the margin chart, and one for the mutants.
std::vector<Drawing> drawings_of(const Results& results, const Trials& trials, const fs::path& verify,
                                 const Canvas& canvas, Drawn& drawn) {
  std::vector<Drawing> drawings{{"the margin chart", margin_script(results, canvas, "margins")}};
  if (trials.mutants) {
    std::string script;
    for (const Figure& figure : mutants_figures(*trials.mutants))
      script += figure_script(plot_of(figure), canvas, "mutants-" + figure.name);
    if (!script.empty()) drawings.push_back({"the mutants", script});
  }
  Canvas small = canvas;
  small.width = page_figure_wide;
  small.height = 4.8;
  small.letters = {0.36, 9.5};
  for (const Record& record : results.records) {
    std::string script;
    for (const Figure& figure : record.figures) {
      const std::string key = record.id + "/" + figure.name;
      try {
        if (!figure.panels.empty()) {
          const PagePlot page = panelled(figure, verify / record.id);
          for (const Plot& panel : page.panels)
            drawn.hidden[key] += panel.undrawn;
          script += page_script(page, canvas, picture_stem(record, figure));
          continue;
        }
        const Plot plot = plot_of(figure, verify / record.id);
        drawn.hidden[key] = plot.undrawn;
        script +=
            figure_script(plot, &figure == &record.figures.front() ? small : canvas, picture_stem(record, figure));
      } catch (const RecordError& wrong) {
        if (!broke_off(record)) throw;
        drawn.undrawn[key] = wrong.what();
      }
    }
    if (!script.empty()) drawings.push_back({"case " + record.id, script});
  }
  return drawings;
}

/// Reads verify/mutants.json and verify/rounding/MODE/results.json, those that are there.
Trials read_trials(const fs::path& verify) {
  Trials trials;
  if (fs::exists(verify / "mutants.json")) trials.mutants = records::read_mutants(verify / "mutants.json");
  for (const char* rounding : {"upward", "downward", "toward_zero"}) {
    const fs::path file = verify / "rounding" / rounding / "results.json";
    if (fs::exists(file)) trials.rounded.emplace(rounding, records::read_results(file));
  }
  return trials;
}

std::string first_line(const std::string& text) { return text.substr(0, text.find('\n')); }

std::string tool_versions() {
  const auto version = [](const char* tool) {
    return first_line(run_or_throw({tool, {"--version"}, {}, {}}, "--version").output);
  };
  const std::string gnuplot = version("gnuplot");
  const std::string pandoc = version("pandoc");
  return fmt::format("Tools: {}; {}; {}.", gnuplot, pandoc, version("pdflatex"));
}

void date_pictures(const fs::path& folder, long long epoch) {
  for (const auto& entry : fs::directory_iterator(folder)) {
    if (entry.path().extension() == ".pdf") date_picture(entry.path(), epoch);
  }
}

}  // namespace

fs::path find_resources() {
  std::error_code failure;
  const fs::path here = fs::read_symlink("/proc/self/exe", failure).parent_path();
  const fs::path installed = here / ".." / "share" / "talus";
  for (const fs::path& folder : {installed, fs::path(TALUS_REPORTS_SOURCE)}) {
    if (fs::exists(folder / "templates" / "front.mustache")) return fs::weakly_canonical(folder);
  }
  throw OutputError(fmt::format("templates are neither in {} nor in {}", installed.lexically_normal().string(),
                                TALUS_REPORTS_SOURCE));
}

std::string make_report(const fs::path& verify, const fs::path& report, const Workplace& workplace) {
  const Results results = records::read_results(verify / "results.json");
  const Trials trials = read_trials(verify);
  const Workshop workshop(report);
  const fs::path figures = workshop.folder() / "figures";
  fs::create_directory(figures);
  const Canvas canvas{workplace.resources / "gnuplot" / "preamble.gp", figures, {"pdf", "svg"}};
  Drawn drawn;
  const std::vector<Drawing> drawings = drawings_of(results, trials, verify, canvas, drawn);

  const Document document{workshop.folder(), "verification", "Talus verification report",
                          workplace.resources / "pandoc", records::epoch_seconds(results.provenance.date)};
  const std::string tools = tool_versions();
  const std::string references =
      results.bibliography.empty() ? std::string{} : references_of(results.bibliography, document);
  records::write_whole(workshop.folder() / "verification.md",
                       report_markdown(results, trials, drawn, workplace.resources / "templates", references, tools));
  std::string html_warnings;
  std::string latex_warnings;
  std::string picture_warnings;
  // LaTeX source needs no pictures, HTML and PDF do.
  in_parallel({[&] { latex_warnings = make_latex(document); },
               [&] {
                 picture_warnings = draw(drawings, workshop.folder(), workplace.jobs);
                 date_pictures(figures, document.epoch);
               }},
              workplace.jobs);
  const Progress progress("writing HTML and PDF", 0);
  in_parallel({[&] { make_pdf(document); }, [&] { html_warnings = make_html(document); }}, workplace.jobs);
  for (const char* name : {"figures", "verification.md", "verification.html", "verification.pdf"})
    workshop.publish(name);
  return picture_warnings + html_warnings + latex_warnings;
}

}  // namespace talus::reports
