#pragma once

#include <nlohmann/json_fwd.hpp>

#include "solver/advise/method_advice.hpp"

namespace talus {

/// The advice on a scene's method for a quantity, as `talus advise --json` prints it: the value, the growth of
/// differences, all tried methods, and the advice or its refusal. In SI units.
[[nodiscard]] nlohmann::ordered_json advice_json(const Scene& scene, const Quantity& quantity, const AdviceRules& rules,
                                                 const Advice& advice);

}  // namespace talus
