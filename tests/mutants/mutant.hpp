#pragma once

#include <cstddef>
#include <string>
#include <vector>

namespace talus::mutants {

/// Kind of code that a mutant replaces.
enum class Form {
  expression,  ///< becomes (on(K) ? (new) : (old))
  statement,   ///< one or more whole statements: become if (on(K)) { new } else { old }
};

/// A position in a source and the text that replaces it.
struct Edit {
  std::string file{};         ///< path in the source tree
  std::size_t begin{};        ///< first byte that is replaced
  std::size_t end{};          ///< behind the last one
  Form form{};                ///< kind of the replaced code
  std::string replacement{};  ///< new text; for a statement it may be empty
};

/// A small change of the solver that is compiled in and switched on at run time (schemata: Untch 1992).
struct Mutant {
  std::string id{};                  ///< unique: the name of a written bug, or FILE:LINE:COLUMN:OPERATION:N
  std::string operation{};           ///< mutation operator, or "bug"
  std::string description{};         ///< description of the fault for a reader
  std::vector<Edit> edits{};         ///< one position; written bugs may have several
  std::vector<std::string> cases{};  ///< of a written bug: at least one must turn red; "*": all that evaluate it
};

}  // namespace talus::mutants
