#include "solver/integrate/exact.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "solver/base/error.hpp"

namespace talus {
namespace {

/// Number of terms of the series: for a step of one radian, the next term is 1/22! = 1e-21 of the first.
constexpr std::size_t term_count = 22;

/// Nodes and weights of Gauss's rule on [-1, 1] (Abramowitz & Stegun 1964, Table 25.4).
constexpr std::array<std::array<double, 2>, 4> gauss{{{0.183434642495649804939476, 0.362683783378361982965150},
                                                      {0.525532409916328985817739, 0.313706645877887287337962},
                                                      {0.796666477413626739591553, 0.222381034453374470544356},
                                                      {0.960289856497536231683560, 0.101228536290376259152531}}};

}  // namespace

void LinearMotion::begin(HybridSystem& system, const State& start, double interval) {
  system.derivative(start, found_);
  piece_.terms.clear();
  (void)system.linear_segment(start, piece_);  // advance() fails if there is none
  q0_ = start.q, v0_ = start.v, a0_ = found_.v;
  const double fastest = fastest_rate(piece_, std::vector<double>(a0_.size(), 1.0));
  step_ = fastest > 0.0 ? 1.0 / fastest : interval;
}

std::string LinearMotion::advance(HybridSystem& system, const State& begin, State& end, double longest) {
  if (!system.has_affine_pieces()) return "the system does not say where its motion is linear";
  const double h = std::min(fraction_ * step_, longest);
  fraction_ = 1.0;
  sum_series(begin, h, end);
  end.t = begin.t + h;
  end.mode = begin.mode;
  return {};
}

/// With P_k = q^(k) h^k/k!, q^(k+2) = -K q^(k) - C q^(k+1) for k > 0:
///   P_(k+2) = -(h^2 K P_k + h (k+1) C P_(k+1))/((k+1) (k+2)),   q = sum P_k,   v = sum k P_k/h.
/// The accelerations at the beginning of the step follow from the segment's linear law, so that errors do not
/// accumulate from step to step.
void LinearMotion::sum_series(const State& begin, double h, State& out) const {
  const std::size_t n = a0_.size();
  out.q = begin.q, out.v = begin.v, out.z = begin.z, out.work = begin.work, out.impulse = begin.impulse;
  if (h == 0.0) return;
  const std::size_t count = piece_.terms.empty() ? 3 : term_count;
  terms_.assign(count * n, 0.0);
  const auto power = [this, n](std::size_t k) { return &terms_[k * n]; };
  std::copy(a0_.begin(), a0_.end(), power(2));
  for (const LinearSegment::Term& term : piece_.terms) {
    const std::size_t j = term.column;
    power(2)[term.row] -= term.stiffness * (begin.q[j] - q0_[j]) + term.damping * (begin.v[j] - v0_[j]);
  }
  for (std::size_t i = 0; i < n; ++i)
    power(1)[i] = h * begin.v[i], power(2)[i] *= 0.5 * h * h;
  for (std::size_t k = 1; k + 2 < count; ++k) {
    const double first = static_cast<double>(k) + 1.0, second = first + 1.0;
    for (const LinearSegment::Term& term : piece_.terms) {
      const double stiff = h * h / (first * second) * term.stiffness, damped = h / second * term.damping;
      power(k + 2)[term.row] -= stiff * power(k)[term.column] + damped * power(k + 1)[term.column];
    }
  }
  for (std::size_t i = 0; i < n; ++i) {
    double displacement = 0.0, speed = 0.0;  // the smallest terms first
    for (std::size_t k = count; k-- > 2;)
      displacement += power(k)[i], speed += static_cast<double>(k) * power(k)[i];
    out.q[i] += power(1)[i] + displacement;
    out.v[i] += speed / h;
  }
}

void LinearMotion::state_at(const State& begin, const State&, double t, State& out) const {
  sum_series(begin, t - begin.t, out);
  out.t = t;
}

void LinearMotion::complete(HybridSystem& system, const State& begin, State& end) {
  if (!system.keeps_accounts()) return;
  const double half = 0.5 * (end.t - begin.t);
  along_.mode = begin.mode;
  for (const auto& [node, weight] : gauss) {
    for (const double x : {-node, node}) {
      state_at(begin, end, begin.t + half * (1.0 + x), along_);
      system.derivative(along_, found_);
      for (std::size_t i = 0; i < end.work.size(); ++i)
        end.work[i] += half * weight * found_.work[i];
      for (std::size_t i = 0; i < end.impulse.size(); ++i)
        end.impulse[i] += half * weight * found_.impulse[i];
    }
  }
}

void LinearMotion::serialize(Archive& archive, const State& like) {
  q0_.resize(like.q.size()), v0_.resize(like.q.size()), a0_.resize(like.q.size());
  archive.numbers("segment_coordinates", q0_);
  archive.numbers("segment_velocities", v0_);
  archive.numbers("segment_accelerations", a0_);
  archive.number("step", step_);
  archive.number("step_fraction", fraction_);
  std::vector<double> numbers;
  for (const LinearSegment::Term& term : piece_.terms)
    numbers.insert(numbers.end(),
                   {static_cast<double>(term.row), static_cast<double>(term.column), term.stiffness, term.damping});
  archive.list("terms", numbers);
  if (!archive.is_loading()) return;
  const double size = static_cast<double>(like.q.size());
  const auto index_of = [size](double x) {
    if (!(x >= 0.0 && x < size && x == std::floor(x)))
      throw InputError{fmt::format("terms: found one of coordinate {}; there are {}", x, size)};
    return static_cast<std::size_t>(x);
  };
  if (numbers.size() % 4 != 0)
    throw InputError{fmt::format("terms: found {} numbers; there must be four for each", numbers.size())};
  piece_.terms.clear();
  for (std::size_t i = 0; i < numbers.size(); i += 4)
    piece_.terms.push_back({index_of(numbers[i]), index_of(numbers[i + 1]), numbers[i + 2], numbers[i + 3]});
}

}  // namespace talus
