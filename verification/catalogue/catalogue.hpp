#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "verification/catalogue/bibliography.hpp"
#include "verification/catalogue/requirement.hpp"

namespace talus::verification {

/// A check of another code or a published benchmark set, and the corresponding requirements here.
struct PeerCheck {
  std::string suite;                  ///< Key of the Reference with its definition.
  std::string id;                     ///< Its name there.
  std::string what;                   ///< One line: the setup.
  std::string form;                   ///< The reference that it is compared with; for discs where the peer has spheres.
  std::vector<std::string> problems;  ///< Ids of the requirements that verify the same in two dimensions; empty: none.
  std::string remark;                 ///< Differences here, or the reason why there is no requirement; may be empty.
};

/// An error in the 1993 report that a case proves.
struct Erratum {
  std::string id;         ///< "E1", ...
  std::string where;      ///< Equation, section and page of the report.
  std::string printed;    ///< The printed text.
  std::string corrected;  ///< The correct text.
  std::string evidence;   ///< The numbers or the argument that prove it.
  std::string proved_by;  ///< Id of the case that proves it.
};

/// A result in one sentence, for the report's summary. `<<NAME>>` in it is replaced by what the case's check of that
/// name measures, so that no number is written twice.
struct CatalogueFinding {
  std::string case_id;
  std::string text;
};

/// A figure of a case that the report's first page shows.
struct CatalogueHighlight {
  std::string case_id;
  std::string figure;   ///< Its name in the case.
  std::string caption;  ///< One sentence.
};

/// What the cases must show, what other codes check, the errors of the 1993 report, the main findings, and the
/// works that are cited.
struct Catalogue {
  std::vector<Requirement> requirements;   ///< The 1993 report's equations, problems, the solver's closed lists.
  std::vector<std::string> families;       ///< Families of cases, in the order of the report; also groups of problems.
  std::vector<PeerCheck> peers;            ///< In the order of the report, the checks of a suite together.
  std::vector<Erratum> errata;             ///< As they were found.
  std::vector<CatalogueFinding> findings;  ///< In the order of the report.
  std::vector<CatalogueHighlight> highlights;  ///< Likewise.
  Bibliography bibliography;

  [[nodiscard]] const Requirement* requirement(const std::string& id) const;  ///< nullptr if there is none.

  /// The family of a case: the one it names, or the one with most of its catalogue problems (the first if several have
  /// equally many); empty if it names none and claims no problem of the catalogue.
  [[nodiscard]] std::string family_of(const std::string& named, const std::vector<std::string>& requirements) const;
};

/// Reads requirements.toml, peers.toml, errata.toml, findings.toml and references.bib of a folder, whose comments
/// explain them, and adds the requirements of the solver's lists. Ids and keys are unique, and every reference to a
/// work or a requirement leads to one; cases are not known here. Errors: IoError if a file cannot be read; InputError
/// with file, line, key, what was found and what is allowed.
[[nodiscard]] Catalogue read_catalogue(const std::filesystem::path& folder);

}  // namespace talus::verification
