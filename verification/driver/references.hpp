#pragma once

#include <string>
#include <vector>

namespace talus::verification {

/// A work that the cases cite.
struct Reference {
  std::string key;   ///< Author and year in one word, e.g. "mustoe1993".
  std::string text;  ///< The full citation.
};

/// The bibliography of the report, by key.
[[nodiscard]] std::vector<Reference> all_references();

/// The citations in `text`, author and year, that the bibliography lacks. A year cites the work of one of the names
/// before it, back to the last semicolon: "Hertz 1882; Tsuji, Tanaka & Ishida, Powder Technol. 71 (1992) 239".
[[nodiscard]] std::vector<std::string> citations_without_entry(const std::string& text);

}  // namespace talus::verification
