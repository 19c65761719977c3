#pragma once

#include <vector>

#include "solver/io/catalogue_field.hpp"

namespace talus {

/// The groups of fields of a fence file, in the order in which they are explained.
[[nodiscard]] std::vector<FieldGroup> fence_field_groups();

}  // namespace talus
