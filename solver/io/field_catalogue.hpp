#pragma once

#include <string_view>
#include <vector>

#include "solver/io/catalogue_field.hpp"

namespace talus {

/// All fields that a scene, fence or cell file can have, in groups, in the order in which they are explained. Numeric
/// fields, shapes, laws and choices come from the lists that the readers use: Field, CountField, VectorField, Names.
[[nodiscard]] const std::vector<FieldGroup>& field_catalogue();

/// The group with the given id. Errors: InputError for an unknown id.
[[nodiscard]] const FieldGroup& field_group(std::string_view id);

/// The fields of a group, those of its base first.
[[nodiscard]] std::vector<CatalogueField> all_fields(const FieldGroup& group);

}  // namespace talus
