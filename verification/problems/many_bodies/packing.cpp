#include "solver/granular/packing.hpp"

#include "solver/base/error.hpp"
#include "verification/study/toolkit.hpp"

namespace talus::verification::problems::packing {
namespace {

constexpr double diameter = 0.3, mass = 2.0;

PackingPlan plan_of(std::size_t discs, double fraction, double spread, bool walls, double aspect) {
  return {.discs = discs,
          .diameter = diameter,
          .spread = spread,
          .mass = mass,
          .solid_fraction = fraction,
          .aspect = aspect,
          .walls = walls,
          .seed = 5};
}

struct Plan {
  std::string name;
  Packing (*make)(const PackingPlan&);
  PackingPlan plan;
};

std::vector<Plan> plans() {
  return {{"scattered in a periodic box", &scatter, plan_of(400, 0.45, 0.0, false, 1.5)},
          {"scattered between walls", &scatter, plan_of(300, 0.4, 0.3, true, 0.5)},
          {"grown in a periodic box", &grow, plan_of(150, 0.75, 0.2, false, 1.5)},
          {"grown between walls", &grow, plan_of(120, 0.7, 0.2, true, 1.0)}};
}

bool is_free(const Packing& packing, std::size_t i) { return packing.shapes.wall[i] == DiscShapes::free; }

/// Minimum distance of two centres over the sum of the radii, by all pairs and images.
double minimum_distance(const Packing& packing) {
  double minimum = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < packing.discs.size(); ++i) {
    for (std::size_t j = i + 1; j < packing.discs.size(); ++j) {
      if (!is_free(packing, i) && !is_free(packing, j)) continue;
      const double dx = std::remainder(packing.discs.x[j] - packing.discs.x[i], packing.width);
      double dy = packing.discs.y[j] - packing.discs.y[i];
      if (packing.box.repeats_y()) dy = std::remainder(dy, packing.height);
      minimum = std::min(minimum, std::hypot(dx, dy) / (packing.shapes.radius[i] + packing.shapes.radius[j]));
    }
  }
  return minimum;
}

/// Sums over the free discs of a packing.
struct Sums {
  double discs{}, area{}, farthest{}, wrong_mass{}, moving{}, size{}, square{}, x{}, y{};

  explicit Sums(const Packing& packing, bool walls) {
    for (std::size_t i = 0; i < packing.discs.size(); ++i) {
      if (!is_free(packing, i)) continue;
      const double ratio = 2.0 * packing.shapes.radius[i] / diameter;
      discs += 1.0, area += 0.25 * std::numbers::pi * ratio * ratio * diameter * diameter;
      size += ratio, square += ratio * ratio;
      keep_worst(wrong_mass, 1.0 / packing.shapes.inverse_mass[i] / (mass * ratio * ratio) - 1.0);
      if (packing.discs.vx[i] != 0.0 || packing.discs.vy[i] != 0.0) moving += 1.0;
      const double room = packing.height - (walls ? 0.6 * 2.0 * packing.shapes.radius[i] : 0.0);
      farthest = std::max(
          {farthest, 2.0 * std::abs(packing.discs.x[i]) / packing.width, 2.0 * std::abs(packing.discs.y[i]) / room});
      x += packing.discs.x[i] / packing.width, y += packing.discs.y[i] / packing.height;
    }
  }
};

/// Number of wall discs whose position, mass, wall or radius is not that of a row of touching discs below or above the
/// rectangle.
double displaced_wall_discs(const Packing& packing, std::size_t free) {
  const std::size_t row = (packing.discs.size() - free) / 2;
  double wrong = std::abs(static_cast<double>(row) - packing.width / diameter) > 1e-9 ? 1.0 : 0.0;
  for (std::size_t k = 0; k < 2 * row; ++k) {
    const std::size_t i = free + k;
    const double x = (static_cast<double>(k % row) + 0.5) * diameter - 0.5 * packing.width;
    const double y = (k < row ? -0.5 : 0.5) * (packing.height + diameter);
    const bool holds = std::hypot(packing.discs.x[i] - x, packing.discs.y[i] - y) < 1e-12 &&
                       packing.shapes.inverse_mass[i] == 0.0 && packing.shapes.wall[i] == (k < row ? 1u : 2u) &&
                       std::abs(packing.shapes.radius[i] - 0.5 * diameter) < 1e-15;
    if (!holds) wrong += 1.0;
  }
  return wrong;
}

Figure centres(const Packing& packing) {
  Figure figure{.name = "centres",
                .title = "Centres of a packing grown between walls",
                .caption =
                    "Discs with a diameter spread of 0.2 at the solid fraction 0.7, between rows of wall discs of the "
                    "middle size.",
                .x = {.label = "x/d"},
                .y = {.label = "y/d"}};
  Series free{.label = "free discs", .style = Style::points}, walls{.label = "walls", .style = Style::crosses};
  for (std::size_t i = 0; i < packing.discs.size(); ++i)
    (is_free(packing, i) ? free : walls).add(packing.discs.x[i] / diameter, packing.discs.y[i] / diameter);
  figure.series = {std::move(free), std::move(walls)};
  return figure;
}

void expect_as_planned(Findings& findings, const Setup& setup, const Plan& each, Table& table) {
  const PackingPlan& plan = each.plan;
  Packing packing = each.make(plan);
  if (setup.has("one_disc_overlaps")) packing.discs.x[7] = packing.discs.x[8], packing.discs.y[7] = packing.discs.y[8];
  const Sums sums{packing, plan.walls};
  const double n = static_cast<double>(plan.discs);
  const auto name = [&](const char* what) { return fmt::format("{}, {}", what, each.name); };
  findings.expect_exact(name("free discs"), sums.discs, n, "a count");
  findings.expect_round_off(
      name("solid fraction"), sums.area / (packing.width * packing.height), plan.solid_fraction, std::sqrt(n) * 2.3e-16,
      "a sum over n discs, rounded at each disc by at most 1.1e-16 of it at random: twice sqrt(n) of that");
  findings.expect(name("height over width"), packing.height / packing.width, plan.aspect,
                  plan.walls ? Tolerance::model(plan.aspect * diameter / packing.width,
                                                "the width is rounded to a whole number of diameters, by half a "
                                                "diameter at most, and the height compensates for it")
                             : Tolerance::round_off(1e-15, "two roots and quotients"));
  findings.expect_round_off(name("largest relative error of the masses"), sums.wrong_mass, 0.0, 1e-15,
                            "mass proportional to area: five operations");
  findings.expect_exact(name("moving discs"), sums.moving, 0.0, "all discs are at rest");
  const double minimum = minimum_distance(packing);
  findings.expect_between(name("minimum distance over the sum of radii"), minimum, 1.0, plan.walls ? 1.02 : 1.05,
                          "no two discs overlap; of a hundred or more some nearly touch", "1");
  findings.expect_round_off(name("minimum distance by the neighbour list"), closest(packing), minimum, 1e-14,
                            "differences of coordinates of up to 30 diameters");
  // The mean of uniformly random positions has a standard deviation of 1/sqrt(12 n) of the width.
  const double spread_of_mean = 4.0 / std::sqrt(12.0 * n);
  findings.expect_model(name("mean position along x over the width"), sums.x / n, 0.0, spread_of_mean,
                        "four standard deviations of the mean of random positions");
  findings.expect_model(name("mean position along y over the height"), sums.y / n, 0.0, spread_of_mean,
                        "four standard deviations of the mean of random positions");
  findings.expect_between(name("largest coordinate over half the rectangle"), sums.farthest, 0.9, 1.0 + 1e-12,
                          "discs fill the whole rectangle and do not leave it; a disc may extend 0.4 radii into a gap "
                          "between two wall discs");
  if (plan.spread > 0.0) {
    const double mean = sums.size / n, variance = sums.square / n - mean * mean;
    findings.expect_model(name("mean diameter over that of the middle size"), mean, 1.0,
                          4.0 * plan.spread / std::sqrt(3.0 * n), "four standard deviations");
    findings.expect_model(
        name("variance of diameters over that of a uniform distribution"), variance / (plan.spread * plan.spread / 3.0),
        1.0, 4.0 * std::sqrt(0.8 / n),
        "four standard deviations: the fourth moment of a uniform distribution is 9/5 of the square of the second");
  }
  if (plan.walls) {
    findings.expect_exact(name("displaced wall discs"), displaced_wall_discs(packing, plan.discs), 0.0,
                          "two rows without gaps");
  }
  if (each.name == "grown between walls" && !setup.coarse) findings.figure(centres(packing));
  table.rows.push_back(cells("{} | {} | {:g} | {:.2f} x {:.2f} | {:.6f}", each.name, plan.discs, plan.solid_fraction,
                             packing.width / diameter, packing.height / diameter, minimum));
}

/// Small packings, of many seeds, in which discs cross the border of the rectangle while they grow.
void expect_within(Findings& findings) {
  double farthest = 0.0;
  for (std::uint64_t seed = 1; seed <= 40; ++seed) {
    PackingPlan plan = plan_of(20, 0.7, 0.2, false, 1.0);
    plan.seed = seed;
    keep_largest(farthest, Sums{grow(plan), false}.farthest);
  }
  findings.expect_between(
      "small grown packings: largest coordinate over half the rectangle, 40 seeds", farthest, 0.9, 1.0 + 1e-12,
      "discs fill the whole rectangle and do not leave it; in some of these packings a disc crosses "
      "the border in the last steps of the growth");
}

/// Velocities of a given temperature: discs of unequal masses, with walls that remain at rest.
void expect_agitated(Findings& findings, const Setup& setup) {
  constexpr double temperature = 3.0;
  constexpr std::size_t count = 2000;
  Packing packing = scatter(plan_of(count, 0.1, 0.5, true, 1.0));
  agitate(packing, temperature, 9);
  double px = 0.0, py = 0.0, largest = 0.0, along_x = 0.0, along_y = 0.0, fourth = 0.0, of_walls = 0.0, of_small = 0.0,
         small = 0.0;
  for (std::size_t i = 0; i < packing.discs.size(); ++i) {
    const double vx = packing.discs.vx[i], vy = packing.discs.vy[i];
    if (!is_free(packing, i)) {
      of_walls += std::abs(vx) + std::abs(vy);
      continue;
    }
    const double m = setup.has("equal_masses") ? mass : 1.0 / packing.shapes.inverse_mass[i];
    px += m * vx, py += m * vy, largest += m * (std::abs(vx) + std::abs(vy));
    along_x += m * vx * vx / count, along_y += m * vy * vy / count;
    fourth += 0.5 * m * m * (vx * vx * vx * vx + vy * vy * vy * vy) / count;
    if (m < mass) of_small += 0.5 * m * (vx * vx + vy * vy), small += 1.0;
  }
  findings.expect(
      "temperature", 0.5 * (along_x + along_y), temperature,
      Tolerance::round_off(
          std::sqrt(count) * 2.3e-16,
          "a sum over n discs, rounded at each disc by at most 1.1e-16 of it at random: twice sqrt(n) of that")
          .relative(),
      "N m");
  findings.expect_round_off("momentum over the sum of its magnitudes", (std::abs(px) + std::abs(py)) / largest, 0.0,
                            5e-16,
                            "the mean is subtracted from each velocity, which rounds it by 1.1e-16 of the largest, "
                            "four times the mean, if all errors have the same sign");
  // The variance of a sum of squares of 2000 nearly Gaussian numbers is 2/2000 of its square.
  const double scatter_of_mean = 4.0 * std::sqrt(2.0 / count);
  findings.expect_model("temperature along x over that along y", along_x / along_y, 1.0,
                        std::sqrt(2.0) * scatter_of_mean, "four standard deviations of a quotient");
  findings.expect(
      "temperature of the lighter half of the discs", of_small / small, temperature,
      Tolerance::model(scatter_of_mean, "four standard deviations: the energy does not depend on the mass").relative(),
      "N m");
  findings.expect_model("fourth moment of the velocities over the square of the second",
                        fourth / (temperature * temperature), 2.9, 4.0 * std::sqrt(24.0 / (2.0 * count)),
                        "3 - 6/5/12 for a sum of twelve uniform random numbers; four standard deviations");
  findings.expect_exact("velocity of the walls", of_walls, 0.0, "wall discs are fixed", "m/s");
}

std::string refusal(const PackingPlan& plan, Packing (*make)(const PackingPlan&) = &scatter) {
  try {
    static_cast<void>(make(plan));
  } catch (const InputError& error) {
    return error.what();
  }
  return "";
}

/// Plans beyond a limit are refused, and their neighbours on the other side of it are not.
void expect_refusals(Findings& findings) {
  const auto changed = [](auto&& change) {
    PackingPlan plan = plan_of(20, 0.1, 0.0, false, 1.0);
    change(plan);
    return refusal(plan);
  };
  const std::vector<std::string> refused{
      changed([](PackingPlan& plan) { plan.discs = 0; }),
      changed([](PackingPlan& plan) { plan.diameter = 0.0; }),
      changed([](PackingPlan& plan) { plan.spread = std::nextafter(0.9, 1.0); }),
      changed([](PackingPlan& plan) { plan.spread = -1e-300; }),
      changed([](PackingPlan& plan) { plan.mass = 0.0; }),
      changed([](PackingPlan& plan) { plan.solid_fraction = std::nextafter(0.9, 1.0); }),
      changed([](PackingPlan& plan) { plan.solid_fraction = 0.0; }),
      changed([](PackingPlan& plan) { plan.aspect = 0.0; })};
  findings.expect_exact("rejected values outside their range",
                        static_cast<double>(std::count_if(
                            refused.begin(), refused.end(),
                            [](const std::string& text) { return text.find("; it must be ") != std::string::npos; })),
                        static_cast<double>(refused.size()), "one error each");
  // One disc in a square of the side d sqrt(pi/(4 f)): 1.0005 d, and 0.9995 d.
  const auto alone = [](double side) {
    return refusal(plan_of(1, 0.25 * std::numbers::pi / (side * side), 0.0, false, 1.0));
  };
  findings.expect_true("size limit of a disc in its rectangle",
                       alone(1.0005).empty() && alone(0.9995).find("own image") != std::string::npos,
                       "a rectangle of 1.0005 diameters is accepted, one of 0.9995 rejected");
  findings.expect_true("size limit between walls, along x only",
                       refusal(plan_of(6, 0.5, 0.0, true, 0.01)).find("own image") == std::string::npos,
                       "between walls no disc meets its image along y");
  const std::string full = refusal(plan_of(200, 0.6, 0.0, false, 1.0));
  findings.expect_true("rejection of a packing without room for all discs",
                       full.find("has no room") != std::string::npos,
                       "random sequential adsorption ends at 0.547 (Feder 1980)");
  const std::size_t named = full.find("; disc ");
  findings.expect_between("index of the disc that finds no room",
                          named == std::string::npos ? 0.0 : std::stod(full.substr(named + 7)), 130.0, 200.0,
                          "0.547/0.6 of 200 at most; a little less because the number of trial positions is limited");
  findings.expect_true("rejection of discs that cannot be pushed apart",
                       refusal(plan_of(12, 0.9, 0.2, false, 1.0), &grow).find("still overlap") != std::string::npos,
                       "discs of different size do not reach 0.9");
  Packing one = scatter(plan_of(1, 0.5, 0.0, false, 1.0));
  std::string warm;
  try {
    agitate(one, 3.0, 1);
  } catch (const InputError& error) {
    warm = error.what();
  }
  agitate(one, 0.0, 1);
  findings.expect_true("rejection of a temperature for a single disc",
                       warm.find("fewer than two") != std::string::npos && one.discs.vx[0] == 0.0,
                       "without momentum it is at rest");
}

void run(Findings& findings, const Setup& setup) {
  Table table{.name = "packings",
              .caption = "Packings of the case, with the minimum distance of two centres over the sum of their radii.",
              .columns = {"packing", "discs", "solid fraction", "width x height, diameters", "minimum distance"}};
  {
    const auto group = findings.in("packings");
    for (const Plan& each : plans()) {
      if (setup.needs(each.name)) expect_as_planned(findings, setup, each, table);
    }
    if (setup.needs("small grown")) expect_within(findings);
  }
  findings.table(table);
  {
    const auto group = findings.in("velocities");
    expect_agitated(findings, setup);
  }
  expect_refusals(findings);
}

}  // namespace

Case definition() {
  return {.id = "packing",
          .title = "Random packings of discs",
          .family = "F: many bodies",
          .requirements = {{"F9", {"packings", "velocities"}}},
          .main_checks = {"minimum distance over the sum of radii, grown in a periodic box", "temperature"},
          .source = "Feder 1980 (random sequential adsorption); Lubachevsky & Stillinger 1990 (growing discs)",
          .faults = {{"one_disc_overlaps", "one disc placed on another",
                      "minimum distance over the sum of radii, grown in a periodic box"},
                     {"equal_masses", "temperature computed with equal masses", "temperature"}},
          .run = run};
}

}  // namespace talus::verification::problems::packing
