#pragma once

#include <string_view>

// Files that together contain every field, one per line; the comment in each table's header names its group in the
// catalogue of fields.

inline constexpr std::string_view complete_files[] = {
    R"(# scene
title = "All parts"
units = "SI"
gravity = ["0 m/s^2", "-9.81 m/s^2"]
[[body]] # body
name = "rock"
mobility = "free"
mass = "3 kg"
inertia = "0.5 kg m^2"
angle = "10 deg"
moment = "1 N m"
position = ["0 m", "1 m"]
velocity = ["1 m/s", "0 m/s"]
spin = "1 rad/s"
force = ["1 N", "0 N"]
[body.shape] # shape circle
kind = "circle"
radius = "0.5 m"
[[body]] # body
name = "door"
mobility = "pinned"
mass = "3 kg"
inertia = "0.5 kg m^2"
position = ["4 m", "1 m"]
pin = ["0 m", "1 m"]
spin = "1 rad/s"
[body.shape] # shape rectangle
kind = "rectangle"
half_width = "0.5 m"
half_height = "1 m"
[[body]] # body
name = "egg"
mobility = "guided_x"
mass = "3 kg"
inertia = "0.5 kg m^2"
position = ["7 m", "1 m"]
pin = ["0 m", "0.5 m"]
velocity = ["1 m/s", "0 m/s"]
[body.shape] # shape superquadric
kind = "superquadric"
half_width = "0.5 m"
half_height = "0.4 m"
exponent = 4.0
[[body]] # body
name = "bead"
mobility = "particle"
mass = "1 kg"
position = ["9 m", "3 m"]
[body.shape] # shape none
kind = "none"
[[body]] # body
name = "ground"
mobility = "fixed"
position = ["0 m", "0 m"]
angle = "5 deg"
[body.shape] # shape half_plane
kind = "half_plane"
[[body]] # body
name = "hills"
mobility = "fixed"
position = ["0 m", "-9 m"]
[body.shape] # shape terrain
kind = "terrain"
points = [["0 m", "0 m"], ["5 m", "1 m"]]
[[contact]] # contact linear_spring_dashpot
name = "bounce"
between = ["rock", "ground"]
law = "linear_spring_dashpot"
stiffness = "1e4 N/m"
restitution = 0.5
restitution_rule = "effective_mass"
end_rule = "clamped"
friction = 0.4
shear_stiffness = "1e4 N/m"
shear_damping = "2 N s/m"
[[contact]] # contact linear_spring_dashpot
name = "knock"
between = ["rock", "door"]
law = "linear_spring_dashpot"
stiffness = "1e4 N/m"
damping = "2 N s/m"
method = "nodes"
nodes = [12, 4]
node_depth = "nearest"
[[contact]] # contact latching_spring
name = "dent"
between = ["rock", "egg"]
law = "latching_spring"
method = "nodes"
nodes = 12
node_depth = "smoother"
stiffness = "1e4 N/m"
unloading_stiffness = "2e4 N/m"
growth = "3 1/m"
friction = 0.4
shear_stiffness = "1e4 N/m"
shear_damping = "2 N s/m"
[[contact]] # contact hertz
name = "touch"
between = ["rock", "hills"]
law = "hertz"
method = "nodes"
nodes = 12
node_depth = "nearest"
modulus = "1e6 Pa"
radius = "0.5 m"
damping = "2 N s/m"
dashpot = "constant"
end_rule = "attractive"
friction = 0.4
shear_law = "mindlin"
shear_modulus = "2e6 Pa"
shear_damping = "2 N s/m"
[[contact]] # contact hertz
name = "knead"
between = ["egg", "ground"]
law = "hertz"
modulus = "1e6 Pa"
radius = "0.5 m"
restitution = 0.5
restitution_rule = "eq_21"
restitution_speed = "2 m/s"
dashpot = "tsuji"
end_rule = "clamped"
friction = 0.4
shear_law = "linear"
shear_stiffness = "1e4 N/m"
[[contact]] # contact hunt_crossley
name = "press"
between = ["door", "egg"]
law = "hunt_crossley"
method = "nodes"
nodes = 12
node_depth = "nearest"
stiffness = "1e4 N/m"
reference_overlap = "1 cm"
exponent = 1.5
restitution = 0.5
restitution_speed = "2 m/s"
friction = 0.4
shear_stiffness = "1e4 N/m"
shear_damping = "2 N s/m"
[[contact]] # contact hunt_crossley
name = "rest"
between = ["rock", "egg"]
law = "hunt_crossley"
stiffness = "1e4 N/m"
reference_overlap = "1 cm"
exponent = 2.0
hysteresis = "0.1 s/m"
[[cable]] # cable tension_only
name = "rope"
law = "tension_only"
stiffness = "100 N/m"
damping = "1 N s/m"
rest_length = "2 m"
slack = "0.1 m"
[cable.from] # cable end
body = "rock"
point = ["0 m", "0.5 m"]
[cable.to] # cable end
body = "bead"
point = ["0 m", "0 m", "1 m"]
[[cable]] # cable elastic_plastic
name = "wire"
law = "elastic_plastic"
stiffness = "100 N/m"
yield = "10 N"
hardening = "1 N/m"
strength = "30 N"
rupture = "1 m"
table = [["0.1 m", "12 N"], ["0.2 m", "13 N"]]
rest_length = "2 m"
slack = "0.1 m"
[cable.from] # cable end
body = "bead"
point = ["0 m", "0 m"]
[cable.to] # cable end
body = "door"
point = ["0 m", "1 m"]
[[cable]] # cable tension_only
name = "line"
law = "tension_only"
stiffness = "100 N/m"
from = { body = "egg", point = ["0 m", "0.4 m"] }
to = { point = ["7 m", "9 m"] }
[[hanger]] # hanger
name = "hook"
body = "egg"
point = ["0 m", "0.4 m"]
strength = "50 N"
[run] # run
integrator = "rk4"
step = "1 ms"
end = "1 s"
interval = "10 ms"
ledger = "off"
[run.watch] # watch
instability = "warning"
tunnelling = "warning"
accuracy = "off"
missing_contacts = "off"
quality = "warning"
)",
    R"(# scene
units = "US"
[[body]] # body
name = "bead"
mobility = "sliding_x"
mass = "1 lb"
position = ["0 ft", "0 ft"]
[run] # run
integrator = "stormer_cowell"
tolerance = 1e-8
end = "1 s"
)",
    R"(# fence file
title = "All of a fence"
units = "SI"
[fence] # fence
columns = 15
spacing = "0.9 m"
span = "16 m"
sag = "1.5 m"
y_top = "1.5 m"
y_bottom = "-1 m"
young = "100 GPa"
area_top = "400 mm^2"
area_bottom = "200 mm^2"
limit_top = "400 kN"
limit_bottom = "300 kN"
restitution = 0.4
penetration = 0.05
duration = "0.1 s"
friction = 0.3
slack = "0.1 m"
connections = 2
gravity_sign = -1
gravity = "9.8 m/s^2"
print_every = 10
history_every = 1
history_elements = [2, 3]
history_codes = [3, 4]
ground_profile = [["-9 m", "-2 m"], ["9 m", "-1.9 m"]]
[[fence.rock]] # fence rock
a = "0.4 m"
b = "0.4 m"
density = "2000 kg/m^3"
power = 1.0
points = 4
solid = "ellipsoid"
position = ["0.9 m", "0 m"]
velocity = ["-10 m/s", "0 m/s"]
spin = "-5 rad/s"
angle = "1 deg"
force = ["1 N", "0 N"]
moment = "1 N m"
along = "0 m"
fixed_point = ["0 m", "0 m"]
bar_length = "0 m"
held = []
[[fence.rock]] # fence rock
a = "0.4 m"
b = "0.4 m"
mass = "700 kg"
shape = "ellipse"
position = ["2.9 m", "0 m"]
velocity = ["-10 m/s", "0 m/s"]
[fence.column] # fence column
a = "0.4 m"
b = "1.2 m"
density = "200 kg/m^3"
power = 0.0
points = 2
solid = "cylinder"
position = ["0 m", "0 m"]
velocity = ["0 m/s", "0 m/s"]
spin = "0 rad/s"
angle = "0 deg"
force = ["0 N", "0 N"]
moment = "0 N m"
along = "0 m"
fixed_point = ["0 m", "0 m"]
bar_length = "0 m"
held = []
[fence.ground] # fence ground
a = "10 m"
b = "0.5 m"
density = "200 kg/m^3"
power = 0.0
points = 2
solid = "block"
position = ["0 m", "-2.5 m"]
velocity = ["0 m/s", "0 m/s"]
spin = "0 rad/s"
angle = "0 deg"
force = ["0 N", "0 N"]
moment = "0 N m"
along = "0 m"
fixed_point = ["0 m", "0 m"]
bar_length = "0 m"
held = ["x", "y", "rotation"]
[[fence.changed_column]] # fence changed_column
number = 3
a = "0.3 m"
b = "1.1 m"
density = "150 kg/m^3"
y_top = "1.4 m"
y_bottom = "-0.9 m"
[[fence.stretched_cable]] # fence stretched_cable
cable = "top1"
stretch = "10 mm"
[fence.options] # fence options
symmetry = "full"
even_centre = "pair"
contact = "resultant"
calibration = "effective_mass"
end_rule = "clamped"
start = "plain"
bottom_end = "anchored"
column_ground = "none"
end = "exit"
exit_x = "-3 m"
sleep = "exact"
integrator = "stormer_cowell"
tolerance = 1e-8
shear_ratio = 0.8
hanger_strength = "100 kN"
strength_top = "600 kN"
strength_bottom = "450 kN"
hardening = 0.1
rupture = 0.3
[fence.options.watch] # fence watch
instability = "warning"
tunnelling = "warning"
accuracy = "off"
missing_contacts = "off"
quality = "warning"
)",
    R"(# fence file
units = "SI"
[fence] # fence
rules = "1993"
columns = 5
spacing = "0.9 m"
span = "16 m"
sag = "1.5 m"
y_top = "1.5 m"
y_bottom = "-1 m"
young = "100 GPa"
area_top = "400 mm^2"
area_bottom = "200 mm^2"
limit_top = "400 kN"
limit_bottom = "300 kN"
restitution = 0.4
penetration = 0.05
steps = 100
step_factor = 0.5
layers = 2
layer_spacing = "1.9 m"
rock_overlap = "10 mm"
layer_overlap = "10 mm"
[[fence.rock]] # fence rock
a = "0.4 m"
b = "0.3 m"
density = "2000 kg/m^3"
shape = "superquadric"
exponent = 3.0
position = ["2.9 m", "0 m"]
velocity = ["-10 m/s", "0 m/s"]
[[fence.rock]] # fence rock
a = "0.4 m"
b = "0.3 m"
density = "2000 kg/m^3"
shape = "rectangle"
position = ["4.9 m", "0 m"]
velocity = ["-10 m/s", "0 m/s"]
[fence.column] # fence column
a = "0.4 m"
b = "1.2 m"
mass = "100 kg"
shape = "superquadric"
exponent = 4.5
[fence.ground] # fence ground
a = "10 m"
b = "0.5 m"
position = ["0 m", "-2.5 m"]
mass = "1000 kg"
shape = "superquadric"
exponent = 4.5
[fence.options] # fence options
table = [[0.01, 1.2]]
)",
    R"(# cell file
title = "All of a cell"
units = "SI"
[cell] # cell latching_spring
law = "latching_spring"
stiffness = "1.7e4 N/m"
unloading_stiffness = "3e4 N/m"
growth = "1 1/m"
diameter = "1 mm"
mass = "7.2e-7 kg"
gravity = "9.81 m/s^2"
block_mass = "9e-3 kg"
block_speed = "5 m/s"
rows = 8
columns = 10
wall_discs = 11
friction = 0.5
shear_stiffness = "1e4 N/m"
seed = 3
[run] # cell run
integrator = "central_difference"
step = "0.2 us"
every = "5 ms"
end = "100 ms"
jump = "on"
images = "nearest"
historical = "off"
pictures = "on"
)",
    R"(# cell file
title = "All of a cell"
units = "SI"
[cell] # cell latching_spring
stiffness = "1.7e4 N/m"
restitution = 0.7
diameter = "1 mm"
mass = "7.2e-7 kg"
gravity = "9.81 m/s^2"
overburden = "8 kPa"
rows = 8
columns = 10
wall_discs = 11
[run] # cell run
step = "0.2 us"
every = "5 ms"
end = "100 ms"
)",
    R"(# cell file
title = "All of a cell"
units = "SI"
[cell] # cell linear_spring_dashpot
law = "linear_spring_dashpot"
stiffness = "2e4 N/m"
damping = "0.02 N s/m"
end_rule = "clamped"
diameter = "1 mm"
mass = "7.2e-7 kg"
gravity = "9.81 m/s^2"
block_mass = "9e-3 kg"
block_speed = "5 m/s"
rows = 8
columns = 10
wall_discs = 11
friction = 0.5
shear_stiffness = "1e4 N/m"
seed = 3
[run] # cell run
step = "0.2 us"
every = "5 ms"
end = "100 ms"
)",
    R"(# cell file
title = "All of a cell"
units = "SI"
[cell] # cell linear_spring_dashpot
law = "linear_spring_dashpot"
stiffness = "2e4 N/m"
restitution = 0.7
diameter = "1 mm"
mass = "7.2e-7 kg"
gravity = "9.81 m/s^2"
overburden = "8 kPa"
rows = 8
columns = 10
wall_discs = 11
[run] # cell run
step = "0.2 us"
every = "5 ms"
end = "100 ms"
)",
    R"(# cell file
title = "All of a cell"
units = "SI"
[cell] # cell hertz
law = "hertz"
modulus = "100 MPa"
radius = "0.25 mm"
damping = "0.02 N s/m"
end_rule = "clamped"
dashpot = "constant"
impact_speed = "0.5 m/s"
diameter = "1 mm"
mass = "7.2e-7 kg"
gravity = "9.81 m/s^2"
block_mass = "9e-3 kg"
block_speed = "5 m/s"
rows = 8
columns = 10
wall_discs = 11
friction = 0.5
shear_law = "linear"
shear_stiffness = "1e4 N/m"
seed = 3
[run] # cell run
step = "0.2 us"
every = "5 ms"
end = "100 ms"
)",
    R"(# cell file
title = "All of a cell"
units = "SI"
[cell] # cell hunt_crossley
law = "hunt_crossley"
stiffness = "2e4 N/m"
reference_overlap = "0.01 mm"
exponent = 1.5
restitution = 0.7
impact_speed = "0.5 m/s"
diameter = "1 mm"
mass = "7.2e-7 kg"
gravity = "9.81 m/s^2"
overburden = "8 kPa"
block_speed = "5 m/s"
rows = 8
columns = 10
wall_discs = 11
[run] # cell run
step = "0.2 us"
every = "5 ms"
end = "100 ms"
)",
    R"(# cell file
title = "All of a cell"
units = "SI"
[cell] # cell hertz
law = "hertz"
modulus = "100 MPa"
radius = "0.25 mm"
restitution = 0.7
impact_speed = "0.5 m/s"
diameter = "1 mm"
mass = "7.2e-7 kg"
gravity = "9.81 m/s^2"
overburden = "8 kPa"
block_speed = "5 m/s"
rows = 8
columns = 10
wall_discs = 11
friction = 0.5
shear_law = "mindlin"
shear_modulus = "80 MPa"
[run] # cell run
step = "0.2 us"
every = "5 ms"
end = "100 ms"
)",
    R"(# cell file
title = "All of a cell"
units = "SI"
[cell] # cell hunt_crossley
law = "hunt_crossley"
stiffness = "2e4 N/m"
reference_overlap = "0.01 mm"
exponent = 1
hysteresis = "0.5 s/m"
diameter = "1 mm"
mass = "7.2e-7 kg"
gravity = "9.81 m/s^2"
block_mass = "9e-3 kg"
block_speed = "5 m/s"
rows = 8
columns = 10
wall_discs = 11
impact_speed = "0.5 m/s"
friction = 0.5
shear_stiffness = "1e4 N/m"
seed = 3
[run] # cell run
step = "0.2 us"
every = "5 ms"
end = "100 ms"
)"};
