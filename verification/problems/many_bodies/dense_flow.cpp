#include "verification/problems/many_bodies/dense_runs.hpp"
#include "verification/study/toolkit.hpp"

namespace talus::verification::problems::dense_flow {
namespace {

void draw(Findings& findings, const std::vector<DenseFlow>& all) {
  Table table{.name = "flow",
              .caption =
                  "Effective friction, with its standard error from ten blocks, at the inertial number that results "
                  "from the solid fraction; softness $p/K_1$; contacts per disc; mean overlap of a contact over $d$.",
              .columns = {"phi", "I", "mu", "error", "p/K1", "contacts", "overlap"}};
  Series points{"discs", {}, {}, Style::errorbars};
  for (const DenseFlow& flow : all) {
    const auto [mu, error] = flow.friction;
    table.rows.push_back(cells("{:.3f} | {:.4f} | {:.4f} | {:.4f} | {:.1e} | {:.2f} | {:.1e}", flow.fraction,
                               flow.inertial.value, mu, error, flow.pressure.value, flow.coordination, flow.overlap));
    points.add(flow.inertial.value, mu);
    points.y_low.push_back(mu - 3.0 * error), points.y_high.push_back(mu + 3.0 * error);
  }
  findings.table(table);
  findings.figure(
      {.name = "friction",
       .title = "Effective friction of frictionless discs",
       .caption =
           "$\\mu$ against the inertial number; bars: three standard errors; lines: range expected at I = 0.003.",
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
  DensePlan plan{.shear_rate = 1e-4, .discs = full ? std::size_t{600} : std::size_t{200}};
  plan.strain = full ? 7.0 : setup.coarse ? 2.5 : 4.0;
  if (setup.has("equal_discs")) plan.spread = 0.0;
  plan.still_box = setup.has("still_box"), plan.motion_alone = setup.has("motion_alone");
  std::vector<DenseFlow> all;
  for (const double fraction : fractions) {
    plan.fraction = fraction;
    all.push_back(run_dense(plan));
    findings.count(all.back().steps);
  }
  const DenseFlow& slow = all.back();
  const double twice = 2.0 * slow.friction.error;
  findings.expect_between(
      {"slowest_flow/friction", "effective friction of the slowest flow"}, slow.friction.value, 0.10 - twice,
      0.13 + twice,
      fmt::format("runs of an independent code gave 0.10 to 0.13 at I = 0.003; the range is extended "
                  "by two standard errors of {:.4f}",
                  slow.friction.error));
  findings.expect_between({"slowest_flow/inertial_number", "inertial number of the slowest flow"}, slow.inertial.value,
                          0.0025, 0.0040, "so that the friction is that at I of about 0.003");
  if (setup.coarse) return;
  // The flows are listed from loose to dense, which is from fast to slow.
  double smallest = std::numeric_limits<double>::infinity();
  bool slower = true;
  for (std::size_t i = 1; i < all.size(); ++i) {
    const Estimate fast = all[i - 1].friction, next = all[i].friction;
    keep_smallest(smallest, (fast.value - next.value) / std::hypot(fast.error, next.error));
    slower = slower && all[i].inertial.value < all[i - 1].inertial.value;
  }
  const auto group = findings.in("growth");
  group->expect_true("inertial number of each flow below that of the looser one", slower,
                     "denser discs at the same shear rate have a higher pressure");
  group->expect_between("increase of friction with the inertial number, smallest over its standard error", smallest,
                        3.0, 100.0,
                        "friction grows as a power of the inertial number (Peyneau & Roux 2008): three standard errors "
                        "of the difference, so that chance is excluded for each of at most four increases; more than a "
                        "hundred would mean that the errors are too small");
  draw(findings, all);
}

}  // namespace

Case definition() {
  return {.id = "dense_flow",
          .title = "Dense flow of discs of different size",
          .requirements = {{"F7", {"slowest_flow", "growth"}}},
          .main_checks = {"slowest_flow/friction", "slowest_flow/inertial_number"},
          .source = "da Cruz et al. 2005; Peyneau & Roux 2008",
          .faults = {{"equal_discs", "discs of equal size, which order themselves", "slowest_flow/friction"},
                     {"still_box", "periodic images that do not slide", "slowest_flow/inertial_number"},
                     {"motion_alone", "stress from motion alone", "slowest_flow/inertial_number"}},
          .seconds = 4.0,
          .full_seconds = 18.0,
          .run = run};
}

}  // namespace talus::verification::problems::dense_flow
