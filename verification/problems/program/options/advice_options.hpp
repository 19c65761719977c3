#pragma once

#include <string>

#include "verification/problems/program/options/calibration_options.hpp"
#include "verification/reference/motion/damped_oscillator.hpp"
#include "verification/study/program/program_options.hpp"

/// Options and results of `talus advise`; part of the case `calculation_options`.
namespace talus::verification::problems::calculation_options {

/// Mass, kg, and stiffness of the cable, N/m, of a body that slides up and down on it; its place at the start, the
/// upper end of the cable, its rest length and the place of the body at rest, m.
inline constexpr double hung_mass = 1.5, hung_stiffness = 96.0, hung_y = -0.3, rope_top = 2.0, rope_length = 2.1;
inline constexpr double hung_rest = rope_top - rope_length - hung_mass * gravity / hung_stiffness;

/// The scene, in which the cable stays taut; `method`: fields of its [run].
[[nodiscard]] std::string hung_text(const std::string& method);

/// Displacement from rest, m, and velocity, m/s, at time t.
[[nodiscard]] reference::OscillatorState hung_state(double t);

/// Compares advice on the scenes plain.toml (a hung body) and drop.toml with the runs that it advises and the closed
/// forms, and the printed numbers with those of JSON.
void check_advice(const Program& program, Findings& findings, Differences& differ);

/// Compares advice on a fence of 1993 whose rock touches from the start, and on a minimum, with the advised runs.
void check_advised_scenes(const Program& program, Differences& differ);

}  // namespace talus::verification::problems::calculation_options
