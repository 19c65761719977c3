#pragma once

#include <filesystem>
#include <string>
#include <string_view>

#include "solver/scenes/fence_scene.hpp"

namespace talus {

/// Reads an input file of the 1993 program FENCE, NAME.DAT (Mustoe & Huttelmaier 1993, Appendix II.4): a title, then
/// list-directed records in feet, slugs, pounds and seconds (areas in in^2, Young's modulus in lb/in^2). The fence is
/// in US units; each number is bit-identical to a scene file's quantity with the same digits. Whole numbers may be
/// written as reals. Text after the last record is ignored. Errors: IoError if the file cannot be read; InputError for
/// invalid content, of the form `sample2.DAT:5: nel, igrav, grav: nel: found "2"; it must be a whole number between 3
/// and 1002`.
[[nodiscard]] scenes::Fence read_deck(const std::filesystem::path& file);

/// The same from a text; `name` is the file named in errors.
[[nodiscard]] scenes::Fence read_deck(std::string_view text, std::string_view name);

/// The scene of the fence that was read from a text. Errors: InputError with the line of the field because of which the
/// fence cannot be built.
[[nodiscard]] scenes::FenceScene deck_scene(const scenes::Fence& fence, std::string_view text, std::string_view name);

}  // namespace talus
