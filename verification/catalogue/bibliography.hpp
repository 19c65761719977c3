#pragma once

#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace talus::verification {

/// A work that is cited: one entry of references.bib.
struct Reference {
  std::string key;                                          ///< Author and year in one word, e.g. "mustoe1993".
  std::string type;                                         ///< Of the entry: "article", "book", ...
  std::vector<std::pair<std::string, std::string>> fields;  ///< Name and text, without the outer braces, in its order.

  /// The text of a field; empty if there is none.
  [[nodiscard]] std::string field(std::string_view name) const;
};

/// All works, in the order of their keys.
struct Bibliography {
  std::string text;  ///< BibTeX, as it stands in the file.
  std::vector<Reference> works;

  /// Whether a work has this key.
  [[nodiscard]] bool has(std::string_view key) const;
};

/// Reads a bibliography in BibTeX; `name` is the file named in errors. Only a part of BibTeX is accepted, which every
/// program reads alike: one field a line, UTF-8 without LaTeX commands, values in braces, whole numbers or names of a
/// @string, known types and fields, capitals of titles preserved by a second pair of braces, sorted keys.
/// Errors: InputError "references.bib:17: hertz1882: note: it is given twice".
[[nodiscard]] Bibliography parse_bibliography(std::string text, std::string_view name);

/// What a text cites by author and year. A year cites the work of one of the names before it, back to the last
/// semicolon: "Hertz 1882; Tsuji, Tanaka & Ishida, Powder Technol. 71 (1992) 239".
struct Citations {
  std::vector<std::string> keys;     ///< Of the works found, in the order of the text.
  std::vector<std::string> missing;  ///< First name and year of those that the bibliography lacks.
};
[[nodiscard]] Citations citations_in(const std::string& text, const Bibliography& bibliography);

}  // namespace talus::verification
