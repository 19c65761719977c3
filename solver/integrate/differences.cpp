#include "solver/integrate/differences.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <functional>

#include "solver/base/error.hpp"
#include "solver/base/pack.hpp"

namespace talus {

namespace {

constexpr std::size_t whole_packs(std::size_t width) { return (width + pack_size - 1) / pack_size * pack_size; }

/// d_(i+1) of the new times is the change of d_i over the time from the oldest of the times in it: takes in a row above
/// the table, and leaves there what falls out below.
TALUS_CLONES void push(double* table, std::size_t stride, std::size_t rows, const double* inverse, double* above) {
  for (std::size_t c = 0; c < stride; c += pack_size) {
    Pack next, before;
    load(next, above + c);
    for (std::size_t i = 0; i < rows; ++i) {
      double* const row = table + i * stride + c;
      load(before, row);
      store(next, row);
      next = (next - before) * inverse[i];
    }
    store(next, above + c);
  }
}

TALUS_CLONES void add_rows(const double* table, std::size_t stride, std::size_t rows, const double* weights,
                           double* sums, std::size_t count) {
  for (std::size_t c = 0; c < count; c += pack_size) {
    Pack sum, row;
    load(sum, sums + c, count - c);
    for (std::size_t i = 0; i < rows; ++i) {
      load(row, table + i * stride + c, count - c);
      sum += row * weights[i];
    }
    store(sum, sums + c, count - c);
  }
}

/// Sizes of x and of its sums with one row and with another; the largest of each.
TALUS_CLONES std::array<double, 3> largest_sums(const double* x, const double* one, double weight_one,
                                                const double* other, double weight_other, const double* factors,
                                                std::size_t count) {
  Sizes most{}, most_one{}, most_other{};
  for (std::size_t c = 0; c < count; c += pack_size) {
    Pack sum, row, factor = Pack{} + 1.0;
    load(sum, x + c, count - c);
    if (factors != nullptr) load(factor, factors + c, count - c);
    raise(most, factor * sum);
    load(row, one + c, count - c);
    raise(most_one, factor * (sum + row * weight_one));
    load(row, other + c, count - c);
    raise(most_other, factor * (sum + row * weight_other));
  }
  return {talus::largest(most), talus::largest(most_one), talus::largest(most_other)};
}

}  // namespace

void Differences::begin(double t, std::span<const double> rates) {
  width_ = rates.size();
  stride_ = whole_packs(width_);
  times_.reserve(most + 1), table_.reserve(most * stride_);  // a step takes no memory
  times_.assign(1, t);
  table_.assign(rates.begin(), rates.end());
  table_.resize(stride_);
}

void Differences::add(double t, std::span<const double> rates) {
  const std::size_t count = std::min(times_.size() + 1, most);
  table_.resize(count * stride_);
  above_.assign(rates.begin(), rates.end());
  above_.resize(stride_);
  std::array<double, most> inverse{};
  for (std::size_t i = 0; i + 1 < count; ++i)
    inverse[i] = 1.0 / (t - times_[i]);
  push(table_.data(), stride_, count, inverse.data(), above_.data());
  times_.insert(times_.begin(), t);
  times_.resize(count);
}

void Differences::add_to(std::span<double> sums, std::size_t first, std::span<const double> weights) const {
  add_rows(table_.data() + first, stride_, weights.size(), weights.data(), sums.data(), sums.size());
}

std::array<double, 3> Differences::largest(std::span<const double> x, std::size_t first,
                                           const std::array<Term, 2>& terms, std::span<const double> factors) const {
  const auto row = [&](const Term& term) { return table_.data() + term.i * stride_ + first; };
  return largest_sums(x.data(), row(terms[0]), terms[0].weight, row(terms[1]), terms[1].weight,
                      factors.empty() ? nullptr : factors.data(), x.size());
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
  stride_ = whole_packs(width);
  memory.list("times", times_);
  memory.list("differences", table_);
  if (!memory.puts_back()) return;
  const bool falling = std::adjacent_find(times_.begin(), times_.end(), std::less_equal{}) == times_.end();
  if (times_.size() > most || !falling)
    throw InputError{
        fmt::format("times: found {} of them; at most {} must be there, the newest first", times_.size(), most)};
  if (table_.size() != times_.size() * stride_)
    throw InputError{fmt::format("differences: found {} numbers; {} times of {} must be there", table_.size(),
                                 times_.size(), stride_)};
}

}  // namespace talus
