/// talus_message_table RECORDED OUT: writes the messages that a recorder noted (recorder.cpp) as the page
/// docs/messages.md.
/// Exit status: 0 written, 1 it could not be written, 2 wrong command line.
#include <fmt/format.h>

#include <exception>
#include <fstream>
#include <iterator>
#include <string>
#include <vector>

#include "tests/messages/message_form.hpp"
#include "verification/record/whole_file.hpp"

namespace {

using talus::messages::Form;

/// Text as code in a cell of a table.
std::string cell(const std::string& text) {
  std::string code = text.find('`') == std::string::npos ? "`" + text + "`" : "`` " + text + " ``";
  for (std::size_t at = code.find('|'); at != std::string::npos; at = code.find('|', at + 2))
    code.insert(at, "\\");
  return code;
}

std::string table(const std::vector<Form>& forms, const std::string& kind) {
  std::string text = "| message | for example |\n|:--|:--|\n";
  for (const Form& form : forms) {
    if (form.kind == kind) text += fmt::format("| {} | {} |\n", cell(form.text), cell(form.example));
  }
  return text;
}

std::string page(const std::vector<Form>& forms) {
  return fmt::format(
      R"(# Error messages

What `talus` and `talus_verify` say when something is wrong, as the tests provoke it (`scripts/messages`; {} messages).
A message names the place first: file, line, table or option, field. Then it says what was found, and what is allowed or
what to do. `...` is a name or text, `N` a number; the place is in the example.
Several errors of one file are reported together.

## Wrong input: exit status 2
Nothing was run or written.

{}
## A file or program: exit status 4
A file could not be read or written, or a program that draws could not be started. What was written before is whole.

{})",
      forms.size(), table(forms, "input"), table(forms, "file"));
}

}  // namespace

int main(int argc, char** argv) {
  if (argc != 3) {
    fmt::print(stderr, "usage: talus_message_table RECORDED OUT\n");
    return 2;
  }
  try {
    std::ifstream in{argv[1]};
    std::vector<std::string> lines;
    for (std::string line; std::getline(in, line);)
      lines.push_back(line);
    // Mutated files are refused in many ways; users meet the messages that the tests provoke on purpose.
    const auto forms = talus::messages::forms_of(lines, {"talus_mutate_inputs", "test_catalogue_bibliography",
                                                         "test_catalogue_catalogue", "test_input_campaign"});
    talus::records::write_whole(argv[2], page(forms));
    fmt::print("{}: {} messages\n", argv[2], forms.size());
  } catch (const std::exception& fault) {
    fmt::print(stderr, "talus_message_table: {}\n", fault.what());
    return 1;
  }
}
