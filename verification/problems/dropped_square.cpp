#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "solver/model/model_builder.hpp"
#include "verification/check/case.hpp"
#include "verification/check/convergence.hpp"
#include "verification/problems/moved_scene.hpp"
#include "verification/problems/scene_run.hpp"

namespace talus::verification::problems {

Case dropped_square();

namespace {

constexpr const char* page = R"(
**Problem.** A square falls on its edge, on a corner, and nearly so, on a plane and on another square. Left and
right must be alike; a square that falls flat must not begin to turn; and a fall a hair off the even one should end
almost as that does, which depends on the kind of contact.

```
      ____        /\          /\  tilt 1e-9
     |    |      /  \        /  \
     |____|      \  /        \  /
    ________   ___\/___    ___\/___
```

**Equations.** Mirrored at the vertical the tilt changes sign and with it the path's $x$, the angle and the spin; on a
plane no rounding differs. On its corner the square is in balance: a tilt $\epsilon$ grows while the contact lasts
by a bounded factor, so spin over tilt tends to a constant as $\epsilon\to0$. On its edge it depends on the contact.
Nodes at both corners share the force as long as both are in: spin over tilt is constant, too. One resultant acts at
the lower corner, turns the square until the other is lower, and so changes side every few steps: the corner is a
point where its force jumps, though its energy does not. In the limit of small steps the two sides share the force
as nodes do, but the kicks of either side, $k d s h/I$ each, do not cancel quite: **a fall an atom off the level
spins, whatever its tilt, by an amount that falls about as the step does** (measured: order .77), and only the even
fall, where the force stands in the middle, does not.

**Source.** Symmetry; Housner 1963 for falls on edges.

| symbol | meaning | value |
|:--|:-----------|:--|
| $s$ | half a side | .5 |
| $m$, $I$ | mass, moment of inertia | 1, 1/6 |
| $k$, $v$ | stiffness, speed of the fall | $10^4$, 1 |
| $\epsilon$ | tilt | $10^{-12}$ to $10^{-3}$ |

**What would break it.** A rule that takes the first of two equal corners; a normal chosen by the sign of nought;
corners listed in one sense that round one way.
)";

constexpr double half_side = 0.5, stiffness = 1e4, speed = 1.0, step = 1.0371e-4;

enum class Target { plane, square };

/// A square turned by `angle` that falls on a plane, or on the top of a fixed square; not yet touching.
Scene fall(double angle, Target target, ContactMethod method, double aside, const Setup& setup) {
  ModelBuilder builder{si};
  const double reach = half_side * (std::abs(std::cos(angle)) + std::abs(std::sin(angle)));
  const BodyId square = builder.add(Body{.name = "square",
                                         .mass = 1.0,
                                         .inertia = 1.0 / 6.0,
                                         .shape = Rectangle{half_side, half_side},
                                         .p_WB = {aside, reach + 0.01},
                                         .angle = angle});
  const BodyId below =
      target == Target::plane
          ? builder.add(Body{.name = "plane", .mobility = Mobility::fixed, .shape = HalfPlane{}})
          : builder.add(Body{.name = "block",
                             .mobility = Mobility::fixed,
                             .shape = Rectangle{setup.has("wider_to_the_left") && angle > 0.0 ? 0.2 : 0.75, 0.5},
                             .p_WB = {0.0, -0.5}});
  builder.add(Contact{.name = "touch",
                      .a = square,
                      .b = below,
                      .law = LinearSpringDashpot{stiffness, 0.0, EndRule::clamped},
                      .method = method,
                      .friction = {{0.2, 0.5 * stiffness}}});
  Scene scene{.title = "A square falls", .model = builder.build()};
  scene.initial = rest_state(scene.model);
  set_velocity(scene.model, scene.initial, square, {0.0, -speed}, setup.has("a_little_spin") ? 1e-13 : 0.0);
  return scene;
}

State after(const Scene& scene, Findings& findings) {
  const RunEnd run = run_steps(scene, VelocityVerlet{}, step, 1500);
  findings.count(static_cast<std::uint64_t>(run.evaluations));
  return run.state;
}

const char* name_of(Target target) { return target == Target::plane ? "plane" : "block"; }
const char* name_of(ContactMethod method) { return method == ContactMethod::nodes ? "nodes" : "resultant"; }

/// Left against right, bit for bit, of falls at many angles, corner and edge among them.
void check_mirror(Findings& findings, const Setup& setup) {
  const double corner = 0.25 * std::numbers::pi;
  for (const Target target : {Target::plane, Target::square}) {
    for (const ContactMethod method : {ContactMethod::resultant, ContactMethod::nodes}) {
      double differing = 0.0;
      for (const double angle : {0.0, 1e-9, 1e-4, 0.3, corner - 1e-9, corner, corner + 1e-9, 1.1}) {
        if (setup.coarse && angle != 0.3) continue;
        for (const double aside : {0.0, 0.31, 0.75}) {
          State left = after(fall(angle, target, method, aside, setup), findings);
          const State right = after(fall(-angle, target, method, -aside, setup), findings);
          left.q = {-left.q[0], left.q[1], -left.q[2]};
          left.v = {-left.v[0], left.v[1], -left.v[2]};
          const Difference apart = difference(left, right);
          differing = std::max({differing, apart.place, apart.velocity});
        }
      }
      const bool exact = target == Target::plane && method == ContactMethod::resultant;
      findings.expect(
          fmt::format("difference of left and right, {}, {}", name_of(target), name_of(method)), differing, 0.0,
          exact ? Tolerance::exact("a change of sign rounds nothing, and no side is preferred")
                : Tolerance::round_off(4.0 * std::sqrt(300.0) * 0x1p-53,
                                       "sides cut from one end, and nodes summed in the list's order, round unlike in "
                                       "each of some 300 steps in contact"),
          "m, m/s");
    }
  }
}

/// Falls without a tilt keep their symmetry.
void check_even(Findings& findings, const Setup& setup) {
  for (const Target target : {Target::plane, Target::square}) {
    for (const ContactMethod method : {ContactMethod::resultant, ContactMethod::nodes}) {
      const State end = after(fall(0.0, target, method, 0.0, setup), findings);
      findings.expect(fmt::format("spin of a square that fell flat, {}, {}", name_of(target), name_of(method)),
                      std::abs(end.v[2]) + std::abs(end.v[0]), 0.0,
                      Tolerance::exact("both halves have the same digits, and their moments cancel"), "rad/s");
    }
  }
}

/// Spin over tilt, and the change of the rebound, as the tilt goes to nought.
void check_offsets(Findings& findings, const Setup& setup) {
  const double corner = 0.25 * std::numbers::pi;
  Figure figure{.name = "offsets",
                .title = "Spin after a fall, nearly even",
                .caption =
                    "Spin of the square after its fall on a plane against its tilt from even. On the corner it tends "
                    "to nought with the tilt, and so it does by nodes on the edge; one resultant there leaves a spin "
                    "whatever the tilt.",
                .x = {.label = "tilt", .unit = "rad", .log = true},
                .y = {.label = "spin", .unit = "rad/s", .log = true},
                .series = {}};
  struct Fall {
    const char* name;
    double angle;
    ContactMethod method;
  };
  const Fall falls[] = {{"on a corner, resultant", corner, ContactMethod::resultant},
                        {"on the edge, resultant", 0.0, ContactMethod::resultant},
                        {"on the edge, nodes", 0.0, ContactMethod::nodes}};
  for (const Fall& one : falls) {
    Series series{one.name, {}, {}, Style::linespoints};
    const double even = after(fall(one.angle, Target::plane, one.method, 0.0, setup), findings).v[2];
    for (double tilt = 1e-12; tilt < 2e-3; tilt *= 10.0) {
      const State end = after(fall(one.angle + tilt, Target::plane, one.method, 0.0, setup), findings);
      series.x.push_back(tilt);
      series.y.push_back(std::max(std::abs(end.v[2] - even), 1e-17));
    }
    figure.series.push_back(series);
    if (&one == &falls[1]) continue;
    Convergence spins;
    for (std::size_t i = 1; i < 9; ++i)
      spins.add(series.x[i], series.y[i]);
    findings.expect_order(fmt::format("spin against tilt, {}", one.name), spins, 0.999, 1.0005, "proportional");
  }
  findings.figure(figure);
}

/// The spin that changes of side leave behind: root mean square over 64 steps of nearly the same length.
void check_chatter(Findings& findings, const Setup& setup) {
  Convergence spins;
  Series resultant{"one resultant", {}, {}, Style::linespoints};
  for (const double coarse : {8e-4, 4e-4, 2e-4, 1e-4}) {
    PhaseError spin;
    for (const double phase : golden_phases(fewest_phases)) {
      const double h = coarse * (0.9 + 0.2 * phase);
      const RunEnd run = run_steps(fall(1e-11, Target::plane, ContactMethod::resultant, 0.0, setup), VelocityVerlet{},
                                   h, std::lround(0.06 / h));
      spin.add(run.state.v[2]);
      findings.count(static_cast<std::uint64_t>(run.evaluations));
    }
    spins.add(coarse, spin.rms());
    resultant.x.push_back(coarse);
    resultant.y.push_back(spin.rms());
  }
  findings.expect_order("spin left by changes of the corner, against the step", spins, 0.6, 1.0,
                        "what an alternating sum of kicks, each of a step's length, leaves: no clean order, but it "
                        "falls with the step");
  findings.figure({.name = "chatter",
                   .title = "Spin of a fall 1e-11 rad off the level",
                   .caption = "Root mean square over 64 steps about each; the same by nodes is $10^{-9}$ rad/s.",
                   .x = {.label = "step", .unit = "s", .log = true},
                   .y = {.label = "spin", .unit = "rad/s", .log = true},
                   .series = {resultant},
                   .slopes = {{1.0, 1e-4, 0.0055, "order 1"}}});
}

void run(Findings& findings, const Setup& setup) {
  check_mirror(findings, setup);
  check_even(findings, setup);
  if (setup.coarse) return;
  check_offsets(findings, setup);
  check_chatter(findings, setup);
}

}  // namespace

Case dropped_square() {
  return {
      .id = "dropped_square",
      .title = "A square that falls on edge and corner",
      .requirements = {{"E7", {"left and right", "fell flat", "spin against tilt", "changes of the corner"}},
                       {"shape.rectangle", {"left and right"}},
                       {"shape.half_plane", {"plane"}},
                       {"method.resultant", {"resultant", "changes of the corner"}},
                       {"method.nodes", {"nodes"}},
                       {"Eq. 18", {"left and right"}},
                       {"pair.rectangle.half_plane", {"left and right"}}},
      .main_checks = {"difference of left and right, plane, resultant",
                      "spin of a square that fell flat, block, resultant", "spin against tilt, on a corner, resultant",
                      "spin left by changes of the corner, against the step"},
      .source = "Housner 1963",
      .page = page,
      .faults = {{"wider_to_the_left", "a block of another width when the square leans left",
                  "difference of left and right, block, resultant"},
                 {"a_little_spin", "a spin of 1e-13 at the start",
                  "spin of a square that fell flat, plane, resultant"}},
      .tier = Tier::quick,
      .time_limit = 60.0,
      .run = run};
}

}  // namespace talus::verification::problems
