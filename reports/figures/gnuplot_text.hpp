/// Texts as gnuplot strings.
#pragma once

#include <cstddef>
#include <string>

namespace talus::reports {

/// A label for gnuplot's enhanced text, in single quotes. Text as in a record: the two `$` around a formula are dropped
/// (the first has no space after it, the second none before it and no digit after it), `^` followed by a number or
/// letters is a superscript, `_` after a single letter a subscript (`k_n`), LaTeX's names of Greek letters and of some
/// signs are those signs (`\omega`, `\le`); any other mark is printed literally.
[[nodiscard]] std::string gnuplot_text(const std::string& text);

/// The same in lines of at most `maximum` characters, broken at spaces; a longer word has a line of its length.
[[nodiscard]] std::string gnuplot_lines(const std::string& text, std::size_t maximum);

/// Literal text for gnuplot's enhanced text, in single quotes: a title or name given by the user. Text longer than
/// `maximum` characters is cut and ends in three dots.
[[nodiscard]] std::string gnuplot_verbatim(const std::string& text, std::size_t maximum = std::string::npos);

/// Text as a single-quoted gnuplot string, for file names.
[[nodiscard]] std::string gnuplot_quoted(const std::string& text);

}  // namespace talus::reports
