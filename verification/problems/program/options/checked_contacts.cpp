#include "verification/problems/program/options/checked_contacts.hpp"

#include <fmt/format.h>

#include <cmath>
#include <numbers>
#include <string>
#include <tuple>
#include <utility>

namespace talus::verification::problems::calculation_options {

void check_worst_named(const Program& program, Differences& differ) {
  const auto body = [](const std::string& name, const std::string& mobility, double radius, double x) {
    return fmt::format(
        "[[body]]\nname = \"{}\"\nmobility = \"{}\"\nmass = \"2 kg\"\nposition = [\"{} m\", \"0 m\"]\n"
        "shape = {{ kind = \"circle\", radius = \"{} m\" }}\n",
        name, mobility, x, radius);
  };
  const auto touching = [](const std::string& one, const std::string& other) {
    return fmt::format(
        "[[contact]]\nname = \"{0}-{1}\"\nbetween = [\"{0}\", \"{1}\"]\n"
        "law = \"linear_spring_dashpot\"\nstiffness = \"3 kN/m\"\ndamping = \"0 N s/m\"\n",
        one, other);
  };
  const std::string worse = body("worse", "free", 0.5, 0.0) + "inertia = \"1 kg m^2\"\n",
                    better = body("better", "free", 0.5, 5.0) + "inertia = \"0.75 kg m^2\"\n";
  const std::string deep = body("large1", "particle", 1.0, 0.0) + body("large2", "particle", 1.0, 1.85),
                    shallow = body("small1", "particle", 0.1, 5.0) + body("small2", "particle", 0.1, 5.16);
  const std::string of_deep = touching("large1", "large2"), of_shallow = touching("small1", "small2");
  const std::string small =
      "contact 'small1-small2' overlaps by 0.04 m at the start, 40 % of half the width of its smaller body; 1 more "
      "overlap by more than 1 %";
  struct Order {
    std::string bodies, warning;
  };
  for (const Order& each :
       {Order{worse + better, "body 'worse': its moment of inertia"},
        Order{better + worse, "body 'worse': its moment of inertia"},
        Order{deep + shallow + of_deep + of_shallow, small}, Order{shallow + deep + of_shallow + of_deep, small}}) {
    program.write("worst.toml",
                  "units = \"SI\"\n" + each.bodies + "[run]\nintegrator = \"rk4\"\nstep = \"1 ms\"\nend = \"1 ms\"\n");
    differ.contains("the worse of two named first: " + each.warning,
                    run_talus(program.folder(), {"check", "worst.toml"}).messages, "warning: " + each.warning);
  }
  // Bars that touch stops above their centres, m = 2 kg, and can touch them with an end, 1/m = 1/2 + 0.5^2/0.2 kg^-1.
  // The damped contact lasts longer than the other, and limits the step more: to 2 (sqrt(1 + xi^2) - xi)/w.
  const auto bar = [](const std::string& name, double x, const char* law) {
    return fmt::format(
        "[[body]]\nname = \"{0}\"\nmobility = \"free\"\nmass = \"2 kg\"\ninertia = \"0.2 kg m^2\"\n"
        "position = [\"{1} m\", \"0 m\"]\n"
        "shape = {{ kind = \"rectangle\", half_width = \"0.5 m\", half_height = \"0.1 m\" }}\n"
        "[[body]]\nname = \"{0}_stop\"\nmobility = \"fixed\"\nposition = [\"{1} m\", \"1 m\"]\n"
        "shape = {{ kind = \"circle\", radius = \"0.1 m\" }}\n"
        "[[contact]]\nname = \"{0}\"\nbetween = [\"{0}\", \"{0}_stop\"]\nlaw = \"linear_spring_dashpot\"\n{2}",
        name, x, law);
  };
  const std::string undamped = bar("undamped", 0.0, "stiffness = \"3 kN/m\"\ndamping = \"0 N s/m\"\n"),
                    damped = bar("damped", 5.0,
                                 "stiffness = \"3.4 kN/m\"\ndamping = \"40 N s/m\"\nend_rule = \"attractive\"\n");
  const double lightest = 1.0 / (1.0 / 2.0 + 0.5 * 0.5 / 0.2), frequency = std::sqrt(3400.0 / lightest),
               ratio = 40.0 / (2.0 * lightest * frequency),
               limit = 2.0 * (std::sqrt(1.0 + ratio * ratio) - ratio) / frequency;
  for (const std::string& bodies : {undamped + damped, damped + undamped}) {
    program.write("lighter.toml", "units = \"SI\"\n" + bodies +
                                      "[run]\nintegrator = \"velocity_verlet\"\nstep = \"25 ms\"\n"
                                      "end = \"25 ms\"\n");
    differ.contains("the lighter contact that limits the step most",
                    run_talus(program.folder(), {"check", "lighter.toml"}).messages,
                    fmt::format("warning: contact 'damped' can act with an effective mass of {:.4g} kg, less than at "
                                "the start: the step is then {:.3g} times the linear limit of velocity_verlet",
                                lightest, 0.025 / limit));
  }
  // Two crossed bars, by nodes: no node of either is in the other. The shortest way apart is half of both lengths.
  std::string bars;
  for (const auto& [name, width, height] : {std::tuple{"upright", 0.1, 1.0}, {"level", 0.7, 0.1}})
    bars += fmt::format(
        "[[body]]\nname = \"{}\"\nmobility = \"particle\"\nmass = \"2 kg\"\nposition = [\"0 m\", \"0 m\"]\n"
        "shape = {{ kind = \"rectangle\", half_width = \"{} m\", half_height = \"{} m\" }}\n",
        name, width, height);
  program.write("crossed.toml", "units = \"SI\"\n" + bars + touching("upright", "level") +
                                    "method = \"nodes\"\n[run]\nintegrator = \"rk4\"\nstep = \"1 ms\"\n"
                                    "end = \"1 ms\"\n");
  differ.contains("overlap of crossed bars", run_talus(program.folder(), {"check", "crossed.toml"}).messages,
                  "warning: contact 'upright-level' overlaps by 0.8 m at the start");
  // A square, turned by 45 degrees, with a corner in the side of a post: the side normals of both outlines are needed.
  const std::string post =
      "[[body]]\nname = \"post\"\nmobility = \"fixed\"\nposition = [\"0 m\", \"0 m\"]\n"
      "shape = { kind = \"rectangle\", half_width = \"0.1 m\", half_height = \"1 m\" }\n";
  const std::string square = fmt::format(
      "[[body]]\nname = \"square\"\nmobility = \"free\"\nmass = \"2 kg\"\ninertia = \"0.1 kg m^2\"\n"
      "position = [\"{} m\", \"0.4 m\"]\nangle = \"45 deg\"\n"
      "shape = {{ kind = \"rectangle\", half_width = \"0.3 m\", half_height = \"0.3 m\" }}\n",
      0.1 + 0.3 * std::numbers::sqrt2 - 0.04);
  for (const auto& [one, other] : {std::pair{"post", "square"}, {"square", "post"}}) {
    program.write("corner.toml", "units = \"SI\"\n" + post + square + touching(one, other) +
                                     "method = \"nodes\"\n[run]\nintegrator = \"rk4\"\nstep = \"1 ms\"\n"
                                     "end = \"1 ms\"\n");
    differ.contains(fmt::format("overlap of {} and {}", one, other),
                    run_talus(program.folder(), {"check", "corner.toml"}).messages,
                    fmt::format("warning: contact '{}-{}' overlaps by 0.04 m at the start", one, other));
  }
}

void check_lighter_corners(const Program& program, Differences& differ) {
  constexpr double a = 0.5, b = 0.2, mass = 2.0, inertia = 0.2, stiffness = 3000.0, damping = 20.0, step = 1e-3;
  const auto corner_mass = [&](double x) { return 1.0 / (1.0 / mass + x * x / inertia); };
  // Frequency, damping ratio and duration of a contact whose dashpot may pull.
  struct Corner {
    double frequency{}, ratio{}, time{};
  };
  const auto corner = [&](double of) {
    const double frequency = std::sqrt(stiffness / of), ratio = damping / (2.0 * of * frequency);
    return Corner{frequency, ratio, std::numbers::pi / (frequency * std::sqrt(1.0 - ratio * ratio))};
  };
  const double minimum = corner_mass(a);
  for (const double degrees : {-20.0, 20.0, 80.0, 100.0}) {
    const double angle = degrees * std::numbers::pi / 180.0;
    const double lightest = corner_mass(a * std::abs(std::cos(angle)) + b * std::abs(std::sin(angle)));
    program.write(
        "plate.toml",
        fmt::format("units = \"SI\"\n[[body]]\nname = \"plate\"\nmobility = \"free\"\nmass = \"{} kg\"\n"
                    "inertia = \"{} kg m^2\"\nposition = [\"0 m\", \"1 m\"]\nangle = \"{} deg\"\n"
                    "shape = {{ kind = \"rectangle\", half_width = \"{} m\", half_height = \"{} m\" }}\n"
                    "[[body]]\nname = \"plane\"\nmobility = \"fixed\"\nposition = [\"0 m\", \"0 m\"]\n"
                    "shape = {{ kind = \"half_plane\" }}\n[[contact]]\nname = \"touch\"\n"
                    "between = [\"plate\", \"plane\"]\nlaw = \"linear_spring_dashpot\"\nstiffness = \"{} N/m\"\n"
                    "damping = \"{} N s/m\"\nend_rule = \"attractive\"\n[run]\nintegrator = \"rk4\"\n"
                    "step = \"{} s\"\nend = \"1 ms\"\n",
                    mass, inertia, degrees, a, b, stiffness, damping, step) +
            // A contact that always acts with the mass of its disc, which is less than that of any corner.
            "[[body]]\nname = \"disc\"\nmobility = \"particle\"\nmass = \"0.1 kg\"\nposition = [\"3 m\", \"1 m\"]\n"
            "shape = { kind = \"circle\", radius = \"0.5 m\" }\n[[contact]]\nname = \"light\"\n"
            "between = [\"disc\", \"plane\"]\nlaw = \"linear_spring_dashpot\"\nstiffness = \"3 kN/m\"\n"
            "damping = \"0 N s/m\"\n");
    const std::string printed = squeezed(program.run({"check", "plate.toml"}));
    const Corner now = corner(lightest), worst = corner(minimum);
    differ.contains("check: the lightest corner at the start", printed,
                    fmt::format(" {:g} {:g} {:.5g} {:.5g} {:.4g} {:.5g} {:.5g}\n", stiffness, damping, lightest,
                                now.frequency, now.ratio, now.time, now.time / step));
    differ.compare(fmt::format("check: a corner that can be lighter than at {} deg", degrees),
                   printed.find(fmt::format("\n touch {:.5g} {:g} {:.5g} {:.5g} {:.5g}\n", minimum, mass,
                                            worst.frequency, worst.time, worst.time / step)) != std::string::npos,
                   minimum < 0.99 * lightest);
    differ.compare("check: a disc whose contact cannot become lighter",
                   printed.find(" light 0.1 0.1") != std::string::npos, false);
  }
}

}  // namespace talus::verification::problems::calculation_options
