#include <fmt/format.h>
#include <fmt/ranges.h>

#include <boost/test/unit_test.hpp>
#include <string>
#include <string_view>

#include "solver/base/error.hpp"
#include "solver/integrate/integrator_list.hpp"
#include "solver/io/read_scene_file.hpp"
#include "solver/io/scene/read_scene.hpp"

BOOST_AUTO_TEST_SUITE(wrong_scenes_tests)

// Each test takes the valid scene, introduces one mistake and expects one message, word for word.

using namespace talus;

namespace {

constexpr std::string_view sound = R"(title = "Two"
units = "SI"
gravity = ["0 m/s^2", "-9.81 m/s^2"]
[[body]]
name = "rock"
mobility = "free"
mass = "3 kg"
inertia = "0.5 kg m^2"
shape = { kind = "circle", radius = "0.5 m" }
position = ["0 m", "1 m"]
[[body]]
name = "ground"
mobility = "fixed"
shape = { kind = "half_plane" }
position = ["0 m", "0 m"]
[[contact]]
name = "bounce"
between = ["rock", "ground"]
law = "linear_spring_dashpot"
stiffness = "1e4 N/m"
damping = "2 N s/m"
[[cable]]
name = "rope"
law = "tension_only"
from = { body = "rock", point = ["0 m", "0 m"] }
to = { point = ["0 m", "4 m", "1 m"] }
stiffness = "100 N/m"
[run]
integrator = "rk4"
step = "1 ms"
end = "1 s"
)";

/// The message of the valid scene with `part` replaced.
std::string message(std::string_view part, std::string_view replacement) {
  std::string text{sound};
  const std::size_t at = text.find(part);
  BOOST_REQUIRE(at != std::string::npos);
  text.replace(at, part.size(), replacement);
  try {
    static_cast<void>(read_scene(text, "s.toml"));
  } catch (const InputError& error) {
    return error.what();
  }
  return "no error";
}

}  // namespace

BOOST_AUTO_TEST_CASE(keys_of_very_many_parts) {
  std::string key = "a";
  for (int i = 0; i < 300000; ++i)
    key += ".a";
  BOOST_TEST(message("title = \"Two\"", key + " = 1") ==
             "s.toml:1: a key has more than 100 parts, which are joined by dots");
}

BOOST_AUTO_TEST_CASE(the_sound_scene_is_read) { BOOST_TEST(message("3 kg", "3 kg") == "no error"); }

BOOST_AUTO_TEST_CASE(quantities) {
  BOOST_TEST(message("\"3 kg\"", "\"-3 kg\"") == "s.toml:7: body 'rock': mass: found \"-3 kg\"; it must be > 0");
  BOOST_TEST(message("\"3 kg\"", "3") ==
             "s.toml:7: body 'rock': mass: found 3; the unit is missing; write e.g. \"3 kg\"");
  BOOST_TEST(message("\"3 kg\"", "\"3\"") ==
             "s.toml:7: body 'rock': mass: found \"3\"; the unit is missing; write e.g. \"3 kg\"");
  BOOST_TEST(message("\"3 kg\"", "true") ==
             "s.toml:7: body 'rock': mass: found true; it must be a quantity in quotes, e.g. \"1 kg\"");
  BOOST_TEST(message("\"3 kg\"", "\"3 m\"") ==
             "s.toml:7: body 'rock': mass: found \"3 m\"; that is a length; it must be a mass, e.g. \"3 kg\"");
  BOOST_TEST(message("\"2 N s/m\"", "\"-2 N s/m\"") ==
             "s.toml:21: contact 'bounce': damping: found \"-2 N s/m\"; it must be >= 0");
  BOOST_TEST(message("\"-9.81 m/s^2\"", "-9.81") ==
             "s.toml:3: gravity.y: found -9.81; the unit is missing; write e.g. \"-9.81 m/s^2\"");
  BOOST_TEST(
      message("[\"0 m\", \"1 m\"]", "\"1 m\"") ==
      "s.toml:10: body 'rock': position: found \"1 m\"; it must be an array of 2 quantities, e.g. [\"1 m\", \"1 m\"]");
  BOOST_TEST(message("\"0 m\", \"1 m\"", "\"0 m\", \"1 m\", \"0 m\"") ==
             "s.toml:10: body 'rock': position: found 3 components; it must have 2");
  BOOST_TEST(message("\"0.5 m\"", "\"0 m\"") == "s.toml:9: body 'rock': shape: radius: found \"0 m\"; it must be > 0");
  BOOST_TEST(message("\"1 ms\"", "\"0 s\"") == "s.toml:30: run: step: found \"0 s\"; it must be > 0");
  BOOST_TEST(message("\"1 ms\"", "\"1e-15 s\"") ==
             "s.toml:28: run: the end is 1e+15 steps away; it must be at most 1e12");
  BOOST_TEST(
      message("\"1 ms\"", "\"1 ms\"\ninterval = \"10 us\"") ==
      "s.toml:31: run: interval: found \"10 us\"; it must be at least the step, \"1 ms\": the history has at most "
      "one row a step");
  BOOST_TEST(message("\"1 ms\"", "\"1 ms\"\ninterval = \"0.001 s\"") == "no error");
  BOOST_TEST(message("\"1 ms\"", "\"auto\"\ninterval = \"1e-9 s\"") == "no error");
}

BOOST_AUTO_TEST_CASE(names_and_keys) {
  BOOST_TEST(message("mass =", "mas =") ==
             "s.toml:7: body 'rock': mas: this key is not known; nearest: mass; known: name, mass, inertia, angle, "
             "moment, mobility, shape, position, pin, velocity, spin, force");
  BOOST_TEST(message("\"free\"", "\"fre\"") ==
             "s.toml:6: body 'rock': mobility: found \"fre\"; nearest: free; known: free, particle, pinned, fixed, "
             "sliding_x, sliding_y, guided_x, guided_y");
  BOOST_TEST(message("\"circle\"", "\"circel\"") ==
             "s.toml:9: body 'rock': shape: kind: found \"circel\"; nearest: circle; known: none, circle, rectangle, "
             "superquadric, half_plane, terrain");
  BOOST_TEST(message("radius =", "radios =") ==
             "s.toml:9: body 'rock': shape: radios: this key is not known; nearest: radius; known: kind, radius");
  BOOST_TEST(message("\"rock\", \"ground\"", "\"rok\", \"ground\"") ==
             "s.toml:18: contact 'bounce': between: body 'rok' is not known; nearest: rock; known: rock, ground");
  BOOST_TEST(message("\"rock\", \"ground\"", "\"rock\"") ==
             "s.toml:18: contact 'bounce': between: found [\"rock\"]; it must be an array of 2 texts in quotes");
  BOOST_TEST(
      message("\"rock\", \"ground\"", "\"a rock with a long name\", \"another with a long name\", \"and a third\"") ==
      "s.toml:18: contact 'bounce': between: found an array of 3; it must be an array of 2 texts in quotes");
  BOOST_TEST(message("\"tension_only\"", "\"tension\"") ==
             "s.toml:24: cable 'rope': law: found \"tension\"; nearest: tension_only; known: tension_only, "
             "elastic_plastic");
  BOOST_TEST(message("\"rk4\"", "\"verlett\"") ==
             fmt::format("s.toml:29: run: integrator: found \"verlett\"; nearest: velocity_verlet; known: {}, auto",
                         fmt::join(integrator_names(), ", ")));
  BOOST_TEST(message("\"SI\"", "\"si\"") == "s.toml:2: units: found \"si\"; nearest: SI; known: SI, US");
  BOOST_TEST(message("name = \"ground\"", "name = \"rock\"") ==
             "s.toml:11: body 'rock' exists already; names must differ");
  BOOST_TEST(message("name = \"ground\"\n", "") == "s.toml:11: body 2: name: it is missing");
  for (const char* name : {"time", "energy", "dissipated", "balance_error"}) {
    BOOST_TEST(
        message("name = \"ground\"", fmt::format("name = \"{}\"", name)) ==
        fmt::format("s.toml:12: body 2: name: found \"{}\"; a history has columns of that name; choose another", name));
  }
  BOOST_TEST(message("[run]", "[rum]") ==
             "s.toml:28: rum: this key is not known; nearest: run; known: fence, title, units, gravity, body, contact, "
             "cable, hanger, run");
  BOOST_TEST(message("[[cable]]", "[cable]") ==
             "s.toml:22: cable: found a table; each cable is a separate table, headed [[cable]]");
}

BOOST_AUTO_TEST_CASE(names_that_a_csv_header_cannot_contain_are_refused) {
  for (const char* name : {"a,b", "a[b", "a]b", R"(a tab\tb)", R"(a delete\u007fb)"}) {
    const std::string found = message("name = \"ground\"", fmt::format("name = \"{}\"", name));
    BOOST_TEST(found.starts_with("s.toml:12: body 2: name: found \"a"), found);
    BOOST_TEST(
        found.ends_with("b\"; a name heads columns of a CSV file; it must be without commas, quotes, brackets and "
                        "control characters"),
        found);
  }
}

BOOST_AUTO_TEST_CASE(what_is_missing_or_has_no_place) {
  BOOST_TEST(message("mass = \"3 kg\"\n", "") == "s.toml:4: body 'rock': mass: it is missing");
  BOOST_TEST(message("step = \"1 ms\"\n", "") ==
             "s.toml:28: run: step: it is missing; rk4 has a fixed step: give it, or \"auto\"");
  BOOST_TEST(message("end = \"1 s\"\n", "") == "s.toml:28: run: end: it is missing");
  BOOST_TEST(message("title = \"Two\"\n", "") == "no error");
  BOOST_TEST(message("\"free\"", "\"particle\"") ==
             "s.toml:8: body 'rock': inertia: this body cannot turn; leave it out");
  BOOST_TEST(message("\"fixed\"", "\"fixed\"\nvelocity = [\"1 m/s\", \"0 m/s\"]") ==
             "s.toml:14: body 'ground': velocity: a fixed body has none; leave it out");
  BOOST_TEST(message("\"fixed\"", "\"particle\"\nmass = \"1 kg\"") ==
             "s.toml:11: body 'ground': a half_plane cannot move; its mobility must be fixed");
  BOOST_TEST(message("damping = \"2 N s/m\"\n", "") ==
             "s.toml:16: contact 'bounce': damping: give either this or restitution, one of the two");
  BOOST_TEST(
      message("damping = \"2 N s/m\"", "restitusion = 0.5")
          .starts_with("s.toml:21: contact 'bounce': restitusion: this key is not known; nearest: restitution; "));
  BOOST_TEST(message("damping = \"2 N s/m\"", "restitution = 1.5") ==
             "s.toml:21: contact 'bounce': restitution: found 1.5; it must be in (0, 1]");
  BOOST_TEST(
      message("damping = \"2 N s/m\"", "restitution = \"0.5\"") ==
      "s.toml:21: contact 'bounce': restitution: found \"0.5\"; it must be a pure number without quotes, e.g. 0.5");
  BOOST_TEST(message("damping = \"2 N s/m\"", "damping = \"2 N s/m\"\nnodes = 12") ==
             "s.toml:22: contact 'bounce': nodes: contact by resultant has no nodes; leave it out");
  BOOST_TEST(message("\"rk4\"", "\"rk4\"\ntolerance = 1e-6") ==
             "s.toml:28: integrator 'rk4': tolerance is 1e-06; it has no step control, so leave it out");
}

BOOST_AUTO_TEST_CASE(what_the_model_refuses) {
  BOOST_TEST(message("[\"0 m\", \"4 m\", \"1 m\"]", "[\"0 m\", \"1 m\"]") ==
             "s.toml:22: cable 'rope': both ends are at the same point; they must be apart");
  BOOST_TEST(message("body = \"rock\", ", "") ==
             "s.toml:22: cable 'rope': neither end can move; at least one must be on a body that does");
  BOOST_TEST(message("\"rock\", \"ground\"", "\"rock\", \"rock\"") ==
             "s.toml:16: contact 'bounce': body 'rock' against itself; name two bodies");
}

// A body that rocks to rest on the flat side of a superquadric would take millions of evaluations.
BOOST_AUTO_TEST_CASE(flat_sides_by_one_resultant) {
  const auto stone = [](const char* exponent, const char* more) {
    return message("shape = { kind = \"circle\", radius = \"0.5 m\" }",
                   fmt::format("shape = {{ kind = \"superquadric\", half_width = \"0.5 m\", half_height = \"0.4 m\", "
                               "exponent = {} }}{}",
                               exponent, more));
  };
  BOOST_TEST(stone("5.0", "") == "no error");
  BOOST_TEST(stone("5.1", "") ==
             "s.toml:16: contact 'bounce': found a superquadric of exponent 5.1 on a half_plane: one resultant has no "
             "position on sides that are flat; give a rectangle, an exponent of at most 5, or contact by nodes");
  std::string text{sound};
  const std::string circle = "shape = { kind = \"circle\", radius = \"0.5 m\" }";
  text.replace(text.find(circle), circle.size(),
               "shape = { kind = \"superquadric\", half_width = \"0.5 m\", half_height = \"0.4 m\", exponent = 8 }");
  const std::string law = "damping = \"2 N s/m\"\n";
  text.replace(text.find(law), law.size(), law + "method = \"nodes\"\n");
  BOOST_CHECK_NO_THROW(static_cast<void>(read_scene(text, "s.toml")));
}

BOOST_AUTO_TEST_CASE(what_is_not_toml) {
  BOOST_TEST(message("mass = ", "mass ").rfind("s.toml:7: not TOML: ", 0) == 0);
  BOOST_TEST(message("mass = \"3 kg\"", "mass = \"3 kg\"\nmass = \"4 kg\"").rfind("s.toml:8: not TOML: ", 0) == 0);
}

BOOST_AUTO_TEST_CASE(a_file_that_is_not_there) {
  BOOST_CHECK_EXCEPTION(
      static_cast<void>(read_scene(std::filesystem::path{"/nowhere/s.toml"})), IoError,
      [](const IoError& error) { return std::string{error.what()} == "/nowhere/s.toml: No such file or directory"; });
}

BOOST_AUTO_TEST_CASE(fields_of_other_contact_laws) {
  constexpr std::string_view dashpot =
      "law = \"linear_spring_dashpot\"\nstiffness = \"1e4 N/m\"\ndamping = \"2 N s/m\"\n";
  const auto latching = [&](std::string_view more) {
    return message(dashpot, fmt::format("law = \"latching_spring\"\nstiffness = \"1e4 N/m\"\n{}\n", more));
  };
  BOOST_TEST(latching("unloading_stiffness = \"2e4 N/m\"\ngrowth = \"3 1/m\"") == "no error");
  BOOST_TEST(latching("") == "s.toml:16: contact 'bounce': unloading_stiffness: it is missing");
  BOOST_TEST(latching("unloading_stiffness = \"1e3 N/m\"") ==
             "s.toml:16: contact 'bounce': unloading_stiffness is 1000; it must be >= stiffness, which is 10000");
  constexpr std::string_view known =
      "known: name, law, stiffness, unloading_stiffness, growth, between, method, nodes, node_depth, friction, "
      "shear_stiffness, shear_damping";
  BOOST_TEST(
      latching("unloading_stiffness = \"2e4 N/m\"\nrestitution = 0.5") ==
      fmt::format("s.toml:22: contact 'bounce': restitution: this key is not known; nearest: friction; {}", known));
  BOOST_TEST(latching("unloading_stiffness = \"2e4 N/m\"\nend_rule = \"clamped\"") ==
             fmt::format("s.toml:22: contact 'bounce': end_rule: this key is not known; nearest: nodes; {}", known));
  const auto hertz = [&](std::string_view more) {
    return message(dashpot, fmt::format("law = \"hertz\"\nmodulus = \"1e6 Pa\"\nradius = \"0.5 m\"\n{}\n", more));
  };
  BOOST_TEST(hertz("damping = \"0 N s/m\"\nend_rule = \"attractive\"") == "no error");
  BOOST_TEST(hertz("friction = 0.3\nshear_law = \"mindlin\"\nshear_modulus = \"1e6 Pa\"") == "no error");
  BOOST_TEST(hertz("friction = 0.3\nshear_law = \"linear\"") == "no error");
  BOOST_TEST(hertz("friction = 0.3\nshear_law = \"mindlin\"") ==
             "s.toml:16: contact 'bounce': shear_modulus: it is missing");
  BOOST_TEST(hertz("friction = 0.3\nshear_law = \"mindlin\"\nshear_modulus = \"0 Pa\"") ==
             "s.toml:24: contact 'bounce': shear_modulus: found \"0 Pa\"; it must be > 0");
  BOOST_TEST(hertz("friction = 0.3\nshear_law = \"mindlin\"\nshear_modulus = \"1 Pa\"\nshear_stiffness = \"1 N/m\"") ==
             "s.toml:25: contact 'bounce': shear_stiffness: it belongs to shear_law = \"linear\"; give shear_modulus "
             "instead");
  BOOST_TEST(hertz("friction = 0.3\nshear_modulus = \"1 Pa\"") ==
             "s.toml:23: contact 'bounce': shear_modulus: it belongs to shear_law = \"mindlin\"; give this law, or "
             "remove it");
  BOOST_TEST(hertz("shear_law = \"mindlin\"") ==
             "s.toml:22: contact 'bounce': shear_law: it requires friction; give friction, or remove it");
  BOOST_TEST(hertz("friction = 0.3\nshear_law = \"minlin\"") ==
             "s.toml:23: contact 'bounce': shear_law: found \"minlin\"; nearest: mindlin; known: linear, mindlin");
  BOOST_TEST(
      latching("unloading_stiffness = \"2e4 N/m\"\nfriction = 0.3\nshear_law = \"mindlin\"") ==
      fmt::format("s.toml:23: contact 'bounce': shear_law: this key is not known; nearest: shear_damping; {}", known));
  BOOST_TEST(hertz("restitution = 0.5\nrestitution_rule = \"eq_21\"") == "no error");
  BOOST_TEST(hertz("") == "no error");
  BOOST_TEST(hertz("damping = \"1 N s/m\"\nrestitution = 0.5") ==
             "s.toml:22: contact 'bounce': damping: give either this or restitution, one of the two");
  BOOST_TEST(hertz("restitution_rule = \"eq_21\"") ==
             "s.toml:22: contact 'bounce': restitution_rule: it needs restitution");
  BOOST_TEST(hertz("restitution = 0.5\ndashpot = \"constant\"") ==
             "s.toml:16: contact 'bounce': restitution_speed: it is missing");
  BOOST_TEST(hertz("damping = \"1 N s/m\"\ndashpot = \"constant\"\nrestitution_speed = \"1 m/s\"") ==
             "s.toml:24: contact 'bounce': restitution_speed: the damping is given; leave this out or give restitution "
             "instead");
  const auto hunt_crossley = [&](std::string_view more) {
    return message(dashpot, fmt::format("law = \"hunt_crossley\"\nstiffness = \"1e4 N/m\"\nreference_overlap = "
                                        "\"1 cm\"\n{}\n",
                                        more));
  };
  BOOST_TEST(hunt_crossley("exponent = 1.5\nrestitution = 0.5\nrestitution_speed = \"1 m/s\"") == "no error");
  BOOST_TEST(hunt_crossley("exponent = 0.9\nhysteresis = \"1 s/m\"") ==
             "s.toml:22: contact 'bounce': exponent: found 0.9; it must be in [1, 100]");
  BOOST_TEST(hunt_crossley("exponent = 1.5\nrestitution = 0.5\nrestitution_speed = \"-1 m/s\"") ==
             "s.toml:24: contact 'bounce': restitution_speed: found \"-1 m/s\"; it must be > 0");
}

BOOST_AUTO_TEST_SUITE_END()
