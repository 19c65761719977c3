#include "solver/base/error.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <numeric>

namespace talus {
namespace {

/// Levenshtein's distance: the fewest insertions, deletions and substitutions that turn a into b (row-by-row
/// recurrence).
std::size_t edit_distance(std::string_view a, std::string_view b) {
  std::vector<std::size_t> row(b.size() + 1);
  std::iota(row.begin(), row.end(), std::size_t{0});
  for (std::size_t i = 1; i <= a.size(); ++i) {
    std::size_t diagonal = row[0];
    row[0] = i;
    for (std::size_t j = 1; j <= b.size(); ++j) {
      const std::size_t substituted = diagonal + (a[i - 1] == b[j - 1] ? 0 : 1);
      diagonal = row[j];
      row[j] = std::min({row[j] + 1, row[j - 1] + 1, substituted});
    }
  }
  return row.back();
}

}  // namespace

std::string nearest_name(std::string_view found, const std::vector<std::string>& known) {
  const auto nearer = [found](const std::string& a, const std::string& b) {
    return edit_distance(found, a) < edit_distance(found, b);
  };
  const auto best = std::min_element(known.begin(), known.end(), nearer);
  return best == known.end() ? std::string{} : *best;
}

InputError unknown_name(std::string_view kind, std::string_view found, const std::vector<std::string>& known) {
  return InputError{fmt::format("{} '{}' is not known; nearest: {}; known: {}", kind, found, nearest_name(found, known),
                                fmt::join(known, ", "))};
}

void demand_failed(const char* condition, const char* file, int line) {
  std::fprintf(stderr, "%s:%d: the program's own contract is broken: %s\n", file, line, condition);
  std::abort();
}

}  // namespace talus
