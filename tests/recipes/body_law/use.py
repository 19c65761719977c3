"""A mass falls into a stiffening cable: lowest point and largest tension by its energy."""

from program import expect, expect_near, rows, run_scene, talus

expect('[[cable]], law = "stiffening"' in talus("list", "laws"), "talus list laws does not list it")

# m g x = k b^2/2 + k b (x - b) + w (x - b)^2/2 at the lowest point: z = x - b.
mass, gravity, k, b, w = 100.0, 10.0, 1e4, 0.05, 1e5
linear, constant = mass * gravity - k * b, mass * gravity * b - 0.5 * k * b * b
z = (linear + (linear * linear + 2.0 * w * constant) ** 0.5) / w
scene = """title = "Mass on a wire rope"
units = "SI"
gravity = ["0 m/s^2", "-10 m/s^2"]
[[body]]
name = "load"
mobility = "particle"
mass = "100 kg"
position = ["0 m", "-2 m"]
[[cable]]
name = "rope"
law = "stiffening"
stiffness = "10 kN/m"
bedding = "5 cm"
working_stiffness = "100 kN/m"
rest_length = "2 m"
from = { point = ["0 m", "0 m"] }
to = { body = "load", point = ["0 m", "0 m"] }
[run]
integrator = "velocity_verlet"
step = "0.05 ms"
interval = "0.05 ms"
end = "0.4 s"
"""
history = rows(run_scene(scene) / "history.csv")
# 1e-5: samples are 0.05 ms apart, and the curvature at the extremes is w/m = 1000 1/s^2 relative to the elongation.
expect_near("lowest point", min(float(row["load.y [m]"]) for row in history), -2.0 - b - z, 1e-5)
expect_near("largest tension", max(float(row["rope.tension [N]"]) for row in history), k * b + w * z, 1e-5)

# The order of its parameters is checked in scenes, too.
scene = scene.replace('working_stiffness = "100 kN/m"', 'working_stiffness = "1 kN/m"')
open("softer.toml", "w").write(scene)
expect("working_stiffness is 1000; it must be >= stiffness, which is 10000" in talus("run", "softer.toml", status=2),
       "a rope that softens is not refused")
