/// Scenes with a closed form between events (solver/dynamics/closed_form.hpp), and the integrator chosen for them.
#include <boost/test/unit_test.hpp>
#include <string>

#include "solver/base/error.hpp"
#include "solver/dynamics/closed_form.hpp"
#include "solver/model/model_builder.hpp"
#include "solver/scenes/bouncing_disc.hpp"
#include "solver/scenes/pendulum.hpp"

BOOST_AUTO_TEST_SUITE(closed_form_tests)

using namespace talus;

namespace {

constexpr LinearSpringDashpot spring{1e4, 0.0, EndRule::clamped};

/// Two bodies and one contact between them.
Model pair(const Body& a, const Body& b, const ContactLaw& law = spring) {
  ModelBuilder builder;
  Body first = a, second = b;
  first.name = std::string{"a"}, second.name = std::string{"b"};
  first.mass = first.inertia = second.mass = second.inertia = 1.0;
  if (first.mobility == Mobility::fixed) first.mass = first.inertia = 0.0;
  if (second.mobility == Mobility::fixed) second.mass = second.inertia = 0.0;
  const BodyId id_a = builder.add(first), id_b = builder.add(second);
  builder.add(Contact{.name = "touch", .a = id_a, .b = id_b, .law = law});
  return builder.build();
}

const Body ground{.mobility = Mobility::fixed, .shape = HalfPlane{}};
const Body disc{.mobility = Mobility::free, .shape = Circle{1.0}, .p_WB = {0.0, 2.0}};

std::string obstacle(const Model& model) { return obstacle_to_closed_form(model).value_or("none"); }

}  // namespace

BOOST_AUTO_TEST_CASE(discs_and_bodies_that_do_not_turn_on_planes_have_one) {
  BOOST_TEST(obstacle(pair(disc, ground)) == "none");
  BOOST_TEST(obstacle(pair(ground, disc)) == "none");
  BOOST_TEST(obstacle(pair({.mobility = Mobility::particle, .shape = Rectangle{1.0, 2.0}, .p_WB = {0.0, 3.0}},
                           ground)) == "none");
  BOOST_TEST(obstacle(pair(disc, ground, LatchingSpring{1.0, 4.0, 0.5})) == "none");
  const Body first{.mobility = Mobility::sliding_x, .shape = Circle{1.0}, .p_WB = {-2.0, 1.0}};
  const Body second{.mobility = Mobility::sliding_x, .shape = Circle{1.0}, .p_WB = {2.0, 1.0}};
  BOOST_TEST(obstacle(pair(first, second)) == "none");
}

BOOST_AUTO_TEST_CASE(what_has_none_says_why) {
  BOOST_TEST(obstacle(pair({.mobility = Mobility::free, .shape = Rectangle{1.0, 2.0}, .p_WB = {0.0, 3.0}}, ground)) ==
             "contact 'touch': its normal turns with the motion");
  BOOST_TEST(obstacle(pair(disc, {.mobility = Mobility::free, .shape = Circle{1.0}, .p_WB = {3.0, 0.0}})) ==
             "contact 'touch': its normal turns with the motion");
  const Body first{.mobility = Mobility::sliding_x, .shape = Circle{1.0}, .p_WB = {-2.0, 1.0}};
  const Body beside{.mobility = Mobility::sliding_x, .shape = Circle{1.0}, .p_WB = {2.0, 1.1}};
  BOOST_TEST(obstacle(pair(first, beside)) == "contact 'touch': its normal turns with the motion");
  BOOST_TEST(obstacle(pair(disc, ground, Hertz{1e6, 1.0, 0.0})) == "contact 'touch': the law hertz is not linear");
  BOOST_TEST(
      obstacle(scenes::pendulum({.mass = 1.0, .inertia = 1.0, .arm = 1.0, .gravity = 9.8, .amplitude = 1.0}).model)
          .find("turns about a pin") != std::string::npos);
}

BOOST_AUTO_TEST_CASE(the_choice_is_exact_where_it_can_be) {
  const Model has_one = pair(disc, ground);
  const Model has_none = pair(disc, ground, Hertz{1e6, 1.0, 0.0});
  BOOST_TEST(name(choose_integrator(has_one, "auto").integrator) == "exact");
  BOOST_TEST(choose_integrator(has_one, "auto").why == "all motion between events is linear");
  const IntegratorChoice other = choose_integrator(has_none, "auto", 1e-7);
  BOOST_TEST(name(other.integrator) == "stormer_cowell");
  BOOST_TEST(tolerance(other.integrator) == 1e-7);
  BOOST_TEST(other.why == "contact 'touch': the law hertz is not linear, so that there is no closed form");
  BOOST_TEST(choose_integrator(has_none, "rk4").why.empty());
  const auto message = [&](const Model& model, const char* method, double tolerance) -> std::string {
    try {
      static_cast<void>(choose_integrator(model, method, tolerance));
    } catch (const InputError& error) {
      return error.what();
    }
    return "no error";
  };
  BOOST_TEST(tolerance(choose_integrator(has_none, "auto").integrator) == usual_tolerance);
  BOOST_TEST(tolerance(choose_integrator(has_none, "stormer_cowell").integrator) == usual_tolerance);
  BOOST_TEST(message(has_none, "exact", 0.0) ==
             "integrator 'exact': the motion between events must be linear, but contact 'touch': the law hertz is not "
             "linear");
  BOOST_TEST(message(has_one, "exact", 1e-6) ==
             "integrator 'exact': tolerance is 1e-06; it has no step control, so leave it out");
}

BOOST_AUTO_TEST_SUITE_END()
