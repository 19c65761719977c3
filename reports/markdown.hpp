/// Writing Markdown: what is text stays text.
#pragma once

#include <string>
#include <vector>

namespace talus::reports::markdown {

/// Words of a record as Markdown on one line: everything that Markdown would read as a mark is escaped, except
/// `$maths$` and `` `code` `` spans, which are kept.
[[nodiscard]] std::string words(const std::string& text);

/// As words(), fit for a cell of a pipe table.
[[nodiscard]] std::string cell(const std::string& text);

/// A code span holding the text.
[[nodiscard]] std::string code(const std::string& text);

/// The id that pandoc (gfm_auto_identifiers) and GitHub give to a heading of that plain text.
[[nodiscard]] std::string heading_id(const std::string& heading);

/// Markdown with its headings moved down together, so that the highest of them is of the given level.
/// Lines inside fenced code are left alone.
[[nodiscard]] std::string with_headings_below(const std::string& text, int level);

/// A column of a table: its heading and whether its cells are numbers (set to the right).
struct Column {
  std::string heading;
  bool numbers{};
};

/// A pipe table; cells are Markdown already (see cell()). The dashes of the separator line carry the widths that the
/// columns deserve: pandoc takes them as relative widths. Caption may be empty.
[[nodiscard]] std::string table(const std::vector<Column>& columns, const std::vector<std::vector<std::string>>& rows,
                                const std::string& caption);

/// A number in few digits ("3.82651", "1.2e-07"), `digits` significant ones; "nan" and "inf" as words.
[[nodiscard]] std::string number(double value, int digits);

/// Significant digits that show where the two numbers differ and one digit more; between 5 and 12.
[[nodiscard]] int digits_to_tell(double measured, double reference);

}  // namespace talus::reports::markdown
