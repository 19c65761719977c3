#include "solver/base/units.hpp"

#include <boost/test/unit_test.hpp>
#include <numbers>

#include "solver/base/error.hpp"

BOOST_AUTO_TEST_SUITE(units_tests)

using namespace talus;

namespace {

std::string message(std::string_view text, Dimension wanted, const UnitSystem& system) {
  try {
    static_cast<void>(parse_quantity(text, wanted, system));
  } catch (const InputError& error) {
    return error.what();
  }
  return "no error";
}

bool starts_with(const std::string& text, std::string_view start) { return text.rfind(start, 0) == 0; }

}  // namespace

// Units of the system itself must not change a single bit of the number.
BOOST_AUTO_TEST_CASE(own_units_cancel_exactly) {
  BOOST_TEST(parse_quantity("14.92 slug", dimension::mass, us) == 14.92);
  BOOST_TEST(parse_quantity("85.42 slug ft^2", dimension::inertia, us) == 85.42);
  BOOST_TEST(parse_quantity("85.42 slug*ft^2", dimension::inertia, us) == 85.42);
  BOOST_TEST(parse_quantity("-5.1 ft/s", dimension::velocity, us) == -5.1);
  BOOST_TEST(parse_quantity("32.174 ft/s^2", dimension::acceleration, us) == 32.174);
  BOOST_TEST(parse_quantity("0.1944e6 lbf/ft", dimension::stiffness, us) == 0.1944e6);
  BOOST_TEST(parse_quantity("1004.9 lbf s/ft", dimension::damping, us) == 1004.9);
  BOOST_TEST(parse_quantity("4 N/m", dimension::stiffness, si) == 4.0);
  BOOST_TEST(parse_quantity("0.1 kg m s^-2", dimension::force, si) == 0.1);
  BOOST_TEST(parse_quantity("  +.3m ", dimension::length, si) == 0.3);
  BOOST_TEST(parse_quantity("12.5 J/m", dimension::force, si) == 12.5);
}

BOOST_AUTO_TEST_CASE(own_symbols_are_read_back) {
  const Dimension all[] = {dimension::mass,
                           dimension::length,
                           dimension::time,
                           dimension::angle,
                           dimension::velocity,
                           dimension::force,
                           dimension::moment,
                           dimension::acceleration,
                           dimension::inertia,
                           dimension::momentum,
                           dimension::stiffness,
                           dimension::angular_velocity,
                           dimension::damping,
                           dimension::energy,
                           dimension::frequency,
                           dimension::angular_momentum,
                           dimension::mass * dimension::mass / dimension::time};
  for (const UnitSystem& system : {si, us}) {
    for (const Dimension dimension : all) {
      BOOST_TEST(parse_quantity("0.7 " + symbol(system, dimension), dimension, system) == 0.7);
    }
  }
  BOOST_TEST(parse_quantity("0.7", dimension::number, us) == 0.7);
}

// Decimal fractions of the system's units are correctly rounded quotients; other units agree with the definitions to 2
// ulp (two roundings).
BOOST_AUTO_TEST_CASE(other_units_convert_by_the_exact_factors) {
  BOOST_TEST(parse_quantity("5 mm", dimension::length, si) == 0.005);
  BOOST_TEST(parse_quantity("3 us", dimension::time, si) == 3e-6);
  BOOST_TEST(parse_quantity("18 in", dimension::length, us) == 1.5);
  BOOST_TEST(parse_quantity("2 yd", dimension::length, us) == 6.0);
  BOOST_TEST(parse_quantity("144 in^2", dimension::length * dimension::length, us) == 1.0);
  BOOST_TEST(parse_quantity("2 kip", dimension::force, us) == 2000.0);
  BOOST_TEST(parse_quantity("1 psi", dimension::force / dimension::length / dimension::length, us) == 144.0);
  BOOST_TEST(parse_quantity("1 lb", dimension::mass, si) == 0.45359237);
  BOOST_TEST(parse_quantity("1 ft", dimension::length, si) == 0.3048);
  BOOST_TEST(parse_quantity("180 deg", dimension::angle, si) == std::numbers::pi);
  BOOST_TEST(parse_quantity("2 min", dimension::time, us) == 120.0);
  BOOST_TEST(parse_quantity("36 km/h", dimension::velocity, si) == 10.0);
  const auto near = boost::test_tools::tolerance(4.5e-16);
  BOOST_TEST(parse_quantity("30 rpm", dimension::angular_velocity, us) == std::numbers::pi, near);
  BOOST_TEST(parse_quantity("1 lbf", dimension::force, si) == 4.4482216152605, near);
  BOOST_TEST(parse_quantity("1 slug", dimension::mass, si) == 14.593902937206365, near);
  BOOST_TEST(parse_quantity("32.174048556430446 lb", dimension::mass, us) == 1.0, near);
  BOOST_TEST(parse_quantity("9.80665 m/s^2", dimension::acceleration, us) == 32.17404855643044, near);
  BOOST_TEST(parse_quantity("1 kN/mm", dimension::stiffness, si) == 1e6);
}

BOOST_AUTO_TEST_CASE(sizes_and_symbols) {
  BOOST_TEST(si_size(us, dimension::force) == exact::pound_force_in_N, boost::test_tools::tolerance(4.5e-16));
  BOOST_TEST(si_size(us, dimension::angular_velocity) == 1.0);
  BOOST_TEST(symbol(us, dimension::stiffness) == "lbf/ft");
  BOOST_TEST(symbol(us, dimension::damping) == "lbf s/ft");
  BOOST_TEST(symbol(us, dimension::inertia) == "slug ft^2");
  BOOST_TEST(symbol(si, dimension::energy) == "N m");
  BOOST_TEST(symbol(si, dimension::angular_velocity) == "rad/s");
  BOOST_TEST(symbol(si, dimension::number) == "1");
  BOOST_TEST(unit_system("US").length == "ft");
  BOOST_CHECK_EXCEPTION(static_cast<void>(unit_system("USA")), InputError, [](const InputError& error) {
    return std::string{error.what()} == "unit system 'USA' is not known; nearest: US; known: SI, US";
  });
  BOOST_TEST(std::string{unknown_name("contact", "hit", {}).what()} == "contact 'hit' is not known; there is none");
}

BOOST_AUTO_TEST_CASE(messages_say_what_was_found_and_what_is_allowed) {
  BOOST_TEST(message("3", dimension::mass, si) == "found \"3\"; the unit is missing; write e.g. \"3 kg\"");
  BOOST_TEST(message("65 ft", dimension::velocity, us) ==
             "found \"65 ft\"; that is a length; it must be a velocity, e.g. \"65 ft/s\"");
  BOOST_TEST(message("600 lb", dimension::force, us) ==
             "found \"600 lb\"; that is a mass; it must be a force, e.g. \"600 lbf\"");
  BOOST_TEST(message("2 1/s", dimension::angular_velocity, si) ==
             "found \"2 1/s\"; that is a frequency; it must be an angular velocity, e.g. \"2 rad/s\"");
  BOOST_TEST(message("heavy", dimension::mass, us) ==
             "found \"heavy\"; it must be a number with a unit, e.g. \"1 slug\"");
  BOOST_TEST(message("", dimension::mass, si) == "found \"\"; it must be a number with a unit, e.g. \"1 kg\"");
  BOOST_TEST(message("inf m", dimension::length, si) ==
             "found \"inf m\"; it must be a number with a unit, e.g. \"1 m\"");
  BOOST_TEST(message("1e999 m", dimension::length, si) ==
             "found \"1e999 m\"; the number is too large or too small for a double");
  BOOST_TEST(message("1 m^1.5", dimension::length, si) ==
             "found \"1 m^1.5\"; a power must be a whole number between -9 and 9");
  BOOST_TEST(message("1 m/", dimension::length, si) == "found \"1 m/\"; a unit must follow '/'");
  BOOST_TEST(message("1 m)", dimension::length, si) == "found \"1 m)\"; ')' is not a unit; write e.g. \"1 m\"");
  BOOST_TEST(message("1 2 m", dimension::length, si) == "found \"1 2 m\"; '2 m' is not a unit; write e.g. \"1 m\"");
  BOOST_TEST(starts_with(message("3 sluug", dimension::mass, us),
                         "found \"3 sluug\"; unit 'sluug' is not known; nearest: slug; known: kg, g, t, "));
  BOOST_TEST(message("1 kg^3", dimension::mass, si) ==
             "found \"1 kg^3\"; that is of dimension M^3; it must be a mass, e.g. \"1 kg\"");
  BOOST_TEST(message("0.5 m", dimension::number, si) ==
             "found \"0.5 m\"; that is a length; it must be a pure number, e.g. \"0.5\"");
}

// A deck's number and a scene's quantity with the same digits are the same double.
BOOST_AUTO_TEST_CASE(numbers_of_a_unit_are_quantities) {
  for (const char* number : {"2e7", "1.076", "0.1", "-3.3333333333333335", "1e-300"}) {
    for (const UnitSystem& system : {si, us}) {
      BOOST_TEST(consistent(std::stod(number), "psi", dimension::pressure, system) ==
                 parse_quantity(std::string{number} + " psi", dimension::pressure, system));
      BOOST_TEST(consistent(std::stod(number), "in^2", dimension::area, system) ==
                 parse_quantity(std::string{number} + " in^2", dimension::area, system));
    }
    BOOST_TEST(consistent(std::stod(number), "", dimension::number, us) == std::stod(number));
  }
  BOOST_TEST(symbol(us, dimension::density) == "slug/ft^3");
  BOOST_TEST(symbol(si, dimension::area) == "m^2");
  BOOST_CHECK_THROW(static_cast<void>(consistent(1.0, "psi", dimension::area, us)), InputError);
}

BOOST_AUTO_TEST_SUITE_END()
