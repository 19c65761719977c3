#pragma once

#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace talus::verification {

/// A cited work: one entry of references.bib.
struct Reference {
  std::string key;                                          ///< Author and year in one word, e.g. "mustoe1993".
  std::string type;                                         ///< Type of the entry: "article", "book", ...
  std::vector<std::pair<std::string, std::string>> fields;  ///< Name and text, without the outer braces, in file order.

  /// The text of a field; empty if the field is absent.
  [[nodiscard]] std::string field(std::string_view name) const;
};

/// All works, in the order of their keys.
struct Bibliography {
  std::string text;  ///< BibTeX, as in the file.
  std::vector<Reference> works;

  /// Whether a work has this key.
  [[nodiscard]] bool has(std::string_view key) const;
};

/// Parses a bibliography in BibTeX; `name` is the file name for error messages. Only a subset of BibTeX is accepted,
/// which every program reads alike: one field per line, UTF-8 without LaTeX commands, values in braces, integers or
/// names of a @string, known types and fields, capitals of titles preserved by a second pair of braces, sorted keys.
/// Errors: InputError "references.bib:17: hertz1882: note: it is given twice".
[[nodiscard]] Bibliography parse_bibliography(std::string text, std::string_view name);

/// The works that a text cites by author and year. A year cites the work of one of the names before it, back to the
/// last semicolon: "Hertz 1882; Tsuji, Tanaka & Ishida, Powder Technol. 71 (1992) 239".
struct Citations {
  std::vector<std::string> keys;     ///< Keys of the works found, in the order of the text.
  std::vector<std::string> missing;  ///< First name and year of citations that are not in the bibliography.
};
[[nodiscard]] Citations citations_in(const std::string& text, const Bibliography& bibliography);

}  // namespace talus::verification
