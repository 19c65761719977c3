#include "verification/check/case.hpp"

#include <stdexcept>

namespace talus::verification {

const char* name_of(Tier tier) { return tier == Tier::quick ? "quick" : "full"; }

Tier tier_named(const std::string& name) {
  if (name == "quick") return Tier::quick;
  if (name == "full") return Tier::full;
  throw std::invalid_argument("tier '" + name + "' is not known; known: quick, full");
}

}  // namespace talus::verification
