#pragma once

#include <cstdint>

namespace talus {

/// The mode of one law instance: an index into the law's own list of mode names. Motion is smooth while no mode
/// changes.
using Mode = std::uint8_t;

/// When the modes of a scene are brought up to date with its motion.
enum class Settling {
  every_evaluation,  ///< before each force evaluation: the classical way, and that of 1993
  accepted_step,     ///< after each accepted step only
};

}  // namespace talus
