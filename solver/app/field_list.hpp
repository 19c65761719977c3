#pragma once

#include <string>

#include "solver/io/field_catalogue.hpp"

namespace talus::app {

/// The fields of a group, without those of its base, as text: head and meaning of the group, then for each field a mark
/// if it is required, its name, meaning, notation, allowed values and default. Lines have at most 110 columns.
[[nodiscard]] std::string field_list(const FieldGroup& group);

/// Explanation of the mark, for the head of a list.
[[nodiscard]] std::string field_list_legend();

}  // namespace talus::app
