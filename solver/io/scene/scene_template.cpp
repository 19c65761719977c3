#include "solver/io/scene/scene_template.hpp"

#include <algorithm>
#include <utility>

#include "solver/base/error.hpp"

namespace talus {
namespace {

/// `<a|b>` becomes a in a file in SI units and b in one in US units.
constexpr std::string_view fence_template =
    R"(# A rockfall fence: columns of tyres hang side by side from a top cable, a bottom cable ties them together, and a
# rock hits the central column. x is horizontal across the fence (the rock comes from the right), y is up, z along it.
#   talus check FILE                       lists bodies, contacts and the expected cost
#   talus run FILE --sheet --out DIR       runs it: summary here; sheet, histories and geometry in DIR
#   talus list fields                      every field that a file can have, with unit and default
# Lines that begin with "# " and a field name are optional fields with their defaults or an example.
title = "Rockfall fence hit by a rock of <700 kg at 10 m/s|1500 lb at 33 ft/s>"
units = "<SI|US>" # <kg, m, s, N|slug, ft, s, lbf>; a quantity may have any other unit

[fence]
columns = 15 # columns in a layer, evenly about mid-span
spacing = "<0.8 m|2.5 ft>" # distance of neighbouring columns, centre to centre
span = "<16 m|50 ft>" # of the top cable between its anchors
sag = "<1.5 m|5 ft>" # of the top cable at mid-span, under the weight of the columns
y_top = "<1.5 m|5 ft>" # joint of a column and the top cable, above the column's centre
y_bottom = "<-1 m|-3 ft>" # joint of a column and the bottom cable; negative: below the centre
young = "<100 GPa|15e6 psi>" # Young's modulus of both cables
area_top = "<400 mm^2|0.6 in^2>" # cross-section of the top cable
area_bottom = "<200 mm^2|0.3 in^2>" # cross-section of the bottom cable
limit_top = "<400 kN|90 kip>" # yield force of the top cable
limit_bottom = "<300 kN|70 kip>" # yield force of the bottom cable
restitution = 0.4 # of all contacts, in (0, 1]
penetration = 0.05 # largest overlap over the rock's radius; sets the contact stiffness
duration = "0.8 s" # time that the run lasts
friction = 0.3 # Coulomb coefficient of all contacts (default 0)
# slack = "<0.1 m|4 in>" # of the bottom cable between two columns (default 0)
# connections = 1 # 2: top and bottom cable (default); 1: top cable only
# layers = 2 # two layers of columns (default 1) need layer_spacing
# layer_spacing = "<0.9 m|3 ft>" # distance of the layers, centre to centre
# gravity = "<9.8 m/s^2|32.2 ft/s^2>" # default: standard gravity
# ground_profile = [["<-9 m|-30 ft>", "<-2 m|-6 ft>"], ["<9 m|30 ft>", "<-1 m|-3 ft>"]] # points of an uneven ground

[[fence.rock]] # one such table for each rock
a = "<0.4 m|1.3 ft>" # half-axis along x
b = "<0.4 m|1.3 ft>" # half-axis along y; a = b is a sphere
mass = "<700 kg|1500 lb>" # or density
position = ["<0.9 m|2.8 ft>", "<0 m|0 ft>"] # of its centre at the start; the central column's is (0, 0)
velocity = ["<-10 m/s|-33 ft/s>", "<0 m/s|0 ft/s>"] # at the start; it must move
# spin = "<-5 rad/s|-5 rad/s>" # counter-clockwise is positive (default 0)
# shape = "rectangle" # ellipse (default), rectangle, or superquadric with its exponent
# solid = "block" # solid of mass and inertia: ellipsoid (default) or block

[fence.column] # all columns are alike
a = "<0.4 m|1.25 ft>" # radius
b = "<1.2 m|4 ft>" # half-height
density = "<200 kg/m^3|12 lb/ft^3>" # of the tyres and their filling, or mass of a column

[fence.ground]
position = ["<0 m|0 ft>", "<-2 m|-7 ft>"] # of the centre of its block, whose upper side (y + b) is the surface
a = "<10 m|30 ft>" # half-width of the block; the surface is unlimited
b = "<0.5 m|2 ft>" # half-height of the block

[fence.options] # this table may be left out
bottom_end = "anchored" # the bottom cable ends at anchors below those of the top cable (default: free)
# symmetry = "full" # all columns; default half: one side of a symmetric fence and impact
# hanger_strength = "<100 kN|20 kip>" # pull at which a top joint breaks (default 0: never)
# strength_top = "<600 kN|130 kip>" # tension at which the top cable breaks (default 0: never)
# strength_bottom = "<450 kN|100 kip>" # tension at which the bottom cable breaks (default 0: never)
# column_ground = "contact" # columns can touch the ground (default none: they pass through it)
# end = "exit" # ends the run early, when the rock passes exit_x; or "rest"
# exit_x = "<-3 m|-10 ft>"
# integrator = "auto" # exact or error-controlled steps that locate events (default)
# tolerance = 1e-10 # of that integrator (default)
)";

constexpr std::string_view scene_template =
    R"(# A disc falls onto an incline, bounces and rolls down. x is horizontal, y is up, angles are counter-clockwise.
#   talus check FILE                lists bodies, contacts and the expected cost
#   talus run FILE --out DIR        runs it: summary here; histories and geometry in DIR
#   talus list fields               every field that a file can have, with unit and default
# Lines that begin with "# " and a field name are optional fields with their defaults or an example.
title = "Disc on an incline"
units = "<SI|US>" # <kg, m, s, N|slug, ft, s, lbf>; a quantity may have any other unit
gravity = ["<0 m/s^2|0 ft/s^2>", "<-9.81 m/s^2|-32.2 ft/s^2>"] # default: none

[[body]] # one such table for each body
name = "disc" # columns of the histories are named after it
mobility = "free" # or particle, pinned, fixed, sliding_x, ... (talus list fields)
mass = "<10 kg|20 lb>"
inertia = "<1.25 kg m^2|10 lb ft^2>" # about the centre of mass; a solid disc has mass radius^2/2
shape = { kind = "circle", radius = "<0.5 m|1 ft>" } # or rectangle, superquadric
position = ["<0 m|0 ft>", "<2 m|6 ft>"] # of the centre of mass at the start
# angle = "0 deg"
# velocity = ["<1 m/s|3 ft/s>", "<0 m/s|0 ft/s>"] # default: at rest
# spin = "<2 rad/s|2 rad/s>" # counter-clockwise is positive (default 0)
# force = ["<20 N|5 lbf>", "<0 N|0 lbf>"] # constant, at the centre of mass
# moment = "<5 N m|4 lbf ft>"

[[body]]
name = "incline"
mobility = "fixed"
shape = { kind = "half_plane" } # all below a line through its position
position = ["<0 m|0 ft>", "<0 m|0 ft>"]
angle = "-15 deg" # down to the right

[[contact]] # one such table for each pair that can touch
name = "impact"
between = ["disc", "incline"]
law = "linear_spring_dashpot" # or latching_spring, hertz (talus list laws)
stiffness = "<200 kN/m|15000 lbf/ft>" # force for each unit of overlap
restitution = 0.5 # or damping
friction = 0.4 # Coulomb coefficient; without it the disc slips freely
# shear_stiffness = "<200 kN/m|15000 lbf/ft>" # of friction that sticks; default: the normal stiffness

# [[cable]] # pulls when it is longer than its rest length
# name = "tether"
# law = "tension_only" # or elastic_plastic
# stiffness = "<1 kN/m|100 lbf/ft>"
# from = { body = "disc", point = ["<0 m|0 ft>", "<0 m|0 ft>"] } # in the axes of the body
# to = { point = ["<-2 m|-6 ft>", "<4 m|12 ft>"] } # a point of the world

[run]
end = "2 s" # time at which the run ends
interval = "10 ms" # time between rows of the history (default: a thousandth of the end)
# integrator = "auto" # exact or error-controlled steps that locate events (default)
# tolerance = 1e-10 # of that integrator (default)
# integrator = "velocity_verlet" # one of fixed step (talus list integrators) needs a step
# step = "auto" # a time, or "auto": 1/20 of the linear limit, 1/200 of the shortest contact at most
# ledger = "off" # on: keep the energy balance (default)
)";

constexpr std::string_view cell_template =
    R"(# A cell of discs between a fixed base and a driven block, sheared as in the program SNOFLO (Lacy 1989).
#   talus check FILE                lists discs, contact time and the expected cost
#   talus cell FILE --out DIR       runs it: stresses, depth and energies here; histories and profiles in DIR
#   talus list fields               every field that a file can have, with unit and default
# Lines that begin with "# " and a field name are optional fields with their defaults or an example.
title = "Shear cell, 80 discs of ice under <8 kPa|1.2 psi>"
units = "<SI|US>" # <kg, m, s, N|slug, ft, s, lbf>; a quantity may have any other unit

[cell]
stiffness = "<17 kN/m|1200 lbf/ft>" # K1 of a contact that is pressed further than before
restitution = 0.7 # of two discs, sqrt(K1/K2); or unloading_stiffness, K2
diameter = "<1 mm|0.04 in>" # of a disc
mass = "<7.2e-7 kg|1.6e-6 lb>" # of a disc
gravity = "<9.81 m/s^2|32.2 ft/s^2>" # acts on the block alone
overburden = "<8 kPa|1.2 psi>" # pressure of the block's weight; or block_mass
rows = 8 # of the array in which the free discs start
columns = 10 # of that array, at most wall_discs
wall_discs = 11 # discs in the base and in the block, at least 3
block_speed = "<5 m/s|16 ft/s>" # at which the block is driven along x
# seed = 1 # of the random velocities at the start (default 0)
# law = "linear_spring_dashpot" # default latching_spring; takes damping in place of unloading_stiffness
# friction = 0.5 # with that law: discs rub and turn (default: they do neither)

[run]
step = "0.2 us" # length of a step: at least 10 in a contact
every = "1 ms" # time between outputs
end = "40 ms" # time that the run lasts
# integrator = "central_difference" # default; or velocity_verlet, euler_cromer
# pictures = "on" # keeps the states for talus snapshot and animate (default off)
# jump = "on" # passes time without contacts at once (default off)
)";

constexpr std::pair<std::string_view, std::string_view> templates[] = {
    {"fence", fence_template}, {"scene", scene_template}, {"cell", cell_template}};

/// Replaces each `<first|second>` by its first or its second part.
std::string chosen(std::string_view text, bool first) {
  std::string made;
  for (std::size_t open; (open = text.find('<')) != std::string_view::npos;) {
    const std::size_t bar = text.find('|', open), close = text.find('>', bar);
    made += text.substr(0, open);
    made += first ? text.substr(open + 1, bar - open - 1) : text.substr(bar + 1, close - bar - 1);
    text.remove_prefix(close + 1);
  }
  return made.append(text);
}

/// Aligns the comments after fields at one column, if the fields are short enough.
std::string aligned(std::string_view text) {
  constexpr std::size_t column = 46;
  std::string made;
  for (std::size_t end; (end = text.find('\n')) != std::string_view::npos; text.remove_prefix(end + 1)) {
    const std::string_view line = text.substr(0, end);
    const std::size_t comment = line.find(" # ");
    made += line.substr(0, comment);
    if (comment != std::string_view::npos)
      made.append(std::max(column, comment + 1) - comment, ' ').append(line.substr(comment + 1));
    made += '\n';
  }
  return made;
}

}  // namespace

std::vector<std::string> template_kinds() {
  std::vector<std::string> kinds;
  for (const auto& [kind, text] : templates)
    kinds.emplace_back(kind);
  return kinds;
}

std::string scene_template(std::string_view kind, const UnitSystem& units) {
  for (const auto& [name, text] : templates)
    if (name == kind) return aligned(chosen(text, units == si));
  throw unknown_name("kind of scene", kind, template_kinds());
}

}  // namespace talus
