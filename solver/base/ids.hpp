#pragma once

#include <cstddef>
#include <cstdint>

namespace talus {

/// Index of a body in Model::bodies. A distinct type, so that it cannot be confused with other indices.
enum class BodyId : std::uint32_t {};
/// Index of a cable in Model::cables.
enum class CableId : std::uint32_t {};
/// Index of a contact in Model::contacts.
enum class ContactId : std::uint32_t {};
/// Index of a hanger in Model::hangers.
enum class HangerId : std::uint32_t {};

/// The plain array index of an id.
template <class Id>
constexpr std::size_t index(Id id) {
  return static_cast<std::size_t>(id);
}

}  // namespace talus
