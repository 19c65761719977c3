#include "tests/mutants/equivalent.hpp"

#include "tests/mutants/strict_table.hpp"

namespace talus::mutants {

std::vector<Equivalent> equivalent_mutants(const std::filesystem::path& file) {
  std::vector<Equivalent> all;
  const toml::table table = parsed(file);
  for (const toml::table* each : tables_of(table, "equivalent", {"file", "operation", "line", "new", "reason"})) {
    all.push_back({text_of(*each, "file"), text_of(*each, "operation"), text_of(*each, "line"),
                   text_of(*each, "new", true), text_of(*each, "reason")});
  }
  return all;
}

}  // namespace talus::mutants
