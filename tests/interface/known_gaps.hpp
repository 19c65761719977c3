/// Items of the interface that no case notices or uses, each with the reason why that is accepted.
#pragma once

#include <map>
#include <string>
#include <vector>

#include "verification/record/interface.hpp"

namespace talus::interface_audit {

/// Reasons by status and item, "survived: option study --threads".
using KnownGaps = std::map<std::string, std::string>;

/// Reads lines `STATUS: ITEM -- REASON`; empty lines and lines that begin with # are skipped. Throws std::runtime_error
/// with the line's number if a line has another form, another status than survived or unused, or no reason, or an item
/// is there twice.
[[nodiscard]] KnownGaps read_known_gaps(const std::string& text);

/// What differs from the known gaps: items that survived or are unused and are not known, and known ones that are
/// neither any more.
[[nodiscard]] std::vector<std::string> unexpected_gaps(const std::vector<records::InterfaceItem>& items,
                                                       const KnownGaps& known);

}  // namespace talus::interface_audit
