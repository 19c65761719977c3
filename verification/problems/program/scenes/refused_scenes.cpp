#include "verification/problems/program/scenes/refused_scenes.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <vector>

#include "verification/study/findings/expectations.hpp"
#include "verification/study/program/program_options.hpp"

namespace talus::verification::problems::scene_fields {
namespace {

const std::string run_table = "[run]\nintegrator = \"velocity_verlet\"\nstep = \"1 us\"\nend = \"10 us\"\n";

/// A column that hangs by a hanger from two cables, whose yield forces may differ.
std::string hung(double left_yield, double right_yield) {
  const auto cable = [](const char* name, double x, double yield) {
    return fmt::format(
        "[[cable]]\nname = \"{}\"\nlaw = \"elastic_plastic\"\nfrom = {{ body = \"column\", point = [\"0 m\", \"1 m\"] "
        "}}\nto = {{ point = [\"{} m\", \"2 m\"] }}\nstiffness = \"1e4 N/m\"\nyield = \"{} N\"\n",
        name, x, yield);
  };
  return "units = \"SI\"\ngravity = [\"0 m/s^2\", \"-10 m/s^2\"]\n[[body]]\nname = \"column\"\nmobility = \"free\"\n"
         "mass = \"2 kg\"\ninertia = \"1 kg m^2\"\nposition = [\"0 m\", \"0 m\"]\n" +
         cable("left", -3.0, left_yield) + cable("right", 3.0, right_yield) +
         "[[hanger]]\nname = \"hook\"\nbody = \"column\"\npoint = [\"0 m\", \"1 m\"]\nstrength = \"1 kN\"\n" +
         run_table;
}

/// An outline on a box, a disc or a plane.
std::string outline(double exponent, const std::string& other) {
  return fmt::format(
      "units = \"SI\"\n[[body]]\nname = \"rock\"\nmobility = \"free\"\nmass = \"2 kg\"\ninertia = \"1 kg "
      "m^2\"\nposition = "
      "[\"0 m\", \"2 m\"]\nshape = {{ kind = \"superquadric\", half_width = \"0.5 m\", half_height = \"0.5 m\", "
      "exponent "
      "= {} }}\n[[body]]\nname = \"other\"\nmobility = \"fixed\"\nposition = [\"0 m\", \"0 m\"]\nshape = {{ {} }}\n"
      "[[contact]]\nname = \"c\"\nbetween = [\"rock\", \"other\"]\nlaw = \"linear_spring_dashpot\"\nstiffness = \"1e4 "
      "N/m\"\ndamping = \"0 N s/m\"\n{}",
      exponent, other, run_table);
}

struct Pair {
  std::string name, accepted, refused, message;
};

}  // namespace

void check_refused(const TemporaryFolder& folder, Findings& findings, const Setup& setup) {
  const std::string box = R"(kind = "rectangle", half_width = "1 m", half_height = "0.5 m")",
                    plane = R"(kind = "half_plane")", disc = R"(kind = "circle", radius = "1 m")";
  const double blunt = setup.has("round_outlines") ? 5.0 : 5.01;
  const std::vector<Pair> pairs{
      {"cables of unlike yield forces at a hanger", hung(500.0, 500.0), hung(500.0, 500.1), "hanger 'hook'"},
      {"cables of unlike yield forces, the weaker one first", hung(500.1, 500.1), hung(500.1, 500.0), "hanger 'hook'"},
      {"a blunt outline on a box", outline(5.0, box), outline(blunt, box), "one resultant has no position"},
      {"a blunt outline on a plane", outline(5.0, plane), outline(blunt, plane), "one resultant has no position"}};
  Differences differ;
  for (const Pair& pair : pairs) {
    folder.write("accepted.toml", pair.accepted), folder.write("refused.toml", pair.refused);
    differ.compare(pair.name + ": accepted", run_talus(folder, {"run", "accepted.toml"}).exit_code, 0);
    differ.ended(pair.name + ": refused", run_talus(folder, {"run", "refused.toml"}), 2, pair.message);
  }
  folder.write("round.toml", outline(20.0, disc));
  differ.compare("a blunt outline on a disc: accepted", run_talus(folder, {"run", "round.toml"}).exit_code, 0);
  differ.expect_none(findings, "scenes on both sides of what is refused: verdicts that differ",
                     "two cables at a hanger become one cable if it breaks, which has one tension; on flat sides one "
                     "resultant of an outline with an exponent above 5 would jump from corner to corner");
}

void check_diverging(const TemporaryFolder& folder, Findings& findings) {
  std::string text = "units = \"SI\"\n";
  for (const auto& [name, speed] : {std::pair{"first", "1"}, std::pair{"second", "1e150"}})
    text += fmt::format(
        "[[body]]\nname = \"{}\"\nmobility = \"particle\"\nmass = \"1 kg\"\nposition = [\"0 m\", \"0 m\"]\n"
        "velocity = [\"0 m/s\", \"{} m/s\"]\n",
        name, speed);
  folder.write("diverging.toml", text +
                                     "[run]\nintegrator = \"velocity_verlet\"\nstep = \"1e160 s\"\nend = \"2e160 s\"\n"
                                     "ledger = \"off\"\nwatch = \"off\"\n");
  const ProgramEnd end = run_talus(folder, {"run", "diverging.toml", "--json"});
  findings.expect_true("run that diverges: exit status, and the coordinate that its summary names",
                       end.exit_code == 3 && end.output.find("'second.y' is not finite") != std::string::npos,
                       "1e150 m/s times 1e160 s is beyond the largest double, 1.8e308");
}

void check_lines(const TemporaryFolder& folder, Findings& findings) {
  constexpr double pin_x = 0.4, pin_y = -0.3, angle = 0.7;
  const std::array mobilities{"pinned", "guided_x", "guided_y"};
  std::string text = "units = \"SI\"\n";
  for (std::size_t i = 0; i < mobilities.size(); ++i) {
    text += fmt::format(
        "[[body]]\nname = \"{0}\"\nmobility = \"{0}\"\nmass = \"1 kg\"\ninertia = \"1 kg m^2\"\npin = [\"{1} m\", "
        "\"{2} "
        "m\"]\nposition = [\"{3} m\", \"1 m\"]\nangle = \"{4} rad\"\n",
        mobilities[i], pin_x, pin_y, 3.0 * static_cast<double>(i), angle);
  }
  folder.write("lines.toml", text + run_table);
  (void)talus_output(folder, {"run", "lines.toml", "--out", "lines"});
  const std::vector<double> points = data_array(geometry_states(folder, "lines", "lines").at(0).text, "Points");
  std::vector<double> exact;
  for (std::size_t i = 0; i < mobilities.size(); ++i) {
    const double x = 3.0 * static_cast<double>(i);
    exact.insert(exact.end(), {x + pin_x * std::cos(angle) - pin_y * std::sin(angle),
                               1.0 + pin_x * std::sin(angle) + pin_y * std::cos(angle), 0.0, x, 1.0, 0.0});
  }
  double worst = points.size() == exact.size() ? 0.0 : std::nan("");
  for (std::size_t i = 0; i < std::min(points.size(), exact.size()); ++i)
    keep_worst(worst, points[i] - exact[i]);
  findings.expect("geometry of bodies without a shape, from the pin to the centre: largest error", worst, 0.0,
                  Tolerance::round_off(5e-15, "a dozen roundings of numbers up to 6"), "m");
}

}  // namespace talus::verification::problems::scene_fields
