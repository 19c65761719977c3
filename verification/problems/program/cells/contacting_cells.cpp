#include "verification/problems/program/cells/contacting_cells.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include "verification/study/findings/expectations.hpp"

namespace talus::verification::problems::cell_files {
namespace {

/// Ten discs in two rows, of a diameter each, under a block that falls on them within 0.1 ms [SI].
constexpr std::size_t moving_discs = 10, discs_and_walls = 20;
constexpr double disc_diameter = 1e-3, disc_mass = 7.2e-7, cell_period = 5e-3, step_length = 2e-6;
constexpr double loading = 170.0, unloading = 310.0, growth = 2e5, friction = 0.5, shear_stiffness = 20.0;
constexpr double spring = 170.0, dashpot = 0.01;
constexpr double modulus = 1e6, contact_radius = 2.5e-4, shear_modulus = 1e5;

std::string cell_of(const std::string& law, const std::string& integrator) {
  return fmt::format(R"(units = "SI"
[cell]
diameter = "{} m"
mass = "{} kg"
gravity = "10000 m/s^2"
block_speed = "5 m/s"
block_mass = "2e-5 kg"
rows = 2
columns = 5
wall_discs = 5
seed = 3
{}[run]
integrator = "{}"
step = "{} s"
every = "{} s"
end = "2.8e-4 s"
pictures = "on"
)",
                     disc_diameter, disc_mass, law, integrator, step_length, step_length);
}

using Pair = std::pair<std::size_t, std::size_t>;

/// The discs of a state, and the forces of its contacts as drawn, by the numbers of the discs from zero.
struct Step {
  std::vector<double> points, velocity, spin;
  std::map<Pair, double> forces, multiple;
};

std::vector<Step> run_cell(const TemporaryFolder& folder, const std::string& text) {
  folder.write("contacting.toml", text);
  std::filesystem::remove_all(folder.path() / "contacting");
  (void)talus_output(folder, {"cell", "contacting.toml", "--out", "contacting"});
  std::vector<Step> steps;
  for (const GeometryState& state : geometry_states(folder, "contacting", "cell")) {
    Step step{
        data_array(state.text, "Points"), data_array(state.text, "velocity"), data_array(state.text, "spin"), {}, {}};
    const std::vector<double> id = data_array(state.text, "id"), force = data_array(state.text, "force"),
                              multiple = data_array(state.text, "multiple"),
                              ends = data_array(state.text.substr(state.text.find("<Lines>")), "connectivity");
    const auto disc = [&](double point) {
      return static_cast<std::size_t>(std::abs(id.at(static_cast<std::size_t>(point)))) - 1;
    };
    for (std::size_t line = 0; line < ends.size() / 2; ++line) {
      const Pair pair = std::minmax(disc(ends[2 * line]), disc(ends[2 * line + 1]));
      step.forces[pair] = force.at(discs_and_walls + line), step.multiple[pair] = multiple.at(discs_and_walls + line);
    }
    steps.push_back(std::move(step));
  }
  return steps;
}

/// Two discs: the direction from the first to the second, the nearest image of which counts, and their relative motion.
struct Touch {
  double x{}, y{}, distance{};
  [[nodiscard]] double overlap() const { return disc_diameter - distance; }
};
Touch touch_of(const Step& step, const Pair& pair) {
  const auto [i, j] = pair;
  double x = step.points.at(3 * j) - step.points.at(3 * i);
  x -= cell_period * std::round(x / cell_period);
  const double y = step.points[3 * j + 1] - step.points[3 * i + 1], distance = std::hypot(x, y);
  return {x / distance, y / distance, distance};
}
/// Half way between two steps.
Touch touch_between(const Step& before, const Step& after, const Pair& pair) {
  const Touch a = touch_of(before, pair), b = touch_of(after, pair);
  const double x = 0.5 * (a.x * a.distance + b.x * b.distance), y = 0.5 * (a.y * a.distance + b.y * b.distance),
               distance = std::hypot(x, y);
  return {x / distance, y / distance, distance};
}
double relative(const Step& step, const Pair& pair, double x, double y) {
  const auto [i, j] = pair;
  return (step.velocity.at(3 * j) - step.velocity.at(3 * i)) * x +
         (step.velocity[3 * j + 1] - step.velocity[3 * i + 1]) * y;
}
double approach(const Step& step, const Pair& pair, const Touch& touch) {
  return -relative(step, pair, touch.x, touch.y);
}
/// Speed of the second disc past the first along the normal turned counter-clockwise, where they touch, in the middle
/// of the overlap.
double slip_rate(const Step& step, const Pair& pair, const Touch& touch) {
  return relative(step, pair, -touch.y, touch.x) -
         0.5 * touch.distance * (step.spin.at(pair.first) + step.spin.at(pair.second));
}

/// Calls visit(pair, touch) for all pairs that overlap in a state, of which one is free.
template <class Visit>
void for_each_overlap(const Step& step, Visit&& visit) {
  for (std::size_t i = 0; i < moving_discs; ++i)
    for (std::size_t j = i + 1; j < discs_and_walls; ++j)
      if (const Touch touch = touch_of(step, {i, j}); touch.overlap() > 0.0) visit(Pair{i, j}, touch);
}

/// Errors over the largest force, and the numbers of contacts that were compared in each mode.
struct Errors {
  double forces{}, accelerations{}, largest{};
  int unloading{}, sticking{}, sliding{}, pulling{};
};

/// Compares the drawn force; a contact without force is not drawn.
void compare_force(const Step& step, const Pair& pair, double exact, Errors& errors) {
  const auto drawn = step.forces.find(pair);
  keep_worst(errors.forces, (drawn == step.forces.end() ? 0.0 : drawn->second) - exact);
  errors.largest = std::max(errors.largest, std::abs(exact));
}

/// A contact law and its friction.
struct RoughLaw {
  double (*force)(double overlap, double largest);
  double (*shear_stiffness)(double overlap);
  /// Stretch of the friction spring at the end of a step of constant speeds; overlap: in the middle of the step.
  double (*moved)(double stretch, double slip_rate, double overlap, double rate);
  double onset;  ///< stretch over slip of a contact that begins
};

/// A latching spring K1 d that unloads with K2 + growth K1 d_max, and friction by a spring of constant stiffness.
constexpr RoughLaw latching_law{
    [](double overlap, double largest) {
      const double back = unloading + growth * loading * largest;
      return std::max(0.0, loading * largest - back * (largest - overlap));
    },
    [](double) { return shear_stiffness; },
    [](double stretch, double slip_rate, double, double) { return stretch + step_length * slip_rate; }, 1.0};

/// 8 G a of spheres, and its integral over a step from one overlap to another.
double sphere_stiffness(double overlap) { return 8.0 * shear_modulus * std::sqrt(contact_radius * overlap); }
double stiffness_integral(double from, double to) {
  const double mean = 2.0 / 3.0 * (to + std::sqrt(from * to) + from) / (std::sqrt(to) + std::sqrt(from));
  return 8.0 * shear_modulus * std::sqrt(contact_radius) * mean * step_length;
}
/// Hertz's spring, and friction with Mindlin's stiffness: while the overlap grows, the force grows by the integral of
/// stiffness and slip rate; while it shrinks, the stretch stays but for the slip.
constexpr RoughLaw sphere_law{
    [](double overlap, double) { return 4.0 / 3.0 * modulus * std::sqrt(contact_radius * overlap) * overlap; },
    sphere_stiffness,
    [](double stretch, double slip_rate, double overlap, double rate) {
      const double from = std::max(overlap - 0.5 * step_length * rate, 0.0), to = overlap + 0.5 * step_length * rate;
      if (!(rate > 0.0 && to > 0.0)) return stretch + step_length * slip_rate;
      return (sphere_stiffness(from) * stretch + slip_rate * stiffness_integral(from, to)) / sphere_stiffness(to);
    },
    2.0 / 3.0};

/// Forces by such a law and a slider at mu N; semi-implicit Euler applies the forces of a state to the velocities of
/// the next one.
Errors rough_errors(const std::vector<Step>& steps, const RoughLaw& law) {
  Errors errors;
  struct History {
    double largest{}, stretch{};
    bool pressed{};
  };
  std::map<Pair, History> histories;
  for (std::size_t n = 0; n < steps.size(); ++n) {
    const Step& now = steps[n];
    std::map<Pair, History> next;
    std::array<std::array<double, 3>, discs_and_walls> loads{};  // forces along x and y, and torque
    for_each_overlap(now, [&](const Pair& pair, const Touch& touch) {
      const auto known = histories.find(pair);
      History history = known == histories.end() ? History{} : known->second;
      const double overlap = touch.overlap();
      if (overlap < history.largest) ++errors.unloading;
      history.largest = std::max(history.largest, overlap);
      const double force = law.force(overlap, history.largest);
      compare_force(now, pair, force, errors);
      if (history.pressed) {
        const Touch middle = touch_between(steps[n - 1], now, pair);
        history.stretch =
            law.moved(history.stretch, slip_rate(now, pair, middle), middle.overlap(), approach(now, pair, middle));
      } else if (const double rate = approach(now, pair, touch); force > 0.0) {
        history.stretch = rate > 0.0 ? law.onset * slip_rate(now, pair, touch) * overlap / rate : 0.0;
      }
      const double stiffness = law.shear_stiffness(overlap), limit = friction * force / stiffness;
      if (force > 0.0) ++(std::abs(history.stretch) > limit ? errors.sliding : errors.sticking);
      history.stretch = std::clamp(history.stretch, -limit, limit), history.pressed = force > 0.0;
      const double drag = stiffness * history.stretch;
      const double x = force * touch.x + drag * touch.y, y = force * touch.y - drag * touch.x;
      auto &first = loads.at(pair.first), &second = loads.at(pair.second);
      first[0] -= x, first[1] -= y, second[0] += x, second[1] += y;
      first[2] += 0.5 * touch.distance * drag, second[2] += 0.5 * touch.distance * drag;
      next[pair] = history;
    });
    histories = std::move(next);
    if (n + 1 == steps.size()) break;
    const Step& after = steps[n + 1];
    for (std::size_t i = 0; i < moving_discs; ++i) {
      for (std::size_t k = 0; k < 2; ++k)
        keep_worst(errors.accelerations,
                   disc_mass * (after.velocity.at(3 * i + k) - now.velocity.at(3 * i + k)) / step_length - loads[i][k]);
      // A disc has the inertia m D^2/8; the torque is compared as a force at its rim.
      keep_worst(errors.accelerations,
                 disc_mass * disc_diameter / 4.0 * (after.spin.at(i) - now.spin.at(i)) / step_length -
                     loads[i][2] / (0.5 * disc_diameter));
    }
  }
  errors.forces /= errors.largest, errors.accelerations /= errors.largest;
  return errors;
}

/// Contacts that are drawn as multiple, or not, although another contact of one of their free discs acts not, or does.
/// Wall discs do not count: `decided` is the number of contacts of a wall disc with another one, and of a free disc
/// without.
struct Multiples {
  double wrong{}, decided{};
};
Multiples multiples(const std::vector<Step>& steps) {
  Multiples found;
  for (const Step& step : steps) {
    std::array<int, discs_and_walls> acting{};
    for (const auto& [pair, force] : step.forces)
      ++acting.at(pair.first), ++acting.at(pair.second);
    for (const auto& [pair, drawn] : step.multiple) {
      // The first of a pair is free.
      const bool first = acting[pair.first] > 1, second = acting[pair.second] > 1,
                 both_free = pair.second < moving_discs;
      found.wrong += (drawn != 0.0) == (first || (both_free && second)) ? 0.0 : 1.0;
      found.decided += second && !first && !both_free ? 1.0 : 0.0;
    }
  }
  return found;
}

/// A spring and a dashpot that pull until the discs part; velocity Verlet writes both at the time of the state.
Errors dashpot_errors(const std::vector<Step>& steps) {
  Errors errors;
  for (const Step& step : steps) {
    for_each_overlap(step, [&](const Pair& pair, const Touch& touch) {
      const double force = spring * touch.overlap() + dashpot * approach(step, pair, touch);
      compare_force(step, pair, force, errors);
      errors.pulling += force < 0.0 ? 1 : 0;
    });
  }
  errors.forces /= errors.largest;
  return errors;
}

}  // namespace

void check_contacting_cells(const TemporaryFolder& folder, Findings& findings, const Setup& setup) {
  const auto digits = [](double bound) {
    return Tolerance::round_off(bound,
                                "an overlap is the difference of positions of up to 3 mm, rounded by 2e-19 m eight "
                                "times, times up to 3 kN/m, over a largest force of 13 mN");
  };
  Errors latching, spheres, damped;
  if (setup.needs("latching springs from") || setup.needs("accelerations") || setup.needs("kinds of contacts drawn")) {
    const double more = setup.has("more_growth") ? 1.001 : 1.0;
    const std::vector<Step> steps = run_cell(
        folder, cell_of(fmt::format("stiffness = \"{} N/m\"\nlaw = \"latching_spring\"\n"
                                    "unloading_stiffness = \"{} N/m\"\n"
                                    "growth = \"{} 1/m\"\nfriction = {}\nshear_stiffness = \"{} N/m\"\n",
                                    loading, unloading, growth * more, setup.has("rougher_discs") ? 0.501 : friction,
                                    setup.has("stiffer_shear") ? 20.01 : shear_stiffness),
                        "euler_cromer"));
    latching = rough_errors(steps, latching_law);
    const Multiples kinds = multiples(steps);
    findings.expect("cells whose discs touch: wrong kinds of contacts drawn", kinds.wrong, 0.0,
                    Tolerance::exact("a contact is multiple if one of its free discs has another one"));
    findings.expect_between("cells whose discs touch: kinds of contacts drawn that a wall disc would change",
                            kinds.decided, 1.0, 1000.0, "a wall disc with several free discs that touch nothing else");
    findings.expect("cells whose discs touch: forces of latching springs from positions, largest error",
                    latching.forces, 0.0, digits(4e-13));
    findings.expect("cells whose discs touch: accelerations by normal and friction forces, largest error",
                    latching.accelerations, 0.0,
                    Tolerance::round_off(1e-12,
                                         "those of six contacts of a disc at most, 4e-13 each, which are independent, "
                                         "and of differences of velocities of 5 m/s, 4e-16 m/s times 0.36 kg/s"));
  }
  if (setup.needs("friction of spheres")) {
    spheres = rough_errors(
        run_cell(folder, cell_of(fmt::format("law = \"hertz\"\nmodulus = \"{} Pa\"\nradius = \"{} m\"\n"
                                             "damping = \"0 N s/m\"\nfriction = {}\nshear_law = \"mindlin\"\n"
                                             "shear_modulus = \"{} Pa\"\n",
                                             modulus, contact_radius, friction,
                                             shear_modulus * (setup.has("stiffer_spheres") ? 1.0001 : 1.0)),
                                 "euler_cromer")),
        sphere_law);
    findings.expect("cells whose discs touch: accelerations by Hertz's law and friction of spheres, largest error",
                    spheres.accelerations, 0.0,
                    Tolerance::round_off(1e-12,
                                         "as for latching springs, and positions rounded by 2e-19 m in overlaps of new "
                                         "contacts, whose stiffness grows with the root of the overlap"));
  }
  if (setup.needs("forces of dashpots")) {
    damped = dashpot_errors(run_cell(
        folder, cell_of(fmt::format("stiffness = \"{} N/m\"\nlaw = \"linear_spring_dashpot\"\ndamping = \"{} N s/m\"\n"
                                    "end_rule = \"{}\"\n",
                                    spring, dashpot, setup.has("clamped_discs") ? "clamped" : "attractive"),
                        "velocity_verlet")));
    findings.expect("cells whose discs touch: forces of dashpots from positions and velocities, largest error",
                    damped.forces, 0.0, digits(4e-13));
  }
  if (!setup.needs("in the mode that occurs least")) return;
  findings.expect_between("cells of spheres whose discs touch: contacts in the mode that occurs least",
                          std::min(spheres.sticking, spheres.sliding), 30.0, 1000.0, "contacts that stick and slide");
  findings.expect_between("cells whose discs touch: contacts in the mode that occurs least",
                          std::min({latching.unloading, latching.sticking, latching.sliding, damped.pulling}), 30.0,
                          1000.0, "contacts that unload, stick, slide and pull, each of which needs a field");
}

}  // namespace talus::verification::problems::cell_files
