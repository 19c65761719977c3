#include "verification/check/tolerance.hpp"

#include <cmath>
#include <stdexcept>
#include <utility>

namespace talus::verification {

Tolerance::Tolerance(Kind kind, double bound, std::string why) : kind_(kind), bound_(bound), why_(std::move(why)) {
  if (why_.find_first_not_of(" \t\n") == std::string::npos) {
    throw std::invalid_argument("a tolerance must say in words why its bound holds");
  }
  if (kind != Kind::exact && !(std::isfinite(bound) && bound > 0.0)) {
    throw std::invalid_argument("a tolerance's bound must be finite and greater than zero: " + why_);
  }
}

Tolerance Tolerance::exact(std::string why) { return {Kind::exact, 0.0, std::move(why)}; }

Tolerance Tolerance::round_off(double bound, std::string why) { return {Kind::round_off, bound, std::move(why)}; }

Tolerance Tolerance::truncation(double predicted_error, double factor, std::string why) {
  if (!(factor >= 1.0 && factor <= 3.0)) {
    throw std::invalid_argument("a truncation bound is at most 3 times the constant measured (and at least once): " +
                                why);
  }
  return {Kind::truncation, factor * predicted_error, std::move(why)};
}

Tolerance Tolerance::model(double bound, std::string why) { return {Kind::model, bound, std::move(why)}; }

Tolerance Tolerance::relative() const {
  Tolerance copy = *this;
  copy.relative_ = true;
  return copy;
}

}  // namespace talus::verification
