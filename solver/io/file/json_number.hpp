#pragma once

#include <nlohmann/json_fwd.hpp>

namespace talus {

/// A number in JSON; one that is not finite, for which JSON has none, as the text "nan", "inf" or "-inf".
[[nodiscard]] nlohmann::ordered_json json_number(double value);

}  // namespace talus
