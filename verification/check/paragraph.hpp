#pragma once

#include <string>
#include <string_view>

namespace talus::verification {

/// The paragraph of a page that begins with "**LABEL.** ", without this label, as Markdown on one line; empty if there
/// is none.
[[nodiscard]] std::string paragraph_of(std::string_view page, std::string_view label);

}  // namespace talus::verification
