#pragma once

#include <filesystem>
#include <span>
#include <string>
#include <vector>

namespace talus::mutants {

/// A generated mutant that changes no result, and why. It is identified by its texts, not by its line number.
struct Equivalent {
  std::string file{};
  std::string operation{};
  std::string line{};         ///< the source line on which it begins, without surrounding spaces
  std::string replacement{};  ///< its new text
  std::string reason{};
};

/// The tables [[equivalent]] of a TOML file, with keys file, operation, line, new, reason.
/// Errors: std::runtime_error with file and line for a file that is not TOML, and for a missing or unknown key.
[[nodiscard]] std::vector<Equivalent> equivalent_mutants(const std::filesystem::path& file);

}  // namespace talus::mutants
