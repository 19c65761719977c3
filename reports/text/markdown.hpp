/// Writing Markdown: text is escaped.
#pragma once

#include <string>
#include <vector>

namespace talus::reports::markdown {

/// Text of a record as Markdown on one line: all characters with a meaning in Markdown are escaped, except `$maths$`
/// and `` `code` `` spans, which are kept.
[[nodiscard]] std::string text(const std::string& text);

/// As words(), for a cell of a pipe table.
[[nodiscard]] std::string cell(const std::string& text);

/// A code span of the text.
[[nodiscard]] std::string code(const std::string& text);

/// The id that pandoc (gfm_auto_identifiers) and GitHub give to a heading with that plain text.
[[nodiscard]] std::string heading_id(const std::string& heading);

/// Markdown with all its heading levels shifted so that the highest is of the given level. Lines inside fenced code are
/// unchanged.
[[nodiscard]] std::string with_headings_below(const std::string& text, int level);

/// A column of a table: its heading and whether its cells are numbers (right-aligned).
struct Column {
  std::string heading;
  bool numbers{};
};

/// A pipe table; cells must be Markdown (see cell()). The dashes of the separator line encode the column widths, which
/// pandoc uses as relative widths. Caption may be empty.
[[nodiscard]] std::string table(const std::vector<Column>& columns, const std::vector<std::vector<std::string>>& rows,
                                const std::string& caption);

/// A number with `digits` significant digits ("3.82651", "1.2e-07"); non-finite values as "nan" and "inf".
[[nodiscard]] std::string number(double value, int digits);

/// Number of significant digits that shows where the two numbers differ, plus one; between 5 and 12.
[[nodiscard]] int digits_to_tell(double measured, double reference);

}  // namespace talus::reports::markdown
