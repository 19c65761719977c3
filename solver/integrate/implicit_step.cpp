#include "solver/integrate/implicit_step.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "solver/state/state_archive.hpp"

namespace talus {
namespace {

constexpr double diagonal = 0.25;
/// Coefficients of ESDIRK4(3)6L[2]SA (Kennedy & Carpenter 2003, Appl. Numer. Math. 44:139, the implicit half of
/// ARK4(3)6L[2]SA), and in the last row the weights of the step.
constexpr std::array<std::array<double, 6>, 6> a{{
    {},
    {0.25, diagonal},
    {8611.0 / 62500.0, -1743.0 / 31250.0, diagonal},
    {5012029.0 / 34652500.0, -654441.0 / 2922500.0, 174375.0 / 388108.0, diagonal},
    {15267082809.0 / 155376265600.0, -71443401.0 / 120774400.0, 730878875.0 / 902184768.0, 2285395.0 / 8070912.0,
     diagonal},
    {82889.0 / 524892.0, 0.0, 15625.0 / 83664.0, 69875.0 / 102672.0, -2260.0 / 8211.0, diagonal},
}};
/// Weights of the embedded method of order 3.
constexpr std::array<double, 6> embedded{4586570599.0 / 29645900160.0, 0.0,
                                         178811875.0 / 945068544.0,    814220225.0 / 1159782912.0,
                                         -3700637.0 / 11593932.0,      61727.0 / 225920.0};

constexpr int maximum_iterations = 6;
/// Error of Newton's method allowed in a stage, relative to the error allowed in the step.
constexpr double newton_error = 0.02;

double largest(const std::vector<double>& x, std::span<const double> lengths) {
  double maximum = 0.0;
  for (std::size_t i = 0; i < x.size(); ++i) {
    const double size = std::abs(x[i]) * (lengths.empty() ? 1.0 : lengths[i]);
    maximum = size > maximum || size != size ? size : maximum;
  }
  return maximum;
}

/// Error relative to a scale; a zero error is zero on any scale.
double relative(double error, double scale) { return error == 0.0 ? 0.0 : error / scale; }

}  // namespace

ImplicitStep::ImplicitStep(const State& like)
    : begin_rates_{like}, end_rates_{like}, end_{like}, at_{like}, found_{like} {
  rates_.fill(found_);
  velocities_.fill(like.v);
}

bool ImplicitStep::begin(HybridSystem& system, const State& at) {
  piece_ = {};
  return system.linearization(at, piece_) && !piece_.terms.empty() && solver_.group(piece_, at.v.size());
}

/// Computes the state of a stage from the rates of the stages before it and its own rates.
void ImplicitStep::set_stage(const State& begin, double h, std::size_t stage) {
  const auto sum = [&](const auto& start, auto& out, const auto& rates_of) {
    for (std::size_t i = 0; i < out.size(); ++i) {
      double total = 0.0;
      for (std::size_t j = 0; j <= stage; ++j)
        total += a[stage][j] * rates_of(j)[i];
      out[i] = start[i] + h * total;
    }
  };
  sum(begin.v, velocities_[stage], [this](std::size_t j) -> const std::vector<double>& { return rates_[j].v; });
  sum(begin.q, at_.q, [this](std::size_t j) -> const std::vector<double>& { return velocities_[j]; });
  sum(begin.z, at_.z, [this](std::size_t j) -> const std::vector<double>& { return rates_[j].z; });
  at_.v = velocities_[stage];
}

/// Newton's method for the accelerations k and memory rates y of a stage. With b = h/4, a change dk moves its
/// velocities by b dk, its coordinates by b^2 dk, and memory by b (dz/dt - y) + b^2 slope dk, so that
///   (I + b C + b^2 K) dk = f(stage) - k - b sum pull (dz/dt - y).
bool ImplicitStep::solve_stage(HybridSystem& system, const State& begin, double h, std::size_t stage,
                               const ErrorScales& scales) {
  const double b = diagonal * h;
  Rates& rates = rates_[stage];
  rates = rates_[stage - 1];
  const double force_scale = fastest_rate_ * scales.speed;
  double before = 0.0;
  for (int iteration = 0; iteration < maximum_iterations; ++iteration) {
    set_stage(begin, h, stage);
    system.derivative(at_, found_);
    change_.resize(rates.v.size());
    for (std::size_t i = 0; i < change_.size(); ++i)
      change_[i] = found_.v[i] - rates.v[i];
    for (const LinearSegment::MemoryPull& term : piece_.pulls)
      change_[term.row] -= b * term.pull * (found_.z[term.column] - rates.z[term.column]);
    residual_ = change_;
    solver_.solve(change_);
    rates.z = found_.z, rates.work = found_.work, rates.impulse = found_.impulse;
    for (std::size_t i = 0; i < change_.size(); ++i)
      rates.v[i] += change_[i];
    for (const LinearSegment::MemoryTerm& term : piece_.memory)
      rates.z[term.row] += term.slope * b * change_[term.column];
    // The remaining residual is the change of the springs' and dashpots' accelerations.
    for (std::size_t i = 0; i < change_.size(); ++i)
      residual_[i] -= change_[i];
    const double size = largest(change_, scales.lengths);
    const double now = std::max({relative(b * size, scales.speed), relative(b * b * size, scales.displacement),
                                 relative(largest(residual_, scales.lengths), force_scale)}) /
                       scales.tolerance;
    if (!std::isfinite(now)) return false;
    const double ratio = iteration == 0 ? 0.1 : now / before;
    if (ratio >= 1.0) return false;
    if (ratio / (1.0 - ratio) * now <= newton_error) return true;
    before = now;
  }
  return false;
}

/// Errors of velocities, coordinates and memory by the embedded method, and of the accelerations that result from them:
/// a displacement error that is small relative to the displacements of the run may be large relative to the overlap of
/// a stiff contact.
double ImplicitStep::error(double h, const ErrorScales& scales) {
  const auto missed = [&](std::size_t size, std::vector<double>& sum, const auto& rates_of) {
    sum.assign(size, 0.0);
    for (std::size_t i = 0; i < size; ++i) {
      for (std::size_t j = 0; j < stages; ++j)
        sum[i] += h * (a[stages - 1][j] - embedded[j]) * rates_of(j)[i];
    }
  };
  missed(at_.z.size(), residual_, [this](std::size_t j) { return rates_[j].z.data(); });
  const double memory = largest(residual_, {});
  missed(at_.v.size(), missed_v_, [this](std::size_t j) { return rates_[j].v.data(); });
  missed(at_.q.size(), missed_q_, [this](std::size_t j) { return velocities_[j].data(); });
  residual_.assign(at_.v.size(), 0.0);
  for (const LinearSegment::Term& term : piece_.terms)
    residual_[term.row] += term.stiffness * missed_q_[term.column] + term.damping * missed_v_[term.column];
  return std::max({relative(largest(missed_v_, scales.lengths), scales.speed),
                   relative(largest(missed_q_, scales.lengths), scales.displacement),
                   relative(memory, scales.displacement),
                   relative(largest(residual_, scales.lengths), fastest_rate_ * scales.speed)}) /
         scales.tolerance;
}

double ImplicitStep::take(HybridSystem& system, const State& begin, Rates& rates, double h, const ErrorScales& scales,
                          State& end) {
  constexpr double infinity = std::numeric_limits<double>::infinity();
  if (!solver_.factorise(piece_, diagonal * h)) return infinity;
  fastest_rate_ = fastest_rate(scales.lengths);
  at_.mode = begin.mode;
  rates_[0] = rates;
  velocities_[0] = begin.v;
  for (std::size_t stage = 1; stage < stages; ++stage) {
    if (!solve_stage(system, begin, h, stage, scales)) return infinity;
  }
  set_stage(begin, h, stages - 1);
  const double found = error(h, scales);
  if (!(found <= 1.0)) return found;
  end.q = at_.q, end.v = at_.v, end.z = at_.z;
  const auto integrate = [&](const auto& start, auto& out, const auto& rate_of) {
    for (std::size_t i = 0; i < out.size(); ++i) {
      out[i] = start[i];
      for (std::size_t j = 0; j < stages; ++j)
        out[i] += h * a[stages - 1][j] * rate_of(j)[i];
    }
  };
  integrate(begin.work, end.work, [this](std::size_t j) { return rates_[j].work.data(); });
  integrate(begin.impulse, end.impulse, [this](std::size_t j) { return rates_[j].impulse.data(); });
  end.t = begin.t + h;
  end.mode = begin.mode;
  begin_rates_ = rates;
  system.derivative(end, end_rates_);
  rates = end_rates_;
  end_ = end;
  return found;
}

void ImplicitStep::state_at(const State& begin, double t, State& out) const {
  const State& end = end_;
  const double h = end.t - begin.t, s = (t - begin.t) / h, r = 1.0 - s;
  // Hermite polynomials: degree 3 from values and rates, degree 5 from second derivatives as well.
  const double value = r * r * (1.0 + 2.0 * s), rate_begin = h * s * r * r, rate_end = -h * s * s * r;
  const auto cubic = [&](const auto& from, const auto& to, const auto& rate, const auto& rate_to, auto& sums) {
    for (std::size_t i = 0; i < sums.size(); ++i)
      sums[i] = to[i] + value * (from[i] - to[i]) + rate_begin * rate[i] + rate_end * rate_to[i];
  };
  const double s3 = s * s * s, r3 = r * r * r;
  const double q0 = r3 * (1.0 + 3.0 * s + 6.0 * s * s);
  const double v0 = h * s * r3 * (1.0 + 3.0 * s), v1 = -h * r * s3 * (1.0 + 3.0 * r);
  const double a0 = 0.5 * h * h * s * s * r3, a1 = 0.5 * h * h * r * r * s3;
  const double dq = -30.0 * s * s * r * r / h;
  const double dv0 = r * r * (1.0 + 2.0 * s - 15.0 * s * s), dv1 = s * s * (1.0 + 2.0 * r - 15.0 * r * r);
  const double da0 = 0.5 * h * s * r * r * (2.0 - 5.0 * s), da1 = -0.5 * h * r * s * s * (2.0 - 5.0 * r);
  out.t = t;
  for (std::size_t i = 0; i < out.q.size(); ++i) {
    const double displacement = begin.q[i] - end.q[i];
    out.q[i] =
        end.q[i] + q0 * displacement + v0 * begin.v[i] + v1 * end.v[i] + a0 * begin_rates_.v[i] + a1 * end_rates_.v[i];
    out.v[i] = dq * displacement + dv0 * begin.v[i] + dv1 * end.v[i] + da0 * begin_rates_.v[i] + da1 * end_rates_.v[i];
  }
  cubic(begin.z, end.z, begin_rates_.z, end_rates_.z, out.z);
  cubic(begin.work, end.work, begin_rates_.work, end_rates_.work, out.work);
  cubic(begin.impulse, end.impulse, begin_rates_.impulse, end_rates_.impulse, out.impulse);
}

void ImplicitStep::serialize(Archive& archive, const State& like) {
  if (archive.is_loading()) *this = ImplicitStep{like};
  archive.scope("begin_rates", [&] { talus::serialize(archive, begin_rates_); });
  archive.scope("end_rates", [&] { talus::serialize(archive, end_rates_); });
  archive.scope("end", [&] { talus::serialize(archive, end_); });
}

}  // namespace talus
