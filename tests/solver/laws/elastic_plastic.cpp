/// A cable that yields and breaks, stretched along prescribed paths with piecewise linear results.
#include "solver/laws/elastic_plastic.hpp"

#include <array>
#include <boost/test/unit_test.hpp>
#include <cmath>
#include <utility>

BOOST_AUTO_TEST_SUITE(elastic_plastic_tests)

using namespace talus;

namespace {

/// One cable whose elongation is prescribed; updates its mode as the dynamics do before each force evaluation.
struct DrawnCable {
  ElasticPlastic law;
  std::array<double, 1> memory{};
  Mode mode{ElasticPlastic::slack};
  double elongation{};
  double dissipated{};
  double released{};

  double tension(double rate) const { return law({elongation, rate}, memory, mode).total(); }

  /// Changes the elongation in equal steps; dissipated work by the trapezoidal rule, exact where tension is constant.
  void draw(double to, int steps) {
    const double step = (to - elongation) / steps;
    for (int i = 0; i < steps; ++i) {
      const double before = law({elongation, step}, memory, mode).dissipative;
      elongation += step;
      press({elongation, step});
      dissipated += 0.5 * (before + law({elongation, step}, memory, mode).dissipative) * step;
    }
  }

  void press(Kinematics x) {
    law.track(x, memory, mode);
    for (std::size_t pass = 0; pass < ElasticPlastic::modes.size(); ++pass) {
      if (law.guard(x, memory, mode) > 0.0) return;
      const Reset next = law.reset(x, memory, mode);
      if (next.mode == mode) return;
      mode = next.mode;
      released += next.released;
    }
  }
};

}  // namespace

BOOST_AUTO_TEST_CASE(holds_the_yield_force_and_keeps_the_stretch) {
  DrawnCable cable{.law = {.stiffness = 8.0, .yield = 2.0}};
  cable.draw(1.0, 64);  // yields from 0.25 on: plastic elongation 0.75
  BOOST_TEST(cable.mode == ElasticPlastic::yielding);
  BOOST_TEST(cable.tension(1.0) == 2.0);
  cable.draw(0.875, 8);
  BOOST_TEST(cable.mode == ElasticPlastic::taut);
  BOOST_TEST(cable.memory[0] == 0.75);
  BOOST_TEST(cable.tension(-1.0) == 1.0);
  cable.draw(0.5, 8);
  BOOST_TEST(cable.mode == ElasticPlastic::slack);
  BOOST_TEST(cable.tension(-1.0) == 0.0);
}

BOOST_AUTO_TEST_CASE(next_impact_starts_from_the_stretch_of_the_last) {
  DrawnCable cable{.law = {.stiffness = 8.0, .yield = 2.0}};
  cable.draw(1.0, 64);
  cable.draw(0.0, 64);
  cable.draw(0.875, 64);
  BOOST_TEST(cable.tension(1.0) == 1.0);
  cable.draw(2.0, 128);
  BOOST_TEST(cable.memory[0] == 1.75);
  BOOST_TEST(cable.tension(1.0) == 2.0);
}

BOOST_AUTO_TEST_CASE(work_done_is_stored_or_dissipated) {
  // Stretched to 1 and released: the area under the curve is yield^2/(2k) + yield 0.75, of which the first term is
  // recovered. The step in which yielding begins is integrated by a trapezium, which is too small by half of 2 x 1/64.
  DrawnCable cable{.law = {.stiffness = 8.0, .yield = 2.0}};
  cable.draw(1.0, 64);
  BOOST_TEST(cable.law.stored_energy({1.0, 1.0}, cable.memory, cable.mode) == 0.25);
  BOOST_TEST(std::abs(cable.dissipated - 1.5) <= 2.0 / 64.0);
  cable.draw(0.0, 64);
  BOOST_TEST(cable.law.stored_energy({0.0, -1.0}, cable.memory, cable.mode) == 0.0);
}

BOOST_AUTO_TEST_CASE(breaks_at_its_strength_and_not_below) {
  DrawnCable below{.law = {.stiffness = 8.0, .strength = 2.0}};
  below.draw(0.249, 64);
  BOOST_TEST(below.mode == ElasticPlastic::taut);
  DrawnCable above{.law = {.stiffness = 8.0, .strength = 2.0}};
  above.draw(0.25, 64);
  BOOST_TEST(above.mode == ElasticPlastic::broken);
  BOOST_TEST(above.released == 0.25);  // strength^2/(2k)
  above.draw(2.0, 64);
  BOOST_TEST(above.tension(1.0) == 0.0);
}

BOOST_AUTO_TEST_CASE(breaks_when_drawn_out_to_its_rupture_stretch) {
  DrawnCable cable{.law = {.stiffness = 8.0, .yield = 2.0, .rupture = 0.5}};
  cable.draw(0.734375, 47);
  BOOST_TEST(cable.mode == ElasticPlastic::yielding);
  cable.draw(0.75, 1);
  BOOST_TEST(cable.mode == ElasticPlastic::broken);
  BOOST_TEST(cable.released == 0.25);
}

BOOST_AUTO_TEST_CASE(hardens_along_a_line_and_along_a_table) {
  // k = 8, yield 2: at elongation e the plastic elongation is p = (8 e - 2)/(8 + H), the tension 2 + H p.
  DrawnCable line{.law = {.stiffness = 8.0, .yield = 2.0, .hardening = 2.0}};
  line.draw(1.0, 4096);
  BOOST_TEST(line.memory[0] == 0.6, boost::test_tools::tolerance(1e-12));
  BOOST_TEST(line.tension(1.0) == 3.2, boost::test_tools::tolerance(1e-12));
  // The same to p = 0.25 (tension 2.5), constant from there to p = 1.25, then with slope 4.
  DrawnCable table{.law = {.stiffness = 8.0, .yield = 2.0, .hardening = 4.0}};
  table.law.table = {{0.25, 2.5}, {1.25, 2.5}};
  table.draw(1.0, 4096);
  BOOST_TEST(table.memory[0] == 1.0 - 2.5 / 8.0, boost::test_tools::tolerance(1e-12));
  BOOST_TEST(table.tension(1.0) == 2.5, boost::test_tools::tolerance(1e-12));
  table.draw(2.0, 4096);
  const double stretch = 1.25 + (8.0 * 0.75 - 2.5) / 12.0;
  BOOST_TEST(table.memory[0] == stretch, boost::test_tools::tolerance(1e-12));
  BOOST_TEST(table.tension(1.0) == 8.0 * (2.0 - stretch), boost::test_tools::tolerance(1e-12));
}

BOOST_AUTO_TEST_CASE(drawn_out_before_is_drawn_out_at_once) {
  // Stretched to 1 and released, a cable equals one that was given this plastic elongation at the start: longer by it,
  // with the same tension. Within the table's first segment, in its second, beyond it, and on a line.
  ElasticPlastic table{.stiffness = 8.0, .yield = 2.0, .rupture = 3.0};
  table.table = {{0.25, 2.5}, {1.25, 4.5}};
  const ElasticPlastic line{.stiffness = 8.0, .yield = 2.0, .hardening = 2.0, .rupture = 3.0};
  for (const auto& [law, first] :
       std::vector<std::pair<ElasticPlastic, double>>{{table, 0.4}, {table, 1.0}, {table, 2.0}, {line, 1.0}}) {
    DrawnCable old{.law = law};
    old.draw(first, 4096);
    const double stretch = old.memory[0];
    old.draw(0.0, 64);
    DrawnCable after{.law = law.drawn_before(stretch)};
    BOOST_TEST(after.law.rupture == 3.0 - stretch);
    BOOST_TEST(after.law.largest_yield() == law.largest_yield());
    for (const double to : {0.9 * first, first + 0.1, first + 0.5}) {
      old.draw(to, 4096);
      after.draw(to - stretch, 4096);
      BOOST_TEST(after.tension(1.0) == old.tension(1.0), boost::test_tools::tolerance(1e-12));
      BOOST_TEST(after.memory[0] + stretch == old.memory[0], boost::test_tools::tolerance(1e-12));
    }
  }
}

BOOST_AUTO_TEST_CASE(hardening_books_what_is_not_given_back) {
  // Area under the curve to e = 1 minus the stored energy there, T^2/(2k): 0.25 up to the yield at e = 0.25, a
  // trapezium of 2 and 3.2 over 0.75, minus 0.64. The step in which yielding begins is integrated by a trapezium.
  DrawnCable cable{.law = {.stiffness = 8.0, .yield = 2.0, .hardening = 2.0}};
  cable.draw(1.0, 4096);
  const double area = 0.25 + 0.5 * (2.0 + 3.2) * 0.75;
  BOOST_TEST(std::abs(cable.dissipated - (area - 0.64)) < 2.0 / 4096.0);
}

BOOST_AUTO_TEST_CASE(hardening_ends_at_the_strength) {
  DrawnCable cable{.law = {.stiffness = 8.0, .yield = 2.0, .hardening = 2.0, .strength = 3.0}};
  cable.draw(0.8, 4096);  // tension 2.88
  BOOST_TEST(cable.mode == ElasticPlastic::yielding);
  cable.draw(1.0, 4096);
  BOOST_TEST(cable.mode == ElasticPlastic::broken);
}

BOOST_AUTO_TEST_SUITE_END()
