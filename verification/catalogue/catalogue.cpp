#include "verification/catalogue/catalogue.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>

#include "solver/base/error.hpp"
#include "verification/catalogue/catalogue_table.hpp"
#include "verification/catalogue/solver_lists.hpp"

namespace talus::verification {

namespace {

namespace fs = std::filesystem;

bool is_number(std::string_view text) {
  const auto digit = [](unsigned char c) { return std::isdigit(c) != 0; };
  return !text.empty() && text.front() != '0' && std::all_of(text.begin(), text.end(), digit);
}

void read_equations(const CatalogueTable& file, Catalogue& catalogue) {
  for (const auto& [id, text] : file.entries("equations")) {
    if (!id.starts_with("Eq. ") || !is_number(id.substr(4)))
      file.fail("equations", "it must be \"Eq. \" and a number", id);
    catalogue.requirements.push_back({id, "equation", text});
  }
}

void read_problems(const CatalogueTable& family, const std::string& title, Catalogue& catalogue) {
  for (const auto& [id, text] : family.entries("problems")) {
    if (id.empty() || id.front() != title.front() || !is_number(id.substr(1)))
      family.fail("problems",
                  fmt::format("it must be {} and a number, as the title of its family begins", title.front()), id);
    if (catalogue.requirement(id) != nullptr) family.fail("problems", "it is given twice", id);
    catalogue.requirements.push_back({id, title, text});
  }
}

void read_requirements(const fs::path& path, Catalogue& catalogue) {
  const CatalogueTable file{path, {"equations", "family"}};
  read_equations(file, catalogue);
  for (const CatalogueTable& family : file.tables("family", "family", "title", {"title", "problems"})) {
    const std::string title = family.text("title");
    auto& known = catalogue.families;
    if (std::find(known.begin(), known.end(), title) != known.end()) family.fail("title", "it is given twice");
    known.push_back(title);
    if (family.has("problems")) read_problems(family, title, catalogue);
  }
  for (Requirement& requirement : requirements_of_solver())
    catalogue.requirements.push_back(std::move(requirement));
}

void read_peers(const fs::path& path, Catalogue& catalogue) {
  std::vector<std::string> sources, ids;
  for (const Reference& work : catalogue.bibliography.works)
    sources.push_back(work.key);
  for (const Requirement& requirement : catalogue.requirements)
    ids.push_back(requirement.id);
  const auto demand_known = [](const CatalogueTable& check, const char* key, const char* kind, const std::string& found,
                               const std::vector<std::string>& known) {
    if (std::find(known.begin(), known.end(), found) == known.end())
      check.fail(key, unknown_name(kind, found, known).what());
  };
  const CatalogueTable file{path, {"check"}};
  for (const CatalogueTable& check :
       file.tables("check", "check", "id", {"suite", "id", "what", "form", "problems", "remark"})) {
    const PeerCheck peer{check.text("suite"), check.text("id"),        check.text("what"),
                         check.text("form"),  check.texts("problems"), check.text_or_empty("remark")};
    demand_known(check, "suite", "reference", peer.suite, sources);
    for (const std::string& problem : peer.problems)
      demand_known(check, "problems", "requirement", problem, ids);
    if (peer.problems.empty() && peer.remark.empty())
      check.fail("problems", "found an empty array; a remark must then give the reason");
    for (const PeerCheck& other : catalogue.peers) {
      if (other.suite == peer.suite && other.id == peer.id) check.fail("id", "its suite has it twice");
    }
    const auto& all = catalogue.peers;
    const auto same = [&](const PeerCheck& other) { return other.suite == peer.suite; };
    if (std::any_of(all.begin(), all.end(), same) && !same(all.back()))
      check.fail("suite",
                 fmt::format("found \"{}\" after another suite; the checks of a suite must be adjacent", peer.suite));
    catalogue.peers.push_back(peer);
  }
}

void read_errata(const fs::path& path, Catalogue& catalogue) {
  const CatalogueTable file{path, {"erratum"}};
  for (const CatalogueTable& table :
       file.tables("erratum", "erratum", "id", {"id", "where", "printed", "corrected", "evidence", "proved_by"})) {
    const Erratum erratum{table.text("id"),        table.text("where"),    table.text("printed"),
                          table.text("corrected"), table.text("evidence"), table.text("proved_by")};
    const std::string next = fmt::format("E{}", catalogue.errata.size() + 1);
    if (erratum.id != next) table.fail("id", fmt::format("found \"{}\"; the next must be {}", erratum.id, next));
    catalogue.errata.push_back(erratum);
  }
}

void read_findings(const fs::path& path, Catalogue& catalogue) {
  const CatalogueTable file{path, {"finding", "highlight"}};
  for (const CatalogueTable& table : file.tables("finding", "finding", "case", {"case", "text"}))
    catalogue.findings.push_back({table.text("case"), table.text("text")});
  for (const CatalogueTable& table : file.tables("highlight", "highlight", "case", {"case", "figure", "caption"}))
    catalogue.highlights.push_back({table.text("case"), table.text("figure"), table.text("caption")});
}

}  // namespace

const Requirement* Catalogue::requirement(const std::string& id) const {
  const auto found = std::find_if(requirements.begin(), requirements.end(), [&](const auto& r) { return r.id == id; });
  return found == requirements.end() ? nullptr : &*found;
}

std::string Catalogue::family_of(const std::string& named, const std::vector<std::string>& requirement_ids) const {
  if (!named.empty()) return named;
  std::string largest;
  std::ptrdiff_t largest_problems = 0;
  for (const std::string& family : families) {
    const auto problems = std::count_if(requirement_ids.begin(), requirement_ids.end(), [&](const std::string& id) {
      const Requirement* const found = requirement(id);
      return found != nullptr && found->group == family;
    });
    if (problems > largest_problems) {
      largest = family;
      largest_problems = problems;
    }
  }
  return largest;
}

Catalogue read_catalogue(const fs::path& folder) {
  Catalogue catalogue;
  const fs::path references = folder / "references.bib";
  catalogue.bibliography = parse_bibliography(read_text(references), references.string());
  read_requirements(folder / "requirements.toml", catalogue);
  read_peers(folder / "peers.toml", catalogue);
  read_errata(folder / "errata.toml", catalogue);
  read_findings(folder / "findings.toml", catalogue);
  return catalogue;
}

}  // namespace talus::verification
