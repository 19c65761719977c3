#include <numeric>

#include "solver/base/error.hpp"
#include "solver/granular/disc_method.hpp"
#include "solver/granular/disc_system.hpp"
#include "solver/granular/fast_disc_system.hpp"
#include "solver/granular/list_skin.hpp"
#include "solver/granular/neighbour_list.hpp"
#include "verification/problems/cell/cell_runs.hpp"
#include "verification/reference/many_bodies/all_pairs.hpp"
#include "verification/study/toolkit.hpp"

namespace talus::verification::problems::disc_lists {
namespace {

/// Number of values that differ between two states: positions, velocities, spins.
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

/// Head-on impacts of two discs that start at gaps close to the skin: within it, so that the pair is listed at the
/// start, and beyond it, so that it is not. Each step brings the discs nearer by 1/2000 of the skin, and the gaps are
/// spaced so closely that some pair is also at each edge of a near list.
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
  findings.expect_exact("pairs that collided and separated", met, gaps, "all pairs collide head on");
  const Tolerance same = Tolerance::exact("a list omits only pairs that do not touch");
  findings.expect({"edges", "values that differ from a loop over all pairs, plain engine"}, plain_differs, 0.0, same);
  findings.expect({"edges", "values that differ from a loop over all pairs, fast engine"}, fast_differs, 0.0, same);
}

/// A periodic box is refused if it is narrower than two reaches of the list, within which a disc could meet two images
/// of another.
void expect_narrow_boxes(Findings& findings) {
  constexpr double small = 0.4, reach = 2.0 * radius + skin;  // of two of the largest discs
  DiscShapes shapes;
  Discs discs;
  shapes.add(radius, 1.0), shapes.add(small, 1.0);
  discs.add(0.0, 0.0, 0.0, 0.0), discs.add(1.2, 0.2, 0.0, 0.0);
  double wrong = 0.0;
  for (const bool wide : {true, false}) {
    const double narrow = (wide ? 2.001 : 1.999) * reach;
    for (const PeriodicBox& box : {PeriodicBox{.width = narrow}, PeriodicBox{.width = 10.0, .height = narrow}}) {
      bool refused = false;
      try {
        NeighbourList list{box, skin};
        list.build(shapes, discs);
      } catch (const InputError&) {
        refused = true;
      }
      wrong += refused == !wide ? 0.0 : 1.0;
    }
  }
  findings.expect_exact("periodic boxes on both sides of two reaches of the list that are wrongly accepted or refused",
                        wrong, 0.0, "width and height, a thousandth below and above");
}

enum class Numbering { by_rows, scattered };

/// A cell of rough discs of two sizes, whose lever arms differ, with fast discs and a driven block. Scattered: the
/// discs of the walls have the first numbers, and neighbours among the others have distant ones; two of three others
/// are larger and press on the walls, because only sums of three forces depend on their order.
FilledCell rough_cell(const ShearCell& cell, Numbering numbering) {
  FilledCell start = fill(cell);
  const std::size_t free = cell.free_discs();
  const double larger = numbering == Numbering::by_rows ? 1.0 : 1.2;
  for (std::size_t i = 0; i < free; ++i) {
    start.shapes.radius[i] *= i % 3 == 0 ? 0.8 : larger;
    start.discs.vy[i] *= 60.0;
  }
  if (numbering == Numbering::by_rows) return start;
  constexpr std::size_t stride = 37;
  TALUS_DEMAND(std::gcd(stride, free) == 1);
  std::vector<std::size_t> order;
  for (std::size_t i = free; i < start.discs.size(); ++i)
    order.push_back(i);
  for (std::size_t i = 0; i < free; ++i)
    order.push_back(stride * i % free);
  const auto renumber = [&order](auto& list) {
    auto renumbered = list;
    for (std::size_t i = 0; i < list.size(); ++i)
      renumbered[i] = list[order[i]];
    list = std::move(renumbered);
  };
  renumber(start.shapes.radius), renumber(start.shapes.inverse_mass), renumber(start.shapes.wall);
  renumber(start.discs.x), renumber(start.discs.y);
  renumber(start.discs.vx), renumber(start.discs.vy), renumber(start.discs.spin);
  return start;
}

/// A cell run by several threads: friction turns both discs of a pair and acts on the walls, also where they belong to
/// other stripes. With scattered numbers a wall meets discs of the same stripe and of others in turn.
void expect_stripes(Findings& findings, const Setup& setup, Numbering numbering) {
  const ShearCell cell = ice_cell(8e3, 5e3);
  const FilledCell start = rough_cell(cell, numbering);
  const LinearSpringDashpot law{20305.0, 0.0208981};
  const CoulombFriction friction{0.5, 14214.0};
  const double h = cell.contact_time() / 20.0;
  const long steps = 1000;
  const std::string which = numbering == Numbering::by_rows ? "" : ", scattered numbers";
  const std::size_t turned = numbering == Numbering::by_rows ? 0 : start.discs.size() - cell.free_discs();
  Discs of_plain = start.discs;
  Vec2 on_block, on_base;
  DiscSystem plain{start.shapes, start.box, law, 0.3 * cell.diameter, friction};
  plain.begin(of_plain);
  for (long n = 0; n < steps; ++n) {
    plain.kick(of_plain, h), plain.drift(of_plain, h);
    on_block += h * plain.wall_force(block_wall), on_base += h * plain.wall_force(base_wall);
  }
  findings.count(plain.evaluations());
  findings.expect_true("non-zero spin and wall impulses" + which,
                       on_block.y > 0.0 && on_base.y < 0.0 && std::abs(of_plain.spin[turned]) > 0.0,
                       "otherwise neither would be compared");
  for (const std::size_t threads : {2U, 5U}) {
    const std::string name = fmt::format("values that differ from the plain engine{}, {} threads", which, threads);
    if (!setup.needs(name)) continue;
    Discs of_fast = start.discs;
    if (setup.has("one_disc_off")) of_fast.vx[turned + 5] *= 1.0 + 1e-15;
    Vec2 block, base;
    FastDiscSystem fast{start.shapes, start.box, law, 0.3 * cell.diameter, friction, threads};
    fast.begin(of_fast);
    fast.advance(of_fast, h, steps,
                 [&] { block += h * fast.wall_force(block_wall), base += h * fast.wall_force(base_wall); });
    findings.count(fast.evaluations());
    const double walls = (block == on_block ? 0.0 : 1.0) + (base == on_base ? 0.0 : 1.0);
    findings.expect_exact({"stripes", name}, static_cast<double>(differing(of_fast, of_plain)) + walls, 0.0,
                          "the same sums in the same order: positions, velocities, spins, impulses on both walls");
  }
}

/// Many discs thrown together, run by two threads, whose numbers are scattered: more pairs of discs of both stripes
/// than are swept at a time.
void expect_many_pairs(Findings& findings) {
  constexpr int side = 60;
  const LinearSpringDashpot law{1e4, 8.0};
  DiscShapes shapes;
  Discs discs;
  for (int i = 0; i < side * side; ++i) {
    shapes.add(radius, 1.0);
    const int site = 1009 * i % (side * side);
    const double x = 1.01 * (site % side), y = 1.01 * (site / side);
    discs.add(x, y, 0.5 * std::sin(3.0 * i), 0.5 * std::cos(7.0 * i));
  }
  const PeriodicBox box{.width = 1.01 * side, .height = 1.01 * side};
  constexpr double h = 1e-3;
  constexpr long steps = 40;
  Discs of_plain = discs, of_fast = discs;
  FastDiscSystem fast{shapes, box, law, 0.3, CoulombFriction{0.0, 1e3}, 2};
  DiscSystem plain{shapes, box, law, 0.3, CoulombFriction{0.0, 1e3}};
  plain.begin(of_plain), fast.begin(of_fast);
  for (long n = 0; n < steps; ++n)
    plain.kick(of_plain, h), plain.drift(of_plain, h);
  fast.advance(of_fast, h, steps);
  findings.count(plain.evaluations() + fast.evaluations());
  double touching = 0.0;
  plain.for_each_contact(of_plain, [&](const DiscContact& contact) { touching += contact.depth > 0.0 ? 1.0 : 0.0; });
  findings.expect_between("contacts of 3600 discs after 40 steps", touching, 500.0, 10000.0,
                          "gaps of 0.01 close within 20 steps, and a contact lasts as long");
  findings.expect_exact({"many_pairs", "values of 3600 discs that differ from the plain engine, 2 threads"},
                        static_cast<double>(differing(of_fast, of_plain)), 0.0, "the same sums in the same order");
}

/// Oblique impact of two rough, spinning discs of different size and mass. The kinetic energy that they lose is
/// compared with the energy dissipated by contacts, and the reported overlap and force of the contact with those
/// computed from positions and velocities.
template <class System>
void expect_losses(Findings& findings, const Setup& setup, const std::string& engine) {
  const LinearSpringDashpot law{1e4, 8.0};
  const CoulombFriction friction{0.3, 6e3};
  record_use(law);
  const std::array masses{1.0, 0.5}, radii{0.5, 0.4};
  DiscShapes shapes;
  Discs discs;
  for (std::size_t i = 0; i < 2; ++i)
    shapes.add(radii[i], 1.0 / masses[i]);
  // The discs meet across both borders of the box.
  const PeriodicBox box{.width = 5.0, .height = 3.0};
  discs.add(2.3, 1.3, 0.3, 0.4), discs.add(3.02 - box.width, 1.861 - box.height, -1.1, -0.7);
  discs.spin = {3.0, -2.0};
  System system{shapes, box, law, skin, friction};
  if constexpr (requires { system.keep_work(); }) system.keep_work();
  system.begin(discs);
  const auto energy = [&] {
    double sum = 0.0;
    for (std::size_t i = 0; i < 2; ++i) {
      const double turning = 0.5 * masses[i] * radii[i] * radii[i];
      sum += 0.5 * masses[i] * (discs.vx[i] * discs.vx[i] + discs.vy[i] * discs.vy[i]) +
             0.5 * turning * discs.spin[i] * discs.spin[i];
    }
    return sum;
  };
  const double before = energy(), contact_time = std::numbers::pi / std::sqrt(law.stiffness * 3.0);
  constexpr long per_contact = 4000;
  const double h = contact_time / static_cast<double>(per_contact);
  double reports = 0.0, wrong = 0.0;
  for (long n = 0; n < 2 * per_contact; ++n) {
    system.kick(discs, h), system.drift(discs, h);
    system.for_each_contact(discs, [&](const DiscContact& contact) {
      const double dx = std::remainder(discs.x[1] - discs.x[0], box.width);
      const double dy = std::remainder(discs.y[1] - discs.y[0], box.height), distance = std::hypot(dx, dy);
      const double approach = -((discs.vx[1] - discs.vx[0]) * dx + (discs.vy[1] - discs.vy[0]) * dy) / distance;
      const double depth = radii[0] + radii[1] - distance;
      const double force = std::max(0.0, law.stiffness * depth + law.damping * approach);
      reports += 1.0;
      keep_worst(wrong, (contact.depth - depth) / radii[0]), keep_worst(wrong, (contact.force - force) / 1e3);
    });
  }
  const double lost = before - energy(), kept = discs.dissipated() * (setup.has("loss_off") ? 1.002 : 1.0);
  findings.count(system.evaluations());
  const auto group = findings.in("losses");
  findings.expect_between("steps in contact over those of an undamped contact, " + engine,
                          reports / static_cast<double>(per_contact), 1.0015, 1.0031,
                          "with xi = 0.069 the discs overlap 1/sqrt(1 - xi^2) = 1.0024 times as long, less 4 xi^3/(3 "
                          "pi) = 0.0001, because the clamped force ends before the overlap; half a step, 0.0001, at "
                          "each end, and 0.0002 for the rotation of the pair, twice each");
  findings.expect_round_off("reported overlap and force, largest error against positions and velocities, " + engine,
                            wrong, 0.0, 1e-14,
                            "differences of positions of about 1; the force of an overlap of a thousandth of that with "
                            "the stiffness 1e4, over 1000");
  findings.expect_truncation("energy dissipated by contacts over the kinetic energy lost, " + engine, kept / lost, 1.0,
                             contact_time * std::sqrt(law.stiffness * 3.0) / static_cast<double>(per_contact), 1.0,
                             "powers are evaluated at the beginning of each step: first order in w h");
}

/// The skin of a list is the one that was fastest for the nearest of the tabulated solid fractions and decades: it
/// changes at the middle between two of them.
void expect_skins(Findings& findings) {
  double wrong = 0.0;
  const auto demand = [&](std::size_t discs, double fraction, std::size_t like, double of) {
    if (list_skin(discs, fraction) != list_skin(like, of)) wrong += 1.0;
  };
  demand(100, 0.39, 100, 0.3), demand(100, 0.41, 100, 0.5), demand(100, 0.1, 100, 0.3), demand(100, 1.2, 100, 0.9);
  demand(316, 0.3, 100, 0.3), demand(317, 0.3, 1000, 0.3), demand(1, 0.3, 100, 0.3), demand(900000, 0.3, 100000, 0.3);
  demand(31622, 0.84, 10000, 0.84), demand(31623, 0.84, 100000, 0.84);
  const bool differ = list_skin(100, 0.3) < list_skin(100, 0.5) && list_skin(1000, 0.3) > list_skin(100, 0.3) &&
                      list_skin(10000, 0.84) > list_skin(100000, 0.84) && list_skin(100, 0.9) < list_skin(100, 0.3);
  findings.expect_exact("skins that differ from the table entry of the nearest solid fraction and decade",
                        wrong + (differ ? 0.0 : 1.0), 0.0,
                        "the table contains the fastest skins; dilute gases need a thick skin, dense flows a thin one");
}

/// Two discs that never meet, by every method that steps discs: states are reported at the time of their velocities,
/// also by methods that store positions half a step later.
template <class System>
void expect_flight(Findings& findings, const std::string& engine) {
  constexpr double h = 0.1;
  constexpr int steps = 10;
  const PeriodicBox box{.width = 12.0, .height = 12.0, .shear_rate = 0.05};
  DiscShapes shapes;
  Discs start;
  for (const double side : {-1.0, 1.0}) {
    shapes.add(radius, 1.0);
    start.add(2.5 * side, 1.5 * side, -0.3 * side, 0.25 * side);
  }
  double worst = 0.0;
  for (const std::string& name : disc_method_names()) {
    System system{shapes, box, LinearSpringDashpot{0.5, 0.0}, skin};
    Discs discs = start;
    system.begin(discs);
    DiscMethod any = make_disc_method(name);
    const Discs end = std::visit(
        [&](auto& method) {
          method.start(system, discs, h);
          for (int n = 0; n < steps; ++n)
            method.step(system, discs, h);
          return synchronized(method, system, discs, h);
        },
        any);
    for (std::size_t i = 0; i < start.size(); ++i) {
      keep_worst(worst, end.x[i] - (start.x[i] + steps * h * start.vx[i]));
      keep_worst(worst, end.y[i] - (start.y[i] + steps * h * start.vy[i]));
    }
    keep_worst(worst, end.shear_displacement - steps * h * box.sliding());
  }
  findings.expect_round_off({"flight", "positions in free flight, largest error of all methods, " + engine}, worst, 0.0,
                            1e-14, "eleven additions to coordinates of up to 3");
}

/// NeighbourList::find compared with a search through the whole list, for listed and unlisted pairs.
void expect_indices(Findings& findings) {
  const FilledCell start = fill(ice_cell(8e3, 5e3));
  NeighbourList list{start.box, 0.3 * 2.0 * start.shapes.radius[0]};
  Discs discs = start.discs;
  wrap(start.box, discs);
  list.build(start.shapes, discs);
  std::vector<std::size_t> indices(discs.size() * discs.size(), list.size());
  list.for_each_pair(discs, [&](std::size_t i, std::size_t j, std::size_t pair, Vec2, const auto&) {
    indices[i * discs.size() + j] = pair;
  });
  double differ = 0.0, listed = 0.0;
  for (std::size_t i = 0; i < discs.size(); ++i) {
    for (std::size_t j = i + 1; j < discs.size(); ++j) {
      differ += list.find(i, j) == indices[i * discs.size() + j] ? 0.0 : 1.0;
      listed += indices[i * discs.size() + j] < list.size() ? 1.0 : 0.0;
    }
  }
  findings.expect_exact({"edges", "indices of pairs in a list that differ from a full search"}, differ, 0.0,
                        "indices of pairs are integers");
  findings.expect_exact("pairs found in a list", listed, static_cast<double>(list.size()), "each pair is listed once");
}

void run(Findings& findings, const Setup& setup) {
  if (setup.needs("pairs in a list")) expect_indices(findings);
  if (setup.needs("positions in free flight")) {
    expect_flight<DiscSystem<LinearSpringDashpot>>(findings, "plain engine");
    expect_flight<FastDiscSystem<LinearSpringDashpot>>(findings, "fast engine");
  }
  if (setup.needs("skins")) expect_skins(findings);
  if (setup.needs("contact")) {
    expect_losses<DiscSystem<LinearSpringDashpot, CoulombFriction>>(findings, setup, "plain engine");
    expect_losses<FastDiscSystem<LinearSpringDashpot, CoulombFriction>>(findings, setup, "fast engine");
  }
  if (setup.needs("loop over all pairs")) expect_edges(findings, setup);
  if (setup.needs("3600 discs")) expect_many_pairs(findings);
  if (setup.needs("periodic boxes")) expect_narrow_boxes(findings);
  if (setup.needs("threads")) {
    expect_stripes(findings, setup, Numbering::by_rows);
    expect_stripes(findings, setup, Numbering::scattered);
  }
}

}  // namespace

Case definition() {
  return {.id = "disc_lists",
          .title = "Neighbour lists and parallel stripes: edge cases",
          .family = "the shear cell",
          .requirements = {{"F3", {"edges", "stripes", "losses", "flight"}}},
          .main_checks = {"values that differ from a loop over all pairs, plain engine",
                          "values that differ from a loop over all pairs, fast engine",
                          "values that differ from the plain engine, 5 threads"},
          .source = "Verlet 1967 (neighbour lists); order of sums, derived here",
          .faults = {{"found_a_step_late", "contact forces of the reference begin one step after the discs touch",
                      "values that differ from a loop over all pairs, plain engine"},
                     {"one_disc_off", "one initial velocity of the fast engine larger by the fraction 1e-15",
                      "values that differ from the plain engine, 5 threads"},
                     {"loss_off", "dissipated energy 0.2 % too large",
                      "energy dissipated by contacts over the kinetic energy lost, fast engine"}},
          .run = run};
}

}  // namespace talus::verification::problems::disc_lists
