#include "tests/messages/message_form.hpp"

#include <algorithm>
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
      scratch{R"((?:_|partial-)[0-9]{2,}(?=[_. :'"]|$))"}, process{R"(process [0-9]+)"};
  return replaced(replaced(replaced(line, folders, "$1"), scratch, ""), process, "process 1234");
}

std::string form_of(const std::string& line) {
  static const std::regex quoted{R"("(?:[^"\\]|\\.)*")"}, named{R"('[^']*')"};
  // The position: segments that end in ": ", up to one of the words with which a message begins.
  static const std::regex place{
      R"(^(?:(?:[^;:]|:(?=[0-9]))*: )+?(?=(?:found|it|its|this|give|the|a|an|no|not|neither|there|is|without|several) )"
      R"(|contact by |[a-z ]+ '\.\.\.' (?:is|was|exists)|[0-9]+ cables end))"};
  static const std::regex lists{R"((nearest|known|kept|kept of|allowed are|known pairs): [^;]*)"},
      number{R"((^|[^A-Za-z0-9_])[-+]?(?:[0-9][0-9,]*\.?[0-9]*|\.[0-9]+)(?:[eE][-+]?[0-9]+)?)"},
      parser{R"((not TOML|not XML|is truncated or not JSON): .*$)"};
  static const std::regex line_of_file{R"(^[^ :]+:[0-9]+: )"}, system{R"(^.*: (?=[A-Z][a-z]+[a-z -]+$))"};
  std::string text = replaced(replaced(lasting(line), line_of_file, ""), system, "");
  text = replaced(replaced(text, quoted, "\"...\""), named, "'...'");
  text = replaced(text, place, "");
  text = replaced(text, lists, "$1: ...");
  text = replaced(text, parser, "$1: ...");
  return replaced(text, number, "$1N");
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
      if (one.empty()) continue;
      const std::string example = lasting(one);
      const auto [place, added] = examples.try_emplace({kind, form_of(one)}, example);
      if (!added && before(example, place->second)) place->second = example;
    }
  }
  std::vector<Form> forms;
  for (const auto& [key, example] : examples)
    forms.push_back({key.first, key.second, example});
  return forms;
}

}  // namespace talus::messages
