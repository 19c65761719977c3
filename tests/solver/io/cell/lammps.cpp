#include "solver/io/cell/lammps.hpp"

#include <algorithm>
#include <boost/test/unit_test.hpp>
#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <random>
#include <sstream>
#include <utility>

#include "solver/base/error.hpp"
#include "solver/granular/disc_system.hpp"
#include "solver/integrate/velocity_verlet.hpp"
#include "tests/temporary_folder.hpp"

BOOST_AUTO_TEST_SUITE(lammps_tests)

using namespace talus;
namespace fs = std::filesystem;

namespace {

constexpr double step = 2e-3;
constexpr long steps = 400;

bool has_lammps() {
  const bool found = std::system("command -v lmp > /dev/null 2>&1") == 0;
  if (!found) BOOST_TEST_MESSAGE("lmp is not installed (Debian: apt-get install lammps): nothing was compared");
  return found;
}

/// Discs of different size, some of them overlapping, with random velocities, over a floor of held discs.
LammpsScene scene(const std::variant<LinearSpringDashpot, Hertz>& law, const PeriodicBox& box, bool walls,
                  double spread = 0.1) {
  std::mt19937 random{5};
  std::uniform_real_distribution<double> unit{-1.0, 1.0};
  LammpsScene made{.shapes = {}, .discs = {}, .box = box, .law = law};
  for (int i = 0; i < 100; ++i) {
    const double radius = 1.0 + spread * unit(random);
    made.shapes.add(radius, 1.0 / (radius * radius));
    made.discs.add(2.05 * (i % 10 - 4.5) + 0.2 * unit(random), 2.05 * (i / 10 - 4.5) + 0.2 * unit(random),
                   2.0 * unit(random), 2.0 * unit(random));
  }
  if (!walls) return made;
  const std::size_t floor = made.shapes.add(DiscWall{}), lid = made.shapes.add(DiscWall{.mass = 20.0, .gravity = 3.0});
  for (const std::size_t wall : {floor, lid}) {
    for (int i = 0; i < 10; ++i) {
      made.shapes.add(1.0, 0.0, wall);
      made.discs.add(2.1 * (i - 4.5), wall == floor ? -11.2 : 11.2, wall == floor ? 0.0 : 0.5, 0.0);
    }
  }
  return made;
}

struct Answer {
  std::vector<Vec2> forces;
  std::vector<double> energies;
};

Answer lammps(const LammpsScene& given, LammpsRun::Style style, bool newton, double h = step, long count = steps) {
  const Folder made;
  const fs::path& folder = made.path;
  export_lammps(folder, given, {.step = h, .steps = count, .skin = 0.6, .style = style, .newton = newton});
  // Alone, without the daemon of Open MPI, whose start takes seconds where a service that it looks for does not answer.
  const std::string command =
      "cd '" + folder.string() + "' && OMPI_MCA_ess_singleton_isolated=1 lmp -in in.discs > screen.txt 2>&1";
  Answer answer;
  BOOST_REQUIRE_MESSAGE(std::system(command.c_str()) == 0, "lmp failed in " + folder.string());
  std::ifstream forces{folder / "forces.txt"};
  std::string line;
  while (std::getline(forces, line) && line.rfind("ITEM: ATOMS", 0) != 0) {
  }
  std::size_t id{};
  Vec2 position, force;
  while (answer.forces.size() < given.discs.size() && forces >> id >> position.x >> position.y >> force.x >> force.y)
    answer.forces.push_back(force);
  std::ifstream log{folder / "log.lammps"};
  for (bool within = false; std::getline(log, line);) {
    if (line.rfind("Loop time", 0) == 0) within = false;
    long at{};
    double energy{};
    if (within && std::istringstream{line} >> at >> energy) answer.energies.push_back(energy);
    if (line.rfind("Step", 0) == 0) within = true, answer.energies.clear();
  }
  return answer;
}

/// The same computed by Talus.
template <class L>
Answer talus_answer(const LammpsScene& given, const L& law) {
  DiscSystem system{given.shapes, given.box, law, 0.6};
  Discs discs = given.discs;
  system.begin(discs);
  Answer answer;
  answer.forces.resize(discs.size());
  DiscRates rates{discs};
  system.evaluate(discs, rates);
  for (std::size_t i = 0; i < discs.size(); ++i) {
    if (given.shapes.inverse_mass[i] > 0.0)
      answer.forces[i] = (1.0 / given.shapes.inverse_mass[i]) * Vec2{rates.vx[i], rates.vy[i]};
  }
  const auto energy = [&] {
    double sum = 0.0;
    for (std::size_t i = 0; i < discs.size(); ++i) {
      if (given.shapes.inverse_mass[i] > 0.0)
        sum += 0.5 * (discs.vx[i] * discs.vx[i] + discs.vy[i] * discs.vy[i]) / given.shapes.inverse_mass[i];
    }
    return sum;
  };
  VelocityVerletOf<Discs> stepper;
  stepper.start(system, discs, step);
  for (long n = 0; n <= steps; ++n) {
    if (n % (steps / 10) == 0) answer.energies.push_back(energy());
    stepper.step(system, discs, step);
  }
  return answer;
}

void compare(const LammpsScene& given, LammpsRun::Style style, bool newton) {
  const Answer theirs = lammps(given, style, newton);
  const Answer ours = std::visit([&](const auto& law) { return talus_answer(given, law); }, given.law);
  BOOST_TEST_REQUIRE(theirs.forces.size() == ours.forces.size());
  double largest = 0.0, apart = 0.0;
  for (std::size_t i = 0; i < ours.forces.size(); ++i) {
    largest = std::max(largest, norm(ours.forces[i]));
    if (given.shapes.wall[i] == DiscShapes::free) apart = std::max(apart, norm(ours.forces[i] - theirs.forces[i]));
  }
  BOOST_TEST(largest > 1.0);
  // Both compute each overlap from positions of some tens of diameters: 1e-15, for overlaps of a tenth.
  BOOST_TEST(apart < 1e-12 * largest);
  BOOST_TEST_REQUIRE(theirs.energies.size() == ours.energies.size());
  // Round-off grows with each impact, and some discs have had three by the end.
  for (std::size_t k = 0; k < ours.energies.size(); ++k)
    BOOST_TEST(ours.energies[k] == theirs.energies[k], boost::test_tools::tolerance(1e-9));
  BOOST_TEST(std::abs(ours.energies.front() - ours.energies.back()) > 0.01 * ours.energies.front());
}

}  // namespace

namespace {

/// Two discs that graze each other and separate with spin.
LammpsScene grazing(const std::variant<LinearSpringDashpot, Hertz>& law, const DiscFriction& friction) {
  LammpsScene scene{.shapes = {}, .discs = {}, .box = {.width = 20.0, .height = 20.0}, .law = law};
  scene.friction = friction;
  scene.shapes.add(1.0, 1.0), scene.shapes.add(1.0, 1.0);
  scene.discs.add(-1.1, 0.0, 0.5, 0.0), scene.discs.add(1.1, 0.0, -0.5, 0.7);
  return scene;
}

/// Kinetic energy after the impact, without that of spin, by LAMMPS and by Talus.
template <class L, class F>
std::pair<double, double> grazed(const L& law, const F& friction, LammpsRun::Style style) {
  const LammpsScene scene = grazing(law, friction);
  constexpr double h = 0.1 * step;
  const Answer theirs = lammps(scene, style, true, h, 10 * steps);
  DiscSystem system{scene.shapes, scene.box, law, 0.6, friction};
  Discs discs = scene.discs;
  system.begin(discs);
  VelocityVerletOf<Discs> stepper;
  stepper.start(system, discs, h);
  for (long n = 0; n < 10 * steps; ++n)
    stepper.step(system, discs, h);
  double energy = 0.0;
  for (std::size_t i = 0; i < 2; ++i)
    energy += 0.5 * (discs.vx[i] * discs.vx[i] + discs.vy[i] * discs.vy[i]);
  return {theirs.energies.back(), energy};
}

/// The energy before, which discs without friction would keep.
constexpr double before_grazing = 0.5 * (0.25 + 0.25 + 0.49);

}  // namespace

BOOST_AUTO_TEST_CASE(lammps_turns_discs_by_friction_alike) {
  if (!has_lammps()) return;
  // LAMMPS applies friction at the radius of the discs, a difference of an overlap of 0.01.
  for (const auto style : {LammpsRun::Style::granular, LammpsRun::Style::gran_hooke}) {
    for (const double coefficient : {0.1, 5.0}) {
      const auto [theirs, ours] = grazed(LinearSpringDashpot{4e3, 0.0}, CoulombFriction{coefficient, 3e3}, style);
      BOOST_TEST(theirs == ours, boost::test_tools::tolerance(0.01));
      BOOST_TEST(ours < 0.97 * before_grazing);
    }
  }
}

BOOST_AUTO_TEST_CASE(lammps_rescales_mindlins_force_alike) {
  if (!has_lammps()) return;
  // The radius is not that of the discs. Stiff contacts have small overlaps, and so differ little by the radius at
  // which friction is applied. A contact lasts some 300 steps.
  for (const double coefficient : {0.1, 0.4, 5.0}) {
    const auto [theirs, ours] = grazed(Hertz{2e4, 0.8}, Mindlin{coefficient, 1.5e4, 0.8}, LammpsRun::Style::granular);
    BOOST_TEST(theirs == ours, boost::test_tools::tolerance(0.005));
    BOOST_TEST(ours < 0.97 * before_grazing);
  }
}

BOOST_AUTO_TEST_CASE(lammps_finds_the_same_forces_and_energies) {
  if (!has_lammps()) return;
  const PeriodicBox box{.width = 21.0, .height = 22.0};
  const LinearSpringDashpot elastic{4e3, 0.0};
  for (const auto style : {LammpsRun::Style::granular, LammpsRun::Style::gran_hooke}) {
    for (const bool newton : {true, false})
      compare(scene(elastic, box, false), style, newton);
  }
  compare(scene(elastic, {}, false), LammpsRun::Style::gran_hooke, true);
  for (const EndRule rule : {EndRule::clamped, EndRule::attractive})
    compare(scene(LinearSpringDashpot{4e3, 20.0, rule}, box, false), LammpsRun::Style::granular, true);
  compare(scene(elastic, {.width = 21.0}, true), LammpsRun::Style::granular, true);
  // Hertz's law, with a radius other than that of the discs.
  for (const EndRule rule : {EndRule::clamped, EndRule::attractive}) {
    const Hertz hertz{1e4, 0.8, 20.0, rule, HertzDashpot::constant};
    compare(scene(hertz, box, false, 0.0), LammpsRun::Style::granular, true);
  }
  compare(scene(Hertz{1e4, 0.8}, {.width = 21.0}, true, 0.0), LammpsRun::Style::granular, true);
}

BOOST_AUTO_TEST_CASE(what_lammps_does_not_have_is_refused) {
  const LinearSpringDashpot dashpot{4e3, 3.0};
  const LammpsScene sliding = scene(dashpot, {.width = 21.0, .height = 22.0, .shear_rate = 0.1}, false);
  BOOST_CHECK_THROW(static_cast<void>(lammps_data(sliding)), InputError);
  BOOST_CHECK_THROW(static_cast<void>(lammps_input(sliding, {.style = LammpsRun::Style::gran_hooke}, "x")), InputError);
  const auto refused = [](const Hertz& law, double spread, LammpsRun::Style style, const std::string& expected) {
    const LammpsScene given = scene(law, {.width = 21.0, .height = 22.0}, false, spread);
    BOOST_CHECK_EXCEPTION(static_cast<void>(lammps_input(given, {.style = style}, "x")), InputError,
                          [&](const InputError& error) { return error.what() == expected; });
  };
  const Hertz constant{1e4, 0.8, 20.0, EndRule::clamped, HertzDashpot::constant};
  refused({1e4, 0.8, 20.0}, 0.0, LammpsRun::Style::granular,
          "dashpot: found tsuji, which LAMMPS sets by another number; it must be constant");
  refused(constant, 0.1, LammpsRun::Style::granular,
          "law: found hertz with discs of different size; for LAMMPS they must be equal");
  refused(constant, 0.0, LammpsRun::Style::gran_hooke,
          "law: found hertz; for the style gran/hooke it must be linear_spring_dashpot");
  const auto refused_friction = [](LammpsRun::Style style, const std::string& expected) {
    const LammpsScene given = grazing(LinearSpringDashpot{4e3, 0.0}, Mindlin{0.3, 1e4, 0.5});
    BOOST_CHECK_EXCEPTION(static_cast<void>(lammps_input(given, {.style = style}, "x")), InputError,
                          [&](const InputError& error) { return error.what() == expected; });
  };
  refused_friction(LammpsRun::Style::gran_hooke,
                   "shear_law: found mindlin; for the style gran/hooke it must be linear");
  refused_friction(
      LammpsRun::Style::granular,
      "shear_law: found mindlin with linear_spring_dashpot, which has no contact radius; it must be linear");
}

BOOST_AUTO_TEST_SUITE_END()
