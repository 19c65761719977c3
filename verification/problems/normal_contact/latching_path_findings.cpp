#include "verification/problems/normal_contact/latching_path_findings.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

#include "verification/reference/latching_impact.hpp"
#include "verification/study/pressed_disc.hpp"

namespace talus::verification::problems {
void check_latching_path(Findings& findings, const Setup& setup) {
  PressedDisc disc{setup.has("forgets_at_zero_force")};
  const char* exact = "all overlaps, forces and their products are short sums of powers of two";
  disc.press(0.5);
  disc.press(0.4375);
  const double before = disc.work();
  disc.press(0.46875);
  disc.press(0.4375);
  findings.expect("work of a loop on the stiff line", disc.work() - before, 0.0, Tolerance::exact(exact), "J");
  for (const double turn : {0.125, 0.453125, 0.625, 0.015625, 0.5, -0.015625})
    disc.press(turn);
  // Whatever the turns, the largest overlap 5/8 decides: K1 M^2/2 (1 - K1/K2).
  findings.expect("work of the whole path until the surfaces part", disc.work(), 0.5 * 64.0 * 0.390625 * 0.75,
                  Tolerance::exact(exact), "J");
  disc.press(0.25);
  const std::vector<double> lines = reference::latching_forces({64.0, 256.0, 0.0, 1.0, 1.0}, disc.path());
  double largest = 0.0;
  for (std::size_t i = 0; i < lines.size(); ++i)
    largest = std::max(largest, std::abs(disc.forces()[i] - lines[i]));
  findings.expect("force along a prescribed path, largest difference", largest, 0.0, Tolerance::exact(exact), "N");
  if (setup.coarse) return;
  Series solver{"solver", {}, {}, Style::points};
  for (std::size_t i = 0; i < lines.size(); i += 24)
    solver.add(disc.path()[i], disc.forces()[i]);
  findings.figure({.name = "path",
                   .title = "Pressed along a path",
                   .caption = "Overlaps in turn: 1/2, 7/16, 15/32, 7/16, 1/8, 29/64, 5/8, 1/64, 1/2, apart, 1/4. The "
                              "stiff line is taken up again out of slackness; after parting the soft one from zero.",
                   .x = {.label = "overlap", .unit = "m"},
                   .y = {.label = "force", .unit = "N"},
                   .series = {{"reference", disc.path(), lines, Style::lines}, solver}});
}

}  // namespace talus::verification::problems
