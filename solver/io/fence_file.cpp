#include "solver/io/fence_file.hpp"

#include <fmt/format.h>

#include "solver/base/error.hpp"
#include "solver/io/fence1993/read_deck.hpp"
#include "solver/io/fence1993/write_deck.hpp"
#include "solver/io/scene/read_fence.hpp"
#include "solver/io/scene/write_fence.hpp"

namespace talus {

namespace {

/// The file's extension in lower case.
std::string small_extension(const std::filesystem::path& file) {
  std::string extension = file.extension().string();
  for (char& c : extension)
    c = c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
  return extension;
}

}  // namespace

bool is_deck(const std::filesystem::path& file) { return small_extension(file) == ".dat"; }

FenceFormat fence_format(const std::filesystem::path& file) {
  if (is_deck(file)) return FenceFormat::deck;
  if (small_extension(file) == ".toml") return FenceFormat::toml;
  throw InputError{fmt::format("{}: found the extension \"{}\"; it must be .DAT (a deck of 1993) or .toml (a scene)",
                               file.string(), file.extension().string())};
}

scenes::Fence read_fence(const std::filesystem::path& file) {
  if (fence_format(file) == FenceFormat::deck) return read_deck(file);
  const TomlValue document = parse_toml(read_text(file), file.string());
  SceneSource source{file.string(), si};
  SceneTable table{source, document, ""};
  if (!table.has("fence")) {
    throw InputError{
        fmt::format("{}: it has no table [fence]; only a fence can be converted, since the records of a "
                    "deck describe nothing else",
                    file.string())};
  }
  source.collect();
  try {
    return read_fence(table, source);
  } catch (const SceneSource::Collected&) {
    source.check();
    throw;
  }
}

std::string fence_text(const scenes::Fence& fence, FenceFormat format) {
  return format == FenceFormat::deck ? write_deck(fence) : write_fence(fence);
}

}  // namespace talus
