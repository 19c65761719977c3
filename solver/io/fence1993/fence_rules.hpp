#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

#include "solver/scenes/fence.hpp"

namespace talus {

using scenes::FenceFault;

/// All violations of the rules between records, for files of any format; empty if the fence can be built. Rules for a
/// single number belong to its field.
[[nodiscard]] std::vector<FenceFault> faults(const scenes::Fence& fence);

/// Reason why a text in UTF-8 cannot be a title; empty if it can.
[[nodiscard]] std::string title_error(std::string_view title);

/// Maximum number of codes that the 1993 program could store.
inline constexpr std::size_t maximum_history_codes = 8;
/// Largest code of a quantity in its list.
inline constexpr int last_history_code = 61;

}  // namespace talus
