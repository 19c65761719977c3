#include "verification/problems/friction/friction_findings.hpp"
#include "verification/study/findings/common_formula.hpp"
#include "verification/study/impacts/oblique_runs.hpp"
#include "verification/study/toolkit.hpp"

namespace talus::verification::problems {
namespace {

/// One impact over 64 phases: slip rate before, exact and mean slip rate afterwards, rms error.
struct Rebound {
  double before{}, exact{}, mean{}, error{};
};

Rebound measure(const reference::ObliqueImpact& impact, const Setup& setup, Findings& findings) {
  Rebound found{impact.slip_rate, reference::rebound(impact, reference::EndRule::clamped).slip_rate, 0.0, 0.0};
  const Scene scene = oblique_scene_of(impact, setup);
  PhaseError error;
  for (std::size_t i = 0; i < fewest_phases; ++i) {
    const ObliqueRun run = run_oblique(scene, std::numbers::pi, 100.0, i, findings);
    error.add(run.slip_rate - found.exact);
    found.mean += run.slip_rate / static_cast<double>(fewest_phases);
  }
  found.error = error.rms();
  return found;
}

/// -v'/v of a spring that never slips while the normal one oscillates; with the Coulomb limit it is correct only for
/// kappa = 1/3.
double without_slip(double kappa) { return -std::cos(std::numbers::pi * std::sqrt(3.0 * kappa)); }

/// Adds a row to the table of the common formula, and checks the formula's error at k_s/k_n = 1/4.
void compare_without_slip(double kappa, double ratio, const Rebound& found, Table& table, Findings& findings) {
  const double formula = without_slip(kappa);
  const double exact = -found.exact / found.before, solver = -found.mean / found.before;
  table.rows.push_back(cells("$k_s/k_n$ = {:.4f}, $v$ = {:.2f} $\\mu v_n$ | {:.4f} | {:.4f} | {:+.4f} | {:.4f}", kappa,
                             found.before / mu, formula, exact, formula - exact, solver));
  if (kappa != 0.25 || ratio != 0.5) return;
  findings.expect_truncation("error of e_t = -cos(pi sqrt(3 k_s/k_n)) at k_s/k_n = 1/4, v = 2 mu v_n", formula - solver,
                             formula - exact, 0.084 * std::pow(std::numbers::pi / 100.5, 2) / found.before, 1.2,
                             "the constant of the rms error of all slip rates, 0.084 (w h)^2, over the initial slip "
                             "rate; the error of a mean of 64 phases is at most their rms error");
}

/// -after/before as text, without a minus sign before zero.
std::string returned(double after, double before) {
  const double ratio = -after / before;
  return fmt::format("{:.4f}", std::abs(ratio) < 5e-5 ? 0.0 : ratio);
}

Series exact_rebounds(double kappa) {
  return curve(fmt::format("k_s/k_n = {:.3g}", kappa), multiples(0.1, 1, 120), [&](double incidence) {
    return reference::rebound(oblique_disc(kappa, incidence * kappa), reference::EndRule::clamped).slip_rate / mu;
  });
}

}  // namespace

void check_rebounds(Findings& findings, const Setup& setup) {
  Table table{.name = "rebounds",
              .caption =
                  "Slip rate after an oblique impact over that before, $-v'/v$: exact and solver (velocity Verlet, 100 "
                  "steps per contact, mean of 64 phases). The unit of $v$ is $\\mu v_n k_n/k_s$.",
              .columns = {"k_s/k_n", "v", "exact", "solver", "rms error over v_n"}};
  Table common =
      common_formula("tangential_restitution",
                     "**Tangential restitution of a contact that sticks, $e_t = -v'/v = -\\cos(\\pi\\sqrt{3 "
                     "k_s/k_n})$.** It neglects that the normal force falls to zero at the end, so that every contact "
                     "with Coulomb's limit slips there unless both springs oscillate in phase, $k_s/k_n$ = 1/3. Discs, "
                     "undamped. Solver: velocity Verlet, 100 steps per contact, mean of 64 phases.");
  Figure figure{.name = "rebound",
                .title = "Rebound of the contact point",
                .caption =
                    "Slip rate after an oblique impact against that before, in units of $\\mu v_n$. Lines: exact; "
                    "points: solver. At the right all contacts slide throughout: $v' = v - 6 \\mu v_n$.",
                .x = {.label = "slip rate before / (mu v_n)"},
                .y = {.label = "slip rate after / (mu v_n)"}};
  double largest = 0.0;
  for (const double kappa : {0.25, 2.0 / 7.0, 1.0 / 3.0, 0.8}) {
    Series points{fmt::format("k_s/k_n = {:.3g}, solver", kappa), {}, {}, Style::points};
    for (const double ratio : {0.1, 0.5, 0.9, 1.2, 2.0, 2.8}) {
      const Rebound found = measure(oblique_disc(kappa, ratio), setup, findings);
      keep_largest(largest, found.error);
      if (ratio <= 0.5) compare_without_slip(kappa, ratio, found, common, findings);
      points.add(found.before / mu, found.mean / mu);
      table.rows.push_back(cells("{:.4f} | {:g} | {} | {} | {:.1e}", kappa, ratio, returned(found.exact, found.before),
                                 returned(found.mean, found.before), found.error));
    }
    figure.series.push_back(exact_rebounds(kappa));
    figure.series.push_back(points);
  }
  findings.expect_truncation(
      {"slip_rates", "rms error of the slip rate after the impact, largest of 4 stiffnesses x 6 obliquities"}, largest,
      0.0, 0.084 * std::pow(std::numbers::pi / 100.5, 2), 1.2,
      "measured constant 0.084 (w h)^2, and a fifth for other phases");
  findings.table(table);
  findings.table(common);
  findings.figure(figure);
}

void check_grazing(Findings& findings, const Setup& setup) {
  double gain = -1.0, error = 0.0;
  const double step = 0.1;
  for (double angle = 60.0; angle <= 88.0; angle += 4.0) {
    for (const double friction : {0.01, 0.1, 0.3, 1.0}) {
      reference::ObliqueImpact impact = oblique_disc(2.0 / 7.0, 0.0);
      impact.friction = friction;
      impact.slip_rate = std::tan(angle * std::numbers::pi / 180.0);
      const double lost = reference::rebound(impact, reference::EndRule::clamped).dissipated;
      const Scene scene = oblique_scene_of(impact, setup);
      for (std::size_t i = 0; i < fewest_phases; ++i) {
        const ObliqueRun run = run_oblique_at_step(scene, std::numbers::pi, step, i, findings);
        const double energy = kinetic_energy(run.end);
        const double before = 0.5 * (1.0 + impact.slip_rate * impact.slip_rate);
        gain = std::max(gain, energy / before - 1.0);
        keep_largest(error, std::abs(energy + lost - before) / before);
      }
    }
  }
  findings.expect_true({"grazing/gain", "no energy gain in grazing impacts of 60 to 88 degrees, mu = 0.01 to 1"},
                       gain <= 0.0,
                       "friction dissipates more than the error of the normal impact, of order (w h)^2, adds");
  findings.expect_truncation(
      {"grazing/energy", "energy after a grazing impact, largest error over (w h)^2 times the initial energy"},
      error / (step * step), 0.0, 0.156, 1.2,
      "measured constant 0.156 (w h)^2 at 31 steps per contact, and a fifth for the next power of the step");
}

}  // namespace talus::verification::problems
