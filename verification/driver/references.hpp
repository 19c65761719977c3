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

}  // namespace talus::verification
