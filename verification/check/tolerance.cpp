#include "verification/check/tolerance.hpp"

#include <array>
#include <cmath>
#include <stdexcept>
#include <utility>

namespace talus::verification {

namespace {

constexpr std::array kinds{std::pair{Kind::exact, "exact"}, std::pair{Kind::round_off, "round_off"},
                           std::pair{Kind::truncation, "truncation"}, std::pair{Kind::model, "model"},
                           std::pair{Kind::interval, "interval"}};

}  // namespace

const char* name_of(Kind kind) {
  for (const auto& entry : kinds) {
    if (entry.first == kind) return entry.second;
  }
  throw std::invalid_argument("a kind of tolerance outside its enumeration");
}

Kind kind_named(const std::string& name) {
  for (const auto& entry : kinds) {
    if (name == entry.second) return entry.first;
  }
  throw std::invalid_argument("kind of tolerance '" + name +
                              "' is not known; known: exact, round_off, truncation, model, interval");
}

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
