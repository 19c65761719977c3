#pragma once

#include <string>

namespace CLI {
class App;
}  // namespace CLI

namespace talus {

/// The shells whose scripts can be written: bash, zsh, fish.
enum class Shell { bash, zsh, fish };

/// A script that makes the shell complete the commands of a program and their options; where no option begins, files.
[[nodiscard]] std::string completion(const CLI::App& program, Shell shell);

}  // namespace talus
