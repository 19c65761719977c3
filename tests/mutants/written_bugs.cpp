#include "tests/mutants/written_bugs.hpp"

#include <fmt/format.h>

#include <set>
#include <stdexcept>

#include "tests/mutants/strict_table.hpp"
#include "verification/record/whole_file.hpp"

namespace talus::mutants {

namespace {

namespace fs = std::filesystem;

Form form_of(const toml::table& table) {
  const std::string form = text_of(table, "form");
  if (form == "expression") return Form::expression;
  if (form == "statement") return Form::statement;
  refuse(table.source(), fmt::format("form is '{}'; allowed: expression, statement", form));
}

Edit edit_of(const toml::table& table, const fs::path& root) {
  Edit edit{.file = text_of(table, "file"), .begin = 0, .end = 0, .form = form_of(table), .replacement = {}};
  const std::string old = text_of(table, "old");
  edit.replacement = text_of(table, "new", edit.form == Form::statement);
  const std::string text = records::read_whole(root / edit.file);
  edit.begin = text.find(old);
  if (edit.begin == std::string::npos) refuse(table.source(), fmt::format("{} does not hold 'old'", edit.file));
  if (text.find(old, edit.begin + 1) != std::string::npos)
    refuse(table.source(), fmt::format("{} holds 'old' more than once", edit.file));
  edit.end = edit.begin + old.size();
  return edit;
}

std::vector<std::string> cases_of(const toml::table& table) {
  std::vector<std::string> cases;
  if (const auto* const list = table["cases"].as_array()) {
    for (const auto& entry : *list) {
      const auto name = entry.value<std::string>();
      if (!name) refuse(entry.source(), "cases must be names of cases");
      cases.push_back(*name);
    }
  }
  if (cases.empty()) refuse(table.source(), "cases is missing; it must name those that turn red");
  return cases;
}

Mutant bug_of(const toml::table& table, const fs::path& root) {
  Mutant bug{.id = text_of(table, "id"), .operation = "bug", .description = text_of(table, "bug")};
  bug.edits.push_back(edit_of(table, root));
  for (const toml::table* also : tables_of(table, "also", {"file", "form", "old", "new"}))
    bug.edits.push_back(edit_of(*also, root));
  bug.cases = cases_of(table);
  return bug;
}

}  // namespace

std::vector<Mutant> written_bugs(const fs::path& folder, const fs::path& root) {
  std::set<fs::path> files;
  for (const auto& entry : fs::directory_iterator(folder)) {
    if (entry.path().extension() == ".toml") files.insert(entry.path());
  }
  std::vector<Mutant> bugs;
  std::set<std::string> ids;
  for (const fs::path& file : files) {
    const toml::table table = parsed(file);
    for (const toml::table* bug :
         tables_of(table, "bug", {"id", "file", "form", "old", "new", "bug", "source", "cases", "also"})) {
      bugs.push_back(bug_of(*bug, root));
      if (!ids.insert(bugs.back().id).second)
        refuse(bug->source(), fmt::format("id '{}' is used twice", bugs.back().id));
    }
  }
  return bugs;
}

}  // namespace talus::mutants
