#include "tests/mutants/syntax.hpp"

#include <fmt/format.h>

#include <fstream>
#include <set>
#include <sstream>
#include <stdexcept>

namespace talus::mutants {

namespace {

std::string taken(CXString string) {
  const char* const text = clang_getCString(string);
  std::string result = text == nullptr ? "" : text;
  clang_disposeString(string);
  return result;
}

/// Byte offset of a location; sets `as_written` to false in a macro.
std::size_t offset_of(CXSourceLocation location, bool& as_written) {
  unsigned expansion = 0;
  unsigned spelling = 0;
  CXFile expanded = nullptr;
  CXFile spelled = nullptr;
  clang_getExpansionLocation(location, &expanded, nullptr, nullptr, &expansion);
  clang_getSpellingLocation(location, &spelled, nullptr, nullptr, &spelling);
  as_written = as_written && expansion == spelling && clang_File_isEqual(expanded, spelled) != 0;
  return expansion;
}

/// Parses a file; `more` are further options. Errors: std::runtime_error with the first error in it.
Unit parsed(CXIndex index, const std::filesystem::path& root, const std::filesystem::path& file,
            std::vector<std::string> more, unsigned how) {
  more.insert(more.end(), {"-std=c++20", "-I" + root.string(), "-isystem/usr/include/eigen3", "-w", "-ferror-limit=1"});
  std::vector<const char*> options;
  for (const std::string& option : more)
    options.push_back(option.c_str());
  CXTranslationUnit read = nullptr;
  const CXErrorCode fault = clang_parseTranslationUnit2(index, file.c_str(), options.data(),
                                                        static_cast<int>(options.size()), nullptr, 0, how, &read);
  Unit unit{read};
  if (fault != CXError_Success) throw std::runtime_error(fmt::format("{}: libclang cannot read it", file.string()));
  for (unsigned i = 0; i < clang_getNumDiagnostics(read); ++i) {
    const CXDiagnostic diagnostic = clang_getDiagnostic(read, i);
    const bool is_error = clang_getDiagnosticSeverity(diagnostic) >= CXDiagnostic_Error;
    const std::string message = taken(clang_formatDiagnostic(diagnostic, CXDiagnostic_DisplaySourceLocation));
    clang_disposeDiagnostic(diagnostic);
    if (is_error) throw std::runtime_error(fmt::format("{}: libclang cannot read it: {}", file.string(), message));
  }
  return unit;
}

CXChildVisitResult collect(CXCursor child, CXCursor /*parent*/, CXClientData data) {
  static_cast<std::vector<Node>*>(data)->emplace_back(child);
  return CXChildVisit_Continue;
}

}  // namespace

Extent Node::extent() const {
  const CXSourceRange range = clang_getCursorExtent(cursor_);
  bool as_written = clang_Location_isFromMainFile(clang_getRangeStart(range)) != 0;
  Extent extent;
  extent.begin = offset_of(clang_getRangeStart(range), as_written);
  extent.end = offset_of(clang_getRangeEnd(range), as_written);
  return as_written && extent.begin < extent.end ? extent : Extent{};
}

std::string Node::name() const { return taken(clang_getCursorSpelling(cursor_)); }

std::string Node::type() const {
  return taken(clang_getTypeSpelling(clang_getCanonicalType(clang_getCursorType(cursor_))));
}

std::vector<Node> Node::children() const {
  std::vector<Node> found;
  clang_visitChildren(cursor_, collect, &found);
  return found;
}

Node Node::bare() const {
  Node node = *this;
  while (node.kind() == CXCursor_UnexposedExpr) {
    const auto inner = node.children();
    if (inner.size() != 1 || inner[0].extent().begin != node.extent().begin ||
        inner[0].extent().end != node.extent().end)
      return node;
    node = inner[0];
  }
  return node;
}

void precompile_libraries(const std::filesystem::path& root, const std::vector<std::string>& files,
                          const std::filesystem::path& precompiled) {
  std::set<std::string> lines;
  for (const std::string& file : files) {
    std::ifstream in(root / file);
    for (std::string line; std::getline(in, line);) {
      if (line.starts_with("#include <")) lines.insert(line);
    }
  }
  std::filesystem::path header = precompiled;
  header.replace_extension(".hpp");
  std::ofstream out(header);
  for (const std::string& line : lines)
    out << line << "\n";
  out.close();
  const std::unique_ptr<void, Dispose> index{clang_createIndex(0, 0)};
  const Unit unit = parsed(index.get(), root, header, {"-xc++-header"}, CXTranslationUnit_ForSerialization);
  if (clang_saveTranslationUnit(unit.get(), precompiled.c_str(), 0) != CXSaveError_None)
    throw std::runtime_error(fmt::format("{}: cannot be written", precompiled.string()));
}

Source::Source(const std::filesystem::path& root, const std::string& file, const std::filesystem::path& precompiled)
    : index_{clang_createIndex(0, 0)} {
  std::ifstream in(root / file, std::ios::binary);
  std::ostringstream text;
  text << in.rdbuf();
  if (!in) throw std::runtime_error(fmt::format("{}: cannot be read", file));
  text_ = text.str();
  unit_ = parsed(index_.get(), root, root / file, {"-xc++", "-include-pch", precompiled.string()}, 0);
}

}  // namespace talus::mutants
