#include "solver/scenes/fence_scene.hpp"
#include "verification/study/scenes/fence_table.hpp"
#include "verification/study/toolkit.hpp"

namespace talus::verification::problems::fence_equations {
namespace {

using scenes::Fence;
using scenes::FenceScene;

constexpr double gravity = 32.18;  // [ft/s^2]

/// The fence of Table 2 with the rock at a height [ft].
Fence table_2(double height, const Setup& setup) {
  Fence fence = published_fence("table_2.DAT");
  fence.rocks.front().position.y = height;
  if (setup.has("joint_below")) fence.y_top = -fence.y_top;
  return fence;
}

/// Poses, cable forces and accelerations of one state, and the contact forces that follow from them.
struct Resultants {
  Resultants(const FenceScene& made, long steps) {
    const Dynamics dynamics{made.scene.model};
    State state = run_steps(made.scene, made.scene.integrator, made.scene.plan.step, steps).state;
    Workspace work = dynamics.workspace();
    Rates rates{state};
    dynamics.update(state, work);
    dynamics.update_modes(state, work);
    dynamics.rates(state, work, rates, false);
    const auto acceleration = [&](BodyId body, std::size_t axis) {
      return rates.v[dynamics.layout().first[index(body)] + axis];
    };
    const BodyId rock_id = *made.members[1].body, column_id = *made.members[2].body;
    const Body& rock_body = made.scene.model.bodies[index(rock_id)];
    const Body& column_body = made.scene.model.bodies[index(column_id)];
    rock = pose(made.scene.model, state, rock_id);
    column = pose(made.scene.model, state, column_id);
    angle = talus::angle(made.scene.model, state, column_id);
    LawForces forces;
    dynamics.forces(state, work, forces);
    top = pull(made, state, forces, *made.members[2].top, *made.members[3].body, 6.5);
    bottom = pull(made, state, forces, *made.members[2].bottom, *made.members[3].body, -4.0);
    on_rock = rock_body.mass * Vec2{acceleration(rock_id, 0), acceleration(rock_id, 1) + gravity};
    rock_moment = rock_body.inertia * acceleration(rock_id, 2);
    on_column =
        column_body.mass * Vec2{acceleration(column_id, 0), acceleration(column_id, 1) + gravity} - top - bottom;
    column_moment = column_body.inertia * acceleration(column_id, 2);
  }

  Pose rock, column;
  double angle{};                         ///< of the column [rad]
  Vec2 top, bottom;                       ///< pull of both segments at the column (Eqs. 15, 16) [lb]
  Vec2 on_rock, on_column;                ///< contact force: mass times acceleration minus all other forces [lb]
  double rock_moment{}, column_moment{};  ///< inertia times angular acceleration [ft lb]

 private:
  /// Pull by Eqs. 15 and 16: twice the tension times the x and y components of the segment's direction. The joint is
  /// at (0, y) of the column.
  Vec2 pull(const FenceScene& made, const State& state, const LawForces& forces, CableId cable, BodyId next,
            double y) const {
    const Pose other = pose(made.scene.model, state, next);
    const auto joint = [&](const Pose& body) { return body.p_WB + y * Vec2{-body.R_WB.sine, body.R_WB.cosine}; };
    const Vec2 along = joint(other) - joint(column);
    const double length = std::sqrt(along.x * along.x + along.y * along.y + 2.5 * 2.5);
    return (2.0 * forces.tensions[index(cable)] / length) * along;
  }
};

/// Cable terms of Eq. 7, with the distances a and b of the joints. `sign_top`: sign of the first term, -1 as corrected.
double cable_moment(const Resultants& r, double sign_top) {
  constexpr double a = 6.5, b = 4.0;
  const double c = std::cos(r.angle), s = std::sin(r.angle);
  return b * (r.bottom.x * c + r.bottom.y * s) + sign_top * a * (r.top.x * c + r.top.y * s);
}

void check_balance(Findings& findings, const Setup& setup, Table& table) {
  // 0.0004 s after touch only the foremost of the rock's nodes is inside the column.
  const Resultants r{scenes::fence_scene(table_2(1.5, setup)), 200};
  const Vec2 node = r.rock.p_WB + 0.953951 * Vec2{-r.rock.R_WB.cosine, -r.rock.R_WB.sine};
  const Vec2 on_column = setup.has("contact_on_one_body_left_out") ? Vec2{} : r.on_column;
  const double scale = norm(r.on_rock);
  findings.expect_round_off(
      {"contact_forces", "sum of the contact forces on column and rock over one of them (Eqs. 5, 6, 8, 9)"},
      norm(on_column + r.on_rock) / scale, 0.0, 2e-15,
      "masses times accelerations minus weights and cable forces of 2e4 lb, small beside the contact force of 4.2e5 "
      "lb: a dozen roundings, each 1.1e-16 of it, 4e-16 as a random walk; five times that");
  const Vec2 column_arm = node - r.column.p_WB, rock_arm = node - r.rock.p_WB;
  const double actual = r.column_moment - cable_moment(r, -1.0);
  const Vec2 P = r.on_column;
  const double corrected = column_arm.x * P.y - column_arm.y * P.x;
  const double printed = P.x * column_arm.y + P.y * column_arm.x;
  const auto why = Tolerance::round_off(3e-15,
                                        "the arm of 1.5 ft is a difference of positions up to 10 ft, rounded to 9e-16 "
                                        "ft each: 1e-15 of the moment of 6.3e5 ft lb, three times that");
  findings.expect({"contact_moment", "Eq. 7 corrected: moment of the contact force on the column"}, actual, corrected,
                  why.relative(), "ft lb");
  findings.expect_between(
      "Eq. 7 as printed: moment of the contact force over the actual one", printed / actual, -1.01, -0.99,
      "P_x Delta y, nearly the whole moment, has the wrong sign; P_y Delta x is a thousandth of it");
  findings.expect_round_off(
      "Eq. 10: moment of the contact force on the rock", r.rock_moment,
      rock_arm.x * r.on_rock.y - rock_arm.y * r.on_rock.x, 5e-16 * scale,
      "the arm, the height of the node above the rock's centre, is a difference of two heights of 1.5 ft: two "
      "roundings of 1.1e-16 ft, times the contact force; as much again for the products",
      "ft lb");
  const auto text = [](double value) { return fmt::format("{:.1f}", value); };
  table.rows.push_back({"Eqs. 5, 8: x component of the force on the column [lb]", text(r.on_rock.x), text(-r.on_rock.x),
                        text(r.on_column.x)});
  table.rows.push_back(
      {"Eq. 7: moment of the contact force on the column [ft lb]", text(printed), text(corrected), text(actual)});
}

void check_cable_moment(Findings& findings, const Setup& setup, Table& table) {
  // 0.036 s: the rock is clear of the column, the bottom cable is taut.
  const Resultants r{scenes::fence_scene(table_2(0.0, setup)), 18'000};
  const double scale = norm(r.top) + norm(r.bottom);
  findings.expect_between("bottom cable force in the state used for the cable terms of Eq. 7", norm(r.bottom), 1e4, 3e5,
                          "the cable terms are tested with a taut bottom cable", "lb");
  findings.expect_round_off(
      "contact force in the state used for the cable terms of Eq. 7", norm(r.on_column), 0.0, 5e-15 * scale,
      "the rock does not touch the column; joints at up to 10 ft are rounded by 9e-16 ft, 4e-16 of a segment of 2.5 "
      "ft: a dozen such roundings of the cable forces, 1.4e-15 as a random walk, three times that",
      "lb");
  const auto why = Tolerance::round_off(1e-14,
                                        "cable forces rounded to 1.4e-15 as in the previous check, on arms up to 6.5 "
                                        "ft: 2e-15 of the moment, five times that");
  findings.expect({"cable_moment", "Eq. 7 corrected: moment of the cables"}, r.column_moment, cable_moment(r, -1.0),
                  why.relative(), "ft lb");
  const double printed = cable_moment(r, 1.0);
  findings.expect_between(
      {"printed_moment", "Eq. 7 as printed: relative error of the moment of the cables"},
      std::abs(printed / r.column_moment - 1.0), 0.2, 0.4,
      "the term of the top cable has the wrong sign: twice that term is missing, 0.294 of the moment");
  table.rows.push_back(cells("Eq. 7: moment of the cables [ft lb] | {:.1f} | {:.1f} | {:.1f}", printed,
                             cable_moment(r, -1.0), r.column_moment));
}

/// x velocity at 0.01 s of a member: 1 is the rock, 2 the central column [ft/s].
double speed(const FenceScene& made, std::size_t member) {
  const State end = run_steps(made.scene, made.scene.integrator, made.scene.plan.step, 5000).state;
  return end.v[Layout{made.scene.model}.first[index(*made.members[member].body)]];
}

/// Largest eigenvalue of a chain of masses between fixed ends, in k/m.
double chain_eigenvalue(int masses) {
  return 4.0 * std::pow(std::sin(0.5 * std::numbers::pi * masses / (masses + 1)), 2);
}

/// Friction force by Eq. 18 as printed.
double printed_friction(double stiffness, double slip, double limit) {
  return stiffness * std::abs(slip) < limit ? stiffness * slip : limit;
}

/// Checks the signs of Eqs. 5-10: forces and moments of cables and contact on column and rock, from the accelerations
/// of a run, against the equations as printed and as corrected. Faults `contact_on_one_body_left_out`, `joint_below`.
void check_resultants(Findings& findings, const Setup& setup) {
  Table table{.name = "resultants",
              .caption =
                  "Forces and moments on the central column: the report's equations as printed and as corrected, and "
                  "mass times acceleration minus all other forces in a run of Table 2.",
              .columns = {"equation", "as printed", "as corrected", "in the run"}};
  check_balance(findings, setup, table);
  check_cable_moment(findings, setup, table);
  if (!setup.coarse) findings.table(table);
}

/// Checks that Eqs. 12 and 14 have the same stiffness: the fence hangs at rest with the tensions of the static shape.
/// Fault `two_stiffnesses`.
void check_initial_tension(Findings& findings, const Setup& setup) {
  Fence fence = table_2(0.0, setup);
  FenceScene made = scenes::fence_scene(fence);
  Model& model = made.scene.model;
  const CableId first = *made.members[2].top;
  if (setup.has("two_stiffnesses")) std::get<ElasticPlastic>(model.cables[index(first)].law).stiffness *= 0.9;
  const Dynamics dynamics{model};
  State state = rest_state(model);
  Workspace work = dynamics.workspace();
  dynamics.update(state, work);
  dynamics.update_modes(state, work);
  LawForces forces;
  dynamics.forces(state, work, forces);
  // Section 2.4, computed by hand: half the central column's weight W at the slope W/(2 H).
  const double weight = 0.38 * std::numbers::pi * 1.25 * 1.25 * 8.0 * gravity;
  const double horizontal = weight / 5.5 * (2.5 * 18.0 + 12.5 * 6.5);
  findings.expect_round_off({"initial_tension", "initial tension, Eq. 14 with the stiffness of Eq. 12"},
                            forces.tensions[index(first)], horizontal * std::hypot(1.0, 0.5 * weight / horizontal),
                            2e-8,
                            "the tension is the stiffness, 8.6e6 lb/ft, times a difference of lengths of 2.5 ft: a "
                            "dozen roundings of 2.2e-16 ft, 7e-9 lb as a random walk, three times that",
                            "lb");
}

/// Checks which central columns are doubled (section 3.1). Fault `central_column_doubled`.
void check_doubling(Findings& findings, const Setup& setup) {
  Fence fence = table_2(0.0, setup);
  fence.columns = 15;  // N = (15 + 1)/2 = 8: even, with one central column
  FenceScene half = scenes::fence_scene(fence);
  FenceScene doubled = half;
  Body& centre = doubled.scene.model.bodies[index(*doubled.members[2].body)];
  centre.mass *= 2.0, centre.inertia *= 2.0;
  if (setup.has("central_column_doubled")) half = doubled;
  fence.options.symmetry = scenes::FenceSymmetry::full;
  const FenceScene full = scenes::fence_scene(fence);
  const double reference = speed(full, 2);
  findings.expect_exact({"half_15_columns", "15 columns, N = 8: speed of the central column at 0.01 s, half model"},
                        speed(half, 2), reference, "cable forces are summed before contact forces, and T + T is 2 T",
                        "ft/s");
  findings.expect_between(
      "15 columns, N = 8, central column doubled: relative error of the rock's speed against the full model",
      std::abs(speed(doubled, 1) / speed(full, 1) - 1.0), 0.05, 1.0,
      "the rule as printed (double if N is even) doubles a column that is the only one hit");
}

/// Checks the missing sign of Eq. 18, the bound of Eq. 25, and numbers on which the report's text and decks disagree.
void check_texts(Findings& findings) {
  // Eq. 18: when backward slip begins, the printed force jumps from -mu Fn to +mu Fn.
  const double stiffness = 1e4, limit = 50.0;
  const double jump = printed_friction(stiffness, -1.000001 * limit / stiffness, limit) -
                      printed_friction(stiffness, -0.999999 * limit / stiffness, limit);
  findings.expect_model({"slip_jump", "Eq. 18 as printed: jump of the force at the start of backward slip over mu Fn"},
                        jump / limit, 2.0, 2e-6, "evaluated a millionth to either side of the limit");
  findings.expect_between(
      {"eigenvalue_13", "Eq. 25: largest eigenvalue of 13 columns along their cable over 2 k/m of one column"},
      chain_eigenvalue(13) / 2.0, 1.5, 2.0,
      "4 k/m sin^2(13 pi/28): the frequency of one element between fixed neighbours is not an upper bound");
  findings.expect_round_off({"eigenvalue_2", "Eq. 25: eigenvalue of the alternating motion of two columns, m = k = 1"},
                            chain_eigenvalue(2), 3.0, 1e-14,
                            "a squared sine; by hand: the outer spring of each mass contributes k, the middle one 2 k");
  const Fence sample = published_fence("sample2.DAT"), table = published_fence("table_2.DAT");
  findings.expect_model("unit weight of the columns of sample2", sample.column.density * gravity, 24.5, 0.05,
                        "half a unit of the last digit", "lb/ft^3");
  findings.expect_model("unit weight of the columns of Tables 2 and 3", table.column.density * gravity, 12.2, 0.05,
                        "half a unit of the last digit", "lb/ft^3");
  findings.expect_round_off("attachment in sample2: y_top minus half the height", sample.y_top - sample.column.b, 2.67,
                            1e-12, "a difference of two numbers of the deck", "ft");
  findings.expect_exact("number of history variables in sample2 (report: \"max. = 6\")",
                        static_cast<double>(sample.history_codes.size()), 8, "a count");
  // f_penet: with m and k of the ground-rock contact in sample2's listing the overlap is at most f r.
  const double sink = 65.0 * std::sqrt(37.23 / 0.8723e8);
  findings.expect_model(
      "largest overlap of rock and ground over f_penet r", sink / (0.05 * 1.201), 1.0 / std::numbers::sqrt2, 7e-5,
      "k = 2 m v^2/(f r)^2; m and k have four digits, rounded to 1.3e-4 and 0.6e-4 of them, half of which enters 0.7");
}

void run(Findings& findings, const Setup& setup) {
  check_resultants(findings, setup);
  check_initial_tension(findings, setup);
  check_doubling(findings, setup);
  if (!setup.coarse) check_texts(findings);
}

}  // namespace

Case definition() {
  return {.id = "fence_equations",
          .title = "Fence equations, printed and corrected",
          .family = "the fence",
          .requirements = {{"Eq. 2, Eq. 5, Eq. 6", {"contact_forces"}},
                           {"Eq. 7", {"contact_moment", "cable_moment"}},
                           {"Eq. 8", {"contact_forces"}},
                           {"Eq. 10", {"Eq. 10: moment of the contact force on the rock"}},
                           {"Eq. 11, Eq. 12, Eq. 14", {"initial_tension"}},
                           {"Eq. 15, Eq. 16", {"cable_moment", "printed_moment"}},
                           {"Eq. 18", {"slip_jump"}},
                           {"Eq. 25", {"eigenvalue_13", "eigenvalue_2"}},
                           {"law.elastic_plastic", {"initial_tension"}}},
          .main_checks = {"contact_forces", "contact_moment", "cable_moment", "half_15_columns"},
          .source = "Mustoe & Huttelmaier 1993, sections 3.1-3.7, Appendix II",
          .faults = {{"contact_on_one_body_left_out", "no contact force on the column", "contact_forces"},
                     {"joint_below", "top cable joint below the centre of mass", "cable_moment"},
                     {"two_stiffnesses", "Eq. 14 with 0.9 times the stiffness of Eq. 12", "initial_tension"},
                     {"central_column_doubled", "mass of the only central column doubled", "half_15_columns"}},
          .run = run};
}

}  // namespace talus::verification::problems::fence_equations
