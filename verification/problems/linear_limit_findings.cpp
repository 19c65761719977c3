#include "verification/problems/linear_limit_findings.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <string_view>
#include <vector>

#include "solver/calibrate/step_advice.hpp"
#include "verification/problems/squeezed_disc.hpp"

namespace talus::verification::problems {

void check_linear_limit(Findings& findings, const Setup& setup) {
  const double longer = setup.has("step_too_long") ? 1.03 : 1.0;
  const std::string round_off =
      "depths are rounded to 1.1e-16, which moves a state by w h (1 + w h) times that, 6.5e-16, against a distance "
      "from rest of 1e-7 that grows by the factor e^g a step: 6.5e-9 (1 + e^-g + ...) = 6.5e-9/g in all, over 11.5/g "
      "steps";
  Figure figure{.name = "stability",
                .title = "Both sides of the linear limit",
                .caption =
                    "ln of the growth per step of a disc squeezed between two planes, against the step over its "
                    "limit $2 (\\sqrt{1 + \\xi^2} - \\xi)$. Below it the motion dies at half the logarithm of the "
                    "determinant (complex pair) or as the larger root; above it, it grows as the matrix says.",
                .x = {"step over limit", "1"},
                .y = {"ln growth per step", "1"},
                .series = {},
                .slopes = {},
                .lines = {{'x', 1.0, "limit"}}};
  for (const double xi : {0.1, 0.0}) {
    const SqueezedDisc disc{.frequency = 100.0, .damping_ratio = xi};
    Series theory{.label = fmt::format("matrix, xi = {:g}", xi), .x = {}, .y = {}, .style = Style::lines};
    for (double share = 0.97; share < 1.0301; share += 0.0005) {
      theory.x.push_back(share);
      theory.y.push_back(leapfrog_growth(xi, share * leapfrog_limit(xi)));
    }
    figure.series.push_back(theory);
    for (const char* method : {"velocity_verlet", "central_difference"}) {
      if (setup.coarse && (xi == 0.0 || method != std::string_view{"velocity_verlet"})) continue;
      Series solver{.label = fmt::format("{}, xi = {:g}", method, xi),
                    .x = {},
                    .y = {},
                    .style = method == std::string_view{"velocity_verlet"} ? Style::points : Style::crosses};
      for (const double share : {0.98, 0.999, 1.001, 1.02}) {
        const double eta = share * leapfrog_limit(xi);
        const double step = longer * eta / disc.frequency;
        const std::string where = fmt::format("squeezed disc, xi = {:g}, {}, {:g} of the limit: ", xi, method, share);
        if (share > 1.0) {
          solver.x.push_back(share);
          solver.y.push_back(growth_per_step(disc, make_integrator(method), step));
          findings.expect(where + "ln growth per step", solver.y.back(), leapfrog_growth(xi, eta),
                          Tolerance::round_off(6e-10, round_off));
          continue;
        }
        const AreaChange area_change = area_change_per_step(disc, make_integrator(method), step);
        findings.expect(where + "ln determinant per step", area_change.logarithm, std::log(1.0 - 2.0 * xi * eta),
                        Tolerance::round_off(
                            area_change.rounding,
                            "depths are rounded to 5.5e-17; the kicks this gives in 10 steps, six standard deviations, "
                            "are summed in quadrature against the area of each step's two states"));
        const std::vector<double> all = distances(disc, make_integrator(method), step, 20000);
        const bool real_pair = leapfrog_growth(xi, eta) > 0.5 * std::log(1.0 - 2.0 * xi * eta) + 1e-3;
        solver.x.push_back(share);
        solver.y.push_back(0.5 * area_change.logarithm);
        if (real_pair) {
          solver.y.back() = std::log(all[400] / all[100]) / 300.0;
          findings.expect(where + "ln decay per step", solver.y.back(), leapfrog_growth(xi, eta),
                          Tolerance::round_off(1e-9,
                                               "round-off of the depth, 1e-16 of the radius a step, against 2e-7: "
                                               "5e-10, gathered over the 50 steps of the decay, in 300 steps"));
        }
        const double early = *std::max_element(all.begin(), all.begin() + 10000);
        const double late = *std::max_element(all.begin() + 10000, all.end());
        findings.expect_true(where + "no growth in 20000 steps", late <= early * (1.0 + 1e-6),
                             "the largest distance from rest in the second half of the run is not above that in the "
                             "first; a growth of 1e-10 a step would show");
      }
      figure.series.push_back(solver);
    }
  }
  if (setup.coarse) return;
  double deviation = 0.0;
  for (const double xi : {0.0, 0.1, 0.2, 0.4, 1.0, 2.0}) {
    const double advised = linear_limit("velocity_verlet", xi).value_or(std::nan(""));
    deviation = std::max(deviation, std::abs(advised - leapfrog_limit(xi)));
  }
  findings.expect("step advice: linear limit of velocity_verlet", deviation, 0.0,
                  Tolerance::round_off(
                      1.8e-15, "two evaluations of 2 (sqrt(1 + xi^2) - xi): 2 half units of a number below 4 each"));
  findings.figure(figure);
}

}  // namespace talus::verification::problems
