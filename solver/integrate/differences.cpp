#include "solver/integrate/differences.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <functional>

#include "solver/base/error.hpp"

namespace talus {

void Differences::begin(double t, std::span<const double> rates) {
  width_ = rates.size();
  times_.assign(1, t);
  table_.assign(rates.begin(), rates.end());
}

void Differences::add(double t, std::span<const double> rates) {
  const std::size_t count = std::min(times_.size() + 1, most);
  table_.resize(count * width_);
  above_.assign(rates.begin(), rates.end());
  double* const above = above_.data();
  for (std::size_t i = 0; i < count; ++i) {
    double* const row = &table_[i * width_];
    // d_(i+1) of the new times is the change of d_i over the time from the oldest of the times in it.
    const double inverse = i + 1 < count ? 1.0 / (t - times_[i]) : 0.0;
    for (std::size_t c = 0; c < width_; ++c) {
      const double before = row[c];
      row[c] = above[c];
      above[c] = (above[c] - before) * inverse;
    }
  }
  times_.insert(times_.begin(), t);
  times_.resize(count);
}

void Differences::basis(double t, std::size_t terms, std::span<Basis> out) const {
  // What integrating a power once and twice divides by; as factors, for a division takes ten times as long.
  static constexpr auto divisors = [] {
    std::array<std::array<double, 2>, most + 2> made{};
    for (std::size_t p = 0; p < made.size(); ++p) {
      const double below = static_cast<double>(p) + 1.0;
      made[p] = {1.0 / below, 1.0 / (below * (below + 1.0))};
    }
    return made;
  }();
  // N_i in powers of s/h, with s = t - t_0 and h the interval: all its zeros are at s <= 0, so that no coefficient is
  // negative and nothing cancels in the integrals.
  const double h = t - times_.front();
  std::array<double, most + 2> power{1.0};
  for (std::size_t i = 0; i < terms; ++i) {
    Basis sum;
    for (std::size_t p = i + 1; p-- > 0;) {
      sum.value += power[p];
      sum.once += power[p] * divisors[p][0];
      sum.twice += power[p] * divisors[p][1];
    }
    out[i] = {sum.value, h * sum.once, h * h * sum.twice};
    if (i + 1 == terms) break;
    const double back = times_.front() - times_[i];
    for (std::size_t p = i + 1; p > 0; --p)
      power[p] = h * power[p - 1] + back * power[p];
    power[0] *= back;
  }
}

void Differences::remember(Memory& memory, std::size_t width) {
  width_ = width;
  memory.list("times", times_);
  memory.list("differences", table_);
  if (!memory.puts_back()) return;
  const bool falling = std::adjacent_find(times_.begin(), times_.end(), std::less_equal{}) == times_.end();
  if (times_.size() > most || !falling)
    throw InputError{
        fmt::format("times: found {} of them; at most {} must be there, the newest first", times_.size(), most)};
  if (table_.size() != times_.size() * width_)
    throw InputError{fmt::format("differences: found {} numbers; {} times of {} must be there", table_.size(),
                                 times_.size(), width_)};
}

}  // namespace talus
