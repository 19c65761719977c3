#pragma once

#include <array>
#include <string>
#include <string_view>
#include <vector>

#include "solver/base/fields.hpp"

namespace CLI {
class App;
class Option;
}  // namespace CLI

namespace talus {

/// The shells whose scripts can be written: bash, zsh, fish.
enum class Shell { bash, zsh, fish };

template <>
struct Names<Shell> {
  static constexpr std::array<std::string_view, 3> list{"bash", "zsh", "fish"};
};

/// Declares the values that an option or argument can have, so that shells complete them; the help does not list them.
/// To be called before what the option needs or excludes is declared. Returns the option.
CLI::Option* offer(CLI::Option* option, const std::vector<std::string>& values);

/// A script that makes the shell complete the commands of a program, their options, and the values that these offer()
/// or check for membership; elsewhere files.
[[nodiscard]] std::string completion(const CLI::App& program, Shell shell);

}  // namespace talus
