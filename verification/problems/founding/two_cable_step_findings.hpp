#pragma once

#include "verification/check/case.hpp"

namespace talus::verification::problems {

/// The speed after the contact at one stiffness, by central difference, against the soft reference: order and predicted
/// constant for both end rules, and a figure.
void check_contact_at_fixed_stiffness(Findings& findings, const Setup& setup);

}  // namespace talus::verification::problems
