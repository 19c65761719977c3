#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <string>
#include <vector>

#include "solver/granular/block_means.hpp"
#include "verification/check/case.hpp"
#include "verification/problems/followed_discs.hpp"

namespace talus::verification::problems {

Case dense_flow();

namespace {

constexpr const char* page = R"(
**Problem.** Discs of unlike size without friction, packed as densely as they still flow, are sheared slowly without walls.
Their resistance is not nought: what is it, over the pressure?

**Equations.** By dimensions, stiff discs at the solid fraction $\phi$ have $p = \dot\gamma^2\rho\,d^2 f(\phi)$; turned
round, $\mu = S/p$ and $\phi$ are functions of the inertial number
$$I = \dot\gamma\,d\sqrt{\rho/p}, \qquad \rho = \frac{4m}{\pi d^2},$$
and of the discs' softness $p/K_1$ if it is not small. $S = -P_{xy}$ and $p$ are those of the virial, motion and contacts.
Here $\phi$ is given and $I$ is measured.

**What is expected.** However slow the flow is, friction stays, as contacts stand against the shear, and grows as a
power of $I$ (Peyneau & Roux 2008, of beads). For $I = .003$ and sizes within 20 % an
independent code's runs gave .10 to .13. Equal discs would order themselves, and slip along their rows.

| symbol | meaning | value |
|:--|:-----|:------|
| $N$ | discs; diameters $d(1 \mp .2)$, masses as areas | 200 (full tier 600) |
| $e$ | latching spring, $K_1/K_2 = e^2$ | .7 |
| $\dot\gamma$ | shear rate | $10^{-4}\sqrt{K_1/m}$ |
| $h$ | step, leapfrog | a tenth of a contact of the middle size |
| strain | to forget the start; measured | 1; 4 (full tier 7) |

**Source.** The numbers $\mu$ and $I$: da Cruz et al. 2005.

**What would break it.** Memory of contacts lost when the list is made anew; images of the sliding box that push with another
velocity; a contact counted once in a while only; pressure without one of its parts.
)";

constexpr double restitution = 0.7, shear_rate = 1e-4, spread = 0.2;

struct Flow {
  double fraction{};
  Estimate friction;
  double inertial{};      ///< I
  double softness{};      ///< p/K1
  double coordination{};  ///< contacts of a disc
  double deepest{};       ///< overlap [d]
};

Packing packing_of(double fraction, std::size_t discs, std::uint64_t seed, const Setup& setup) {
  // Beyond what growth reaches the discs are blown up, and press on each other until they flow.
  const double grown = std::min(fraction, 0.82);
  Packing packing = grow({.discs = discs,
                          .diameter = 1.0,
                          .spread = setup.has("equal_discs") ? 0.0 : spread,
                          .mass = 1.0,
                          .solid_fraction = grown,
                          .seed = seed});
  for (double& radius : packing.shapes.radius)
    radius *= std::sqrt(fraction / grown);
  packing.box.shear_rate = setup.has("still_box") ? 0.0 : shear_rate;
  for (std::size_t i = 0; i < discs; ++i)
    packing.discs.vx[i] += shear_rate * packing.discs.y[i];
  return packing;
}

Flow shear(double fraction, std::size_t discs, double before, double strain, Findings& findings, const Setup& setup) {
  const double ratio = restitution * restitution;
  const LatchingSpring law{1.0, 1.0 / ratio, 0.0};
  const double contact_time = 0.5 * std::numbers::pi * (1.0 + restitution) / std::sqrt(2.0);
  const Packing start = packing_of(fraction, discs, 1, setup);
  FollowPlan plan{
      .step = contact_time / 10.0, .every = 20, .skin = 0.1, .contacts_left_out = setup.has("motion_alone")};
  plan.steps = std::lround((before + strain) / shear_rate / plan.step);
  BlockMeans means{3, strain / shear_rate, 10};  // shear stress, pressure, contacts of a disc
  Flow found;
  found.fraction = fraction;
  follow(start, law, plan, [&](const SeenDiscs& seen) {
    if (seen.t < before / shear_rate) return;
    means.add(seen.t - before / shear_rate, 1.0,
              std::array{-seen.stress.xy, seen.stress.pressure(),
                         2.0 * static_cast<double>(seen.contacts.contacts) / static_cast<double>(discs)});
    found.deepest = std::max(found.deepest, seen.contacts.largest_depth);
  });
  findings.count(static_cast<std::uint64_t>(plan.steps));
  found.friction = means.ratio(0, 1, 0);
  const double mean_pressure = means.mean(1, 0, means.blocks());
  found.inertial = shear_rate * std::sqrt(4.0 / std::numbers::pi / mean_pressure);
  found.softness = mean_pressure;
  found.coordination = means.mean(2, 0, means.blocks());
  return found;
}

void draw(Findings& findings, const std::vector<Flow>& all) {
  Table table{.name = "flow",
              .caption =
                  "Friction, with its standard error from ten blocks, at the inertial number that the solid "
                  "fraction gives; softness $p/K_1$; contacts of a disc; largest overlap over $d$.",
              .columns = {"phi", "I", "mu", "error", "p/K1", "contacts", "overlap"},
              .rows = {}};
  Series points{"discs", {}, {}, Style::errorbars};
  for (const Flow& flow : all) {
    const auto [mu, error] = flow.friction;
    table.rows.push_back({fmt::format("{:.3f}", flow.fraction), fmt::format("{:.4f}", flow.inertial),
                          fmt::format("{:.4f}", mu), fmt::format("{:.4f}", error), fmt::format("{:.1e}", flow.softness),
                          fmt::format("{:.2f}", flow.coordination), fmt::format("{:.3f}", flow.deepest)});
    points.x.push_back(flow.inertial), points.y.push_back(mu);
    points.y_low.push_back(mu - 3.0 * error), points.y_high.push_back(mu + 3.0 * error);
  }
  findings.table(table);
  findings.figure({.name = "friction",
                   .title = "Friction of discs without friction",
                   .caption =
                       "$\\mu$ against the inertial number; bars: three standard errors; lines: the range expected "
                       "at I = .003.",
                   .x = {.label = "I", .log = true},
                   .y = {.label = "mu", .min = 0.0},
                   .series = {points},
                   .lines = {{'y', 0.10, ""}, {'y', 0.13, ""}}});
}

void run(Findings& findings, const Setup& setup) {
  const bool full = setup.tier == Tier::full && !setup.coarse;
  const std::vector<double> fractions = setup.coarse ? std::vector<double>{0.843}
                                        : full       ? std::vector<double>{0.76, 0.80, 0.82, 0.83, 0.843}
                                                     : std::vector<double>{0.80, 0.83, 0.843};
  const double strain = full ? 7.0 : setup.coarse ? 2.5 : 4.0;
  std::vector<Flow> all;
  for (const double fraction : fractions)
    all.push_back(shear(fraction, full ? 600 : 200, 1.0, strain, findings, setup));
  const Flow& slow = all.back();
  const double twice = 2.0 * slow.friction.error;
  findings.expect_between(
      "friction at the slowest flow", slow.friction.value, 0.10 - twice, 0.13 + twice,
      fmt::format("what an independent code's runs gave at I = .003, .10 to .13, and two standard errors "
                  "of {:.4f} beyond",
                  slow.friction.error));
  findings.expect_between("inertial number of the slowest flow", slow.inertial, 0.0025, 0.0040,
                          "so that the friction is that of I about .003");
  if (!setup.coarse) draw(findings, all);
}

}  // namespace

Case dense_flow() {
  return {.id = "dense_flow",
          .title = "A dense flow of discs of unlike size",
          .requirements = {{"F7", {"friction at the slowest flow", "inertial number"}}},
          .main_checks = {"friction at the slowest flow", "inertial number of the slowest flow"},
          .source = "da Cruz et al. 2005; Peyneau & Roux 2008",
          .page = page,
          .faults = {{"equal_discs", "discs of one size, which order themselves", "friction at the slowest flow"},
                     {"still_box", "images that do not slide", "inertial number of the slowest flow"},
                     {"motion_alone", "stress by the motion alone", "inertial number of the slowest flow"}},
          .tier = Tier::quick,
          .time_limit = 600.0,
          .run = run};
}

}  // namespace talus::verification::problems
