#include "solver/geometry/pose.hpp"

namespace talus {

Rotation rotation(double angle) { return {std::cos(angle), std::sin(angle)}; }

}  // namespace talus
