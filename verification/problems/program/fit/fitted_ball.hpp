#pragma once

#include <string>

#include "verification/record/json_node.hpp"

/// A ball on a floor, and requests to fit its contact; part of the case `fitted_parameters`.
namespace talus::verification::problems::fitted_parameters {

inline constexpr double mass = 2.0, radius = 0.1, stiffness = 2e4, damping = 40.0, gravity = 9.81, drop = 0.2;

/// A ball that falls on a floor, or hits it at once without weight.
[[nodiscard]] std::string ball(const std::string& more_of_contact, bool falls);

/// A fitted field with its range. `more`: further lines of it.
[[nodiscard]] std::string parameter(const std::string& field, const std::string& range, const std::string& more = "");

inline constexpr const char* heading = "title = \"Ball\"\nscene = \"ball.toml\"\ndata = \"data.csv\"\n";
inline constexpr const char* of_height =
    "[[input]]\ncolumn = \"time [s]\"\nfield = \"run.end\"\n[[quantity]]\nname = \"height\"\ncolumn = \"y [mm]\"\n"
    "result = \"ball.y.end\"\n";
inline constexpr const char* of_speed =
    "[[input]]\ncolumn = \"vy [m/s]\"\nfield = \"body.ball.velocity[1]\"\n[[quantity]]\ncolumn = \"rebound [m/s]\"\n"
    "result = \"ball.vy.end\"\n";

/// A parameter of fit.json.
[[nodiscard]] inline const records::Json& found(const records::Json& fit, std::size_t parameter) {
  return fit.at("parameters").at(parameter);
}

}  // namespace talus::verification::problems::fitted_parameters
