#include "verification/driver/peers.hpp"

namespace talus::verification {

namespace {

// A sphere has I = 2 m r^2/5, a disc m r^2/2: 2/7 and 5/7 become 1/3 and 2/3, 5/2 becomes 2, 7/2 becomes 3.

void append_mfix(std::vector<PeerCheck>& all) {
  const char* suite = "mfix";
  all.push_back({suite,
                 "DEM01",
                 "particle falls on a wall and bounces, linear spring and dashpot",
                 "fall, contact and rise in three closed stages",
                 {"B6"}});
  all.push_back({suite,
                 "DEM02",
                 "bounces as the spring grows stiff",
                 "heights $(h_0 - r)e^{2k} + r$ of hard spheres",
                 {"B6", "B7"}});
  all.push_back({suite,
                 "DEM03",
                 "two particles pressed between walls",
                 "two coupled linear equations of motion",
                 {"B10"},
                 "by normal modes"});
  all.push_back({suite,
                 "DEM04",
                 "particle set down on a rough floor with $u_0$",
                 "rolls from $t_s = 2u_0/(7\\mu g)$ on; disc: $u_0/(3\\mu g)$",
                 {"C1"}});
  all.push_back({suite,
                 "DEM05",
                 "oblique impacts on a wall, linear and Hertzian",
                 "measured: Kharaz, Gorham and Salman 2001",
                 {"C4", "C5", "C6"},
                 "against exact solutions of the linear law; the measurements are of spheres"});
  all.push_back({suite,
                 "DEM06",
                 "particle at its terminal velocity in a gas",
                 "drag of Schiller and Naumann balances the weight",
                 {},
                 "no fluid here"});
}

void append_lammps(std::vector<PeerCheck>& all) {
  const char* suite = "lammps";
  all.push_back({suite, "`freefall`", "fall before any contact", "$z_0 - gt^2/2$, $-gt$", {"A1"}});
  all.push_back({suite,
                 "`collision_restitution`",
                 "two equal spheres head-on",
                 "relative speed turned by $-e$, momentum nought",
                 {"A4", "B5"},
                 "at all ratios of the masses"});
  all.push_back({suite, "`wall_restitution`", "sphere bounces off a wall", "$-e v$", {"B2", "B3"}});
  all.push_back({suite,
                 "`hertz_normal_impact`, `hertz_peak`",
                 "Hertzian impact at its deepest",
                 "$\\frac12 m v^2 = \\frac25 P\\alpha$; $\\alpha = (5mv^2/4k)^{2/5}$",
                 {"law.hertz"}});
  all.push_back({suite,
                 "`stack_energy`",
                 "two spheres pressed between walls, undamped",
                 "energy stays",
                 {"B10"},
                 "by the motion itself"});
  all.push_back({suite,
                 "`oblique_impact`, `oblique_impact_pair`",
                 "oblique impact that slides all through",
                 "loses $\\mu(1+e)v_n$, spin $\\frac52\\mu(1+e)v_n/r$; disc: 2 for 5/2",
                 {"C4"}});
  all.push_back({suite, "`energy_dissipation`", "grazing impact with friction", "energy does not grow", {"C7"}});
  all.push_back({suite,
                 "`slip_transient`, `slip_cessation`",
                 "sphere slides until it rolls",
                 "$u_0 - \\mu g t$; rolls at $\\frac57u_0$; disc: $\\frac23u_0$",
                 {"C1"}});
  all.push_back({suite,
                 "`spin_impact`",
                 "spinning sphere meets a wall head-on, slides all through",
                 "$v_x = \\mu(1+e)v$, $\\omega_0 - \\frac52\\mu(1+e)v/r$",
                 {"C4"},
                 "the slip rate as a speed along the plane: nothing else enters"});
  all.push_back({suite,
                 "`spin_no_friction`",
                 "head-on, spins such that nothing slips",
                 "spin stays, no tangential speed",
                 {"C6"},
                 "`spinning_discs`"});
  all.push_back({suite,
                 "`momentum_conservation`",
                 "two particles collide off centre",
                 "momentum and angular momentum stay",
                 {"A4"}});
  all.push_back({suite,
                 "`incline_rolling`",
                 "sphere rolls down an incline, with rolling resistance",
                 "$\\frac57g(\\sin\\theta - \\mu_r\\cos\\theta)$",
                 {"C2"},
                 "without rolling resistance, $\\frac23g\\sin\\theta$ for a disc"});
  all.push_back({suite,
                 "`rolling_decay`, `twist_decay...`",
                 "spin damped by rolling or twisting resistance",
                 "falls in proportion to time",
                 {},
                 "no such law here; twisting needs a third dimension"});
  all.push_back({suite,
                 "`pulloff_dmt`, `pulloff_jkr`",
                 "cohesive contact let go",
                 "$4\\pi\\gamma R$; $\\frac83\\pi\\gamma R$",
                 {},
                 "no cohesion here"});
  all.push_back({suite,
                 "`terminal_velocity...`, `heat_equilibration`",
                 "drag; heat conducted between spheres",
                 "$mg/\\gamma$; exchange of heat",
                 {},
                 "no fluid, no heat here"});
}

void append_chung_ooi(std::vector<PeerCheck>& all) {
  const char* suite = "chung2011";
  all.push_back({suite,
                 "test 1",
                 "elastic normal impact of two identical spheres",
                 "Hertz: force against time and overlap",
                 {"law.hertz", "B5"},
                 "Hertz on a plane; two bodies with the linear law"});
  all.push_back(
      {suite, "test 2", "elastic normal impact of a sphere on a rigid plane", "Hertz, as test 1", {"law.hertz"}});
  all.push_back({suite,
                 "test 3",
                 "normal impact with other coefficients of restitution",
                 "speed after over speed before $= e$",
                 {"B2", "B3", "law.hertz"}});
  all.push_back({suite,
                 "test 4",
                 "oblique impact on a plane, one speed, other angles",
                 "tangential restitution, spin, rebound angle; measured, and sliding in closed form",
                 {"C4", "C5", "C6"}});
  all.push_back({suite,
                 "test 5",
                 "oblique impact, one normal speed, other tangential ones",
                 "rebound against incidence, in units of $\\mu v_n$",
                 {"C5", "C6"}});
  all.push_back({suite,
                 "test 6",
                 "impact on a plane, one normal speed, other spins",
                 "tangential speed and spin afterwards",
                 {"C4", "C6"},
                 "only the slip rate enters"});
  all.push_back({suite,
                 "test 7",
                 "two identical spheres head-on, opposite spins",
                 "no tangential force: spins stay",
                 {"C6"},
                 "`spinning_discs`"});
  all.push_back({suite, "test 8", "two spheres of unlike size, one spins", "as test 6", {"C6"}, "`spinning_discs`"});
}

}  // namespace

std::vector<PeerCheck> all_peer_checks() {
  std::vector<PeerCheck> all;
  append_mfix(all);
  append_lammps(all);
  append_chung_ooi(all);
  return all;
}

}  // namespace talus::verification
