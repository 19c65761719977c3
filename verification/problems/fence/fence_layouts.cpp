#include "verification/problems/fence/fence_layouts.hpp"
#include "solver/base/error.hpp"
#include "solver/integrate/linear_segment.hpp"
#include "solver/scenes/fence_scene.hpp"
#include "solver/scenes/fence_summary.hpp"
#include "verification/study/scenes/fence_table.hpp"
#include "verification/study/toolkit.hpp"

namespace talus::verification::problems::fence_layouts {

scenes::Fence fence_of_today() {
  scenes::Fence fence = published_fence("table_2.DAT");
  fence.options = scenes::current_options();
  fence.options.integrator = "velocity_verlet";
  fence.options.tolerance = 0.0;
  return fence;
}

namespace {

using scenes::EvenCentre;
using scenes::FenceSymmetry;

/// Mass of a solid cylinder of half-width a and half-height b [M].
double cylinder_mass(double a, double b, double density) { return 2.0 * std::numbers::pi * a * a * b * density; }
double mass_of_others(const scenes::Fence& fence) {
  return cylinder_mass(fence.column.a, fence.column.b, fence.column.density);
}
double mass_of_unlike() { return cylinder_mass(unlike.a, unlike.b, unlike.density); }
/// Moment of inertia of an upright cylinder over its mass [L^2].
double inertia_of_mass(double a, double b) { return (3.0 * a * a + 4.0 * b * b) / 12.0; }

struct Layout {
  int columns{};
  FenceSymmetry symmetry{};
  EvenCentre centre{EvenCentre::pair};
};

/// Layouts that use every construction option: two layers, dissimilar columns, a bottom cable with anchored ends.
std::vector<scenes::Fence> fences(const Setup& setup) {
  std::vector<scenes::Fence> all;
  for (const Layout layout : {Layout{13, FenceSymmetry::half}, Layout{13, FenceSymmetry::full},
                              Layout{12, FenceSymmetry::half, EvenCentre::doubled}, Layout{12, FenceSymmetry::half},
                              Layout{12, FenceSymmetry::full, EvenCentre::doubled}}) {
    for (const std::vector<int>& numbers : {std::vector<int>{}, {3, 6}, {1}}) {
      scenes::Fence fence = fence_of_today();
      fence.columns = layout.columns, fence.layers = 2;
      fence.options.symmetry = layout.symmetry, fence.options.even_centre = layout.centre;
      fence.options.bottom_end = scenes::BottomEnd::anchored;
      for (const int number : numbers) {
        fence.changed_columns.push_back(unlike);
        fence.changed_columns.back().number = number;
        if (setup.has("denser_columns")) fence.changed_columns.back().density *= 1.0 + 1e-6;
      }
      all.push_back(fence);
    }
  }
  return all;
}

bool is_column(const Body& body) { return body.name.find("column") != std::string::npos; }
bool is_unlike(const scenes::Fence& fence, const Body& body) {
  return std::ranges::any_of(fence.changed_columns, [&](const scenes::ChangedColumn& changed) {
    return body.name.ends_with(fmt::format("column{}", changed.number)) ||
           body.name.ends_with(fmt::format("column-{}", changed.number));
  });
}
bool is_top(const Cable& cable) { return cable.name.find("top") != std::string::npos; }
double stiffness(const Cable& cable) { return std::get<ElasticPlastic>(cable.law).stiffness; }

/// A cable between its ends in space, in a scene at rest.
struct Segment {
  Segment(const Model& model, const Cable& cable) {
    const Vec3 a = reference_point(model, cable.a), b = reference_point(model, cable.b);
    line = {b.x - a.x, b.y - a.y, b.z - a.z}, length = norm(line);
    tension = std::max(0.0, stiffness(cable) * (length - cable.rest_length));
  }
  Vec3 line;         ///< from end A to end B [L]
  double length{};   ///< [L]
  double tension{};  ///< [F]
};

/// Sums of the cable pulls on each body, upwards and along the fence, for one of the columns that it represents [F].
struct Pulls {
  std::vector<double> up, along;
};
Pulls pulls_of(const Model& model) {
  Pulls pulls{std::vector<double>(model.bodies.size(), 0.0), std::vector<double>(model.bodies.size(), 0.0)};
  for (const Cable& cable : model.cables) {
    const Segment segment{model, cable};
    for (const auto& [end, sign] : {std::pair{&cable.a, 1.0}, {&cable.b, -1.0}}) {
      if (!end->body) continue;
      const std::size_t body = index(*end->body);
      const double fraction = static_cast<double>(cable.multiplicity) / model.bodies[body].multiplicity;
      const double pull = sign * fraction * segment.tension / segment.length;
      pulls.up[body] += pull * segment.line.y, pulls.along[body] += pull * segment.line.z;
    }
  }
  return pulls;
}

// ---- equilibrium of fences at rest ----

void check_hanging(Findings& findings, const Setup& setup) {
  double balance = 0.0, sideways = 0.0, horizontal = 0.0, sag = 0.0, span = 0.0, slack = 0.0, mass = 0.0, inertia = 0.0,
         off_plane = 0.0;
  for (const scenes::Fence& fence : fences(setup)) {
    const Model model = scenes::fence_scene(fence).scene.model;
    const double usual = mass_of_others(fence);
    const Pulls pulls = pulls_of(model);
    double masses = 0.0, inertias = 0.0;
    for (std::size_t i = 0; i < model.bodies.size(); ++i) {
      const Body& body = model.bodies[i];
      if (!is_column(body)) continue;
      const bool other = is_unlike(fence, body);
      const double a = other ? unlike.a : fence.column.a, b = other ? unlike.b : fence.column.b;
      masses += static_cast<double>(body.multiplicity) * body.mass / (other ? mass_of_unlike() : usual);
      inertias += static_cast<double>(body.multiplicity) * body.inertia /
                  ((other ? mass_of_unlike() : usual) * inertia_of_mass(a, b));
      keep_worst(off_plane,
                 fence.column.position.x - (body.name.starts_with("back") ? fence.layer_spacing : 0.0) - body.p_WB.x);
      keep_worst(balance, pulls.up[i] / (body.mass * fence.gravity) - 1.0);
      // The half model contains the pull of the other side only as a mirror image.
      if (fence.options.symmetry == FenceSymmetry::full)
        keep_worst(sideways, pulls.along[i] / (body.mass * fence.gravity));
    }
    keep_worst(mass, masses / (fence.layers * fence.columns) - 1.0);
    keep_worst(inertia, inertias / (fence.layers * fence.columns) - 1.0);
    // Moments of weights about an end of half the top cable give, with the sag, the horizontal tension.
    double moment = 0.0;
    for (int i = 0; i < fence.columns; ++i) {
      const double along = std::abs(i - 0.5 * (fence.columns - 1)) * fence.spacing;
      const int number = 1 + static_cast<int>(along / fence.spacing);  // 0 and 0.5 spacings: number 1
      const bool other = std::ranges::count(fence.changed_columns, number, &scenes::ChangedColumn::number) > 0;
      moment += 0.5 * (other ? mass_of_unlike() : usual) * fence.gravity * (0.5 * fence.span - along);
    }
    double lowest = std::numeric_limits<double>::infinity(), highest = -lowest, farthest = 0.0;
    for (const Cable& cable : model.cables) {
      const Segment segment{model, cable};
      if (!is_top(cable)) {
        keep_worst(slack, cable.rest_length - segment.length - fence.slack);
        continue;
      }
      keep_worst(horizontal, segment.tension * std::abs(segment.line.z) / segment.length / (moment / fence.sag) - 1.0);
      for (const CableEnd& end : {cable.a, cable.b}) {
        const Vec3 p = reference_point(model, end);
        lowest = std::min(lowest, p.y), highest = std::max(highest, p.y), keep_largest(farthest, p.z);
      }
    }
    keep_worst(sag, highest - lowest - fence.sag), keep_worst(span, 2.0 * farthest - fence.span);
  }
  const Tolerance by_lengths = Tolerance::round_off(
      5e-11,
      "a tension of 2e4 lb is 9e6 lb/ft times a difference of lengths of 2.5 to 12.5 ft, rounded to 1e-8 lb; relative "
      "to weights of 480 lb, 2e-11, and half as much again for two cables a column");
  findings.expect(
      {"vertical_force", "vertical cable force over weight of the columns, all layouts, worst relative error"}, balance,
      0.0, by_lengths);
  findings.expect("cable force along the fence over weight of the columns, full models, largest", sideways, 0.0,
                  by_lengths);
  findings.expect_round_off(
      {"horizontal_tension", "horizontal tension of each segment against that from moments, worst relative error"},
      horizontal, 0.0, 2.5e-12,
      "as for the vertical force, 1e-8 lb, relative to tensions of 2e4 lb: 5e-13, and five times that for the seven "
      "segments of a half");
  const Tolerance lengths =
      Tolerance::round_off(2.5e-14, "sums of up to seven lengths of 55 ft, each rounded by at most 3.6e-15 ft");
  findings.expect("sag of the top cables, worst error", sag, 0.0, lengths, "ft");
  findings.expect("span of the top cables, worst error", span, 0.0, lengths, "ft");
  findings.expect("slack of the bottom cables, worst error", slack, 0.0, lengths, "ft");
  findings.expect_round_off({"masses", "number of columns from the sum of masses, worst relative error"}, mass, 0.0,
                            1e-14, "sums of up to 26 quotients");
  findings.expect_round_off("number of columns from the sum of moments of inertia, worst relative error", inertia, 0.0,
                            1e-14, "sums of up to 26 quotients");
  findings.expect_exact("distance of the columns of each layer from its plane, largest", off_plane, 0.0,
                        "the same difference of two numbers", "ft");
}

/// Checks that the sag of stretched cables does not depend on the height of the fence.
void check_raised(Findings& findings) {
  constexpr double raised = 100.0;  // [ft]
  const auto made = [](double by) {
    scenes::Fence fence = fence_of_today();
    fence.stretched_cables = {{"top1", 0.004}, {"top2", 0.012}};
    fence.column.position.y += by;
    return scenes::fence_scene(fence).scene.model;
  };
  const Model low = made(0.0), high = made(raised);
  double apart = 0.0;
  for (std::size_t i = 0; i < low.bodies.size(); ++i)
    if (is_column(low.bodies[i])) keep_worst(apart, high.bodies[i].p_WB.y - raised - low.bodies[i].p_WB.y);
  findings.expect_round_off(
      "rise of the columns on stretched cables of a fence raised by 100 ft, worst error", apart, 0.0, 1e-9,
      "Newton's method ends at a residual of 1e-9 of a weight of 480 lb; the stiffness of the segments at one column "
      "is about 2 T/l = 2e4 lb/ft, that of seven in a row a thirtieth of it",
      "ft");
}

/// Checks cables so much longer than the original ones that the columns hang many sags lower. The first guess must be
/// close: Newton's method moves columns by at most a tenth of the sag per iteration, in at most a hundred iterations.
void check_long_cables(Findings& findings) {
  scenes::Fence fence = fence_of_today();
  fence.layers = 2, fence.connections = 1;
  fence.sag = 0.1, fence.limit_top = 1e9;
  for (const char* const layer : {"", "back_"})
    for (int i = 1; i <= 7; ++i)
      fence.stretched_cables.push_back({fmt::format("{}top{}", layer, i), 0.4 + 0.05 * i});
  const Model model = scenes::fence_scene(fence).scene.model;
  const Pulls pulls = pulls_of(model);
  double balance = 0.0, highest = -std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < model.bodies.size(); ++i) {
    if (!is_column(model.bodies[i])) continue;
    keep_worst(balance, pulls.up[i] / (model.bodies[i].mass * fence.gravity) - 1.0);
    if (model.bodies[i].name.ends_with("column1")) highest = std::max(highest, model.bodies[i].p_WB.y);
  }
  findings.expect_round_off(
      "vertical cable force over weight of the columns, cables longer by 4 ft per half, worst relative error", balance,
      0.0, 5e-11, "as for all layouts: the tension of at most 1e4 lb is 9e6 lb/ft times a difference of lengths");
  findings.expect_true("central columns of both layers lower by more than ten sags",
                       highest < fence.column.position.y - 10.0 * fence.sag,
                       "half of a cable is 31 ft long over a half span of 27.5 ft");
}

/// Checks the stiffness of each column along y in the linearization, over its mass, against two segments in space.
void check_linearization(Findings& findings) {
  double worst = 0.0;
  for (const FenceSymmetry symmetry : {FenceSymmetry::half, FenceSymmetry::full}) {
    scenes::Fence fence = fence_of_today();
    fence.options.symmetry = symmetry;
    fence.rocks[0].position.x += 1.0;  // it touches nothing
    const Model model = scenes::fence_scene(fence).scene.model;
    const Dynamics dynamics{model};
    Workspace work = dynamics.workspace();
    State state = rest_state(model);
    dynamics.update(state, work), dynamics.update_modes(state, work);
    LinearSegment piece;
    dynamics.linearization(state, work, piece);
    for (std::size_t i = 0; i < model.bodies.size(); ++i) {
      const Body& body = model.bodies[i];
      if (!is_column(body)) continue;
      double exact = 0.0, found = 0.0;
      for (const Cable& cable : model.cables) {
        if (!is_top(cable)) continue;
        const Segment segment{model, cable};
        const double sine = segment.line.y / segment.length;
        // For the half model's central column the second segment is the mirror image of the first.
        const double both = symmetry == FenceSymmetry::half && body.name == "column1" ? 2.0 : 1.0;
        for (const CableEnd& end : {cable.a, cable.b})
          if (end.body && index(*end.body) == i) exact += both * stiffness(cable) * sine * sine / body.mass;
      }
      const std::size_t y = dynamics.layout().first[i] + 1;
      for (const LinearSegment::Term& term : piece.terms)
        if (term.row == y && term.column == y) found += term.stiffness;
      keep_worst(worst, found / exact - 1.0);
    }
  }
  findings.expect_round_off(
      "cable stiffness at each column in the linearization, half and full models, worst relative error", worst, 0.0,
      1e-9,
      "the slope of the law is a difference quotient over 1e-6 of the elongation, which amplifies a rounding of 1e-16 "
      "to 1e-10");
}

/// Checks the step by the rule of 1993, contacts of columns with the ground, and strengths of cables.
void check_numbers(Findings& findings, const Setup& setup) {
  double step = 0.0, ground = 0.0, strength = 0.0;
  for (scenes::Fence fence : fences(setup)) {
    fence.options.column_ground = scenes::ColumnGround::contact;
    fence.options.strength_top = 1e5, fence.options.strength_bottom = 2e5;
    const scenes::FenceScene made = scenes::fence_scene(fence);
    const Model& model = made.scene.model;
    const double central = model.bodies[index(*find_body(model, "column1"))].mass;
    const double k = stiffness(model.cables[index(*find_cable(model, "top1"))]);
    const double rule = 2.0 * std::numbers::pi * std::sqrt(0.5 * central / k) / 100.0;
    keep_worst(step, made.scene.plan.step / (fence.step_factor * rule) - 1.0);
    const double speed = norm(fence.rocks[0].velocity), overlap = fence.penetration * fence.column.a;
    for (const Body& body : model.bodies) {
      if (!is_column(body)) continue;
      const Contact& contact = model.contacts[index(*find_contact(model, body.name + "-ground"))];
      keep_worst(ground, contact.multiplicity - body.multiplicity);
      keep_worst(ground, contact.nodes[0] - 4.0 * (fence.column.points - 1));
      keep_worst(ground, std::get<LinearSpringDashpot>(contact.law).stiffness /
                                 (2.0 * body.mass * speed * speed / (overlap * overlap)) -
                             1.0);
    }
    for (const Cable& cable : model.cables)
      keep_worst(strength, std::get<ElasticPlastic>(cable.law).strength / (is_top(cable) ? 1e5 : 2e5) - 1.0);
  }
  const Tolerance few = Tolerance::round_off(2e-15, "half a dozen operations");
  findings.expect("step against the given multiple of the step by the rule of 1993, worst relative error", step, 0.0,
                  few);
  findings.expect("contacts of columns with the ground, worst relative error of stiffness and multiplicity", ground,
                  0.0, few);
  findings.expect_exact("strengths of the cables, worst relative error", strength, 0.0, "copied numbers");
}

// ---- hangers, starts, contacts ----

/// Checks that each column hangs by one hanger at its top joint, and that the heaviest one sets the strength required.
void check_hangers(Findings& findings) {
  scenes::Fence fence = fence_of_today();
  fence.changed_columns = {unlike};
  double missing = 0.0;
  for (const FenceSymmetry symmetry : {FenceSymmetry::half, FenceSymmetry::full}) {
    fence.options.symmetry = symmetry, fence.options.hanger_strength = 1e9;
    const scenes::FenceScene made = scenes::fence_scene(fence);
    const Model& model = made.scene.model;
    for (const scenes::FenceMember& member : made.members) {
      if (!member.body || member.layer == 0) continue;
      const Body& body = model.bodies[index(*member.body)];
      const bool right =
          member.hanger && model.hangers[index(*member.hanger)].body == *member.body &&
          model.hangers[index(*member.hanger)].p.y == (is_unlike(fence, body) ? unlike.y_top : fence.y_top);
      missing += right ? 0.0 : 1.0;
    }
    missing += model.hangers.size() == (symmetry == FenceSymmetry::half ? 7 : 13) ? 0.0 : 1.0;
  }
  // With different strengths, and with a single hanger, each column's record has the strength of its hanger.
  double limits = 0.0;
  for (const int columns : {13, 1}) {
    fence.columns = columns, fence.changed_columns.clear();
    scenes::FenceScene made = scenes::fence_scene(fence);
    for (std::size_t i = 0; i < made.scene.model.hangers.size(); ++i)
      made.scene.model.hangers[i].strength = 1e5 * static_cast<double>(i + 1);
    const Dynamics dynamics{made.scene.model};
    const scenes::FenceMonitor watch{fence, made, dynamics};
    double listed = 0.0;
    for (const scenes::ColumnRecord& column : watch.summary().columns)
      for (const Hanger& hanger : made.scene.model.hangers)
        if (hanger.body == column.body) listed += 1.0, keep_worst(limits, column.limit / hanger.strength - 1.0);
    if (listed != columns) limits = std::nan("");
  }
  findings.expect_exact("hanger strength in the record of each column, worst relative error", limits, 0.0,
                        "copied numbers");
  fence = fence_of_today(), fence.changed_columns = {unlike};
  findings.expect_exact("number of columns without a hanger at their top joint", missing, 0.0, "a count");
  fence.options.symmetry = FenceSymmetry::half;
  const auto error = [&](double fraction) -> std::string {
    fence.options.hanger_strength = fraction * mass_of_unlike() * fence.gravity;
    try {
      (void)scenes::fence_scene(fence);
    } catch (const InputError& found) {
      return found.what();
    }
    return "";
  };
  findings.expect_true("hanger strength of 0.999 of the heaviest column's weight: error that names the hanger",
                       error(0.999).find("'hanger3'") != std::string::npos,
                       "the other hangers carry two thirds of that weight");
  findings.expect_true("hanger strength of 1.001 of the heaviest column's weight: no error", error(1.001).empty(),
                       "each hanger carries its column's weight");
}

/// Checks the error for a stretched cable that does not exist, and the reason given for the integrator chosen.
void check_messages(Findings& findings) {
  scenes::Fence fence = fence_of_today();
  fence.stretched_cables = {{"top99", 0.01}};
  std::string message;
  try {
    (void)scenes::fence_scene(fence);
  } catch (const InputError& found) {
    message = found.what();
  }
  fence.stretched_cables.clear();
  fence.options.integrator = automatic_integrator;
  const Scene scene = scenes::fence_scene(fence).scene;
  double named = 0.0;
  for (const Cable& cable : scene.model.cables)
    named += message.find(cable.name) != std::string::npos ? 1.0 : 0.0;
  findings.expect_exact("number of cables listed by the error for an unknown stretched cable", named,
                        static_cast<double>(scene.model.cables.size()), "all cables that may be meant");
  findings.expect_true("name of the unknown cable in the error for it", message.find("top99") != std::string::npos,
                       "an error says what was found");
  findings.expect_true("reason for the integrator chosen for a fence", !scene.integrator_reason.empty(),
                       "the integrator was not given");
}

/// Checks accelerations by constant forces and a moment, in addition to weights and balanced cable forces.
void check_given_forces(Findings& findings, scenes::Fence fence) {
  fence.rocks[0].position.x += 1.0;  // it touches nothing
  fence.rocks[0].force = {120.0, -40.0}, fence.rocks[0].moment = 15.0;
  fence.column.force = {30.0, -20.0};
  const Scene scene = scenes::fence_scene(fence).scene;
  const Dynamics dynamics{scene.model};
  State state = first_state(scene);
  Workspace work = dynamics.workspace();
  Rates rates{state};
  dynamics.evaluate(state, work, rates, false);
  double worst = 0.0;
  for (std::size_t i = 0; i < scene.model.bodies.size(); ++i) {
    const Body& body = scene.model.bodies[i];
    const std::size_t first = dynamics.layout().first[i];
    if (is_column(body)) {
      const double mass = mass_of_others(fence);
      keep_worst(worst, (mass * rates.v[first] - 30.0) / 20.0),
          keep_worst(worst, (mass * rates.v[first + 1] + 20.0) / 20.0);
    } else if (body.name == "rock") {
      const double a = fence.rocks[0].a, mass = 4.0 / 3.0 * std::numbers::pi * a * a * a * fence.rocks[0].density;
      keep_worst(worst, (mass * rates.v[first] - 120.0) / 20.0);
      keep_worst(worst, (mass * (rates.v[first + 1] + fence.gravity) + 40.0) / 20.0);
      keep_worst(worst, (0.4 * mass * a * a * rates.v[first + 2] - 15.0) / 20.0);
    }
  }
  findings.expect_round_off("initial accelerations by given forces and moment, worst error of force or moment over 20",
                            worst, 0.0, 1e-12, "cable forces of 2e4 lb, rounded to 4e-12 lb, sum up to the weight");
}

/// Checks initial velocities of columns, and which columns are awake after three steps.
void check_start(Findings& findings, const Setup& setup) {
  scenes::Fence fence = fence_of_today();
  fence.options.symmetry = FenceSymmetry::full, fence.layers = 2;
  scenes::Fence moving = fence;
  moving.column.velocity = {1.5, -0.25};
  double velocity = 0.0;
  const scenes::FenceScene made = scenes::fence_scene(moving);
  for (std::size_t i = 0; i < made.scene.model.bodies.size(); ++i) {
    if (!is_column(made.scene.model.bodies[i])) continue;
    const Pose at = pose(made.scene.model, made.scene.initial, static_cast<BodyId>(i));
    keep_worst(velocity, norm(at.v_WB - moving.column.velocity)), keep_worst(velocity, at.w_WB);
  }
  findings.expect_exact("initial velocities of the columns, worst error", velocity, 0.0, "copied numbers", "ft/s");
  check_given_forces(findings, fence);
  constexpr int steps = 3;
  const scenes::FenceScene still = scenes::fence_scene(fence);
  const RunEnd run = run_steps(still.scene, VelocityVerlet{}, 1e-5, setup.has("late_look") ? 10 : steps, findings);
  const talus::Layout layout{still.scene.model};
  const auto awake = std::count(run.state.mode.begin() + static_cast<std::ptrdiff_t>(layout.first_sleeper),
                                run.state.mode.end(), Mode{1});
  findings.expect_exact(
      "columns awake after three steps", static_cast<double>(awake), 1.0 + 2.0 * steps,
      "the rock touches the central column; in each step the motion reaches one more column on either side");
}

double dashpot(const Model& model, const std::string& name) {
  return std::get<LinearSpringDashpot>(model.contacts[index(*find_contact(model, name))].law).damping;
}

/// Effective mass of the contact of a rock with a column, at the height of the rock [M].
double felt_mass(const scenes::Fence& fence, const Model& model, const std::string& column) {
  const double a = fence.column.a, b = fence.column.b, mass = mass_of_others(fence);
  const double arm = fence.rocks[0].position.y - model.bodies[index(*find_body(model, column))].p_WB.y;
  const double rock = model.bodies[index(*find_body(model, "rock1"))].mass;
  return 1.0 / (1.0 / rock + 1.0 / mass + arm * arm / (mass * inertia_of_mass(a, b)));
}

/// Checks rocks that hit the third columns of both sides and the central one at the same height.
void check_sides(Findings& findings, const Setup& setup) {
  scenes::Fence fence = fence_of_today();
  fence.options.symmetry = FenceSymmetry::full, fence.options.contact = scenes::FenceContact::nodes;
  fence.layers = 2;
  fence.rocks[0].along = 2.0 * fence.spacing, fence.rocks[0].position.y = 1.7;
  fence.rocks.push_back(fence.rocks[0]);
  fence.rocks[1].along *= -1.0;
  fence.rocks.push_back(fence.rocks[0]);
  fence.rocks[2].along = 0.0;
  if (setup.has("one_rock_higher")) fence.rocks[1].position.y += 0.01;
  const Model model = scenes::fence_scene(fence).scene.model;
  double apart = 0.0;
  for (const char* const column : {"column", "back_column"})
    keep_worst(
        apart,
        dashpot(model, fmt::format("rock2-{}-3", column)) / dashpot(model, fmt::format("rock1-{}3", column)) - 1.0);
  findings.expect_exact(
      {"mirrored_dashpots", "dashpots of two rocks that hit mirrored columns, worst relative difference"}, apart, 0.0,
      "the same numbers on both sides");
  const double ratio = dashpot(model, "rock1-column3") / dashpot(model, "rock3-column1");
  findings.expect_round_off("squared ratio of dashpots over ratio of effective masses, third column to central column",
                            ratio * ratio * felt_mass(fence, model, "column1") / felt_mass(fence, model, "column3"),
                            1.0, 1e-14, "two dozen operations: c = 2 xi sqrt(k m) with the same k and xi");
}

/// Checks that rocks of different size side by side have a contact exactly if they are closer than the sum of their
/// radii, whichever comes first.
void check_rock_pairs(Findings& findings) {
  constexpr double small = 0.5, large = 1.5;  // [ft]
  double wrong = 0.0;
  for (const auto& [first, second] : {std::pair{small, large}, {large, small}}) {
    for (const double apart : {0.95 * (small + large), 1.05 * (small + large)}) {
      scenes::Fence fence = fence_of_today();
      fence.options.symmetry = FenceSymmetry::full;
      fence.rocks.push_back(fence.rocks[0]);
      fence.rocks[0].a = fence.rocks[0].b = first, fence.rocks[1].a = fence.rocks[1].b = second;
      fence.rocks[1].along = apart;
      const bool found = find_contact(scenes::fence_scene(fence).scene.model, "rock1-rock2").has_value();
      wrong += found == (apart < small + large) ? 0.0 : 1.0;
    }
  }
  findings.expect_exact(
      "pairs of rocks of different size side by side with a wrong or no contact", wrong, 0.0,
      "discs in parallel planes can touch exactly if the planes are closer than the sum of the radii");
  scenes::Fence fence = fence_of_today();
  fence.options.symmetry = FenceSymmetry::full, fence.options.contact = scenes::FenceContact::nodes;
  fence.rocks.push_back(fence.rocks[0]);
  fence.rocks[1].position.x += 3.0;
  fence.rocks[0].points = 3, fence.rocks[1].points = 6;
  const Model model = scenes::fence_scene(fence).scene.model;
  const auto nodes = model.contacts[index(*find_contact(model, "rock1-rock2"))].nodes;
  findings.expect_true("nodes of the contact of two rocks with 3 and 6 points a quadrant", nodes == std::array{8, 20},
                       "four quadrants, each with one end of its points");
}

void run(Findings& findings, const Setup& setup) {
  check_hanging(findings, setup);
  check_numbers(findings, setup);
  check_raised(findings);
  check_long_cables(findings);
  check_linearization(findings);
  check_hangers(findings);
  check_messages(findings);
  check_start(findings, setup);
  check_sides(findings, setup);
  check_rock_pairs(findings);
  check_held_elements(findings, setup);
  check_outlines(findings);
  check_reach(findings);
  check_warnings(findings);
  check_positions(findings);
  check_duration(findings);
  check_counts(findings);
  check_ends(findings);
}

}  // namespace

Case definition() {
  return {
      .id = "fence_layouts",
      .title = "Fence layouts",
      .family = "the fence",
      .requirements = {{"Eq. 14", {"horizontal_tension"}}},
      .main_checks = {"vertical_force", "masses", "slack of the bottom cables, worst error", "mirrored_dashpots"},
      .source = "Mustoe & Huttelmaier 1993, sections 2.4, 3.1 and 3.5",
      .faults = {{"denser_columns", "dissimilar columns denser by a millionth", "masses"},
                 {"one_rock_higher", "one of two rocks hits 0.01 ft higher", "mirrored_dashpots"},
                 {"late_look", "columns counted after ten steps instead of three", "columns awake after three steps"},
                 {"gravity_down", "gravity of either sign compared with gravity along -y", "held_elements"}},
      .run = run};
}

}  // namespace talus::verification::problems::fence_layouts
