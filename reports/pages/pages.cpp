#include "reports/pages/pages.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <functional>

#include "reports/base/error.hpp"
#include "reports/pages/appendix.hpp"
#include "reports/pages/audits_page.hpp"
#include "reports/pages/claims.hpp"
#include "reports/pages/comparisons.hpp"
#include "reports/pages/coverage.hpp"
#include "reports/pages/front_page.hpp"
#include "reports/pages/interface_page.hpp"
#include "reports/pages/mutants_page.hpp"
#include "reports/pages/page_cells.hpp"
#include "reports/pages/rounding.hpp"
#include "reports/pages/summary.hpp"
#include "reports/text/markdown.hpp"

namespace talus::reports {
namespace {

namespace mustache = kainjow::mustache;
/// Date, tier, revision and machine of the run in one line; the appendix has all details.
std::string run_text(const Results& results) {
  const Provenance& p = results.provenance;
  return fmt::format("Run of {}, tier {}, revision {}{}{}.", p.date, name_of(results.tier), p.revision.substr(0, 10),
                     p.dirty ? " with uncommitted changes" : "", p.cpu.empty() ? "" : ", on " + machine(p));
}

/// Registered cases that were not to run, by name; the first twelve of many.
std::string unselected(const Results& results) {
  std::string names;
  std::size_t count = 0;
  constexpr std::size_t named = 12;
  for (const std::string& id : results.registered) {
    if (std::find(results.selected.begin(), results.selected.end(), id) != results.selected.end()) continue;
    if (++count <= named) names += (names.empty() ? "" : ", ") + id;
  }
  return count <= named ? names : names + fmt::format(" and {} more", count - named);
}

/// The values of the first page.
mustache::data front(const Results& results, const Drawn& drawn) {
  const Counts c = counts_of(results);
  mustache::data values;
  values.set("verdict", holds(results) ? "PASS" : "FAIL");
  values.set("counts", fmt::format("{} cases: {} passed, {} failed. {} checks: {} failed, {} slack ({} exact or "
                                   "round-off ones are exempt from that rule). {} negative controls: "
                                   "{} not red or not judged.",
                                   c.cases, c.passed, c.failed, c.checks, c.checks_failed, c.slack, c.exempt,
                                   c.controls, c.controls_failed));
  const std::string left_out = unselected(results);
  // Without --only all cases of the tier are selected.
  values.set("is_partial", !left_out.empty() && !results.only.empty());
  values.set("left_out", left_out);
  values.set("has_full_only", !left_out.empty() && results.only.empty());
  values.set("full_only", left_out);
  const std::string failed = failures(results);
  values.set("has_failures", !failed.empty());
  values.set("failures", failed);
  values.set("run", run_text(results));
  values.set("verified", verified(results));
  values.set("not_verified", not_verified(results));
  values.set("pictures", drawn.no_pictures.empty() ? highlights(results) : "");
  values.set("findings", findings(results));
  values.set("cases", summary_by_family(results));
  return values;
}

/// The heading of a text's first line, as plain text.
std::string first_heading(const std::string& text) {
  const std::string line = text.substr(0, text.find('\n'));
  std::string heading = line.substr(std::min(line.find_first_not_of("# "), line.size()));
  heading.erase(std::remove(heading.begin(), heading.end(), '\\'), heading.end());
  return heading;
}

/// A link `](page:NAME)` or `](details:NAME)` leads to target(is_details, NAME).
std::string resolved(const std::string& text, const std::function<std::string(bool, const std::string&)>& target) {
  std::string result;
  std::size_t at = 0;
  for (;;) {
    const std::size_t page = text.find("](page:", at), details = text.find("](details:", at);
    const std::size_t open = std::min(page, details);
    if (open == std::string::npos) return result + text.substr(at);
    const std::size_t from = text.find(':', open) + 1, to = text.find(')', from);
    result += text.substr(at, open - at) + "](" + target(open == details, text.substr(from, to - from)) + ")";
    at = to + 1;
  }
}

const ReportPage& page_of(const std::vector<ReportPage>& pages, const std::string& name) {
  const auto found =
      std::find_if(pages.begin(), pages.end(), [&](const ReportPage& page) { return page.name == name; });
  if (found == pages.end()) throw OutputError(fmt::format("no page '{}' for a link", name));
  return *found;
}

/// The chapters on audits; one that is neither of this run nor recorded gives the command that makes it.
void set_audits(mustache::data& values, const records::Audits& audits, const Results& results, const Drawn& drawn) {
  const auto set = [&](const char* audit, const char* command, const auto& found, auto&& text_of) {
    values.set(audit, found ? origin_text(audits, audit, command) + text_of(*found)
                            : fmt::format("Not measured in this run: {} does so.\n", markdown::code(command)));
  };
  set("mutants", "make mutants", audits.mutants,
      [&](const records::Mutants& mutants) { return mutants_text(mutants, results, drawn.no_pictures.empty()); });
  values.set("gate", audits.gate ? gate_text(*audits.gate) : "");
  set("interface", "make interface", audits.interface, interface_text);
  set("rounding", "scripts/nightly rounding", audits.rounding,
      [&](const records::RoundingAudit& rounding) { return rounding_text(rounding, results); });
  set("fuzz", "make fuzz", audits.fuzz, fuzz_text);
  set("faults", "make faults", audits.faults, faults_text);
  set("inputs", "scripts/inputs", audits.inputs, inputs_text);
  set("lines", "scripts/coverage", audits.lines, lines_text);
  values.set("defects", audits.defects.empty() ? "The list is not at hand.\n" : defects_text(audits.defects, results));
}

}  // namespace

std::vector<ReportPage> report_pages(const Results& results, const records::Audits& audits, const Drawn& drawn,
                                     const std::filesystem::path& templates, const std::string& references,
                                     const std::string& tools) {
  std::vector<ReportPage> pages;
  const auto chapter = [&](const char* name, const mustache::data& values, Volume volume) {
    const std::string text = filled(templates / "chapters" / fmt::format("{}.mustache", name), values);
    pages.push_back(
        {name, first_heading(text), "", volume == Volume::main ? text : "", volume == Volume::details ? text : ""});
  };
  const mustache::data first = front(results, drawn);
  const std::string front_text = filled(templates / "front.mustache", first);
  pages.push_back(
      {"index", first_heading(front_text), "", front_text, filled(templates / "details_front.mustache", first)});
  mustache::data values;
  values.set("coverage", coverage(results, audits.mutants ? &*audits.mutants : nullptr));
  values.set("ladder", ladder_of_claims(results));
  values.set("claims", claims_of_cases(results));
  values.set("formulas", common_formulas(results));
  values.set("peers", checks_of_peers(results));
  values.set("errata", errata(results));
  values.set("provenance", provenance(results));
  set_audits(values, audits, results, drawn);
  values.set("perturbed", perturbed_references(results));
  values.set("traceability", traceability(results));
  values.set("references", references.empty() ? "None.\n" : references);
  if (!drawn.no_pictures.empty()) values.set("no_pictures", markdown::text(drawn.no_pictures));
  values.set("tools", tools);
  values.set("date", results.provenance.date);
  const std::string ladder = filled(templates / "chapters" / "claims.mustache", values);
  pages.push_back({"claims", first_heading(ladder), "", ladder,
                   filled(templates / "chapters" / "claims_of_cases.mustache", values)});
  for (const char* name : {"coverage", "errata"})
    chapter(name, values, Volume::main);
  std::size_t number = 0;
  const auto family = [&](const std::string& name) {
    for (const Record& record : results.records) {
      if (record.family != name) continue;
      ++number;
      const std::string bugs = audits.mutants ? bugs_text(*audits.mutants, record.id) : "";
      pages.push_back({record.id, case_heading(record), name.empty() ? "others" : name,
                       case_page(record, number, drawn, templates),
                       case_details(record, number, drawn, templates, bugs)});
    }
  };
  for (const std::string& name : results.families)
    family(name);
  family("");
  for (const char* name : {"formulas", "peers", "margins", "mutants", "interface", "rounding", "audits", "defects",
                           "traceability", "references", "provenance", "colophon"})
    chapter(name, values, Volume::details);
  return pages;
}

std::string stem_of(Volume volume) { return volume == Volume::main ? "verification" : "verification-details"; }

std::string volume_text(const std::vector<ReportPage>& pages, Volume volume) {
  const auto part = [](const ReportPage& page, Volume of) -> const std::string& {
    return of == Volume::main ? page.main : page.details;
  };
  std::string text, family;
  for (const ReportPage& page : pages) {
    if (part(page, volume).empty()) continue;
    if (volume == Volume::details && page.family != family && !page.family.empty())
      text += fmt::format("# {}\n\n", markdown::text(page.family));
    family = page.family;
    text += part(page, volume) + "\n";
  }
  return resolved(text, [&](bool is_details, const std::string& name) {
    const ReportPage& page = page_of(pages, name);
    const Volume wanted = is_details ? Volume::details : Volume::main;
    const Volume there = !part(page, wanted).empty() ? wanted : wanted == Volume::main ? Volume::details : Volume::main;
    return fmt::format("{}#{}", there == volume ? "" : stem_of(there) + ".md",
                       markdown::heading_id(first_heading(part(page, there))));
  });
}

std::string site_text(const std::vector<ReportPage>& pages, const ReportPage& page) {
  // The first page of the details introduces the second volume, which the site does not have.
  std::string text = page.main + (page.name == "index" || page.details.empty() ? "" : "\n" + page.details);
  text = resolved(text, [&](bool is_details, const std::string& name) {
    const ReportPage& other = page_of(pages, name);
    return fmt::format("{}.html{}", name, is_details ? "#" + markdown::heading_id(first_heading(other.details)) : "");
  });
  for (const std::string folder : {"figures/", "data/"}) {
    const std::string link = "](" + folder;
    for (std::size_t at = text.find(link); at != std::string::npos; at = text.find(link, at + link.size()))
      text.replace(at, link.size(), "](../" + folder);
  }
  return text;
}

}  // namespace talus::reports
