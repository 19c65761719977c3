#include "solver/model/model_builder.hpp"

#include <boost/test/unit_test.hpp>
#include <cmath>
#include <limits>
#include <string>

#include "solver/base/error.hpp"
#include "solver/model/layout.hpp"

BOOST_AUTO_TEST_SUITE(model_builder_tests)

using namespace talus;

namespace {

Body rock(std::string name = "rock") {
  return {.name = std::move(name), .mass = 2.0, .inertia = 1.0, .shape = Circle{1.0}};
}

/// Checks that an InputError with exactly this message is thrown.
template <class Act>
void refuses(Act&& act, const std::string& expected) {
  try {
    act();
  } catch (const InputError& error) {
    BOOST_TEST(error.what() == expected);
    return;
  }
  BOOST_ERROR("accepted, but expected: " << expected);
}

}  // namespace

BOOST_AUTO_TEST_CASE(wrong_bodies_are_refused) {
  ModelBuilder builder;
  builder.add(rock());
  refuses([&] { builder.add(rock()); }, "body 'rock' exists already; names must differ");
  refuses([&] { builder.add(rock("")); }, "a body has no name; each requires a unique one");
  Body light = rock("light");
  light.mass = -3.0;
  refuses([&] { builder.add(light); }, "body 'light': mass is -3; it must be > 0");
  Body loose = rock("loose");
  loose.inertia = 0.0;
  refuses([&] { builder.add(loose); }, "body 'loose': inertia is 0; it must be > 0");
  Body flat = rock("flat");
  flat.shape = Rectangle{1.0, 0.0};
  refuses([&] { builder.add(flat); }, "body 'flat': half_height is 0; it must be > 0");
  Body nowhere = rock("nowhere");
  nowhere.p_WB.x = std::numeric_limits<double>::quiet_NaN();
  refuses([&] { builder.add(nowhere); }, "body 'nowhere': position is nan; it must be finite");
  Body plane = rock("plane");
  plane.shape = HalfPlane{};
  refuses([&] { builder.add(plane); }, "body 'plane': a half_plane cannot move; its mobility must be fixed");
}

BOOST_AUTO_TEST_CASE(wrong_cables_are_refused) {
  ModelBuilder builder;
  const BodyId body = builder.add(rock());
  const TensionOnly law{10.0, 0.0};
  refuses(
      [&] {
        builder.add(Cable{.name = "c", .a = {body, {}}, .b = {std::nullopt, {}}, .rest_length = 1.0, .law = law});
      },
      "cable 'c': both ends are at the same point; they must be apart");
  refuses(
      [&] {
        builder.add(Cable{.name = "c", .a = {}, .b = {std::nullopt, {1, 0, 0}}, .rest_length = 1.0, .law = law});
      },
      "cable 'c': neither end can move; at least one must be on a body that does");
  refuses(
      [&] {
        builder.add(
            Cable{.name = "c", .a = {body, {}}, .b = {std::nullopt, {1, 0, 0}}, .rest_length = -1.0, .law = law});
      },
      "cable 'c': rest_length is -1; it must be >= 0");
  refuses(
      [&] {
        builder.add(Cable{
            .name = "c", .a = {body, {}}, .b = {std::nullopt, {1, 0, 0}}, .rest_length = 1.0, .law = TensionOnly{}});
      },
      "cable 'c': stiffness is 0; it must be > 0");
}

BOOST_AUTO_TEST_CASE(wrong_contacts_are_refused) {
  ModelBuilder builder;
  const BodyId one = builder.add(rock("one"));
  Body bare = rock("bare");
  bare.shape = NoShape{};
  const BodyId two = builder.add(bare);
  const BodyId wall = builder.add(Body{.name = "wall", .mobility = Mobility::fixed, .shape = HalfPlane{}});
  const BodyId post = builder.add(Body{.name = "post", .mobility = Mobility::fixed, .shape = Circle{1.0}});
  const LinearSpringDashpot law{10.0, 0.0, EndRule::clamped};
  refuses([&] { builder.add(Contact{.name = "c", .a = one, .b = one, .law = law}); },
          "contact 'c': body 'one' against itself; name two bodies");
  refuses([&] { builder.add(Contact{.name = "c", .a = wall, .b = post, .law = law}); },
          "contact 'c': neither 'wall' nor 'post' can move");
  refuses(
      [&] {
        builder.add(Contact{.name = "c", .a = one, .b = wall, .law = LatchingSpring{10.0, 9.0, 0.0}});
      },
      "contact 'c': unloading_stiffness is 9; it must be >= stiffness, which is 10");
  refuses(
      [&] {
        builder.add(Contact{.name = "c", .a = one, .b = wall, .law = Hertz{10.0, 0.0, 0.0}});
      },
      "contact 'c': radius is 0; it must be > 0");
  refuses([&] { builder.add(Contact{.name = "c", .a = one, .b = two, .law = law}); },
          "contact 'c': no contact between shapes 'circle' and 'none' by method 'resultant'; known pairs: circle with "
          "circle, rectangle, superquadric, half_plane, terrain; rectangle and superquadric with rectangle, "
          "superquadric, half_plane");
  refuses(
      [&] {
        builder.add(
            Contact{.name = "c", .a = one, .b = wall, .law = law, .method = ContactMethod::nodes, .nodes = {2, 2}});
      },
      "contact 'c': nodes is 2, 2; each must be from 3 to 100000");
}

BOOST_AUTO_TEST_CASE(a_scene_needs_a_body) {
  refuses([] { static_cast<void>(ModelBuilder{}.build()); }, "the scene has no body; it needs at least one");
}

BOOST_AUTO_TEST_CASE(a_body_carries_only_the_coordinates_it_has) {
  ModelBuilder builder;
  builder.add(rock("free"));
  Body grain = rock("grain");
  grain.mobility = Mobility::particle;
  builder.add(grain);
  Body column = rock("column");
  column.mobility = Mobility::pinned;
  column.p_BPin = {0.0, 1.0};
  const BodyId pinned = builder.add(column);
  builder.add(Body{.name = "ground", .mobility = Mobility::fixed, .shape = HalfPlane{}});
  const Model model = builder.build();
  const Layout layout{model};
  BOOST_TEST(layout.coordinates.size() == 6);  // 3 + 2 + 1 + 0
  BOOST_TEST(name(model, layout.coordinates[5]) == "column.angle");
  State state = rest_state(model);
  refuses(
      [&] {
        set_velocity(model, state, pinned, {1.0, 0.0}, 0.0);
      },
      "body 'column' is pinned and has no independent velocity; give its angular velocity");
  set_velocity(model, state, pinned, {}, 2.0);
  const Pose now = pose(model, state, pinned);
  BOOST_TEST(now.v_WB.x == 2.0);  // the centre is one unit below the pin, angular velocity 2
  BOOST_TEST(now.p_WB.y == 0.0);
}

BOOST_AUTO_TEST_CASE(node_contacts_have_one_instance_a_node_both_ways) {
  ModelBuilder builder;
  const BodyId one = builder.add(rock("one"));
  Body box = rock("box");
  box.shape = Rectangle{1.0, 1.0};
  box.p_WB = {3.0, 0.0};
  const BodyId two = builder.add(box);
  builder.add(Contact{.name = "c",
                      .a = one,
                      .b = two,
                      .law = LinearSpringDashpot{1.0, 0.0, EndRule::clamped},
                      .method = ContactMethod::nodes,
                      .nodes = {12, 12}});
  BOOST_TEST(Layout{builder.build()}.contact_instances[0] == 16);
}

// A quarter turn rotates the body's x axis to the world's y; the position along the fence is that of the point on the
// body.
BOOST_AUTO_TEST_CASE(a_cable_end_stands_with_its_body) {
  ModelBuilder builder;
  Body turned = rock();
  turned.p_WB = {1.0, 2.0};
  turned.angle = std::acos(0.0);
  const BodyId body = builder.add(turned);
  const Model model = builder.build();
  const Vec3 on_body = reference_point(model, {.body = body, .p = {3.0, 0.0, 5.0}});
  BOOST_TEST(std::abs(on_body.x - 1.0) < 1e-15);  // 3 times the rounding of a right angle, 6e-17
  BOOST_TEST(on_body.y == 5.0);
  BOOST_TEST(on_body.z == 5.0);
  const Vec3 in_world = reference_point(model, {.body = {}, .p = {3.0, 0.0, 5.0}});
  BOOST_TEST(in_world.x == 3.0);
  BOOST_TEST(in_world.y == 0.0);
}

BOOST_AUTO_TEST_SUITE_END()
