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

/// Adds a time to the table: the new d_(i+1) is the change of d_i over the time since the oldest time in the old d_i.
/// `above` is the new d_0 on entry, and the difference that is dropped at the end of the table on return.
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

TALUS_CLONES void sum_rows(const double* x, const double* table, std::size_t stride, std::span<const double> weights,
                           double* sums, std::size_t count) {
  for_packs(
      count, [&](std::size_t c, auto left) __attribute__((always_inline)) {
        Pack sum, row;
        load(sum, x + c, left);
        for (std::size_t i = 0; i < weights.size(); ++i) {
          load(row, table + i * stride + c, left);
          sum += row * weights[i];
        }
        store(sum, sums + c, left);
      });
}

TALUS_CLONES void move_rows(const double* q, const double* v, double h, const double* table, std::size_t stride,
                            std::span<const Differences::Basis> basis, double* to_q, double* to_v, std::size_t count) {
  for_packs(
      count, [&](std::size_t c, auto left) __attribute__((always_inline)) {
        Pack displacement, speed, row;
        load(displacement, q + c, left), load(speed, v + c, left);
        displacement += h * speed;
        for (std::size_t i = 0; i < basis.size(); ++i) {
          load(row, table + i * stride + c, left);
          displacement += row * basis[i].twice, speed += row * basis[i].once;
        }
        store(displacement, to_q + c, left), store(speed, to_v + c, left);
      });
}

/// Largest magnitudes of x, of x plus a multiple of one row, and of x plus a multiple of another, times the factors.
TALUS_CLONES std::array<double, 3> largest_sums(const double* x, const double* one, double weight_one,
                                                const double* other, double weight_other, const double* factors,
                                                std::size_t count) {
  Sizes maximum{}, maximum_one{}, maximum_other{};
  for_packs(
      count, [&](std::size_t c, auto left) __attribute__((always_inline)) {
        Pack sum, row, factor = Pack{} + 1.0;
        load(sum, x + c, left);
        if (factors != nullptr) load(factor, factors + c, left);
        raise(maximum, factor * sum);
        load(row, one + c, left);
        raise(maximum_one, factor * (sum + row * weight_one));
        load(row, other + c, left);
        raise(maximum_other, factor * (sum + row * weight_other));
      });
  return {talus::largest(maximum), talus::largest(maximum_one), talus::largest(maximum_other)};
}

/// Let G_i^q be the integral of N_i, q times over, from the newest time to t. Since N_(i+1) = (s - t_i) N_i at time s,
/// integration by parts gives G_(i+1)^q = (t - t_i) G_i^q - q G_i^(q+1), with G_0^q = h^q/q! and h = t - t_0. All q are
/// computed side by side, each divided by h^q: H_(i+1)^q = (t - t_i) H_i^q - q h H_i^(q+1). Cancellation is small
/// because N_i never decreases: q H_i^(q+1) is at most H_i^q q/(q + 1), and t - t_i is at least h.
TALUS_CLONES void integrate_basis(const double* times, double t, std::size_t terms, Differences::Basis* out) {
  // The last of most + 1 terms is integrated twice, so the first term needs most + 3 integrals.
  constexpr std::size_t packs = whole_packs(Differences::capacity + 3) / pack_size;
  static constexpr auto inverse_factorials = [] {
    std::array<double, packs * pack_size> made{1.0};
    for (std::size_t q = 1; q < made.size(); ++q)
      made[q] = made[q - 1] / static_cast<double>(q);
    return made;
  }();
  const double h = t - times[0];
  std::array<Pack, packs + 1> integrals{};  // the last pack is zero
  std::array<Pack, packs> factors;
  for (std::size_t p = 0; p < packs; ++p) {
    load(integrals[p], inverse_factorials.data() + p * pack_size);
    factors[p] = h * (Pack{0.0, 1.0, 2.0, 3.0} + static_cast<double>(p * pack_size));
  }
  for (std::size_t i = 0;; ++i) {
    out[i] = {integrals[0][0], h * integrals[0][1], h * h * integrals[0][2]};
    if (i + 1 == terms) return;
    const double back = t - times[i];
    for (std::size_t p = 0; p < packs; ++p) {
      const Pack next = __builtin_shufflevector(integrals[p], integrals[p + 1], 1, 2, 3, 4);
      integrals[p] = back * integrals[p] - factors[p] * next;
    }
  }
}

}  // namespace

void Differences::begin(double t, std::span<const double> rates) {
  width_ = rates.size();
  stride_ = whole_packs(width_);
  times_.reserve(capacity + 1), table_.reserve(capacity * stride_);  // so that steps do not allocate
  times_.assign(1, t);
  table_.assign(rates.begin(), rates.end());
  table_.resize(stride_);
}

void Differences::add(double t, std::span<const double> rates) {
  const std::size_t count = std::min(times_.size() + 1, capacity);
  table_.resize(count * stride_);
  above_.assign(rates.begin(), rates.end());
  above_.resize(stride_);
  std::array<double, capacity> inverse{};
  for (std::size_t i = 0; i + 1 < count; ++i)
    inverse[i] = 1.0 / (t - times_[i]);
  push(table_.data(), stride_, count, inverse.data(), above_.data());
  times_.insert(times_.begin(), t);
  times_.resize(count);
}

void Differences::sum(std::span<const double> x, std::size_t first, std::span<const double> weights,
                      std::span<double> sums) const {
  sum_rows(x.data(), table_.data() + first, stride_, weights, sums.data(), sums.size());
}

void Differences::move(std::span<const double> q, std::span<const double> v, double h, std::span<const Basis> basis,
                       std::span<double> to_q, std::span<double> to_v) const {
  move_rows(q.data(), v.data(), h, table_.data(), stride_, basis, to_q.data(), to_v.data(), to_q.size());
}

std::array<double, 3> Differences::largest(std::span<const double> x, std::size_t first,
                                           const std::array<Term, 2>& terms, std::span<const double> factors) const {
  const auto row = [&](const Term& term) { return table_.data() + term.i * stride_ + first; };
  return largest_sums(x.data(), row(terms[0]), terms[0].weight, row(terms[1]), terms[1].weight,
                      factors.empty() ? nullptr : factors.data(), x.size());
}

void Differences::basis(double t, std::size_t terms, std::span<Basis> out) const {
  integrate_basis(times_.data(), t, terms, out.data());
}

void Differences::serialize(Archive& archive, std::size_t width) {
  width_ = width;
  stride_ = whole_packs(width);
  archive.list("times", times_);
  archive.list("differences", table_);
  if (!archive.is_loading()) return;
  const bool falling = std::adjacent_find(times_.begin(), times_.end(), std::less_equal{}) == times_.end();
  if (times_.size() > capacity || !falling)
    throw InputError{
        fmt::format("times: found {} of them; at most {} must be there, the newest first", times_.size(), capacity)};
  if (table_.size() != times_.size() * stride_)
    throw InputError{fmt::format("differences: found {} numbers; {} times of {} must be there", table_.size(),
                                 times_.size(), stride_)};
}

}  // namespace talus
