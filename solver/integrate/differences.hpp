#pragma once

#include <array>
#include <cstddef>
#include <span>
#include <vector>

#include "solver/base/archive.hpp"

namespace talus {

/// Divided differences of rates of change at the latest times. The polynomial through the newest `order` of them is
///
///   f(t) = sum_i d_i N_i(t),   N_i(t) = (t - t_0) (t - t_1) .. (t - t_(i-1)),   t_0 the newest time, i < order
///
/// for each of several quantities at once (Newton's form; Krogh 1974 integrates it once and twice).
class Differences {
 public:
  /// Maximum number of stored times.
  static constexpr std::size_t capacity = 13;

  /// Restarts with the rates at one time.
  void begin(double t, std::span<const double> rates);
  /// Adds the rates at a later time; beyond `capacity` times the oldest are dropped.
  void add(double t, std::span<const double> rates);

  std::size_t count() const { return times_.size(); }
  double newest() const { return times_.front(); }

  /// N_i at a time, and its single and double integral from the newest time to that time.
  struct Basis {
    double value{};
    double once{};
    double twice{};
  };
  /// Evaluates N_0 .. N_(terms - 1) at time t; terms <= count() + 1.
  void basis(double t, std::size_t terms, std::span<Basis> out) const;

  /// Writes x + sum_i d_i weight_i, i < weights.size(), for consecutive quantities that begin with index `first`. Terms
  /// are added one by one, in increasing i. `sums` must not overlap x.
  void sum(std::span<const double> x, std::size_t first, std::span<const double> weights, std::span<double> sums) const;
  /// Moves coordinates q with velocities v by a time h [T], where the first quantities are their accelerations: writes
  /// q + h v + sum_i d_i twice_i and v + sum_i d_i once_i. The outputs must not overlap q and v.
  void move(std::span<const double> q, std::span<const double> v, double h, std::span<const Basis> basis,
            std::span<double> to_q, std::span<double> to_v) const;
  /// A term to be added; weight zero: none.
  struct Term {
    std::size_t i{};
    double weight{};
  };
  /// Largest magnitudes of factor x, of factor (x + d_i weight) with the first term, and of the same with the second
  /// term instead, over consecutive quantities that begin with index `first`; NaN if one is NaN. No factors: 1.
  std::array<double, 3> largest(std::span<const double> x, std::size_t first, const std::array<Term, 2>& terms,
                                std::span<const double> factors) const;

  /// Serializes times and differences for `width` quantities. Errors when restoring: InputError if they do not fit.
  void serialize(Archive& archive, std::size_t width);

 private:
  std::vector<double> times_;  ///< newest first
  std::vector<double> table_;  ///< rows d_0, d_1, ..., each of all quantities, padded with zeros to whole packs
  std::size_t width_{};        ///< number of quantities
  std::size_t stride_{};       ///< distance between rows
  std::vector<double> above_;  ///< scratch: the next row
};

}  // namespace talus
