#pragma once

#include <fmt/format.h>

#include <string>

/// A scene of discs in a grid, each with a contact to the next.
inline std::string disc_grid(int discs) {
  std::string text = "units = \"SI\"\n";
  for (int i = 0; i < discs; ++i) {
    text += fmt::format(
        "[[body]]\nname = \"d{}\"\nmobility = \"free\"\nmass = \"1 kg\"\ninertia = \"0.5 kg m^2\"\n"
        "shape = {{ kind = \"circle\", radius = \"0.5 m\" }}\nposition = [\"{} m\", \"{} m\"]\n"
        "velocity = [\"0.1 m/s\", \"0 m/s\"]\n",
        i, 1.1 * (i % 100), 1.1 * (i / 100));
    if (i == 0) continue;
    text += fmt::format(
        "[[contact]]\nname = \"c{0}\"\nbetween = [\"d{1}\", \"d{0}\"]\nlaw = \"linear_spring_dashpot\"\n"
        "stiffness = \"1e5 N/m\"\nrestitution = 0.7\n",
        i, i - 1);
  }
  return text + "[run]\nend = \"1 ms\"\nstep = \"10 us\"\nintegrator = \"velocity_verlet\"\n";
}
