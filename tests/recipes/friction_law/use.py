"""A pressed disc that is pushed within its friction: it rests at the displacement F/(g d)."""

from program import expect, expect_near, final_body, run_scene, talus

fields = talus("list", "laws")
expect("shear_gradient times the overlap" in " ".join(fields.split()), "talus list laws does not list it")

scene = """title = "Pressed disc that is pushed"
units = "SI"
gravity = ["0 m/s^2", "-10 m/s^2"]
[[body]]
name = "disc"
mobility = "particle"
mass = "1 kg"
position = ["0 m", "0.4999 m"]
force = ["2 N", "0 N"]
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
law = "hunt_crossley"
stiffness = "1e6 N/m"
reference_overlap = "1 mm"
exponent = 2.0
hysteresis = "0.1 s/m"
friction = 0.5
shear_law = "growing"
shear_gradient = "1e9 N/m^2"
shear_damping = "600 N s/m"
[run]
integrator = "velocity_verlet"
step = "10 us"
end = "0.5 s"
[run.watch]
quality = "off"
"""
# The overlap at rest is (10 N/(1e9 N/m^2))^(1/2) = 0.1 mm, the tangential stiffness there 1e5 N/m.
expect_near("displacement", final_body(run_scene(scene), "disc")["position"][0], 2e-5, 1e-6)

linear = scene.replace('shear_law = "growing"\nshear_gradient = "1e9 N/m^2"\n', 'shear_stiffness = "2e5 N/m"\n')
expect_near("displacement by linear friction", final_body(run_scene(linear, "linear"), "disc")["position"][0], 1e-5, 1e-6)

for wrong, message in (
        (scene.replace('shear_gradient = "1e9 N/m^2"\n', ""), "shear_gradient"),
        (scene.replace('shear_law = "growing"\n', ""),
         'shear_gradient: it belongs to shear_law = "growing"; give this law, or remove it')):
    open("wrong.toml", "w").write(wrong)
    shown = talus("run", "wrong.toml", status=2)
    expect(message in shown, f"expected the message {message}; found {shown}")
