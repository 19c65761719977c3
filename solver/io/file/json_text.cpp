#include "solver/io/file/json_text.hpp"

#include "solver/base/error.hpp"
#include "solver/io/file/toml_document.hpp"
#include "verification/record/error.hpp"
#include "verification/record/json_depth.hpp"

namespace talus {

std::string read_json_text(const std::filesystem::path& file) {
  std::string text = read_text(file);
  try {
    records::demand_shallow_json(text, file);
  } catch (const records::RecordError& error) {
    throw InputError{error.what()};
  }
  return text;
}

}  // namespace talus
