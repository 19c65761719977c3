#include <boost/test/unit_test.hpp>
#include <cmath>
#include <numbers>

#include "solver/io/read_scene_file.hpp"
#include "solver/io/scene/read_scene.hpp"
#include "solver/laws/restitution.hpp"
#include "solver/scenes/two_cable.hpp"

BOOST_AUTO_TEST_SUITE(read_scene_tests)

using namespace talus;

namespace {

Scene case_scene(const char* name) { return read_scene(std::filesystem::path{TALUS_CASES} / name); }

const LinearSpringDashpot& law(const Scene& scene) {
  return std::get<LinearSpringDashpot>(scene.model.contacts.front().law);
}

/// c of Eq. 21 (Mustoe & Huttelmaier 1993): 2 ln(1/e) sqrt(k m/(pi^2 + ln(1/e)^2)).
double eq_21(double e, double k, double m) {
  const double l = -std::log(e);
  return 2.0 * l * std::sqrt(k * m / (std::numbers::pi * std::numbers::pi + l * l));
}

}  // namespace

BOOST_AUTO_TEST_CASE(every_case_is_read) {
  for (const char* name :
       {"two_cable.toml", "pivoted_cylinder.toml", "damped_disc.toml", "pendulum.toml", "cable_pendulum.toml"}) {
    const Scene scene = case_scene(name);
    BOOST_TEST(!scene.title.empty());
    BOOST_TEST(scene.plan.step > 0.0);
  }
}

// A file and the scene made in code are the same model: values equal to the bit, because no unit conversion is needed.
BOOST_AUTO_TEST_CASE(two_cable_is_the_scene_in_code) {
  const Scene read = case_scene("two_cable.toml");
  scenes::TwoCable parameters;
  parameters.contact.stiffness = 1e4;
  parameters.radius = 0.1;
  const Scene made = scenes::two_cable(parameters);
  BOOST_REQUIRE(read.model.bodies.size() == made.model.bodies.size());
  for (const Body& body : made.model.bodies) {
    const Body& twin = read.model.bodies[index(find_body(read.model, body.name).value())];
    BOOST_TEST(twin.mass == body.mass);
    BOOST_TEST((twin.mobility == body.mobility));
    BOOST_TEST((twin.shape == body.shape));
    BOOST_TEST((twin.p_WB == body.p_WB));
  }
  for (const Cable& cable : made.model.cables) {
    const Cable& twin = read.model.cables[index(find_cable(read.model, cable.name).value())];
    BOOST_TEST(twin.rest_length == cable.rest_length);
    BOOST_TEST((twin.law == cable.law));
  }
  BOOST_TEST(law(read).damping == eq_21(0.5, 1e4, 2.0 / 3.0), boost::test_tools::tolerance(1e-15));
  BOOST_TEST((law(read).end_rule == EndRule::attractive));
  const BodyId striker = find_body(read.model, "striker").value();
  BOOST_TEST((pose(read.model, read.initial, striker).v_WB == Vec2{2.0, 0.0}));
}

// The damping follows at each impact from the ratio alone, with the formula of the end rule.
BOOST_AUTO_TEST_CASE(restitution_gives_a_damping_ratio) {
  const Scene read = case_scene("pivoted_cylinder.toml");
  BOOST_TEST(law(read).damping == 0.0);
  BOOST_TEST(2.0 * law(read).damping_ratio * 1e3 == eq_21(0.5, 1e6, 1.0), boost::test_tools::tolerance(1e-14));
  BOOST_TEST((law(read).end_rule == EndRule::attractive));
  BOOST_TEST(read.model.bodies[0].mass == 14.92);
  BOOST_TEST(read.model.bodies[0].inertia == 85.42);
  BOOST_TEST(read.model.gravity.y == -exact::standard_gravity / exact::foot_in_m,
             boost::test_tools::tolerance(4.5e-16));
}

BOOST_AUTO_TEST_CASE(restitution_by_eq_21_and_by_nodes_takes_particles) {
  std::string text = R"(title = "t"
units = "US"
[[body]]
name = "a"
mobility = "free"
mass = "37.23 slug"
inertia = "20 slug ft^2"
shape = { kind = "circle", radius = "1 ft" }
position = ["0 ft", "0 ft"]
spin = "34 rad/s"
[[body]]
name = "b"
mobility = "fixed"
shape = { kind = "rectangle", half_width = "15 in", half_height = "4 ft" }
position = ["-1 yd", "0 ft"]
angle = "90 deg"
[[contact]]
name = "c"
between = ["a", "b"]
law = "linear_spring_dashpot"
stiffness = "1 kip/in"
restitution = 0.5
restitution_rule = "eq_21"
method = "nodes"
nodes = 16
[run]
integrator = "odeint_dopri5"
tolerance = 1e-6
step = "1 ms"
end = "1 min"
interval = "10 ms"
ledger = "off"
)";
  const Scene read = read_scene(text, "t.toml");
  BOOST_TEST(law(read).stiffness == 12000.0);
  BOOST_TEST((law(read).end_rule == EndRule::clamped));
  BOOST_TEST(law(read).damping == eq_21(0.5, 12000.0, 37.23), boost::test_tools::tolerance(1e-15));
  BOOST_TEST(read.model.contacts[0].nodes[0] == 16);
  BOOST_TEST((read.model.contacts[0].method == ContactMethod::nodes));
  BOOST_TEST(std::get<Rectangle>(read.model.bodies[1].shape).half_width == 1.25);
  BOOST_TEST(read.model.bodies[1].p_WB.x == -3.0);
  BOOST_TEST(read.model.bodies[1].angle == std::numbers::pi / 2);
  BOOST_TEST(read.initial.v.back() == 34.0);
  BOOST_TEST(read.plan.end == 60.0);
  BOOST_TEST(!read.plan.ledger);
  BOOST_TEST(name(read.integrator) == "odeint_dopri5");
}

BOOST_AUTO_TEST_SUITE_END()
