#include "verification/driver/requirements.hpp"

#include <array>
#include <utility>

#include "solver/geometry/shape.hpp"
#include "solver/integrate/integrator_list.hpp"
#include "solver/laws/law_list.hpp"
#include "solver/laws/unilateral_spring.hpp"
#include "solver/model/contact.hpp"
#include "solver/state/state.hpp"

namespace talus::verification {

namespace {

/// The numbered equations of the 1993 report, from the equations of motion to the validation problems.
constexpr std::array equations{
    std::pair{1, "superquadric outline of a body"},
    std::pair{2, "x-motion of an attenuator's centre of mass"},
    std::pair{3, "y-motion of an attenuator's centre of mass"},
    std::pair{4, "rotation of an attenuator"},
    std::pair{5, "resultant x-force on an attenuator: top cable, bottom cable, rock"},
    std::pair{6, "resultant y-force on an attenuator, with its weight"},
    std::pair{7, "resultant moment on an attenuator"},
    std::pair{8, "x-motion of the rock"},
    std::pair{9, "y-motion of the rock, with its weight"},
    std::pair{10, "rotation of the rock"},
    std::pair{11, "initial position of a top cable's end"},
    std::pair{12, "unstretched length of a cable segment from its initial tension"},
    std::pair{13, "current length of a cable segment"},
    std::pair{14, "tension of a cable segment: linear when stretched, none when slack"},
    std::pair{15, "components of a cable's tension"},
    std::pair{16, "resultant of the two cable segments at an attenuator"},
    std::pair{17, "normal contact force: spring and dashpot while overlapping"},
    std::pair{18, "tangential contact force: spring and Coulomb slider"},
    std::pair{19, "viscous part of the normal contact force"},
    std::pair{20, "rate of the overlap from the velocities at the contact point"},
    std::pair{21, "damping coefficient from the coefficient of restitution"},
    std::pair{22, "generalized equation of motion"},
    std::pair{23, "central difference: velocity at the half step"},
    std::pair{24, "central difference: coordinate at the full step"},
    std::pair{25, "step limit 2/omega_max"},
    std::pair{26, "two-cable impact: speed of the struck particle after the impact"},
    std::pair{27, "two-cable impact: speed against cable angle"},
    std::pair{28, "pivoted cylinder: speed of its centre after the impact"},
    std::pair{29, "pivoted cylinder: angular velocity after the impact"},
    std::pair{30, "pivoted cylinder: angular velocity against angle"},
};

void append(std::vector<Requirement>& all, const std::string& group, const std::vector<std::string>& names,
            const std::string& text) {
  for (const auto& name : names)
    all.push_back({group + "." + name, group, text});
}

template <class Enum>
std::vector<std::string> names_of() {
  return {Names<Enum>::list.begin(), Names<Enum>::list.end()};
}

}  // namespace

std::vector<Requirement> all_requirements() {
  std::vector<Requirement> all;
  for (const auto& equation : equations) {
    all.push_back({"Eq. " + std::to_string(equation.first), "equation", equation.second});
  }
  append(all, "law", ContactLaws::names(), "contact law");
  append(all, "law", CableLaws::names(), "cable law");
  append(all, "end_rule", names_of<EndRule>(), "how a contact with a dashpot ends");
  append(all, "method", names_of<ContactMethod>(), "how the overlap of two outlines becomes forces");
  append(all, "mechanism", {mechanism_names.begin(), mechanism_names.end()}, "how energy leaves bodies and springs");
  append(all, "integrator", integrator_names(), "time integration");
  append(all, "shape", shape_names(), "outline of a body");
  return all;
}

}  // namespace talus::verification
