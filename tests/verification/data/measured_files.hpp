#pragma once

#include <string>

#include "tests/temporary_folder.hpp"

namespace talus::verification {

/// A ball thrown up, in flight: after 0.5 s at 1 m + 0.5 s v - 1.25 m.
inline const std::string flight_scene =
    "title = \"Flight\"\nunits = \"SI\"\ngravity = [\"0 m/s^2\", \"-10 m/s^2\"]\n\n[[body]]\nname = \"ball\"\nmobility "
    "= "
    "\"free\"\nmass = \"1 kg\"\ninertia = \"0.1 kg m^2\"\nposition = [\"0 m\", \"1 m\"]\nvelocity = [\"0 m/s\", \"1 "
    "m/s\"]\nshape = { kind = \"circle\", radius = \"0.1 m\" }\n\n[[body]]\nname = \"ground\"\nmobility = \"fixed\"\n"
    "shape = { kind = \"half_plane\" }\nposition = [\"0 m\", \"-9 m\"]\n\n[[contact]]\nname = \"fall\"\nbetween = "
    "[\"ball\", \"ground\"]\nlaw = \"linear_spring_dashpot\"\nstiffness = \"1e5 N/m\"\nrestitution = "
    "0.5\n\n[run]\nintegrator = "
    "\"velocity_verlet\"\nstep = \"1 ms\"\nend = \"0.5 s\"\ninterval = \"0.1 s\"\n";

inline const std::string flight_set =
    "title = \"Heights\"\nsource = \"a field book of 2024\"\nwhat = \"A ball thrown up.\"\nnot_shown = \"air "
    "resistance\"\nscene = \"flight.toml\"\ndata = \"heights.csv\"\n\n[[input]]\ncolumn = \"speed [m/s]\"\nfield = "
    "\"body.ball.velocity[1]\"\nuncertainty = 0.04\n\n[[quantity]]\nname = \"height\"\ncolumn = \"height "
    "[m]\"\nresult = \"final.ball.y\"\nuncertainty = \"u\"\nmodel_error = 0.02\n\n[[control]]\nname = "
    "\"weak_gravity\"\nwhat = \"gravity of Mars\"\nfield = \"gravity[1]\"\nvalue = \"-3.7 m/s^2\"\nturns_red = "
    "\"height\"\n";

/// A folder with a set of measurements, its scene and its data.
struct MeasuredFolder {
  Folder files;

  explicit MeasuredFolder(const std::string& csv = "speed [m/s],height [m],u\n4,1.76,0.01\n6,2.74,0.02\n",
                          const std::string& set = flight_set, const std::string& scene = flight_scene) {
    files.file("flight.toml", scene);
    files.file("heights.csv", csv);
    files.file("heights.measured.toml", set);
  }
  [[nodiscard]] std::filesystem::path set() const { return files.path / "heights.measured.toml"; }
};

/// `text` with the first `old` replaced.
inline std::string with(std::string text, const std::string& old, const std::string& fresh) {
  return text.replace(text.find(old), old.size(), fresh);
}

}  // namespace talus::verification
