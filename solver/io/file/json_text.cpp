#include "solver/io/file/json_text.hpp"

#include "solver/base/error.hpp"
#include "solver/io/file/toml_document.hpp"
#include "verification/record/error.hpp"
#include "verification/record/json_depth.hpp"

namespace talus {

std::string read_json_text(const std::filesystem::path& file) {
  std::string text = read_text(file);
  demand_shallow_json(text, file);
  return text;
}

void demand_shallow_json(std::string_view text, const std::filesystem::path& file, std::size_t line) {
  try {
    records::demand_shallow_json(text, file, line);
  } catch (const records::RecordError& error) {
    throw InputError{error.what()};
  }
}

}  // namespace talus
