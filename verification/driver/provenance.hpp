#pragma once

#include <string>

#include "verification/record/results.hpp"

namespace talus::verification {

using records::Provenance;

/// Provenance of this executable on this machine, now; the date is taken from SOURCE_DATE_EPOCH if set, so that a
/// report can be reproduced.
[[nodiscard]] Provenance provenance();

/// Processor, compiler and options as text.
[[nodiscard]] std::string machine_text();

}  // namespace talus::verification
