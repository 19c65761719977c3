#include <fmt/format.h>

#include <cmath>
#include <string>
#include <vector>

#include "solver/granular/disc_system.hpp"
#include "solver/granular/fast_disc_system.hpp"
#include "verification/check/case.hpp"
#include "verification/problems/cell/cell_runs.hpp"
#include "verification/reference/all_pairs.hpp"
#include "verification/study/usage.hpp"

namespace talus::verification::problems::disc_lists {
namespace {

/// Numbers of two states that differ: places, velocities, spins.
long differing(const Discs& a, const Discs& b) {
  long differ = 0;
  const auto compare = [&](const std::vector<double>& one, const std::vector<double>& other) {
    for (std::size_t i = 0; i < one.size(); ++i)
      differ += one[i] == other[i] ? 0 : 1;
  };
  compare(a.x, b.x), compare(a.y, b.y), compare(a.vx, b.vx), compare(a.vy, b.vy), compare(a.spin, b.spin);
  return differ;
}

constexpr double radius = 0.5, skin = 0.5, speed = 8e-4, step = 0.157;

/// Head-on impacts of two discs that start at gaps about the skin: within it, so that they are listed at the start, and
/// beyond, so that they are not. Each step brings them nearer by 1/2000 of the skin, and the gaps are so close to each
/// other that some pair is at each edge of a near list, too.
void expect_edges(Findings& findings, const Setup& setup) {
  const LinearSpringDashpot law{0.5, 0.1};
  record_use(law);
  double plain_differs = 0.0, fast_differs = 0.0, met = 0.0;
  constexpr int gaps = 40;
  for (int n = 0; n < gaps; ++n) {
    const double gap = 1.004 * skin - 8e-4 * n;
    DiscShapes shapes;
    Discs discs;
    for (const double side : {-1.0, 1.0}) {
      shapes.add(radius, 1.0);
      discs.add(side * (radius + 0.5 * gap), 0.0, -side * speed, 0.0);
    }
    reference::AllPairs all{.stiffness = law.stiffness,
                            .damping = law.damping,
                            .radius = {radius, radius},
                            .inverse_mass = {1.0, 1.0},
                            .x = discs.x,
                            .y = discs.y,
                            .vx = discs.vx,
                            .vy = discs.vy};
    DiscSystem plain{shapes, {}, law, skin};
    FastDiscSystem fast{shapes, {}, law, skin};
    Discs of_plain = discs, of_fast = discs;
    plain.begin(of_plain), fast.begin(of_fast);
    const long steps = std::lround(gap / (2.0 * speed * step)) + 60;
    bool late = setup.has("found_a_step_late");
    for (long k = 0; k < steps; ++k) {
      if (late && all.x[1] - all.x[0] < 2.0 * radius) {
        late = false;
        all.x[0] += step * all.vx[0], all.x[1] += step * all.vx[1];
      } else {
        all.step(step);
      }
      plain.kick(of_plain, step), plain.drift(of_plain, step);
    }
    fast.advance(of_fast, step, steps);
    findings.count(plain.evaluations() + fast.evaluations());
    Discs exact = of_plain;
    exact.x = all.x, exact.y = all.y, exact.vx = all.vx, exact.vy = all.vy;
    plain_differs += static_cast<double>(differing(of_plain, exact));
    fast_differs += static_cast<double>(differing(of_fast, exact));
    met += all.vx[1] > 0.0 ? 1.0 : 0.0;
  }
  findings.expect("pairs that met and parted", met, gaps, Tolerance::exact("all of them head on"));
  const Tolerance same = Tolerance::exact("a list leaves out pairs that do not touch");
  findings.in("edges")->expect("numbers that differ from a loop over all pairs, plain engine", plain_differs, 0.0,
                               same);
  findings.in("edges")->expect("numbers that differ from a loop over all pairs, fast engine", fast_differs, 0.0, same);
}

/// A cell of rough discs, whose block is driven, by several threads: friction turns both discs of a pair and pushes the
/// walls, also where they are in other stripes.
void expect_stripes(Findings& findings, const Setup& setup) {
  ShearCell cell = ice_cell(8e3, 5e3);
  FilledCell start = fill(cell);
  for (std::size_t i = 0; i < cell.free_discs(); ++i) {
    // Discs of two sizes, whose arms differ.
    if (i % 3 == 0) start.shapes.radius[i] *= 0.8;
    start.discs.vy[i] *= 60.0;
  }
  const LinearSpringDashpot law{20305.0, 0.0208981};
  const CoulombFriction friction{0.5, 14214.0};
  const double h = cell.contact_time() / 20.0;
  const long steps = 1000;
  Discs of_plain = start.discs;
  Vec2 on_block, on_base;
  DiscSystem plain{start.shapes, start.box, law, 0.3 * cell.diameter, friction};
  plain.begin(of_plain);
  for (long n = 0; n < steps; ++n) {
    plain.kick(of_plain, h), plain.drift(of_plain, h);
    on_block += h * plain.wall_force(block_wall), on_base += h * plain.wall_force(base_wall);
  }
  findings.count(plain.evaluations());
  findings.expect_true("discs turn, and the block is pushed",
                       on_block.y > 0.0 && on_base.y < 0.0 && std::abs(of_plain.spin[0]) > 0.0,
                       "else neither is compared");
  for (const std::size_t threads : {2U, 5U}) {
    const std::string name = fmt::format("numbers that differ from the plain engine's with {} threads", threads);
    if (!setup.needs(name)) continue;
    Discs of_fast = start.discs;
    if (setup.has("one_disc_off")) of_fast.vx[5] *= 1.0 + 1e-15;
    Vec2 block, base;
    FastDiscSystem fast{start.shapes, start.box, law, 0.3 * cell.diameter, friction, threads};
    fast.begin(of_fast);
    fast.advance(of_fast, h, steps,
                 [&] { block += h * fast.wall_force(block_wall), base += h * fast.wall_force(base_wall); });
    findings.count(fast.evaluations());
    const double walls = (block == on_block ? 0.0 : 1.0) + (base == on_base ? 0.0 : 1.0);
    findings.in("stripes")->expect(
        name, static_cast<double>(differing(of_fast, of_plain)) + walls, 0.0,
        Tolerance::exact("the same sums in the same order: places, velocities, spins, impulses on both walls"));
  }
}

void run(Findings& findings, const Setup& setup) {
  if (setup.needs("loop over all pairs")) expect_edges(findings, setup);
  if (setup.needs("threads")) expect_stripes(findings, setup);
}

}  // namespace

Case definition() {
  return {.id = "disc_lists",
          .title = "Neighbour lists to their edges, and stripes with walls and friction",
          .family = "the shear cell",
          .requirements = {{"F3", {"edges", "stripes"}}},
          .main_checks = {"numbers that differ from a loop over all pairs, plain engine",
                          "numbers that differ from a loop over all pairs, fast engine",
                          "numbers that differ from the plain engine's with 5 threads"},
          .source = "Verlet 1967 (neighbour lists); order of sums, derived here",
          .faults = {{"found_a_step_late", "the reference lets discs overlap for a step before they push",
                      "numbers that differ from a loop over all pairs, plain engine"},
                     {"one_disc_off", "one velocity of the fast engine 1e-15 of itself larger",
                      "numbers that differ from the plain engine's with 5 threads"}},
          .run = run};
}

}  // namespace talus::verification::problems::disc_lists
