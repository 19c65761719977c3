#include "reports/pages.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "reports/appendix.hpp"
#include "reports/comparisons.hpp"
#include "reports/coverage.hpp"
#include "reports/markdown.hpp"
#include "reports/mutants_page.hpp"
#include "reports/page_cells.hpp"
#include "reports/summary.hpp"

namespace talus::reports {
namespace {

namespace mustache = kainjow::mustache;
/// When and from what, in a line; the appendix has all of it.
std::string run_in_words(const Results& results) {
  const Provenance& p = results.provenance;
  return fmt::format("Run of {}, tier {}, revision {}{}.", p.date, name_of(results.tier), p.revision.substr(0, 10),
                     p.dirty ? " with uncommitted changes" : "");
}

std::string front(const Results& results, const Trials& trials, const std::filesystem::path& templates) {
  const Counts c = counts_of(results);
  mustache::data values;
  values.set("verdict", holds(results) ? "PASS" : "FAIL");
  values.set("counts", fmt::format("{} cases: {} passed, {} failed. {} checks: {} failed, {} slack ({} exact or "
                                   "round-off ones are exempt from that rule). {} negative controls: "
                                   "{} failed.",
                                   c.cases, c.passed, c.failed, c.checks, c.checks_failed, c.slack, c.exempt,
                                   c.controls, c.controls_failed));
  std::string left_out;
  for (const std::string& id : results.registered) {
    if (std::find(results.selected.begin(), results.selected.end(), id) != results.selected.end()) continue;
    left_out += (left_out.empty() ? "" : ", ") + id;
  }
  values.set("is_partial", !left_out.empty());
  values.set("left_out", left_out);
  const std::string failed = failures(results);
  values.set("has_failures", !failed.empty());
  values.set("failures", failed);
  values.set("run", run_in_words(results));
  values.set("cases", summary_by_family(results));
  values.set("coverage", coverage(results, trials.mutants ? &*trials.mutants : nullptr));
  values.set("formulas", common_formulas(results));
  values.set("peers", checks_of_peers(results));
  values.set("errata", errata(results));
  return filled(templates / "front.mustache", values);
}

std::string back(const Results& results, const Trials& trials, const Drawn& drawn,
                 const std::filesystem::path& templates, const std::string& references, const std::string& tools) {
  mustache::data values;
  values.set("provenance", provenance(results));
  std::string details;
  for (std::size_t i = 0; i < results.records.size(); ++i)
    details += fmt::format("{}\n", case_details(results.records[i], i + 1, drawn, templates));
  values.set("details", details);
  values.set("rounding",
             trials.rounded.empty()
                 ? "The cases were not run under other roundings in this run: `scripts/nightly rounding` does so.\n"
                 : rounding_text(results, trials.rounded));
  values.set("mutants", trials.mutants ? mutants_text(*trials.mutants, results, drawn.no_pictures.empty())
                                       : "The cases were not run with mutants in this run: `make mutants` does so.\n");
  values.set("perturbed", perturbed_references(results));
  values.set("traceability", traceability(results));
  values.set("references", references.empty() ? "None.\n" : references);
  if (!drawn.no_pictures.empty()) values.set("no_pictures", markdown::words(drawn.no_pictures));
  values.set("tools", tools);
  values.set("date", results.provenance.date);
  return filled(templates / "back.mustache", values);
}

}  // namespace

std::string report_markdown(const Results& results, const Trials& trials, const Drawn& drawn,
                            const std::filesystem::path& templates, const std::string& references,
                            const std::string& tools) {
  std::string text = front(results, trials, templates);
  for (std::size_t i = 0; i < results.records.size(); ++i) {
    text += fmt::format("\n{}", case_page(results.records[i], i + 1, drawn, templates));
  }
  return fmt::format("{}\n{}", text, back(results, trials, drawn, templates, references, tools));
}

}  // namespace talus::reports
