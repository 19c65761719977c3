#pragma once

#include <string>

#include "verification/record/results.hpp"

namespace talus::verification {

using records::Provenance;

/// That of this executable on this machine, now; the date from SOURCE_DATE_EPOCH if set, so that a report can be made
/// again.
[[nodiscard]] Provenance provenance();

/// Processor, compiler and options of that, in words.
[[nodiscard]] std::string machine_words();

}  // namespace talus::verification
