#include "verification/driver/requirements.hpp"

#include <algorithm>
#include <array>
#include <cctype>
#include <utility>

#include "solver/geometry/shape.hpp"
#include "solver/integrate/integrator_list.hpp"
#include "solver/laws/coulomb_friction.hpp"
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

/// The catalogue of problems with an exact solution, by family. Each is a problem of its own, not a number of one.
struct Problem {
  const char* id;
  const char* text;
};

constexpr std::array problems{
    Problem{"A1", "free flight under gravity, with spin"},
    Problem{"A2", "area, centroid and moment of inertia of polygons and rectangles"},
    Problem{"A3", "area and moment of inertia of superellipses"},
    Problem{"A4", "momentum, angular momentum and energy of colliding discs"},
    Problem{"A5", "time reversal of undamped velocity Verlet"},
    Problem{"A6", "translation, mirror, exchange of bodies, rotation, moving frame: the same answer"},
    Problem{"A7", "powers of two in length, mass and time: the same bits"},
    Problem{"A8", "round-off in double, long double and quadruple precision"},
    Problem{"B1", "disc on a wall, undamped: restitution, contact time, overlap"},
    Problem{"B2", "damped contact that may pull: restitution, time, pull at the end"},
    Problem{"B3", "damped contact that ends with its force: restitution, time"},
    Problem{"B4", "largest overlap of a damped contact"},
    Problem{"B5", "two discs of unlike mass in a moving frame"},
    Problem{"B6", "bounces under gravity on a spring and dashpot"},
    Problem{"B7", "bounces as the contact grows stiff"},
    Problem{"B8", "three discs in a row struck by the first"},
    Problem{"B9", "column of discs at rest under its weight"},
    Problem{"B10", "two discs pressed between walls: normal modes"},
    Problem{"B11", "latching spring: restitution, time, residual overlap"},
    Problem{"B12", "latching spring whose unloading stiffens with the force"},
    Problem{"B13", "reloading within the latching spring's loop"},
    Problem{"B14", "latching spring in steps: restitution by four methods"},
    Problem{"B15", "row of discs that latch, struck by the first"},
    Problem{"B16", "discs struck anew before they part: what latches remember"},
    Problem{"C1", "disc that slides until it rolls"},
    Problem{"C2", "disc on an incline, on both sides of sliding"},
    Problem{"C3", "block on an incline, on both sides of sliding"},
    Problem{"C4", "oblique impact that slides all through"},
    Problem{"C5", "oblique impact that sticks all through, k_s = k_n/3"},
    Problem{"C6", "oblique impacts at other k_s/k_n"},
    Problem{"C7", "grazing impacts gain no energy"},
    Problem{"C8", "a locked pair turned as one: the friction spring turns with it"},
    Problem{"C9", "closed path of a sticking contact: no net work"},
    Problem{"C10", "cyclic shear: area of the loop"},
    Problem{"C11", "small disc between large ones: time levels of friction"},
    Problem{"C12", "order of an oblique impact: time level of the slip"},
    Problem{"D1", "fall into a cable"},
    Problem{"D2", "fall into a cable with a dashpot that cannot push"},
    Problem{"D3", "cable that yields without hardening"},
    Problem{"D4", "cable that hardens, several cycles"},
    Problem{"D5", "mass between two straight unstretched cables"},
    Problem{"D6", "chain of masses under tension: frequencies"},
    Problem{"D7", "hanging chain: catenary as the links stiffen"},
    Problem{"D8", "slack, taut, slack with onset at any phase"},
    Problem{"D9", "cable that breaks, on both sides of its strength"},
    Problem{"E1", "superellipse on a wall at all angles"},
    Problem{"E2", "pairs of superellipses, against brute force"},
    Problem{"E3", "ellipse that rocks on a plane"},
    Problem{"E4", "disc of M corners that rolls"},
    Problem{"E5", "curvature of superellipses at the rounded corner"},
    Problem{"E6", "force as the slope of the stored energy"},
    Problem{"E7", "square dropped on an edge, on a corner, and nearly so"},
    Problem{"E8", "slide round a corner and back: work of a closed path"},
    Problem{"E9", "block that rocks from corner to corner"},
    Problem{"E10", "contact search against all pairs"},
    Problem{"F1", "gas of inelastic discs that cools"},
    Problem{"F2", "triangular lattice: step at which it grows unstable"},
    Problem{"F3", "shear cell: serial and threaded, grid and all pairs"},
    Problem{"F4", "shear cell: stress inside against force on the walls"},
    Problem{"F5", "restart at half time: the same bits"},
    Problem{"F6", "gas of inelastic discs in uniform shear"},
    Problem{"F7", "dense flow of discs of unlike size"},
};

constexpr std::array families{"A: motion and bodies",   "B: normal contact", "C: friction and rotation", "D: cables",
                              "E: outlines in contact", "F: many bodies",    "founding problems",        "the fence",
                              "the shear cell",         "speed and accuracy"};

/// Is it the id of a problem of the catalogue: a letter and a number?
bool is_problem(const std::string& id) {
  return id.size() > 1 && id[0] >= 'A' && id[0] <= 'F' && std::isdigit(static_cast<unsigned char>(id[1])) != 0;
}

/// "A: motion and bodies" for "A4".
std::string family_of_problem(const std::string& id) { return families[static_cast<std::size_t>(id.front() - 'A')]; }

void append(std::vector<Requirement>& all, const std::string& group, const std::vector<std::string>& names,
            const std::string& text) {
  for (const auto& name : names)
    all.push_back({group + "." + name, group, text});
}

/// The regimes of a law: its modes from `first` on. That a contact is open, mode 0, is no regime; that a cable is slack
/// is one.
template <class Law>
void append_regimes(std::vector<Requirement>& all, std::size_t first, const std::string& name,
                    const std::string& what) {
  for (std::size_t mode = first; mode < Law::modes.size(); ++mode)
    append(all, "regime", {name + "." + std::string{Law::modes[mode]}}, "mode of a " + what);
}

/// The pairs of outlines that can touch: ground does not touch ground, and what has no outline touches nothing.
void append_pairs(std::vector<Requirement>& all) {
  const std::vector<std::string> names = shape_names();
  const auto ground = [](const std::string& name) { return name == HalfPlane::name || name == Terrain::name; };
  for (std::size_t a = 0; a < names.size(); ++a) {
    for (std::size_t b = a; b < names.size(); ++b) {
      if (names[a] == NoShape::name || (ground(names[a]) && ground(names[b]))) continue;
      append(all, "pair", {names[a] + "." + names[b]}, "outlines in contact");
    }
  }
}

void append_integrators(std::vector<Requirement>& all) {
  for (const std::string& name : integrator_names()) {
    append(all, "integrator", {name}, "time integration");
    // The tolerance changes no order.
    all.back().order = order(make_integrator(name, needs_tolerance(name) ? 1e-9 : 0.0));
  }
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
  for (const Problem& problem : problems)
    all.push_back({problem.id, family_of_problem(problem.id), problem.text});
  append(all, "law", ContactLaws::names(), "contact law");
  append(all, "law", CableLaws::names(), "cable law");
  append(all, "end_rule", names_of<EndRule>(), "how a contact with a dashpot ends");
  append(all, "method", names_of<ContactMethod>(), "how the overlap of two outlines becomes forces");
  append(all, "mechanism", {mechanism_names.begin(), mechanism_names.end()}, "how energy leaves bodies and springs");
  append_integrators(all);
  append(all, "shape", shape_names(), "outline of a body");
  append_pairs(all);
  ContactLaws::for_each([&](auto law) { append_regimes<decltype(law)>(all, 1, std::string{law.name}, "contact law"); });
  append_regimes<CoulombFriction>(all, 1, "friction", "friction law");
  CableLaws::for_each([&](auto law) { append_regimes<decltype(law)>(all, 0, std::string{law.name}, "cable law"); });
  return all;
}

std::vector<std::string> all_families() { return {families.begin(), families.end()}; }

std::string family_of(const std::string& named, const std::vector<std::string>& requirements) {
  if (!named.empty()) return named;
  std::array<int, families.size()> problems_of{};
  for (const std::string& id : requirements) {
    if (is_problem(id)) ++problems_of[static_cast<std::size_t>(id.front() - 'A')];
  }
  const auto most = std::max_element(problems_of.begin(), problems_of.end());
  return *most == 0 ? "" : families[static_cast<std::size_t>(most - problems_of.begin())];
}

}  // namespace talus::verification
