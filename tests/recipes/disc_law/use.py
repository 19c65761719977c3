"""Impacts of a disc by the conical law: the restitution of its damping ratio at every speed; its potential, by the
script of the guide; and a shear cell of it."""

import math

from program import expect, expect_near, final_body, guide_script, run, run_scene, talus

laws = talus("list", "laws")
for head in ('[[contact]], law = "conical"', '[cell], law = "conical"'):
    expect(head in laws, f"talus list laws does not list {head}")

mass, stiffness, damping = 2.0, 1e5, 150.0
xi = damping / (2.0 * math.sqrt(1.5 * stiffness * mass))
restitution = math.exp(-2.0 * xi * math.acos(xi) / math.sqrt(1.0 - xi * xi))
for speed in (1.0, 3.0):
    folder = run_scene(f"""title = "Disc that strikes the ground"
units = "SI"
[[body]]
name = "disc"
mobility = "particle"
mass = "{mass} kg"
position = ["0 m", "0.5 m"]
velocity = ["0 m/s", "{-speed} m/s"]
[body.shape]
kind = "circle"
radius = "0.5 m"
[[body]]
name = "ground"
mobility = "fixed"
position = ["0 m", "0 m"]
[body.shape]
kind = "half_plane"
[[contact]]
name = "touch"
between = ["disc", "ground"]
law = "conical"
stiffness = "{stiffness} N/m"
at_overlap = "1 cm"
damping = "{damping} N s/m"
[run]
integrator = "velocity_verlet"
step = "2 us"
end = "0.1 s"
""", f"out{speed}")
    # 1e-3: dashpots are of first order in the step, which is 1e-4 of the contact time.
    expect_near("speed after the impact", final_body(folder, "disc")["velocity"][1], restitution * speed, 1e-3)

# By the Python of Debian, for which the module is built.
script, laws = guide_script("Is a contact law conservative?"), "for law in (\n"
expect(script.count(laws) == 1, f"the script of the guide must have one line '{laws}'")
conical = {"law": "conical", "stiffness": "50 kN/m", "at_overlap": "1 mm", "damping": "0 N s/m"}
found = run("/usr/bin/python3", "-c", script.replace(laws, f"{laws}    {conical},\n")).splitlines()[0]
# 3e-9, h^2/(3 d^2) with h = 1e-4 d: the error of the difference of energies that are cubic.
expect(found.startswith("conical: ") and float(found.split()[-1]) < 1e-8, f"the script of the guide says: {found}")

open("cell.toml", "w").write("""title = "Cell of conical discs"
units = "SI"
[cell]
law = "conical"
stiffness = "2e4 N/m"
at_overlap = "0.01 mm"
restitution = 0.7
diameter = "1 mm"
mass = "7.2e-7 kg"
gravity = "9.81 m/s^2"
overburden = "8 kPa"
block_speed = "5 m/s"
rows = 8
columns = 10
wall_discs = 11
[run]
step = "0.2 us"
every = "1 ms"
end = "2 ms"
""")
expect("conical" in talus("cell", "cell.toml", "--out", "cell"), "the summary of the cell does not name the law")
