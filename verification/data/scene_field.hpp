#pragma once

#include <string>

namespace talus::verification {

/// The text of a scene, TOML, with one field changed. `field` is the path to it: keys separated by dots, an element of
/// an array by its index, and a table of a list by its name: "gravity[1]", "run.step", "body.disc.shape.radius". The
/// last key may be new. `value` is TOML: "0.3", "\"5 m/s\"". Errors: InputError with the part that was not found, and
/// what is there.
[[nodiscard]] std::string with_field(const std::string& scene, const std::string& field, const std::string& value);

}  // namespace talus::verification
