#pragma once

#include <clang-c/Index.h>

#include <filesystem>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

namespace talus::mutants {

/// Part of a source: bytes [begin, end).
struct Extent {
  std::size_t begin{};
  std::size_t end{};

  [[nodiscard]] std::size_t size() const { return end - begin; }
};

/// A node of a source's syntax tree, as given by libclang.
class Node {
 public:
  explicit Node(CXCursor cursor) : cursor_{cursor} {}

  [[nodiscard]] CXCursorKind kind() const { return clang_getCursorKind(cursor_); }
  /// Extent in the main file; size 0 if the node is in another file, or contains a macro.
  [[nodiscard]] Extent extent() const;
  [[nodiscard]] std::string name() const;
  /// Canonical type, as the compiler writes it; for an uninstantiated template "<dependent type>" or with its
  /// parameters.
  [[nodiscard]] std::string type() const;
  [[nodiscard]] CXTypeKind type_kind() const { return clang_getCanonicalType(clang_getCursorType(cursor_)).kind; }
  [[nodiscard]] std::vector<Node> children() const;
  /// The declaration that a name refers to; a node of kind CXCursor_InvalidFile if it is not known.
  [[nodiscard]] Node referenced() const { return Node{clang_getCursorReferenced(cursor_)}; }
  /// The scope to which a declaration belongs.
  [[nodiscard]] Node owner() const { return Node{clang_getCursorSemanticParent(cursor_)}; }
  [[nodiscard]] bool is_null() const { return clang_Cursor_isNull(cursor_) != 0; }
  [[nodiscard]] bool in_main_file() const {
    return clang_Location_isFromMainFile(clang_getCursorLocation(cursor_)) != 0;
  }
  /// The expression without implicit conversions and temporaries. Parentheses remain.
  [[nodiscard]] Node bare() const;

 private:
  CXCursor cursor_;
};

struct Dispose {
  void operator()(CXIndex index) const { clang_disposeIndex(index); }
  void operator()(CXTranslationUnit unit) const { clang_disposeTranslationUnit(unit); }
};
using Unit = std::unique_ptr<CXTranslationUnitImpl, Dispose>;

/// Parses the library headers that the files include, once, and writes `precompiled`. Each source is then parsed in a
/// third of the time. Errors: std::runtime_error.
void precompile_libraries(const std::filesystem::path& root, const std::vector<std::string>& files,
                          const std::filesystem::path& precompiled);

/// The syntax tree of one source or header, read as C++20 with the project's include folders.
class Source {
 public:
  /// `precompiled`: written by precompile_libraries().
  /// Errors: std::runtime_error if it cannot be read or has errors, with the first of them.
  Source(const std::filesystem::path& root, const std::string& file, const std::filesystem::path& precompiled);

  [[nodiscard]] Node top() const { return Node{clang_getTranslationUnitCursor(unit_.get())}; }
  [[nodiscard]] const std::string& text() const { return text_; }
  [[nodiscard]] std::string_view text(Extent extent) const {
    return std::string_view(text_).substr(extent.begin, extent.size());
  }

 private:
  std::string text_;
  std::unique_ptr<void, Dispose> index_;
  Unit unit_;
};

}  // namespace talus::mutants
