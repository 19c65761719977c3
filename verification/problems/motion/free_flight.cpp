#include "verification/reference/motion/constant_force.hpp"
#include "verification/study/toolkit.hpp"

namespace talus::verification::problems::free_flight {
namespace {

constexpr double mass = 2.3, inertia = 0.71, moment = 0.37;
constexpr Vec2 gravity{0.31, -9.81}, force{1.7, 0.9};
constexpr long steps = 1000;
constexpr double production_step = 0.00137;

constexpr std::array<reference::ConstantForce, 3> flights{
    reference::ConstantForce{0.3, 4.7, gravity.x + force.x / mass},
    reference::ConstantForce{-0.7, 6.1, gravity.y + force.y / mass},
    reference::ConstantForce{0.2, -3.9, moment / inertia}};

Scene flight_scene(const Setup& setup) {
  SceneBuilder builder{si};
  builder.gravity(setup.has("gravity_a_millionth_off") ? 1.000001 * gravity : gravity);
  const BodyId body = builder.add(Body{.name = "body",
                                       .mass = mass,
                                       .inertia = inertia,
                                       .p_WB = {flights[0].position, flights[1].position},
                                       .angle = flights[2].position,
                                       .force = force,
                                       .moment = setup.has("moment_left_out") ? 0.0 : moment});
  Scene scene = builder.at_rest("Free flight");
  set_velocity(scene.model, scene.initial, body, {flights[0].speed, flights[1].speed}, flights[2].speed);
  return scene;
}

/// Final errors of the three coordinates and of their rates.
struct FlightErrors {
  std::array<double, 3> position{}, speed{};
  double largest{};  ///< largest coordinate or rate, including the angle

  double worst_position() const {
    return worst_of({std::abs(position[0]), std::abs(position[1]), std::abs(position[2])});
  }
  double worst_speed() const { return worst_of({std::abs(speed[0]), std::abs(speed[1]), std::abs(speed[2])}); }
};

FlightErrors fly(const Integrator& method, double step, long count, const Setup& setup, Findings& findings) {
  const Integrator given = setup.has("euler_for_verlet") && name(method) == "velocity_verlet" ? EulerCromer{} : method;
  const RunEnd run = run_steps(flight_scene(setup), given, step, count, findings);
  const double t = step * static_cast<double>(count);
  FlightErrors errors;
  for (std::size_t i = 0; i < flights.size(); ++i) {
    const double position = position_at(flights[i], t), speed = speed_at(flights[i], t);
    errors.position[i] = run.state.q[i] - position;
    errors.speed[i] = run.state.v[i] - speed;
    for (const double of : {position, speed, flights[i].speed})
      keep_largest(errors.largest, of);
  }
  return errors;
}

void check_method(Findings& findings, const Setup& setup, const std::string& method, Table& table) {
  const double tolerance = needs_tolerance(method) ? 1e-10 : 0.0;
  const FlightErrors errors = fly(make_integrator(method, tolerance), production_step, steps, setup, findings);
  const IntegratorTraits& traits = integrator_traits(method);
  const double rounding = static_cast<double>(traits.additions) * steps * 0x1p-53 * errors.largest;
  const auto claim = findings.in("integrator." + method), group = findings.in("errors");
  const std::string reason = "one rounding by u of the largest number for each addition to a coordinate in a step";
  table.rows.push_back(
      cells("{} | {:.1e} | {:.1e} | {:.1e}", method, errors.worst_position(), errors.worst_speed(), rounding));
  findings.expect_round_off(method + ", error of the velocities", errors.worst_speed(), 0.0, rounding, reason);
  if (traits.free_fall_error == 0.0) {
    findings.expect_round_off(method + ", error of the coordinates", errors.worst_position(), 0.0, rounding, reason);
    return;
  }
  for (std::size_t i = 0; i < flights.size(); ++i) {
    const double late = reference::semi_implicit_euler_error(flights[i], production_step, steps);
    const bool early = traits.free_fall_error < 0.0;
    findings.expect_round_off(
        fmt::format("{}, error of {} over {}a h t/2", method, std::array{"x", "y", "the angle"}[i], early ? "-" : ""),
        errors.position[i] / (early ? -late : late), 1.0, rounding / std::abs(late), reason);
  }
}

/// Checks the axes of five bodies at once, some at small angles and some at very large ones, against sine and cosine of
/// the C library.
void check_angles(Findings& findings) {
  SceneBuilder builder{si};
  for (int i = 0; i < 5; ++i)
    builder.add(Body{.name = fmt::format("body{}", i), .mass = 1.0, .inertia = 1.0});
  const Model model = builder.build();
  const Dynamics dynamics{model};
  State state = rest_state(model);
  double worst = 0.0;
  const std::vector<double> angles{0.1, -0.7, 1.5, -30.0, 2e3, 1e5, -3e7, 4e9, 1e12, -6e14, 5e15, 1e17, -1e300, 0.0};
  for (std::size_t first = 0; first < angles.size(); ++first) {
    for (std::size_t i = 0; i < 5; ++i)
      state.q[3 * i + 2] = angles[(first + 3 * i) % angles.size()];
    const Snapshot seen{dynamics, state};
    for (std::size_t i = 0; i < 5; ++i) {
      const Rotation found = seen.geometry().poses[i].R_WB;
      const auto angle = static_cast<long double>(state.q[3 * i + 2]);
      keep_worst(worst, static_cast<double>(static_cast<long double>(found.cosine) - std::cos(angle)));
      keep_worst(worst, static_cast<double>(static_cast<long double>(found.sine) - std::sin(angle)));
    }
  }
  findings.expect_round_off("sine and cosine of bodies at angles of 0 to 1e300 rad, largest error", worst, 0.0, 0x1p-52,
                            "two units in the last place of a number below 1");
}

void draw_steps(Findings& findings, const Setup& setup) {
  Figure figure{.name = "steps",
                .title = "Errors of free flight",
                .caption =
                    "Error of y at t = 1 s against the step: both Euler methods lie on the line $a h t/2$, leapfrog "
                    "and Runge-Kutta at round-off.",
                .x = {.label = "step", .unit = "s", .log = true},
                .y = {.label = "error of y", .unit = "m", .log = true}};
  for (const char* method : {"euler_cromer", "euler", "velocity_verlet", "central_difference", "rk4"}) {
    Series series{method, {}, {}, Style::points};
    for (long count = 10; count <= 10000; count *= 10) {
      const double step = 1.0 / (static_cast<double>(count) + 0.381966);
      const FlightErrors errors = fly(make_integrator(method), step, count, setup, findings);
      series.add(step, std::max(std::abs(errors.position[1]), 1e-17));
    }
    figure.series.push_back(series);
  }
  const double a = std::abs(flights[1].acceleration);
  figure.series.push_back({"a h t/2", {1e-4, 0.1}, {0.5e-4 * a, 0.05 * a}, Style::lines});
  findings.figure(figure);
}

void run(Findings& findings, const Setup& setup) {
  Table table{.name = "methods",
              .caption = "Largest error of a coordinate and of a velocity after 1000 steps, and the round-off bound.",
              .columns = {"method", "coordinates", "velocities", "round-off bound"}};
  for (const std::string& method : integrator_names())
    check_method(findings, setup, method, table);
  if (setup.coarse) return;
  findings.table(table);
  check_angles(findings);
  draw_steps(findings, setup);
}

}  // namespace

Case definition() {
  return {
      .id = "free_flight",
      .title = "Free flight with spin",
      .requirements =
          {{"A1", {"errors"}},
           {"Eq. 2, Eq. 3",
            {"central_difference, error of the coordinates", "lagged_central_difference, error of the coordinates"}},
           {"Eq. 23",
            {"central_difference, error of the velocities", "lagged_central_difference, error of the velocities"}},
           {"Eq. 24",
            {"central_difference, error of the coordinates", "lagged_central_difference, error of the coordinates"}}},
      .main_checks = {"velocity_verlet, error of the coordinates", "euler_cromer, error of y over a h t/2",
                      "rk4, error of the coordinates"},
      .source = "Galilei 1638; Hairer, Lubich & Wanner 2006, section I.1",
      .faults = {{"gravity_a_millionth_off", "gravity is too large by a millionth",
                  "velocity_verlet, error of the velocities"},
                 {"moment_left_out", "the applied moment is omitted", "central_difference, error of the coordinates"},
                 {"euler_for_verlet", "semi-implicit Euler runs under the name of velocity Verlet",
                  "velocity_verlet, error of the coordinates"}},
      .run = run};
}

}  // namespace talus::verification::problems::free_flight
