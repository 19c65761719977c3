#include "verification/catalogue/bibliography.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <map>
#include <regex>
#include <sstream>

#include "solver/base/error.hpp"
#include "verification/record/utf8.hpp"

namespace talus::verification {

namespace {

/// An entry type and its required fields. An editor can replace the author.
struct EntryType {
  std::string_view name;
  std::array<std::string_view, 4> required{};  ///< Unused elements are empty.
};

constexpr std::array entry_types{
    EntryType{"article", {"author", "title", "journal", "year"}},
    EntryType{"book", {"author", "title", "year"}},
    EntryType{"incollection", {"author", "title", "year"}},
    EntryType{"mastersthesis", {"author", "title", "school", "year"}},
    EntryType{"misc", {"title"}},
    EntryType{"phdthesis", {"author", "title", "school", "year"}},
    EntryType{"techreport", {"author", "title", "number", "year"}},
};

constexpr std::array<std::string_view, 23> field_names{
    "address", "archiveprefix", "author", "booktitle", "edition", "editor", "eprint",    "institution",
    "journal", "keywords",      "month",  "note",      "number",  "pages",  "pagetotal", "publisher",
    "school",  "series",        "title",  "type",      "url",     "volume", "year",
};

/// Fields in which a second pair of braces preserves capitals and "and".
constexpr std::array<std::string_view, 6> verbatim_fields{"booktitle", "institution", "publisher",
                                                          "school",    "series",      "title"};

template <class List>
bool contains(const List& list, std::string_view name) {
  return std::find(list.begin(), list.end(), name) != list.end();
}

/// Whether the text begins with a brace and the matching brace ends it.
bool is_braced(std::string_view text) {
  int open = 0;
  for (std::size_t i = 0; i < text.size(); ++i) {
    open += text[i] == '{' ? 1 : text[i] == '}' ? -1 : 0;
    if (open <= 0) return i > 0 && open == 0 && i + 1 == text.size();
  }
  return false;
}

/// Rejects a line that is not UTF-8, or that is too long for std::regex, which recurses for each character and would
/// overflow the stack.
void demand_plain_lines(const std::string& text, std::string_view name) {
  constexpr std::size_t longest_line = 4000;
  std::istringstream lines{text};
  std::string line;
  for (int number = 1; std::getline(lines, line); ++number) {
    if (!records::is_utf8(line)) throw InputError{fmt::format("{}:{}: the line is not UTF-8", name, number)};
    if (line.size() > longest_line)
      throw InputError{
          fmt::format("{}:{}: found {} bytes; a line must have at most {}", name, number, line.size(), longest_line)};
  }
}

/// Reads a .bib file line by line.
class BibReader {
 public:
  explicit BibReader(std::string_view name) : name_{name} {}

  std::vector<Reference> works(const std::string& text) {
    std::istringstream lines{text};
    std::string line;
    for (line_ = 1; std::getline(lines, line); ++line_) {
      if (line.find_first_not_of(" \t\r") == std::string::npos) continue;
      in_entry_ ? read_inside(line) : read_outside(line);
    }
    if (in_entry_) fail("the end of the file; the entry must end with a line }");
    return std::move(works_);
  }

 private:
  [[noreturn]] void fail(const std::string& message) const {
    throw InputError{fmt::format("{}:{}: {}{}", name_, line_, in_entry_ ? works_.back().key + ": " : "", message)};
  }

  void read_outside(const std::string& line) {
    static const std::regex entry{R"(@(\w+)\{([a-z]+\d*),)"}, string{R"(@string\{(\w+) = (\{.*\})\})"};
    std::smatch parts;
    if (line.front() == '%') {
      if (line.find('@') != std::string::npos) fail("found @ in a comment; BibTeX takes it for an entry");
    } else if (std::regex_match(line, parts, string)) {
      if (!strings_.emplace(parts[1], text_of(parts[2])).second)
        fail(fmt::format("string '{}' is given twice", parts[1].str()));
    } else if (std::regex_match(line, parts, entry)) {
      start_entry({parts[2], parts[1], {}});
    } else {
      fail(fmt::format("found \"{}\"; it must be `@type{{key,`, `@string{{name = {{text}}}}` or a comment after %",
                       line));
    }
  }

  void start_entry(Reference work) {
    std::vector<std::string> known;
    for (const EntryType& type : entry_types)
      known.emplace_back(type.name);
    if (!contains(known, work.type)) fail(unknown_name("type", work.type, known).what());
    if (!works_.empty() && !(works_.back().key < work.key))
      fail(fmt::format("{}: found after {}; keys must be sorted and unique", work.key, works_.back().key));
    works_.push_back(std::move(work));
    in_entry_ = true;
  }

  void read_inside(const std::string& line) {
    static const std::regex field{R"(\s*(\w+) = (\{.*\}|\w+),)"};
    std::smatch parts;
    if (line == "}") {
      end_entry();
    } else if (std::regex_match(line, parts, field)) {
      add_field(parts[1], text_of(parts[2]));
    } else {
      fail(
          fmt::format("found \"{}\"; it must be `name = {{text}},`, `name = number,`, `name = string,` or `}}`", line));
    }
  }

  /// The text of a value: the text between its braces, its digits, or the text of the string that it names.
  std::string text_of(const std::string& value) const {
    if (value.front() == '{') {
      if (!is_braced(value)) fail(fmt::format("found \"{}\"; its braces do not match", value));
      return value.substr(1, value.size() - 2);
    }
    if (value.find_first_not_of("0123456789") == std::string::npos) return value;
    const auto string = strings_.find(value);
    if (string != strings_.end()) return string->second;
    std::vector<std::string> known;
    for (const auto& [name, text] : strings_)
      known.push_back(name);
    fail(unknown_name("string", value, known).what());
  }

  void add_field(const std::string& name, const std::string& text) {
    Reference& work = works_.back();
    const auto refuse = [&](std::string_view rule) {
      fail(fmt::format("{}: found \"{}\"; it must {}", name, text, rule));
    };
    if (!contains(field_names, name))
      fail(unknown_name("field", name, {field_names.begin(), field_names.end()}).what());
    if (!work.field(name).empty()) fail(fmt::format("{}: it is given twice", name));
    if (text.find_first_not_of(' ') == std::string::npos) refuse("not be empty");
    if (name != "url" && text.find_first_of("\\$%#&~^") != std::string::npos)
      refuse("be in UTF-8 without LaTeX's commands and special characters \\ $ % # & ~ ^");
    if (contains(verbatim_fields, name) && !is_braced(text))
      refuse("be in two pairs of braces, {{..}}, which preserve its capitals");
    work.fields.emplace_back(name, text);
  }

  void end_entry() {
    const Reference& work = works_.back();
    const auto type =
        std::find_if(entry_types.begin(), entry_types.end(), [&](const EntryType& t) { return t.name == work.type; });
    for (const std::string_view name : type->required) {
      const bool edited = name == "author" && !work.field("editor").empty();
      if (!name.empty() && work.field(name).empty() && !edited)
        fail(fmt::format("{}: it is missing; @{} requires it", name, work.type));
    }
    const std::string digits = work.key.substr(std::min(work.key.size(), work.key.find_first_of("0123456789")));
    if (digits != work.field("year"))
      fail(fmt::format("year: found \"{}\"; the key must be a name and the year", work.field("year")));
    in_entry_ = false;
  }

  std::string_view name_;
  int line_ = 0;
  bool in_entry_ = false;
  std::vector<Reference> works_;
  std::map<std::string, std::string> strings_;
};

}  // namespace

std::string Reference::field(std::string_view name) const {
  const auto field = std::find_if(fields.begin(), fields.end(), [&](const auto& f) { return f.first == name; });
  return field == fields.end() ? "" : field->second;
}

bool Bibliography::has(std::string_view key) const {
  return std::any_of(works.begin(), works.end(), [&](const Reference& work) { return work.key == key; });
}

Bibliography parse_bibliography(std::string text, std::string_view name) {
  demand_plain_lines(text, name);
  std::vector<Reference> works = BibReader{name}.works(text);
  return {std::move(text), std::move(works)};
}

Citations citations_in(const std::string& text, const Bibliography& bibliography) {
  static const std::regex name_or_year{R"([A-Z][a-z]+|\b(1[5-9]|20)\d\d\b|;)"};
  Citations citations;
  std::vector<std::string> names;
  for (std::sregex_iterator it{text.begin(), text.end(), name_or_year}, end; it != end; ++it) {
    std::string word = it->str();
    if (word == ";") {
      names.clear();
    } else if (word.front() >= 'A') {
      word.front() = static_cast<char>(word.front() - 'A' + 'a');
      names.push_back(word);
    } else {
      const auto cited = std::find_if(names.begin(), names.end(),
                                      [&](const std::string& name) { return bibliography.has(name + word); });
      if (cited == names.end()) {
        citations.missing.push_back((names.empty() ? "" : names.front() + " ") + word);
      } else {
        citations.keys.push_back(*cited + word);
      }
    }
  }
  return citations;
}

}  // namespace talus::verification
