"""A disc at rest: its row in contact_forces.csv, the name in the list of files, and its removal by another run."""

from program import expect, expect_near, rows, run_scene, talus

scene = """title = "Disc that comes to rest"
units = "SI"
gravity = ["0 m/s^2", "-10 m/s^2"]
[[body]]
name = "disc"
mobility = "particle"
mass = "2 kg"
position = ["0 m", "0.5 m"]
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
law = "linear_spring_dashpot"
stiffness = "1e4 N/m"
damping = "200 N s/m"
[run]
integrator = "velocity_verlet"
step = "0.1 ms"
end = "1 s"
"""
out = run_scene(scene)
table = rows(out / "contact_forces.csv")
expect(len(table) == 1 and table[0]["contact"] == "touch" and table[0]["body_a"] == "disc", f"found {table}")
expect_near("normal force", float(table[0]["normal_force [N]"]), 20.0, 1e-9)
expect_near("overlap", float(table[0]["overlap [m]"]), 2e-3, 1e-9)
expect("contact_forces.csv" in talus("run", "scene.toml", "--out", "out"), "the list of files does not name it")

falls = scene[:scene.index("[[contact]]")] + scene[scene.index("[run]"):]
run_scene(falls, "out")
expect(not (out / "contact_forces.csv").exists(), "another run into the folder leaves the file of the first")
