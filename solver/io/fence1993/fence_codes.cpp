#include "solver/io/fence1993/fence_codes.hpp"

namespace talus {
namespace {

constexpr std::string_view an_address = "it was an address in the program of 1993";
constexpr std::string_view a_label = "it is a label of the deck and measures nothing";
constexpr std::string_view old_velocity =
    "it was working memory of the integrator of 1993; codes 6 to 8 are velocities";
constexpr std::string_view of_a_pair = "a contact's stiffness belongs to two elements; the listing prints it";
constexpr std::string_view no_mass_damping = "the model has no mass damping";
constexpr std::string_view no_nodal_springs = "the model has no nodal springs";

// Codes 17 to 22, 33 and 34 are numbers of the deck. Codes 23 to 25 are interpreted as the sum of all loads on the
// element (inferred from their names), 46 to 60 as quantities of the cable segments that lead from the element outwards
// (Appendix II.3.1 (iv)).
constexpr std::array<FenceCode, fence_code_count> codes{{
    {1, "SMALLEST POINTER", "", dimension::number, Needs::body, an_address, nullptr},
    {2, "ELEMENT SHAPE(E.G. SPHERICAL)", "", dimension::number, Needs::body, a_label, nullptr},
    {3, "X - LOCATION OF ELEMENT CENTROID", "x", dimension::length, Needs::body, "",
     [](const FenceSample& s) { return s.pose().p_WB.x; }},
    {4, "Y - LOCATION OF ELEMENT CENTROID", "y", dimension::length, Needs::body, "",
     [](const FenceSample& s) { return s.pose().p_WB.y; }},
    {5, "ELEMENT GLOBAL ROTATION - THETA", "theta", dimension::angle, Needs::body, "",
     [](const FenceSample& s) { return angle(s.dynamics.model(), s.state, *s.member.body); }},
    {6, "X - VELOCITY OF ELEMENT CENTROID", "vx", dimension::velocity, Needs::body, "",
     [](const FenceSample& s) { return s.pose().v_WB.x; }},
    {7, "Y - VELOCITY OF ELEMENT CENTROID", "vy", dimension::velocity, Needs::body, "",
     [](const FenceSample& s) { return s.pose().v_WB.y; }},
    {8, "ANGULAR VELOCITY OF ELEMENT - OMEGA", "omega", dimension::angular_velocity, Needs::body, "",
     [](const FenceSample& s) { return s.pose().w_WB; }},
    {9, "ELEMENT LENGTH X-DIR.", "half_length_x", dimension::length, Needs::body, "",
     [](const FenceSample& s) { return s.element.a; }},
    {10, "ELEMENT LENGTH Y-DIR.", "half_length_y", dimension::length, Needs::body, "",
     [](const FenceSample& s) { return s.element.b; }},
    {11, "POWER OF SUPERQUAD", "power", dimension::number, Needs::body, "",
     [](const FenceSample& s) { return s.element.power; }},
    {12, "NUMBER OF NODAL POINTS ON SUPERQUAD", "points", dimension::number, Needs::body, "",
     [](const FenceSample& s) { return static_cast<double>(s.element.points); }},
    {13, "ATTACHMENT LENGTH (FENCE ONLY) = 0.0 FOR", "attachment_length", dimension::length, Needs::column, "",
     [](const FenceSample& s) { return s.element.bar_length; }},
    {14, "ELEMENT DENSITY", "density", dimension::density, Needs::body, "",
     [](const FenceSample& s) { return s.element.density; }},
    {15, "ELEMENT MASS", "mass", dimension::mass, Needs::body, "", [](const FenceSample& s) { return s.member.mass; }},
    {16, "ELEMENT MASS MOMENT OF INERTIA", "inertia", dimension::inertia, Needs::body, "",
     [](const FenceSample& s) { return s.member.inertia; }},
    {17, "EXTERNAL CENTROIDAL FORCE X-DIR.", "applied_force_x", dimension::force, Needs::body, "",
     [](const FenceSample& s) { return s.element.force.x; }},
    {18, "EXTERNAL CENTROIDAL FORCE Y-DIR.", "applied_force_y", dimension::force, Needs::body, "",
     [](const FenceSample& s) { return s.element.force.y; }},
    {19, "EXTERNAL CENTROIDAL MOMENT", "applied_moment", dimension::moment, Needs::body, "",
     [](const FenceSample& s) { return s.element.moment; }},
    {20, "CENTROIDAL BOUNDARY CONSTRAINT, X-DIR.", "held_x", dimension::number, Needs::body, "",
     [](const FenceSample& s) { return static_cast<double>(s.element.held[0]); }},
    {21, "CENTROIDAL BOUNDARY CONSTRAINT, Y-DIR.", "held_y", dimension::number, Needs::body, "",
     [](const FenceSample& s) { return static_cast<double>(s.element.held[1]); }},
    {22, "CENTROIDAL BOUNDARY CONSTRAINT, ROTATION", "held_rotation", dimension::number, Needs::body, "",
     [](const FenceSample& s) { return static_cast<double>(s.element.held[2]); }},
    {23, "TOTAL APPLIED ELEMENT LOAD, X-DIR.", "load_x", dimension::force, Needs::moving, "",
     [](const FenceSample& s) { return s.load().force.x; }},
    {24, "TOTAL APPLIED ELEMENT LOAD, Y-DIR.", "load_y", dimension::force, Needs::moving, "",
     [](const FenceSample& s) { return s.load().force.y; }},
    {25, "TOTAL APPLIED ELEMENT LOAD, ROTATION", "load_moment", dimension::moment, Needs::moving, "",
     [](const FenceSample& s) { return s.load().moment; }},
    {26, "OLD ELEMENT VELOCITY AT CENTROID X-DIR.", "", dimension::number, Needs::body, old_velocity, nullptr},
    {27, "OLD ELEMENT VELOCITY AT CENTROID Y-DIR.", "", dimension::number, Needs::body, old_velocity, nullptr},
    {28, "OLD ELEMENT VELOCITY AT CENTROID ROT.", "", dimension::number, Needs::body, old_velocity, nullptr},
    {29, "NORMAL CONTACT STIFFNESS", "", dimension::number, Needs::body, of_a_pair, nullptr},
    {30, "SHEAR CONTACT STIFFNESS", "", dimension::number, Needs::body, of_a_pair, nullptr},
    {31, "MASS DAMPING FOR TRANSLATION", "", dimension::number, Needs::body, no_mass_damping, nullptr},
    {32, "MASS DAMPING FOR ROTATION", "", dimension::number, Needs::body, no_mass_damping, nullptr},
    {33, "LOCAL X-COORDINATE OF A FIXED PT. ON ELE", "fixed_point_x", dimension::length, Needs::body, "",
     [](const FenceSample& s) { return s.element.fixed_point.x; }},
    {34, "LOCAL Y-COORDINATE OF A FIXED PT. ON ELE", "fixed_point_y", dimension::length, Needs::body, "",
     [](const FenceSample& s) { return s.element.fixed_point.y; }},
    {35, "ELEMENT KINETIC ENERGY (TRANSLATIONAL)", "kinetic_translation", dimension::energy, Needs::body, "",
     [](const FenceSample& s) { return 0.5 * s.member.mass * dot(s.pose().v_WB, s.pose().v_WB); }},
    {36, "ELEMENT KINETIC ENERGY (ROTATIONAL)", "kinetic_rotation", dimension::energy, Needs::body, "",
     [](const FenceSample& s) { return 0.5 * s.member.inertia * s.pose().w_WB * s.pose().w_WB; }},
    {37, "ELEMENT KINETIC ENERGY (TOTAL)", "kinetic", dimension::energy, Needs::body, "",
     [](const FenceSample& s) {
       return 0.5 *
              (s.member.mass * dot(s.pose().v_WB, s.pose().v_WB) + s.member.inertia * s.pose().w_WB * s.pose().w_WB);
     }},
    {38, "ELEMENT GRAVITATIONAL ENERGY", "gravitational", dimension::energy, Needs::body, "",
     [](const FenceSample& s) { return -s.member.mass * dot(s.dynamics.model().gravity, s.pose().p_WB); }},
    {39, "NODAL SPRING ENERGY (AXIAL)", "", dimension::number, Needs::body, no_nodal_springs, nullptr},
    {40, "NODAL SPRING ENERGY (SHEAR)", "", dimension::number, Needs::body, no_nodal_springs, nullptr},
    {41, "NODAL SPRING ENERGY (BENDING)", "", dimension::number, Needs::body, no_nodal_springs, nullptr},
    {42, "INCREMENTAL SPRING DISPLACEMENT (AXIAL)", "", dimension::number, Needs::body, no_nodal_springs, nullptr},
    {43, "INCREMENTAL SPRING DISPLACEMENT (SHEAR)", "", dimension::number, Needs::body, no_nodal_springs, nullptr},
    {44, "INCREMENTAL SPRING ROTATION", "", dimension::number, Needs::body, no_nodal_springs, nullptr},
    {45, "ELEMENT POTENTIAL ENERGY (GRAVIT. & SPRI", "", dimension::number, Needs::body, no_nodal_springs, nullptr},
    {46, "TOP CABLE LENGTH", "top_length", dimension::length, Needs::top, "",
     [](const FenceSample& s) { return s.path(s.member.top).length; }},
    {47, "BOTTOM CABLE LENGTH", "bottom_length", dimension::length, Needs::bottom, "",
     [](const FenceSample& s) { return s.path(s.member.bottom).length; }},
    {48, "TENSION IN TOP CABLE", "top_tension", dimension::force, Needs::top, "",
     [](const FenceSample& s) { return s.tension(s.member.top); }},
    {49, "X-COMPONENT OF TENSION IN TOP CABLE", "top_tension_x", dimension::force, Needs::top, "",
     [](const FenceSample& s) { return s.pull(s.member.top).x; }},
    {50, "Y-COMPONENT OF TENSION IN TOP CABLE", "top_tension_y", dimension::force, Needs::top, "",
     [](const FenceSample& s) { return s.pull(s.member.top).y; }},
    {51, "FORCE IN TOP JOINT OF ATTENUATOR", "top_joint_force", dimension::force, Needs::top, "",
     [](const FenceSample& s) { return s.joint_force(); }},
    {52, "TENSION IN BOTTOM CABLE", "bottom_tension", dimension::force, Needs::bottom, "",
     [](const FenceSample& s) { return s.tension(s.member.bottom); }},
    {53, "X-COMPONENT OF TENSION IN BOTTOM CABLE", "bottom_tension_x", dimension::force, Needs::bottom, "",
     [](const FenceSample& s) { return s.pull(s.member.bottom).x; }},
    {54, "Y-COMPONENT OF TENSION IN BOTTOM CABLE", "bottom_tension_y", dimension::force, Needs::bottom, "",
     [](const FenceSample& s) { return s.pull(s.member.bottom).y; }},
    {55, "STIFFNESS OF TOP CABLE", "top_stiffness", dimension::stiffness, Needs::top, "",
     [](const FenceSample& s) { return s.law(s.member.top).stiffness; }},
    {56, "STIFFNESS OF BOTTOM CABLE", "bottom_stiffness", dimension::stiffness, Needs::bottom, "",
     [](const FenceSample& s) { return s.law(s.member.bottom).stiffness; }},
    {57, "INITIAL LENGTH OF BOTTOM CABLE", "bottom_rest_length", dimension::length, Needs::bottom, "",
     [](const FenceSample& s) { return s.cable(s.member.bottom).rest_length; }},
    {58, "BREAKING STRENGTH OF TOP CABLE", "top_limit", dimension::force, Needs::top, "",
     [](const FenceSample& s) { return s.law(s.member.top).yield; }},
    {59, "BREAKING STRENGTH OF BOTTOM CABLE", "bottom_limit", dimension::force, Needs::bottom, "",
     [](const FenceSample& s) { return s.law(s.member.bottom).yield; }},
    {60, "TOP CABLE PLASTIC DEFORMATION (FT)", "top_plastic_stretch", dimension::length, Needs::top, "",
     [](const FenceSample& s) { return s.stretch(s.member.top); }},
    {61, "LARGEST POINTER (CHECK WITH NPRMAX !)", "", dimension::number, Needs::body, an_address, nullptr},
}};

}  // namespace

Wrench FenceSample::load() const {
  const Model& model = dynamics.model();
  const Body& body = model.bodies[index(*member.body)];
  const Wrench laws = work.wrenches[index(*member.body)];
  return {laws.force + body.force + body.mass * model.gravity, laws.moment + body.moment};
}

double FenceSample::joint_force() const {
  return norm(work.joints.force(dynamics.cables().ends()[index(*member.top)].a));
}

const std::array<FenceCode, fence_code_count>& fence_codes() { return codes; }

}  // namespace talus
