#pragma once

#include <algorithm>
#include <boost/test/unit_test.hpp>
#include <cmath>
#include <string>
#include <vector>

#include "solver/cell/cell_run.hpp"

/// Cells of all laws, plans for them, and functions shared by the tests of their runs.
namespace talus {

inline CoulombFriction rough_example(CoulombFriction, double) { return {0.5, 1.4e4}; }
inline Mindlin rough_example(Mindlin, double radius) { return {0.5, 4e8, radius}; }

/// A cell of each law, smooth and with each friction that it can have: contact times of all are similar.
inline std::vector<ShearCell> cells() {
  std::vector<ShearCell> all;
  for (const DiscLaw& law : std::vector<DiscLaw>{
           LatchingSpring{1.7e4, 1.7e4 / 0.49, 0.0}, LatchingSpring{1.7e4, 2e4, 0.01}, LinearSpringDashpot{2e4, 0.0},
           LinearSpringDashpot{2e4, 0.02}, LinearSpringDashpot{2e4, 0.02, EndRule::attractive},
           Hertz{7e8, 2.5e-4, 0.08, EndRule::clamped, HertzDashpot::tsuji},
           Hertz{7e8, 2.5e-4, 0.02, EndRule::attractive, HertzDashpot::constant},
           HuntCrossley{4.5e4, 1e-5, 1.5, 0.5}}) {
    ShearCell cell = ice_cell(8e3, 5e3);
    cell.law = law;
    all.push_back(cell);
    const auto add_rough = [&]<class L, class F>(const L& of, const F&) {
      if constexpr (CanHaveFriction<L, F>) {
        double radius = 0.0;
        if constexpr (HasContactRadius<L>) radius = of.radius;
        cell.friction = rough_example(F{}, radius);
        all.push_back(cell);
      }
    };
    DiscFrictions::for_each(
        [&](const auto& friction) { std::visit([&](const auto& of) { add_rough(of, friction); }, law); });
  }
  return all;
}

/// Methods that are allowed for the cell.
inline std::vector<std::string> methods(const ShearCell& cell) {
  std::vector<std::string> names = disc_method_names();
  std::erase_if(names, [&](const std::string& name) {
    return cell.law_of_1989() == nullptr && integrator_traits(name).amplitude_growth_rate != 0.0;
  });
  return names;
}

inline CellPlan plan(const ShearCell& cell, double contacts, double steps_in_contact = 20.0) {
  const double step = cell.contact_time() / steps_in_contact;
  return {.step = step, .every = contacts / 4.0 * cell.contact_time(), .end = contacts * cell.contact_time()};
}

/// Largest difference of positions [L].
inline double apart(CellRun& one_run, CellRun& other_run) {
  const Discs one = one_run.discs(), other = other_run.discs();
  const double width = one_run.cell().width();
  double maximum = 0.0;
  for (std::size_t i = 0; i < one.size(); ++i) {
    const double x = one.x[i] - other.x[i];
    maximum = std::max({maximum, std::abs(x - width * std::round(x / width)), std::abs(one.y[i] - other.y[i])});
  }
  return maximum;
}

inline CellRun& run(CellRun& cell) {
  while (!cell.finished())
    cell.advance();
  BOOST_TEST(cell.failure().empty());
  return cell;
}

}  // namespace talus
