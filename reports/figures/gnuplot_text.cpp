#include "reports/figures/gnuplot_text.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <map>

namespace talus::reports {
namespace {

bool letter_or_digit(char letter) { return std::isalnum(static_cast<unsigned char>(letter)) != 0; }

/// Length of the argument of `^` or `_` at `offset`: {...}, (...), a signed number, or a short word; 0 if none.
std::size_t script_length(const std::string& text, std::size_t offset) {
  if (offset >= text.size()) return 0;
  if (text[offset] == '{' || text[offset] == '(') {
    const std::size_t end = text.find(text[offset] == '{' ? '}' : ')', offset);
    return end == std::string::npos ? 0 : end + 1 - offset;
  }
  std::size_t end = offset;
  if (text[end] == '-' || text[end] == '+') ++end;
  const std::size_t sign = end - offset;
  while (end < text.size() && (letter_or_digit(text[end]) ||
                               (text[end] == '.' && end + 1 < text.size() && letter_or_digit(text[end + 1])))) {
    ++end;
  }
  if (end - offset == sign &&
      (static_cast<unsigned char>(text[end]) & 0x80U) != 0) {  // one sign, such as a Greek letter
    ++end;
    while (end < text.size() && (static_cast<unsigned char>(text[end]) & 0xC0U) == 0x80U)
      ++end;
  }
  const std::size_t length = end - offset;
  return length > sign && length <= 5 ? length : 0;
}

/// `_` marks a subscript only after a symbol of one letter, so that names such as two_cable are unchanged.
bool follows_symbol(const std::string& text, std::size_t offset) {
  if (offset == 0) return false;
  const bool ascii = static_cast<unsigned char>(text[offset - 1]) < 0x80;
  if (!ascii) return true;
  return std::isalpha(static_cast<unsigned char>(text[offset - 1])) != 0 &&
         (offset == 1 || (!letter_or_digit(text[offset - 2]) && text[offset - 2] != '_'));
}

/// Removes the two marks around each formula, by pandoc's rules.
std::string without_formula_marks(const std::string& text) {
  const auto space = [&](std::size_t i) { return std::isspace(static_cast<unsigned char>(text[i])) != 0; };
  const auto digit = [&](std::size_t i) {
    return i < text.size() && std::isdigit(static_cast<unsigned char>(text[i])) != 0;
  };
  const auto end_of = [&](std::size_t begin) {
    for (std::size_t i = text.find('$', begin + 1); i != std::string::npos; i = text.find('$', i + 1)) {
      if (i > begin + 1 && !space(i - 1) && !digit(i + 1)) return i;
    }
    return std::string::npos;
  };
  std::string result;
  for (std::size_t i = 0; i < text.size(); ++i) {
    const bool begins = text[i] == '$' && i + 1 < text.size() && !space(i + 1);
    const std::size_t end = begins ? end_of(i) : std::string::npos;
    if (end == std::string::npos) {
      result += text[i];
      continue;
    }
    result += text.substr(i + 1, end - i - 1);
    i = end;
  }
  return result;
}

/// Replaces names of signs by the signs, as in `\omega`; other backslashes are unchanged.
std::string with_signs(const std::string& text) {
  static const std::map<std::string, const char*> signs{
      {"alpha", "α"},  {"beta", "β"},  {"gamma", "γ"},  {"delta", "δ"},  {"epsilon", "ε"}, {"varepsilon", "ε"},
      {"eta", "η"},    {"theta", "θ"}, {"kappa", "κ"},  {"lambda", "λ"}, {"mu", "μ"},      {"nu", "ν"},
      {"xi", "ξ"},     {"pi", "π"},    {"rho", "ρ"},    {"sigma", "σ"},  {"tau", "τ"},     {"phi", "φ"},
      {"varphi", "φ"}, {"psi", "ψ"},   {"omega", "ω"},  {"Delta", "Δ"},  {"Omega", "Ω"},   {"Sigma", "Σ"},
      {"ell", "ℓ"},    {"cdot", "·"},  {"times", "×"},  {"le", "≤"},     {"ge", "≥"},      {"pm", "±"},
      {"to", "→"},     {"infty", "∞"}, {"approx", "≈"}, {"ne", "≠"},     {"dots", "…"},    {"sqrt", "√"}};
  std::string result;
  for (std::size_t i = 0; i < text.size(); ++i) {
    if (text[i] != '\\') {
      result += text[i];
      continue;
    }
    std::size_t end = i + 1;
    while (end < text.size() && std::isalpha(static_cast<unsigned char>(text[end])) != 0)
      ++end;
    const auto sign = signs.find(text.substr(i + 1, end - i - 1));
    if (sign == signs.end()) {
      result += text[i];
      continue;
    }
    result += sign->second;
    i = end - 1;
  }
  return result;
}

/// Replaces control characters, for example tabs in a deck's title.
std::string without_control(std::string text) {
  for (char& letter : text)
    if (std::iscntrl(static_cast<unsigned char>(letter)) != 0) letter = ' ';
  return text;
}

std::string escaped(const std::string& text) {
  std::string result;
  for (const char letter : text) {
    if (std::string("\\{}^_@&~").find(letter) != std::string::npos) result += '\\';
    if (letter == '\'') result += '\'';
    result += letter;
  }
  return result;
}

}  // namespace

std::string gnuplot_quoted(const std::string& text) {
  std::string result = "'";
  for (const char letter : text) {
    if (letter == '\'') result += '\'';
    result += letter;
  }
  return result + "'";
}

std::string gnuplot_verbatim(const std::string& text, std::size_t maximum) {
  const auto begins = [](char byte) { return (static_cast<unsigned char>(byte) & 0xC0U) != 0x80U; };  // start of a
                                                                                                      // UTF-8 character
  std::string shown;
  std::size_t characters = 0;
  for (const char byte : without_control(text)) {
    if (begins(byte) && ++characters > maximum) return "'" + escaped(shown) + "...'";
    shown += byte;
  }
  return "'" + escaped(shown) + "'";
}

std::string gnuplot_text(const std::string& text_in_record) {
  const std::string text = with_signs(without_control(without_formula_marks(text_in_record)));
  std::string result = "'";
  for (std::size_t i = 0; i < text.size(); ++i) {
    const bool raises = text[i] == '^';
    const bool lowers = text[i] == '_' && follows_symbol(text, i);
    const std::size_t length = raises || lowers ? script_length(text, i + 1) : 0;
    if (length == 0) {
      result += escaped(text.substr(i, 1));
      continue;
    }
    std::string script = text.substr(i + 1, length);
    if (script.front() == '{' || script.front() == '(') script = script.substr(1, script.size() - 2);
    result += fmt::format("{}{{{}}}", text[i], escaped(script));
    i += length;
  }
  return result + "'";
}

std::string gnuplot_lines(const std::string& text_in_record, std::size_t maximum) {
  const std::string plain = without_formula_marks(text_in_record);  // a line may end within a formula
  std::string text, line;
  for (std::size_t at = 0; at < plain.size();) {
    const std::size_t space = std::min(plain.find(' ', at), plain.size());
    const std::string word = plain.substr(at, space - at);
    if (!line.empty() && line.size() + 1 + word.size() > maximum) {
      text += gnuplot_text(line) + ".\"\\n\".";
      line.clear();
    }
    line += (line.empty() ? "" : " ") + word;
    at = space + 1;
  }
  return text + gnuplot_text(line);
}

}  // namespace talus::reports
