#include "tests/fuzz/mutation.hpp"

#include <algorithm>
#include <array>
#include <string_view>

namespace talus::fuzz {
namespace {

/// Maximum length of a changed text, which one change may still exceed.
constexpr std::size_t longest = 200'000;

/// A span of a text.
struct Span {
  std::size_t begin{}, end{};
  std::size_t size() const { return end - begin; }
};

/// Numbers that every reader must handle: limits of types, of decimal notation, and of list-directed records.
constexpr std::array<std::string_view, 34> extremes{
    "nan",        "inf",         "-inf",       "1e400",      "-1e400",      "1e-400",
    "-0",         "-0.0",        "0",          "1",          "-1",          "2",
    "0.5",        "1e-9",        "1e9",        "1e19",       "-1e19",       "1e154",
    "1e308",      "-1e308",      "1e-308",     "4.9e-324",   "127",         "65536",
    "2147483647", "-2147483648", "4294967296", "1000000000", "1e400000000", "9223372036854775807",
    "3*1",        "100000000*1", "1d400",      "0x10",
};
constexpr std::array<std::string_view, 4> beyond{"-9223372036854775808", "9223372036854775808", "18446744073709551616",
                                                 "123456789012345678901234567890123456789012345678901234567890"};

/// Bytes with a meaning in one of the formats, or in none.
constexpr std::array<std::string_view, 26> bytes{std::string_view{"\0", 1},
                                                 "\xff",
                                                 "\xef\xbb\xbf",
                                                 "\xc3",
                                                 "\xed\xa0\x80",
                                                 "\r",
                                                 "\r\n",
                                                 "\n",
                                                 "\t",
                                                 " ",
                                                 "\"",
                                                 "'",
                                                 "\\",
                                                 "{",
                                                 "}",
                                                 "[",
                                                 "]",
                                                 ",",
                                                 "=",
                                                 "#",
                                                 "/",
                                                 "*",
                                                 "<",
                                                 "/*",
                                                 "&x;",
                                                 "\\ud800"};

constexpr std::string_view separators = " \t\r\n,;=[]{}()<>\"'#";

std::size_t below(std::mt19937_64& random, std::size_t count) { return count == 0 ? 0 : random() % count; }

template <class List>
auto one_of(std::mt19937_64& random, const List& list) {
  return list[below(random, list.size())];
}

std::vector<Span> tokens_of(std::string_view text) {
  std::vector<Span> tokens;
  for (std::size_t begin = text.find_first_not_of(separators); begin != std::string_view::npos;
       begin = text.find_first_not_of(separators, begin)) {
    const std::size_t end = std::min(text.find_first_of(separators, begin), text.size());
    tokens.push_back({begin, end});
    begin = end;
  }
  return tokens;
}

bool is_number(std::string_view token) {
  const std::size_t digit = token.find_first_not_of("+-.");
  return digit < 2 && token[digit] >= '0' && token[digit] <= '9';
}

/// Lines with their line ends.
std::vector<Span> lines_of(std::string_view text) {
  std::vector<Span> lines;
  for (std::size_t begin = 0; begin < text.size();) {
    const std::size_t end = std::min(text.find('\n', begin), text.size() - 1) + 1;
    lines.push_back({begin, end});
    begin = end;
  }
  return lines;
}

/// A random span of up to 64 bytes; one in eight may be as long as the text.
Span any_span(std::mt19937_64& random, std::size_t size) {
  const std::size_t begin = below(random, size + 1);
  const std::size_t room = size - begin, maximum = below(random, 8) == 0 ? room : std::min<std::size_t>(room, 64);
  return {begin, begin + below(random, maximum + 1)};
}

void change_bytes(std::string& text, std::mt19937_64& random) {
  const Span span = any_span(random, text.size());
  switch (below(random, 6)) {
    case 0:
      if (span.begin < text.size())
        text[span.begin] = static_cast<char>(static_cast<unsigned char>(text[span.begin]) ^ (1U << below(random, 8)));
      break;
    case 1:
      text.insert(span.begin, 1, static_cast<char>(below(random, 256)));
      break;
    case 2:
      text.insert(span.begin, one_of(random, bytes));
      break;
    case 3:
      text.erase(span.begin, span.size());
      break;
    case 4:
      text.insert(below(random, text.size() + 1), text.substr(span.begin, span.size()));
      break;
    default:
      text.resize(span.begin);
      break;
  }
}

void change_number(std::string& text, std::mt19937_64& random) {
  std::vector<Span> numbers = tokens_of(text);
  std::erase_if(numbers,
                [&](Span token) { return !is_number(std::string_view{text}.substr(token.begin, token.size())); });
  if (numbers.empty()) return;
  const Span number = one_of(random, numbers);
  switch (below(random, 8)) {
    case 0:
      text.insert(number.begin, "-");
      break;
    case 1:
      text.insert(number.end, "0");
      break;
    case 2:
      text.insert(number.end, "e" + std::to_string(static_cast<int>(below(random, 41)) - 20));
      break;
    case 3:
      text[number.begin] = static_cast<char>('0' + below(random, 10));
      break;
    case 4:
      text.replace(number.begin, number.size(), one_of(random, beyond));
      break;
    default:
      text.replace(number.begin, number.size(), one_of(random, extremes));
      break;
  }
}

/// Replaces a token of one text by a token of another.
void change_token(std::string& text, const std::string& other, std::mt19937_64& random) {
  const std::vector<Span> here = tokens_of(text), there = tokens_of(other);
  if (here.empty() || there.empty()) return;
  const Span token = one_of(random, here), source = one_of(random, there);
  text.replace(token.begin, token.size(), other, source.begin, source.size());
}

void change_lines(std::string& text, std::mt19937_64& random) {
  const std::vector<Span> lines = lines_of(text);
  if (lines.empty()) return;
  const Span line = one_of(random, lines), other = one_of(random, lines);
  const std::string copy = text.substr(line.begin, line.size());
  switch (below(random, 4)) {
    case 0:
      text.erase(line.begin, line.size());
      break;
    case 1:
      text.insert(other.begin, copy);
      break;
    case 2: {
      const Span first = line.begin < other.begin ? line : other, second = line.begin < other.begin ? other : line;
      if (first.begin == second.begin) break;
      const std::string swapped = text.substr(second.begin, second.size()) +
                                  text.substr(first.end, second.begin - first.end) +
                                  text.substr(first.begin, first.size());
      text.replace(first.begin, second.end - first.begin, swapped);
      break;
    }
    default: {
      std::string many;
      for (std::size_t n = below(random, 8) == 0 ? 2000 : 20; n > 0 && many.size() < longest; --n)
        many += copy;
      text.insert(line.begin, many);
    }
  }
}

/// Opens many brackets at the position of a token and, in most cases, closes them.
void nest(std::string& text, std::mt19937_64& random) {
  constexpr std::array<std::array<std::string_view, 2>, 5> kinds{
      {{"[", "]"}, {"{\"a\":", "}"}, {"{ a = ", " }"}, {"<a>", "</a>"}, {"a.", ""}}};
  constexpr std::array<std::size_t, 4> depths{3, 65, 300, 20'000};
  const std::vector<Span> tokens = tokens_of(text);
  if (tokens.empty()) return;
  const Span token = one_of(random, tokens);
  const auto kind = one_of(random, kinds);
  const std::size_t depth = one_of(random, depths);
  std::string open, close;
  for (std::size_t n = 0; n < depth; ++n)
    open += kind[0], close += kind[1];
  if (below(random, 4) != 0) text.insert(token.end, close);
  text.insert(token.begin, open);
}

/// Joins the beginning of one text and the end of another; in most cases cut between lines.
void splice(std::string& text, const std::string& other, std::mt19937_64& random) {
  const std::vector<Span> here = lines_of(text), there = lines_of(other);
  if (here.empty() || there.empty()) return;
  const bool between_lines = below(random, 4) != 0;
  const std::size_t cut = between_lines ? one_of(random, here).begin : below(random, text.size());
  const std::size_t from = between_lines ? one_of(random, there).begin : below(random, other.size());
  text = text.substr(0, cut) + other.substr(from);
}

}  // namespace

std::string mutated(const std::vector<std::string>& sound, std::mt19937_64& random) {
  std::string text = sound[below(random, sound.size())];
  for (std::size_t left = 1 + below(random, 4); left > 0 && text.size() < longest; --left) {
    const std::string& other = sound[below(random, sound.size())];
    switch (below(random, 16)) {
      case 0:
      case 1:
      case 2:
        change_bytes(text, random);
        break;
      case 3:
      case 4:
      case 5:
        change_lines(text, random);
        break;
      case 6:
        splice(text, other, random);
        break;
      case 7:
        if (below(random, 4) == 0) nest(text, random);
        break;
      case 8:
      case 9:
      case 10:
        change_token(text, other, random);
        break;
      default:
        change_number(text, random);
        break;
    }
  }
  return text;
}

}  // namespace talus::fuzz
