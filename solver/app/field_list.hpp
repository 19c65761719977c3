#pragma once

#include <string>

#include "solver/io/field_catalogue.hpp"

namespace talus::app {

/// The fields of a group, not of its base, as text: head and meaning of the group, then for each field its mark if it
/// is required, its name, its meaning, how it is written, the values allowed and what it is where it is left out. Lines
/// have at most 110 columns.
[[nodiscard]] std::string field_list(const FieldGroup& group);

/// The meaning of the mark, for the head of a list.
[[nodiscard]] std::string field_list_legend();

}  // namespace talus::app
