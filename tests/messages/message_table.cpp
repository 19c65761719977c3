/// talus_message_table RECORDED CURES OUT: writes the messages that a recorder noted (recorder.cpp) as the page
/// docs/messages.md, with the cures of a file (cures.txt).
/// Exit status: 0 written, 1 it could not be written or a message has no cure, 2 wrong command line.
#include <fmt/format.h>

#include <exception>
#include <fstream>
#include <iterator>
#include <string>
#include <vector>

#include "tests/messages/message_form.hpp"
#include "verification/record/whole_file.hpp"

namespace {

using talus::messages::Cure;
using talus::messages::Form;

/// Text as code in a cell of a table.
std::string cell(const std::string& text) {
  std::string code = text.find('`') == std::string::npos ? "`" + text + "`" : "`` " + text + " ``";
  for (std::size_t at = code.find('|'); at != std::string::npos; at = code.find('|', at + 2))
    code.insert(at, "\\");
  return code;
}

std::string table(const std::vector<Form>& forms, const std::vector<Cure>& cures, const std::string& kind) {
  std::string text = "| message | for example | what to do |\n|:--|:--|:--|\n";
  for (const Form& form : forms) {
    if (form.kind == kind)
      text += fmt::format("| {} | {} | {} |\n", cell(form.text), cell(form.example), cure_of(form, cures));
  }
  return text;
}

std::string page(const std::vector<Form>& forms, const std::vector<Cure>& cures) {
  return fmt::format(
      R"(# Error messages

Error messages of `talus` and `talus_verify`, collected from the tests (`scripts/messages`; {} messages).
A message names the place first: file, line, table or option, field. Then it says what was found, and what is allowed or
what to do. After a name that is not known it lists the nearest name and the known ones. Where a message does not say
what to do, the third column does. `...` is a name or text, `N` a number; the place is in the example.
Several errors of one file are reported together.

## Wrong input: exit status 2
Nothing was run or written.

{}
## A file or program: exit status 4
A file could not be read or written, or a program that draws could not be started. What was written before is whole.

{})",
      forms.size(), table(forms, cures, "input"), table(forms, cures, "file"));
}

}  // namespace

int main(int argc, char** argv) {
  if (argc != 4) {
    fmt::print(stderr, "usage: talus_message_table RECORDED CURES OUT\n");
    return 2;
  }
  try {
    std::ifstream in{argv[1]};
    std::vector<std::string> lines;
    for (std::string line; std::getline(in, line);)
      lines.push_back(line);
    // Mutated files are refused in many ways; users meet the messages that the tests provoke on purpose.
    const auto forms =
        talus::messages::forms_of(lines, {"talus_mutate_inputs", "test_catalogue", "test_input_campaign"});
    std::ifstream listed{argv[2]};
    const auto cures = talus::messages::read_cures(listed);
    talus::records::write_whole(argv[3], page(forms, cures));
    fmt::print("{}: {} messages\n", argv[3], forms.size());
    const auto errors = talus::messages::cure_errors(forms, cures);
    for (const std::string& error : errors)
      fmt::print(stderr, "talus_message_table: {}\n", error);
    return errors.empty() ? 0 : 1;
  } catch (const std::exception& fault) {
    fmt::print(stderr, "talus_message_table: {}\n", fault.what());
    return 1;
  }
}
