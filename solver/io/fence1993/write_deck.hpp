#pragma once

#include <string>

#include "solver/scenes/fence.hpp"

namespace talus {

/// The deck of a fence, each record on a line with the manual's names of its values behind. read_deck gives the fence
/// back to the last bit if it is in US units and its areas and Young's modulus can be written in inches so; otherwise
/// numbers are rounded to the deck's units in their last place. Errors: InputError naming the options of the fence that
/// no record carries and that are not those of 1993.
[[nodiscard]] std::string write_deck(const scenes::Fence& fence);

}  // namespace talus
