#pragma once

#include <string>

#include "solver/scenes/fence.hpp"

namespace talus {

/// Text of the deck of a fence, with each record on one line, followed by the manual's names of its values. read_deck
/// restores the fence to the last bit if it is in US units and its areas and Young's modulus have an exact decimal form
/// in inches; otherwise numbers are rounded in the last digit when converted to the deck's units. Errors: InputError
/// naming the options of the fence that no record carries and that differ from those of 1993.
[[nodiscard]] std::string write_deck(const scenes::Fence& fence);

}  // namespace talus
