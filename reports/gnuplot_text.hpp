/// Texts in gnuplot's language.
#pragma once

#include <string>

namespace talus::reports {

/// A label for gnuplot's enhanced text, in single quotes. Words as in a record: `$` is dropped, `^` followed by a
/// number or letters raises them, `_` after a single letter lowers what follows (`k_n`); any other mark stands for
/// itself.
[[nodiscard]] std::string gnuplot_text(const std::string& words);

/// Text as a single-quoted gnuplot string, for file names.
[[nodiscard]] std::string gnuplot_quoted(const std::string& text);

}  // namespace talus::reports
