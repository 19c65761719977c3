#pragma once

#include <filesystem>
#include <string>

#include "tests/temporary_folder.hpp"

/// A sweep of a ball that a clamped spring and dashpot reflect: inputs are its speed [m/s] and the damping [N s/m], the
/// mass is the same in all runs; outputs the velocity after the impact [m/s], and its largest x [m]. The scene
/// is written beside it.
inline std::filesystem::path write_ball_sweep(const Folder& folder, const std::string& more = "") {
  folder.file("ball.toml",
              "title = \"Ball against a wall\"\nunits = \"SI\"\n"
              "[[body]]\nname = \"ball\"\nmobility = \"particle\"\nmass = \"1 kg\"\nposition = [\"-0.15 m\", \"0 m\"]\n"
              "velocity = [\"5 m/s\", \"0 m/s\"]\nshape = { kind = \"circle\", radius = \"0.1 m\" }\n"
              "[[body]]\nname = \"wall\"\nmobility = \"fixed\"\nposition = [\"0 m\", \"0 m\"]\nangle = \"90 deg\"\n"
              "shape = { kind = \"half_plane\" }\n"
              "[[contact]]\nname = \"hit\"\nbetween = [\"ball\", \"wall\"]\nlaw = \"linear_spring_dashpot\"\n"
              "stiffness = \"1e5 N/m\"\ndamping = \"100 N s/m\"\n"
              "[run]\nintegrator = \"exact\"\nstep = \"1e-4 s\"\nend = \"0.2 s\"\n");
  return folder.file("sweep.toml",
                     "base = \"ball.toml\"\noutputs = [\"ball.vx.end\", \"ball.x.max\"]\n"
                     "[[axis]]\nfield = \"body.ball.mass\"\nvalues = [\"2 kg\"]\n"
                     "[[axis]]\nfield = \"body.ball.velocity[0]\"\nrange = [\"1 m/s\", \"5 m/s\"]\ncount = 2\n"
                     "[[axis]]\nfield = \"contact.hit.damping\"\nvalues = [\"0 N s/m\", \"400 N s/m\"]\n" +
                         more);
}
