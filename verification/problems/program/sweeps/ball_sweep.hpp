#pragma once

#include <string>

#include "verification/record/csv.hpp"
#include "verification/study/program/program_options.hpp"

/// Sweeps of a ball that hits a wall; part of the case `swept_scenes`.
namespace talus::verification::problems::swept_scenes {

/// Radius of the ball, m, and time step of its scene, s.
inline constexpr double radius = 0.1, step = 1e-4;

/// The scene, in SI units.
std::string ball_scene(const std::string& integrator);

/// An axis of the field with `rest`, its other keys.
std::string axis(const std::string& field, const std::string& rest);

/// Writes the text, plans, runs and collects it in a folder of its name, compares the two files, and returns the table.
records::Csv collected(const Program& program, const std::string& name, const std::string& text, Differences& differ);

}  // namespace talus::verification::problems::swept_scenes
