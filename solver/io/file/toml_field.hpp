#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "solver/io/file/toml_document.hpp"

namespace talus {

/// A key of the path to a field, with the index behind it.
struct FieldKey {
  std::string key;
  std::optional<std::size_t> index;
};

/// The keys of a path such as "run.step", "gravity[1]", "fence.rock[0].a" or "body.disc.shape.radius". Errors:
/// InputError for a text that is no path.
[[nodiscard]] std::vector<FieldKey> field_keys(std::string_view path);

/// One value of a document; it is added, empty, if only the last key is missing, or tables `options` or `watch` above
/// it, which files may leave out. `path`: keys separated by dots, an element of an array by its index from 0, and a
/// table of a list by its name or index. Errors: InputError with the part that was not found, and what is there.
[[nodiscard]] TomlValue& field_at(TomlValue& document, std::string_view path);

/// Sets that value. Errors: as field_at().
void set_field(TomlValue& document, std::string_view path, const TomlValue& value);

}  // namespace talus
