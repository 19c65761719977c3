#pragma once

#include <string_view>

namespace talus::verification::problems {

/// The page of the case called `name`, FAMILY/NAME.md beside its source: Markdown after an empty line. Generated
/// (embed_pages.cmake); std::invalid_argument if no listed case has this name.
[[nodiscard]] std::string_view page_of(std::string_view name);

}  // namespace talus::verification::problems
