#include "solver/io/file/fortran.hpp"

#include <boost/test/unit_test.hpp>

BOOST_AUTO_TEST_SUITE(fortran_tests)

using talus::fortran_e;
using talus::fortran_g;

// Expected texts are those that a Fortran compiler prints with Ew.3, Ew.4 and Gw.3, without the leading zero, which the
// 1993 listing does not have.
BOOST_AUTO_TEST_CASE(format_e) {
  BOOST_TEST(fortran_e(0.0, 3) == ".000E+00");
  BOOST_TEST(fortran_e(-0.0, 3) == ".000E+00");
  BOOST_TEST(fortran_e(1.0, 3) == ".100E+01");
  BOOST_TEST(fortran_e(0.1, 3) == ".100E+00");
  BOOST_TEST(fortran_e(0.99949, 3) == ".999E+00");
  BOOST_TEST(fortran_e(0.99951, 3) == ".100E+01");
  BOOST_TEST(fortran_e(1e-10, 3) == ".100E-09");
  BOOST_TEST(fortran_e(8.27374e-5, 3) == ".827E-04");
  BOOST_TEST(fortran_e(-65.0, 3) == "-.650E+02");
  BOOST_TEST(fortran_e(-0.04281, 3) == "-.428E-01");
  BOOST_TEST(fortran_e(32.18, 4) == ".3218E+02");
  BOOST_TEST(fortran_e(8.723e7, 4) == ".8723E+08");
  BOOST_TEST(fortran_e(5.0, 1) == ".5E+01");
}

BOOST_AUTO_TEST_CASE(exponents_of_three_digits_take_the_place_of_the_letter) {
  BOOST_TEST(fortran_e(1e98, 3) == ".100E+99");
  BOOST_TEST(fortran_e(1e99, 3) == ".100+100");
  BOOST_TEST(fortran_e(9.999e98, 3) == ".100+100");
  BOOST_TEST(fortran_e(-1e-300, 3) == "-.100-299");
  BOOST_TEST(fortran_e(1e-100, 3) == ".100E-99");
}

BOOST_AUTO_TEST_CASE(format_g_stands_without_exponent_near_one) {
  BOOST_TEST(fortran_g(0.0, 3) == ".000");
  BOOST_TEST(fortran_g(55.0, 3) == "55.0");
  BOOST_TEST(fortran_g(-4.0, 3) == "-4.00");
  BOOST_TEST(fortran_g(1.076, 3) == "1.08");
  BOOST_TEST(fortran_g(0.25, 3) == ".250");
  BOOST_TEST(fortran_g(0.1, 3) == ".100");
  BOOST_TEST(fortran_g(0.0999, 3) == ".999E-01");
  BOOST_TEST(fortran_g(0.09996, 3) == ".100");
  BOOST_TEST(fortran_g(999.4, 3) == "999.");
  BOOST_TEST(fortran_g(999.6, 3) == ".100E+04");
  BOOST_TEST(fortran_g(2e7, 3) == ".200E+08");
}

BOOST_AUTO_TEST_SUITE_END()
