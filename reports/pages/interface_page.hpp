/// The report's chapter on the program's interface: what the cases would notice if one item of it were wrong.
#pragma once

#include <string>
#include <vector>

#include "verification/record/interface.hpp"

namespace talus::reports {

/// Markdown: a table by kind, and the items without a case that would notice.
[[nodiscard]] std::string interface_text(const std::vector<records::InterfaceItem>& items);

}  // namespace talus::reports
