#pragma once

#include "verification/check/case.hpp"

/// What a single run or a single step can hide, on the undamped disc that meets a wall.
namespace talus::verification::problems {

/// A step that divides the contact time shows an order that the method does not have: false orders, and a figure.
void check_commensurate(Findings& findings);

/// What an undamped impact gains and loses at steps up to 2/w, against the exact map of the leapfrog: a check and a
/// table.
void check_gain(Findings& findings);

/// Each onset phase by itself at one coarse step, against the exact map of the leapfrog: a check and a figure.
void check_phases(Findings& findings);

}  // namespace talus::verification::problems
