"""Free fall, exact to the last bit, and an oscillation, which the method's map of a step predicts."""

from program import expect, expect_near, final_body, run_scene, talus

expect("heun" in talus("list", "integrators"), "talus list integrators does not list it")


def scene(gravity, velocity, more, step, end):
    return f"""units = "SI"
gravity = ["0 m/s^2", "{gravity} m/s^2"]
[[body]]
name = "bob"
mobility = "particle"
mass = "1 kg"
position = ["0 m", "-1.5 m"]
velocity = ["{velocity} m/s", "0 m/s"]
{more}[run]
integrator = "heun"
step = "{step} s"
end = "{end} s"
"""


bob = final_body(run_scene(scene(-10.0, 0.25, "", 0.125, 1.0), "fall"), "bob")
expect(bob["position"] == [0.25, -6.5], f"free fall: found {bob['position']}")

# A taut cable of k/m = 4 1/s^2, elongated by 0.5 m at the start: each step multiplies x + i v/w by 1 + z + z^2/2, z = -i w h.
cable = """[[cable]]
name = "line"
law = "tension_only"
stiffness = "4 N/m"
rest_length = "1 m"
from = { point = ["0 m", "0 m"] }
to = { body = "bob", point = ["0 m", "0 m"] }
"""
steps, step = 16, 0.03125
z = -2j * step
bob = final_body(run_scene(scene(0.0, 0.0, cable, step, steps * step), "swing"), "bob")
expect_near("oscillation", bob["position"][1], -1.0 - 0.5 * ((1.0 + z + z * z / 2.0) ** steps).real, 1e-14)
talus("check", "scene.toml")
