#include "solver/base/error.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <numeric>

namespace talus {
namespace {

constexpr char lower(char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c; }

/// Weighted edit distance from `found` to `known` (Levenshtein's row-by-row recurrence). A missing letter costs least,
/// because names are more often abbreviated than extended: "verlett" is nearest to velocity_verlet, not to rk4.
std::size_t edit_cost(std::string_view found, std::string_view known) {
  constexpr std::size_t left_out = 1, other_case = 1, wrong = 3, too_many = 3;
  std::vector<std::size_t> row(known.size() + 1);
  std::iota(row.begin(), row.end(), std::size_t{0});
  for (std::size_t i = 1; i <= found.size(); ++i) {
    std::size_t diagonal = row[0];
    row[0] = i * too_many;
    for (std::size_t j = 1; j <= known.size(); ++j) {
      const char f = found[i - 1], k = known[j - 1];
      const std::size_t kept = diagonal + (f == k ? 0 : lower(f) == lower(k) ? other_case : wrong);
      diagonal = row[j];
      row[j] = std::min({row[j] + too_many, row[j - 1] + left_out, kept});
    }
  }
  return row.back();
}

}  // namespace

std::string nearest_name(std::string_view found, const std::vector<std::string>& known) {
  const auto nearer = [found](const std::string& a, const std::string& b) {
    return edit_cost(found, a) < edit_cost(found, b);
  };
  const auto best = std::min_element(known.begin(), known.end(), nearer);
  return best == known.end() ? std::string{} : *best;
}

InputError unknown_name(std::string_view kind, std::string_view found, const std::vector<std::string>& known) {
  if (known.empty()) return InputError{fmt::format("{} '{}' is not known; there is none", kind, found)};
  constexpr std::size_t maximum_named = 60;
  const std::size_t named = std::min(known.size(), maximum_named);
  const std::string more = known.size() > named ? fmt::format(" and {} more", known.size() - named) : "";
  return InputError{
      fmt::format("{} '{}' is not known; nearest: {}; known: {}{}", kind, found, nearest_name(found, known),
                  fmt::join(known.begin(), known.begin() + static_cast<std::ptrdiff_t>(named), ", "), more)};
}

void demand_failed(const char* condition, const char* file, int line) {
  std::fprintf(stderr, "%s:%d: the program's own contract is broken: %s\n", file, line, condition);
  std::abort();
}

}  // namespace talus
