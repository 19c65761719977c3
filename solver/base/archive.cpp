#include "solver/base/archive.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "solver/base/error.hpp"

namespace talus {

namespace {

bool is_whole(double value, double largest) { return value >= 0.0 && value <= largest && value == std::floor(value); }

}  // namespace

std::vector<std::string> Archive::left_over() const {
  std::vector<std::string> names;
  if (!saved_) return names;
  for (const auto& [name, value] : *saved_) {
    if (!items_.contains(name)) names.push_back(name);
  }
  return names;
}

template <class Kind>
const Kind& Archive::saved(std::string_view name, std::string_view kind) {
  const std::string full = full_name(name);
  const auto found = saved_->find(full);
  if (found == saved_->end()) throw InputError{fmt::format("{}: it is missing; it must be {}", full, kind)};
  const Kind* value = std::get_if<Kind>(&found->second);
  if (!value) {
    throw InputError{fmt::format("{}: found {}; it must be {}", full,
                                 found->second.index() == 0 ? "a list of numbers" : "a text", kind)};
  }
  items_.emplace(full, Kind{});
  return *value;
}

void Archive::numbers(std::string_view name, std::span<double> values) {
  if (!saved_) {
    items_.insert_or_assign(full_name(name), std::vector<double>(values.begin(), values.end()));
    return;
  }
  const auto& found = saved<std::vector<double>>(name, "a list of numbers");
  if (found.size() != values.size()) {
    throw InputError{
        fmt::format("{}: found {} numbers; it must have {}", full_name(name), found.size(), values.size())};
  }
  std::copy(found.begin(), found.end(), values.begin());
}

void Archive::vector(std::string_view name, Vec2& value) {
  std::array kept{value.x, value.y};
  numbers(name, kept);
  value = {kept[0], kept[1]};
}

void Archive::vector(std::string_view name, Vec3& value) {
  std::array kept{value.x, value.y, value.z};
  numbers(name, kept);
  value = {kept[0], kept[1], kept[2]};
}

void Archive::list(std::string_view name, std::vector<double>& values) {
  if (saved_) {
    values = saved<std::vector<double>>(name, "a list of numbers");
  } else {
    items_.insert_or_assign(full_name(name), values);
  }
}

void Archive::text(std::string_view name, std::string& value) {
  if (saved_) {
    value = saved<std::string>(name, "a text");
  } else {
    items_.insert_or_assign(full_name(name), value);
  }
}

void Archive::demand_whole(std::string_view name, double value, double largest) const {
  if (is_whole(value, largest)) return;
  throw InputError{
      fmt::format("{}: found {}; it must be a whole number from 0 to {}", full_name(name), value, largest)};
}

void Archive::count(std::string_view name, long& value) {
  auto kept = static_cast<double>(value);
  number(name, kept);
  demand_whole(name, kept, 0x1p53);
  value = static_cast<long>(kept);
}

void Archive::flag(std::string_view name, bool& value) {
  double kept = value ? 1.0 : 0.0;
  number(name, kept);
  demand_whole(name, kept, 1.0);
  value = kept == 1.0;
}

void Archive::numbers(std::string_view name, std::span<std::uint16_t> values) {
  constexpr double largest = std::numeric_limits<std::uint16_t>::max();
  std::vector<double> kept(values.begin(), values.end());
  numbers(name, kept);
  for (std::size_t i = 0; i < kept.size(); ++i) {
    // The name of an element is made for an error only: there may be millions.
    if (!is_whole(kept[i], largest)) demand_whole(fmt::format("{}[{}]", name, i), kept[i], largest);
    values[i] = static_cast<std::uint16_t>(kept[i]);
  }
}

}  // namespace talus
