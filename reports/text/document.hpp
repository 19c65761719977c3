/// From Markdown to HTML and PDF: pandoc and pdfLaTeX.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace talus::reports {

/// A Markdown document and the inputs for its conversion.
struct Document {
  std::filesystem::path folder;     ///< holds the document and its pictures; results go there too
  std::string stem;                 ///< of the Markdown file and of what is made from it
  std::string title;                ///< in the metadata
  std::filesystem::path resources;  ///< reports/pandoc: header.tex, pdf.lua, references.csl, ...
  long long epoch{};                ///< date of the document, seconds since 1970
  bool has_contents{true};          ///< has a table of contents, labels or long tables, which need an extra pass
};

/// The entries of a bibliography in BibTeX as a Markdown list, each after its key, in their order. Throws OutputError
/// as run_or_throw(), and also if pandoc warns.
[[nodiscard]] std::string references_of(const std::string& bibliography, const Document& document);

/// A page of a site.
struct SitePage {
  std::string name;         ///< file stem
  std::string title;        ///< plain text
  std::string text;         ///< Markdown
  std::string search_text;  ///< what the search finds the page by, beside its title
};

/// Writes folder/NAME.html of each page, with a style sheet, a script and the index of the search; `navigation` is a
/// Markdown list of links for the side of each page. No file refers to the network. Returns pandoc's warnings. Throws
/// OutputError as run_or_throw().
std::string make_site(const std::vector<SitePage>& pages, const std::string& navigation, const Document& site,
                      unsigned jobs);

/// Writes folder/stem.tex (pictures need not exist yet); returns pandoc's warnings. Characters that pdfLaTeX cannot
/// print are replaced by their code point, U+hhhh.
std::string make_latex(const Document& document);

/// Writes folder/stem.pdf from folder/stem.tex, running pdfLaTeX until page numbers are stable. The same text and
/// pictures give the same bytes.
void make_pdf(const Document& document);

/// Markdown in which every character outside ASCII and Latin-1 that `header` does not declare is written U+hhhh.
[[nodiscard]] std::string printable(const std::string& markdown, const std::string& header);

}  // namespace talus::reports
