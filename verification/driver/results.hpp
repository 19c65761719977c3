#pragma once

#include "verification/record/record_files.hpp"

namespace talus::verification {

using records::Results;

/// Fills what follows from the records and the driver's lists: which cases show a requirement and what peers check, the
/// families of the cases, the errata that registered cases prove, and the bibliography.
void complete(Results& results);

}  // namespace talus::verification
