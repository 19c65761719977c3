#include "verification/problems/program/sweeps/ball_sweep.hpp"

#include <fmt/format.h>

#include "verification/study/program/sweep_results.hpp"

namespace talus::verification::problems::swept_scenes {

std::string ball_scene(const std::string& integrator) {
  return fmt::format(
      "title = \"Ball against a wall\"\nunits = \"SI\"\n"
      "[[body]]\nname = \"ball\"\nmobility = \"particle\"\nmass = \"2 kg\"\nposition = [\"-0.15 m\", \"0 m\"]\n"
      "velocity = [\"5 m/s\", \"0 m/s\"]\nshape = {{ kind = \"circle\", radius = \"{} m\" }}\n"
      "[[body]]\nname = \"wall\"\nmobility = \"fixed\"\nposition = [\"0 m\", \"0 m\"]\nangle = \"90 deg\"\n"
      "shape = {{ kind = \"half_plane\" }}\n"
      "[[contact]]\nname = \"hit\"\nbetween = [\"ball\", \"wall\"]\nlaw = \"linear_spring_dashpot\"\n"
      "stiffness = \"1e5 N/m\"\ndamping = \"100 N s/m\"\n"
      "[run]\nintegrator = \"{}\"\nstep = \"{} s\"\nend = \"0.2 s\"\n",
      radius, integrator, step);
}

std::string axis(const std::string& field, const std::string& rest) {
  return fmt::format("[[axis]]\nfield = \"{}\"\n{}\n", field, rest);
}

records::Csv collected(const Program& program, const std::string& name, const std::string& text, Differences& differ) {
  program.write(name + ".toml", text);
  program.run({"sweep", "plan", name + ".toml"});
  program.run({"sweep", "run", name});
  program.run({"sweep", "collect", name});
  return compared_sweep(program, name, differ);
}

}  // namespace talus::verification::problems::swept_scenes
