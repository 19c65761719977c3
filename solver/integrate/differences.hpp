#pragma once

#include <array>
#include <cstddef>
#include <span>
#include <vector>

#include "solver/base/archive.hpp"

namespace talus {

/// Rates of change at the last few times, as divided differences: the polynomial through the newest `order` of them is
///
///   f(t) = sum_i d_i N_i(t),   N_i(t) = (t - t_0) (t - t_1) .. (t - t_(i-1)),   t_0 the newest time, i < order
///
/// for each of several quantities at once (Newton's form; Krogh 1974 integrates it once and twice).
class Differences {
 public:
  /// The most times that are kept.
  static constexpr std::size_t most = 13;

  /// Restarts with the rates at one time.
  void begin(double t, std::span<const double> rates);
  /// Adds the rates at a later time; the oldest are forgotten when there are too many.
  void add(double t, std::span<const double> rates);

  std::size_t count() const { return times_.size(); }
  double newest() const { return times_.front(); }

  /// N_i at a time, and its integrals from the newest time to that one: once, and twice.
  struct Basis {
    double value{};
    double once{};
    double twice{};
  };
  /// Those of N_0 .. N_(terms - 1); terms <= count() + 1.
  void basis(double t, std::size_t terms, std::span<Basis> out) const;

  /// x + sum_i d_i weight_i of neighbouring quantities, the first of which is told, i < weights.size(). The terms are
  /// added one by one, i rising. The sums are written elsewhere than x is.
  void sum(std::span<const double> x, std::size_t first, std::span<const double> weights, std::span<double> sums) const;
  /// Where coordinates q that move at v are h later [T] if the first quantities are their accelerations:
  /// q + h v + sum_i d_i twice_i, and v + sum_i d_i once_i. They are written elsewhere than q and v are.
  void move(std::span<const double> q, std::span<const double> v, double h, std::span<const Basis> basis,
            std::span<double> to_q, std::span<double> to_v) const;
  /// A term that is added, or none.
  struct Term {
    std::size_t i{};
    double weight{};
  };
  /// The largest size of factor x, of factor (x + d_i weight) with the first term, and with the second instead, among
  /// neighbouring quantities; NaN if one is. Without factors: 1.
  std::array<double, 3> largest(std::span<const double> x, std::size_t first, const std::array<Term, 2>& terms,
                                std::span<const double> factors) const;

  /// Names its parts; one that puts back is told its width. Errors when putting back: InputError if they do not fit.
  void serialize(Archive& archive, std::size_t width);

 private:
  std::vector<double> times_;  ///< newest first
  std::vector<double> table_;  ///< d_0, d_1, ..., each of all quantities and of noughts up to a whole row of packs
  std::size_t width_{};        ///< quantities
  std::size_t stride_{};       ///< from row to row
  std::vector<double> above_;  ///< scratch: the next row
};

}  // namespace talus
