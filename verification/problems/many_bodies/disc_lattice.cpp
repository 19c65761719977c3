#include <random>

#include "solver/granular/disc_method.hpp"
#include "solver/granular/disc_system.hpp"
#include "solver/laws/linear_spring_dashpot.hpp"
#include "verification/study/toolkit.hpp"

namespace talus::verification::problems::disc_lattice {
namespace {

constexpr int rows = 8, columns = 8;
constexpr double overlap = 1e-4, first = 1e-11;

struct Lattice {
  DiscShapes shapes;
  Discs discs;
  PeriodicBox box;
};

Lattice lattice() {
  Lattice made;
  const double spacing = 1.0 - overlap, height = std::sqrt(0.75) * spacing;
  made.box = {.width = columns * spacing, .height = rows * height};
  for (int r = 0; r < rows; ++r) {
    for (int c = 0; c < columns; ++c) {
      made.shapes.add(0.5, 1.0);
      made.discs.add((c + 0.5 * (r % 2) + 0.25) * spacing - 0.5 * made.box.width,
                     (r + 0.5) * height - 0.5 * made.box.height, 0.0, 0.0);
    }
  }
  return made;
}

struct Grown {
  double rate{};     ///< growth of the amplitude: logarithm per step
  double maximum{};  ///< largest amplitude over the initial one
  Series amplitude;
};

Grown grow(const std::string& integrator, double ratio, int steps, const Setup& setup, Findings& findings) {
  const Lattice start = lattice();
  const double stiffness = setup.has("springs_softer") ? 0.97 : 1.0;
  DiscSystem system{start.shapes, start.box, LinearSpringDashpot{stiffness, 0.0, EndRule::attractive}, 0.2};
  Discs discs = start.discs;
  std::mt19937_64 random{5};
  for (std::size_t i = 0; i < discs.size(); ++i) {
    for (double* coordinate : {&discs.x[i], &discs.y[i]})
      *coordinate += first * (std::ldexp(static_cast<double>(random() >> 11), -52) - 1.0);
  }
  const double h = ratio * (setup.has("limit_of_a_pair") ? std::sqrt(2.0) : std::sqrt(2.0 / 3.0));
  Grown grown;
  grown.amplitude = {.label = fmt::format("{} of the limit", ratio), .style = Style::lines};
  std::visit(
      [&](auto method) {
        system.begin(discs);
        method.start(system, discs, h);
        for (int n = 1; n <= steps; ++n) {
          method.step(system, discs, h);
          double squares = 0.0;
          for (std::size_t i = 0; i < discs.size(); ++i) {
            const double dx = discs.x[i] - start.discs.x[i], dy = discs.y[i] - start.discs.y[i];
            const double x = dx - start.box.width * std::round(dx / start.box.width);
            const double y = dy - start.box.height * std::round(dy / start.box.height);
            squares += x * x + y * y;
          }
          const double amplitude = std::sqrt(squares / static_cast<double>(discs.size()));
          grown.amplitude.add(n, amplitude);
          grown.maximum = std::max(grown.maximum, amplitude / first);
          if (amplitude > 0.1 * overlap) break;
        }
      },
      make_disc_method(integrator));
  findings.count(system.evaluations());
  const std::vector<double>& y = grown.amplitude.y;
  const std::size_t last = y.size() - 1, middle = y.size() / 2;
  grown.rate = std::log(y[last] / y[middle]) / static_cast<double>(last - middle);
  return grown;
}

void run(Findings& findings, const Setup& setup) {
  Figure figure{.name = "growth",
                .title = "Displacements of a lattice near its stability limit",
                .caption =
                    "Root mean square displacement over a diameter, velocity Verlet. At x = 1.01 and 1.02 of the limit "
                    "it grows by the factor e^{2 arcosh x} per step.",
                .x = {"step", "1"},
                .y = {.label = "displacement over d", .log = true, .min = 1e-12, .max = 1e-4}};
  for (const char* integrator : {"velocity_verlet", "euler_cromer", "central_difference"}) {
    for (const double ratio : {0.99, 1.01, 1.02}) {
      const Grown grown = grow(integrator, ratio, ratio < 1.0 ? (setup.coarse ? 400 : 4000) : 400, setup, findings);
      const std::string name = fmt::format("{}, step {} of the limit", integrator, ratio);
      if (ratio < 1.0) {
        findings.expect_between("largest displacement over the initial one, " + name, grown.maximum, 0.1, 30.0,
                                "oscillations near the limit exceed the initial displacement by the factor 1/sqrt(1 - "
                                "0.99^2) = 7 at most for each mode, and 128 modes are superposed");
      } else {
        const double exact = 2.0 * std::acosh(ratio);
        findings.expect(
            {"growth", "growth per step, " + name}, grown.rate, exact,
            Tolerance::model(ratio > 1.015 ? 0.002 : 0.005,
                             "the overlap changes w by 5e-5, a quarter of a percent of the growth rate at 1.01; the "
                             "other modes become small in comparison but still contribute at half the run")
                .relative());
      }
      if (std::string{integrator} == "velocity_verlet") {
        Series series = grown.amplitude;
        if (series.x.size() > 120) series.x.resize(120), series.y.resize(120);
        figure.series.push_back(std::move(series));
      }
    }
  }
  findings.figure(std::move(figure));
}

}  // namespace

Case definition() {
  return {.id = "disc_lattice",
          .title = "Lattice of discs: stability limit of the step",
          .requirements = {{"F2", {"growth"}}},
          .main_checks = {"growth per step, velocity_verlet, step 1.01 of the limit",
                          "growth per step, euler_cromer, step 1.02 of the limit",
                          "largest displacement over the initial one, velocity_verlet, step 0.99 of the limit"},
          .source = "lattice dynamics, derived here",
          .faults = {{"springs_softer", "stiffness 3 % smaller",
                      "growth per step, velocity_verlet, step 1.01 of the limit"},
                     {"limit_of_a_pair", "steps relative to the limit of two discs",
                      "largest displacement over the initial one, velocity_verlet, step 0.99 of the limit"}},
          .run = run};
}

}  // namespace talus::verification::problems::disc_lattice
