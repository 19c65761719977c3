#include "reports/report.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <functional>

#include "reports/base/error.hpp"
#include "reports/base/file.hpp"
#include "reports/base/process.hpp"
#include "reports/base/progress.hpp"
#include "reports/figures/drawing.hpp"
#include "reports/figures/gnuplot_script.hpp"
#include "reports/figures/page_script.hpp"
#include "reports/pages/front_page.hpp"
#include "reports/pages/mutants_page.hpp"
#include "reports/pages/pages.hpp"
#include "reports/pages/sketch.hpp"
#include "reports/text/document.hpp"
#include "reports/text/markdown.hpp"
#include "solver/threads/parallel_for.hpp"
#include "verification/record/audits.hpp"
#include "verification/record/whole_file.hpp"

namespace talus::reports {
namespace fs = std::filesystem;
namespace {

/// Runs the tasks in parallel on up to `jobs` threads. Rethrows the exception of the first task in the list that threw.
void in_parallel(const std::vector<std::function<void()>>& tasks, unsigned jobs) {
  parallel_for(tasks.size(), jobs, [&](std::size_t i) { tasks[i](); });
}

/// Copies the CSV files of the figures that were drawn.
void copy_data(const Results& results, const fs::path& verify, const fs::path& report) {
  for (const Record& record : results.records) {
    for (const Figure& figure : record.figures) {
      const fs::path from = verify / record.id / figure.csv, to = report / data_file(record, figure);
      if (figure.csv.empty() || !fs::exists(from)) continue;
      fs::create_directories(to.parent_path());
      fs::copy_file(from, to, fs::copy_options::skip_existing);  // several figures may share one
    }
  }
}

bool broke_off(const Record& record) { return !finished(record.status); }

/// One script for each case, one for the margin chart, and one for the mutants.
std::vector<Drawing> drawings_of(const Results& results, const records::Audits& audits, const fs::path& verify,
                                 const Canvas& canvas, Drawn& drawn) {
  std::vector<Drawing> drawings{{"the margin chart", margin_script(results, canvas, "margins")}};
  if (audits.mutants) {
    std::string script;
    for (const Figure& figure : mutants_figures(*audits.mutants))
      script += figure_script(plot_of(figure), canvas, "mutants-" + figure.name);
    if (!script.empty()) drawings.push_back({"the mutants", script});
  }
  Canvas quarter = canvas;
  quarter.width = front_figure_wide;
  quarter.height = 5.6;
  quarter.letters = {0.32, 8.0};
  std::string highlighted;
  for (const records::Highlight& highlight : results.highlights) {
    const Figure* const figure = figure_of(results, highlight);
    if (figure == nullptr) continue;
    const fs::path folder = verify / highlight.case_id;
    highlighted += figure->panels.empty() ? figure_script(plot_of(*figure, folder), quarter, highlight_stem(highlight))
                                          : page_script(panelled(*figure, folder), quarter, highlight_stem(highlight));
  }
  if (!highlighted.empty()) drawings.push_back({"the first page", highlighted});
  Canvas small = canvas;
  small.width = page_figure_wide;
  small.height = 4.4;
  small.letters = {0.42, 10.5};
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
    std::vector<PageSketch> sketches;
    try {
      sketches = page_sketches(record.page);
    } catch (const RecordError& wrong) {
      throw RecordError(fmt::format("page of case {}: {}", record.id, wrong.what()));
    }
    for (std::size_t i = 0; i < sketches.size(); ++i)
      script += sketch_script(sketches[i].drawing, canvas, sketch_stem(record.id, i));
    if (!script.empty()) drawings.push_back({"case " + record.id, script});
  }
  return drawings;
}

/// The site's pages: a case is found by the names of its checks, too.
std::vector<SitePage> site_pages(const std::vector<ReportPage>& pages, const Results& results) {
  std::vector<SitePage> site;
  for (const ReportPage& page : pages) {
    std::string search_text = page.family;
    for (const Record& record : results.records) {
      if (record.id != page.name) continue;
      for (const Check& check : record.checks)
        search_text += " " + check.name;
    }
    site.push_back({page.name, page.title, site_text(pages, page), search_text});
  }
  return site;
}

/// The contents of the site as a list: chapters, and the cases below their families.
std::string navigation(const std::vector<ReportPage>& pages, const Results& results) {
  std::string text, family;
  for (const ReportPage& page : pages) {
    if (page.family != family && !page.family.empty()) text += fmt::format("- {}\n", markdown::text(page.family));
    family = page.family;
    const auto record = std::find_if(results.records.begin(), results.records.end(),
                                     [&](const Record& each) { return each.id == page.name; });
    const bool failed = record != results.records.end() && record->status != Status::pass;
    text += fmt::format("{}- [{}]({}.html){}\n", family.empty() ? "" : "    ",
                        markdown::text(record == results.records.end() ? page.title : page.name), page.name,
                        failed ? " **fail**" : "");
  }
  return text;
}

std::string first_line(const std::string& text) { return text.substr(0, text.find('\n')); }

std::string tool_versions() {
  const auto version = [](const char* tool) {
    try {
      return first_line(run_or_throw({tool, {"--version"}, {}, {}}, "--version").output);
    } catch (const OutputError&) {
      return fmt::format("no {}", tool);
    }
  };
  const std::string gnuplot = version("gnuplot");
  const std::string pandoc = version("pandoc");
  return fmt::format("Tools: {}; {}; {}.", gnuplot, pandoc, version("pdflatex"));
}

/// Reason why a part of the report could not be made, one line; empty if it was made. Only OutputError is caught.
std::string failure_of(const std::function<void()>& make) {
  try {
    make();
  } catch (const OutputError& wrong) {
    return fmt::format("{}\n", wrong.what());
  }
  return {};
}

/// Without gnuplot: marks every figure as not drawn, with the reason.
void undraw_all(const Results& results, const std::string& why, Drawn& drawn) {
  drawn.no_pictures = why;
  for (const Record& record : results.records)
    for (const Figure& figure : record.figures)
      drawn.undrawn.insert({record.id + "/" + figure.name, why});
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

Made make_report(const fs::path& verify, const fs::path& report, const ToolPaths& tools) {
  const Results results = records::read_results(verify / "results.json");
  const records::Audits audits = records::read_audits(verify, tools.audits);
  const StagingFolder staging(report);
  const fs::path figures = staging.folder() / "figures";
  fs::create_directory(figures);
  fs::create_directory(staging.folder() / "data");
  copy_data(results, verify, staging.folder());
  const Canvas canvas{tools.resources / "gnuplot" / "preamble.gp", figures, {"pdf", "svg"}};
  Drawn drawn;
  const std::vector<Drawing> drawings = drawings_of(results, audits, verify, canvas, drawn);

  const long long epoch = records::epoch_seconds(results.provenance.date);
  const auto volume = [&](Volume which, const char* title) {
    return Document{staging.folder(), stem_of(which), title, tools.resources / "pandoc", epoch};
  };
  const std::array volumes{Volume::main, Volume::details};
  const std::array documents{volume(Volume::main, "Talus verification report"),
                             volume(Volume::details, "Talus verification: details")};
  Document site{staging.folder() / "html", "index", "Talus verification", tools.resources / "pandoc", epoch};
  fs::create_directory(site.folder);
  const std::string versions = tool_versions();
  std::string references;
  if (!results.bibliography.empty() &&
      !failure_of([&] { references = references_of(results.bibliography, documents[0]); }).empty())
    references = fmt::format("```\n{}\n```\n", results.bibliography);
  std::vector<ReportPage> pages;
  const auto write_markdown = [&] {
    pages = report_pages(results, audits, drawn, tools.resources / "templates", references, versions);
    for (const Volume which : volumes)
      records::write_whole(staging.folder() / (stem_of(which) + ".md"), volume_text(pages, which));
  };
  std::string html_warnings, latex_warnings, picture_warnings, undrawn, no_latex, no_pdf, no_html;
  const auto write_latex = [&] {
    latex_warnings.clear();
    no_latex = failure_of([&] {
      for (const Document& document : documents)
        latex_warnings += make_latex(document);
    });
  };
  write_markdown();
  // LaTeX source needs no pictures, the PDF does.
  in_parallel({write_latex,
               [&] {
                 undrawn = failure_of([&] {
                   picture_warnings = draw(drawings, staging.folder(), tools.jobs);
                   date_pictures(figures, epoch);
                 });
               }},
              tools.jobs);
  if (!undrawn.empty()) {
    undraw_all(results, first_line(undrawn), drawn);
    write_markdown();
    write_latex();
  }
  const Progress progress("writing HTML and PDF", 0);
  std::array<std::string, 2> without;
  const auto write_pdf = [&](std::size_t i) {
    without[i] = no_latex.empty() ? failure_of([&] { make_pdf(documents[i]); }) : no_latex;
  };
  in_parallel({[&] { write_pdf(1); }, [&] { write_pdf(0); }}, tools.jobs);
  // Apart from the PDF: it starts as many processes as are allowed.
  no_html = failure_of(
      [&] { html_warnings = make_site(site_pages(pages, results), navigation(pages, results), site, tools.jobs); });
  no_pdf = !without[0].empty() ? without[0] : without[1];
  Made made{{}, picture_warnings + html_warnings + latex_warnings, undrawn + no_html};
  if (no_pdf != no_html) made.unmade += no_pdf;
  const auto publish = [&](const std::string& name, bool was_made, const std::string& named = {}) {
    if (was_made) {
      staging.publish(name);
      if (name != "figures" && name != "data") made.files.push_back(report / (named.empty() ? name : named));
    } else {
      fs::remove_all(report / name);  // left by an earlier report
    }
  };
  publish("figures", undrawn.empty());
  publish("data", true);
  for (const Volume which : volumes)
    publish(stem_of(which) + ".md", true);
  publish("html", no_html.empty(), "html/index.html");
  for (const Volume which : volumes)
    publish(stem_of(which) + ".pdf", no_pdf.empty());
  return made;
}

void write_rounding_audit(const fs::path& verify, const fs::path& file) {
  std::vector<std::pair<std::string, Results>> rounded;
  for (const char* mode : {"upward", "downward", "toward_zero"})
    rounded.emplace_back(mode, records::read_results(verify / "rounding" / mode / "results.json"));
  records::write_rounding(records::rounding_audit(records::read_results(verify / "results.json"), rounded), file);
}

Made make_pages(const std::vector<fs::path>& files, const std::string& title, const fs::path& target,
                const ToolPaths& tools) {
  const StagingFolder staging(target);
  std::vector<SitePage> pages;
  std::string contents;
  for (const fs::path& file : files) {
    SitePage page{pages.empty() ? "index" : file.stem().string(), "", records::read_whole(file), ""};
    if (page.text.rfind("# ", 0) != 0)
      throw RecordError(fmt::format("{}:1: must begin with '# ' and the page's title", file.string()));
    page.title = first_line(page.text).substr(2);
    for (std::size_t at = page.text.find("\n#"); at != std::string::npos; at = page.text.find("\n#", at + 1))
      page.search_text += page.text.substr(at, page.text.find('\n', at + 1) - at);
    contents += fmt::format("- [{}]({}.html)\n", markdown::text(page.title), page.name);
    pages.push_back(std::move(page));
  }
  const Document site{staging.folder(), "index", title.empty() ? pages.front().title : title,
                      tools.resources / "pandoc"};
  Made made;
  made.warnings = make_site(pages, contents, site, tools.jobs);
  std::vector<std::string> made_files;
  for (const auto& entry : fs::directory_iterator(staging.folder()))
    made_files.push_back(entry.path().filename().string());
  for (const std::string& name : made_files)
    staging.publish(name);
  made.files.push_back(target / "index.html");
  return made;
}

Made make_sketches(const std::vector<fs::path>& files, const fs::path& target, const std::set<std::string>& formats,
                   const ToolPaths& tools) {
  const StagingFolder staging(target);
  const Canvas canvas{tools.resources / "gnuplot" / "preamble.gp", staging.folder(), formats};
  std::vector<Drawing> drawings;
  std::vector<std::string> names;
  for (const fs::path& file : files) {
    std::vector<PageSketch> sketches;
    try {
      sketches = page_sketches(records::read_whole(file));
    } catch (const RecordError& wrong) {
      throw RecordError(fmt::format("{}: {}", file.string(), wrong.what()));
    }
    if (sketches.empty()) throw RecordError(fmt::format("{}: it has no sketch (a block ```sketch)", file.string()));
    const std::string stem = file.stem().string();
    std::string script;
    for (std::size_t i = 0; i < sketches.size(); ++i) {
      script += sketch_script(sketches[i].drawing, canvas, sketch_stem(stem, i));
      for (const std::string& format : formats)
        names.push_back(sketch_stem(stem, i) + "." + format);
    }
    drawings.push_back({file.string(), script});
  }
  Made made;
  made.warnings = draw(drawings, staging.folder(), tools.jobs);
  for (const std::string& name : names) {
    staging.publish(name);
    made.files.push_back(target / name);
  }
  return made;
}

}  // namespace talus::reports
