#pragma once

#include <string>

#include "verification/reference/motion/constant_force.hpp"
#include "verification/study/program/program_options.hpp"

/// Options and results of `talus calibrate`; part of the case `calculation_options`.
namespace talus::verification::problems::calculation_options {

constexpr double gravity = 10.0;
/// Height of the dropped disc; it touches the ground after 0.14 s.
constexpr reference::ConstantForce drop{0.6, 0.0, -gravity};
/// Scene of a disc that falls on the ground.
[[nodiscard]] std::string drop_text();

/// The scene of a text in SI units in US units; its quantities have their units.
[[nodiscard]] std::string in_us_units(std::string text);

/// Compares calibrations of a pair of masses, of a latching spring and of a contact of the scene drop.toml with the
/// exact impacts, and the printed numbers with those of JSON.
void check_calibration(const Program& program, Findings& findings, Differences& differ);

}  // namespace talus::verification::problems::calculation_options
