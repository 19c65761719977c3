#include "verification/problems/founding/swing_period_findings.hpp"

#include "verification/problems/founding/leapfrog_swing.hpp"
#include "verification/study/runs/swing.hpp"
#include "verification/study/toolkit.hpp"

namespace talus::verification::problems {
namespace {

using std::numbers::pi;
constexpr double per_small_swing = 128.0;  // steps

/// Rounds a decimal number of 45 digits to 14 decimals, through a long double, which has 18 digits.
std::string rounded(const std::string& decimal) { return fmt::format("{:.14f}", std::stold(decimal)); }

/// Figure of the periods over that of small oscillations, with the elliptic integral.
Figure period_figure(const Series& ratio) {
  const Series elliptic = curve("2 K/pi", multiples(1.0, 1, 179), [](double degrees) {
    return bob_motion(degrees * degree).period() * bob_frequency() / (2.0 * pi);
  });
  return {.name = "period",
          .title = "Period against amplitude",
          .caption =
              "Period over that of small oscillations: simulated with the pinned body, and the elliptic integral. The "
              "difference is not visible at this scale; the next figure shows it.",
          .x = {"amplitude", "deg"},
          .y = {"T w0/(2 pi)", "1"},
          .series = {elliptic, ratio}};
}

/// Figure of the relative errors of the period over (w0 h)^2, with the constant of the modified Hamiltonian.
Figure constant_figure(const Series& measured) {
  const Series theory = curve("modified Hamiltonian", multiples(1.0, 1, 179),
                              [](double degrees) { return verlet_period_constant(degrees * degree); });
  return {.name = "period_constant",
          .title = "Error constant of velocity Verlet's period",
          .caption =
              "Relative error of the period over $(w_0 h)^2$, 128 steps per period of small oscillations, and the "
              "constant that follows from the modified Hamiltonian: -1/24 for small oscillations, zero near 158 "
              "degrees, positive beyond.",
          .x = {"amplitude", "deg"},
          .y = {"(T_h/T - 1)/(w0 h)^2", "1"},
          .series = {theory, measured},
          .lines = {{'y', -1.0 / 24.0, "-1/24"}}};
}

}  // namespace

void check_amplitudes(Findings& findings, const Setup& setup) {
  const double h = 2.0 * pi / bob_frequency() / per_small_swing;
  const double z = bob_frequency() * h;
  Series measured{.label = "velocity_verlet", .style = Style::points};
  Series ratio{.label = "solver", .style = Style::points};
  Table table{.name = "periods",
              .caption =
                  "Period of the pinned body: reference (computed at 50 digits, 15 shown), simulated by velocity "
                  "Verlet with 128 steps per period of small oscillations, and the relative error with its prediction.",
              .columns = {"A [deg]", "T [s]", "simulated [s]", "relative error", "predicted"}};
  double worst = 0.0;
  for (const double degrees : {0.1, 1.0, 10.0, 30.0, 60.0, 90.0, 120.0, 140.0, 150.0, 170.0, 175.0, 179.0}) {
    if (setup.coarse && degrees != 60.0) continue;
    const double amplitude = degrees * degree;
    const double reference = bob_motion(amplitude).period();
    const double period = period_of(scenes::pendulum(bob(setup, amplitude)), verlet(setup), h, 3.0 * reference);
    const double constant = verlet_period_constant(amplitude);
    keep_largest(worst, (period / reference - 1.0) / (z * z) - constant);
    const auto claim = findings.in("integrator.velocity_verlet");
    findings.expect({"periods", fmt::format("period at {:g} degrees", degrees)}, period, reference,
                    Tolerance::truncation(
                        std::abs(constant) * z * z, 1.05,
                        "the derived second-order error of velocity Verlet's period; the next term is below 5 % of it")
                        .relative(),
                    "s");
    measured.add(degrees, (period / reference - 1.0) / (z * z));
    ratio.add(degrees, period * bob_frequency() / (2.0 * pi));
    table.rows.push_back(cells("{:g} | {} | {:.10f} | {:.4e} | {:.4e}", degrees,
                               rounded(bob_motion(amplitude).period_45_digits()), period, period / reference - 1.0,
                               constant * z * z));
  }
  if (setup.coarse) return;
  findings.expect_truncation(
      {"integrator.velocity_verlet",
       "error constant of velocity Verlet's period, largest deviation from the modified Hamiltonian"},
      worst, 0.0, 17.0 / 5760.0 * z * z, 1.05,
      "next term of the expansion, largest for small oscillations: z/(2 asin(z/2)) = 1 - z^2/24 - 17 z^4/5760 ...");
  findings.table(table);
  findings.figure(period_figure(ratio));
  findings.figure(constant_figure(measured));
}

}  // namespace talus::verification::problems
