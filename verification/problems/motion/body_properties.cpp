#include "solver/geometry/mass_properties.hpp"
#include "verification/reference/outlines/solid_moments.hpp"
#include "verification/study/toolkit.hpp"

namespace talus::verification::problems::body_properties {
namespace {

constexpr std::array sizes{std::array{0.953951, 0.953951}, std::array{1.25, 4.0}, std::array{3.1, 1.03},
                           std::array{0.05, 2.0}};
constexpr double density = 5.127408;

/// Tolerance of eight products and sums.
Tolerance few_roundings() {
  return Tolerance::round_off(8.0 * 0x1p-53, "eight operations, each rounded by half a unit in the last place")
      .relative();
}

void check_solid(Findings& findings, const Setup& setup, const char* name, reference::Solid solid,
                 MassProperties (*properties)(double, double, double)) {
  for (const auto& [a, b] : sizes) {
    const double given = setup.has("full_length") ? 2.0 * b : b;
    MassProperties found = properties(a, given, density);
    if (setup.has("sphere_for_ellipsoid")) found.inertia = 0.4 * found.mass * a * a;
    const reference::SolidMoments exact = reference::integrated_moments(solid, a, b);
    const std::string which = fmt::format("{} of half-lengths {:g} and {:g}", name, a, b);
    findings.expect({"mass", "mass, " + which}, found.mass, density * exact.volume, few_roundings(), "kg");
    findings.expect({"moment_of_inertia", "moment of inertia, " + which}, found.inertia, density * exact.polar,
                    few_roundings(), "kg m^2");
  }
}

void check_rectangle(Findings& findings) {
  for (const auto& [a, b] : sizes) {
    std::vector<reference::Point> corners;
    const Shape shape = Rectangle{a, b};
    record_shape(shape);
    for (const Vec2 p : boundary_nodes(shape, 4))
      corners.push_back({p.x, p.y});
    const std::string which = fmt::format("rectangle of half-lengths {:g} and {:g}", a, b);
    const double area = reference::polygon_area(corners);
    const reference::Point centroid = reference::polygon_centroid(corners);
    findings.expect({"area", "area, " + which}, area, 4.0 * a * b, few_roundings(), "m^2");
    findings.expect_exact({"centroid", "largest coordinate of the centroid, " + which},
                          std::max(std::abs(centroid.x), std::abs(centroid.y)), 0.0,
                          "the corners come in pairs of opposite sign and cancel exactly", "m");
    findings.expect({"polar_moment", "polar moment divided by area, " + which},
                    reference::polygon_polar_moment(corners) / area, (a * a + b * b) / 3.0, few_roundings(), "m^2");
  }
}

/// Checks the inertia of a pinned body, obtained from its response to a moment, for 24 arms of the pin.
void check_pin(Findings& findings, const Setup& setup) {
  const double mass = 2.3, inertia = 0.71, moment = 1.7;
  double farthest = 0.0;
  for (int i = 0; i < 24; ++i) {
    const double angle = 0.27 * i, arm = 0.1 * (i + 1);
    SceneBuilder builder{si};
    builder.add(Body{.name = "body",
                     .mobility = Mobility::pinned,
                     .mass = mass,
                     .inertia = inertia,
                     .angle = 0.4 * i,
                     .p_BPin = arm * Vec2{std::cos(angle), std::sin(angle)},
                     .moment = moment});
    const Model model = builder.build();
    const Dynamics dynamics{model};
    Workspace work = dynamics.workspace();
    const State state = rest_state(model);
    Rates rates{state};
    dynamics.update(state, work);
    dynamics.rates(state, work, rates);
    const double expected = inertia + (setup.has("without_steiner") ? 0.0 : mass * arm * arm);
    keep_largest(farthest, moment / rates.v[0] / expected - 1.0);
  }
  findings.expect_round_off(
      {"inertia_about_pin", "inertia about a pin from the response to a moment, largest relative error of 24 pins"},
      farthest, 0.0, 8.0 * 0x1p-53, "eight operations, each rounded by half a unit in the last place");
}

void run(Findings& findings, const Setup& setup) {
  check_solid(findings, setup, "ellipsoid", reference::Solid::ellipsoid, ellipsoid);
  check_solid(findings, setup, "block", reference::Solid::block, block);
  check_solid(findings, setup, "cylinder", reference::Solid::cylinder, cylinder);
  check_rectangle(findings);
  check_pin(findings, setup);
}

}  // namespace

Case definition() {
  return {
      .id = "body_properties",
      .title = "Area, mass and moment of inertia",
      .requirements = {{"A2", {"mass", "moment_of_inertia", "area", "centroid", "polar_moment", "inertia_about_pin"}},
                       {"shape.rectangle", {"area", "centroid", "polar_moment"}}},
      .main_checks = {"moment of inertia, cylinder of half-lengths 1.25 and 4",
                      "moment of inertia, ellipsoid of half-lengths 3.1 and 1.03", "inertia_about_pin"},
      .source = "Mustoe & Huttelmaier 1993, section 2.2",
      .faults = {{"full_length", "the full length is passed as half-length", "mass, block of half-lengths 1.25 and 4"},
                 {"sphere_for_ellipsoid", "the inertia of a sphere is used for all solids",
                  "moment of inertia, ellipsoid of half-lengths 3.1 and 1.03"},
                 {"without_steiner", "the expected inertia omits the parallel-axis term", "inertia_about_pin"}},
      .run = run};
}

}  // namespace talus::verification::problems::body_properties
