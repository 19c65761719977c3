#include "tests/messages/message_form.hpp"

#include <algorithm>
#include <istream>
#include <map>
#include <regex>
#include <sstream>
#include <stdexcept>
#include <utility>

namespace talus::messages {
namespace {

std::string replaced(const std::string& text, const std::regex& what, const char* by) {
  return std::regex_replace(text, what, by);
}

/// Shorter first, because the first is used as the example.
bool before(const std::string& a, const std::string& b) { return a.size() != b.size() ? a.size() < b.size() : a < b; }

}  // namespace

std::string lasting(const std::string& line) {
  static const std::regex folders{R"((^|[ '"])(?:/[^/ :'"]+)+/(?=[^/ :'"]))"},
      scratch{R"((?:_|partial-)[0-9]{2,}(?=[_. :'"]|$))"},
      temporary{R"((talus_(?:test|case))_[A-Za-z0-9]{6}(?![A-Za-z0-9]))"}, process{R"(process [0-9]+)"},
      hash{R"((^|[^A-Za-z0-9.])(?=[0-9]*[a-f])[0-9a-f]{16}(?![A-Za-z0-9]))"};
  const std::string text = replaced(replaced(replaced(line, folders, "$1"), temporary, "$1"), scratch, "");
  return replaced(replaced(text, process, "process 1234"), hash, "$010123456789abcdef");
}

std::string form_of(const std::string& line) {
  static const std::regex quoted{R"("(?:[^"\\]|\\.)*")"}, named{R"('[^']*')"};
  // The position: segments that end in ": ", up to one of the words with which a message begins.
  static const std::regex location{
      R"(^(?:(?:[^;:]|:(?=[0-9]))*: )+?(?=(?:found|it|its|this|give|given|possible|the|a|an|no|not|neither|there|is)"
      R"(|several|none|must) |contact by |[0-9]+ of [0-9]+ runs |run [0-9a-f]+ has |'\.\.\.' (?:and '|is |occurs ))"
      R"(|[a-z ]+ '\.\.\.' (?:is|was|exists|belongs)|[0-9]+ cables end|line [0-9]+ joins|history [0-9]))"};
  static const std::regex lists{R"((nearest|known|recorded|recorded for|allowed are|known pairs): [^;]*)"};
  static const std::regex parser{
      R"((not TOML|not XML|is truncated or not JSON|it is not (?:a file written by|the final state of) [^:]*): .*$)"};
  static const std::regex line_of_file{R"(^[^ :]+:[0-9]+: )"}, system{R"(^.*: (?=[A-Z][a-z]+[a-z -]+$))"};
  // A year that names a format or a program is no value (a deck of 1993); neither is a digit of a name (UTF-8, K1) or
  // of a formula (1/sqrt(k)).
  static const std::regex year{R"(\b(of|by) (19[0-9]{2})\b)"},
      hex{R"((^|[^A-Za-z0-9.])(?:0x[0-9a-f]+|[0-9a-f]{16})(?![A-Za-z0-9]))"}, mark{"\x01"},
      number{R"((^|[^A-Za-z0-9_.\x01-])[-+]?[0-9]+(?:,[0-9]{3})*(?:\.[0-9]+)?(?:[eE][-+]?[0-9]+)?)"
             R"((?![A-Za-z0-9_]|[.,][0-9]|/[a-z]))"};
  std::string text = replaced(replaced(lasting(line), line_of_file, ""), parser, "$1: ...");
  text = replaced(replaced(replaced(text, system, ""), quoted, "\"...\""), named, "'...'");
  text = replaced(replaced(text, location, ""), lists, "$1: ...");
  text = replaced(replaced(text, hex, "$1N"), year, "$1 \x01$2");
  return replaced(replaced(text, number, "$1N"), mark, "");
}

bool names_cure(const std::string& form) {
  static const std::regex word_pattern{
      R"(\b(?:must|needs|requires|required|give|write|remove|delete|leave|choose|name (?:one|two|its)|set [A-Z]|take a|use (?:a|the))"
      R"(|run (?:it|them|the)|plan the|resume (?:it|the)|known:|there is none|allowed are|at most|at least|is it installed)(?![a-z]))"};
  return std::regex_search(form, word_pattern);
}

std::vector<Cure> read_cures(std::istream& in) {
  std::vector<Cure> cures;
  for (std::string line; std::getline(in, line);) {
    if (line.empty() || line.front() == '#') continue;
    if (line.front() != ' ') {
      cures.push_back({line, {}});
      continue;
    }
    const std::string added = line.substr(std::min(line.find_first_not_of(' '), line.size()));
    if (cures.empty() || added.empty()) throw std::runtime_error("cures: no message before: " + line);
    std::string& cure = cures.back().cure;
    cure += cure.empty() ? added : ' ' + added;
  }
  return cures;
}

std::vector<std::string> cure_errors(const std::vector<Form>& forms, const std::vector<Cure>& cures) {
  std::vector<std::string> errors;
  for (const Cure& cure : cures) {
    const auto is_named = [&](const Form& form) { return form.text == cure.form; };
    if (std::none_of(forms.begin(), forms.end(), is_named)) errors.push_back("no message has the form: " + cure.form);
    if (cure.cure.empty()) errors.push_back("no cure follows: " + cure.form);
  }
  for (const Form& form : forms) {
    if (!names_cure(form.text) && cure_of(form, cures).empty())
      errors.push_back("the message names no cure, and cures.txt has none: " + form.text);
  }
  return errors;
}

std::string cure_of(const Form& form, const std::vector<Cure>& cures) {
  const auto found = std::find_if(cures.begin(), cures.end(), [&](const Cure& cure) { return cure.form == form.text; });
  return found == cures.end() ? std::string{} : found->cure;
}

std::vector<Form> forms_of(const std::vector<std::string>& recorded, const std::vector<std::string>& ignored) {
  std::map<std::pair<std::string, std::string>, std::string> examples;
  for (const std::string& line : recorded) {
    const std::size_t first = line.find('\t'), second = line.find('\t', first + 1);
    if (first == std::string::npos || second == std::string::npos)
      throw std::runtime_error("not written by the recorder of messages: " + line);
    const std::string kind = line.substr(0, first), program = line.substr(first + 1, second - first - 1);
    if (std::find(ignored.begin(), ignored.end(), program) != ignored.end()) continue;
    std::istringstream lines{line.substr(second + 1)};
    for (std::string one; std::getline(lines, one, '\x1f');) {
      if (one.empty() || one.starts_with("help: ")) continue;
      const std::string example = lasting(one);
      const auto [entry, added] = examples.try_emplace({kind, form_of(one)}, example);
      if (!added && before(example, entry->second)) entry->second = example;
      if (one.back() == ':') break;  // the text of another program follows
    }
  }
  std::vector<Form> forms;
  for (const auto& [key, example] : examples)
    forms.push_back({key.first, key.second, example});
  return forms;
}

}  // namespace talus::messages
