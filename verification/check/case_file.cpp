#include "verification/check/case_file.hpp"

#include <utility>

namespace talus::verification {
namespace {

std::filesystem::path& folder() {
  static std::filesystem::path chosen{TALUS_CASES};
  return chosen;
}

}  // namespace

std::filesystem::path case_file(const std::filesystem::path& name) { return folder() / name; }

void replace_case_folder(std::filesystem::path replacement) { folder() = std::move(replacement); }

}  // namespace talus::verification
