#include "verification/reference/outlines/rocking_block.hpp"
#include "verification/study/toolkit.hpp"

namespace talus::verification::problems::rocking_block {
namespace {

constexpr double gravity = 9.81, damping_ratio = 3.0;

Scene block_scene(const reference::RockingBlock& block, double tilt, double stiffness, const Setup& setup) {
  SceneBuilder builder{si};
  builder.gravity({0.0, -gravity});
  const double b = block.half_width, h = block.half_height, inertia = (b * b + h * h) / 3.0;
  // The right corner is at the origin, sunk by its overlap under the weight; the block is tilted clockwise.
  const double sine = std::sin(-tilt), cosine = std::cos(tilt);
  const Vec2 corner{cosine * b + sine * h, sine * b - cosine * h};
  const BodyId body = builder.add_free("block", 1.0, setup.has("inertia_about_the_base") ? 2.0 * inertia : inertia,
                                       Rectangle{b, h}, {-corner.x, -corner.y - gravity / stiffness}, -tilt);
  const BodyId plane = builder.add_fixed("plane", HalfPlane{});
  const double dashpot = 2.0 * damping_ratio * std::sqrt(stiffness / (1.0 + b * b / inertia));
  builder.add(Contact{.name = "touch",
                      .a = body,
                      .b = plane,
                      .law = LinearSpringDashpot{stiffness, setup.has("no_dashpot") ? 0.0 : dashpot, EndRule::clamped},
                      .method = ContactMethod::nodes,
                      .friction = CoulombFriction{setup.has("smooth_ground") ? 0.1 : 1e3, stiffness}});
  return builder.at_rest("Rocking block");
}

/// Times at which the block is upright, and the largest tilt between them.
struct Rocked {
  double first{}, second{};  ///< passages of q = 0 [T]
  double tilt{};             ///< largest tilt to the other side [rad]
  std::vector<double> time, angle;
};

Rocked rock(const reference::RockingBlock& block, double tilt, double stiffness, const Setup& setup,
            Findings& findings) {
  const Scene scene = block_scene(block, tilt, stiffness, setup);
  const double step = 0.05 / std::sqrt(stiffness * 5.0);
  Rocked rocked;
  double before = -tilt;
  const Watcher watch = [&](const State& seen, const StepInfo& info) {
    const double now = seen.q[2];
    if ((before < 0.0) != (now < 0.0)) {
      const double at = seen.t - step * now / (now - before);
      (rocked.first == 0.0 ? rocked.first : rocked.second == 0.0 ? rocked.second : before) = at;
    }
    if (rocked.first > 0.0 && rocked.second == 0.0) rocked.tilt = std::max(rocked.tilt, now);
    if (info.step % 200 == 0) rocked.time.push_back(seen.t), rocked.angle.push_back(now);
    before = now;
  };
  const double end = 3.6 * fall_time(block, tilt);
  if (!run_scene(scene, VelocityVerlet{}, {step, end, end, false}, findings, watch).finished)
    rocked.first = std::nan("");
  return rocked;
}

constexpr reference::RockingBlock slender{0.2, 1.0, gravity}, wide{0.5, 1.0, gravity};

double energy_ratio(const reference::RockingBlock& block, double tilt, const Rocked& rocked) {
  return tilt_energy(block, rocked.tilt) / tilt_energy(block, tilt);
}

Figure rocking_figure(const Rocked& one, const Rocked& other) {
  return {.name = "rocking",
          .title = "Rocking from corner to corner",
          .caption =
              "Tilt of a slender (b/h = 0.2) and a wide block (0.5), released at half the critical angle, at which the "
              "block balances on a corner.",
          .x = {.label = "time", .unit = "s"},
          .y = {.label = "angle", .unit = "rad"},
          .series = {{"slender", one.time, one.angle, Style::lines}, {"wide", other.time, other.angle, Style::lines}}};
}

void check_slender(Findings& findings, const Setup& setup, double stiffness, Table& table) {
  const double tilt = 0.5 * block_angle(slender), exact = fall_time(slender, tilt);
  const Rocked rocked = rock(slender, tilt, stiffness, setup, findings);
  const double rate = std::sqrt(2.0 * tilt_energy(slender, tilt) * 0.75) / std::hypot(0.2, 1.0);
  const double late = gravity / stiffness / (2.0 * slender.half_width * rate);
  findings.expect_model({fmt::format("time_of_fall/{:g}", stiffness),
                         fmt::format("time of a fall over that of the rigid block, k = {:g}", stiffness)},
                        rocked.first / exact, 1.0, late / exact,
                        "the corner's overlap, divided by the speed at which the other corner descends");
  const double ratio = energy_ratio(slender, tilt, rocked);
  findings.expect_model({fmt::format("energy_ratio/{:g}", stiffness),
                         fmt::format("energy ratio at a change of corner over Housner's, k = {:g}", stiffness)},
                        ratio / impact_energy_ratio(slender), 1.0, 500.0 / stiffness,
                        "first order in 1/k, its order checked below; the measured constant falls from 640 at k = 1e4 "
                        "to 540 at 8e4 and 410 at 1e6, plus a fifth");
  table.rows.push_back(cells("slender | {:g} | {:.6f} | {:.5f} | {:.5f}", stiffness, rocked.first / exact, ratio,
                             impact_energy_ratio(slender)));
}

void check_limit(Findings& findings, const Setup& setup) {
  const double tilt = 0.5 * block_angle(slender);
  Convergence lacking;
  for (const double stiffness : doublings(1e4, 4)) {
    const Rocked rocked = rock(slender, tilt, stiffness, setup, findings);
    lacking.add(1.0 / stiffness, std::abs(energy_ratio(slender, tilt, rocked) - impact_energy_ratio(slender)));
  }
  findings.expect_order(
      "order of the energy ratio in 1/k", lacking, 0.85, 1.2,
      "while the new corner is hit, the old one carries part of the weight at a height proportional to 1/k");
}

void run(Findings& findings, const Setup& setup) {
  Table table{.name = "blocks",
              .caption =
                  "Time of the first fall over that of the rigid block, and potential energy at the next reversal over "
                  "that at the start, compared with Housner's ratio.",
              .columns = {"block", "k", "time", "energy ratio", "Housner"}};
  check_slender(findings, setup, 1e6, table);
  if (setup.coarse) return;
  check_limit(findings, setup);
  const double tilt = 0.5 * block_angle(wide);
  double softer = 0.0;
  for (const double stiffness : {1e5, 1e6}) {
    const Rocked rocked = rock(wide, tilt, stiffness, setup, findings);
    const double ratio = energy_ratio(wide, tilt, rocked);
    table.rows.push_back({"wide", fmt::format("{:g}", stiffness),
                          fmt::format("{:.6f}", rocked.first / fall_time(wide, tilt)), fmt::format("{:.5f}", ratio),
                          fmt::format("{:.5f}", impact_energy_ratio(wide))});
    if (stiffness < 1e6) {
      softer = ratio;
      continue;
    }
    findings.expect_between("energy ratio at a change of corner over Housner's, wide block",
                            ratio / impact_energy_ratio(wide), 1.03, 1.12,
                            "measured: the undamped friction spring continues to oscillate");
    findings.in("wide_block")
        ->expect("energy ratio of the wide block at k = 1e5 over that at k = 1e6", softer / ratio, 1.0,
                 Tolerance::model(540.0 / 1e5,
                                  "first order in 1/k, with the constant of the slender block at k = 8e4: less than a "
                                  "tenth of what the wide block retains too much"));
    findings.figure(rocking_figure(rock(slender, 0.5 * block_angle(slender), 1e5, setup, findings), rocked));
  }
  findings.table(table);
}

}  // namespace

Case definition() {
  return {.id = "rocking_block",
          .title = "Rocking block (Housner)",
          .requirements = {{"E9",
                            {"time of a fall over that of the rigid block, k = 1e+06",
                             "energy ratio at a change of corner over Housner's, k = 1e+06",
                             "order of the energy ratio in 1/k", "wide_block",
                             "energy ratio at a change of corner over Housner's, wide block"}},
                           {"shape.rectangle",
                            {"energy ratio at a change of corner over Housner's, k = 1e+06",
                             "energy ratio at a change of corner over Housner's, wide block"}},
                           {"method.nodes",
                            {"energy ratio at a change of corner over Housner's, k = 1e+06",
                             "energy ratio at a change of corner over Housner's, wide block"}},
                           {"Eq. 18", {"time of a fall over that of the rigid block, k = 1e+06"}},
                           {"pair.rectangle.half_plane",
                            {"energy ratio at a change of corner over Housner's, k = 1e+06",
                             "energy ratio at a change of corner over Housner's, wide block"}}},
          .main_checks = {"time of a fall over that of the rigid block, k = 1e+06",
                          "energy ratio at a change of corner over Housner's, k = 1e+06",
                          "energy ratio at a change of corner over Housner's, wide block"},
          .source = "Housner 1963, Bull. Seismol. Soc. Am. 53:403",
          .faults = {{"inertia_about_the_base", "twice the moment of inertia",
                      "time of a fall over that of the rigid block, k = 1e+06"},
                     {"smooth_ground", "a coefficient of friction of 0.1",
                      "time of a fall over that of the rigid block, k = 1e+06"},
                     {"no_dashpot", "corners that rebound",
                      "energy ratio at a change of corner over Housner's, k = 1e+06"}},
          .run = run};
}

}  // namespace talus::verification::problems::rocking_block
